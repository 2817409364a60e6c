<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>guided_sweep</name>
    <message>
        <source>Start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Target, %1 mm out of the image</source>
        <translation>Ziel, %1 mm außerhalb der Bildebene</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Führen</translation>
    </message>
    <message>
        <source>Follow a sweep that the case holds</source>
        <translation>Einem Schwenk folgen, den der Fall enthält</translation>
    </message>
    <message>
        <source>Guided sweep</source>
        <translation>Geführter Schwenk</translation>
    </message>
    <message>
        <source>&amp;Show the guided sweep</source>
        <translation>Geführten Schwenk &amp;zeigen</translation>
    </message>
    <message>
        <source>The guided sweep is still going on.</source>
        <translation>Der geführte Schwenk läuft noch.</translation>
    </message>
</context>
<context>
    <name>guided_sweep::GuidePanel</name>
    <message>
        <source>Hold the probe where the sweep begins, and keep the pose; then where it ends.</source>
        <translation>Den Schallkopf an den Anfang des Schwenks halten und die Lage merken; dann an sein Ende.</translation>
    </message>
    <message>
        <source>Start here</source>
        <translation>Anfang hier</translation>
    </message>
    <message>
        <source>The sweep begins where the probe is now</source>
        <translation>Der Schwenk beginnt, wo der Schallkopf jetzt ist</translation>
    </message>
    <message>
        <source>End here</source>
        <translation>Ende hier</translation>
    </message>
    <message>
        <source>The sweep ends where the probe is now</source>
        <translation>Der Schwenk endet, wo der Schallkopf jetzt ist</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>The probe moves along the sweep by itself, and is yours again at its end</source>
        <translation>Der Schallkopf bewegt sich von selbst den Schwenk entlang und gehört am Ende wieder Ihnen</translation>
    </message>
    <message>
        <source>Start of the sweep</source>
        <translation>Anfang des Schwenks</translation>
    </message>
    <message>
        <source>End of the sweep</source>
        <translation>Ende des Schwenks</translation>
    </message>
    <message>
        <source>Duration of the sweep</source>
        <translation>Dauer des Schwenks</translation>
    </message>
    <message>
        <source>Give the probe back</source>
        <translation>Schallkopf zurückgeben</translation>
    </message>
    <message>
        <source>Show the sweep</source>
        <translation>Schwenk zeigen</translation>
    </message>
    <message>
        <source>The sweep has no start yet.</source>
        <translation>Der Schwenk hat noch keinen Anfang.</translation>
    </message>
    <message>
        <source>The sweep has no end yet.</source>
        <translation>Der Schwenk hat noch kein Ende.</translation>
    </message>
    <message>
        <source>%1 mm in %2 s</source>
        <translation>%1 mm in %2 s</translation>
    </message>
</context>
<context>
    <name>ew::Message</name>
    <message>
        <source>Nothing is scanned; open a case first.</source>
        <translation>Es wird nichts geschallt; zuerst einen Fall öffnen.</translation>
    </message>
    <message>
        <source>an object with start, end and duration_s</source>
        <translation>ein Objekt mit start, end und duration_s</translation>
    </message>
    <message>
        <source>16 numbers, probe to world, row by row</source>
        <translation>16 Zahlen, Schallkopf zu Welt, Zeile für Zeile</translation>
    </message>
    <message>
        <source>a number from 1 to 60</source>
        <translation>eine Zahl von 1 bis 60</translation>
    </message>
</context>
</TS>
