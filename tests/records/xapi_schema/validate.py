"""Judges xAPI statements by the published schema: validate.py FILE. Prints each problem; exit status 1 when there is any, 77 without the
validator. With --required a field is left out of the first statement of each kind in turn, and the schema has to notice."""
import copy
import json
import pathlib
import re
import sys

try:
    import jsonschema
except ImportError:
    sys.exit(77)

HERE = pathlib.Path(__file__).resolve().parent
SCHEMA = json.loads((HERE / "1.0.1.json").read_text())
FORMATS = json.loads((HERE / "formats.json").read_text())


def checker():
    """The schema's own formats; an expression that Python does not read is left out and named."""
    made = jsonschema.FormatChecker(formats=())
    for name, pattern in FORMATS.items():
        try:
            # The language is JavaScript's: surrogate pairs outside the basic plane are of no use here.
            expression = re.compile(pattern)
        except re.error:
            expression = None
        if expression is None:
            print("format not checked:", name, file=sys.stderr)
            continue
        made.checks(name)(lambda value, expression=expression: not isinstance(value, str) or expression.search(value) is not None)
    return made


def by_id(part, found):
    """The schema names its parts by "#statement", "#activityid!core" and the like, wherever they stand."""
    if isinstance(part, dict):
        if isinstance(part.get("id"), str):
            found[part["id"]] = part
        for each in part.values():
            by_id(each, found)
    elif isinstance(part, list):
        for each in part:
            by_id(each, found)
    return found


def resolved(part, parts):
    if isinstance(part, dict):
        made = {}
        for key, value in part.items():
            if key == "$ref" and value in parts:
                made[key] = "#/definitions/" + value[1:]
            elif key != "id" or not isinstance(value, str):
                made[key] = resolved(value, parts)
        return made
    if isinstance(part, list):
        return [resolved(each, parts) for each in part]
    return part


def validator():
    parts = by_id(SCHEMA, {})
    definitions = {name[1:]: resolved(part, parts) for name, part in parts.items()}
    schema = {"$schema": SCHEMA["$schema"], "definitions": definitions, "$ref": "#/definitions/statement"}
    jsonschema.Draft4Validator.check_schema(schema)
    return jsonschema.Draft4Validator(schema, format_checker=checker())


def main():
    judge = validator()
    statements = json.loads(pathlib.Path(sys.argv[1]).read_text())
    problems = 0
    for statement in statements:
        for problem in judge.iter_errors(statement):
            problems += 1
            print(statement.get("id"), list(problem.absolute_path), problem.message[:300])
    if "--required" in sys.argv:
        for field, bad in (("actor", None), ("verb", None), ("object", None), ("id", "no uuid"), ("timestamp", "yesterday")):
            broken = copy.deepcopy(statements[0])
            if bad is None:
                del broken[field]
            else:
                broken[field] = bad
            if judge.is_valid(broken):
                problems += 1
                print("the schema does not notice a wrong", field)
    print(len(statements), "statements,", problems, "problems")
    return 1 if problems or not statements else 0


sys.exit(main())
