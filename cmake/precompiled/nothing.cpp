// The headers beside it are precompiled for a target of their own, and a target has sources.
int main() { return 0; }
