<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>ew::Message</name>
    <message>
        <source>%1 %2, was %3</source>
        <translation>%1 %2, vorher %3</translation>
    </message>
    <message>
        <source>%1 cannot be made (%2); check that you may write there.</source>
        <translation>%1 kann nicht angelegt werden (%2); prüfen Sie, ob Sie dort schreiben dürfen.</translation>
    </message>
    <message>
        <source>%1 has no image; choose another recording.</source>
        <translation>%1 hat kein Bild; wählen Sie eine andere Aufzeichnung.</translation>
    </message>
    <message>
        <source>A drawing</source>
        <translation>Eine Zeichnung</translation>
    </message>
    <message>
        <source>B and M-mode</source>
        <translation>B- und M-Mode</translation>
    </message>
    <message>
        <source>B-mode</source>
        <translation>B-Mode</translation>
    </message>
    <message>
        <source>Handed in a measurement</source>
        <translation>Eine Messung abgegeben</translation>
    </message>
    <message>
        <source>Handed in an answer</source>
        <translation>Eine Antwort abgegeben</translation>
    </message>
    <message>
        <source>Looking at what was seen</source>
        <translation>Betrachten, was gesehen wurde</translation>
    </message>
    <message>
        <source>Looking for attempts</source>
        <translation>Suche nach Versuchen</translation>
    </message>
    <message>
        <source>One of the scans has no valid pose of the probe; look at both on one clock.</source>
        <translation>Einer der Scans hat keine gültige Pose des Schallkopfs; sehen Sie beide auf einer Uhr an.</translation>
    </message>
    <message>
        <source>TGC</source>
        <translation>TGC</translation>
    </message>
    <message>
        <source>The case that %1 was recorded in is not in the library; import it, or open it, and choose the scan again.</source>
        <translation>Der Fall, in dem %1 aufgezeichnet wurde, ist nicht in der Bibliothek; importieren oder öffnen Sie ihn und wählen Sie den Scan noch einmal.</translation>
    </message>
    <message>
        <source>The comments have format %1, and this program reads formats up to %2; open them with a newer EchoWeave.</source>
        <translation>Die Kommentare haben Format %1, und dieses Programm liest Formate bis %2; öffnen Sie sie mit einem neueren EchoWeave.</translation>
    </message>
    <message>
        <source>an id that no other comment has</source>
        <translation>eine Kennung, die kein anderer Kommentar hat</translation>
    </message>
    <message>
        <source>as recorded</source>
        <translation>wie aufgezeichnet</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>dynamic range</source>
        <translation>Dynamikbereich</translation>
    </message>
    <message>
        <source>focus</source>
        <translation>Fokus</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>neutral</source>
        <translation>neutral</translation>
    </message>
    <message>
        <source>points, each lateral and axial</source>
        <translation>Punkte, jeder lateral und axial</translation>
    </message>
    <message>
        <source>probe</source>
        <translation>Schallkopf</translation>
    </message>
    <message>
        <source>the comments</source>
        <translation>den Kommentaren</translation>
    </message>
    <message>
        <source>two points, each lateral and axial</source>
        <translation>zwei Punkte, jeder lateral und axial</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>A placement needs at least three pairs of places, not on one line, and there are %1; add some.</source>
        <translation>Eine Platzierung braucht mindestens drei Paare von Orten, die nicht auf einer Linie liegen, und es gibt %1; weitere hinzufügen.</translation>
    </message>
    <message>
        <source>The places all lie on one line, so that nobody can say how the volume is turned about it; add one beside it.</source>
        <translation>Die Orte liegen alle auf einer Linie, sodass niemand sagen kann, wie das Volumen um sie gedreht ist; einen daneben hinzufügen.</translation>
    </message>
    <message>
        <source>Nobody has named places of the mannequin &apos;%1&apos;; place the volume by hand, or choose another mannequin.</source>
        <translation>Für den Übungskörper „%1“ sind keine Orte benannt; das Volumen von Hand platzieren oder einen anderen wählen.</translation>
    </message>
    <message>
        <source>The mannequin &apos;%1&apos; is a mesh, whose skin only the window has; place the volume there.</source>
        <translation>Der Übungskörper „%1“ ist ein Netz, dessen Haut nur das Fenster hat; das Volumen dort platzieren.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is there already, and nothing in it is overwritten; choose a new folder.</source>
        <translation>„%1“ gibt es schon, und nichts darin wird überschrieben; einen neuen Ordner wählen.</translation>
    </message>
    <message>
        <source>Stopped as asked; no case was made.</source>
        <translation>Wie gewünscht angehalten; es wurde kein Fall angelegt.</translation>
    </message>
    <message>
        <source>The case is not your own, so that nothing is put into its folder; save it as your own case first.</source>
        <translation>Der Fall ist kein eigener, deshalb wird nichts in seinen Ordner gelegt; ihn zuerst als eigenen Fall speichern.</translation>
    </message>
    <message>
        <source>The spacing of a voxel must be from 0.1 to 10 mm.</source>
        <translation>Der Voxelabstand muss 0,1 bis 10 mm betragen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; holds pictures one by one and no volume; a case needs a volume, a recording with poses, or a stitched result.</source>
        <translation>„%1“ enthält einzelne Bilder und kein Volumen; ein Fall braucht ein Volumen, eine Aufnahme mit Posen oder ein zusammengefügtes Ergebnis.</translation>
    </message>
    <message>
        <source>The project &apos;%1&apos; was not stitched into one volume: %2</source>
        <translation>Das Projekt „%1“ wurde nicht zu einem Volumen zusammengefügt: %2</translation>
    </message>
    <message>
        <source>No volume is named; choose a volume, a recording or a stitched result.</source>
        <translation>Es ist kein Volumen genannt; ein Volumen, eine Aufnahme oder ein zusammengefügtes Ergebnis wählen.</translation>
    </message>
    <message>
        <source>The volume lies where its file says; place it on the body by hand.</source>
        <translation>Das Volumen liegt, wo seine Datei es sagt; es von Hand am Körper platzieren.</translation>
    </message>
    <message>
        <source>templates</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>There is no template &apos;%1&apos;; the templates are %2.</source>
        <translation>Es gibt keine Vorlage „%1“; die Vorlagen sind %2.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; looks like the date of a real examination; write how long ago it was.</source>
        <translation>„%1“ sieht nach dem Datum einer echten Untersuchung aus; schreiben, wie lange sie her ist.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; looks like a date of birth; give an age instead.</source>
        <translation>„%1“ sieht nach einem Geburtsdatum aus; stattdessen ein Alter angeben.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; looks like a telephone number; leave it out.</source>
        <translation>„%1“ sieht nach einer Telefonnummer aus; sie weglassen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; looks like the number of a patient, an insurance or an examination; leave it out.</source>
        <translation>„%1“ sieht nach der Nummer eines Patienten, einer Versicherung oder einer Untersuchung aus; sie weglassen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; looks like an address; leave it out.</source>
        <translation>„%1“ sieht nach einer Adresse aus; sie weglassen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; looks like the name of a real person; write an invented one, or none.</source>
        <translation>„%1“ sieht nach dem Namen einer echten Person aus; einen erfundenen oder keinen schreiben.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; looks like a real hospital; write &quot;another hospital&quot;.</source>
        <translation>„%1“ sieht nach einem echten Krankenhaus aus; „ein anderes Krankenhaus“ schreiben.</translation>
    </message>
    <message>
        <source>It has a title for trainees.</source>
        <translation>Ein Titel für Lernende ist da.</translation>
    </message>
    <message>
        <source>Write a title for trainees that gives no finding away.</source>
        <translation>Einen Titel für Lernende schreiben, der keinen Befund verrät.</translation>
    </message>
    <message>
        <source>The region is given.</source>
        <translation>Die Region ist angegeben.</translation>
    </message>
    <message>
        <source>Give the region of the body.</source>
        <translation>Die Körperregion angeben.</translation>
    </message>
    <message>
        <source>The indication is given.</source>
        <translation>Die Fragestellung ist angegeben.</translation>
    </message>
    <message>
        <source>Write the indication: what is asked.</source>
        <translation>Die Fragestellung schreiben: was gefragt ist.</translation>
    </message>
    <message>
        <source>The findings are written.</source>
        <translation>Die Befunde sind geschrieben.</translation>
    </message>
    <message>
        <source>Write the findings, a sentence each.</source>
        <translation>Die Befunde schreiben, je einen Satz.</translation>
    </message>
    <message>
        <source>The diagnosis is written.</source>
        <translation>Die Diagnose ist geschrieben.</translation>
    </message>
    <message>
        <source>Write the diagnosis.</source>
        <translation>Die Diagnose schreiben.</translation>
    </message>
    <message>
        <source>The difficulty is given.</source>
        <translation>Die Schwierigkeit ist angegeben.</translation>
    </message>
    <message>
        <source>Say how difficult the case is, 1 to 5.</source>
        <translation>Angeben, wie schwierig der Fall ist, 1 bis 5.</translation>
    </message>
    <message>
        <source>It has a volume.</source>
        <translation>Ein Volumen ist da.</translation>
    </message>
    <message>
        <source>Give the case a volume.</source>
        <translation>Dem Fall ein Volumen geben.</translation>
    </message>
    <message>
        <source>The licence of the recording is given.</source>
        <translation>Die Lizenz der Aufnahme ist angegeben.</translation>
    </message>
    <message>
        <source>Give the licence under which the recording may be passed on.</source>
        <translation>Die Lizenz angeben, unter der die Aufnahme weitergegeben werden darf.</translation>
    </message>
    <message>
        <source>It says whom to name for the recording.</source>
        <translation>Es ist angegeben, wer für die Aufnahme zu nennen ist.</translation>
    </message>
    <message>
        <source>Say whom to name for the recording.</source>
        <translation>Angeben, wer für die Aufnahme zu nennen ist.</translation>
    </message>
    <message>
        <source>Put the probe where a trainee begins, and take that as the start.</source>
        <translation>Den Schallkopf dorthin setzen, wo Lernende beginnen, und das als Anfang übernehmen.</translation>
    </message>
    <message>
        <source>From the start nothing of the volume is seen; put the start above it.</source>
        <translation>Vom Anfang aus ist nichts vom Volumen zu sehen; den Anfang darüber setzen.</translation>
    </message>
    <message>
        <source>The start shows what is to be found; begin somewhere else.</source>
        <translation>Der Anfang zeigt, was gefunden werden soll; anderswo beginnen.</translation>
    </message>
    <message>
        <source>A trainee begins where the volume is seen and nothing is given away.</source>
        <translation>Lernende beginnen, wo das Volumen zu sehen ist und nichts verraten wird.</translation>
    </message>
    <message>
        <source>It has no lesson; trainees can scan it freely.</source>
        <translation>Es gibt keine Lektion; Lernende können frei schallen.</translation>
    </message>
    <message>
        <source>Lesson &apos;%1&apos;: %2</source>
        <translation>Lektion „%1“: %2</translation>
    </message>
    <message>
        <source>Lesson &apos;%1&apos;, step &apos;%2&apos;: %3</source>
        <translation>Lektion „%1“, Schritt „%2“: %3</translation>
    </message>
    <message>
        <source>Lesson &apos;%1&apos; is ready.</source>
        <translation>Die Lektion „%1“ ist fertig.</translation>
    </message>
    <message>
        <source>Nothing in its texts looks like a real person&apos;s.</source>
        <translation>Nichts in den Texten sieht nach einer echten Person aus.</translation>
    </message>
    <message>
        <source>%1 % of the volume&apos;s near face touch the skin (gap up to %2 mm), and %3 % of it lie outside the body; place it better.</source>
        <translation>%1 % der nahen Fläche des Volumens berühren die Haut (Abstand bis %2 mm), und %3 % liegen außerhalb des Körpers; es besser platzieren.</translation>
    </message>
    <message>
        <source>The volume lies against the skin: %1 % of its near face touch it.</source>
        <translation>Das Volumen liegt an der Haut an: %1 % seiner nahen Fläche berühren sie.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; lies outside the volume; correct it, or leave it out.</source>
        <translation>„%1“ liegt außerhalb des Volumens; es berichtigen oder weglassen.</translation>
    </message>
    <message>
        <source>The probe of &apos;%1&apos; stands more than %2 mm off the skin, where no hand can put it.</source>
        <translation>Der Schallkopf von „%1“ steht mehr als %2 mm neben der Haut, wo keine Hand ihn hinsetzen kann.</translation>
    </message>
    <message>
        <source>It has no target; say what is to be found.</source>
        <translation>Es gibt kein Ziel; angeben, was gefunden werden soll.</translation>
    </message>
    <message>
        <source>All %1 targets can be reached.</source>
        <translation>Alle %1 Ziele sind erreichbar.</translation>
    </message>
    <message>
        <source>Every file of its folder is used.</source>
        <translation>Jede Datei des Ordners wird gebraucht.</translation>
    </message>
    <message>
        <source>%1 files of its folder are used by nothing, &apos;%2&apos; first; they would be handed on as well.</source>
        <translation>%1 Dateien des Ordners braucht niemand, „%2“ zuerst; sie würden mit weitergegeben.</translation>
    </message>
    <message>
        <source>Nobody knows the skin of the mannequin here, so the volume&apos;s contact was not checked.</source>
        <translation>Die Haut des Übungskörpers ist hier nicht bekannt, deshalb wurde die Auflage des Volumens nicht geprüft.</translation>
    </message>
    <message>
        <source>The case is not ready to be published: %1</source>
        <translation>Der Fall kann noch nicht veröffentlicht werden: %1</translation>
    </message>
    <message>
        <source>The case is not ready to be published, %1 things are missing. The first: %2</source>
        <translation>Der Fall kann noch nicht veröffentlicht werden, es fehlen %1 Dinge. Das erste: %2</translation>
    </message>
    <message>
        <source>The case &apos;%1&apos; has no volume yet; give it one in the Author workspace, or make it anew from a volume.</source>
        <translation>Der Fall „%1“ hat noch kein Volumen; ihm im Arbeitsbereich „Gestalten“ eines geben oder ihn aus einem Volumen neu anlegen.</translation>
    </message>
    <message>
        <source>three numbers: the unit vector in the file that points away from the probe</source>
        <translation>drei Zahlen: der Einheitsvektor in der Datei, der vom Schallkopf weg zeigt</translation>
    </message>
    <message>
        <source>three numbers: the unit vector in the file that points to the marker of the probe</source>
        <translation>drei Zahlen: der Einheitsvektor in der Datei, der zur Markierung des Schallkopfs zeigt</translation>
    </message>
    <message>
        <source>a number from -1 to 1</source>
        <translation>eine Zahl von -1 bis 1</translation>
    </message>
    <message>
        <source>an object that names a file or a recipe, not both, and where the volume lies (file_to_world)</source>
        <translation>ein Objekt, das eine Datei oder ein Rezept nennt, nicht beides, und sagt, wo das Volumen liegt (file_to_world)</translation>
    </message>
    <message>
        <source>'%1' is not a language such as "de".</source>
        <translation>„%1“ ist keine Sprache wie „de“.</translation>
    </message>
    <message>
        <source>Nothing is scanned; wait until the volume of the case is shown.</source>
        <translation>Es wird nichts untersucht; warten, bis das Volumen des Falls gezeigt wird.</translation>
    </message>
    <message>
        <source>There is no picture '%1'; choose another.</source>
        <translation>Ein Bild „%1“ gibt es nicht; ein anderes wählen.</translation>
    </message>
    <message>
        <source>'%1' is neither a PNG nor a JPEG picture; choose one of these.</source>
        <translation>„%1“ ist weder ein PNG- noch ein JPEG-Bild; ein solches wählen.</translation>
    </message>
    <message>
        <source>The picture '%1' has more than 100 million pixels; make it smaller first.</source>
        <translation>Das Bild „%1“ hat mehr als 100 Millionen Bildpunkte; es zuerst verkleinern.</translation>
    </message>
    <message>
        <source>The picture '%1' cannot be read (%2); choose another.</source>
        <translation>Das Bild „%1“ kann nicht gelesen werden (%2); ein anderes wählen.</translation>
    </message>
    <message>
        <source>The folder '%1' cannot be made (%2); check its permissions.</source>
        <translation>Der Ordner „%1“ kann nicht angelegt werden (%2); seine Zugriffsrechte prüfen.</translation>
    </message>
    <message>
        <source>'%1' cannot be written (%2); check its permissions.</source>
        <translation>„%1“ kann nicht geschrieben werden (%2); die Zugriffsrechte prüfen.</translation>
    </message>
    <message>
        <source>Nothing was scanned while it was recorded; put the probe on the body and record again.</source>
        <translation>Während der Aufnahme wurde nichts untersucht; den Schallkopf auf den Körper setzen und neu aufnehmen.</translation>
    </message>
    <message>
        <source>What was known of your exercises cannot be read; it was put aside as &apos;%1&apos;, and the exercises begin anew. %2</source>
        <translation>Was über die Übungen bekannt war, kann nicht gelesen werden; es wurde als „%1“ beiseitegelegt, und die Übungen beginnen von vorn. %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be read, nor be put aside (%2); move it away.</source>
        <translation>„%1“ kann nicht gelesen und nicht beiseitegelegt werden (%2); die Datei wegräumen.</translation>
    </message>
    <message>
        <source>Another window is writing &apos;%1&apos;; try again in a moment.</source>
        <translation>Ein anderes Fenster schreibt gerade „%1“; gleich noch einmal versuchen.</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; for your exercises cannot be made (%2); free some space, or choose a library you may write to.</source>
        <translation>Der Ordner „%1“ für die Übungen kann nicht angelegt werden (%2); Platz schaffen oder eine beschreibbare Bibliothek wählen.</translation>
    </message>
    <message>
        <source>The body is still being read; try again in a moment.</source>
        <translation>Der Körper wird noch gelesen; gleich noch einmal versuchen.</translation>
    </message>
    <message>
        <source>The exercises were not planned.</source>
        <translation>Die Übungen wurden nicht geplant.</translation>
    </message>
    <message>
        <source>Bring it into the image, freeze, set the calipers, and press Done.</source>
        <translation>Ins Bild bringen, einfrieren, die Messkreuze setzen und Fertig drücken.</translation>
    </message>
    <message>
        <source>Bring it into the image, point at it, and press Done.</source>
        <translation>Ins Bild bringen, darauf zeigen und Fertig drücken.</translation>
    </message>
    <message>
        <source>Bring the probe to this plane and press Done.</source>
        <translation>Den Schallkopf auf diese Ebene bringen und Fertig drücken.</translation>
    </message>
    <message>
        <source>Measure: %1</source>
        <translation>Messen: %1</translation>
    </message>
    <message>
        <source>Point at: %1</source>
        <translation>Zeigen auf: %1</translation>
    </message>
    <message>
        <source>Find the plane: %1</source>
        <translation>Ebene aufsuchen: %1</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a film or a TIFF, which may show more than a scan; clean it first (echoweave screen), or open it in the window.</source>
        <translation>„%1“ ist ein Film oder ein TIFF, worauf mehr als ein Schallbild zu sehen sein kann; zuerst bereinigen (echoweave screen) oder im Fenster öffnen.</translation>
    </message>
    <message>
        <source>The recording has no frame %1; it ends with frame %2.</source>
        <translation>Die Aufnahme hat kein Bild %1; sie endet mit Bild %2.</translation>
    </message>
    <message>
        <source>of the carrier</source>
        <translation>des Trägers</translation>
    </message>
    <message>
        <source>of each neighbouring line</source>
        <translation>jeder Nachbarlinie</translation>
    </message>
    <message>
        <source>scatter of the scatterers&apos; strength</source>
        <translation>Streuung der Stärke der Streuer</translation>
    </message>
    <message>
        <source>little walls of all directions</source>
        <translation>kleine Wände aller Richtungen</translation>
    </message>
    <message>
        <source>above the tissue around them</source>
        <translation>über dem Gewebe um sie</translation>
    </message>
    <message>
        <source>a whole number from 1 to 5</source>
        <translation>eine ganze Zahl von 1 bis 5</translation>
    </message>
    <message>
        <source>a number from 0.5 to 6 (of the carrier)</source>
        <translation>eine Zahl von 0,5 bis 6 (des Trägers)</translation>
    </message>
    <message>
        <source>a number from 1 to 10 (in the smallest resolution cell)</source>
        <translation>eine Zahl von 1 bis 10 (in der kleinsten Auflösungszelle)</translation>
    </message>
    <message>
        <source>a number from 3 to 10 (along a line)</source>
        <translation>eine Zahl von 3 bis 10 (entlang einer Linie)</translation>
    </message>
    <message>
        <source>a number from 1 to 3 (of the slice, in standard deviations)</source>
        <translation>eine Zahl von 1 bis 3 (der Schicht, in Standardabweichungen)</translation>
    </message>
    <message>
        <source>a number from 0.2 to 1 (of the probe&apos;s widest aperture)</source>
        <translation>eine Zahl von 0,2 bis 1 (der größten Apertur des Schallkopfs)</translation>
    </message>
    <message>
        <source>a number from 1 to 3 (1 without a filter across lines)</source>
        <translation>eine Zahl von 1 bis 3 (1 ohne Filter quer zu den Linien)</translation>
    </message>
    <message>
        <source>a number from 1 to 4 (depth over aperture, near the face)</source>
        <translation>eine Zahl von 1 bis 4 (Tiefe durch Apertur, nahe der Sondenfläche)</translation>
    </message>
    <message>
        <source>a number from 0 to 0.3 (of each neighbouring line)</source>
        <translation>eine Zahl von 0 bis 0,3 (jeder Nachbarlinie)</translation>
    </message>
    <message>
        <source>a number from -30 to 30 (decibels; 0 is neutral)</source>
        <translation>eine Zahl von -30 bis 30 (Dezibel; 0 ist neutral)</translation>
    </message>
    <message>
        <source>a number from 0 to 6 (scatter of the scatterers&apos; strength)</source>
        <translation>eine Zahl von 0 bis 6 (Streuung der Stärke der Streuer)</translation>
    </message>
    <message>
        <source>a number from 0 to 37 (little walls of all directions)</source>
        <translation>eine Zahl von 0 bis 37 (kleine Wände aller Richtungen)</translation>
    </message>
    <message>
        <source>a number from -20 to 40 (above the tissue around them)</source>
        <translation>eine Zahl von -20 bis 40 (über dem Gewebe um sie)</translation>
    </message>
    <message>
        <source>a number from 0 to 0.8 (0 without a filter of speckle)</source>
        <translation>eine Zahl von 0 bis 0,8 (0 ohne Speckle-Filter)</translation>
    </message>
    <message>
        <source>a number from -60 to 20 (of live gas, below its front; -60 is none)</source>
        <translation>eine Zahl von -60 bis 20 (von Gas bei lebenden Echos, unter seiner Vorderseite; -60 ist keines)</translation>
    </message>
    <message>
        <source>a number from 0.05 to 10 (with depth)</source>
        <translation>eine Zahl von 0,05 bis 10 (mit der Tiefe)</translation>
    </message>
    <message>
        <source>a number from -60 to 0 (of live layers, copied deeper; -60 is none)</source>
        <translation>eine Zahl von -60 bis 0 (von Schichten bei lebenden Echos, die tiefer noch einmal erscheinen; -60 ist keines)</translation>
    </message>
    <message>
        <source>a number from 0 to 20 (below 0.05 gas, below 0.5 lung)</source>
        <translation>eine Zahl von 0 bis 20 (unter 0,05 Gas, unter 0,5 Lunge)</translation>
    </message>
    <message>
        <source>0 without a filter of speckle</source>
        <translation>0 ohne Speckle-Filter</translation>
    </message>
    <message>
        <source>of live gas, below its front; -60 is none</source>
        <translation>von Gas bei lebenden Echos, unter seiner Vorderseite; -60 ist keines</translation>
    </message>
    <message>
        <source>of live layers, copied deeper; -60 is none</source>
        <translation>von Schichten bei lebenden Echos, die tiefer noch einmal erscheinen; -60 ist keines</translation>
    </message>
    <message>
        <source>below 0.05 gas, below 0.5 lung</source>
        <translation>unter 0,05 Gas, unter 0,5 Lunge</translation>
    </message>
    <message>
        <source>a number from -80 to -10 (below the echoes beside a line)</source>
        <translation>eine Zahl von -80 bis -10 (unter den Echos neben einer Linie)</translation>
    </message>
    <message>
        <source>in the smallest resolution cell</source>
        <translation>in der kleinsten Auflösungszelle</translation>
    </message>
    <message>
        <source>along a line</source>
        <translation>entlang einer Linie</translation>
    </message>
    <message>
        <source>of the slice, in standard deviations</source>
        <translation>der Schicht, in Standardabweichungen</translation>
    </message>
    <message>
        <source>of the probe&apos;s widest aperture</source>
        <translation>der größten Apertur des Schallkopfs</translation>
    </message>
    <message>
        <source>1 without a filter across lines</source>
        <translation>1 ohne Filter quer zu den Linien</translation>
    </message>
    <message>
        <source>of a recorded volume; 0 forms all grain anew</source>
        <translation>eines aufgenommenen Volumens; 0 bildet alle Körnung neu</translation>
    </message>
    <message>
        <source>The level of this volume needs %1 of memory, %2 are allowed; allow more, or choose a smaller sigma.</source>
        <translation>Der Pegel dieses Volumens braucht %1 Speicher, erlaubt sind %2; mehr erlauben oder ein kleineres Sigma wählen.</translation>
    </message>
    <message>
        <source>The level is averaged over %1 mm, expected is a number from 0.2 to 5.</source>
        <translation>Der Pegel wird über %1 mm gemittelt, erwartet wird eine Zahl von 0.2 bis 5.</translation>
    </message>
    <message>
        <source>Finding the tissue&apos;s level</source>
        <translation>Der Pegel des Gewebes wird bestimmt</translation>
    </message>
    <message>
        <source>Finding the tissue&apos;s level was stopped.</source>
        <translation>Das Bestimmen des Gewebepegels wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Live echoes need the volume in memory, and this one stays in its file; leave out --map.</source>
        <translation>Lebendige Echos brauchen das Volumen im Speicher, und dieses bleibt in seiner Datei; --map weglassen.</translation>
    </message>
    <message>
        <source>&apos;volume.level&apos; in case.json stands beside a recipe, which makes its own level; take one of them out.</source>
        <translation>&apos;volume.level&apos; in case.json steht neben einem Rezept, das seinen eigenen Pegel macht; eines davon herausnehmen.</translation>
    </message>
    <message>
        <source>a volume file of the tissue&apos;s mean echo (one 8 bit unsigned number a voxel, as `echoweave level` writes it) inside the case folder, as a relative path; beside a file alone, for a recipe makes its own</source>
        <translation>eine Volumendatei mit dem mittleren Echo des Gewebes (eine vorzeichenlose 8-Bit-Zahl je Voxel, wie `echoweave level` sie schreibt) im Fallordner, als relativer Pfad; nur neben einer Datei, denn ein Rezept macht seinen eigenen</translation>
    </message>
    <message>
        <source>a number from 0 to 1 (of a recorded volume; 0 forms all grain anew)</source>
        <translation>eine Zahl von 0 bis 1 (eines aufgenommenen Volumens; 0 bildet alle Körnung neu)</translation>
    </message>
    <message>
        <source>depth over aperture, near the face</source>
        <translation>Tiefe durch Apertur, nahe der Sondenfläche</translation>
    </message>
    <message>
        <source>below the echoes beside a line</source>
        <translation>unter den Echos neben einer Linie</translation>
    </message>
    <message>
        <source>This processor has no %1; choose one of: %2.</source>
        <translation>Dieser Prozessor hat kein %1; eines von diesen wählen: %2.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no instruction set that can be chosen; choose one of: %2.</source>
        <translation>„%1“ ist kein Befehlssatz, der sich wählen lässt; einen von diesen wählen: %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;</source>
        <translation>„%1“</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read; check the medium it is on.</source>
        <translation>„%1“ kann nicht gelesen werden; den Datenträger prüfen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written (%2); choose another place or free some room.</source>
        <translation>„%1“ kann nicht geschrieben werden (%2); einen anderen Ort wählen oder Platz schaffen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was made by somebody else in the meantime and is left as it is; choose another name.</source>
        <translation>„%1“ wurde inzwischen von jemand anderem angelegt und bleibt, wie es ist; einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was not written because of a fault in the program; try again.</source>
        <translation>„%1“ wurde wegen eines Fehlers im Programm nicht geschrieben; noch einmal versuchen.</translation>
    </message>
    <message>
        <source>&quot;female&quot;, &quot;male&quot;, &quot;other&quot; or &quot;&quot;</source>
        <translation>&quot;female&quot;, &quot;male&quot;, &quot;other&quot; oder &quot;&quot;</translation>
    </message>
    <message>
        <source>&quot;graph cut&quot;, &quot;nearest&quot; or &quot;feather&quot;: how the sweeps are joined where they overlap</source>
        <translation>&quot;graph cut&quot;, &quot;nearest&quot; oder &quot;feather&quot;: wie die Schwenks verbunden werden, wo sie sich überlappen</translation>
    </message>
    <message>
        <source>&quot;mean&quot;, &quot;maximum&quot;, &quot;latest&quot; or &quot;weighted&quot; by the confidence in each echo</source>
        <translation>&quot;mean&quot;, &quot;maximum&quot;, &quot;latest&quot; oder &quot;weighted&quot;, gewichtet nach der Verlässlichkeit jedes Echos</translation>
    </message>
    <message>
        <source>&quot;nearest&quot; or &quot;linear&quot;</source>
        <translation>&quot;nearest&quot; oder &quot;linear&quot;</translation>
    </message>
    <message>
        <source>&quot;point&quot;, &quot;plane&quot; or &quot;structure&quot;</source>
        <translation>&quot;point&quot;, &quot;plane&quot; oder &quot;structure&quot;</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 (by %2 mm and %3 degrees)</source>
        <translation>%1 (um %2 mm und %3°)</translation>
    </message>
    <message>
        <source>%1 (interface %2, compiler %3)</source>
        <translation>%1 (Schnittstelle %2, Compiler %3)</translation>
    </message>
    <message>
        <source>%1 GiB</source>
        <translation>%1 GiB</translation>
    </message>
    <message>
        <source>%1 Usage: echoweave %2.</source>
        <translation>%1 Aufruf: echoweave %2.</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>%1 angles</source>
        <translation>%1 Winkel</translation>
    </message>
    <message>
        <source>%1 are INVALID and %2 missing</source>
        <translation>%1 sind INVALID, %2 fehlen</translation>
    </message>
    <message>
        <source>%1 are used</source>
        <translation>%1 werden verwendet</translation>
    </message>
    <message>
        <source>%1 asks for the last bytes of packed samples; store them unpacked.</source>
        <translation>%1 verlangt die letzten Byte gepackter Abtastwerte; die Abtastwerte ungepackt speichern.</translation>
    </message>
    <message>
        <source>%1 asks to skip lines of its data file, which is not read; use byte skip.</source>
        <translation>%1 will Zeilen der Datendatei überspringen, was nicht unterstützt wird; byte skip verwenden.</translation>
    </message>
    <message>
        <source>%1 at character %2 of the expression</source>
        <translation>%1 beim Zeichen %2 des Ausdrucks</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 Byte</translation>
    </message>
    <message>
        <source>%1 cannot be listed; check its permissions.</source>
        <translation>Der Inhalt von %1 lässt sich nicht auflisten; die Zugriffsrechte prüfen.</translation>
    </message>
    <message>
        <source>%1 cannot be mapped (%2); read it into memory.</source>
        <translation>%1 lässt sich nicht in den Speicher abbilden (%2); stattdessen einlesen.</translation>
    </message>
    <message>
        <source>%1 cannot be opened (%2); check its permissions.</source>
        <translation>%1 kann nicht geöffnet werden (%2); die Zugriffsrechte prüfen.</translation>
    </message>
    <message>
        <source>%1 cannot be opened; check its permissions.</source>
        <translation>%1 kann nicht geöffnet werden; die Zugriffsrechte prüfen.</translation>
    </message>
    <message>
        <source>%1 cannot be read (%2); check its permissions.</source>
        <translation>%1 kann nicht gelesen werden (%2); die Zugriffsrechte prüfen.</translation>
    </message>
    <message>
        <source>%1 cannot be read as DICOM: %2; get the file again.</source>
        <translation>%1 kann nicht als DICOM gelesen werden: %2; die Datei neu besorgen.</translation>
    </message>
    <message>
        <source>%1 cannot be read as JSON; restore an earlier copy.</source>
        <translation>%1 kann nicht als JSON gelesen werden; eine frühere Kopie wiederherstellen.</translation>
    </message>
    <message>
        <source>%1 cannot be read as a mesh; export it again as STL, PLY or OBJ.</source>
        <translation>%1 kann nicht als Netz gelesen werden; neu als STL, PLY oder OBJ exportieren.</translation>
    </message>
    <message>
        <source>%1 cannot be read; check its permissions.</source>
        <translation>%1 kann nicht gelesen werden; die Zugriffsrechte prüfen.</translation>
    </message>
    <message>
        <source>%1 cannot be read; check that you may open it.</source>
        <translation>%1 kann nicht gelesen werden; prüfen, ob die Datei geöffnet werden darf.</translation>
    </message>
    <message>
        <source>%1 cannot be read; check the medium it is on.</source>
        <translation>%1 kann nicht gelesen werden; den Datenträger prüfen.</translation>
    </message>
    <message>
        <source>%1 cannot be written in blocks; end its name in .mha.</source>
        <translation>%1 kann nicht in Blöcken geschrieben werden; den Namen auf .mha enden lassen.</translation>
    </message>
    <message>
        <source>%1 could not be packed as PNG; try another size.</source>
        <translation>%1 ließ sich nicht als PNG packen; eine andere Größe versuchen.</translation>
    </message>
    <message>
        <source>%1 could not be unpacked; close other programs.</source>
        <translation>%1 konnte nicht entpackt werden; andere Programme schließen.</translation>
    </message>
    <message>
        <source>%1 could not be written: %2; check the folder and the free space, or write .avi.</source>
        <translation>%1 konnte nicht geschrieben werden: %2; Ordner und freien Platz prüfen oder als .avi schreiben.</translation>
    </message>
    <message>
        <source>%1 does not begin with &quot;ply&quot;; it is not a PLY file.</source>
        <translation>%1 beginnt nicht mit &quot;ply&quot; und ist damit keine PLY-Datei.</translation>
    </message>
    <message>
        <source>%1 does not hold one JSON object; check that it is the right file.</source>
        <translation>%1 enthält kein einzelnes JSON-Objekt; prüfen, ob es die richtige Datei ist.</translation>
    </message>
    <message>
        <source>%1 does not say how large its pixels are (it has no ultrasound regions); give the size in mm.</source>
        <translation>%1 sagt nicht, wie groß die Pixel sind (es gibt keine Ultraschallregionen); die Größe in mm angeben.</translation>
    </message>
    <message>
        <source>%1 ends before its first frame is whole; nothing of it can be used.</source>
        <translation>%1 endet, bevor das erste Bild vollständig ist; nichts davon ist zu gebrauchen.</translation>
    </message>
    <message>
        <source>%1 ends before its header says so; copy it again.</source>
        <translation>%1 endet früher, als der Kopf angibt; neu kopieren.</translation>
    </message>
    <message>
        <source>%1 ends before its samples begin; get the file again.</source>
        <translation>%1 endet, bevor die Abtastwerte beginnen; die Datei neu besorgen.</translation>
    </message>
    <message>
        <source>%1 ends inside the header of a binary STL file; export the mesh again.</source>
        <translation>%1 endet im Kopf einer binären STL-Datei; das Netz neu exportieren.</translation>
    </message>
    <message>
        <source>%1 ends, or holds something other than a number, in %2 %3 of %4; export the mesh again.</source>
        <translation>%1 endet bei %2 %3 von %4 oder enthält dort etwas anderes als eine Zahl; das Netz neu exportieren.</translation>
    </message>
    <message>
        <source>%1 entries</source>
        <translation>%1 Einträge</translation>
    </message>
    <message>
        <source>%1 extends %2, which is neither beside it nor in resources/anatomy; put it there.</source>
        <translation>%1 erweitert %2, das weder daneben noch in resources/anatomy liegt; es dort ablegen.</translation>
    </message>
    <message>
        <source>%1 extends %2, which is neither beside it nor in resources/mannequin; put it there.</source>
        <translation>%1 erweitert %2, das weder daneben noch in resources/mannequin liegt; es dort ablegen.</translation>
    </message>
    <message>
        <source>%1 finite number</source>
        <translation>%1 endliche Zahl</translation>
    </message>
    <message>
        <source>%1 finite numbers</source>
        <translation>%1 endliche Zahlen</translation>
    </message>
    <message>
        <source>%1 frame carries the same time as the frame before.</source>
        <translation>%1 Bild trägt dieselbe Zeit wie das Bild davor.</translation>
    </message>
    <message>
        <source>%1 frame with an INVALID and %2 with a missing pose were left out; %3.</source>
        <translation>%1 Bild mit ungültiger (INVALID) und %2 mit fehlender Lage wurden ausgelassen; %3.</translation>
    </message>
    <message>
        <source>%1 frames carry the same time as the frame before.</source>
        <translation>%1 Bilder tragen dieselbe Zeit wie das Bild davor.</translation>
    </message>
    <message>
        <source>%1 frames with an INVALID and %2 with a missing pose were left out; %3.</source>
        <translation>%1 Bilder mit ungültiger (INVALID) und %2 mit fehlender Lage wurden ausgelassen; %3.</translation>
    </message>
    <message>
        <source>%1 gives more than %2 transforms for one frame; check that the file is undamaged.</source>
        <translation>%1 nennt mehr als %2 Transformationen für ein Bild; prüfen, ob die Datei unbeschädigt ist.</translation>
    </message>
    <message>
        <source>%1 has &quot;%2&quot; for a coordinate (line %3); export the mesh again.</source>
        <translation>%1 hat „%2“ als Koordinate (Zeile %3); das Netz neu exportieren.</translation>
    </message>
    <message>
        <source>%1 has %2 bits a sample; export it with 8 or 16.</source>
        <translation>%1 hat %2 Bit je Abtastwert; mit 8 oder 16 exportieren.</translation>
    </message>
    <message>
        <source>%1 has %2 bytes after its samples, which were not read.</source>
        <translation>%1 hat %2 Byte nach den Abtastwerten, die nicht gelesen wurden.</translation>
    </message>
    <message>
        <source>%1 has %2 bytes, but the limit is %3; cut it into parts.</source>
        <translation>%1 hat %2 Byte, die Grenze ist aber %3; in Teile zerlegen.</translation>
    </message>
    <message>
        <source>%1 has %2 bytes, fewer than %3 samples of %4 after %5 need; correct the dimensions.</source>
        <translation>%1 hat %2 Byte, weniger als für %3 Abtastwerte zu %4 Byte ab Byte %5 nötig; die Größe berichtigen.</translation>
    </message>
    <message>
        <source>%1 has %2 values per sample, but one value or a colour is needed; export the echo levels alone.</source>
        <translation>%1 hat %2 Werte je Abtastwert, nötig ist einer oder eine Farbe; nur die Echopegel exportieren.</translation>
    </message>
    <message>
        <source>%1 has %2 x %3 pixels, the first picture %4 x %5; put pictures of one size into the folder.</source>
        <translation>%1 hat %2 × %3 Pixel, das erste Bild %4 × %5; Bilder einer Größe in den Ordner legen.</translation>
    </message>
    <message>
        <source>%1 has a face with corner %2, which does not exist; export the mesh again.</source>
        <translation>%1 hat eine Fläche mit der Ecke %2, die es nicht gibt; das Netz neu exportieren.</translation>
    </message>
    <message>
        <source>%1 has a face with fewer than three corners (line %2); export the mesh again.</source>
        <translation>%1 hat eine Fläche mit weniger als drei Ecken (Zeile %2); das Netz neu exportieren.</translation>
    </message>
    <message>
        <source>%1 has a face with the corner &quot;%2&quot;, which does not exist (line %3); export the mesh again.</source>
        <translation>%1 hat eine Fläche mit der Ecke „%2“, die es nicht gibt (Zeile %3); das Netz neu exportieren.</translation>
    </message>
    <message>
        <source>%1 has a header line of more than 1 MiB; check what kind of file it is.</source>
        <translation>%1 hat eine Kopfzeile von mehr als 1 MiB; prüfen, was für eine Datei es ist.</translation>
    </message>
    <message>
        <source>%1 has a header of more than 512 MiB; record fewer frames in one file.</source>
        <translation>%1 hat einen Kopf von mehr als 512 MiB; weniger Bilder in eine Datei aufnehmen.</translation>
    </message>
    <message>
        <source>%1 has a point whose coordinates are not finite; export the mesh again.</source>
        <translation>%1 hat einen Punkt, dessen Koordinaten nicht endlich sind; das Netz neu exportieren.</translation>
    </message>
    <message>
        <source>%1 has a point with fewer than three coordinates (line %2); export the mesh again.</source>
        <translation>%1 hat einen Punkt mit weniger als drei Koordinaten (Zeile %2); das Netz neu exportieren.</translation>
    </message>
    <message>
        <source>%1 has an ending that is not read; give a .mha, .mhd, .nrrd, .nhdr, .nii or .nii.gz file.</source>
        <translation>Dateien mit der Endung von %1 werden nicht gelesen; eine Datei .mha, .mhd, .nrrd, .nhdr, .nii oder .nii.gz angeben.</translation>
    </message>
    <message>
        <source>%1 has an ending that is not written; end its name in .avi or .mp4.</source>
        <translation>Dateien mit der Endung von %1 werden nicht geschrieben; den Namen auf .avi oder .mp4 enden lassen.</translation>
    </message>
    <message>
        <source>%1 has an ending that is not written; end its name in .igs.mha.</source>
        <translation>Dateien mit der Endung von %1 werden nicht geschrieben; den Namen auf .igs.mha enden lassen.</translation>
    </message>
    <message>
        <source>%1 has an ending that is not written; end its name in .mha or .mhd.</source>
        <translation>Dateien mit der Endung von %1 werden nicht geschrieben; den Namen auf .mha oder .mhd enden lassen.</translation>
    </message>
    <message>
        <source>%1 has an ending that is not written; end its name in .mha.</source>
        <translation>Dateien mit der Endung von %1 werden nicht geschrieben; den Namen auf .mha enden lassen.</translation>
    </message>
    <message>
        <source>%1 has an ending that is not written; end its name in .png or .mha.</source>
        <translation>Dateien mit der Endung von %1 werden nicht geschrieben; den Namen auf .png oder .mha enden lassen.</translation>
    </message>
    <message>
        <source>%1 has an ending that is not written; end its name in .xml.</source>
        <translation>Dateien mit der Endung von %1 werden nicht geschrieben; den Namen auf .xml enden lassen.</translation>
    </message>
    <message>
        <source>%1 has colours of %2 bits; export it with 8.</source>
        <translation>%1 hat Farben mit %2 Bit; mit 8 exportieren.</translation>
    </message>
    <message>
        <source>%1 has faces without vertex_indices; export the mesh again.</source>
        <translation>%1 hat Flächen ohne vertex_indices; das Netz neu exportieren.</translation>
    </message>
    <message>
        <source>%1 has format %2, and this program reads formats up to %3; open it with a newer EchoWeave.</source>
        <translation>%1 hat das Format %2, und dieses Programm liest Formate bis %3; mit einem neueren EchoWeave öffnen.</translation>
    </message>
    <message>
        <source>%1 has format %2, this program reads up to format 1; open it with a newer EchoWeave.</source>
        <translation>%1 hat das Format %2, dieses Programm liest bis Format 1; mit einem neueren EchoWeave öffnen.</translation>
    </message>
    <message>
        <source>%1 has more than the %2 bytes allowed here; check that it is the right file.</source>
        <translation>%1 hat mehr als die hier erlaubten %2 Byte; prüfen, ob es die richtige Datei ist.</translation>
    </message>
    <message>
        <source>%1 has no end of its PLY header; export the mesh again.</source>
        <translation>Der PLY-Kopf von %1 hat kein Ende; das Netz neu exportieren.</translation>
    </message>
    <message>
        <source>%1 has no triangles; export the body as a surface mesh.</source>
        <translation>%1 hat keine Dreiecke; den Körper als Oberflächennetz exportieren.</translation>
    </message>
    <message>
        <source>%1 has points without x, y and z; export the mesh again.</source>
        <translation>%1 hat Punkte ohne x, y und z; das Netz neu exportieren.</translation>
    </message>
    <message>
        <source>%1 has samples of NIfTI data type %2, which is not read; convert it to whole or floating point numbers.</source>
        <translation>%1 hat Abtastwerte vom NIfTI-Datentyp %2, der nicht gelesen wird; in ganze oder Gleitkommazahlen umwandeln.</translation>
    </message>
    <message>
        <source>%1 has samples of no known type; export it as 8 bit samples.</source>
        <translation>%1 hat Abtastwerte unbekannter Art; mit 8 Bit exportieren.</translation>
    </message>
    <message>
        <source>%1 has sizes %2, but a recording is width x height x frames; sequences of volumes are not read, export its frames.</source>
        <translation>%1 hat die Größe %2, eine Aufnahme hat aber Breite × Höhe × Bilder; Folgen von Volumen werden nicht gelesen, stattdessen die Bilder exportieren.</translation>
    </message>
    <message>
        <source>%1 has the colours %2 in %3 samples a pixel, which is not read; export it as MONOCHROME2 or RGB.</source>
        <translation>%1 hat die Farben %2 in %3 Abtastwerten je Pixel, was nicht gelesen wird; als MONOCHROME2 oder RGB exportieren.</translation>
    </message>
    <message>
        <source>%1 holds %2 packed pictures or more, but promises %3 frames; export it again.</source>
        <translation>%1 enthält %2 gepackte Bilder oder mehr, verspricht aber %3; neu exportieren.</translation>
    </message>
    <message>
        <source>%1 holds %2 samples, but labels are one 8 bit unsigned number a voxel; export them as such.</source>
        <translation>Die Abtastwerte von %1 sind %2, Labels aber eine Zahl mit 8 Bit ohne Vorzeichen je Voxel; sie so exportieren.</translation>
    </message>
    <message>
        <source>%1 holds %2 volumes one after the other; choose one by its number, 1 to %3.</source>
        <translation>%1 enthält %2 Volumen nacheinander; eines nach seiner Nummer wählen, 1 bis %3.</translation>
    </message>
    <message>
        <source>%1 holds %2 volumes one after the other; number %3 was read.</source>
        <translation>%1 enthält %2 Volumen nacheinander; Nummer %3 wurde gelesen.</translation>
    </message>
    <message>
        <source>%1 holds %2 volumes one after the other; the first was read.</source>
        <translation>%1 enthält %2 Volumen nacheinander; das erste wurde gelesen.</translation>
    </message>
    <message>
        <source>%1 holds %2 volumes, no number %3; choose one that is there.</source>
        <translation>%1 enthält %2 Volumen, aber keine Nummer %3; eine vorhandene wählen.</translation>
    </message>
    <message>
        <source>%1 holds a single plane, not a volume; import it as a picture.</source>
        <translation>%1 enthält eine einzige Ebene und kein Volumen; als Bild importieren.</translation>
    </message>
    <message>
        <source>%1 holds images, not poses alone; open it as a sweep.</source>
        <translation>%1 enthält Bilder, nicht nur Lagen; als Schwenk öffnen.</translation>
    </message>
    <message>
        <source>%1 holds its vectors as text, which is not read; write it as binary.</source>
        <translation>Die Vektoren von %1 sind als Text gespeichert, was nicht gelesen wird; binär schreiben.</translation>
    </message>
    <message>
        <source>%1 holds more than may be read at once.</source>
        <translation>%1 enthält mehr, als auf einmal gelesen werden darf.</translation>
    </message>
    <message>
        <source>%1 holds no pictures (.png, .jpg, .pgm); choose a folder that does.</source>
        <translation>%1 enthält keine Bilder (.png, .jpg, .pgm); einen Ordner mit Bildern wählen.</translation>
    </message>
    <message>
        <source>%1 holds no tissue intensities (only flow or other data); export the B-mode volume.</source>
        <translation>%1 enthält keine Gewebehelligkeiten (nur Fluss oder andere Daten); das B-Mode-Volumen exportieren.</translation>
    </message>
    <message>
        <source>%1 holds no voxels (%2); choose a file with samples in it.</source>
        <translation>%1 enthält keine Voxel (%2); eine Datei mit Abtastwerten wählen.</translation>
    </message>
    <message>
        <source>%1 is %2, so it cannot be mapped; read it into memory, or save it uncompressed with 8 bit samples.</source>
        <translation>%1 lässt sich nicht in den Speicher abbilden (%2); einlesen oder unkomprimiert mit 8-Bit-Abtastwerten speichern.</translation>
    </message>
    <message>
        <source>%1 is %2, which cannot be used.</source>
        <translation>%1 ist %2; das ist nicht zu gebrauchen.</translation>
    </message>
    <message>
        <source>%1 is %2; it must be %3.</source>
        <translation>%1 ist %2; erwartet: %3.</translation>
    </message>
    <message>
        <source>%1 is INVALID and %2 missing</source>
        <translation>%1 ist INVALID, %2 fehlen</translation>
    </message>
    <message>
        <source>%1 is XML but no device set: it has no PlusConfiguration; give the device set the sweep was recorded with.</source>
        <translation>%1 ist XML, aber keine Kalibrierung: PlusConfiguration fehlt; die Kalibrierung angeben, mit der der Schwenk aufgenommen wurde.</translation>
    </message>
    <message>
        <source>%1 is a DICOM file without a Kretz volume in it; import it as pictures.</source>
        <translation>%1 ist eine DICOM-Datei ohne Kretz-Volumen; als Bilder importieren.</translation>
    </message>
    <message>
        <source>%1 is a DICOM file without pictures; choose the file that holds the pictures.</source>
        <translation>%1 ist eine DICOM-Datei ohne Bilder; die Datei mit den Bildern wählen.</translation>
    </message>
    <message>
        <source>%1 is a Kretz file with wavelet compression, which is not published; export it uncompressed, or as Cartesian volume.</source>
        <translation>%1 ist eine Kretz-Datei mit Wavelet-Kompression, deren Aufbau nicht veröffentlicht ist; unkomprimiert oder als kartesisches Volumen exportieren.</translation>
    </message>
    <message>
        <source>%1 is a Kretz file without an uncompressed grey volume; export it uncompressed, or as Cartesian volume.</source>
        <translation>%1 ist eine Kretz-Datei ohne unkomprimiertes Grauvolumen; unkomprimiert oder als kartesisches Volumen exportieren.</translation>
    </message>
    <message>
        <source>%1 is a damaged JPEG; save the picture again.</source>
        <translation>%1 ist ein beschädigtes JPEG; das Bild neu speichern.</translation>
    </message>
    <message>
        <source>%1 is a recorded sweep, not a volume; reconstruct it first.</source>
        <translation>%1 ist ein aufgezeichneter Schwenk, kein Volumen; zuerst rekonstruieren.</translation>
    </message>
    <message>
        <source>%1 is a volume of %2 slices, not a picture; open it as a volume.</source>
        <translation>%1 ist ein Volumen mit %2 Schichten, kein Bild; als Volumen öffnen.</translation>
    </message>
    <message>
        <source>%1 is a volume, not a recorded sweep: its voxels have a place of their own; open it as a volume.</source>
        <translation>%1 ist ein Volumen, kein aufgezeichneter Schwenk: Die Voxel haben ihren eigenen Ort; als Volumen öffnen.</translation>
    </message>
    <message>
        <source>%1 is a volume, not a recorded sweep; open it as a volume.</source>
        <translation>%1 ist ein Volumen, kein aufgezeichneter Schwenk; als Volumen öffnen.</translation>
    </message>
    <message>
        <source>%1 is an empty file; export the mesh again.</source>
        <translation>%1 ist eine leere Datei; das Netz neu exportieren.</translation>
    </message>
    <message>
        <source>%1 is larger than a %2 can be (8 MiB); check that it is the right file.</source>
        <translation>%1 ist zu groß (%2, höchstens 8 MiB); prüfen, ob es die richtige Datei ist.</translation>
    </message>
    <message>
        <source>%1 is no Enhanced US Volume: its pictures have no places in space; import it as a sequence of pictures.</source>
        <translation>%1 ist kein Enhanced US Volume: Die Bilder haben keinen Ort im Raum; als Bildfolge importieren.</translation>
    </message>
    <message>
        <source>%1 is no JSON Schema that can be used; correct it (%2).</source>
        <translation>%1 ist kein brauchbares JSON-Schema; berichtigen (%2).</translation>
    </message>
    <message>
        <source>%1 is not a DICOM file; check what kind of file it is.</source>
        <translation>%1 ist keine DICOM-Datei; prüfen, was für eine Datei es ist.</translation>
    </message>
    <message>
        <source>%1 is not a JPEG of 8 bits that can be read; save the picture again.</source>
        <translation>%1 ist kein lesbares JPEG mit 8 Bit; das Bild neu speichern.</translation>
    </message>
    <message>
        <source>%1 is not a JSON object; write it as { &quot;name&quot;: value, ... }.</source>
        <translation>%1 ist kein JSON-Objekt; es als { &quot;name&quot;: Wert, ... } schreiben.</translation>
    </message>
    <message>
        <source>%1 is not a Kretz file; check what kind of file it is.</source>
        <translation>%1 ist keine Kretz-Datei; prüfen, was für eine Datei es ist.</translation>
    </message>
    <message>
        <source>%1 is not a MetaImage: a header line has no &quot;=&quot;; check what kind of file it is.</source>
        <translation>%1 ist kein MetaImage: Eine Kopfzeile hat kein „=“; prüfen, was für eine Datei es ist.</translation>
    </message>
    <message>
        <source>%1 is not a NIfTI volume; check what kind of file it is.</source>
        <translation>%1 ist kein NIfTI-Volumen; prüfen, was für eine Datei es ist.</translation>
    </message>
    <message>
        <source>%1 is not a NRRD file; check what kind of file it is.</source>
        <translation>%1 ist keine NRRD-Datei; prüfen, was für eine Datei es ist.</translation>
    </message>
    <message>
        <source>%1 is not a PNG that can be read (%2); save the picture again.</source>
        <translation>%1 ist kein lesbares PNG (%2); das Bild neu speichern.</translation>
    </message>
    <message>
        <source>%1 is not a picture that can be read (%2); save it again.</source>
        <translation>%1 ist kein lesbares Bild (%2); neu speichern.</translation>
    </message>
    <message>
        <source>%1 is not a regular file; choose a file.</source>
        <translation>%1 ist keine gewöhnliche Datei; eine Datei wählen.</translation>
    </message>
    <message>
        <source>%1 is not a text header followed by samples; check what kind of file it is.</source>
        <translation>%1 ist kein Textkopf mit Abtastwerten danach; prüfen, was für eine Datei es ist.</translation>
    </message>
    <message>
        <source>%1 is not text, which an OBJ file is; export the mesh again.</source>
        <translation>%1 ist kein Text, wie eine OBJ-Datei es ist; das Netz neu exportieren.</translation>
    </message>
    <message>
        <source>%1 is not valid JSON: it breaks at line %2, column %3; correct it there or restore an earlier copy.</source>
        <translation>%1 ist kein gültiges JSON: Es bricht in Zeile %2, Spalte %3 ab; dort berichtigen oder eine frühere Kopie wiederherstellen.</translation>
    </message>
    <message>
        <source>%1 is not well-formed XML (%2 at byte %3); give the device set the sweep was recorded with.</source>
        <translation>%1 ist kein wohlgeformtes XML (%2 bei Byte %3); die Kalibrierung angeben, mit der der Schwenk aufgenommen wurde.</translation>
    </message>
    <message>
        <source>%1 is packed as &quot;%2&quot;, which is not read; save it as raw or gzip.</source>
        <translation>%1 ist als „%2“ gepackt, was nicht gelesen wird; als raw oder gzip speichern.</translation>
    </message>
    <message>
        <source>%1 is shorter than its header promises; export the mesh again.</source>
        <translation>%1 ist kürzer, als sein Kopf verspricht; das Netz neu exportieren.</translation>
    </message>
    <message>
        <source>%1 is the header of a two-file NIfTI (.hdr + .img); convert it to a single .nii.</source>
        <translation>%1 ist der Kopf eines NIfTI aus zwei Dateien (.hdr + .img); in eine einzige .nii umwandeln.</translation>
    </message>
    <message>
        <source>%1 is too short: a NIfTI header has at least 348 bytes, the file has %2; get the file again.</source>
        <translation>%1 ist zu kurz: Ein NIfTI-Kopf hat mindestens 348 Byte, die Datei hat %2; die Datei neu besorgen.</translation>
    </message>
    <message>
        <source>%1 is too short: an item of %2 bytes has %3; get the file again.</source>
        <translation>%1 ist zu kurz: Ein Item von %2 Byte hat %3; die Datei neu besorgen.</translation>
    </message>
    <message>
        <source>%1 is too short: it promises %2 bytes of pixels and has %3; get the file again.</source>
        <translation>%1 ist zu kurz: Die Datei verspricht %2 Byte an Pixeln und hat %3; die Datei neu besorgen.</translation>
    </message>
    <message>
        <source>%1 is too short: it promises %2 frames and has %3; get the file again.</source>
        <translation>%1 ist zu kurz: Die Datei verspricht %2 Bilder und hat %3; die Datei neu besorgen.</translation>
    </message>
    <message>
        <source>%1 is too short: its header promises %2 bytes of samples, the file has %3 compressed bytes, which cannot hold them; get the file again.</source>
        <translation>%1 ist zu kurz: Der Kopf verspricht %2 Byte an Abtastwerten, die Datei hat %3 gepackte Byte, in die sie nicht passen; die Datei neu besorgen.</translation>
    </message>
    <message>
        <source>%1 is too short: its header promises %2 bytes of samples, the file has %3; get the file again.</source>
        <translation>%1 ist zu kurz: Der Kopf verspricht %2 Byte an Abtastwerten, die Datei hat %3; die Datei neu besorgen.</translation>
    </message>
    <message>
        <source>%1 is too short: its header promises %2 compressed bytes, the file has %3; get the file again.</source>
        <translation>%1 ist zu kurz: Der Kopf verspricht %2 gepackte Byte, die Datei hat %3; die Datei neu besorgen.</translation>
    </message>
    <message>
        <source>%1 is used</source>
        <translation>%1 wird verwendet</translation>
    </message>
    <message>
        <source>%1 items</source>
        <translation>%1 Einträge der Sequenz</translation>
    </message>
    <message>
        <source>%1 keeps its samples in &quot;%2&quot;, which is not there; put both files into one folder.</source>
        <translation>Die Abtastwerte von %1 sind in „%2“, das nicht da ist; beide Dateien in einen Ordner legen.</translation>
    </message>
    <message>
        <source>%1 keeps its samples in many files, which is not read; save it as one .nrrd.</source>
        <translation>Die Abtastwerte von %1 sind in vielen Dateien, was nicht gelesen wird; als eine .nrrd speichern.</translation>
    </message>
    <message>
        <source>%1 lists one file per slice, which is not read; convert it to a single .mha.</source>
        <translation>%1 nennt je Schicht eine Datei, was nicht gelesen wird; in eine einzige .mha umwandeln.</translation>
    </message>
    <message>
        <source>%1 missed beats were put in evenly between those around.</source>
        <translation>%1 fehlende Schläge wurden gleichmäßig zwischen denen ringsum ergänzt.</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 names one file per slice by a pattern, which is not read; convert it to a single .mha.</source>
        <translation>%1 nennt je Schicht eine Datei nach einem Muster, was nicht gelesen wird; in eine einzige .mha umwandeln.</translation>
    </message>
    <message>
        <source>%1 needs the mannequin %2, which is neither beside it nor in resources/mannequin; put it there.</source>
        <translation>%1 braucht den Übungskörper %2, der weder daneben noch in resources/mannequin liegt; ihn dort ablegen.</translation>
    </message>
    <message>
        <source>%1 nests deeper than %2 levels, which no file of this program does; check that it is the right file.</source>
        <translation>%1 ist tiefer als %2 Ebenen geschachtelt, wie keine Datei dieses Programms; prüfen, ob es die richtige Datei ist.</translation>
    </message>
    <message>
        <source>%1 numbers</source>
        <translation>%1 Zahlen</translation>
    </message>
    <message>
        <source>%1 numbers (NDims)</source>
        <translation>%1 Zahlen (NDims)</translation>
    </message>
    <message>
        <source>%1 numbers (dimension)</source>
        <translation>%1 Zahlen (dimension)</translation>
    </message>
    <message>
        <source>%1 numbers from %2 to %3</source>
        <translation>%1 Zahlen von %2 bis %3</translation>
    </message>
    <message>
        <source>%1 of %2 cycles are irregular; their frames are not used.</source>
        <translation>%1 von %2 Zyklen sind unregelmäßig; ihre Bilder werden nicht verwendet.</translation>
    </message>
    <message>
        <source>%1 of the pixels are coloured, in a colour flow region; their luminance became the echo level, and a mask tells where.</source>
        <translation>%1 der Pixel sind farbig, in einer Region mit Farbdoppler; ihre Helligkeit wurde zum Echopegel, und eine Maske sagt, wo.</translation>
    </message>
    <message>
        <source>%1 of the pixels are coloured, in a colour flow region; they were made black, and a mask tells where.</source>
        <translation>%1 der Pixel sind farbig, in einer Region mit Farbdoppler; sie wurden geschwärzt, und eine Maske sagt, wo.</translation>
    </message>
    <message>
        <source>%1 of the pixels are coloured; their luminance became the echo level, and a mask tells where.</source>
        <translation>%1 der Pixel sind farbig; ihre Helligkeit wurde zum Echopegel, und eine Maske sagt, wo.</translation>
    </message>
    <message>
        <source>%1 of the pixels are coloured; their luminance became the echo level.</source>
        <translation>%1 der Pixel sind farbig; ihre Helligkeit wurde zum Echopegel.</translation>
    </message>
    <message>
        <source>%1 of the pixels are coloured; they were made black, and a mask tells where.</source>
        <translation>%1 der Pixel sind farbig; sie wurden geschwärzt, und eine Maske sagt, wo.</translation>
    </message>
    <message>
        <source>%1 of the pixels are coloured; they were made black.</source>
        <translation>%1 der Pixel sind farbig; sie wurden geschwärzt.</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 oder %2</translation>
    </message>
    <message>
        <source>%1 pairs agree within %2 (rms).</source>
        <translation>%1 Paare stimmen auf %2 überein (RMS).</translation>
    </message>
    <message>
        <source>%1 pairs agree within %2 (rms); %3 do not fit, by %4.</source>
        <translation>%1 Paare stimmen auf %2 überein (RMS); %3 passen nicht, um %4.</translation>
    </message>
    <message>
        <source>%1 pairs agree within %2 (rms); %3 does not fit, by %4.</source>
        <translation>%1 Paare stimmen auf %2 überein (RMS); %3 passt nicht, um %4.</translation>
    </message>
    <message>
        <source>%1 patient text</source>
        <translation>%1 Text zum Patienten</translation>
    </message>
    <message>
        <source>%1 phases cannot be made of %2 gated frames; ask for at least 1 and at most as many as there are frames.</source>
        <translation>Aus %2 zugeordneten Bildern lassen sich keine %1 Phasen machen; mindestens 1 und höchstens so viele Phasen verlangen, wie es Bilder gibt.</translation>
    </message>
    <message>
        <source>%1 pictures were read in the order of their numbers: x to the right, y down, z from picture to picture, the origin in the first pixel of the first; which way they lie in the patient is not known.</source>
        <translation>%1 Bilder wurden in der Reihenfolge ihrer Nummern gelesen: x nach rechts, y nach unten, z von Bild zu Bild, der Ursprung im ersten Pixel des ersten; wie sie im Patienten liegen, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>%1 pixels of each picture cut away or made black, with any text in them.</source>
        <translation>%1 Pixel jedes Bildes abgeschnitten oder geschwärzt, samt Text darin.</translation>
    </message>
    <message>
        <source>%1 planes hold flow or other data instead of tissue; they were left out.</source>
        <translation>%1 Ebenen enthalten Fluss oder andere Daten statt Gewebe; sie wurden weggelassen.</translation>
    </message>
    <message>
        <source>%1 private fields of the maker left out.</source>
        <translation>%1 private Felder des Herstellers weggelassen.</translation>
    </message>
    <message>
        <source>%1 promises %2 frames of %3 x %4 pixels, for which %5 bytes of memory would be needed, but the limit is %6; check that the file is undamaged, or cut it into parts.</source>
        <translation>%1 verspricht %2 Bilder von %3 × %4 Pixeln, für die %5 Byte Speicher nötig wären, die Grenze ist aber %6; prüfen, ob die Datei unbeschädigt ist, oder sie in Teile zerlegen.</translation>
    </message>
    <message>
        <source>%1 promises %2 of &quot;%3&quot;; use a mesh with at most %4.</source>
        <translation>%1 verspricht %2 Elemente „%3“; ein Netz mit höchstens %4 verwenden.</translation>
    </message>
    <message>
        <source>%1 promises %2 pixels, but the limit is %3; save a smaller picture.</source>
        <translation>%1 verspricht %2 Pixel, die Grenze ist aber %3; ein kleineres Bild speichern.</translation>
    </message>
    <message>
        <source>%1 promises %2 samples and holds %3; get the file again.</source>
        <translation>%1 verspricht %2 Abtastwerte und enthält %3; die Datei neu besorgen.</translation>
    </message>
    <message>
        <source>%1 promises %2 triangles but ends after %3; export the mesh again.</source>
        <translation>%1 verspricht %2 Dreiecke, endet aber nach %3; das Netz neu exportieren.</translation>
    </message>
    <message>
        <source>%1 promises %2 triangles; use a mesh with at most 20 million.</source>
        <translation>%1 verspricht %2 Dreiecke; ein Netz mit höchstens 20 Millionen verwenden.</translation>
    </message>
    <message>
        <source>%1 repeat the place of an earlier pair.</source>
        <translation>%1 wiederholen die Stelle eines früheren Paares.</translation>
    </message>
    <message>
        <source>%1 repeats the place of an earlier pair.</source>
        <translation>%1 wiederholt die Stelle eines früheren Paares.</translation>
    </message>
    <message>
        <source>%1 sample is not a finite number and became 0.</source>
        <translation>%1 Abtastwert ist keine endliche Zahl und wurde zu 0.</translation>
    </message>
    <message>
        <source>%1 samples</source>
        <translation>%1 je Abtastwert</translation>
    </message>
    <message>
        <source>%1 samples are not finite numbers and became 0.</source>
        <translation>%1 Abtastwerte sind keine endlichen Zahlen und wurden zu 0.</translation>
    </message>
    <message>
        <source>%1 says &quot;%2&quot; in its header, which cannot be read; export the mesh again.</source>
        <translation>%1 enthält im Kopf „%2“, was nicht zu lesen ist; das Netz neu exportieren.</translation>
    </message>
    <message>
        <source>%1 says its pictures are %2, but they are not stored so; export it again.</source>
        <translation>%1 nennt die Bilder %2, sie sind aber nicht so gespeichert; neu exportieren.</translation>
    </message>
    <message>
        <source>%1 says its pictures are uncompressed, but they are not stored so; export it again.</source>
        <translation>%1 nennt die Bilder unkomprimiert, sie sind aber nicht so gespeichert; neu exportieren.</translation>
    </message>
    <message>
        <source>%1 shows %2 calibrated pictures side by side (%3); choose one of the regions.</source>
        <translation>%1 zeigt %2 kalibrierte Bilder nebeneinander (%3); eine der Regionen wählen.</translation>
    </message>
    <message>
        <source>%1 subvolumes lie together, %2 pair confirmed by loops.</source>
        <translation>%1 Teilvolumen liegen zusammen, %2 Paar ist durch Schleifen bestätigt.</translation>
    </message>
    <message>
        <source>%1 subvolumes lie together, %2 pairs confirmed by loops.</source>
        <translation>%1 Teilvolumen liegen zusammen, %2 Paare sind durch Schleifen bestätigt.</translation>
    </message>
    <message>
        <source>%1 text of the examination</source>
        <translation>%1 Text zur Untersuchung</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1 transform comes without a status and counts as valid.</source>
        <translation>%1 Transformation hat keinen Status und gilt als gültig.</translation>
    </message>
    <message>
        <source>%1 transforms come without a status and count as valid.</source>
        <translation>%1 Transformationen haben keinen Status und gelten als gültig.</translation>
    </message>
    <message>
        <source>%1 values a voxel</source>
        <translation>%1 Werte je Voxel</translation>
    </message>
    <message>
        <source>%1 was changed while it was in use; open it again.</source>
        <translation>%1 wurde während der Benutzung geändert; neu öffnen.</translation>
    </message>
    <message>
        <source>%1 with %2</source>
        <translation>%1 mit %2</translation>
    </message>
    <message>
        <source>%1 words</source>
        <translation>%1 Wörter</translation>
    </message>
    <message>
        <source>%1 words, one per axis,</source>
        <translation>%1 Wörter, eines je Achse</translation>
    </message>
    <message>
        <source>%1 would need %2 bytes of memory, but the limit is %3; cut it into parts.</source>
        <translation>%1 bräuchte %2 Byte Speicher, die Grenze ist aber %3; in Teile zerlegen.</translation>
    </message>
    <message>
        <source>%1 x %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>%1 x %2, rescaled</source>
        <translation>%1 × %2, umgerechnet</translation>
    </message>
    <message>
        <source>%1, %2 min left</source>
        <translation>%1, noch %2 min</translation>
    </message>
    <message>
        <source>%1, %2 s left</source>
        <translation>%1, noch %2 s</translation>
    </message>
    <message>
        <source>%1, one a frame</source>
        <translation>%1, einer je Bild</translation>
    </message>
    <message>
        <source>%1, one a sample of that axis</source>
        <translation>%1, einer je Abtastwert dieser Achse</translation>
    </message>
    <message>
        <source>%1, or 0 for %2</source>
        <translation>%1 oder 0 für %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2, %3 x %4 pixels at (%5, %6)</source>
        <translation>%1: %2, %3 × %4 Pixel bei (%5, %6)</translation>
    </message>
    <message>
        <source>%1: %2, %3 x %4 pixels at (%5, %6), %7 x %8 mm a pixel</source>
        <translation>%1: %2, %3 × %4 Pixel bei (%5, %6), %7 × %8 mm je Pixel</translation>
    </message>
    <message>
        <source>%1; and more</source>
        <translation>%1; und weitere</translation>
    </message>
    <message>
        <source>%2 has %1 region, no region %3; choose one that is there, or 0 for the whole picture.</source>
        <translation>%2 hat %1 Region, aber keine Region %3; eine vorhandene wählen oder 0 für das ganze Bild.</translation>
    </message>
    <message>
        <source>%2 has %1 regions, no region %3; choose one that is there, or 0 for the whole picture.</source>
        <translation>%2 hat %1 Regionen, aber keine Region %3; eine vorhandene wählen oder 0 für das ganze Bild.</translation>
    </message>
    <message>
        <source>%2 holds %1 volume, no number %3; choose one that is there.</source>
        <translation>%2 enthält %1 Volumen, aber keine Nummer %3; eine vorhandene wählen.</translation>
    </message>
    <message>
        <source>%2 holds %1 volumes, no number %3; choose one that is there.</source>
        <translation>%2 enthält %1 Volumen, aber keine Nummer %3; eine vorhandene wählen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos;</source>
        <translation>„%1“</translation>
    </message>
    <message>
        <source>&apos;%1&apos; and &apos;%2&apos; could not be deformed onto each other. %3</source>
        <translation>„%1“ und „%2“ konnten nicht miteinander verformt werden. %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; and &apos;%2&apos; could not be registered. %3</source>
        <translation>„%1“ und „%2“ konnten nicht zugeordnet werden. %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; belongs to the program, and the next version replaces it; save the case as a copy of your own.</source>
        <translation>„%1“ gehört zum Programm, und die nächste Version ersetzt es; den Fall als eigene Kopie speichern.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be a section of a case; it needs small letters, digits, &apos;-&apos; and &apos;_&apos;.</source>
        <translation>„%1“ kann kein Abschnitt eines Falls sein; der Name braucht Kleinbuchstaben, Ziffern, „-“ und „_“.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be read; give a file with one pose a line.</source>
        <translation>„%1“ kann nicht gelesen werden; eine Datei mit einer Lage je Zeile angeben.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be written (%2); choose another folder.</source>
        <translation>„%1“ kann nicht geschrieben werden (%2); einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not describe raw samples (%2); write DIMS:TYPE:SPACING[:OFFSET], as in 256x256x180:u8:0.5,0.5,1.2:512.</source>
        <translation>„%1“ beschreibt keine rohen Abtastwerte (%2); GRÖSSE:TYP:ABSTAND[:VERSATZ] schreiben, wie in 256x256x180:u8:0.5,0.5,1.2:512.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; gave no volume; check what kind of file it is.</source>
        <translation>„%1“ ergab kein Volumen; prüfen, was für eine Datei es ist.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has more than 64 MiB, which is too much for poses; check that it is the right file.</source>
        <translation>„%1“ hat mehr als 64 MiB, zu viel für Lagen; prüfen, ob es die richtige Datei ist.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; holds %2 numbers; a transform is 16 numbers, row by row.</source>
        <translation>„%1“ enthält %2 Zahlen; eine Transformation besteht aus 16 Zahlen, Zeile für Zeile.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; holds %2 volumes one after the other; choose one by its number, 1 to %2.</source>
        <translation>„%1“ enthält %2 Volumen nacheinander; eines über seine Nummer wählen, 1 bis %2.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; holds poses, but is no recording of a scan made here; open it as a sweep&apos;s tracking instead.</source>
        <translation>„%1“ enthält Lagen, ist aber keine hier gemachte Aufzeichnung einer Untersuchung; stattdessen als Tracking eines Schwenks öffnen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; holds something that is not a number; a transform is 16 numbers, row by row.</source>
        <translation>„%1“ enthält etwas, das keine Zahl ist; eine Transformation besteht aus 16 Zahlen, Zeile für Zeile.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in %2 cannot be checked (%3); the schema of its plugin is wrong.</source>
        <translation>„%1“ (%2) lässt sich nicht prüfen (%3); das Schema der Erweiterung ist fehlerhaft.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in %2 cannot be used. %3</source>
        <translation>„%1“ (%2) ist nicht zu gebrauchen. %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in %2 is %3, which cannot be used.</source>
        <translation>„%1“ (%2) ist %3; das ist nicht zu gebrauchen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in %2 is %3; it must be %4.</source>
        <translation>„%1“ (%2) ist %3; erwartet: %4.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in case.json is &quot;%2&quot;, and the patient has %3.</source>
        <translation>„%1“ in case.json ist „%2“, aber der Patient hat %3.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in case.json is &quot;%2&quot;, and the patient has %3; it has %4.</source>
        <translation>„%1“ in case.json ist „%2“, aber der Patient hat %3; er hat %4.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in case.json is &quot;%2&quot;, but the case folder cannot be opened; check that it is still there.</source>
        <translation>„%1“ in case.json ist „%2“, aber der Fallordner lässt sich nicht öffnen; prüfen, ob er noch da ist.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in case.json is &quot;%2&quot;, but there is no such file in the case folder; put it there or correct the name.</source>
        <translation>„%1“ in case.json ist „%2“, aber im Fallordner gibt es keine solche Datei; sie dort ablegen oder den Namen berichtigen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in case.json is &quot;%2&quot;, which is no probe of the program; name one of %3.</source>
        <translation>„%1“ in case.json ist „%2“, aber das ist kein Schallkopf des Programms; einen von diesen nennen: %3.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in case.json is &quot;%2&quot;, which is not a relative path inside the case folder; copy the file into the case folder and name it there.</source>
        <translation>„%1“ in case.json ist „%2“, aber das ist kein relativer Pfad innerhalb des Fallordners; die Datei in den Fallordner kopieren und dort nennen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in case.json is &quot;%2&quot;, which keeps its samples in &apos;%3&apos;, outside of the case folder; copy both files into the case folder and correct the name in the header.</source>
        <translation>„%1“ in case.json ist „%2“; die Abtastwerte dieser Datei liegen in „%3“, außerhalb des Fallordners; beide Dateien in den Fallordner kopieren und den Namen im Kopf der Datei berichtigen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in case.json is &quot;%2&quot;, which leads out of the case folder through a link; copy the file itself into the case folder.</source>
        <translation>„%1“ in case.json ist „%2“, was über eine Verknüpfung aus dem Fallordner hinausführt; die Datei selbst in den Fallordner kopieren.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a folder, a pipe or a device; give a file with one pose a line.</source>
        <translation>„%1“ ist ein Ordner, eine Pipe oder ein Gerät; eine Datei mit einer Lage je Zeile angeben.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a pipe or a device and not a file; save what comes out of it as a file first.</source>
        <translation>„%1“ ist eine Pipe oder ein Gerät und keine Datei; zuerst als Datei speichern, was herauskommt.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a recording already, so there is nothing to import; with the poses of a tracker, or a file that says how a motor moved the probe, a volume can be made of it.</source>
        <translation>„%1“ ist bereits eine Aufnahme, zu importieren gibt es also nichts; mit den Lagen eines Trackers oder einer Datei, die sagt, wie ein Motor den Schallkopf bewegte, lässt sich daraus ein Volumen machen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither 16 numbers nor a file that can be read; give the pose in one of these two ways.</source>
        <translation>„%1“ ist weder 16 Zahlen noch eine lesbare Datei; die Lage auf eine dieser beiden Arten angeben.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no rectangle; give x,y,width,height in pixels from the upper left corner.</source>
        <translation>„%1“ ist kein Rechteck; x,y,Breite,Höhe in Pixeln von der linken oberen Ecke angeben.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a result that was written here before, and would be lost; move it away or choose another folder.</source>
        <translation>„%1“ ist kein Ergebnis, das hier früher geschrieben wurde, und ginge verloren; die Datei verschieben oder einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a step; the steps are %2.</source>
        <translation>„%1“ ist kein Schritt; die Schritte sind %2.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not an option of stitch.</source>
        <translation>„%1“ ist keine Option von stitch.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not empty, and nothing in it is overwritten; choose a new or an empty folder.</source>
        <translation>„%1“ ist nicht leer, und nichts darin wird überschrieben; einen neuen oder leeren Ordner wählen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is of no known kind; if it holds samples without a header, say how they are stored (dimensions, type, spacing, offset).</source>
        <translation>„%1“ ist von keiner bekannten Art; wenn die Datei Abtastwerte ohne Kopf enthält, angeben, wie sie gespeichert sind (Größe, Typ, Abstand, Versatz).</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is read by this project and would be written over by its result; choose another folder.</source>
        <translation>„%1“ wird von diesem Projekt gelesen und würde von seinem Ergebnis überschrieben; einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; lies among the intermediate results of &apos;%2&apos;, which come and go; copy it to a place of its own or choose another folder.</source>
        <translation>„%1“ liegt unter den Zwischenergebnissen von „%2“, die kommen und gehen; die Datei an einen eigenen Ort kopieren oder einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; of the plugin &apos;%2&apos; did not come to its end (%3); please report it with what you did.</source>
        <translation>„%1“ der Erweiterung „%2“ kam nicht zu Ende (%3); bitte melden und dabei die letzten Schritte nennen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; of the plugin &apos;%2&apos; stopped unexpectedly (%3); please report it with what you did.</source>
        <translation>„%1“ der Erweiterung „%2“ brach unerwartet ab (%3); bitte melden und dabei die letzten Schritte nennen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; says 1 x 1 x 1 mm without place or rotation, as converters write when they do not know; give the spacing in mm.</source>
        <translation>„%1“ nennt 1 × 1 × 1 mm ohne Ort und Drehung, wie es Konverter schreiben, die es nicht wissen; den Abstand in mm angeben.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; with &apos;%2&apos;, which was said already</source>
        <translation>„%1“ mit „%2“, schon vorher genannt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; with &apos;%2&apos;: %3, and the other pairs contradict it. %4</source>
        <translation>„%1“ mit „%2“: %3, und die anderen Paare widersprechen. %4</translation>
    </message>
    <message>
        <source>&apos;%1&apos; with &apos;%2&apos;: %3. %4</source>
        <translation>„%1“ mit „%2“: %3. %4</translation>
    </message>
    <message>
        <source>&apos;start_pose&apos; in case.json lies %1 mm beside the volume, where a probe sees nothing; put the probe on the body above the volume and take that pose.</source>
        <translation>„start_pose“ in case.json liegt %1 mm neben dem Volumen, wo ein Schallkopf nichts sieht; den Schallkopf über dem Volumen auf den Körper setzen und diese Lage nehmen.</translation>
    </message>
    <message>
        <source>&apos;volume.labels&apos; in case.json stands beside a recipe, which makes its own labels; take one of them out.</source>
        <translation>„volume.labels“ in case.json steht neben einem Rezept, das seine Labels selbst macht; eines von beiden entfernen.</translation>
    </message>
    <message>
        <source>(correlation %1 before, %2 after, %3 by chance)</source>
        <translation>(Korrelation %1 vorher, %2 nachher, %3 durch Zufall)</translation>
    </message>
    <message>
        <source>(correlation %1 over %2 overlap, %3 deviations above chance)</source>
        <translation>(Korrelation %1 über %2 Überlappung, %3 Standardabweichungen über dem Zufall)</translation>
    </message>
    <message>
        <source>(none named)</source>
        <translation>(keine genannt)</translation>
    </message>
    <message>
        <source>--prune keeps what a finished volume was made of and does not go with --until.</source>
        <translation>--prune behält, woraus ein fertiges Volumen gemacht wurde, und verträgt sich nicht mit --until.</translation>
    </message>
    <message>
        <source>--threads is &apos;%1&apos; and must be a whole number from 0 to 9999.</source>
        <translation>--threads ist „%1“ und muss eine ganze Zahl von 0 bis 9999 sein.</translation>
    </message>
    <message>
        <source>0 (absent), 1 (interpolated) or 2 (measured)</source>
        <translation>0 (fehlt), 1 (interpoliert) oder 2 (gemessen)</translation>
    </message>
    <message>
        <source>0 for the probe&apos;s own</source>
        <translation>0 für die des Schallkopfs</translation>
    </message>
    <message>
        <source>0 is neutral</source>
        <translation>0 ist neutral</translation>
    </message>
    <message>
        <source>0 or at least 1</source>
        <translation>0 oder mindestens 1</translation>
    </message>
    <message>
        <source>0 or more</source>
        <translation>0 oder mehr</translation>
    </message>
    <message>
        <source>1 as physics has it</source>
        <translation>1 wie in der Physik</translation>
    </message>
    <message>
        <source>1 missed beat was put in evenly between those around.</source>
        <translation>1 fehlender Schlag wurde gleichmäßig zwischen denen ringsum ergänzt.</translation>
    </message>
    <message>
        <source>1 or more</source>
        <translation>1 oder mehr</translation>
    </message>
    <message>
        <source>1 private field of the maker left out.</source>
        <translation>1 privates Feld des Herstellers weggelassen.</translation>
    </message>
    <message>
        <source>16 bit signed</source>
        <translation>16 Bit mit Vorzeichen</translation>
    </message>
    <message>
        <source>16 bit unsigned</source>
        <translation>16 Bit ohne Vorzeichen</translation>
    </message>
    <message>
        <source>16 finite numbers (4 x 4, row by row)</source>
        <translation>16 endliche Zahlen (4 × 4, Zeile für Zeile)</translation>
    </message>
    <message>
        <source>16 numbers (4 x 4, row by row)</source>
        <translation>16 Zahlen (4 × 4, Zeile für Zeile)</translation>
    </message>
    <message>
        <source>16 numbers, a rigid 4 x 4 matrix row by row, in mm</source>
        <translation>16 Zahlen, eine starre 4 × 4-Matrix, Zeile für Zeile, in mm</translation>
    </message>
    <message>
        <source>16 numbers, probe to world, a rigid 4 x 4 matrix row by row, in mm</source>
        <translation>16 Zahlen, Schallkopf zu Welt, eine starre 4 × 4-Matrix, Zeile für Zeile, in mm</translation>
    </message>
    <message>
        <source>16 numbers, probe to world, a rigid 4 x 4 matrix row by row, in mm, of a plane; without it the patient&apos;s plane of that name</source>
        <translation>16 Zahlen, Schallkopf zu Welt, eine starre 4 × 4-Matrix, Zeile für Zeile, in mm, bei einer Ebene; ohne sie gilt die Ebene dieses Namens beim Patienten</translation>
    </message>
    <message>
        <source>16 numbers, probe to world, a rigid 4 x 4 matrix row by row, in mm: where an expert has the finding in the picture</source>
        <translation>16 Zahlen, Schallkopf zu Welt, eine starre 4 × 4-Matrix, Zeile für Zeile, in mm: wo ein Experte den Befund im Bild hat</translation>
    </message>
    <message>
        <source>16 numbers, row by row</source>
        <translation>16 Zahlen, Zeile für Zeile</translation>
    </message>
    <message>
        <source>16 numbers, row by row, or the name of a file that holds them</source>
        <translation>16 Zahlen, Zeile für Zeile, oder der Name einer Datei, die sie enthält</translation>
    </message>
    <message>
        <source>16 numbers, row by row, when the method is &quot;by hand&quot;</source>
        <translation>16 Zahlen, Zeile für Zeile, wenn das Verfahren &quot;by hand&quot; ist</translation>
    </message>
    <message>
        <source>2 or 3</source>
        <translation>2 oder 3</translation>
    </message>
    <message>
        <source>32 bit floating point</source>
        <translation>32 Bit Gleitkomma</translation>
    </message>
    <message>
        <source>32 bit signed</source>
        <translation>32 Bit mit Vorzeichen</translation>
    </message>
    <message>
        <source>32 bit unsigned</source>
        <translation>32 Bit ohne Vorzeichen</translation>
    </message>
    <message>
        <source>32 or 64 bit floating point</source>
        <translation>32 oder 64 Bit Gleitkomma</translation>
    </message>
    <message>
        <source>64 bit floating point</source>
        <translation>64 Bit Gleitkomma</translation>
    </message>
    <message>
        <source>64 bit signed</source>
        <translation>64 Bit mit Vorzeichen</translation>
    </message>
    <message>
        <source>64 bit unsigned</source>
        <translation>64 Bit ohne Vorzeichen</translation>
    </message>
    <message>
        <source>8 bit signed</source>
        <translation>8 Bit mit Vorzeichen</translation>
    </message>
    <message>
        <source>8 bit unsigned</source>
        <translation>8 Bit ohne Vorzeichen</translation>
    </message>
    <message>
        <source>8 bit unsigned (0 absent, 1 interpolated, 2 measured)</source>
        <translation>8 Bit ohne Vorzeichen (0 fehlt, 1 interpoliert, 2 gemessen)</translation>
    </message>
    <message>
        <source>8 bit unsigned (0 to 255 for 0 to 1)</source>
        <translation>8 Bit ohne Vorzeichen (0 bis 255 für 0 bis 1)</translation>
    </message>
    <message>
        <source>A case cannot be saved inside its own folder; choose a folder beside it.</source>
        <translation>Ein Fall lässt sich nicht in seinem eigenen Ordner speichern; einen Ordner daneben wählen.</translation>
    </message>
    <message>
        <source>A confidence map needs at least 2 scan lines of 2 samples; this frame has %1 x %2.</source>
        <translation>Eine Verlässlichkeitskarte braucht mindestens 2 Bildzeilen mit 2 Abtastwerten; dieses Bild hat %1 × %2.</translation>
    </message>
    <message>
        <source>A delay that is not a finite number cannot be used; give seconds.</source>
        <translation>Eine Verzögerung, die keine endliche Zahl ist, ist nicht zu gebrauchen; Sekunden angeben.</translation>
    </message>
    <message>
        <source>A factor is the distance of nodes in pixels and must be at least 2.</source>
        <translation>Ein Faktor ist der Abstand der Knoten in Pixeln und muss mindestens 2 sein.</translation>
    </message>
    <message>
        <source>A field of two components lies in one slice; %1 was not written.</source>
        <translation>Ein Feld mit zwei Komponenten liegt in einer Schicht; %1 wurde nicht geschrieben.</translation>
    </message>
    <message>
        <source>A film of %1 x %2 pixels cannot be made; give at least 2x2.</source>
        <translation>Ein Film von %1 × %2 Pixeln ist nicht möglich; mindestens 2x2 angeben.</translation>
    </message>
    <message>
        <source>A hole filling reach of %1 mm cannot be used; give 0 mm or more.</source>
        <translation>Eine Füllweite von %1 mm ist nicht zu gebrauchen; 0 mm oder mehr angeben.</translation>
    </message>
    <message>
        <source>A hole filling reach of %1 mm is %2 voxels here, more than the %3 that can be bridged; give a shorter reach or a coarser spacing.</source>
        <translation>Eine Füllweite von %1 mm entspricht hier %2 Voxeln, mehr als den %3, die überbrückt werden können; eine kürzere Füllweite oder einen gröberen Voxelabstand angeben.</translation>
    </message>
    <message>
        <source>A mannequin is a recipe (.json) or a mesh (.stl, .ply, .obj), and %1 is neither.</source>
        <translation>Ein Übungskörper ist ein Rezept (.json) oder ein Netz (.stl, .ply, .obj), und %1 ist keines von beiden.</translation>
    </message>
    <message>
        <source>A part of the case in the cache could not be used and was made again. %1</source>
        <translation>Ein Teil des Falls im Zwischenspeicher war nicht zu gebrauchen und wurde neu gemacht. %1</translation>
    </message>
    <message>
        <source>A picture of %1 x %2 pixels is too small for the words it must carry; give at least %3x%4, or write .mha.</source>
        <translation>Ein Bild von %1 × %2 Pixeln ist zu klein für die Worte, die es tragen muss; mindestens %3x%4 angeben oder .mha schreiben.</translation>
    </message>
    <message>
        <source>A prepared volume in the cache was damaged; it is made again.</source>
        <translation>Ein vorbereitetes Volumen im Zwischenspeicher war beschädigt; es wird neu gemacht.</translation>
    </message>
    <message>
        <source>A recording is shown; close it before the settings are changed.</source>
        <translation>Eine Aufzeichnung wird gezeigt; sie schließen, bevor die Einstellungen geändert werden.</translation>
    </message>
    <message>
        <source>The image is frozen; let it run before the settings are changed.</source>
        <translation>Das Bild ist eingefroren; es laufen lassen, bevor die Einstellungen geändert werden.</translation>
    </message>
    <message>
        <source>A stroke of the seam editor names a volume that is not there, or has no place or radius.</source>
        <translation>Ein Strich des Nahteditors nennt ein Volumen, das es nicht gibt, oder hat keinen Ort oder Radius.</translation>
    </message>
    <message>
        <source>A text of &apos;%1&apos; in %2 is too long to be checked; shorten it to at most %3 bytes.</source>
        <translation>Ein Text von „%1“ (%2) ist zum Prüfen zu lang; auf höchstens %3 Byte kürzen.</translation>
    </message>
    <message>
        <source>A text of the case is not valid UTF-8 and cannot be saved; type it again.</source>
        <translation>Ein Text des Falls ist kein gültiges UTF-8 und lässt sich nicht speichern; neu eingeben.</translation>
    </message>
    <message>
        <source>A value is missing after %1.</source>
        <translation>Nach %1 fehlt ein Wert.</translation>
    </message>
    <message>
        <source>A volume is missing: name two.</source>
        <translation>Ein Volumen fehlt; zwei angeben.</translation>
    </message>
    <message>
        <source>A volume needs a name; type one.</source>
        <translation>Ein Volumen braucht einen Namen; einen eingeben.</translation>
    </message>
    <message>
        <source>A volume of this sweep needs more memory than allowed; use a coarser spacing or allow more memory.</source>
        <translation>Ein Volumen dieses Schwenks braucht mehr Speicher als erlaubt; einen gröberen Voxelabstand wählen oder mehr Speicher erlauben.</translation>
    </message>
    <message>
        <source>A voxel spacing of %1 mm cannot be used; give a positive number of millimetres.</source>
        <translation>Ein Voxelabstand von %1 mm ist nicht zu gebrauchen; eine positive Zahl in Millimetern angeben.</translation>
    </message>
    <message>
        <source>An image is flat where the other one shows something: there is nothing to go by, and the displacement is left at zero.</source>
        <translation>Ein Bild ist flach, wo das andere etwas zeigt: Es gibt keinen Anhaltspunkt, und die Verschiebung bleibt null.</translation>
    </message>
    <message>
        <source>Another plugin named &apos;%1&apos; was found before this one and is used instead; remove one of them.</source>
        <translation>Eine andere Erweiterung mit dem Namen „%1“ wurde vor dieser gefunden und wird an ihrer Stelle verwendet; eine von beiden entfernen.</translation>
    </message>
    <message>
        <source>Another run is at work in &apos;%1&apos;; wait until it has ended, or choose another folder.</source>
        <translation>In „%1“ arbeitet schon ein anderer Lauf; warten, bis er zu Ende ist, oder einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>Another volume is called &apos;%1&apos; already; choose another name.</source>
        <translation>Ein anderes Volumen heißt schon „%1“; einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>Arranging voxels in bricks</source>
        <translation>Voxel werden in Blöcken angeordnet</translation>
    </message>
    <message>
        <source>Assessing the registration was cancelled.</source>
        <translation>Das Bewerten der Registrierung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>At %1 mm the volume of %2 would need %3 bytes of memory, but the limit is %4; choose a coarser spacing.</source>
        <translation>Bei %1 mm bräuchte das Volumen von %2 an Speicher %3 Byte, die Grenze ist aber %4; einen gröberen Voxelabstand wählen.</translation>
    </message>
    <message>
        <source>At least one iteration is needed.</source>
        <translation>Mindestens ein Durchgang ist nötig.</translation>
    </message>
    <message>
        <source>At most %1 volumes can be stitched at once; stitch them in groups.</source>
        <translation>Höchstens %1 Volumen können auf einmal verbunden werden; in Gruppen verbinden.</translation>
    </message>
    <message>
        <source>Deformed, the volumes agree.</source>
        <translation>Verformt stimmen die Volumen überein.</translation>
    </message>
    <message>
        <source>Blending</source>
        <translation>Mischen</translation>
    </message>
    <message>
        <source>Building the virtual patient</source>
        <translation>Der virtuelle Patient wird erzeugt</translation>
    </message>
    <message>
        <source>Building the virtual patient was stopped.</source>
        <translation>Das Erzeugen des virtuellen Patienten wurde abgebrochen.</translation>
    </message>
    <message>
        <source>By how much the poses lag behind the images cannot be told. %1</source>
        <translation>Um wie viel die Lagen den Bildern nachlaufen, ist nicht zu erkennen. %1</translation>
    </message>
    <message>
        <source>Checking for residual motion</source>
        <translation>Restbewegung wird gesucht</translation>
    </message>
    <message>
        <source>Combining deformations</source>
        <translation>Verformungen werden zusammengeführt</translation>
    </message>
    <message>
        <source>Comparing</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Comparing images</source>
        <translation>Bilder werden verglichen</translation>
    </message>
    <message>
        <source>Comparing movements</source>
        <translation>Bewegungen werden verglichen</translation>
    </message>
    <message>
        <source>Comparing sweeps</source>
        <translation>Schwenks werden verglichen</translation>
    </message>
    <message>
        <source>Comparing views</source>
        <translation>Ansichten werden verglichen</translation>
    </message>
    <message>
        <source>Computing the exact slices</source>
        <translation>Die genauen Schnitte werden berechnet</translation>
    </message>
    <message>
        <source>Converting beams</source>
        <translation>Strahlen werden umgewandelt</translation>
    </message>
    <message>
        <source>Converting scan lines</source>
        <translation>Bildzeilen werden umgewandelt</translation>
    </message>
    <message>
        <source>Converting the scan lines was stopped.</source>
        <translation>Das Umwandeln der Bildzeilen wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Coordinates are those of the file&apos;s own volume frame of reference, in mm; where it lies in the patient is not in the file.</source>
        <translation>Die Koordinaten sind die des eigenen Bezugssystems der Datei (Volume Frame of Reference), in mm; wo es im Patienten liegt, steht nicht in der Datei.</translation>
    </message>
    <message>
        <source>Copying</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Cutting seams</source>
        <translation>Nähte werden geschnitten</translation>
    </message>
    <message>
        <source>Deforming %1 and %2</source>
        <translation>%1 und %2 werden verformt</translation>
    </message>
    <message>
        <source>Descending from the start led nowhere; a search about it found a pose %1 and %2 degrees from it.</source>
        <translation>Der Abstieg vom Anfang führte nirgendwohin; eine Suche um ihn herum fand eine Lage %1 und %2° davon entfernt.</translation>
    </message>
    <message>
        <source>Drawing views</source>
        <translation>Ansichten werden gezeichnet</translation>
    </message>
    <message>
        <source>ECG</source>
        <translation>EKG</translation>
    </message>
    <message>
        <source>ECHOWEAVE_RESOURCES is &apos;%1&apos;, which is not a folder; correct it or unset it.</source>
        <translation>ECHOWEAVE_RESOURCES ist „%1“, aber das ist kein Ordner; den Wert berichtigen oder die Variable aufheben.</translation>
    </message>
    <message>
        <source>Estimating confidence</source>
        <translation>Verlässlichkeit wird geschätzt</translation>
    </message>
    <message>
        <source>Estimating the confidence was stopped.</source>
        <translation>Das Schätzen der Verlässlichkeit wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Filling holes</source>
        <translation>Lücken werden gefüllt</translation>
    </message>
    <message>
        <source>Filling holes along the sweep</source>
        <translation>Lücken entlang des Schwenks werden gefüllt</translation>
    </message>
    <message>
        <source>Finding the surfaces</source>
        <translation>Die Grenzflächen werden gesucht</translation>
    </message>
    <message>
        <source>Frame %1 has &quot;%2&quot; for its field %3; gating needs numbers and the frames&apos; times.</source>
        <translation>Bild %1 hat „%2“ in seinem Feld %3; Gating braucht Zahlen und die Zeiten der Bilder.</translation>
    </message>
    <message>
        <source>Frame %1 has %2 x %3 pixels and frame 0 has %4 x %5; reconstruct frames of one size at a time.</source>
        <translation>Bild %1 hat %2 × %3 Pixel und Bild 0 hat %4 × %5; Bilder einer Größe auf einmal rekonstruieren.</translation>
    </message>
    <message>
        <source>Frame %1 has another size than frame 0; gate frames of one size.</source>
        <translation>Bild %1 hat eine andere Größe als Bild 0; Gating braucht Bilder einer Größe.</translation>
    </message>
    <message>
        <source>Frame %1 has no pixels; reconstruct a sweep with images.</source>
        <translation>Bild %1 hat keine Pixel; einen Schwenk mit Bildern rekonstruieren.</translation>
    </message>
    <message>
        <source>Frame %1 has no time for its field %2; gating needs numbers and the frames&apos; times.</source>
        <translation>Bild %1 hat keine Zeit zu seinem Feld %2; Gating braucht Zahlen und die Zeiten der Bilder.</translation>
    </message>
    <message>
        <source>Frame %1 has no time, so poses cannot be shifted in time; choose a recording whose frames all have one.</source>
        <translation>Bild %1 hat keine Zeit, deshalb lassen sich Lagen nicht in der Zeit verschieben; eine Aufnahme wählen, deren Bilder alle eine haben.</translation>
    </message>
    <message>
        <source>Frame %1 has no time; gate a recording whose frames all have one.</source>
        <translation>Bild %1 hat keine Zeit; zum Gating eine Aufnahme verwenden, deren Bilder alle eine haben.</translation>
    </message>
    <message>
        <source>Frame %1 of %2 is damaged: its %3 stream cannot be unpacked into the size the file gives; get the file again.</source>
        <translation>Bild %1 von %2 ist beschädigt: Der Datenstrom (%3) lässt sich nicht in die Größe entpacken, die die Datei nennt; die Datei neu besorgen.</translation>
    </message>
    <message>
        <source>Frames of this sweep would be %1 x %2 pixels, but a side may have %3 at most; use a larger pixel_mm.</source>
        <translation>Die Bilder dieses Schwenks hätten %1 × %2 Pixel, eine Seite darf aber höchstens %3 haben; ein größeres pixel_mm nehmen.</translation>
    </message>
    <message>
        <source>Halves of the overlap registered apart agree to %1%2.</source>
        <translation>Getrennt zugeordnete Hälften der Überlappung stimmen auf %1 überein%2.</translation>
    </message>
    <message>
        <source>Halves of the overlap registered apart contradict each other by %1%2.</source>
        <translation>Getrennt zugeordnete Hälften der Überlappung widersprechen sich um %1%2.</translation>
    </message>
    <message>
        <source>Halves of the overlap registered apart contradict each other by %1%2: the start may be too far off.</source>
        <translation>Getrennt zugeordnete Hälften der Überlappung widersprechen sich um %1%2: Vielleicht liegt der Anfang zu weit daneben.</translation>
    </message>
    <message>
        <source>Image Orientation (Volume) of frame %1</source>
        <translation>Image Orientation (Volume) von Bild %1</translation>
    </message>
    <message>
        <source>Image Position (Volume) of frame %1</source>
        <translation>Image Position (Volume) von Bild %1</translation>
    </message>
    <message>
        <source>Imaging the tissue was stopped.</source>
        <translation>Das Abbilden des Gewebes wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Imaging tissue</source>
        <translation>Das Gewebe wird abgebildet</translation>
    </message>
    <message>
        <source>In %1 %2 of the pixels are coloured, as by Doppler, and echo levels cannot show that; say whether to keep them as grey or to drop them.</source>
        <translation>In %1 sind %2 der Pixel farbig, wie durch Doppler, und Echopegel können das nicht zeigen; angeben, ob sie als Grau bleiben oder wegfallen.</translation>
    </message>
    <message>
        <source>In %1 %2 of the pixels are coloured, in a colour flow region, as by Doppler, and echo levels cannot show that; say whether to keep them as grey or to drop them.</source>
        <translation>In %1 sind %2 der Pixel in einer Region mit Farbdoppler farbig, und Echopegel können das nicht zeigen; angeben, ob sie als Grau bleiben oder wegfallen.</translation>
    </message>
    <message>
        <source>In %1, %2 is &quot;%3&quot;, but %4 is needed; correct the header or export the file again.</source>
        <translation>In %1 ist %2 „%3“ (erwartet: %4); den Kopf berichtigen oder die Datei neu exportieren.</translation>
    </message>
    <message>
        <source>In %1, Transform is &quot;%2 to %3&quot;, but two frame names (From and To) is needed; correct the header or export the file again.</source>
        <translation>In %1 ist Transform „%2 zu %3“ (erwartet: zwei Namen von Bezugssystemen, From und To); den Kopf berichtigen oder die Datei neu exportieren.</translation>
    </message>
    <message>
        <source>Inspecting %1</source>
        <translation>%1 wird untersucht</translation>
    </message>
    <message>
        <source>Inverting the deformation</source>
        <translation>Die Verformung wird umgekehrt</translation>
    </message>
    <message>
        <source>Inverting the deformation was cancelled.</source>
        <translation>Das Umkehren der Verformung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>It could as well be %1: they lie on the same loop and nothing else tells them apart. Match another pair across it.</source>
        <translation>Ebenso gut könnte es %1 sein: Sie liegen auf derselben Schleife, und nichts anderes unterscheidet sie. Ein weiteres Paar quer dazu zuordnen.</translation>
    </message>
    <message>
        <source>Its deformation has a displacement too many, too few or without a number.</source>
        <translation>Seine Verformung hat eine Verschiebung zu viel, zu wenig oder ohne Zahl.</translation>
    </message>
    <message>
        <source>Its grey correction has a number that cannot be used.</source>
        <translation>Seine Graukorrektur enthält eine Zahl, die nicht zu gebrauchen ist.</translation>
    </message>
    <message>
        <source>Joining would need %1 MiB, and the limit is %2 MiB; choose a coarser spacing or smaller blocks.</source>
        <translation>Das Zusammenfügen bräuchte %1 MiB, und die Grenze ist %2 MiB; einen gröberen Voxelabstand oder kleinere Blöcke wählen.</translation>
    </message>
    <message>
        <source>LOCAL or the name of a file</source>
        <translation>LOCAL oder der Name einer Datei</translation>
    </message>
    <message>
        <source>Labelling the tissues</source>
        <translation>Die Gewebe werden bezeichnet</translation>
    </message>
    <message>
        <source>Labelling the tissues was stopped.</source>
        <translation>Das Bezeichnen der Gewebe wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Left out, because they can name a person, a place or a time: %1.</source>
        <translation>Weggelassen, weil es eine Person, einen Ort oder eine Zeit nennen kann: %1.</translation>
    </message>
    <message>
        <source>Line %1 of the poses holds %2 numbers; a pose is 16 numbers, row by row.</source>
        <translation>Zeile %1 der Lagen enthält %2 Zahlen; eine Lage besteht aus 16 Zahlen, Zeile für Zeile.</translation>
    </message>
    <message>
        <source>Line %1 of the poses holds something that is not a number; a pose is 16 numbers, row by row.</source>
        <translation>Zeile %1 der Lagen enthält etwas, das keine Zahl ist; eine Lage besteht aus 16 Zahlen, Zeile für Zeile.</translation>
    </message>
    <message>
        <source>Looking at overlaps</source>
        <translation>Überlappungen werden angesehen</translation>
    </message>
    <message>
        <source>Looking for a rhythm in the images</source>
        <translation>In den Bildern wird ein Rhythmus gesucht</translation>
    </message>
    <message>
        <source>Looking for seams</source>
        <translation>Nähte werden gesucht</translation>
    </message>
    <message>
        <source>Looking for shadows</source>
        <translation>Schatten werden gesucht</translation>
    </message>
    <message>
        <source>M-mode</source>
        <translation>M-Mode</translation>
    </message>
    <message>
        <source>Making the body was cancelled.</source>
        <translation>Das Erzeugen des Körpers wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Making the skin</source>
        <translation>Die Haut wird erzeugt</translation>
    </message>
    <message>
        <source>Making the surface</source>
        <translation>Die Oberfläche wird erzeugt</translation>
    </message>
    <message>
        <source>Making the surface was stopped.</source>
        <translation>Das Erzeugen der Oberfläche wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Measuring distances from the border</source>
        <translation>Abstände vom Rand werden gemessen</translation>
    </message>
    <message>
        <source>Measuring the patient was stopped.</source>
        <translation>Das Vermessen des Patienten wurde abgebrochen.</translation>
    </message>
    <message>
        <source>More pairs contradict each other than agree.</source>
        <translation>Es widersprechen sich mehr Paare, als übereinstimmen.</translation>
    </message>
    <message>
        <source>More than 268 million pixels fall into one voxel; reconstruct with a finer spacing.</source>
        <translation>Mehr als 268 Millionen Pixel fallen in einen Voxel; mit einem feineren Voxelabstand rekonstruieren.</translation>
    </message>
    <message>
        <source>Residual motion that the deformation does not follow: at %1 of the places that can tell, tissue lies elsewhere, by %2 in the mean (deformed, %3).</source>
        <translation>Der Verformung entgeht Bewegung: An %1 der Stellen, die es zeigen können, liegt Gewebe im Mittel %2 daneben (verformt, %3).</translation>
    </message>
    <message>
        <source>Residual motion that the deformation does not follow: at %1 of the places that can tell, tissue lies elsewhere, by %2 in the mean.</source>
        <translation>Der Verformung entgeht Bewegung: An %1 der Stellen, die es zeigen können, liegt Gewebe im Mittel %2 daneben.</translation>
    </message>
    <message>
        <source>Movement in the images and in the poses do not agree at any delay (correlation %1, %2 is needed).</source>
        <translation>Die Bewegungen in den Bildern und in den Lagen stimmen bei keiner Verzögerung überein (Korrelation %1, nötig ist %2).</translation>
    </message>
    <message>
        <source>Moving the probe</source>
        <translation>Der Schallkopf wird bewegt</translation>
    </message>
    <message>
        <source>Near this start the images agree no better than unrelated tissue does%1.</source>
        <translation>Nahe diesem Anfang stimmen die Bilder nicht besser überein als fremdes Gewebe%1.</translation>
    </message>
    <message>
        <source>No deformation brought the volumes closer than they were; the start is kept.</source>
        <translation>Keine Verformung brachte die Volumen näher zusammen, als sie waren; der Anfang bleibt.</translation>
    </message>
    <message>
        <source>No deformation brought the volumes together; the start is kept.</source>
        <translation>Keine Verformung brachte die Volumen zusammen; der Anfang bleibt.</translation>
    </message>
    <message>
        <source>No case is open; open one first.</source>
        <translation>Kein Fall ist geöffnet; zuerst einen öffnen.</translation>
    </message>
    <message>
        <source>No case is open; open one in the workstation first.</source>
        <translation>Kein Fall ist geöffnet; zuerst einen in der Workstation öffnen.</translation>
    </message>
    <message>
        <source>No frame has a valid way to %1, so it was not used.</source>
        <translation>Kein Bild hat einen gültigen Weg zu %1; dieses Bezugssystem wurde deshalb nicht verwendet.</translation>
    </message>
    <message>
        <source>No frame of the motorised sweep can be used: each is marked invalid or has no motor value.</source>
        <translation>Kein Bild des motorisierten Schwenks ist zu gebrauchen: Jedes ist als ungültig markiert oder hat keinen Wert des Motors.</translation>
    </message>
    <message>
        <source>No loop checks the pair %1: were it wrong, nothing would show it.</source>
        <translation>Keine Schleife prüft das Paar %1: Wäre es falsch, fiele es nicht auf.</translation>
    </message>
    <message>
        <source>No loop checks the pairs %1: were one of them wrong, nothing would show it.</source>
        <translation>Keine Schleife prüft die Paare %1: Wäre eines davon falsch, fiele es nicht auf.</translation>
    </message>
    <message>
        <source>No pose brings the two volumes into agreement over %1 overlap.</source>
        <translation>Keine Lage bringt die beiden Volumen über %1 Überlappung zur Übereinstimmung.</translation>
    </message>
    <message>
        <source>No region of %1 tells how large a pixel is (%2); give the size of a pixel in mm, or choose a region that you know to be right.</source>
        <translation>Keine Region von %1 sagt, wie groß ein Pixel ist (%2); die Größe eines Pixels in mm angeben oder eine Region wählen, die sicher richtig ist.</translation>
    </message>
    <message>
        <source>No voxel of the %1 volume was measured; choose a volume that holds an echo.</source>
        <translation>Kein Voxel des %1 Volumens wurde gemessen; ein Volumen wählen, das ein Echo enthält.</translation>
    </message>
    <message>
        <source>No warp agrees better than chance does: the displacement is left at zero %1.</source>
        <translation>Keine Verformung passt besser als der Zufall: Die Verschiebung bleibt null %1.</translation>
    </message>
    <message>
        <source>No warp agrees better than the images as they lie, and they agree: the displacement is left at zero %1.</source>
        <translation>Keine Verformung passt besser als die Bilder, wie sie liegen, und diese stimmen überein: Die Verschiebung bleibt null %1.</translation>
    </message>
    <message>
        <source>No warp agrees better where it was not fitted: the displacement is left at zero (gain of correlation there %1, its error %2).</source>
        <translation>Keine Verformung passt dort besser, wo sie nicht angepasst wurde: Die Verschiebung bleibt null (Gewinn an Korrelation dort %1, sein Fehler %2).</translation>
    </message>
    <message>
        <source>Nobody says where pixels lie before the probe; give &quot;image&quot; with pixel_mm and face_px in the motor file, or the device set (.xml) with the calibration from Image to Probe.</source>
        <translation>Nirgends steht, wo die Pixel vor dem Schallkopf liegen; in der Motordatei &quot;image&quot; mit pixel_mm und face_px angeben oder die Kalibrierung (.xml) von Image zu Probe.</translation>
    </message>
    <message>
        <source>Nobody says where pixels lie before the probe; its face was taken to be at the middle of their upper edge.</source>
        <translation>Nirgends steht, wo die Pixel vor dem Schallkopf liegen; die Schallkopffläche wurde in der Mitte ihrer oberen Kante angenommen.</translation>
    </message>
    <message>
        <source>Nothing is scanned; open a case in the workstation first.</source>
        <translation>Es wird nichts geschallt; zuerst einen Fall in der Workstation öffnen.</translation>
    </message>
    <message>
        <source>Nothing is scanned; open a case or a volume first.</source>
        <translation>Es wird nichts geschallt; zuerst einen Fall oder ein Volumen öffnen.</translation>
    </message>
    <message>
        <source>Nothing joins these %1 parts: %2. How they lie to each other is not known: match a pair between them.</source>
        <translation>Diese %1 Teile verbindet nichts: %2. Wie sie zueinander liegen, ist nicht bekannt; ein Paar zwischen ihnen zuordnen.</translation>
    </message>
    <message>
        <source>Nothing that names a person was found.</source>
        <translation>Es wurde nichts gefunden, was eine Person nennt.</translation>
    </message>
    <message>
        <source>Of %1 frame, none has a usable pose to %2: %3; check that the tracker saw the probe, or choose another target frame.</source>
        <translation>Von %1 Bild hat keines eine brauchbare Lage zu %2: %3; prüfen, ob der Tracker den Schallkopf gesehen hat, oder ein anderes Bezugssystem als Ziel wählen.</translation>
    </message>
    <message>
        <source>Of %1 frames, none has a usable pose to %2: %3; check that the tracker saw the probe, or choose another target frame.</source>
        <translation>Von %1 Bildern hat keines eine brauchbare Lage zu %2: %3; prüfen, ob der Tracker den Schallkopf gesehen hat, oder ein anderes Bezugssystem als Ziel wählen.</translation>
    </message>
    <message>
        <source>Of %1 the first volume alone can be read, because of how it is stored; convert it to .nii or .mha.</source>
        <translation>Von %1 kann nur das erste Volumen gelesen werden, weil es so gespeichert ist; in .nii oder .mha umwandeln.</translation>
    </message>
    <message>
        <source>Of the beam angles (C300/0002) there is one alone, %1 degrees off; it was laid straight ahead.</source>
        <translation>Von den Strahlwinkeln (C300/0002) gibt es nur einen, um %1 Grad versetzt; er wurde geradeaus gelegt.</translation>
    </message>
    <message>
        <source>Of the plane angles (C300/0001) there is one alone, %1 degrees off; it was laid straight ahead.</source>
        <translation>Von den Ebenenwinkeln (C300/0001) gibt es nur einen, um %1 Grad versetzt; er wurde geradeaus gelegt.</translation>
    </message>
    <message>
        <source>One can read the pairs in two ways: without %1, or without %2. Add a pair or correct one.</source>
        <translation>Die Paare lassen sich auf zwei Arten lesen: ohne %1 oder ohne %2. Ein weiteres Paar setzen oder eines berichtigen.</translation>
    </message>
    <message>
        <source>One of the volumes has no part that may be believed.</source>
        <translation>Eines der Volumen hat keinen Teil, dem zu trauen ist.</translation>
    </message>
    <message>
        <source>One place is too few: a turn needs three places that are not on one line.</source>
        <translation>Eine Stelle ist zu wenig: Eine Drehung braucht drei Stellen, die nicht auf einer Geraden liegen.</translation>
    </message>
    <message>
        <source>One pose stands out by a margin of %1, and halves of the overlap registered apart agree to %2%3.</source>
        <translation>Eine Lage ragt mit dem Abstand %1 heraus, und getrennt zugeordnete Hälften der Überlappung stimmen auf %2 überein%3.</translation>
    </message>
    <message>
        <source>Only %1 % of the motion was kept: all of it would have squeezed the tissue too far.</source>
        <translation>Nur %1 % der Bewegung wurden beibehalten: Die ganze hätte das Gewebe zu stark gestaucht.</translation>
    </message>
    <message>
        <source>Only the mean has weights; ask for the mean or do not ask for weights.</source>
        <translation>Nur das Mittel hat Gewichte; das Mittel verlangen oder auf Gewichte verzichten.</translation>
    </message>
    <message>
        <source>Opening the case was stopped.</source>
        <translation>Das Öffnen des Falls wurde abgebrochen.</translation>
    </message>
    <message>
        <source>PARALLEL, FAN or ROTATIONAL</source>
        <translation>PARALLEL, FAN oder ROTATIONAL</translation>
    </message>
    <message>
        <source>Pair %1 joins %2 with itself.</source>
        <translation>Paar %1 verbindet %2 mit sich selbst.</translation>
    </message>
    <message>
        <source>Pair %1 names a subvolume that does not exist; there are %2.</source>
        <translation>Paar %1 nennt ein Teilvolumen, das es nicht gibt; es sind %2.</translation>
    </message>
    <message>
        <source>Part %1 of %2, which overlaps no other: %3.</source>
        <translation>Teil %1 von %2, der keinen anderen überlappt: %3.</translation>
    </message>
    <message>
        <source>Pasting frames</source>
        <translation>Bilder werden eingefügt</translation>
    </message>
    <message>
        <source>Phase %1 names frame %2, which the sweep does not have.</source>
        <translation>Phase %1 nennt das Bild %2, das es im Schwenk nicht gibt.</translation>
    </message>
    <message>
        <source>Phase %1 of %2 has no frame; ask for fewer phases.</source>
        <translation>Phase %1 von %2 hat kein Bild; weniger Phasen verlangen.</translation>
    </message>
    <message>
        <source>Phases were taken from the images: which moment phase 0 is, they do not say.</source>
        <translation>Die Phasen wurden den Bildern entnommen: Welcher Augenblick Phase 0 ist, sagen sie nicht.</translation>
    </message>
    <message>
        <source>Pictures do not say how large a pixel is and how far apart they lie; give the spacing in mm.</source>
        <translation>Bilder sagen nicht, wie groß ein Pixel ist und wie weit sie auseinanderliegen; die Abstände in mm angeben.</translation>
    </message>
    <message>
        <source>Pictures may have text burned in; check that they name nobody.</source>
        <translation>In Bilder kann Text eingebrannt sein; prüfen, dass sie niemanden nennen.</translation>
    </message>
    <message>
        <source>Pixel Spacing of frame %1</source>
        <translation>Pixel Spacing von Bild %1</translation>
    </message>
    <message>
        <source>Placed by hand.</source>
        <translation>Von Hand gelegt.</translation>
    </message>
    <message>
        <source>Placing subvolumes</source>
        <translation>Teilvolumen werden platziert</translation>
    </message>
    <message>
        <source>Poses lag %1 behind the images (+- %2, from the %3); they were moved in time, and %4 frames beside gaps and ends have none left.</source>
        <translation>Die Lagen laufen den Bildern um %1 nach (± %2, gemessen an: %3); sie wurden in der Zeit verschoben. Ohne Lage sind nun an Lücken und Enden %4 Bilder.</translation>
    </message>
    <message>
        <source>Poses lag %1 behind the images (+- %2, from the %3); they were moved in time.</source>
        <translation>Die Lagen laufen den Bildern um %1 nach (± %2, gemessen an: %3); sie wurden in der Zeit verschoben.</translation>
    </message>
    <message>
        <source>Poses lag %1 behind the images; they were moved in time, and %2 frames beside gaps and ends have none left.</source>
        <translation>Die Lagen laufen den Bildern um %1 nach; sie wurden in der Zeit verschoben. Ohne Lage sind nun an Lücken und Enden %2 Bilder.</translation>
    </message>
    <message>
        <source>Poses lag %1 behind the images; they were moved in time.</source>
        <translation>Die Lagen laufen den Bildern um %1 nach; sie wurden in der Zeit verschoben.</translation>
    </message>
    <message>
        <source>Preparing images</source>
        <translation>Bilder werden vorbereitet</translation>
    </message>
    <message>
        <source>Preparing the case was stopped.</source>
        <translation>Das Vorbereiten des Falls wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Preparing the images</source>
        <translation>Bilder werden vorbereitet</translation>
    </message>
    <message>
        <source>Read as %1, as you said; the origin is the first voxel, and which way the axes lie in the patient is not in the file.</source>
        <translation>Wie angegeben gelesen als %1; der Ursprung ist der erste Voxel, und wie die Achsen im Patienten liegen, steht nicht in der Datei.</translation>
    </message>
    <message>
        <source>Readers of this format disagree about the side of z; if left and right planes are swapped, import it mirrored.</source>
        <translation>Leser dieses Formats sind sich über die Seite von z nicht einig; sind linke und rechte Ebenen vertauscht, gespiegelt importieren.</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>Reading frames</source>
        <translation>Bilder werden gelesen</translation>
    </message>
    <message>
        <source>Reading frames at the voxels</source>
        <translation>Bilder werden an den Voxeln gelesen</translation>
    </message>
    <message>
        <source>Reading pictures</source>
        <translation>Bilder werden eingelesen</translation>
    </message>
    <message>
        <source>Reading the mesh</source>
        <translation>Das Netz wird gelesen</translation>
    </message>
    <message>
        <source>Reading the mesh was cancelled.</source>
        <translation>Das Lesen des Netzes wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Reading the patient</source>
        <translation>Der Patient wird gelesen</translation>
    </message>
    <message>
        <source>Reading the patient was stopped.</source>
        <translation>Das Lesen des Patienten wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Reading the slices</source>
        <translation>Schichten werden gelesen</translation>
    </message>
    <message>
        <source>Reading the slices was stopped.</source>
        <translation>Das Lesen der Schichten wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Reading voxels</source>
        <translation>Voxel werden gelesen</translation>
    </message>
    <message>
        <source>Reading was cancelled.</source>
        <translation>Das Lesen wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Reconstructing the sweep &apos;%1&apos;</source>
        <translation>Der Schwenk „%1“ wird rekonstruiert</translation>
    </message>
    <message>
        <source>Recording the sweep</source>
        <translation>Der Schwenk wird aufgenommen</translation>
    </message>
    <message>
        <source>Recording the sweep &apos;%1&apos;</source>
        <translation>Der Schwenk „%1“ wird aufgenommen</translation>
    </message>
    <message>
        <source>Recording the sweep was stopped.</source>
        <translation>Das Aufnehmen des Schwenks wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Recording this sweep takes %1 MiB, but only %2 MiB may be used; use fewer frames or a larger pixel_mm.</source>
        <translation>Das Aufnehmen dieses Schwenks braucht %1 MiB, es dürfen aber nur %2 MiB belegt werden; weniger Bilder oder ein größeres pixel_mm nehmen.</translation>
    </message>
    <message>
        <source>Reference is the file&apos;s volume frame of reference; each frame has its own place in it.</source>
        <translation>Reference ist das Bezugssystem der Datei (Volume Frame of Reference); jedes Bild hat darin seinen Ort.</translation>
    </message>
    <message>
        <source>Reference, Tracker or World</source>
        <translation>Reference, Tracker oder World</translation>
    </message>
    <message>
        <source>Region %1 of %2 cannot be used as it is; give the size of a pixel in mm, or choose another region.</source>
        <translation>Region %1 von %2 ist so nicht zu gebrauchen; die Größe eines Pixels in mm angeben oder eine andere Region wählen.</translation>
    </message>
    <message>
        <source>Region %1 of %2 cannot be used; take the whole picture and give the size of a pixel in mm.</source>
        <translation>Region %1 von %2 ist nicht zu gebrauchen; das ganze Bild nehmen und die Größe eines Pixels in mm angeben.</translation>
    </message>
    <message>
        <source>Regions and windows need a side above 0 mm.</source>
        <translation>Gebiete und Fenster brauchen eine Seite über 0 mm.</translation>
    </message>
    <message>
        <source>Registering</source>
        <translation>Zuordnen</translation>
    </message>
    <message>
        <source>Registering %1 and %2</source>
        <translation>%1 und %2 werden zugeordnet</translation>
    </message>
    <message>
        <source>Registration was cancelled.</source>
        <translation>Das Zuordnen wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Saving was cancelled.</source>
        <translation>Das Speichern wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Searching for large motion</source>
        <translation>Große Bewegungen werden gesucht</translation>
    </message>
    <message>
        <source>Searching poses</source>
        <translation>Lagen werden gesucht</translation>
    </message>
    <message>
        <source>Shadows and other streaks were taken out, which drew the volumes %1 and %2 degrees elsewhere.</source>
        <translation>Schatten und andere Streifen wurden herausgenommen; sie hatten die Volumen um %1 und %2° anderswohin gezogen.</translation>
    </message>
    <message>
        <source>Shaping the body</source>
        <translation>Der Körper wird geformt</translation>
    </message>
    <message>
        <source>Shaping the body was stopped.</source>
        <translation>Das Formen des Körpers wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Slices of %1 samples are too large for a preview; check the dimensions.</source>
        <translation>Schichten von %1 Abtastwerten sind für eine Vorschau zu groß; die Größe prüfen.</translation>
    </message>
    <message>
        <source>Some pixels are coloured; their luminance became the echo level.</source>
        <translation>Einige Pixel sind farbig; ihre Helligkeit wurde zum Echopegel.</translation>
    </message>
    <message>
        <source>Sources can be kept for at most %1 frames, the sweep has %2; reconstruct it in parts or without sources.</source>
        <translation>Quellbilder lassen sich für höchstens %1 Bilder festhalten, der Schwenk hat %2; in Teilen oder ohne Quellbilder rekonstruieren.</translation>
    </message>
    <message>
        <source>Spacing is 1 x 1 x 1 mm with the origin at 0 and no rotation: the true spacing is probably unknown.</source>
        <translation>Der Voxelabstand ist 1 × 1 × 1 mm mit dem Ursprung bei 0 und ohne Drehung: Der wahre Abstand ist vermutlich unbekannt.</translation>
    </message>
    <message>
        <source>Spacing, origin and directions are the file&apos;s own, in LPS.</source>
        <translation>Abstand, Ursprung und Richtungen sind die der Datei, in LPS.</translation>
    </message>
    <message>
        <source>Stitching</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Stitching would need %1, and the limit is %2; choose a coarser spacing, or check whether one of the volumes is placed far away.</source>
        <translation>Das Verbinden bräuchte %1, und die Grenze ist %2; einen gröberen Voxelabstand wählen oder prüfen, ob eines der Volumen weit entfernt liegt.</translation>
    </message>
    <message>
        <source>Stitching would need more memory than there is, and the limit is %1; choose a coarser spacing, or check whether one of the volumes is placed far away.</source>
        <translation>Das Verbinden bräuchte mehr Speicher, als es gibt, und die Grenze ist %1; einen gröberen Voxelabstand wählen oder prüfen, ob eines der Volumen weit entfernt liegt.</translation>
    </message>
    <message>
        <source>Stopped as asked.</source>
        <translation>Wie gewünscht abgebrochen.</translation>
    </message>
    <message>
        <source>Stopped as asked; nothing was changed.</source>
        <translation>Wie gewünscht abgebrochen; nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Surfaces are written as .stl or .ply, not as %1; change its ending.</source>
        <translation>Oberflächen werden als .stl oder .ply geschrieben, nicht als %1; die Endung ändern.</translation>
    </message>
    <message>
        <source>Text is burned into the pictures; check that what is left names nobody.</source>
        <translation>In die Bilder ist Text eingebrannt; prüfen, dass der verbliebene niemanden nennt.</translation>
    </message>
    <message>
        <source>The %1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>The %1 has %2 times and %3 values; give one value for each time.</source>
        <translation>Das %1 hat %2 Zeiten und %3 Werte; zu jeder Zeit einen Wert angeben.</translation>
    </message>
    <message>
        <source>The %1 has fewer than four samples at different times; gate by another signal or by the images.</source>
        <translation>Das %1 hat weniger als vier Abtastwerte zu verschiedenen Zeiten; zum Gating ein anderes Signal oder die Bilder verwenden.</translation>
    </message>
    <message>
        <source>The %1 image has no pixels.</source>
        <translation>Im %1 Bild sind keine Pixel.</translation>
    </message>
    <message>
        <source>The %1 image&apos;s rows overlap.</source>
        <translation>Die Zeilen des %1 Bildes überlappen sich.</translation>
    </message>
    <message>
        <source>The %1 is the same throughout, as of an electrode or a belt that is not connected; gate by another signal or by the images.</source>
        <translation>Das %1 ist durchgehend gleich, wie von einer Elektrode oder einem Gurt ohne Anschluss; zum Gating ein anderes Signal oder die Bilder verwenden.</translation>
    </message>
    <message>
        <source>The %1 volume has %2 echo values for %3 voxels.</source>
        <translation>Im %1 Volumen sind %2 Echowerte für %3 Voxel.</translation>
    </message>
    <message>
        <source>The %1 volume has more than 2^30 voxels; resample it to a coarser spacing first.</source>
        <translation>Im %1 Volumen sind mehr als 2^30 Voxel; zuerst auf einen gröberen Voxelabstand umrechnen.</translation>
    </message>
    <message>
        <source>The %1 volume has no voxels.</source>
        <translation>Im %1 Volumen sind keine Voxel.</translation>
    </message>
    <message>
        <source>The %1 volume holds another number of voxels than its grid says; write it anew.</source>
        <translation>Im %1 Volumen ist eine andere Zahl von Voxeln, als sein Gitter sagt; das Volumen neu schreiben.</translation>
    </message>
    <message>
        <source>The %1 volume&apos;s confidence has another size than the volume.</source>
        <translation>Die Verlässlichkeit des %1 Volumens hat eine andere Größe als das Volumen.</translation>
    </message>
    <message>
        <source>The ECG cannot gate: %1; gate by the images.</source>
        <translation>Das EKG eignet sich nicht zum Gating: %1; stattdessen die Bilder verwenden.</translation>
    </message>
    <message>
        <source>The ECG is inverted: its R peaks point downwards.</source>
        <translation>Das EKG ist invertiert: Seine R-Zacken zeigen nach unten.</translation>
    </message>
    <message>
        <source>The ECG is saturated: %1 % of it lie at its highest or lowest value; R peaks are timed by the middle of their tops.</source>
        <translation>Das EKG ist übersteuert: %1 % davon liegen am höchsten oder tiefsten Wert; als Zeit der R-Zacken gilt die Mitte ihrer Spitzen.</translation>
    </message>
    <message>
        <source>The OutputSpacing of the device set differs between axes (%1, %2, %3 mm), but voxels are cubes; choose their size yourself (--spacing).</source>
        <translation>OutputSpacing der Kalibrierung ist je Achse verschieden (%1, %2, %3 mm), Voxel sind aber Würfel; ihre Größe selbst wählen (--spacing).</translation>
    </message>
    <message>
        <source>The apex of the beams of the %1 volume is no place.</source>
        <translation>Der Scheitel der Strahlen des %1 Volumens ist kein Ort.</translation>
    </message>
    <message>
        <source>The axes are not at right angles to each other; they were kept as they are.</source>
        <translation>Die Achsen stehen nicht im rechten Winkel zueinander; sie blieben, wie sie sind.</translation>
    </message>
    <message>
        <source>The beam angles (C300/0002) are not the same on both sides (%1 degrees off); straight ahead is pi / 2 here, other readers take the middle of the table.</source>
        <translation>Die Strahlwinkel (C300/0002) sind auf beiden Seiten nicht gleich (um %1 Grad versetzt); geradeaus ist hier pi / 2, andere Leser nehmen die Mitte der Tabelle.</translation>
    </message>
    <message>
        <source>The beams were converted to voxels of %1 mm: x lateral, y away from the probe, z against x cross y, from the centre of the beams&apos; arc.</source>
        <translation>Die Strahlen wurden in Voxel von %1 mm umgewandelt: x lateral, y vom Schallkopf weg, z gegen x Kreuz y, von der Mitte des Bogens der Strahlen aus.</translation>
    </message>
    <message>
        <source>The beams were converted to voxels of %1 mm: x lateral, y away from the probe, z along x cross y, from the centre of the beams&apos; arc.</source>
        <translation>Die Strahlen wurden in Voxel von %1 mm umgewandelt: x lateral, y vom Schallkopf weg, z entlang x Kreuz y, von der Mitte des Bogens der Strahlen aus.</translation>
    </message>
    <message>
        <source>The best delay lies at the end of the range; try a larger one.</source>
        <translation>Die beste Verzögerung liegt am Ende des Bereichs; einen größeren versuchen.</translation>
    </message>
    <message>
        <source>The best of %1 turns with all shifts agrees no better than unrelated tissue does%2.</source>
        <translation>Auch die beste von %1 Drehungen mit allen Verschiebungen stimmt nicht besser überein als fremdes Gewebe%2.</translation>
    </message>
    <message>
        <source>The best pose agrees hardly better than unrelated tissue does%1.</source>
        <translation>Die beste Lage stimmt kaum besser überein als fremdes Gewebe%1.</translation>
    </message>
    <message>
        <source>The blend beside the seam must be 0 or a positive number of mm.</source>
        <translation>Die Breite des Mischens neben der Naht muss 0 oder eine positive Zahl in mm sein.</translation>
    </message>
    <message>
        <source>The blend of levels beside the seam must be 0 or a positive number of mm.</source>
        <translation>Die Breite, auf der die Pegel neben der Naht übergehen, muss 0 oder eine positive Zahl in mm sein.</translation>
    </message>
    <message>
        <source>The blocks of a join must be at least 8 voxels wide.</source>
        <translation>Die Blöcke des Zusammenfügens müssen mindestens 8 Voxel breit sein.</translation>
    </message>
    <message>
        <source>The body has no surface inside its bounds; check the parts of its recipe.</source>
        <translation>Der Körper hat in seinen Grenzen keine Oberfläche; die Teile seines Rezepts prüfen.</translation>
    </message>
    <message>
        <source>The body would be sampled at more than 500 million places; choose a larger cell size.</source>
        <translation>Der Körper würde an mehr als 500 Millionen Stellen abgetastet; eine größere Zellengröße wählen.</translation>
    </message>
    <message>
        <source>The body&apos;s bounds are empty or larger than 5 m; give the recipe parts in millimetres.</source>
        <translation>Die Grenzen des Körpers sind leer oder größer als 5 m; die Teile des Rezepts in Millimetern angeben.</translation>
    </message>
    <message>
        <source>The calibration is mirrored (a left-handed frame); it was used as it is.</source>
        <translation>Die Kalibrierung ist gespiegelt (ein linkshändiges System); sie wurde verwendet, wie sie ist.</translation>
    </message>
    <message>
        <source>The calibration&apos;s axes are up to %1 % off the right angle; they were used as they are.</source>
        <translation>Die Achsen der Kalibrierung weichen bis zu %1 % vom rechten Winkel ab; sie wurden verwendet, wie sie sind.</translation>
    </message>
    <message>
        <source>The case &apos;%1&apos; holds something the program did not foresee (%2); check its files, and please report it.</source>
        <translation>Der Fall „%1“ enthält etwas, das das Programm nicht vorgesehen hat (%2); seine Dateien prüfen und den Fehler bitte melden.</translation>
    </message>
    <message>
        <source>The case &apos;%1&apos; needs more memory than there is; close other programs or take a smaller one.</source>
        <translation>Der Fall „%1“ braucht mehr Speicher, als es gibt; andere Programme schließen oder einen kleineren nehmen.</translation>
    </message>
    <message>
        <source>The case cannot be saved to &apos;%1&apos; (%2); choose a folder you may write to, with enough space.</source>
        <translation>Der Fall lässt sich nicht in „%1“ speichern (%2); einen Ordner mit Schreibrecht und genug Platz wählen.</translation>
    </message>
    <message>
        <source>The case folder &apos;%1&apos; cannot be made (%2); choose a folder you may write to.</source>
        <translation>Der Fallordner „%1“ lässt sich nicht anlegen (%2); einen Ordner mit Schreibrecht wählen.</translation>
    </message>
    <message>
        <source>The case in &apos;%1&apos; was saved by another program since it was opened here; save it with File, Save case, which asks what to keep.</source>
        <translation>Der Fall in „%1“ wurde von einem anderen Programm gespeichert, seit er hier geöffnet wurde; über Datei, Fall speichern sichern: Dort wird gefragt, was bleiben soll.</translation>
    </message>
    <message>
        <source>The case in the folder &apos;%1&apos; is left out: %2</source>
        <translation>Der Fall im Ordner „%1“ wird ausgelassen: %2</translation>
    </message>
    <message>
        <source>The case is not saved.</source>
        <translation>Der Fall ist nicht gespeichert.</translation>
    </message>
    <message>
        <source>The case library &apos;%1&apos; cannot be opened (%2); choose another folder.</source>
        <translation>Die Fallsammlung „%1“ lässt sich nicht öffnen (%2); einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>The cells of the seam must be wider than 0 mm.</source>
        <translation>Die Zellen der Naht müssen breiter als 0 mm sein.</translation>
    </message>
    <message>
        <source>The centre of the tracker&apos;s covariance of %1 is not a number.</source>
        <translation>Die Mitte der Tracker-Kovarianz von %1 ist keine Zahl.</translation>
    </message>
    <message>
        <source>The clip fan contains a value that is not a number; give origin, angles and radii in full.</source>
        <translation>Der Fächer der Bilder enthält einen Wert, der keine Zahl ist; Spitze, Winkel und Radien vollständig angeben.</translation>
    </message>
    <message>
        <source>The clip fan ends at radius %1 px before it begins at %2 px; give a stop radius larger than the start radius.</source>
        <translation>Der Fächer der Bilder endet beim Radius %1 px, bevor er bei %2 px beginnt; einen Endradius angeben, der größer als der Anfangsradius ist.</translation>
    </message>
    <message>
        <source>The clip leaves no pixel of the frame; check the rectangle and the fan against the frame&apos;s size.</source>
        <translation>Rechteck und Fächer lassen kein Pixel des Bildes übrig; beide mit der Größe des Bildes vergleichen.</translation>
    </message>
    <message>
        <source>The clip rectangle begins at (%1, %2) px, outside the %3 x %4 px frame; give an origin inside the frame.</source>
        <translation>Das Rechteck der Bilder beginnt bei (%1, %2) px, außerhalb des Bildes von %3 × %4 px; einen Ursprung im Bild angeben.</translation>
    </message>
    <message>
        <source>The clip rectangle contains a value that is not a number; give origin and size in pixels.</source>
        <translation>Das Rechteck der Bilder enthält einen Wert, der keine Zahl ist; Ursprung und Größe in Pixeln angeben.</translation>
    </message>
    <message>
        <source>The clip rectangle has a negative size; give its width and height in pixels.</source>
        <translation>Das Rechteck der Bilder hat eine negative Größe; Breite und Höhe in Pixeln angeben.</translation>
    </message>
    <message>
        <source>The command &apos;%1&apos; of the plugin &apos;%2&apos; stopped unexpectedly (%3); please report it with the command you gave.</source>
        <translation>Der Befehl „%1“ der Erweiterung „%2“ brach unerwartet ab (%3); bitte melden und dabei den eingegebenen Befehl nennen.</translation>
    </message>
    <message>
        <source>The compressed samples of %1 are damaged; get the file again.</source>
        <translation>Die gepackten Abtastwerte von %1 sind beschädigt; die Datei neu besorgen.</translation>
    </message>
    <message>
        <source>The compressed samples of %1 break off after %2 of the %3 bytes the header promises; get the file again.</source>
        <translation>Die gepackten Abtastwerte von %1 brechen nach %2 der %3 Byte ab, die der Kopf verspricht; die Datei neu besorgen.</translation>
    </message>
    <message>
        <source>The compressed samples of %1 break off after %2 unpacked bytes; get the file again.</source>
        <translation>Die gepackten Abtastwerte von %1 brechen nach %2 ausgepackten Byte ab; die Datei neu besorgen.</translation>
    </message>
    <message>
        <source>The compressor could not be started; free some memory and try again.</source>
        <translation>Das Packen ließ sich nicht beginnen; Speicher freigeben und noch einmal versuchen.</translation>
    </message>
    <message>
        <source>The confidence in %1 lies on another grid than its volume; give the confidence made with this volume.</source>
        <translation>Die Verlässlichkeit in %1 liegt auf einem anderen Gitter als ihr Volumen; die zu diesem Volumen gemachte Verlässlichkeit angeben.</translation>
    </message>
    <message>
        <source>The confidence of a frame could not be computed; use the beam-wise estimate.</source>
        <translation>Die Verlässlichkeit eines Bildes konnte nicht berechnet werden; die strahlweise Schätzung verwenden.</translation>
    </message>
    <message>
        <source>The confidence of the %1 volume has %2 values for %3 voxels.</source>
        <translation>Die Verlässlichkeit des %1 Volumens hat %2 Werte für %3 Voxel.</translation>
    </message>
    <message>
        <source>The confidence of the %1 volume has values outside 0 to 1.</source>
        <translation>Die Verlässlichkeit des %1 Volumens hat Werte außerhalb von 0 bis 1.</translation>
    </message>
    <message>
        <source>The confidence option %1 is %2; choose %3 to %4.</source>
        <translation>Die Einstellung %1 der Verlässlichkeit ist %2; einen Wert von %3 bis %4 wählen.</translation>
    </message>
    <message>
        <source>The control grid has %1 displacements for %2 nodes; write it anew.</source>
        <translation>Das Kontrollgitter hat %1 Verschiebungen für %2 Knoten; das Gitter neu schreiben.</translation>
    </message>
    <message>
        <source>The converted picture shall have pixels of %1 x %2 mm; give a ScanConversion with square pixels.</source>
        <translation>Das umgewandelte Bild soll Pixel von %1 × %2 mm haben; eine ScanConversion mit quadratischen Pixeln angeben.</translation>
    </message>
    <message>
        <source>The converted pictures need %1 MiB of memory; convert them to fewer pixels.</source>
        <translation>Die umgewandelten Bilder brauchen %1 MiB Speicher; in weniger Pixel umwandeln.</translation>
    </message>
    <message>
        <source>The covariance of %1 %2; a covariance is symmetric and no variance is negative.</source>
        <translation>Die Kovarianz %2 (%1); eine Kovarianz ist symmetrisch, und keine Varianz ist negativ.</translation>
    </message>
    <message>
        <source>The coverage in %1 lies on another grid than its volume; give the coverage made with this volume.</source>
        <translation>Die Abdeckung in %1 liegt auf einem anderen Gitter als ihr Volumen; die zu diesem Volumen gemachte Abdeckung angeben.</translation>
    </message>
    <message>
        <source>The coverage of the %1 volume has %2 values for %3 voxels.</source>
        <translation>Die Abdeckung des %1 Volumens hat %2 Werte für %3 Voxel.</translation>
    </message>
    <message>
        <source>The decompressor could not be started; free some memory and try again.</source>
        <translation>Das Entpacken ließ sich nicht beginnen; Speicher freigeben und noch einmal versuchen.</translation>
    </message>
    <message>
        <source>The deflated data set of %1 cannot be unpacked whole; get the file again.</source>
        <translation>Der gepackte Datensatz von %1 lässt sich nicht vollständig entpacken; die Datei neu besorgen.</translation>
    </message>
    <message>
        <source>The deformation folds in %1 cells of its control grid and has no inverse; register again with a stiffer grid.</source>
        <translation>Die Verformung faltet sich in %1 Zellen ihres Kontrollgitters und hat keine Umkehrung; mit einem steiferen Gitter neu zuordnen.</translation>
    </message>
    <message>
        <source>The deformation folds in 1 cell of its control grid and has no inverse; register again with a stiffer grid.</source>
        <translation>Die Verformung faltet sich in 1 Zelle ihres Kontrollgitters und hat keine Umkehrung; mit einem steiferen Gitter neu zuordnen.</translation>
    </message>
    <message>
        <source>The deformation has another number of vectors than its lattice has nodes.</source>
        <translation>Die Verformung hat eine andere Zahl von Vektoren, als ihr Gitter Knoten hat.</translation>
    </message>
    <message>
        <source>The device set asks for the compounding %1; expected MEAN, MAXIMUM or LATEST. Correct it there, or choose the compounding yourself (--compounding).</source>
        <translation>Die Kalibrierung verlangt das Compounding %1; erwartet wird MEAN, MAXIMUM oder LATEST. Dort berichtigen oder das Compounding selbst wählen (--compounding).</translation>
    </message>
    <message>
        <source>The device set asks for the interpolation %1; expected NEAREST_NEIGHBOR or LINEAR.</source>
        <translation>Die Kalibrierung verlangt die Interpolation %1; erwartet wird NEAREST_NEIGHBOR oder LINEAR.</translation>
    </message>
    <message>
        <source>The device set says Compounding &quot;%1&quot;, as old ones do; that was taken as the latest view.</source>
        <translation>Die Kalibrierung sagt Compounding „%1“, wie alte es tun; das wurde als neueste Ansicht verstanden.</translation>
    </message>
    <message>
        <source>The device set says Compounding &quot;%1&quot;, as old ones do; that was taken as the mean of all views.</source>
        <translation>Die Kalibrierung sagt Compounding „%1“, wie alte es tun; das wurde als Mittel aller Ansichten verstanden.</translation>
    </message>
    <message>
        <source>The direction of axis %1 is not of unit length; check the file&apos;s orientation matrix.</source>
        <translation>Die Richtung der Achse %1 hat nicht die Länge 1; die Orientierungsmatrix in der Datei prüfen.</translation>
    </message>
    <message>
        <source>The direction of the beam of the %1 volume is no direction.</source>
        <translation>Die Strahlrichtung des %1 Volumens ist keine Richtung.</translation>
    </message>
    <message>
        <source>The directions of the volume&apos;s axes lie in one plane; check the file&apos;s orientation matrix.</source>
        <translation>Die Richtungen der Volumenachsen liegen in einer Ebene; die Orientierungsmatrix in der Datei prüfen.</translation>
    </message>
    <message>
        <source>The distance of pixels must be above 0 mm in x and in y.</source>
        <translation>Der Abstand der Pixel muss in x und in y über 0 mm sein.</translation>
    </message>
    <message>
        <source>The edge of the surface&apos;s cells is %1 mm; choose one from 0.01 to 100 mm.</source>
        <translation>Die Kantenlänge der Zellen der Oberfläche ist %1 mm; eine von 0,01 bis 100 mm wählen.</translation>
    </message>
    <message>
        <source>The elastic registration was cancelled.</source>
        <translation>Die elastische Registrierung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The end of %1 is missing; the %2 frames before it were read.</source>
        <translation>Das Ende von %1 fehlt; die %2 Bilder davor wurden gelesen.</translation>
    </message>
    <message>
        <source>The equalisation was stopped before it was complete.</source>
        <translation>Das Angleichen wurde abgebrochen, bevor es vollständig war.</translation>
    </message>
    <message>
        <source>The estimate was stopped before it was complete.</source>
        <translation>Das Schätzen wurde abgebrochen, bevor es vollständig war.</translation>
    </message>
    <message>
        <source>The fall-off was lengthened from %1 to %2 mm, 2.5 times the largest motion.</source>
        <translation>Das Abklingen wurde von %1 auf %2 mm verlängert, das 2,5-Fache der größten Bewegung.</translation>
    </message>
    <message>
        <source>The feather width must be 0 or a positive number of mm.</source>
        <translation>Die Breite des Auslaufens muss 0 oder eine positive Zahl in mm sein.</translation>
    </message>
    <message>
        <source>The file %1 is too large to be a probe; a probe is a small JSON text.</source>
        <translation>Die Datei %1 ist für einen Schallkopf zu groß; ein Schallkopf ist ein kurzer JSON-Text.</translation>
    </message>
    <message>
        <source>The file also holds %1 volumes over time; its still one was read.</source>
        <translation>Die Datei enthält auch %1 Volumen über die Zeit; das stehende wurde gelesen.</translation>
    </message>
    <message>
        <source>The file also holds a colour or power Doppler volume, which was left out.</source>
        <translation>Die Datei enthält auch ein Farb- oder Powerdoppler-Volumen, das weggelassen wurde.</translation>
    </message>
    <message>
        <source>The file does not rule out text burned into the pictures; check that they name nobody.</source>
        <translation>Die Datei schließt Text in den Bildern nicht aus; prüfen, dass sie niemanden nennen.</translation>
    </message>
    <message>
        <source>The file does not say that it is a recording; each slice was taken for a frame.</source>
        <translation>Die Datei sagt nicht, dass sie eine Aufnahme ist; jede Schicht wurde als ein Bild gelesen.</translation>
    </message>
    <message>
        <source>The file gives no usable times of its frames (Frame Time, Frame Time Vector), so they have none.</source>
        <translation>Die Datei nennt keine brauchbaren Zeiten ihrer Bilder (Frame Time, Frame Time Vector); sie haben deshalb keine.</translation>
    </message>
    <message>
        <source>The file gives voxel sizes but no orientation; its axes were taken for right, anterior and superior.</source>
        <translation>Die Datei nennt Voxelgrößen, aber keine Ausrichtung; ihre Achsen wurden als rechts, anterior und superior verstanden.</translation>
    </message>
    <message>
        <source>The file that keeps unsaved work (&apos;%1&apos;) is damaged; it is left where it is and nothing was reopened.</source>
        <translation>Die Datei mit ungespeicherter Arbeit („%1“) ist beschädigt; sie bleibt, wo sie ist, und nichts wurde wieder geöffnet.</translation>
    </message>
    <message>
        <source>The file&apos;s space is &quot;%1&quot;; its axes were taken for left, posterior and superior.</source>
        <translation>Der Raum der Datei (space) ist „%1“; ihre Achsen wurden als links, posterior und superior verstanden.</translation>
    </message>
    <message>
        <source>The file&apos;s space is not named; its axes were taken for left, posterior and superior.</source>
        <translation>Der Raum der Datei (space) ist nicht genannt; ihre Achsen wurden als links, posterior und superior verstanden.</translation>
    </message>
    <message>
        <source>The filling of holes was stopped before it was complete.</source>
        <translation>Das Füllen der Lücken wurde abgebrochen, bevor es vollständig war.</translation>
    </message>
    <message>
        <source>The fixed volume covers nothing as thick as three voxels of %1 mm. Where no coverage is given, black that reaches the border counts as outside: give the coverage that reconstruct wrote.</source>
        <translation>Das feste Volumen erfasst nichts, was drei Voxel zu %1 mm dick wäre. Ohne Abdeckung gilt Schwarz am Rand als außerhalb; die beim Rekonstruieren geschriebene Abdeckung angeben.</translation>
    </message>
    <message>
        <source>The fixed volume holds no echo.</source>
        <translation>Das feste Volumen enthält kein Echo.</translation>
    </message>
    <message>
        <source>The fixed volume is too thin to be registered in three dimensions: it takes three voxels of %1 mm in every direction.</source>
        <translation>Das feste Volumen ist zu dünn: In jeder Richtung braucht es drei Voxel zu %1 mm.</translation>
    </message>
    <message>
        <source>The fixed volume shows no structure: it is the same grey nearly everywhere.</source>
        <translation>Das feste Volumen zeigt keine Struktur: Es ist fast überall gleich grau.</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; cannot be written (%2); choose one you may write to.</source>
        <translation>In den Ordner „%1“ kann nicht geschrieben werden (%2); einen mit Schreibrecht wählen.</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; holds no case.json, so it is not a case; choose a case folder.</source>
        <translation>Der Ordner „%1“ enthält keine case.json und ist damit kein Fall; einen Fallordner wählen.</translation>
    </message>
    <message>
        <source>The folder of probes %1 cannot be opened: %2.</source>
        <translation>Der Ordner mit Schallköpfen %1 kann nicht geöffnet werden: %2.</translation>
    </message>
    <message>
        <source>The folder of probes %1 cannot be read: %2.</source>
        <translation>Der Ordner mit Schallköpfen %1 kann nicht gelesen werden: %2.</translation>
    </message>
    <message>
        <source>The frames differ in size; estimate the delay of frames of one size.</source>
        <translation>Die Bilder haben verschiedene Größen; die Verzögerung an Bildern einer Größe schätzen.</translation>
    </message>
    <message>
        <source>The gating was stopped before it was complete.</source>
        <translation>Das Gating wurde abgebrochen, bevor es vollständig war.</translation>
    </message>
    <message>
        <source>The grid asked for does not hold every frame at a spacing of %1 mm; use the grid of all frames together.</source>
        <translation>Das verlangte Gitter fasst mit einem Voxelabstand von %1 mm nicht jedes Bild; das Gitter aller Bilder zusammen verwenden.</translation>
    </message>
    <message>
        <source>The header has %1 field about frames after the last image, number %2; they were kept but not used.</source>
        <translation>Der Kopf hat %1 Feld über Bilder nach dem letzten, Nummer %2; es wurde behalten, aber nicht verwendet.</translation>
    </message>
    <message>
        <source>The header has %1 fields about frames after the last image, number %2; they were kept but not used.</source>
        <translation>Der Kopf hat %1 Felder über Bilder nach dem letzten, Nummer %2; sie wurden behalten, aber nicht verwendet.</translation>
    </message>
    <message>
        <source>The header of %1 breaks off before its samples; get the file again.</source>
        <translation>Der Kopf von %1 bricht vor den Abtastwerten ab; die Datei neu besorgen.</translation>
    </message>
    <message>
        <source>The header of %1 ends before it says where the samples are (ElementDataFile); get the file again.</source>
        <translation>Der Kopf von %1 endet, bevor er sagt, wo die Abtastwerte sind (ElementDataFile); die Datei neu besorgen.</translation>
    </message>
    <message>
        <source>The header of %1 promises %2 bytes of samples, but %3 are there; correct the header&apos;s sizes or export the file again.</source>
        <translation>Der Kopf von %1 verspricht %2 Byte an Abtastwerten, es sind aber %3; die Größen im Kopf berichtigen oder die Datei neu exportieren.</translation>
    </message>
    <message>
        <source>The header of %1 promises %2 frames without pixels, but describes far fewer in its %3 bytes of fields; check that the file is undamaged.</source>
        <translation>Der Kopf von %1 verspricht %2 Bilder ohne Pixel, beschreibt in seinen %3 Byte an Feldern aber weit weniger; prüfen, ob die Datei unbeschädigt ist.</translation>
    </message>
    <message>
        <source>The header of %1 promises %2 frames, but only %3 fit the memory limit; cut the recording into parts.</source>
        <translation>Der Kopf von %1 verspricht %2 Bilder, aber nur %3 passen in die Grenze des Speichers; die Aufnahme in Teile zerlegen.</translation>
    </message>
    <message>
        <source>The header of %1 promises %2 samples, but an axis may have %3 at most; check that the file is undamaged.</source>
        <translation>Der Kopf von %1 verspricht %2 Abtastwerte, eine Achse darf aber höchstens %3 haben; prüfen, ob die Datei unbeschädigt ist.</translation>
    </message>
    <message>
        <source>The header of %1 promises %2 samples, for which %3 bytes of memory would be needed, but the limit is %4; check that the file is undamaged, or cut it into parts.</source>
        <translation>Der Kopf von %1 verspricht %2 Abtastwerte, für die %3 Byte Speicher nötig wären, die Grenze ist aber %4; prüfen, ob die Datei unbeschädigt ist, oder sie in Teile zerlegen.</translation>
    </message>
    <message>
        <source>The header says nothing about %1 of %2 frames; their poses and times count as missing.</source>
        <translation>Der Kopf sagt nichts über %1 von %2 Bildern; ihre Lagen und Zeiten gelten als fehlend.</translation>
    </message>
    <message>
        <source>The header&apos;s rescaling (slope and intercept) was left out: the 8 bit levels are used as stored.</source>
        <translation>Die Umrechnung im Kopf (slope und intercept) wurde weggelassen: Die 8-Bit-Pegel gelten, wie sie gespeichert sind.</translation>
    </message>
    <message>
        <source>The image does not hold one 8-bit grey value per voxel; convert it to unsigned char first.</source>
        <translation>Das Bild hat nicht einen Grauwert von 8 Bit je Voxel; es erst in unsigned char umwandeln.</translation>
    </message>
    <message>
        <source>The image has no voxels; give one that has.</source>
        <translation>Das Bild hat keine Voxel; eines mit Voxeln angeben.</translation>
    </message>
    <message>
        <source>The image holds another number of voxels than its dimensions say; make it again.</source>
        <translation>Das Bild enthält eine andere Zahl von Voxeln, als seine Größe sagt; es neu erzeugen.</translation>
    </message>
    <message>
        <source>The image orientation %1 is not known; expected two of the letters M or U and F or N, as in MF.</source>
        <translation>Die Bildausrichtung %1 ist nicht bekannt; erwartet werden zwei der Buchstaben M oder U und F oder N, wie in MF.</translation>
    </message>
    <message>
        <source>The images agree as they lie, and no warp agrees better where it was not fitted: the displacement is left at zero (gain of correlation there %1, its error %2).</source>
        <translation>Die Bilder stimmen überein, wie sie liegen, und keine Verformung passt dort besser, wo sie nicht angepasst wurde: Die Verschiebung bleibt null (Gewinn an Korrelation dort %1, sein Fehler %2).</translation>
    </message>
    <message>
        <source>The images agree hardly better than unrelated tissue does%1.</source>
        <translation>Die Bilder stimmen kaum besser überein als fremdes Gewebe%1.</translation>
    </message>
    <message>
        <source>The images are stored in orientation %1 and were turned to MF.</source>
        <translation>Die Bilder sind in der Ausrichtung %1 gespeichert und wurden nach MF gedreht.</translation>
    </message>
    <message>
        <source>The images at voxels of %1 mm are too large to register; ask for a coarser finest level.</source>
        <translation>Die Bilder mit Voxeln zu %1 mm sind zu groß zum Zuordnen; eine gröbere feinste Stufe verlangen.</translation>
    </message>
    <message>
        <source>The images cannot gate: %1; use a recorded signal or do without gating.</source>
        <translation>Die Bilder eignen sich nicht zum Gating: %1; ein aufgezeichnetes Signal verwenden oder auf Gating verzichten.</translation>
    </message>
    <message>
        <source>The images were clipped to the fan of the device set.</source>
        <translation>Die Bilder wurden auf den Fächer der Kalibrierung beschnitten.</translation>
    </message>
    <message>
        <source>The images were clipped to the fan of the recording.</source>
        <translation>Die Bilder wurden auf den Fächer der Aufnahme beschnitten.</translation>
    </message>
    <message>
        <source>The images were clipped to the rectangle of the device set.</source>
        <translation>Die Bilder wurden auf das Rechteck der Kalibrierung beschnitten.</translation>
    </message>
    <message>
        <source>The images were clipped to the rectangle of the recording.</source>
        <translation>Die Bilder wurden auf das Rechteck der Aufnahme beschnitten.</translation>
    </message>
    <message>
        <source>The import was stopped before it was complete.</source>
        <translation>Der Import wurde abgebrochen, bevor er vollständig war.</translation>
    </message>
    <message>
        <source>The labels of %1 voxels need more memory than is allowed; choose a coarser spacing.</source>
        <translation>Die Labels von %1 Voxeln brauchen mehr Speicher als erlaubt; einen gröberen Voxelabstand wählen.</translation>
    </message>
    <message>
        <source>The landmark %1 has a coordinate that is not a number; correct or remove it.</source>
        <translation>Die Landmarke %1 hat eine Koordinate, die keine Zahl ist; berichtigen oder entfernen.</translation>
    </message>
    <message>
        <source>The largest motion must be 0 mm (no search) or above.</source>
        <translation>Die größte Bewegung muss 0 mm (keine Suche) oder größer sein.</translation>
    </message>
    <message>
        <source>The layout of Kretz files is not published by its maker; distances are as good as what is known of it.</source>
        <translation>Der Aufbau von Kretz-Dateien ist vom Hersteller nicht veröffentlicht; Abstände sind so gut wie das, was davon bekannt ist.</translation>
    </message>
    <message>
        <source>The least Jacobian must lie between 0 and 1.</source>
        <translation>Die kleinste Jacobi-Determinante muss zwischen 0 und 1 liegen.</translation>
    </message>
    <message>
        <source>The library of the plugin &apos;%1&apos; cannot be loaded (%2); install the plugin again.</source>
        <translation>Die Bibliothek der Erweiterung „%1“ lässt sich nicht laden (%2); die Erweiterung neu installieren.</translation>
    </message>
    <message>
        <source>The library of the plugin &apos;%1&apos; cannot be loaded: %2; install the plugin again.</source>
        <translation>Die Bibliothek der Erweiterung „%1“ lässt sich nicht laden: %2; die Erweiterung neu installieren.</translation>
    </message>
    <message>
        <source>The library of the plugin &apos;%1&apos; has no function %2, so it is not an EchoWeave plugin; install the plugin again or remove its folder.</source>
        <translation>Die Bibliothek der Erweiterung „%1“ hat keine Funktion %2 und ist damit keine Erweiterung von EchoWeave; die Erweiterung neu installieren oder ihren Ordner entfernen.</translation>
    </message>
    <message>
        <source>The mannequin &apos;%1&apos; is neither in the case folder nor among the program&apos;s own; put the file into the case folder or leave the field empty.</source>
        <translation>Der Übungskörper „%1“ ist weder im Fallordner noch unter denen des Programms; die Datei in den Fallordner legen oder das Feld leer lassen.</translation>
    </message>
    <message>
        <source>The matching option %1 is %2; it must be %3.</source>
        <translation>Die Einstellung %1 des Zuordnens ist %2; erwartet: %3.</translation>
    </message>
    <message>
        <source>The matrix of frame %1 from image to world contains a value that is not a finite number; check the calibration and the pose of this frame.</source>
        <translation>Die Matrix von Bild %1 vom Bild in die Welt enthält einen Wert, der keine endliche Zahl ist; die Kalibrierung und die Lage dieses Bildes prüfen.</translation>
    </message>
    <message>
        <source>The matrix of frame %1 from image to world does not end with the row 0 0 0 1; check the calibration and the pose of this frame.</source>
        <translation>Die Matrix von Bild %1 vom Bild in die Welt endet nicht mit der Zeile 0 0 0 1; die Kalibrierung und die Lage dieses Bildes prüfen.</translation>
    </message>
    <message>
        <source>The matrix of frame %1 from image to world maps the image onto a line or a point; check the calibration and the pose of this frame.</source>
        <translation>Die Matrix von Bild %1 vom Bild in die Welt bildet das Bild auf eine Linie oder einen Punkt ab; die Kalibrierung und die Lage dieses Bildes prüfen.</translation>
    </message>
    <message>
        <source>The measurement &quot;%1&quot; cannot be taken: %2; move its places or change the anatomy.</source>
        <translation>Die Messung „%1“ ist nicht möglich: %2; ihre Orte verschieben oder die Anatomie ändern.</translation>
    </message>
    <message>
        <source>The measurement was cancelled.</source>
        <translation>Die Messung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The mesh measures %1 units, so it was taken to be in metres and scaled to millimetres.</source>
        <translation>Das Netz misst %1 Einheiten; sie wurden als Meter verstanden und in Millimeter umgerechnet.</translation>
    </message>
    <message>
        <source>The mesh measures %1 units, which is no body in millimetres or metres; scale it so that its height in millimetres is right.</source>
        <translation>Das Netz misst %1 Einheiten, was weder in Millimetern noch in Metern ein Körper ist; es so skalieren, dass seine Höhe in Millimetern stimmt.</translation>
    </message>
    <message>
        <source>The motor does not move from frame to frame; check its step or its recorded values.</source>
        <translation>Der Motor bewegt sich nicht von Bild zu Bild; seine Schrittweite oder seine aufgezeichneten Werte prüfen.</translation>
    </message>
    <message>
        <source>The motor file %1 has format %2 and this program reads up to %3; use a newer version of the program.</source>
        <translation>Die Motordatei %1 hat das Format %2, und dieses Programm liest Formate bis %3; eine neuere Version des Programms verwenden.</translation>
    </message>
    <message>
        <source>The motor has %1 values and the recording %2 frames; give one value for each frame, or a step.</source>
        <translation>Der Motor hat %1 Werte und die Aufnahme %2 Bilder; zu jedem Bild einen Wert oder eine Schrittweite angeben.</translation>
    </message>
    <message>
        <source>The moving volume covers nothing as thick as three voxels of %1 mm. Where no coverage is given, black that reaches the border counts as outside: give the coverage that reconstruct wrote.</source>
        <translation>Das bewegte Volumen erfasst nichts, was drei Voxel zu %1 mm dick wäre. Ohne Abdeckung gilt Schwarz am Rand als außerhalb; die beim Rekonstruieren geschriebene Abdeckung angeben.</translation>
    </message>
    <message>
        <source>The moving volume holds another number of voxels than its grid says; write it anew.</source>
        <translation>Das bewegte Volumen enthält eine andere Zahl von Voxeln, als sein Gitter sagt; das Volumen neu schreiben.</translation>
    </message>
    <message>
        <source>The moving volume holds no echo.</source>
        <translation>Das bewegte Volumen enthält kein Echo.</translation>
    </message>
    <message>
        <source>The moving volume is too thin to be registered in three dimensions: it takes three voxels of %1 mm in every direction.</source>
        <translation>Das bewegte Volumen ist zu dünn: In jeder Richtung braucht es drei Voxel zu %1 mm.</translation>
    </message>
    <message>
        <source>The moving volume shows no structure: it is the same grey nearly everywhere.</source>
        <translation>Das bewegte Volumen zeigt keine Struktur: Es ist fast überall gleich grau.</translation>
    </message>
    <message>
        <source>The name of an output is empty; give a file name.</source>
        <translation>Der Name einer Ausgabe ist leer; einen Dateinamen angeben.</translation>
    </message>
    <message>
        <source>The number of threads is negative; give 0 for all cores or a positive number.</source>
        <translation>Die Zahl der Threads ist negativ; 0 für alle Kerne oder eine positive Zahl angeben.</translation>
    </message>
    <message>
        <source>The option %1 is %2; it must be %3.</source>
        <translation>Die Einstellung %1 ist %2; erwartet: %3.</translation>
    </message>
    <message>
        <source>The option %1 must be above 0.</source>
        <translation>Die Einstellung %1 muss über 0 sein.</translation>
    </message>
    <message>
        <source>The options of the equalisation are out of range; use cells and knots above 0.</source>
        <translation>Die Einstellungen des Angleichens liegen außerhalb ihres Bereichs; Zellen und Knoten über 0 nehmen.</translation>
    </message>
    <message>
        <source>The options of the equalisation are out of range; use cells, knots and steps above 0.</source>
        <translation>Die Einstellungen des Angleichens liegen außerhalb ihres Bereichs; Zellen, Knoten und Schritte über 0 nehmen.</translation>
    </message>
    <message>
        <source>The output &apos;%1&apos; is a link to &apos;%2&apos;, a file of another kind; name that file instead.</source>
        <translation>Die Ausgabe „%1“ ist eine Verknüpfung mit „%2“, einer Datei anderer Art; stattdessen diese nennen.</translation>
    </message>
    <message>
        <source>The output &apos;%1&apos; is also an input; give it another name.</source>
        <translation>Die Ausgabe „%1“ ist zugleich Eingabe; ihr einen anderen Namen geben.</translation>
    </message>
    <message>
        <source>The output &apos;%1&apos; is named twice; give each output its own name.</source>
        <translation>Die Ausgabe „%1“ ist zweimal genannt; jeder Ausgabe einen eigenen Namen geben.</translation>
    </message>
    <message>
        <source>The output &apos;%1&apos; must end in %2 or %3.</source>
        <translation>Die Ausgabe „%1“ muss auf %2 oder %3 enden.</translation>
    </message>
    <message>
        <source>The output &apos;%1&apos; must end in %2.</source>
        <translation>Die Ausgabe „%1“ muss auf %2 enden.</translation>
    </message>
    <message>
        <source>The output folder is missing.</source>
        <translation>Der Ausgabeordner fehlt.</translation>
    </message>
    <message>
        <source>The overlap does not hold the pose: moved by %1 along or about what holds it least, the images still agree %2 as well.</source>
        <translation>Die Überlappung hält die Lage nicht fest: Um %1 in die Richtung bewegt, in der sie am wenigsten gehalten ist, stimmen die Bilder noch zu %2 so gut überein.</translation>
    </message>
    <message>
        <source>The overlap does not hold the pose: the normal equations are singular.</source>
        <translation>Die Überlappung hält die Lage nicht fest: Die Normalgleichungen sind singulär.</translation>
    </message>
    <message>
        <source>The overlap found is too small to tell it from chance%1.</source>
        <translation>Die gefundene Überlappung ist zu klein, um Zufall auszuschließen%1.</translation>
    </message>
    <message>
        <source>The overlap is too small to register: fewer than 50 voxels are covered by both volumes.</source>
        <translation>Die Überlappung ist zu klein: Beide Volumen erfassen gemeinsam weniger als 50 Voxel.</translation>
    </message>
    <message>
        <source>The overlap is too small to tell%1.</source>
        <translation>Die Überlappung ist zu klein für ein Urteil%1.</translation>
    </message>
    <message>
        <source>The overlap shows no structure that could be followed: the normal equations are singular.</source>
        <translation>Die Überlappung zeigt keine Struktur, der sich folgen ließe: Die Normalgleichungen sind singulär.</translation>
    </message>
    <message>
        <source>The pair %1 has a centre that is not a number or a trust outside 0..1.</source>
        <translation>Das Paar %1 hat eine Mitte, die keine Zahl ist, oder ein Vertrauen außerhalb von 0..1.</translation>
    </message>
    <message>
        <source>The pairs contradict each other: no rigid transform brings more than %1 of %2 together. Pick them again.</source>
        <translation>Die Paare widersprechen sich: Keine starre Lage bringt mehr als %1 von %2 zusammen. Die Paare neu setzen.</translation>
    </message>
    <message>
        <source>The pairs leave %1 free to slide or turn.</source>
        <translation>Die Paare lassen %1 gleiten oder sich drehen.</translation>
    </message>
    <message>
        <source>The panel &apos;%1&apos; of the plugin &apos;%2&apos; could not be opened (%3); the rest of the program is not affected.</source>
        <translation>Der Bereich „%1“ der Erweiterung „%2“ ließ sich nicht öffnen (%3); das übrige Programm ist davon nicht betroffen.</translation>
    </message>
    <message>
        <source>The patient has no organ %1; its organs are %2.</source>
        <translation>Der Patient hat kein Organ %1; seine Organe sind %2.</translation>
    </message>
    <message>
        <source>The patient&apos;s truth in the cache was damaged and has been taken away; open the case again.</source>
        <translation>Die wahren Werte des Patienten im Zwischenspeicher waren beschädigt und wurden entfernt; den Fall noch einmal öffnen.</translation>
    </message>
    <message>
        <source>The pick error of landmarks must be a length above 0 mm.</source>
        <translation>Der Klickfehler der Landmarken muss eine Länge über 0 mm sein.</translation>
    </message>
    <message>
        <source>The picture has no pixels, so %1 was not written.</source>
        <translation>Das Bild hat keine Pixel; %1 wurde deshalb nicht geschrieben.</translation>
    </message>
    <message>
        <source>The pictures are stored with black as the highest value (MONOCHROME1) and were turned over.</source>
        <translation>In den Bildern ist Schwarz der höchste Wert (MONOCHROME1); sie wurden umgekehrt.</translation>
    </message>
    <message>
        <source>The pictures have no place in space: Picture counts mm from the middle of the upper left pixel, x to the right, y down, %1 x %2 mm a pixel; the file does not say on which side the probe&apos;s marker is.</source>
        <translation>Die Bilder haben keinen Ort im Raum: Picture zählt mm von der Mitte des linken oberen Pixels, x nach rechts, y nach unten, %1 × %2 mm je Pixel; die Datei sagt nicht, auf welcher Seite die Marke des Schallkopfs ist.</translation>
    </message>
    <message>
        <source>The pictures of %1 are packed in a way that is not read (transfer syntax %2); export them uncompressed, as JPEG, JPEG-LS, JPEG 2000 or RLE.</source>
        <translation>Die Bilder von %1 sind so gepackt, wie es nicht gelesen wird (Transfersyntax %2); unkomprimiert, als JPEG, JPEG-LS, JPEG 2000 oder RLE exportieren.</translation>
    </message>
    <message>
        <source>The pictures of %1 have text burned in, which may name the patient; choose a region, name the rectangles to make black, or say that the text may stay.</source>
        <translation>In die Bilder von %1 ist Text eingebrannt, der den Patienten nennen kann; eine Region wählen, die zu schwärzenden Rechtecke nennen oder angeben, dass der Text bleiben darf.</translation>
    </message>
    <message>
        <source>The pictures of this recording know the size of their pixels, but not where the probe was; say how it moved, as a motor file does.</source>
        <translation>Die Bilder dieser Aufnahme kennen die Größe ihrer Pixel, aber nicht den Ort des Schallkopfs; angeben, wie er sich bewegt hat, wie es eine Motordatei tut.</translation>
    </message>
    <message>
        <source>The pictures were cut to region %1.</source>
        <translation>Die Bilder wurden auf Region %1 zugeschnitten.</translation>
    </message>
    <message>
        <source>The pictures would need %1 bytes of memory, but the limit is %2; take fewer or smaller ones.</source>
        <translation>Die Bilder bräuchten %1 Byte Speicher, die Grenze ist aber %2; weniger oder kleinere nehmen.</translation>
    </message>
    <message>
        <source>The places in one volume are the mirror image of those in the other: left and right were confused when they were picked, or one file is mirrored.</source>
        <translation>Die Stellen im einen Volumen sind das Spiegelbild derer im anderen: Links und rechts wurden beim Setzen verwechselt, oder eine Datei ist gespiegelt.</translation>
    </message>
    <message>
        <source>The places lie on one line, so that the turn about it is free: add a pair beside the line.</source>
        <translation>Die Stellen liegen auf einer Geraden, sodass die Drehung um sie frei bleibt; ein Paar neben der Geraden setzen.</translation>
    </message>
    <message>
        <source>The plane angles (C300/0001) are not the same on both sides (%1 degrees off); straight ahead is pi / 2 here, other readers take the middle of the table.</source>
        <translation>Die Ebenenwinkel (C300/0001) sind auf beiden Seiten nicht gleich (um %1 Grad versetzt); geradeaus ist hier pi / 2, andere Leser nehmen die Mitte der Tabelle.</translation>
    </message>
    <message>
        <source>The planes are shifted against each other evenly: the axes are not at right angles and were kept as they are.</source>
        <translation>Die Ebenen sind gleichmäßig gegeneinander verschoben: Die Achsen stehen nicht im rechten Winkel und blieben, wie sie sind.</translation>
    </message>
    <message>
        <source>The planes lie unevenly, %1 mm apart at the closest; they were resampled linearly to %2 even ones.</source>
        <translation>Die Ebenen liegen ungleichmäßig, am engsten %1 mm auseinander; sie wurden linear auf %2 gleichmäßige umgerechnet.</translation>
    </message>
    <message>
        <source>The planes of %1 are not parallel or differ in size, so that they are no regular grid; import them as a sequence, which keeps the place of each, and reconstruct it.</source>
        <translation>Die Ebenen von %1 sind nicht parallel oder verschieden groß und bilden deshalb kein regelmäßiges Gitter; als Bildfolge importieren, die den Ort jeder Ebene behält, und rekonstruieren.</translation>
    </message>
    <message>
        <source>The planes of %1 are shifted sideways against each other unevenly, so that they are no regular grid; import them as a sequence, which keeps the place of each, and reconstruct it.</source>
        <translation>Die Ebenen von %1 sind ungleichmäßig seitlich gegeneinander verschoben und bilden deshalb kein regelmäßiges Gitter; als Bildfolge importieren, die den Ort jeder Ebene behält, und rekonstruieren.</translation>
    </message>
    <message>
        <source>The planes of %1 lie in one plane, so that there is no volume; export it again.</source>
        <translation>Die Ebenen von %1 liegen alle in einer Ebene, sodass es kein Volumen gibt; neu exportieren.</translation>
    </message>
    <message>
        <source>The planes of %1 lie so unevenly that a regular grid would be too large; import them as a sequence and reconstruct it.</source>
        <translation>Die Ebenen von %1 liegen so ungleichmäßig, dass ein regelmäßiges Gitter zu groß würde; als Bildfolge importieren und rekonstruieren.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; %2 was built for ABI %3, and this program has ABI %4; install the version of the plugin that belongs to this EchoWeave, or build it again.</source>
        <translation>Die Erweiterung „%1“ %2 wurde für ABI %3 gebaut, und dieses Programm hat ABI %4; die Version installieren, die zu diesem EchoWeave gehört, oder die Erweiterung neu bauen.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; could not follow a change of the case (%2); what its panel shows may be out of date.</source>
        <translation>Die Erweiterung „%1“ konnte einer Änderung des Falls nicht folgen (%2); was ihr Bereich zeigt, kann veraltet sein.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; could not follow the scan (%2); what it shows may be out of date.</source>
        <translation>Die Erweiterung „%1“ konnte dem Scan nicht folgen (%2); was sie zeigt, kann veraltet sein.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; could not move the probe (%2); press Escape to take the probe back.</source>
        <translation>Die Erweiterung „%1“ konnte den Schallkopf nicht bewegen (%2); Esc nimmt ihn zurück.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; could not redo the step (%2); save under another name before you go on.</source>
        <translation>Die Erweiterung „%1“ konnte den Schritt nicht wiederholen (%2); vor dem Weiterarbeiten unter einem anderen Namen speichern.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; could not save (%2); try another name or folder.</source>
        <translation>Die Erweiterung „%1“ konnte nicht speichern (%2); einen anderen Namen oder Ordner versuchen.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; could not say what it still holds (%2); save your work before you close the window.</source>
        <translation>Die Erweiterung „%1“ konnte nicht sagen, was sie noch enthält (%2); vor dem Schließen des Fensters die Arbeit speichern.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; could not say what its panel holds (%2); save under another name before you go on.</source>
        <translation>Die Erweiterung „%1“ konnte nicht sagen, was ihr Bereich enthält (%2); vor dem Weiterarbeiten unter einem anderen Namen speichern.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; could not start (%2); the rest of the program is not affected.</source>
        <translation>Die Erweiterung „%1“ ließ sich nicht starten (%2); das übrige Programm ist davon nicht betroffen.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; could not start and gave no reason; the log may say more.</source>
        <translation>Die Erweiterung „%1“ ließ sich nicht starten und nannte keinen Grund; das Protokoll sagt vielleicht mehr.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; could not take over the result of &apos;%2&apos; (%3); please report it with what you did.</source>
        <translation>Die Erweiterung „%1“ konnte das Ergebnis von „%2“ nicht übernehmen (%3); bitte melden und dabei die letzten Schritte nennen.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; could not undo the last step (%2); save under another name before you go on.</source>
        <translation>Die Erweiterung „%1“ konnte den letzten Schritt nicht zurücknehmen (%2); vor dem Weiterarbeiten unter einem anderen Namen speichern.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; did not end in order (%2); nothing of your work is affected.</source>
        <translation>Die Erweiterung „%1“ endete nicht ordentlich (%2); die Arbeit ist davon nicht betroffen.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; failed (%2).</source>
        <translation>Die Erweiterung „%1“ ist fehlgeschlagen (%2).</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; is not running any more; start the program again.</source>
        <translation>Die Erweiterung „%1“ läuft nicht mehr; das Programm neu starten.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; met a problem that it did not foresee (%2); save your work, and please report it with what you did.</source>
        <translation>Die Erweiterung „%1“ stieß auf ein unvorhergesehenes Problem (%2); die Arbeit speichern, das Problem bitte melden und dabei die letzten Schritte nennen.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; names the library &apos;%2&apos;, which is not in its folder; install the plugin again.</source>
        <translation>Die Erweiterung „%1“ nennt die Bibliothek „%2“, die nicht in ihrem Ordner ist; die Erweiterung neu installieren.</translation>
    </message>
    <message>
        <source>The plugin folder &apos;%1&apos; holds no %2; install the plugin again or remove the folder.</source>
        <translation>Der Ordner „%1“ einer Erweiterung enthält keine %2; die Erweiterung neu installieren oder den Ordner entfernen.</translation>
    </message>
    <message>
        <source>The plugin of this work is not running any more.</source>
        <translation>Die Erweiterung dieser Arbeit läuft nicht mehr.</translation>
    </message>
    <message>
        <source>The pose is not a rotation with a translation: %1. Give 16 numbers, row by row, with orthonormal axes and a last row of 0 0 0 1.</source>
        <translation>Die Lage ist keine Drehung mit Verschiebung: %1. 16 Zahlen angeben, Zeile für Zeile, mit orthonormalen Achsen und der letzten Zeile 0 0 0 1.</translation>
    </message>
    <message>
        <source>The pose of %1 cannot be used: %2</source>
        <translation>Die Lage von %1 ist nicht zu gebrauchen: %2</translation>
    </message>
    <message>
        <source>The poses were not solved, as asked.</source>
        <translation>Die Optimierung der Lagen wurde wie gewünscht abgebrochen.</translation>
    </message>
    <message>
        <source>The poses were worked out from the motor&apos;s values, not from a tracker.</source>
        <translation>Die Lagen wurden aus den Werten des Motors berechnet, nicht von einem Tracker gemessen.</translation>
    </message>
    <message>
        <source>The prepared volume could not be kept for the next start; set ECHOWEAVE_CACHE to a folder you may write to. %1</source>
        <translation>Das vorbereitete Volumen ließ sich nicht für den nächsten Start aufheben; ECHOWEAVE_CACHE auf einen Ordner mit Schreibrecht setzen. %1</translation>
    </message>
    <message>
        <source>The prepared volume in the cache could not be used and was made again. %1</source>
        <translation>Das vorbereitete Volumen im Zwischenspeicher war nicht zu gebrauchen und wurde neu gemacht. %1</translation>
    </message>
    <message>
        <source>The prepared volume in the cache was damaged and was made again.</source>
        <translation>Das vorbereitete Volumen im Zwischenspeicher war beschädigt und wurde neu gemacht.</translation>
    </message>
    <message>
        <source>The probe &apos;%1&apos; is none of this case; choose one that it names.</source>
        <translation>Der Schallkopf „%1“ gehört nicht zu diesem Fall; einen wählen, den er nennt.</translation>
    </message>
    <message>
        <source>The probe file %1 cannot be read: %2.</source>
        <translation>Die Schallkopfdatei %1 kann nicht gelesen werden: %2.</translation>
    </message>
    <message>
        <source>The probe file %1 cannot be read; check its permissions.</source>
        <translation>Die Schallkopfdatei %1 kann nicht gelesen werden; ihre Zugriffsrechte prüfen.</translation>
    </message>
    <message>
        <source>The probe file %1 has format %2, this program reads up to %3; update EchoWeave.</source>
        <translation>Die Schallkopfdatei %1 hat das Format %2, dieses Programm liest Formate bis %3; EchoWeave aktualisieren.</translation>
    </message>
    <message>
        <source>The probe file %1 is not a JSON object; compare it with a shipped probe.</source>
        <translation>Die Schallkopfdatei %1 ist kein JSON-Objekt; sie mit einem mitgelieferten Schallkopf vergleichen.</translation>
    </message>
    <message>
        <source>The probe has no place; hold it on the body and measure again.</source>
        <translation>Der Schallkopf hat keine Lage; ihn an den Körper halten und erneut messen.</translation>
    </message>
    <message>
        <source>The probe moves to and fro so regularly that several delays fit; use a sweep with uneven movement.</source>
        <translation>Der Schallkopf bewegt sich so regelmäßig hin und her, dass mehrere Verzögerungen passen; einen Schwenk mit ungleichmäßiger Bewegung verwenden.</translation>
    </message>
    <message>
        <source>The probe moves too evenly, or has too few poses: no change of speed can be found again in the images.</source>
        <translation>Der Schallkopf bewegt sich zu gleichmäßig oder hat zu wenige Lagen: Keine Änderung der Geschwindigkeit ist in den Bildern wiederzufinden.</translation>
    </message>
    <message>
        <source>The probe sees too little of the volume to compare; slide it over the volume and measure again.</source>
        <translation>Der Schallkopf sieht zu wenig vom Volumen, um zu vergleichen; ihn über das Volumen schieben und erneut messen.</translation>
    </message>
    <message>
        <source>The program&apos;s folder &apos;%1&apos; was not found beside the program; install EchoWeave again or set ECHOWEAVE_RESOURCES to its resources folder.</source>
        <translation>Der Ordner „%1“ des Programms wurde neben dem Programm nicht gefunden; EchoWeave neu installieren oder ECHOWEAVE_RESOURCES auf seinen Ordner resources setzen.</translation>
    </message>
    <message>
        <source>The project file is missing.</source>
        <translation>Die Projektdatei fehlt.</translation>
    </message>
    <message>
        <source>The project has no volume yet; add one before it is saved.</source>
        <translation>Das Projekt hat noch kein Volumen; vor dem Speichern eines hinzufügen.</translation>
    </message>
    <message>
        <source>The reconstruction of &apos;%1&apos; is not there.</source>
        <translation>Die Rekonstruktion von „%1“ ist nicht da.</translation>
    </message>
    <message>
        <source>The reconstruction of &apos;%1&apos; was damaged.</source>
        <translation>Die Rekonstruktion von „%1“ war beschädigt.</translation>
    </message>
    <message>
        <source>The reconstruction was stopped before it was complete.</source>
        <translation>Die Rekonstruktion wurde abgebrochen, bevor sie vollständig war.</translation>
    </message>
    <message>
        <source>The recorded places were taken as they are.</source>
        <translation>Die aufgezeichneten Lagen wurden übernommen, wie sie sind.</translation>
    </message>
    <message>
        <source>The recording &apos;%1&apos; has format %2, this program reads up to %3; update EchoWeave.</source>
        <translation>Die Aufzeichnung „%1“ hat das Format %2, dieses Programm liest Formate bis %3; EchoWeave aktualisieren.</translation>
    </message>
    <message>
        <source>The recording &apos;%1&apos; has something else in %2 than %3.</source>
        <translation>Die Aufzeichnung „%1“ enthält in %2 nicht das Erwartete: %3.</translation>
    </message>
    <message>
        <source>The recording &apos;%1&apos; holds no image; record the scan again.</source>
        <translation>Die Aufzeichnung „%1“ enthält kein Bild; die Untersuchung neu aufzeichnen.</translation>
    </message>
    <message>
        <source>The recording &apos;%1&apos; is no longer the one that the volume was made from; make the volume again to see its frames.</source>
        <translation>Die Aufnahme „%1“ ist nicht mehr die, aus der das Volumen gemacht wurde; das Volumen neu machen, um seine Bilder zu sehen.</translation>
    </message>
    <message>
        <source>The recording and the device set both say %1 to %2; the device set was used.</source>
        <translation>Aufnahme und Kalibrierung nennen beide %1 zu %2; verwendet wurde die Kalibrierung.</translation>
    </message>
    <message>
        <source>The recording cannot be written to &apos;%1&apos; (%2); choose another folder.</source>
        <translation>Die Aufnahme lässt sich nicht in „%1“ schreiben (%2); einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>The recording carries no field %1; gate by another signal or by the images.</source>
        <translation>Die Aufnahme enthält kein Feld %1; zum Gating ein anderes Signal oder die Bilder verwenden.</translation>
    </message>
    <message>
        <source>The recording does not name its image orientation; MF (marker side first, far side last) was assumed.</source>
        <translation>Die Aufnahme nennt die Ausrichtung ihrer Bilder nicht; MF (Markenseite zuerst, ferne Seite zuletzt) wurde angenommen.</translation>
    </message>
    <message>
        <source>The recording has &quot;%1&quot; for its field %2; expected %3, or describe the motor in a file.</source>
        <translation>Die Aufnahme hat „%1“ im Feld %2 (erwartet: %3); das Feld berichtigen oder den Motor in einer Datei beschreiben.</translation>
    </message>
    <message>
        <source>The recording has %1 scan lines of %2 samples; a picture needs at least 2 of each.</source>
        <translation>Die Aufnahme hat %1 Bildzeilen mit %2 Abtastwerten; ein Bild braucht von beiden mindestens 2.</translation>
    </message>
    <message>
        <source>The recording has no frames, so %1 was not written; record or open one first.</source>
        <translation>Die Aufnahme hat keine Bilder; %1 wurde deshalb nicht geschrieben; erst eine aufnehmen oder öffnen.</translation>
    </message>
    <message>
        <source>The recording has nothing for its field %1; expected %2, or describe the motor in a file.</source>
        <translation>Die Aufnahme hat nichts im Feld %1 (erwartet: %2); das Feld ergänzen oder den Motor in einer Datei beschreiben.</translation>
    </message>
    <message>
        <source>The recording has poses but no images.</source>
        <translation>Die Aufnahme hat Lagen, aber keine Bilder.</translation>
    </message>
    <message>
        <source>The recording holds %1 data, no brightness. EchoWeave does not read radio frequency lines: record again with B-mode images, or have the program that recorded it make them (in PLUS the RfProcessing of the device set).</source>
        <translation>Die Aufnahme enthält %1-Daten statt Helligkeit. EchoWeave liest keine Hochfrequenzzeilen: erneut mit B-Mode-Bildern aufnehmen oder sie von dem Programm erzeugen lassen, das aufgenommen hat (in PLUS mit RfProcessing in der Kalibrierung).</translation>
    </message>
    <message>
        <source>The recording holds images of orientation &quot;%1&quot;, no scan lines.</source>
        <translation>Die Aufnahme enthält Bilder der Ausrichtung „%1“, keine Bildzeilen.</translation>
    </message>
    <message>
        <source>The recording holds no image, so &apos;%1&apos; was not written; scan while it runs.</source>
        <translation>Die Aufzeichnung enthält kein Bild, deshalb wurde „%1“ nicht geschrieben; schallen, während sie läuft.</translation>
    </message>
    <message>
        <source>The recording holds poses but no images, so there is nothing to reconstruct; choose the recording with the images.</source>
        <translation>Die Aufnahme enthält Lagen, aber keine Bilder, es gibt also nichts zu rekonstruieren; die Aufnahme mit den Bildern wählen.</translation>
    </message>
    <message>
        <source>The recording holds scan lines and does not say their %1; give a device set whose ScanConversion says it with %2.</source>
        <translation>Die Aufnahme enthält Bildzeilen und nennt %1 nicht; eine Kalibrierung angeben, deren ScanConversion dafür %2 nennt.</translation>
    </message>
    <message>
        <source>The recording holds scan lines and does not say where they lie; give a device set whose ScanConversion has TransducerGeometry=&quot;CURVILINEAR&quot; or &quot;LINEAR&quot;.</source>
        <translation>Die Aufnahme enthält Bildzeilen und sagt nicht, wo sie liegen; eine Kalibrierung angeben, deren ScanConversion TransducerGeometry=&quot;CURVILINEAR&quot; oder &quot;LINEAR&quot; hat.</translation>
    </message>
    <message>
        <source>The recording holds scan lines; they were converted to images of %1 x %2 pixels of %3 mm.</source>
        <translation>Die Aufnahme enthält Bildzeilen; sie wurden in Bilder von %1 × %2 Pixeln zu %3 mm umgewandelt.</translation>
    </message>
    <message>
        <source>The recording&apos;s %1 is &quot;%2&quot;; expected %3 numbers.</source>
        <translation>%1 der Aufnahme ist „%2“; erwartet werden %3 Zahlen.</translation>
    </message>
    <message>
        <source>The recording&apos;s %1 is &quot;%2&quot;; expected 1 number.</source>
        <translation>%1 der Aufnahme ist „%2“; erwartet wird 1 Zahl.</translation>
    </message>
    <message>
        <source>The recording&apos;s pixels do not match its size, so %1 was not written.</source>
        <translation>Die Pixel der Aufnahme passen nicht zu ihrer Größe; %1 wurde deshalb nicht geschrieben.</translation>
    </message>
    <message>
        <source>The region counts its own mm from pixel (%1, %2) of the cut picture, where x is %3 and y is %4.</source>
        <translation>Die Region zählt eigene mm ab Pixel (%1, %2) des zugeschnittenen Bildes, wo x gleich %3 und y gleich %4 ist.</translation>
    </message>
    <message>
        <source>The registration option %1 is %2; it must be %3.</source>
        <translation>Die Einstellung %1 der Registrierung ist %2; erwartet: %3.</translation>
    </message>
    <message>
        <source>The registration was cancelled.</source>
        <translation>Das Zuordnen wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The respiration signal cannot gate: %1; gate by the images.</source>
        <translation>Das Atemsignal eignet sich nicht zum Gating: %1; stattdessen die Bilder verwenden.</translation>
    </message>
    <message>
        <source>The result of &apos;%1&apos; could not be taken over (%2); please report it with what you did.</source>
        <translation>Das Ergebnis von „%1“ ließ sich nicht übernehmen (%2); bitte melden und dabei die letzten Schritte nennen.</translation>
    </message>
    <message>
        <source>The samples are %1 and all have the value %2; they became 0.</source>
        <translation>Die Abtastwerte haben %1 und alle den Wert %2; sie wurden zu 0.</translation>
    </message>
    <message>
        <source>The samples are %1: values from %2 to %3 were mapped to 0 to 255.</source>
        <translation>Die Abtastwerte haben %1: Werte von %2 bis %3 wurden auf 0 bis 255 abgebildet.</translation>
    </message>
    <message>
        <source>The samples are colours; their luminance became the echo level.</source>
        <translation>Die Abtastwerte sind Farben; ihre Helligkeit wurde zum Echopegel.</translation>
    </message>
    <message>
        <source>The samples have %1 bits with sign: values from %2 to %3 were mapped to 0 to 255.</source>
        <translation>Die Abtastwerte haben %1 Bit mit Vorzeichen: Werte von %2 bis %3 wurden auf 0 bis 255 abgebildet.</translation>
    </message>
    <message>
        <source>The samples have %1 bits: values from %2 to %3 were mapped to 0 to 255.</source>
        <translation>Die Abtastwerte haben %1 Bit: Werte von %2 bis %3 wurden auf 0 bis 255 abgebildet.</translation>
    </message>
    <message>
        <source>The samples lie as far below 0 as above, as those of radio frequency (RF) lines do; if they are, the grey levels made of them are no brightness: export the B-mode volume instead.</source>
        <translation>Die Abtastwerte reichen so weit unter 0 wie darüber, wie bei Hochfrequenzzeilen (RF); sind es solche, sind die Grauwerte daraus keine Helligkeit: dann stattdessen das B-Mode-Volumen exportieren.</translation>
    </message>
    <message>
        <source>The scan lines are %1, no brightness; convert them to B-mode brightness first.</source>
        <translation>Die Bildzeilen sind %1 statt Helligkeit; sie zuerst in B-Mode-Helligkeit umwandeln.</translation>
    </message>
    <message>
        <source>The scan lines run from %1 to %2 degrees; only sectors as wide to the left as to the right, from minus to plus, are converted.</source>
        <translation>Die Bildzeilen reichen von %1 bis %2 Grad; umgewandelt werden nur Sektoren, die nach links so weit reichen wie nach rechts, von Minus nach Plus.</translation>
    </message>
    <message>
        <source>The scan lines&apos; %1 is &quot;%2&quot;; give a device set whose ScanConversion says it with %3.</source>
        <translation>%1 der Bildzeilen ist „%2“; eine Kalibrierung angeben, deren ScanConversion dafür %3 nennt.</translation>
    </message>
    <message>
        <source>The scan lines&apos; TransducerGeometry is &quot;%1&quot;; give a device set whose ScanConversion has TransducerGeometry=&quot;CURVILINEAR&quot; or &quot;LINEAR&quot;.</source>
        <translation>TransducerGeometry der Bildzeilen ist „%1“; eine Kalibrierung angeben, deren ScanConversion TransducerGeometry=&quot;CURVILINEAR&quot; oder &quot;LINEAR&quot; hat.</translation>
    </message>
    <message>
        <source>The seams have levels of other volumes; find them again.</source>
        <translation>Die Nähte haben Pegel anderer Volumen; die Nähte neu suchen.</translation>
    </message>
    <message>
        <source>The seams name more volumes than there are; find them again.</source>
        <translation>Die Nähte nennen mehr Volumen, als es gibt; die Nähte neu suchen.</translation>
    </message>
    <message>
        <source>The seams were found for another grid; find them again for this one.</source>
        <translation>Die Nähte wurden für ein anderes Gitter gefunden; die Nähte für dieses neu suchen.</translation>
    </message>
    <message>
        <source>The section &apos;%1&apos; of a case belongs to another plugin; take another name.</source>
        <translation>Der Abschnitt „%1“ eines Falls gehört zu einer anderen Erweiterung; einen anderen Namen nehmen.</translation>
    </message>
    <message>
        <source>The section &apos;%1&apos; of a case has no schema; add it first.</source>
        <translation>Der Abschnitt „%1“ eines Falls hat kein Schema; es zuerst hinzufügen.</translation>
    </message>
    <message>
        <source>The size of a pixel must be above 0 mm in both directions.</source>
        <translation>Die Größe eines Pixels muss in beiden Richtungen über 0 mm sein.</translation>
    </message>
    <message>
        <source>The size of a pixel was given: %1 x %2 mm instead of the %3 x %4 mm of the region.</source>
        <translation>Die Größe eines Pixels wurde angegeben: %1 × %2 mm statt der %3 × %4 mm der Region.</translation>
    </message>
    <message>
        <source>The solution did not settle; allow more iterations.</source>
        <translation>Die Optimierung der Lagen konvergierte nicht; mehr Durchgänge zulassen.</translation>
    </message>
    <message>
        <source>The solver of poses failed (%1).</source>
        <translation>Die Optimierung der Lagen ist fehlgeschlagen (%1).</translation>
    </message>
    <message>
        <source>The sources of the voxels do not fit the grid; give one for each voxel.</source>
        <translation>Die Quellbilder der Voxel passen nicht zum Gitter; für jeden Voxel eines angeben.</translation>
    </message>
    <message>
        <source>The spacing must be above 0 mm along every axis.</source>
        <translation>Der Abstand muss entlang jeder Achse über 0 mm sein.</translation>
    </message>
    <message>
        <source>The spacing must lie between 0.001 and 1000 mm.</source>
        <translation>Der Abstand muss zwischen 0,001 und 1000 mm liegen.</translation>
    </message>
    <message>
        <source>The spacing of raw samples is not in the file; give it in mm, above 0.</source>
        <translation>Der Abstand roher Abtastwerte steht nicht in der Datei; ihn in mm angeben, über 0.</translation>
    </message>
    <message>
        <source>The spacing of the result must be a positive number of mm, or 0 for the finest of the inputs.</source>
        <translation>Der Voxelabstand des Ergebnisses muss eine positive Zahl in mm sein, oder 0 für den feinsten der Eingaben.</translation>
    </message>
    <message>
        <source>The spacing was given and replaces that of the file; origin and directions are the file&apos;s.</source>
        <translation>Der Abstand wurde angegeben und ersetzt den der Datei; Ursprung und Richtungen sind die der Datei.</translation>
    </message>
    <message>
        <source>The step %1 would need %2 MiB of memory, more than the %3 MiB allowed; use a coarser spacing_mm or fewer volumes at a time.</source>
        <translation>Der Schritt „%1“ bräuchte %2 MiB Speicher, mehr als die erlaubten %3 MiB; einen gröberen Voxelabstand (spacing_mm) oder weniger Volumen auf einmal nehmen.</translation>
    </message>
    <message>
        <source>The stiffness must be 0 (automatic) or above.</source>
        <translation>Die Steifigkeit muss 0 (automatisch) oder größer sein.</translation>
    </message>
    <message>
        <source>The stitch project</source>
        <translation>Das Stitching-Projekt</translation>
    </message>
    <message>
        <source>The stitch project has format %1, and this program reads formats up to %2; open it with a newer EchoWeave.</source>
        <translation>Das Stitching-Projekt hat das Format %1, und dieses Programm liest Formate bis %2; mit einem neueren EchoWeave öffnen.</translation>
    </message>
    <message>
        <source>The stitch project has no volumes; add some.</source>
        <translation>Das Stitching-Projekt hat keine Volumen; welche hinzufügen.</translation>
    </message>
    <message>
        <source>The stitching was cancelled.</source>
        <translation>Das Verbinden wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The stitching was cancelled; what was finished is kept.</source>
        <translation>Das Verbinden wurde abgebrochen; was fertig war, bleibt erhalten.</translation>
    </message>
    <message>
        <source>The surface of %1 has too many parts with edges of %2 mm; choose longer ones.</source>
        <translation>Die Oberfläche von %1 hat bei Kanten von %2 mm zu viele Teile; längere wählen.</translation>
    </message>
    <message>
        <source>The sweep &apos;%1&apos; asks for the probe &apos;%2&apos;, which the program does not have; name one of resources/probes.</source>
        <translation>Der Schwenk „%1“ verlangt den Schallkopf „%2“, den das Programm nicht hat; einen aus resources/probes nennen.</translation>
    </message>
    <message>
        <source>The sweep asks for a depth of %1 mm, but %2 sees from %3 to %4 mm; change machine.depth_mm or the probe.</source>
        <translation>Der Schwenk verlangt eine Tiefe von %1 mm, %2 sieht aber von %3 bis %4 mm; machine.depth_mm oder den Schallkopf ändern.</translation>
    </message>
    <message>
        <source>The sweep asks for breath, pulse or their signals, but this patient&apos;s recipe describes no motion; switch breathing, pulsating, ecg and respiration off or describe the motion.</source>
        <translation>Der Schwenk verlangt Atmung, Puls oder deren Signale, das Rezept dieses Patienten beschreibt aber keine Bewegung; breathing, pulsating, ecg und respiration ausschalten oder die Bewegung beschreiben.</translation>
    </message>
    <message>
        <source>The sweep has %1 stations, but a motor starts from one; give one station, or make the sweep freehand.</source>
        <translation>Der Schwenk hat %1 Stationen, ein Motor geht aber von einer aus; eine Station angeben oder den Schwenk freihändig führen.</translation>
    </message>
    <message>
        <source>The sweep has no frame with a usable pose; check the tracking of the recording.</source>
        <translation>Der Schwenk hat kein Bild mit brauchbarer Lage; den Tracker der Aufnahme prüfen.</translation>
    </message>
    <message>
        <source>The sweep has no frames or no frame rate; give at least one frame and a rate above 0.</source>
        <translation>Der Schwenk hat keine Bilder oder keine Bildrate; mindestens ein Bild und eine Rate über 0 angeben.</translation>
    </message>
    <message>
        <source>The sweep has no station; say at least one point near the skin where the probe is put.</source>
        <translation>Der Schwenk hat keine Station; mindestens einen Punkt nahe der Haut angeben, auf den der Schallkopf gesetzt wird.</translation>
    </message>
    <message>
        <source>The sweep has too few frames at different times to compare movements.</source>
        <translation>Der Schwenk hat zu wenige Bilder zu verschiedenen Zeiten, um Bewegungen zu vergleichen.</translation>
    </message>
    <message>
        <source>The sweep presses the probe %1 mm into the skin, but %2 can press %3 mm at most; use a smaller indentation_mm.</source>
        <translation>Der Schwenk drückt den Schallkopf %1 mm in die Haut, %2 kann aber höchstens %3 mm drücken; ein kleineres indentation_mm nehmen.</translation>
    </message>
    <message>
        <source>The sweep would become %1 x %2 x %3 voxels and need %4 MiB, more than the %5 MiB allowed; give a coarser spacing_mm.</source>
        <translation>Aus dem Schwenk würden %1 × %2 × %3 Voxel, und er bräuchte %4 MiB, mehr als die erlaubten %5 MiB; ein gröberes spacing_mm angeben.</translation>
    </message>
    <message>
        <source>The sweep&apos;s %1 %2; %3.</source>
        <translation>%1 des Schwenks %2; %3.</translation>
    </message>
    <message>
        <source>The system has no room for another thread; close other programs and try again.</source>
        <translation>Das System hat keinen Platz für einen weiteren Thread; andere Programme schließen und noch einmal versuchen.</translation>
    </message>
    <message>
        <source>The tangent plane cuts nothing that both volumes cover: move it into their overlap.</source>
        <translation>Die Tangentialebene schneidet nichts, was beide Volumen erfassen; sie in die Überlappung verschieben.</translation>
    </message>
    <message>
        <source>The tangent plane needs a normal with a direction; this one has none.</source>
        <translation>Die Tangentialebene braucht eine Normale mit einer Richtung; diese hat keine.</translation>
    </message>
    <message>
        <source>The tangent plane&apos;s point is not a number.</source>
        <translation>Der Punkt der Tangentialebene ist keine Zahl.</translation>
    </message>
    <message>
        <source>The three pairs contradict each other by %1, and three cannot say which of them is wrong: correct one or add a fourth.</source>
        <translation>Die drei Paare widersprechen sich um %1, und drei können nicht sagen, welches falsch ist; eines berichtigen oder ein viertes setzen.</translation>
    </message>
    <message>
        <source>The times of the %1 go from %2 s to %3 s, which is longer than a day; correct the recording&apos;s times.</source>
        <translation>Die Zeiten im %1 reichen von %2 s bis %3 s, länger als einen Tag; die Zeiten der Aufnahme berichtigen.</translation>
    </message>
    <message>
        <source>The transform in &apos;%1&apos; cannot be used. %2</source>
        <translation>Die Transformation in „%1“ ist nicht zu gebrauchen. %2</translation>
    </message>
    <message>
        <source>The transform of the pair %1 cannot be used: %2</source>
        <translation>Die Transformation des Paares %1 ist nicht zu gebrauchen: %2</translation>
    </message>
    <message>
        <source>The triangles faced inwards and were turned.</source>
        <translation>Die Dreiecke zeigten nach innen und wurden umgedreht.</translation>
    </message>
    <message>
        <source>The two images show almost nothing in common places: check how they lie to each other.</source>
        <translation>Die beiden Bilder zeigen an gemeinsamen Stellen fast nichts; prüfen, wie sie zueinander liegen.</translation>
    </message>
    <message>
        <source>The two volumes do not overlap at the start: bring them closer, or match without a start.</source>
        <translation>Am Anfang überlappen sich die beiden Volumen nicht; sie näher zusammenbringen oder ohne Anfangslage suchen.</translation>
    </message>
    <message>
        <source>The virtual scanner&apos;s %1 is %2; choose one from %3 to %4.</source>
        <translation>%1 des virtuellen Geräts ist %2; einen Wert von %3 bis %4 wählen.</translation>
    </message>
    <message>
        <source>The volume cannot be kept in bricks: %1 MiB of memory are not to be had.</source>
        <translation>Das Volumen lässt sich nicht in Blöcken halten: %1 MiB Speicher sind nicht zu bekommen.</translation>
    </message>
    <message>
        <source>The volume has %1 bytes of voxels, but its grid %2; it was not written.</source>
        <translation>Das Volumen hat %1 Byte an Voxeln, sein Gitter aber %2; es wurde nicht geschrieben.</translation>
    </message>
    <message>
        <source>The volume has more voxels than can be handled; use a coarser spacing.</source>
        <translation>Das Volumen hat mehr Voxel, als sich verarbeiten lassen; einen gröberen Voxelabstand nehmen.</translation>
    </message>
    <message>
        <source>The volume has no voxels along axis %1; check the file&apos;s dimensions.</source>
        <translation>Das Volumen hat entlang der Achse %1 keine Voxel; die Größe in der Datei prüfen.</translation>
    </message>
    <message>
        <source>The volume is Cartesian already, %1 mm in every direction; its origin is its first voxel, and which way it lies in the patient is not in the file.</source>
        <translation>Das Volumen ist schon kartesisch, %1 mm in jeder Richtung; sein Ursprung ist sein erster Voxel, und wie es im Patienten liegt, steht nicht in der Datei.</translation>
    </message>
    <message>
        <source>The poses of the images are those in the recording&apos;s frame %1.</source>
        <translation>Die Posen der Bilder sind die im Bezugssystem %1 der Aufnahme.</translation>
    </message>
    <message>
        <source>The volume needs at least one sample along each axis; give its dimensions.</source>
        <translation>Das Volumen braucht mindestens einen Abtastwert entlang jeder Achse; die Größe angeben.</translation>
    </message>
    <message>
        <source>The volume would have %1 voxels and need %2 of memory, more than the %3 that a volume may take; use a coarser spacing.</source>
        <translation>Das Volumen hätte %1 Voxel und bräuchte %2 Speicher, mehr als die %3, die ein Volumen belegen darf; einen gröberen Voxelabstand nehmen.</translation>
    </message>
    <message>
        <source>The volume would have %1 voxels and need more than 2048 GiB of memory; use a coarser spacing.</source>
        <translation>Das Volumen hätte %1 Voxel und bräuchte mehr als 2048 GiB Speicher; einen gröberen Voxelabstand nehmen.</translation>
    </message>
    <message>
        <source>The volume would have %1 voxels, more than %2 along one axis; use a coarser spacing, or check the calibration and poses for a wrong scale.</source>
        <translation>Das Volumen hätte %1 Voxel, mehr als %2 entlang einer Achse; einen gröberen Voxelabstand nehmen oder Kalibrierung und Lagen auf einen falschen Maßstab prüfen.</translation>
    </message>
    <message>
        <source>The volume would have %1 x %2 x %3 voxels and need %4 of memory with the frames, more than the %5 that a volume may take; use a coarser spacing.</source>
        <translation>Das Volumen hätte %1 × %2 × %3 Voxel und bräuchte mit den Bildern %4 Speicher, mehr als die %5, die ein Volumen belegen darf; einen gröberen Voxelabstand nehmen.</translation>
    </message>
    <message>
        <source>The volume&apos;s origin is not finite; check the file&apos;s offset.</source>
        <translation>Der Ursprung des Volumens ist nicht endlich; den Offset in der Datei prüfen.</translation>
    </message>
    <message>
        <source>The volume&apos;s place is not 16 numbers, row by row; correct &apos;volume.file_to_world&apos; in case.json.</source>
        <translation>Die Lage des Volumens besteht nicht aus 16 Zahlen, Zeile für Zeile; „volume.file_to_world“ in case.json berichtigen.</translation>
    </message>
    <message>
        <source>The volume&apos;s voxels do not fit its grid; read it again.</source>
        <translation>Die Voxel des Volumens passen nicht zu seinem Gitter; das Volumen neu lesen.</translation>
    </message>
    <message>
        <source>The volumes agree: %1, %2 before.</source>
        <translation>Die Volumen stimmen überein: %1, vorher %2.</translation>
    </message>
    <message>
        <source>The volumes contradict each other: deformed, they agree no better than unrelated tissue does.</source>
        <translation>Die Volumen widersprechen sich: Auch verformt stimmen sie nicht besser überein als fremdes Gewebe.</translation>
    </message>
    <message>
        <source>The volumes contradict each other: deformed, they reach %1, which unrelated tissue reaches as well.</source>
        <translation>Die Volumen widersprechen sich: Verformt erreichen sie %1, was fremdes Gewebe ebenso erreicht.</translation>
    </message>
    <message>
        <source>The volumes do not overlap anywhere, so nothing was blended; check their places if they should.</source>
        <translation>Die Volumen überlappen sich nirgends, daher wurde nichts gemischt; ihre Lagen prüfen, falls sie es sollten.</translation>
    </message>
    <message>
        <source>The volumes do not overlap where they were placed; place them, or match them first.</source>
        <translation>Wo die Volumen liegen, überlappen sie sich nicht; sie platzieren oder zuerst zuordnen.</translation>
    </message>
    <message>
        <source>The voxel spacing along axis %1 is not a positive number; check the file&apos;s spacing.</source>
        <translation>Der Voxelabstand entlang der Achse %1 ist keine positive Zahl; den Abstand in der Datei prüfen.</translation>
    </message>
    <message>
        <source>The voxel spacing is %1 mm; choose one from 0.01 to 1000 mm.</source>
        <translation>Der Voxelabstand ist %1 mm; einen von 0,01 bis 1000 mm wählen.</translation>
    </message>
    <message>
        <source>The warp must fall off over more than 0 mm.</source>
        <translation>Die Verformung muss über mehr als 0 mm abklingen.</translation>
    </message>
    <message>
        <source>The warped image agrees with the fixed one %1.</source>
        <translation>Das verformte Bild stimmt mit dem festen überein %1.</translation>
    </message>
    <message>
        <source>The weight of interpolated voxels must be above 0 and at most 1.</source>
        <translation>Das Gewicht interpolierter Voxel muss über 0 und höchstens 1 sein.</translation>
    </message>
    <message>
        <source>The weights of a seam must be 0 or positive.</source>
        <translation>Die Gewichte einer Naht müssen 0 oder positiv sein.</translation>
    </message>
    <message>
        <source>The weights of frame %1 have %2 x %3 values for %4 x %5 pixels; give one weight for each pixel.</source>
        <translation>Die Gewichte von Bild %1 haben %2 × %3 Werte für %4 × %5 Pixel; zu jedem Pixel ein Gewicht angeben.</translation>
    </message>
    <message>
        <source>The whole picture of %1 has no size of a pixel of its own; give it in mm.</source>
        <translation>Das ganze Bild von %1 nennt keine eigene Größe eines Pixels; sie in mm angeben.</translation>
    </message>
    <message>
        <source>The work stopped unexpectedly (%1); nothing was changed, please report it with what you did.</source>
        <translation>Die Arbeit brach unerwartet ab (%1); nichts wurde geändert, bitte melden und dabei die letzten Schritte nennen.</translation>
    </message>
    <message>
        <source>There are %1 frames and %2 poses; give one pose for each frame.</source>
        <translation>Es gibt %1 Bilder und %2 Lagen; zu jedem Bild eine Lage angeben.</translation>
    </message>
    <message>
        <source>There are %1 frames and %2 times; give one time for each frame.</source>
        <translation>Es gibt %1 Bilder und %2 Zeiten; zu jedem Bild eine Zeit angeben.</translation>
    </message>
    <message>
        <source>There are %1 times and %2 poses; give one time for each frame.</source>
        <translation>Es gibt %1 Zeiten und %2 Lagen; zu jedem Bild eine Zeit angeben.</translation>
    </message>
    <message>
        <source>There are fewer than two sweeps to compare; give all sweeps that are to be stitched.</source>
        <translation>Es sind weniger als zwei Schwenks zu vergleichen; alle Schwenks angeben, die verbunden werden sollen.</translation>
    </message>
    <message>
        <source>There are no threads left to keep watch over %1; close other programs.</source>
        <translation>Es gibt keine Threads mehr, um %1 zu überwachen; andere Programme schließen.</translation>
    </message>
    <message>
        <source>There are two projects, &apos;%1&apos; and &apos;%2&apos;, and only one can be stitched.</source>
        <translation>Es sind zwei Projekte, „%1“ und „%2“, und nur eines kann verbunden werden.</translation>
    </message>
    <message>
        <source>There is no %1 at %2; check the path.</source>
        <translation>Unter %2 liegt keine Datei (%1); den Pfad prüfen.</translation>
    </message>
    <message>
        <source>There is no file %1; check its name and folder.</source>
        <translation>Es gibt keine Datei %1; Namen und Ordner prüfen.</translation>
    </message>
    <message>
        <source>There is no file %1; choose a mannequin recipe or a mesh.</source>
        <translation>Es gibt keine Datei %1; ein Rezept eines Übungskörpers oder ein Netz wählen.</translation>
    </message>
    <message>
        <source>There is no file or folder &apos;%1&apos;; check the name.</source>
        <translation>Es gibt keine Datei und keinen Ordner „%1“; den Namen prüfen.</translation>
    </message>
    <message>
        <source>There is no pair of landmarks: a turn needs three places that are not on one line.</source>
        <translation>Es gibt kein Landmarkenpaar: Eine Drehung braucht drei Stellen, die nicht auf einer Geraden liegen.</translation>
    </message>
    <message>
        <source>There is no pose; give 16 numbers, row by row, or a file with one pose a line.</source>
        <translation>Es gibt keine Lage; 16 Zahlen angeben, Zeile für Zeile, oder eine Datei mit einer Lage je Zeile.</translation>
    </message>
    <message>
        <source>There is no probe file %1; check the name.</source>
        <translation>Es gibt keine Schallkopfdatei %1; den Namen prüfen.</translation>
    </message>
    <message>
        <source>There is no subvolume to place; add at least one.</source>
        <translation>Es gibt kein Teilvolumen zu platzieren; mindestens eines hinzufügen.</translation>
    </message>
    <message>
        <source>There is no volume to measure with; open one first.</source>
        <translation>Es gibt kein Volumen, an dem sich messen ließe; erst eines öffnen.</translation>
    </message>
    <message>
        <source>There is no volume to stitch; add at least one.</source>
        <translation>Es gibt kein Volumen zu verbinden; mindestens eines hinzufügen.</translation>
    </message>
    <message>
        <source>There is no way from the pixels (frame Image) to %1: from Image only %2 can be reached, and %3 stand apart; %4.</source>
        <translation>Es führt kein Weg von den Pixeln (Bezugssystem Image) zu %1: Von Image aus ist nur %2 zu erreichen, und abseits stehen %3; %4.</translation>
    </message>
    <message>
        <source>There is no way from the pixels (frame Image) to %1: from Image only %2 can be reached; %3.</source>
        <translation>Es führt kein Weg von den Pixeln (Bezugssystem Image) zu %1: Von Image aus ist nur %2 zu erreichen; %3.</translation>
    </message>
    <message>
        <source>There is no way from the pixels (frame Image) to %1: nothing can be reached from Image, and %2 stand apart; %3.</source>
        <translation>Es führt kein Weg von den Pixeln (Bezugssystem Image) zu %1: Von Image aus ist nichts zu erreichen, und abseits stehen %2; %3.</translation>
    </message>
    <message>
        <source>There is no way from the pixels (frame Image) to %1: nothing can be reached from Image; %2.</source>
        <translation>Es führt kein Weg von den Pixeln (Bezugssystem Image) zu %1: Von Image aus ist nichts zu erreichen; %2.</translation>
    </message>
    <message>
        <source>There is not enough memory for %1; close other programs.</source>
        <translation>Für %1 reicht der Speicher nicht; andere Programme schließen.</translation>
    </message>
    <message>
        <source>There is not enough memory for %1; use a mesh with fewer triangles.</source>
        <translation>Für %1 reicht der Speicher nicht; ein Netz mit weniger Dreiecken verwenden.</translation>
    </message>
    <message>
        <source>There is not enough memory for &apos;%1&apos; of the plugin &apos;%2&apos;; close other programs or choose a coarser spacing.</source>
        <translation>Für „%1“ der Erweiterung „%2“ reicht der Speicher nicht; andere Programme schließen oder einen gröberen Voxelabstand wählen.</translation>
    </message>
    <message>
        <source>There is not enough memory for &apos;%1&apos; of the plugin &apos;%2&apos;; use a coarser spacing or a smaller input.</source>
        <translation>Für „%1“ der Erweiterung „%2“ reicht der Speicher nicht; einen gröberen Voxelabstand oder eine kleinere Eingabe nehmen.</translation>
    </message>
    <message>
        <source>There is not enough memory for a picture of %1; close other programs.</source>
        <translation>Für ein Bild von %1 reicht der Speicher nicht; andere Programme schließen.</translation>
    </message>
    <message>
        <source>There is not enough memory for a volume of %1; use a coarser spacing.</source>
        <translation>Für ein Volumen von %1 reicht der Speicher nicht; einen gröberen Voxelabstand nehmen.</translation>
    </message>
    <message>
        <source>There is not enough memory for the %1 samples of %2; close other programs, or cut the file into parts.</source>
        <translation>Für die %1 Abtastwerte von %2 reicht der Speicher nicht; andere Programme schließen oder die Datei in Teile zerlegen.</translation>
    </message>
    <message>
        <source>There is not enough memory for the frames of %1; close other programs.</source>
        <translation>Für die Bilder von %1 reicht der Speicher nicht; andere Programme schließen.</translation>
    </message>
    <message>
        <source>There is not enough memory for the frames of this sweep; use fewer or a larger pixel_mm.</source>
        <translation>Für die Bilder dieses Schwenks reicht der Speicher nicht; weniger Bilder oder ein größeres pixel_mm nehmen.</translation>
    </message>
    <message>
        <source>There is not enough memory for the pictures of %1; close other programs.</source>
        <translation>Für die Bilder von %1 reicht der Speicher nicht; andere Programme schließen.</translation>
    </message>
    <message>
        <source>There is not enough memory for the planes of %1; close other programs.</source>
        <translation>Für die Ebenen von %1 reicht der Speicher nicht; andere Programme schließen.</translation>
    </message>
    <message>
        <source>There is not enough memory for the recording %1; close other programs, or cut it into parts.</source>
        <translation>Für die Aufnahme %1 reicht der Speicher nicht; andere Programme schließen oder sie in Teile zerlegen.</translation>
    </message>
    <message>
        <source>There is not enough memory for the sums of the reconstruction; use fewer threads.</source>
        <translation>Für die Summen der Rekonstruktion reicht der Speicher nicht; weniger Threads nehmen.</translation>
    </message>
    <message>
        <source>There is not enough memory for this; close other programs or choose a coarser spacing.</source>
        <translation>Dafür reicht der Speicher nicht; andere Programme schließen oder einen gröberen Voxelabstand wählen.</translation>
    </message>
    <message>
        <source>There is not enough memory to fill holes; use fewer threads or a coarser spacing.</source>
        <translation>Zum Füllen der Lücken reicht der Speicher nicht; weniger Threads oder einen gröberen Voxelabstand nehmen.</translation>
    </message>
    <message>
        <source>There is not enough memory to read frames at the voxels; use fewer threads or a coarser spacing.</source>
        <translation>Zum Lesen der Bilder an den Voxeln reicht der Speicher nicht; weniger Threads oder einen gröberen Voxelabstand nehmen.</translation>
    </message>
    <message>
        <source>There is not enough memory to sample the body at this spacing; use a coarser one.</source>
        <translation>Um den Körper mit diesem Abstand abzutasten, reicht der Speicher nicht; einen gröberen nehmen.</translation>
    </message>
    <message>
        <source>There is one subvolume; it stays where it is.</source>
        <translation>Es gibt ein Teilvolumen; es bleibt, wo es ist.</translation>
    </message>
    <message>
        <source>There is one volume alone.</source>
        <translation>Es gibt nur ein Volumen.</translation>
    </message>
    <message>
        <source>This patient at %1 mm needs %2 of memory, %3 are allowed; choose a coarser spacing.</source>
        <translation>Dieser Patient braucht bei %1 mm %2 Speicher, erlaubt sind %3; einen gröberen Voxelabstand wählen.</translation>
    </message>
    <message>
        <source>Time runs backwards at %1 frame; the order in the file was kept.</source>
        <translation>Die Zeit läuft bei %1 Bild rückwärts; die Reihenfolge der Datei blieb.</translation>
    </message>
    <message>
        <source>Time runs backwards at %1 frames; the order in the file was kept.</source>
        <translation>Die Zeit läuft bei %1 Bildern rückwärts; die Reihenfolge der Datei blieb.</translation>
    </message>
    <message>
        <source>Time runs backwards at frame %1; put the recording in order of time.</source>
        <translation>Bei Bild %1 läuft die Zeit rückwärts; die Aufnahme nach der Zeit ordnen.</translation>
    </message>
    <message>
        <source>Time runs backwards in the %1 at sample %2; put the recording in order of time.</source>
        <translation>Im %1 läuft die Zeit beim Abtastwert %2 rückwärts; die Aufnahme nach der Zeit ordnen.</translation>
    </message>
    <message>
        <source>Timing the qualities</source>
        <translation>Die Zeiten der Qualitäten werden gemessen</translation>
    </message>
    <message>
        <source>Forming the finest echoes</source>
        <translation>Die feinsten Echos werden gebildet</translation>
    </message>
    <message>
        <source>Timing the slice thickness</source>
        <translation>Die Zeiten der Schichtdicke werden gemessen</translation>
    </message>
    <message>
        <source>Too little structure is shared to tell whether the deformation is right.</source>
        <translation>Die Volumen haben zu wenig Struktur gemeinsam, um die Verformung zu beurteilen.</translation>
    </message>
    <message>
        <source>Too little structure is shared to tell: deformed, the volumes reach %1.</source>
        <translation>Die Volumen haben zu wenig Struktur gemeinsam für ein Urteil: Verformt erreichen sie %1.</translation>
    </message>
    <message>
        <source>True or False</source>
        <translation>True oder False</translation>
    </message>
    <message>
        <source>Two different poses agree almost equally (margin %1): the structure repeats, a close start or landmarks must choose%2.</source>
        <translation>Zwei verschiedene Lagen stimmen fast gleich gut überein (Abstand %1): Die Struktur wiederholt sich, ein naher Anfang oder Landmarken müssen entscheiden%2.</translation>
    </message>
    <message>
        <source>Two places are too few: a turn needs three places that are not on one line.</source>
        <translation>Zwei Stellen sind zu wenig: Eine Drehung braucht drei Stellen, die nicht auf einer Geraden liegen.</translation>
    </message>
    <message>
        <source>Two planes of %1 lie in the same place; export the volume again.</source>
        <translation>Zwei Ebenen von %1 liegen am selben Ort; das Volumen neu exportieren.</translation>
    </message>
    <message>
        <source>Two sweeps of the case are called &apos;%1&apos;; give each a name of its own.</source>
        <translation>Zwei Schwenks des Falls heißen „%1“; jedem einen eigenen Namen geben.</translation>
    </message>
    <message>
        <source>Unfolding</source>
        <translation>Faltungen werden entfernt</translation>
    </message>
    <message>
        <source>Unsaved changes of the case cannot be kept in &apos;%1&apos; (%2), so a crash would lose them; save the case often.</source>
        <translation>Ungespeicherte Änderungen des Falls lassen sich nicht in „%1“ aufheben (%2), ein Absturz würde sie also verlieren; den Fall oft speichern.</translation>
    </message>
    <message>
        <source>Volume %1 of %2 was read, %3 s after the first.</source>
        <translation>Volumen %1 von %2 wurde gelesen, %3 s nach dem ersten.</translation>
    </message>
    <message>
        <source>Volume %1 of %2 was read.</source>
        <translation>Volumen %1 von %2 wurde gelesen.</translation>
    </message>
    <message>
        <source>Volume &apos;%1&apos; cannot be stitched. %2</source>
        <translation>Das Volumen „%1“ kann nicht verbunden werden. %2</translation>
    </message>
    <message>
        <source>Volume &apos;%1&apos; contributed nothing: none of its voxels are covered.</source>
        <translation>Das Volumen „%1“ trug nichts bei: Keiner seiner Voxel ist erfasst.</translation>
    </message>
    <message>
        <source>Volume &apos;%1&apos; contributed nothing: other volumes show all that it covers better.</source>
        <translation>Das Volumen „%1“ trug nichts bei: Andere Volumen zeigen alles besser, was es erfasst.</translation>
    </message>
    <message>
        <source>Volume &apos;%1&apos; has no coverage, so its black voxels count as measured and darken the blend; give its coverage file if there is one.</source>
        <translation>Das Volumen „%1“ hat keine Abdeckung, sodass seine schwarzen Voxel als gemessen gelten und die Mischung abdunkeln; die Abdeckungsdatei angeben, falls es eine gibt.</translation>
    </message>
    <message>
        <source>Volume &apos;%1&apos; is not in the result: no pair that can be believed holds it to the others.</source>
        <translation>Das Volumen „%1“ ist nicht im Ergebnis: Kein Paar, dem zu trauen ist, hält es an den anderen.</translation>
    </message>
    <message>
        <source>Waiting for another EchoWeave that prepares the same case</source>
        <translation>Es wird auf ein anderes EchoWeave gewartet, das denselben Fall vorbereitet</translation>
    </message>
    <message>
        <source>Waiting for another program was cancelled.</source>
        <translation>Das Warten auf ein anderes Programm wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Warping the moving volume</source>
        <translation>Das bewegte Volumen wird verformt</translation>
    </message>
    <message>
        <source>Warping the moving volume was cancelled.</source>
        <translation>Das Verformen des bewegten Volumens wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Watching the images move</source>
        <translation>Die Bewegung der Bilder wird verfolgt</translation>
    </message>
    <message>
        <source>What agrees are mostly streaks, such as shadows along the beam, which turn with the probe: without them the pose lies %1 and %2 degrees elsewhere. A tracker, landmarks or the direction of the beams can decide.</source>
        <translation>Was übereinstimmt, sind vor allem Streifen wie Schatten längs des Strahls, die sich mit dem Schallkopf drehen: Ohne sie liegt die Lage %1 und %2° anderswo. Ein Tracker, Landmarken oder die Richtung der Strahlen können entscheiden.</translation>
    </message>
    <message>
        <source>What agrees are mostly streaks, such as shadows along the beam, which turn with the probe: without them the volumes agree hardly better than unrelated tissue does%1.</source>
        <translation>Was übereinstimmt, sind vor allem Streifen wie Schatten längs des Strahls, die sich mit dem Schallkopf drehen: Ohne sie stimmen die Volumen kaum besser überein als fremdes Gewebe%1.</translation>
    </message>
    <message>
        <source>What moves changes along the sweep; the phase may slip where one part of it ends and the next begins.</source>
        <translation>Was sich bewegt, ändert sich entlang des Schwenks; wo ein Teil endet und der nächste beginnt, kann die Phase springen.</translation>
    </message>
    <message>
        <source>What was there before could not be put back and lies in &apos;%1&apos;.</source>
        <translation>Was vorher dort war, ließ sich nicht zurücklegen und liegt in „%1“.</translation>
    </message>
    <message>
        <source>With %1 samples a second R peaks are timed to about %2 ms.</source>
        <translation>Bei %1 Abtastwerten je Sekunde ist die Zeit der R-Zacken auf etwa %2 ms genau.</translation>
    </message>
    <message>
        <source>With this delay no frame has a pose; check the delay, it is in seconds.</source>
        <translation>Mit dieser Verzögerung hat kein Bild eine Lage; die Verzögerung prüfen, sie ist in Sekunden.</translation>
    </message>
    <message>
        <source>With voxels of %1 mm the whole recording would be one voxel; use a finer spacing, or check the calibration for a wrong scale.</source>
        <translation>Mit Voxeln von %1 mm wäre die ganze Aufnahme ein einziger Voxel; einen feineren Voxelabstand nehmen oder die Kalibrierung auf einen falschen Maßstab prüfen.</translation>
    </message>
    <message>
        <source>Without information, and left out: %1.</source>
        <translation>Ohne Information und weggelassen: %1.</translation>
    </message>
    <message>
        <source>Work on %1 was stopped as you asked; nothing was changed.</source>
        <translation>Die Arbeit an %1 wurde wie gewünscht abgebrochen; nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Writing %1 was stopped; nothing was left of it.</source>
        <translation>Das Schreiben von %1 wurde abgebrochen; nichts davon blieb zurück.</translation>
    </message>
    <message>
        <source>Writing confidence</source>
        <translation>Verlässlichkeit wird geschrieben</translation>
    </message>
    <message>
        <source>Writing coverage</source>
        <translation>Abdeckung wird geschrieben</translation>
    </message>
    <message>
        <source>Writing frames</source>
        <translation>Bilder werden geschrieben</translation>
    </message>
    <message>
        <source>Writing out the displacements</source>
        <translation>Verschiebungen werden ausgeschrieben</translation>
    </message>
    <message>
        <source>Writing out the displacements was cancelled.</source>
        <translation>Das Ausschreiben der Verschiebungen wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Writing picture</source>
        <translation>Bild wird geschrieben</translation>
    </message>
    <message>
        <source>Writing sources</source>
        <translation>Quellbilder werden geschrieben</translation>
    </message>
    <message>
        <source>Writing vectors</source>
        <translation>Vektoren werden geschrieben</translation>
    </message>
    <message>
        <source>Writing voxels</source>
        <translation>Voxel werden geschrieben</translation>
    </message>
    <message>
        <source>Wrong, and left out, are %1.</source>
        <translation>Falsch und weggelassen: %1.</translation>
    </message>
    <message>
        <source>Wrong, and left out, is %1.</source>
        <translation>Falsch und weggelassen: %1.</translation>
    </message>
    <message>
        <source>a ProbeToWorldTransform and a Timestamp</source>
        <translation>eine ProbeToWorldTransform und ein Timestamp</translation>
    </message>
    <message>
        <source>a UUID or a short name of letters, digits, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;, starting with a letter or digit, at most 100 characters</source>
        <translation>eine UUID oder ein kurzer Name aus Buchstaben, Ziffern, „-“, „_“ und „.“, mit einem Buchstaben oder einer Ziffer am Anfang und höchstens 100 Zeichen</translation>
    </message>
    <message>
        <source>a closing parenthesis</source>
        <translation>eine schließende Klammer</translation>
    </message>
    <message>
        <source>a comma or a closing parenthesis</source>
        <translation>ein Komma oder eine schließende Klammer</translation>
    </message>
    <message>
        <source>a correlation of %1 over %2 of the smaller volume</source>
        <translation>eine Korrelation von %1 über %2 des kleineren Volumens</translation>
    </message>
    <message>
        <source>a coverage value</source>
        <translation>ein Wert der Abdeckung</translation>
    </message>
    <message>
        <source>a depth below held_depth_mm</source>
        <translation>eine Tiefe unter held_depth_mm</translation>
    </message>
    <message>
        <source>a depth in mm, 0 for half of the depth, or a list of up to %1 depths</source>
        <translation>eine Tiefe in mm, 0 für die halbe Tiefe oder eine Liste von bis zu %1 Tiefen</translation>
    </message>
    <message>
        <source>a dimension is no count</source>
        <translation>eine Dimension ist keine Anzahl</translation>
    </message>
    <message>
        <source>a direction</source>
        <translation>eine Richtung</translation>
    </message>
    <message>
        <source>a direction across the beam</source>
        <translation>eine Richtung quer zum Strahl</translation>
    </message>
    <message>
        <source>a distance along a line of %1 mm</source>
        <translation>ein Abstand entlang einer Linie von %1 mm</translation>
    </message>
    <message>
        <source>a distance without a line</source>
        <translation>ein Abstand ohne Linie</translation>
    </message>
    <message>
        <source>a divisor that is not 0</source>
        <translation>ein Divisor, der nicht 0 ist</translation>
    </message>
    <message>
        <source>a factor; 1 is neutral</source>
        <translation>ein Faktor; 1 ist neutral</translation>
    </message>
    <message>
        <source>a field without a name</source>
        <translation>ein Feld ohne Namen</translation>
    </message>
    <message>
        <source>a file name</source>
        <translation>ein Dateiname</translation>
    </message>
    <message>
        <source>a file of resources/mannequin or of the case folder, or &quot;&quot; for the default</source>
        <translation>eine Datei aus resources/mannequin oder aus dem Fallordner, oder &quot;&quot; für den üblichen</translation>
    </message>
    <message>
        <source>a frame described before this one</source>
        <translation>ein davor beschriebenes Koordinatensystem</translation>
    </message>
    <message>
        <source>a label that no other tissue of the list has</source>
        <translation>ein label, das kein anderes Gewebe der Liste hat</translation>
    </message>
    <message>
        <source>a larger depth than from_depth_mm</source>
        <translation>eine größere Tiefe als from_depth_mm</translation>
    </message>
    <message>
        <source>a length above 0</source>
        <translation>eine Länge über 0</translation>
    </message>
    <message>
        <source>a list of %1</source>
        <translation>eine Liste von %1</translation>
    </message>
    <message>
        <source>a list of %1 entries</source>
        <translation>eine Liste von %1 Einträgen</translation>
    </message>
    <message>
        <source>a list of %1 factors of at least 0, near to far (1 is neutral)</source>
        <translation>eine Liste von %1 Faktoren von mindestens 0, von nah nach fern (1 ist neutral)</translation>
    </message>
    <message>
        <source>a list of %1 numbers of decibels, each %2, near to far (0 is neutral)</source>
        <translation>eine Liste von %1 Zahlen in Dezibel, jede %2, von nah nach fern (0 ist neutral)</translation>
    </message>
    <message>
        <source>a list of %1 numbers from %2 to %3</source>
        <translation>eine Liste von %1 Zahlen von %2 bis %3</translation>
    </message>
    <message>
        <source>a list of 1 to %1 rising numbers from %2 to %3, %4 among them</source>
        <translation>eine Liste von 1 bis %1 steigenden Zahlen von %2 bis %3, darunter %4</translation>
    </message>
    <message>
        <source>a list of 1 to %1 volumes</source>
        <translation>eine Liste von 1 bis %1 Volumen</translation>
    </message>
    <message>
        <source>a list of 1 to 20 virtual sweeps of the recipe inside the case folder, as relative paths such as &quot;sweeps/subcostal.json&quot;</source>
        <translation>eine Liste von 1 bis 20 virtuellen Schwenks des Rezepts im Fallordner, als relative Pfade wie &quot;sweeps/subcostal.json&quot;</translation>
    </message>
    <message>
        <source>a list of at least three when the method is &quot;landmarks&quot;</source>
        <translation>eine Liste von mindestens drei, wenn das Verfahren &quot;landmarks&quot; ist</translation>
    </message>
    <message>
        <source>a list of at most %1 entries</source>
        <translation>eine Liste von höchstens %1 Einträgen</translation>
    </message>
    <message>
        <source>a list of events</source>
        <translation>eine Liste von Ereignissen</translation>
    </message>
    <message>
        <source>a list of objects with fixed_mm and moving_mm</source>
        <translation>eine Liste von Objekten mit fixed_mm und moving_mm</translation>
    </message>
    <message>
        <source>a list of objects with kind and name: what is to be found</source>
        <translation>eine Liste von Objekten mit kind und name: was zu finden ist</translation>
    </message>
    <message>
        <source>a list of objects with name and tolerance: what is to be measured</source>
        <translation>eine Liste von Objekten mit name und tolerance: was zu messen ist</translation>
    </message>
    <message>
        <source>a list of objects with view, at_mm and radius_mm</source>
        <translation>eine Liste von Objekten mit view, at_mm und radius_mm</translation>
    </message>
    <message>
        <source>a list of objects with when, kind and findings</source>
        <translation>eine Liste von Objekten mit when, kind und findings</translation>
    </message>
    <message>
        <source>a list of objects, each with its own label</source>
        <translation>eine Liste von Objekten, jedes mit eigenem label</translation>
    </message>
    <message>
        <source>a list of pairs</source>
        <translation>eine Liste von Paaren</translation>
    </message>
    <message>
        <source>a list of probe ids</source>
        <translation>eine Liste von Kennungen von Schallköpfen</translation>
    </message>
    <message>
        <source>a list of texts: what a good report of this examination says</source>
        <translation>eine Liste von Texten: was ein guter Befundbericht dieser Untersuchung sagt</translation>
    </message>
    <message>
        <source>a list of words such as &quot;panel&quot; or &quot;command:stitch&quot;</source>
        <translation>eine Liste von Wörtern wie &quot;panel&quot; oder &quot;command:stitch&quot;</translation>
    </message>
    <message>
        <source>a magnification</source>
        <translation>eine Vergrößerung</translation>
    </message>
    <message>
        <source>a marker stands where an element was expected</source>
        <translation>eine Marke steht, wo ein Element erwartet wurde</translation>
    </message>
    <message>
        <source>a multiple of %1</source>
        <translation>ein Vielfaches von %1</translation>
    </message>
    <message>
        <source>a name</source>
        <translation>ein Name</translation>
    </message>
    <message>
        <source>a name of %1 bytes</source>
        <translation>ein Name von %1 Byte</translation>
    </message>
    <message>
        <source>a name of 1 to 200 characters</source>
        <translation>ein Name mit 1 bis 200 Zeichen</translation>
    </message>
    <message>
        <source>a name that is not taken yet</source>
        <translation>ein Name, der noch nicht vergeben ist</translation>
    </message>
    <message>
        <source>a name that no other volume has</source>
        <translation>ein Name, den kein anderes Volumen hat</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a number above 0</source>
        <translation>eine Zahl über 0</translation>
    </message>
    <message>
        <source>a number above 0, in the measurement&apos;s unit</source>
        <translation>eine Zahl über 0, in der Einheit der Messung</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>eine Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>a number from -150 to 0 (below full white)</source>
        <translation>eine Zahl von -150 bis 0 (unter vollem Weiß)</translation>
    </message>
    <message>
        <source>a number from -150 to 0 (where the compensation ends)</source>
        <translation>eine Zahl von -150 bis 0 (wo der Ausgleich endet)</translation>
    </message>
    <message>
        <source>a number from 0 to 100</source>
        <translation>eine Zahl von 0 bis 100</translation>
    </message>
    <message>
        <source>a number from 0 to 100 (lost on entering)</source>
        <translation>eine Zahl von 0 bis 100 (Verlust beim Eintritt)</translation>
    </message>
    <message>
        <source>a number from 0 to 100 (one way)</source>
        <translation>eine Zahl von 0 bis 100 (einfacher Weg)</translation>
    </message>
    <message>
        <source>a number from 0 to 100, in mm</source>
        <translation>eine Zahl von 0 bis 100, in mm</translation>
    </message>
    <message>
        <source>a number from 0 to 1000, in mm</source>
        <translation>eine Zahl von 0 bis 1000, in mm</translation>
    </message>
    <message>
        <source>a number from 0 to 180, in degrees</source>
        <translation>eine Zahl von 0 bis 180, in Grad</translation>
    </message>
    <message>
        <source>a number from 0 to 255 (grey levels up to here take nothing)</source>
        <translation>eine Zahl von 0 bis 255 (Grauwerte bis hierher dämpfen nicht)</translation>
    </message>
    <message>
        <source>a number from 0 to 3 (1 as physics has it)</source>
        <translation>eine Zahl von 0 bis 3 (1 wie in der Physik)</translation>
    </message>
    <message>
        <source>a number from 0 to 3 (what the machine compensates)</source>
        <translation>eine Zahl von 0 bis 3 (was das Gerät ausgleicht)</translation>
    </message>
    <message>
        <source>a number from 0 to 3 (with depth)</source>
        <translation>eine Zahl von 0 bis 3 (mit der Tiefe)</translation>
    </message>
    <message>
        <source>a number from 0 to 30</source>
        <translation>eine Zahl von 0 bis 30</translation>
    </message>
    <message>
        <source>a number from 0 to 50 (gaps that gel fills)</source>
        <translation>eine Zahl von 0 bis 50 (Spalte, die das Gel füllt)</translation>
    </message>
    <message>
        <source>a number from 0 to 60 (lost in them)</source>
        <translation>eine Zahl von 0 bis 60 (Verlust darin)</translation>
    </message>
    <message>
        <source>a number from 0 to 60 (of mirror images)</source>
        <translation>eine Zahl von 0 bis 60 (für Spiegelbilder)</translation>
    </message>
    <message>
        <source>a number from 0 to 60 (there and back)</source>
        <translation>eine Zahl von 0 bis 60 (hin und zurück)</translation>
    </message>
    <message>
        <source>a number from 0 to 60 (where the amplifier ends)</source>
        <translation>eine Zahl von 0 bis 60 (wo der Verstärker endet)</translation>
    </message>
    <message>
        <source>a number from 0 to a fifth of length_mm</source>
        <translation>eine Zahl von 0 bis zu einem Fünftel von length_mm</translation>
    </message>
    <message>
        <source>a number from 0.001 to half of length_mm</source>
        <translation>eine Zahl von 0,001 bis zur Hälfte von length_mm</translation>
    </message>
    <message>
        <source>a number from 0.1 to 100, in mm</source>
        <translation>eine Zahl von 0,1 bis 100, in mm</translation>
    </message>
    <message>
        <source>a number from 0.1 to 1000, in mm</source>
        <translation>eine Zahl von 0,1 bis 1000, in mm</translation>
    </message>
    <message>
        <source>a number from 0.1 to 180, of a plane</source>
        <translation>eine Zahl von 0,1 bis 180, bei einer Ebene</translation>
    </message>
    <message>
        <source>a number from 0.1 to 200, of a plane</source>
        <translation>eine Zahl von 0,1 bis 200, bei einer Ebene</translation>
    </message>
    <message>
        <source>a number from 0.1 to 200, of a point</source>
        <translation>eine Zahl von 0,1 bis 200, bei einem Punkt</translation>
    </message>
    <message>
        <source>a number from 0.1 to 4 (of the probe&apos;s own thickness)</source>
        <translation>eine Zahl von 0,1 bis 4 (als Vielfaches der Schichtdicke des Schallkopfs)</translation>
    </message>
    <message>
        <source>a number from 0.5 to 100 (length of the lines under air)</source>
        <translation>eine Zahl von 0,5 bis 100 (Länge der Linien unter Luft)</translation>
    </message>
    <message>
        <source>a number from 1 to 10</source>
        <translation>eine Zahl von 1 bis 10</translation>
    </message>
    <message>
        <source>a number from 1 to 1000, in mm</source>
        <translation>eine Zahl von 1 bis 1000, in mm</translation>
    </message>
    <message>
        <source>a number from 1 to 16</source>
        <translation>eine Zahl von 1 bis 16</translation>
    </message>
    <message>
        <source>a number from 1 to 256 (grey levels from here on are strong interfaces)</source>
        <translation>eine Zahl von 1 bis 256 (Grauwerte ab hier sind starke Grenzflächen)</translation>
    </message>
    <message>
        <source>a number from 1 to 256 (grey levels from here on reflect)</source>
        <translation>eine Zahl von 1 bis 256 (Grauwerte ab hier reflektieren)</translation>
    </message>
    <message>
        <source>a number from 20 to 120 (what grey 0 to 255 spans)</source>
        <translation>eine Zahl von 20 bis 120 (was Grau 0 bis 255 umspannt)</translation>
    </message>
    <message>
        <source>a number of axes from 1 to 7</source>
        <translation>eine Achsenzahl von 1 bis 7</translation>
    </message>
    <message>
        <source>a number of bytes</source>
        <translation>eine Anzahl Byte</translation>
    </message>
    <message>
        <source>a number of bytes or -1</source>
        <translation>eine Anzahl Byte oder -1</translation>
    </message>
    <message>
        <source>a number of millimetres</source>
        <translation>eine Zahl in Millimetern</translation>
    </message>
    <message>
        <source>a number or an expression</source>
        <translation>eine Zahl oder ein Ausdruck</translation>
    </message>
    <message>
        <source>a number or an expression that begins with =</source>
        <translation>eine Zahl oder ein Ausdruck, der mit = beginnt</translation>
    </message>
    <message>
        <source>a number other than 0</source>
        <translation>eine andere Zahl als 0</translation>
    </message>
    <message>
        <source>a number that fits %1 samples</source>
        <translation>eine Zahl, die in einen Abtastwert passt (%1)</translation>
    </message>
    <message>
        <source>a number up to 100, in mm, or 0 for the finest of the volumes</source>
        <translation>eine Zahl bis 100, in mm, oder 0 für den feinsten Abstand der Volumen</translation>
    </message>
    <message>
        <source>a number up to 100, in mm, or 0 to choose it from the sweep</source>
        <translation>eine Zahl bis 100, in mm, oder 0, um sie aus dem Schwenk zu wählen</translation>
    </message>
    <message>
        <source>a number, a name or an opening parenthesis</source>
        <translation>eine Zahl, ein Name oder eine öffnende Klammer</translation>
    </message>
    <message>
        <source>a place at least 1 mm away from it</source>
        <translation>ein mindestens 1 mm davon entfernter Ort</translation>
    </message>
    <message>
        <source>a place inside the section</source>
        <translation>ein Ort im Querschnitt</translation>
    </message>
    <message>
        <source>a place near the skin</source>
        <translation>ein Ort nahe der Haut</translation>
    </message>
    <message>
        <source>a place, or &quot;place&quot;: &quot;largest&quot; or &quot;smallest&quot; of a tube</source>
        <translation>ein Ort oder &quot;place&quot;: &quot;largest&quot; oder &quot;smallest&quot; eines Rohrs</translation>
    </message>
    <message>
        <source>a plane of a patient, and the case has no recipe</source>
        <translation>eine Ebene eines Patienten, und der Fall hat kein Rezept</translation>
    </message>
    <message>
        <source>a plane with probe_to_world</source>
        <translation>eine Ebene mit probe_to_world</translation>
    </message>
    <message>
        <source>a point at least 0.01 mm from the one before</source>
        <translation>ein Punkt, mindestens 0,01 mm vom vorigen entfernt</translation>
    </message>
    <message>
        <source>a point or a plane</source>
        <translation>ein Punkt oder eine Ebene</translation>
    </message>
    <message>
        <source>a point to look at, as the probe is not on the skin</source>
        <translation>ein Punkt, auf den zu blicken ist, da der Schallkopf nicht auf der Haut liegt</translation>
    </message>
    <message>
        <source>a probe id such as &quot;convex-3.5&quot;</source>
        <translation>die Kennung eines Schallkopfs wie &quot;convex-3.5&quot;</translation>
    </message>
    <message>
        <source>a probe that is not on the skin needs it</source>
        <translation>ein Schallkopf, der nicht auf der Haut liegt, braucht es</translation>
    </message>
    <message>
        <source>a radius that some of the vessels have</source>
        <translation>ein Radius, den manche der Gefäße haben</translation>
    </message>
    <message>
        <source>a recipe that does not extend this one in turn</source>
        <translation>ein Rezept, das nicht seinerseits dieses erweitert</translation>
    </message>
    <message>
        <source>a relative path such as &quot;sweeps/subcostal.json&quot;</source>
        <translation>ein relativer Pfad wie &quot;sweeps/subcostal.json&quot;</translation>
    </message>
    <message>
        <source>a result that is finite</source>
        <translation>ein endliches Ergebnis</translation>
    </message>
    <message>
        <source>a sample</source>
        <translation>ein Abtastwert</translation>
    </message>
    <message>
        <source>a sentence saying what the plugin does</source>
        <translation>ein Satz, der sagt, was die Erweiterung tut</translation>
    </message>
    <message>
        <source>a sequence holds something that is no item</source>
        <translation>eine Sequenz enthält etwas, das kein Item ist</translation>
    </message>
    <message>
        <source>a shape</source>
        <translation>eine Form</translation>
    </message>
    <message>
        <source>a shape described before this one</source>
        <translation>eine vor dieser beschriebene Form</translation>
    </message>
    <message>
        <source>a short name of letters, digits, &apos;-&apos; and &apos;_&apos;, starting with a letter</source>
        <translation>ein kurzer Name aus Buchstaben, Ziffern, „-“ und „_“, mit einem Buchstaben am Anfang</translation>
    </message>
    <message>
        <source>a shorter one</source>
        <translation>eine kürzere</translation>
    </message>
    <message>
        <source>a shorter one, or a wider way from held to free</source>
        <translation>eine kürzere Verschiebung oder ein breiterer Übergang von gehalten zu frei</translation>
    </message>
    <message>
        <source>a spacing is not above 0 mm</source>
        <translation>ein Abstand ist nicht über 0 mm</translation>
    </message>
    <message>
        <source>a structure of a patient, and the case has no recipe</source>
        <translation>eine Struktur eines Patienten, und der Fall hat kein Rezept</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>a text of %1 bytes</source>
        <translation>ein Text von %1 Byte</translation>
    </message>
    <message>
        <source>a text of at most %1 bytes</source>
        <translation>ein Text von höchstens %1 Byte</translation>
    </message>
    <message>
        <source>a text of at most 200 bytes</source>
        <translation>ein Text von höchstens 200 Byte</translation>
    </message>
    <message>
        <source>a time in seconds</source>
        <translation>eine Zeit in Sekunden</translation>
    </message>
    <message>
        <source>a title of 1 to 200 characters</source>
        <translation>ein Titel mit 1 bis 200 Zeichen</translation>
    </message>
    <message>
        <source>a title of 1 to 200 characters that gives no finding away; without it a trainee reads the title</source>
        <translation>ein Titel mit 1 bis 200 Zeichen, der keinen Befund verrät; ohne ihn lesen Lernende den Titel</translation>
    </message>
    <message>
        <source>a transform&apos;s name</source>
        <translation>der Name einer Transformation</translation>
    </message>
    <message>
        <source>a tube that runs up or down all along, never turning back or running level</source>
        <translation>ein Rohr, das durchgehend auf- oder absteigt, ohne umzukehren oder waagerecht zu verlaufen</translation>
    </message>
    <message>
        <source>a tube, or at_mm in place of %1</source>
        <translation>ein Rohr oder at_mm anstelle von %1</translation>
    </message>
    <message>
        <source>a type from MET_UCHAR to MET_DOUBLE</source>
        <translation>ein Typ von MET_UCHAR bis MET_DOUBLE</translation>
    </message>
    <message>
        <source>a type from uchar to double</source>
        <translation>ein Typ von uchar bis double</translation>
    </message>
    <message>
        <source>a version such as &quot;1.2.0&quot;</source>
        <translation>eine Version wie &quot;1.2.0&quot;</translation>
    </message>
    <message>
        <source>a virtual patient inside the case folder, as a relative path such as &quot;patient.json&quot;</source>
        <translation>ein virtueller Patient im Fallordner, als relativer Pfad wie &quot;patient.json&quot;</translation>
    </message>
    <message>
        <source>a volume file inside the case folder, as a relative path such as &quot;volumes/abdomen.mha&quot;</source>
        <translation>eine Volumendatei im Fallordner, als relativer Pfad wie &quot;volumes/abdomen.mha&quot;</translation>
    </message>
    <message>
        <source>a volume file of labels (one 8 bit unsigned number a voxel) inside the case folder, as a relative path; beside a file alone, for a recipe makes its own</source>
        <translation>eine Volumendatei mit Labels (je Voxel eine vorzeichenlose 8-Bit-Zahl) im Fallordner, als relativer Pfad; nur neben einer Datei, denn ein Rezept macht seine eigenen</translation>
    </message>
    <message>
        <source>a voxel spacing from 0.1 to 10 mm</source>
        <translation>ein Voxelabstand von 0,1 bis 10 mm</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>a whole number above 0</source>
        <translation>eine ganze Zahl über 0</translation>
    </message>
    <message>
        <source>a whole number from %1</source>
        <translation>eine ganze Zahl ab %1</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>eine ganze Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>a whole number from 0 to 130</source>
        <translation>eine ganze Zahl von 0 bis 130</translation>
    </message>
    <message>
        <source>a whole number from 0 to 255</source>
        <translation>eine ganze Zahl von 0 bis 255</translation>
    </message>
    <message>
        <source>a whole number from 1</source>
        <translation>eine ganze Zahl ab 1</translation>
    </message>
    <message>
        <source>a whole number from 1 to 6</source>
        <translation>eine ganze Zahl von 1 bis 6</translation>
    </message>
    <message>
        <source>a word</source>
        <translation>ein Wort</translation>
    </message>
    <message>
        <source>above 0</source>
        <translation>ein Wert über 0</translation>
    </message>
    <message>
        <source>above 0 and at most 1</source>
        <translation>ein Wert über 0 und höchstens 1</translation>
    </message>
    <message>
        <source>above 0 and at most 100</source>
        <translation>ein Wert über 0 und höchstens 100</translation>
    </message>
    <message>
        <source>above 0 and below 0.9</source>
        <translation>ein Wert über 0 und unter 0,9</translation>
    </message>
    <message>
        <source>above 0, or 0 together with the other one when recorded places are exact</source>
        <translation>ein Wert über 0 oder, wenn aufgezeichnete Lagen genau sind, 0 zusammen mit dem anderen</translation>
    </message>
    <message>
        <source>aligned</source>
        <translation>ausgerichtet</translation>
    </message>
    <message>
        <source>along the beam</source>
        <translation>entlang des Strahls</translation>
    </message>
    <message>
        <source>an axis of the planes that lies behind the first samples</source>
        <translation>eine Achse der Ebenen, die hinter den ersten Abtastwerten liegt</translation>
    </message>
    <message>
        <source>an element has no value representation</source>
        <translation>ein Element hat keine Value Representation</translation>
    </message>
    <message>
        <source>an event that this program knows</source>
        <translation>ein Ereignis, das dieses Programm kennt</translation>
    </message>
    <message>
        <source>an expression of at most %1 characters</source>
        <translation>ein Ausdruck von höchstens %1 Zeichen</translation>
    </message>
    <message>
        <source>an invented name of at most 200 characters</source>
        <translation>ein erfundener Name mit höchstens 200 Zeichen</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>an object that says how the sweeps become the volume</source>
        <translation>ein Objekt, das sagt, wie die Schwenks zum Volumen werden</translation>
    </message>
    <message>
        <source>an object with %1 fields</source>
        <translation>ein Objekt mit %1 Feldern</translation>
    </message>
    <message>
        <source>an object with a label</source>
        <translation>ein Objekt mit label</translation>
    </message>
    <message>
        <source>an object with a section of each plugin that keeps something in the case</source>
        <translation>ein Objekt mit einem Abschnitt jeder Erweiterung, die etwas im Fall aufhebt</translation>
    </message>
    <message>
        <source>an object with default, lowest, highest and unit</source>
        <translation>ein Objekt mit default, lowest, highest und unit</translation>
    </message>
    <message>
        <source>an object with kind and name</source>
        <translation>ein Objekt mit kind und name</translation>
    </message>
    <message>
        <source>an object with lowest_mm and highest_mm</source>
        <translation>ein Objekt mit lowest_mm und highest_mm</translation>
    </message>
    <message>
        <source>an object with name, sex and age_years</source>
        <translation>ein Objekt mit name, sex und age_years</translation>
    </message>
    <message>
        <source>an object with one entry for each name, of at most %1 entries</source>
        <translation>ein Objekt mit einem Eintrag je Name und höchstens %1 Einträgen</translation>
    </message>
    <message>
        <source>an object with the effects the scene calls for</source>
        <translation>ein Objekt mit den Effekten, die die Szene verlangt</translation>
    </message>
    <message>
        <source>an object with the fields of a case</source>
        <translation>ein Objekt mit den Feldern eines Falls</translation>
    </message>
    <message>
        <source>an object with the fields of a plugin manifest</source>
        <translation>ein Objekt mit den Feldern der Beschreibung einer Erweiterung</translation>
    </message>
    <message>
        <source>an object with the name of a measurement of the patient</source>
        <translation>ein Objekt mit dem Namen einer Messung des Patienten</translation>
    </message>
    <message>
        <source>an object with when, kind and findings, each a text</source>
        <translation>ein Objekt mit when, kind und findings, jeweils als Text</translation>
    </message>
    <message>
        <source>an odd number from %1 to %2</source>
        <translation>eine ungerade Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>an operator in place of &quot;%1&quot;</source>
        <translation>ein Operator anstelle von „%1“</translation>
    </message>
    <message>
        <source>an organ of the patient, of a structure</source>
        <translation>ein Organ des Patienten, bei einer Struktur</translation>
    </message>
    <message>
        <source>angles that go to and fro</source>
        <translation>Winkel, die hin und her gehen</translation>
    </message>
    <message>
        <source>angles that rise or fall throughout</source>
        <translation>Winkel, die durchweg steigen oder fallen</translation>
    </message>
    <message>
        <source>angles within 89 degrees of pi / 2</source>
        <translation>Winkel, die höchstens 89 Grad von pi / 2 abweichen</translation>
    </message>
    <message>
        <source>another kind of picture</source>
        <translation>eine andere Art Bild</translation>
    </message>
    <message>
        <source>another volume than fixed</source>
        <translation>ein anderes Volumen als fixed</translation>
    </message>
    <message>
        <source>any amount</source>
        <translation>beliebig viel</translation>
    </message>
    <message>
        <source>any distance</source>
        <translation>beliebig viel</translation>
    </message>
    <message>
        <source>at %1 has no skin within %2 mm</source>
        <translation>hat bei %1 keine Haut innerhalb von %2 mm</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>mindestens %1</translation>
    </message>
    <message>
        <source>at least one frame</source>
        <translation>mindestens ein Bild</translation>
    </message>
    <message>
        <source>at least one value per sample</source>
        <translation>mindestens ein Wert je Abtastwert</translation>
    </message>
    <message>
        <source>at most %1 in all organs, a shared one counted at every use</source>
        <translation>höchstens %1 in allen Organen, ein gemeinsamer bei jeder Verwendung gezählt</translation>
    </message>
    <message>
        <source>at most %1 nested parentheses</source>
        <translation>höchstens %1 geschachtelte Klammern</translation>
    </message>
    <message>
        <source>at most %1 of all trees together</source>
        <translation>höchstens %1 von allen Bäumen zusammen</translation>
    </message>
    <message>
        <source>at most %1 shapes inside one another</source>
        <translation>höchstens %1 ineinander geschachtelte Formen</translation>
    </message>
    <message>
        <source>at most %1 solids and %2 shapes inside one another</source>
        <translation>höchstens %1 Volumenkörper und %2 ineinander geschachtelte Formen</translation>
    </message>
    <message>
        <source>at most 50; place the volumes first</source>
        <translation>höchstens 50 (die Volumen zuerst platzieren)</translation>
    </message>
    <message>
        <source>at most 60 mm</source>
        <translation>höchstens 60 mm</translation>
    </message>
    <message>
        <source>at near_mm</source>
        <translation>bei near_mm</translation>
    </message>
    <message>
        <source>away from the body</source>
        <translation>vom Körper entfernt</translation>
    </message>
    <message>
        <source>beam angles (C300/0002)</source>
        <translation>Strahlwinkel (C300/0002)</translation>
    </message>
    <message>
        <source>beams (C000/0002)</source>
        <translation>Zahl der Strahlen (C000/0002)</translation>
    </message>
    <message>
        <source>below full white</source>
        <translation>unter vollem Weiß</translation>
    </message>
    <message>
        <source>between 0 and 1</source>
        <translation>ein Wert zwischen 0 und 1</translation>
    </message>
    <message>
        <source>both %1 and %2</source>
        <translation>sowohl %1 als auch %2</translation>
    </message>
    <message>
        <source>both before and after another</source>
        <translation>sowohl vor als auch nach einem anderen</translation>
    </message>
    <message>
        <source>by hand, not checked</source>
        <translation>von Hand, nicht geprüft</translation>
    </message>
    <message>
        <source>by landmarks, %1</source>
        <translation>nach Landmarken, %1</translation>
    </message>
    <message>
        <source>cannot tell</source>
        <translation>unklar</translation>
    </message>
    <message>
        <source>change</source>
        <translation>Veränderung</translation>
    </message>
    <message>
        <source>choose a smaller probe or another place</source>
        <translation>einen kleineren Schallkopf oder eine andere Stelle wählen</translation>
    </message>
    <message>
        <source>choose one of those frames, or give the device set (.xml) that leads on</source>
        <translation>eines dieser Bezugssysteme wählen oder die Kalibrierung (.xml) angeben, die weiterführt</translation>
    </message>
    <message>
        <source>colour bar</source>
        <translation>Farbbalken</translation>
    </message>
    <message>
        <source>colour flow</source>
        <translation>Farbdoppler</translation>
    </message>
    <message>
        <source>compressed</source>
        <translation>komprimiert</translation>
    </message>
    <message>
        <source>correlates what does not vary</source>
        <translation>korreliert, was nicht variiert</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>decibels; 0 is neutral</source>
        <translation>Dezibel; 0 ist neutral</translation>
    </message>
    <message>
        <source>distance of samples (C100/0001)</source>
        <translation>Abstand der Abtastwerte (C100/0001)</translation>
    </message>
    <message>
        <source>distances in mm</source>
        <translation>Abstände in mm</translation>
    </message>
    <message>
        <source>does not say where it looks (towards_mm)</source>
        <translation>sagt nicht, wohin sie blickt (towards_mm)</translation>
    </message>
    <message>
        <source>entries, first value and 8 or 16 bits</source>
        <translation>Zahl der Einträge, erster Wert und 8 oder 16 Bit</translation>
    </message>
    <message>
        <source>fewer ends, or an organ of fewer solids</source>
        <translation>weniger Enden, oder ein Organ aus weniger Körpern</translation>
    </message>
    <message>
        <source>fewer than two cycles can be seen</source>
        <translation>es sind weniger als zwei Zyklen zu sehen</translation>
    </message>
    <message>
        <source>fewer points</source>
        <translation>weniger Punkte</translation>
    </message>
    <message>
        <source>finite vectors of 2 or 3 numbers</source>
        <translation>endliche Vektoren mit 2 oder 3 Zahlen</translation>
    </message>
    <message>
        <source>finite voxel sizes</source>
        <translation>endliche Voxelgrößen</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>festen</translation>
    </message>
    <message>
        <source>four numbers, [x, y, z, radius] in mm, with a radius from %1 to %2</source>
        <translation>vier Zahlen, [x, y, z, Radius] in mm, mit einem Radius von %1 bis %2</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>Bild %1</translation>
    </message>
    <message>
        <source>frame %1 of %2</source>
        <translation>Bild %1 von %2</translation>
    </message>
    <message>
        <source>from 0 to 180</source>
        <translation>ein Wert von 0 bis 180</translation>
    </message>
    <message>
        <source>from 0.1 to 10 mm</source>
        <translation>ein Wert von 0,1 bis 10 mm</translation>
    </message>
    <message>
        <source>from 1 to 1000</source>
        <translation>ein Wert von 1 bis 1000</translation>
    </message>
    <message>
        <source>from 2 to 90</source>
        <translation>ein Wert von 2 bis 90</translation>
    </message>
    <message>
        <source>from_mm and to_mm, two places</source>
        <translation>from_mm und to_mm, zwei Orte</translation>
    </message>
    <message>
        <source>gaps that gel fills</source>
        <translation>Spalte, die das Gel füllt</translation>
    </message>
    <message>
        <source>give a point near the skin, or say &quot;on_skin&quot;: false to place the probe freely</source>
        <translation>einen Punkt nahe der Haut angeben oder &quot;on_skin&quot;: false setzen, um den Schallkopf frei zu platzieren</translation>
    </message>
    <message>
        <source>give the device set (.xml) with the calibration from Image to Probe</source>
        <translation>die Kalibrierung (.xml) von Image zu Probe angeben</translation>
    </message>
    <message>
        <source>give the device set (.xml) with the calibration from Image to the tracked probe</source>
        <translation>die Kalibrierung (.xml) von Image zum verfolgten Schallkopf angeben</translation>
    </message>
    <message>
        <source>give the direction of the image&apos;s x axis, square to the beam</source>
        <translation>die Richtung der x-Achse des Bildes angeben, senkrecht zum Strahl</translation>
    </message>
    <message>
        <source>given</source>
        <translation>angegeben</translation>
    </message>
    <message>
        <source>given without a recipe</source>
        <translation>ohne Rezept angegeben</translation>
    </message>
    <message>
        <source>given without sweeps</source>
        <translation>ohne Schwenks angegeben</translation>
    </message>
    <message>
        <source>given, and the case has no recipe whose patient could know their values</source>
        <translation>angegeben, und der Fall hat kein Rezept, dessen Patient die Werte kennen könnte</translation>
    </message>
    <message>
        <source>grey bar</source>
        <translation>Graukeil</translation>
    </message>
    <message>
        <source>grey levels from here on are strong interfaces</source>
        <translation>Grauwerte ab hier sind starke Grenzflächen</translation>
    </message>
    <message>
        <source>grey levels from here on reflect</source>
        <translation>Grauwerte ab hier reflektieren</translation>
    </message>
    <message>
        <source>grey levels up to here take nothing</source>
        <translation>Grauwerte bis hierher dämpfen nicht</translation>
    </message>
    <message>
        <source>has a lateral direction along its beam</source>
        <translation>hat eine laterale Richtung entlang ihres Strahls</translation>
    </message>
    <message>
        <source>has a negative variance</source>
        <translation>hat eine negative Varianz</translation>
    </message>
    <message>
        <source>has an entry that is not a number</source>
        <translation>hat einen Eintrag, der keine Zahl ist</translation>
    </message>
    <message>
        <source>has correlations that cannot be together</source>
        <translation>hat Korrelationen, die nicht zusammen bestehen können</translation>
    </message>
    <message>
        <source>here</source>
        <translation>vorhanden</translation>
    </message>
    <message>
        <source>is in a fold of the skin that the probe %1 does not fit into</source>
        <translation>liegt in einer Hautfalte, in die der Schallkopf %1 nicht passt</translation>
    </message>
    <message>
        <source>is not symmetric</source>
        <translation>ist nicht symmetrisch</translation>
    </message>
    <message>
        <source>it cannot be read</source>
        <translation>sie lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>it ends early</source>
        <translation>die Datei endet zu früh</translation>
    </message>
    <message>
        <source>it ends inside a sequence</source>
        <translation>die Datei endet mitten in einer Sequenz</translation>
    </message>
    <message>
        <source>it ends inside an element of %1 bytes</source>
        <translation>die Datei endet mitten in einem Element von %1 Byte</translation>
    </message>
    <message>
        <source>it ends inside an element&apos;s head</source>
        <translation>die Datei endet mitten im Kopf eines Elements</translation>
    </message>
    <message>
        <source>it ends inside an item of a sequence</source>
        <translation>die Datei endet mitten im Item einer Sequenz</translation>
    </message>
    <message>
        <source>it ends inside an item&apos;s end</source>
        <translation>die Datei endet vor dem Ende eines Items</translation>
    </message>
    <message>
        <source>it ends inside the pixels</source>
        <translation>die Datei endet mitten in den Pixeln</translation>
    </message>
    <message>
        <source>it gives no size of a pixel</source>
        <translation>sie nennt keine Größe eines Pixels</translation>
    </message>
    <message>
        <source>it has a single R peak, which does not say how long a beat lasts</source>
        <translation>es hat eine einzige R-Zacke, die nicht sagt, wie lang ein Schlag dauert</translation>
    </message>
    <message>
        <source>it has no R peak</source>
        <translation>es hat keine R-Zacke</translation>
    </message>
    <message>
        <source>it has too few samples a second</source>
        <translation>es hat zu wenige Abtastwerte je Sekunde</translation>
    </message>
    <message>
        <source>it has too many elements</source>
        <translation>die Datei hat zu viele Elemente</translation>
    </message>
    <message>
        <source>it has too many fragments</source>
        <translation>die Datei hat zu viele Fragmente</translation>
    </message>
    <message>
        <source>it holds fewer than two full inspirations</source>
        <translation>es enthält weniger als zwei volle Einatmungen</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>es ist ein Ordner</translation>
    </message>
    <message>
        <source>it is a library of another kind of machine</source>
        <translation>sie ist eine Bibliothek für eine andere Art von Rechner</translation>
    </message>
    <message>
        <source>it is cut off</source>
        <translation>sie ist abgeschnitten</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>it is mirrored (left-handed)</source>
        <translation>sie ist gespiegelt (linkshändig)</translation>
    </message>
    <message>
        <source>it is no two-dimensional picture</source>
        <translation>sie ist kein zweidimensionales Bild</translation>
    </message>
    <message>
        <source>it is not a folder</source>
        <translation>es ist kein Ordner</translation>
    </message>
    <message>
        <source>it is not a library</source>
        <translation>sie ist keine Bibliothek</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>es ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>it is shorter than one heart beat</source>
        <translation>es ist kürzer als ein Herzschlag</translation>
    </message>
    <message>
        <source>it is shorter than two breaths</source>
        <translation>es ist kürzer als zwei Atemzüge</translation>
    </message>
    <message>
        <source>it names no file</source>
        <translation>es nennt keine Datei</translation>
    </message>
    <message>
        <source>it reaches beyond the picture of %1 x %2 pixels, so that it was made for another size</source>
        <translation>sie reicht über das Bild von %1 × %2 Pixeln hinaus, wurde also für eine andere Größe gemacht</translation>
    </message>
    <message>
        <source>its %1 and %2 axes are not orthogonal</source>
        <translation>ihre Achsen %1 und %2 stehen nicht senkrecht aufeinander</translation>
    </message>
    <message>
        <source>its %1 axis has length %2 instead of 1</source>
        <translation>ihre %1-Achse hat die Länge %2 statt 1</translation>
    </message>
    <message>
        <source>its beats are %1 s apart, too far for a heart</source>
        <translation>seine Schläge liegen %1 s auseinander, zu weit für ein Herz</translation>
    </message>
    <message>
        <source>its corners are missing or crossed</source>
        <translation>ihre Ecken fehlen oder sind vertauscht</translation>
    </message>
    <message>
        <source>its folder &apos;%1&apos; does not exist</source>
        <translation>den Ordner „%1“ gibt es nicht</translation>
    </message>
    <message>
        <source>its last row is not 0 0 0 1</source>
        <translation>ihre letzte Zeile ist nicht 0 0 0 1</translation>
    </message>
    <message>
        <source>its line does not cross the two surfaces one after the other</source>
        <translation>ihre Linie kreuzt die beiden Oberflächen nicht nacheinander</translation>
    </message>
    <message>
        <source>its line does not enter %1</source>
        <translation>ihre Linie tritt nicht in %1 ein</translation>
    </message>
    <message>
        <source>its line does not leave %1 before it enters the other</source>
        <translation>ihre Linie verlässt %1 nicht, bevor sie in das andere eintritt</translation>
    </message>
    <message>
        <source>its neighbour could not be opened</source>
        <translation>die Datei daneben ließ sich nicht öffnen</translation>
    </message>
    <message>
        <source>its place does not lie inside %1</source>
        <translation>ihr Ort liegt nicht in %1</translation>
    </message>
    <message>
        <source>its units are not cm</source>
        <translation>ihre Einheiten sind nicht cm</translation>
    </message>
    <message>
        <source>larger than a cubic metre</source>
        <translation>größer als ein Kubikmeter</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>keine Angabe</translation>
    </message>
    <message>
        <source>left out, as at most %1 recipes extend one another</source>
        <translation>keine Angabe, denn höchstens %1 Rezepte erweitern einander</translation>
    </message>
    <message>
        <source>left out, because a probe of the kind %1 has no such field</source>
        <translation>keine Angabe, denn ein Schallkopf der Art %1 hat kein solches Feld</translation>
    </message>
    <message>
        <source>left out, or beside the recipe whose patient is swept</source>
        <translation>keine Angabe oder eine neben dem Rezept, dessen Patient geschallt wird</translation>
    </message>
    <message>
        <source>left out, or beside the sweeps it is about</source>
        <translation>keine Angabe oder eine neben den Schwenks, um die es geht</translation>
    </message>
    <message>
        <source>left out: only a fan motor has it</source>
        <translation>keine Angabe, denn nur ein Fächermotor hat es</translation>
    </message>
    <message>
        <source>left out: only a fan or a rotational motor has it</source>
        <translation>keine Angabe, denn nur ein Fächer- oder ein Drehmotor hat es</translation>
    </message>
    <message>
        <source>left out: only a hand has it</source>
        <translation>keine Angabe, denn nur eine Hand hat es</translation>
    </message>
    <message>
        <source>left out: only a parallel motor has it</source>
        <translation>keine Angabe, denn nur ein paralleler Motor hat es</translation>
    </message>
    <message>
        <source>length of the lines under air</source>
        <translation>Länge der Linien unter Luft</translation>
    </message>
    <message>
        <source>less growth, or a longer reach, so that no tissue is folded</source>
        <translation>weniger Wachstum oder eine größere Reichweite, damit sich kein Gewebe faltet</translation>
    </message>
    <message>
        <source>little or big</source>
        <translation>little oder big</translation>
    </message>
    <message>
        <source>look at a point inside the body</source>
        <translation>auf einen Punkt im Körper blicken</translation>
    </message>
    <message>
        <source>look at a point inside the body, less than 80 degrees from straight in</source>
        <translation>auf einen Punkt im Körper blicken, weniger als 80 Grad von senkrecht nach innen</translation>
    </message>
    <message>
        <source>looks along the skin or out of the body</source>
        <translation>blickt entlang der Haut oder aus dem Körper heraus</translation>
    </message>
    <message>
        <source>looks towards the very point where it stands</source>
        <translation>blickt auf eben den Punkt, an dem sie steht</translation>
    </message>
    <message>
        <source>lost in them</source>
        <translation>Verlust darin</translation>
    </message>
    <message>
        <source>lost on entering</source>
        <translation>Verlust beim Eintritt</translation>
    </message>
    <message>
        <source>made of too many solids, a shared one counted at every use, or of shapes that use one another too deeply</source>
        <translation>aus zu vielen Volumenkörpern, ein gemeinsamer bei jeder Verwendung gezählt, oder aus Formen, die einander zu tief verwenden</translation>
    </message>
    <message>
        <source>mannequin recipe</source>
        <translation>Rezept des Übungskörpers</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>nicht vorhanden</translation>
    </message>
    <message>
        <source>more than %1</source>
        <translation>mehr als %1</translation>
    </message>
    <message>
        <source>more than 10^19</source>
        <translation>mehr als 10^19</translation>
    </message>
    <message>
        <source>more than the depth before</source>
        <translation>mehr als die Tiefe davor</translation>
    </message>
    <message>
        <source>move it to where there is anatomy</source>
        <translation>dorthin verschieben, wo Anatomie ist</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>bewegten</translation>
    </message>
    <message>
        <source>name one of those frames as the target, or give the device set (.xml) that leads on</source>
        <translation>eines dieser Bezugssysteme als Ziel nennen oder die Kalibrierung (.xml) angeben, die weiterführt</translation>
    </message>
    <message>
        <source>names from the %1 of the recipe that this one extends</source>
        <translation>Namen aus %1 des Rezepts, das dieses erweitert</translation>
    </message>
    <message>
        <source>nested too deeply</source>
        <translation>zu tief geschachtelt</translation>
    </message>
    <message>
        <source>no</source>
        <translation>keine Art</translation>
    </message>
    <message>
        <source>no 8 bit PGM</source>
        <translation>kein PGM mit 8 Bit</translation>
    </message>
    <message>
        <source>no R peaks stand out of the noise (%1 times its spread, %2 are needed)</source>
        <translation>keine R-Zacken ragen aus dem Rauschen (das %1-Fache seiner Streuung, nötig ist das %2-Fache)</translation>
    </message>
    <message>
        <source>no binary PGM</source>
        <translation>kein binäres PGM</translation>
    </message>
    <message>
        <source>no free name beside it</source>
        <translation>kein freier Name daneben</translation>
    </message>
    <message>
        <source>no parameter at all: this recipe has none</source>
        <translation>gar kein Parameter: Dieses Rezept hat keinen</translation>
    </message>
    <message>
        <source>no part of the centre line lies inside</source>
        <translation>kein Teil der Mittellinie liegt innen</translation>
    </message>
    <message>
        <source>no reason given</source>
        <translation>kein Grund genannt</translation>
    </message>
    <message>
        <source>no reason was given</source>
        <translation>ohne Angabe eines Grundes</translation>
    </message>
    <message>
        <source>no such measurement</source>
        <translation>keine solche Messung</translation>
    </message>
    <message>
        <source>no such organ</source>
        <translation>kein solches Organ</translation>
    </message>
    <message>
        <source>no such standard plane</source>
        <translation>keine solche Standardebene</translation>
    </message>
    <message>
        <source>no whole number</source>
        <translation>keine ganze Zahl</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>not 1 to 3000 mm above lowest_mm</source>
        <translation>nicht 1 bis 3000 mm über lowest_mm</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>keine Zahl</translation>
    </message>
    <message>
        <source>not a usable name</source>
        <translation>kein brauchbarer Name</translation>
    </message>
    <message>
        <source>not above the section before it</source>
        <translation>nicht über dem Querschnitt davor</translation>
    </message>
    <message>
        <source>not aligned</source>
        <translation>nicht ausgerichtet</translation>
    </message>
    <message>
        <source>not below from_depth_mm</source>
        <translation>nicht unter from_depth_mm</translation>
    </message>
    <message>
        <source>not known here</source>
        <translation>hier nicht bekannt</translation>
    </message>
    <message>
        <source>not positive</source>
        <translation>nicht positiv</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>nothing in it repeats (correlation %1 after one period, %2 is needed)</source>
        <translation>nichts darin wiederholt sich (Korrelation %1 nach einer Periode, nötig ist %2)</translation>
    </message>
    <message>
        <source>nothing in them repeats at %1 to %2 times a minute (confidence %3, %4 is needed)</source>
        <translation>nichts in ihnen wiederholt sich %1- bis %2-mal je Minute (Verlässlichkeit %3, nötig ist %4)</translation>
    </message>
    <message>
        <source>nothing of %1 is found</source>
        <translation>von %1 ist nichts zu finden</translation>
    </message>
    <message>
        <source>nothing usable</source>
        <translation>nichts Brauchbares</translation>
    </message>
    <message>
        <source>number %1</source>
        <translation>Nummer %1</translation>
    </message>
    <message>
        <source>of mirror images</source>
        <translation>für Spiegelbilder</translation>
    </message>
    <message>
        <source>of the probe&apos;s own thickness</source>
        <translation>als Vielfaches der Schichtdicke des Schallkopfs</translation>
    </message>
    <message>
        <source>one entry for each pair of volumes</source>
        <translation>ein Eintrag je Volumenpaar</translation>
    </message>
    <message>
        <source>one finite vector</source>
        <translation>ein endlicher Vektor</translation>
    </message>
    <message>
        <source>one number per axis</source>
        <translation>eine Zahl je Achse</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>eines von %1</translation>
    </message>
    <message>
        <source>one of at most %1</source>
        <translation>einer von höchstens %1</translation>
    </message>
    <message>
        <source>one of capsule, difference, ellipsoid, grown, half_space, intersection, loft, of, patches, rough, septa, sheets, shell, tube, union, vessel_tree, vessels_beside</source>
        <translation>eines von capsule, difference, ellipsoid, grown, half_space, intersection, loft, of, patches, rough, septa, sheets, shell, tube, union, vessel_tree, vessels_beside</translation>
    </message>
    <message>
        <source>one of its numbers is not finite</source>
        <translation>eine ihrer Zahlen ist nicht endlich</translation>
    </message>
    <message>
        <source>one of the tissues (%1)</source>
        <translation>eines der Gewebe (%1)</translation>
    </message>
    <message>
        <source>one of them</source>
        <translation>eines davon</translation>
    </message>
    <message>
        <source>one or three spacings are needed</source>
        <translation>ein oder drei Abstände sind nötig</translation>
    </message>
    <message>
        <source>one shape</source>
        <translation>eine einzige Form</translation>
    </message>
    <message>
        <source>one solid too many with those of the organs before it</source>
        <translation>mit denen der Organe davor ein Volumenkörper zu viel</translation>
    </message>
    <message>
        <source>one station, from which the motor starts</source>
        <translation>eine einzige Station, von der der Motor ausgeht</translation>
    </message>
    <message>
        <source>one surface without the other</source>
        <translation>eine Oberfläche ohne die andere</translation>
    </message>
    <message>
        <source>one vector or none per axis</source>
        <translation>ein Vektor oder none je Achse</translation>
    </message>
    <message>
        <source>one way</source>
        <translation>einfacher Weg</translation>
    </message>
    <message>
        <source>one whole number per axis</source>
        <translation>eine ganze Zahl je Achse</translation>
    </message>
    <message>
        <source>one whole number per axis, none negative,</source>
        <translation>eine ganze Zahl je Achse, keine negativ</translation>
    </message>
    <message>
        <source>one whole number per dimension</source>
        <translation>eine ganze Zahl je Dimension</translation>
    </message>
    <message>
        <source>one whole number per dimension, none negative,</source>
        <translation>eine ganze Zahl je Dimension, keine negativ</translation>
    </message>
    <message>
        <source>only in a recipe that extends another</source>
        <translation>nur in einem Rezept, das ein anderes erweitert</translation>
    </message>
    <message>
        <source>other bits</source>
        <translation>eine andere Zahl von Bit</translation>
    </message>
    <message>
        <source>other lengths or angles</source>
        <translation>andere Längen oder Winkel</translation>
    </message>
    <message>
        <source>parameters of which at most %1 rest on one another in a row</source>
        <translation>Parameter, von denen höchstens %1 der Reihe nach aufeinander beruhen</translation>
    </message>
    <message>
        <source>parameters that do not depend on one another in a circle, as %1 does</source>
        <translation>Parameter, die nicht im Kreis voneinander abhängen, wie %1 es tut</translation>
    </message>
    <message>
        <source>patient field</source>
        <translation>Patientenfeld</translation>
    </message>
    <message>
        <source>plane angles (C300/0001)</source>
        <translation>Ebenenwinkel (C300/0001)</translation>
    </message>
    <message>
        <source>planes (C000/0003)</source>
        <translation>Zahl der Ebenen (C000/0003)</translation>
    </message>
    <message>
        <source>put a station between the two, or swap the sign of lateral</source>
        <translation>eine Station dazwischen setzen oder das Vorzeichen von lateral umkehren</translation>
    </message>
    <message>
        <source>puts the probe at %1, outside the patient&apos;s box from %2 to %3</source>
        <translation>setzt den Schallkopf auf %1, außerhalb des Patientenquaders von %2 bis %3</translation>
    </message>
    <message>
        <source>radius of the first sample (C200/0001)</source>
        <translation>Radius des ersten Abtastwerts (C200/0001)</translation>
    </message>
    <message>
        <source>radius of the planes (C200/0002)</source>
        <translation>Radius der Ebenen (C200/0002)</translation>
    </message>
    <message>
        <source>rescaled with a slope that is not positive</source>
        <translation>umgerechnet mit einer Steigung, die nicht positiv ist</translation>
    </message>
    <message>
        <source>respiration signal</source>
        <translation>Atemsignal</translation>
    </message>
    <message>
        <source>samples along a beam (C000/0001)</source>
        <translation>Zahl der Abtastwerte je Strahl (C000/0001)</translation>
    </message>
    <message>
        <source>seconds across the strip</source>
        <translation>Sekunden über den Streifen</translation>
    </message>
    <message>
        <source>sections by rising z_mm</source>
        <translation>Querschnitte mit steigendem z_mm</translation>
    </message>
    <message>
        <source>segments that do not fit together</source>
        <translation>Segmente, die nicht zusammenpassen</translation>
    </message>
    <message>
        <source>sequences are nested too deeply</source>
        <translation>Sequenzen sind zu tief geschachtelt</translation>
    </message>
    <message>
        <source>set but not there</source>
        <translation>gesetzt, aber nicht vorhanden</translation>
    </message>
    <message>
        <source>shift across the beam</source>
        <translation>Verschiebung quer zum Strahl</translation>
    </message>
    <message>
        <source>shift along the beam</source>
        <translation>Verschiebung längs des Strahls</translation>
    </message>
    <message>
        <source>six direction cosines</source>
        <translation>sechs Richtungskosinus</translation>
    </message>
    <message>
        <source>small letters, digits and _, and neither min nor max</source>
        <translation>kleine Buchstaben, Ziffern und _, und weder min noch max</translation>
    </message>
    <message>
        <source>so long that it would fold the tissue where it fades</source>
        <translation>so lang, dass sich das Gewebe falten würde, wo die Bewegung ausläuft</translation>
    </message>
    <message>
        <source>spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>subvolume %1</source>
        <translation>Teilvolumen %1</translation>
    </message>
    <message>
        <source>sweep file</source>
        <translation>Schwenkdatei</translation>
    </message>
    <message>
        <source>tables of different lengths</source>
        <translation>Tabellen verschiedener Länge</translation>
    </message>
    <message>
        <source>text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>text on one line, without blanks around it,</source>
        <translation>Text in einer Zeile, ohne Leerzeichen außen</translation>
    </message>
    <message>
        <source>text, such as &quot;two years ago&quot;</source>
        <translation>Text, etwa &quot;two years ago&quot;</translation>
    </message>
    <message>
        <source>text, such as &quot;ultrasound&quot;</source>
        <translation>Text, etwa &quot;ultrasound&quot;</translation>
    </message>
    <message>
        <source>the ABI number of the SDK, a whole number from 0 to 4294967295</source>
        <translation>die ABI-Nummer des SDK, eine ganze Zahl von 0 bis 4294967295</translation>
    </message>
    <message>
        <source>the Matrix of %1 to %2</source>
        <translation>die Matrix von %1 zu %2</translation>
    </message>
    <message>
        <source>the body region in words, at most 200 characters</source>
        <translation>die Körperregion in Worten, höchstens 200 Zeichen</translation>
    </message>
    <message>
        <source>the centre line is not inside there, or runs along the direction</source>
        <translation>die Mittellinie liegt dort nicht innen oder verläuft entlang der Richtung</translation>
    </message>
    <message>
        <source>the device set given has no transform from or to Image, give the one this sweep was recorded with</source>
        <translation>die angegebene Kalibrierung hat keine Transformation von oder zu Image; die angeben, mit der dieser Schwenk aufgenommen wurde</translation>
    </message>
    <message>
        <source>the face&apos;s -x end to its +x end</source>
        <translation>vom Ende der Schallkopffläche bei -x bis zu dem bei +x</translation>
    </message>
    <message>
        <source>the file name of the library in the same folder</source>
        <translation>der Dateiname der Bibliothek im selben Ordner</translation>
    </message>
    <message>
        <source>the film could not be begun</source>
        <translation>der Film ließ sich nicht beginnen</translation>
    </message>
    <message>
        <source>the format number, a whole number from 1</source>
        <translation>die Formatnummer, eine ganze Zahl ab 1</translation>
    </message>
    <message>
        <source>the licence of the recording, such as &quot;CC BY 4.0&quot;, at most 200 characters</source>
        <translation>die Lizenz der Aufnahme, etwa &quot;CC BY 4.0&quot;, höchstens 200 Zeichen</translation>
    </message>
    <message>
        <source>the medium is full or gone</source>
        <translation>der Datenträger ist voll oder weg</translation>
    </message>
    <message>
        <source>the motor file %1</source>
        <translation>Motordatei %1</translation>
    </message>
    <message>
        <source>the name of a file beside this one or in resources/anatomy, without a folder</source>
        <translation>der Name einer Datei neben dieser oder in resources/anatomy, ohne Ordner</translation>
    </message>
    <message>
        <source>the name of a file beside this one or in resources/mannequin, without a folder</source>
        <translation>der Name einer Datei neben dieser oder in resources/mannequin, ohne Ordner</translation>
    </message>
    <message>
        <source>the name of a file in resources/mannequin, without a folder</source>
        <translation>der Name einer Datei in resources/mannequin, ohne Ordner</translation>
    </message>
    <message>
        <source>the name of a parameter in place of &quot;%1&quot;</source>
        <translation>der Name eines Parameters anstelle von „%1“</translation>
    </message>
    <message>
        <source>the name of a shape or organ</source>
        <translation>der Name einer Form oder eines Organs</translation>
    </message>
    <message>
        <source>the name of a shape or organ that is an ellipsoid</source>
        <translation>der Name einer Form oder eines Organs, das ein Ellipsoid ist</translation>
    </message>
    <message>
        <source>the name of a shape or organ that is a tube</source>
        <translation>der Name einer Form oder eines Organs, das ein Rohr ist</translation>
    </message>
    <message>
        <source>the name of a shipped probe, such as convex-3.5, without folder and ending</source>
        <translation>der Name eines mitgelieferten Schallkopfs, etwa convex-3.5, ohne Ordner und Endung</translation>
    </message>
    <message>
        <source>the name of a vessel_tree</source>
        <translation>der Name eines vessel_tree</translation>
    </message>
    <message>
        <source>the name of a volume or sweep file</source>
        <translation>der Name einer Volumen- oder Schwenkdatei</translation>
    </message>
    <message>
        <source>the name of an organ of the patient</source>
        <translation>der Name eines Organs des Patienten</translation>
    </message>
    <message>
        <source>the name of another of the %1</source>
        <translation>der Name eines anderen Eintrags in %1</translation>
    </message>
    <message>
        <source>the name of one of the planes</source>
        <translation>der Name einer der Ebenen</translation>
    </message>
    <message>
        <source>the name of one of the project&apos;s volumes</source>
        <translation>der Name eines der Volumen des Projekts</translation>
    </message>
    <message>
        <source>the number of components</source>
        <translation>die Zahl der Komponenten</translation>
    </message>
    <message>
        <source>the number of frames</source>
        <translation>die Zahl der Bilder</translation>
    </message>
    <message>
        <source>the offset is no count of bytes</source>
        <translation>der Versatz ist keine Anzahl Byte</translation>
    </message>
    <message>
        <source>the pair %1</source>
        <translation>das Paar %1</translation>
    </message>
    <message>
        <source>the part of the body that is drawn</source>
        <translation>der Teil des Körpers, der gezeichnet wird</translation>
    </message>
    <message>
        <source>the pixels hold something that is no fragment</source>
        <translation>die Pixel enthalten etwas, das kein Fragment ist</translation>
    </message>
    <message>
        <source>the probe file %1</source>
        <translation>Schallkopfdatei %1</translation>
    </message>
    <message>
        <source>the probe&apos;s own</source>
        <translation>die des Schallkopfs</translation>
    </message>
    <message>
        <source>the range the volume was recorded with</source>
        <translation>den Umfang, mit dem das Volumen aufgenommen wurde</translation>
    </message>
    <message>
        <source>the recording holds no tracked poses, so it cannot be placed: choose one recorded with a tracker, or say how a motor moved the probe</source>
        <translation>die Aufnahme enthält keine verfolgten Lagen und kann nicht platziert werden: eine wählen, die mit einem Tracker aufgenommen wurde, oder angeben, wie ein Motor den Schallkopf bewegt hat</translation>
    </message>
    <message>
        <source>the recording is shorter than three cycles or has gaps of many times its length</source>
        <translation>die Aufnahme ist kürzer als drei Zyklen oder hat Lücken von einem Vielfachen ihrer Länge</translation>
    </message>
    <message>
        <source>the sample type</source>
        <translation>die Art der Abtastwerte</translation>
    </message>
    <message>
        <source>the scene of case.json</source>
        <translation>Szene von case.json</translation>
    </message>
    <message>
        <source>the schema of the section &apos;%1&apos;</source>
        <translation>Schema des Abschnitts „%1“</translation>
    </message>
    <message>
        <source>the stitch project</source>
        <translation>Stitching-Projekt</translation>
    </message>
    <message>
        <source>the tracker&apos;s pose of %1</source>
        <translation>die Lage von %1 nach dem Tracker</translation>
    </message>
    <message>
        <source>the type is not known</source>
        <translation>der Typ ist nicht bekannt</translation>
    </message>
    <message>
        <source>the upper corner of the box</source>
        <translation>die obere Ecke des Quaders</translation>
    </message>
    <message>
        <source>the voxel size along axis %1</source>
        <translation>die Voxelgröße entlang der Achse %1</translation>
    </message>
    <message>
        <source>there and back</source>
        <translation>hin und zurück</translation>
    </message>
    <message>
        <source>there are fewer than eight frames at different times</source>
        <translation>es sind weniger als acht Bilder zu verschiedenen Zeiten</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>der Speicher reicht nicht</translation>
    </message>
    <message>
        <source>there is something of that name</source>
        <translation>den Namen gibt es dort schon</translation>
    </message>
    <message>
        <source>there unless &quot;%1&quot; is, and not beside it: one of the two says where the frames lie</source>
        <translation>eine Angabe genau dann, wenn „%1“ fehlt (eines von beiden sagt, wo die Bilder liegen)</translation>
    </message>
    <message>
        <source>they do not change</source>
        <translation>sie ändern sich nicht</translation>
    </message>
    <message>
        <source>three dimensions are needed</source>
        <translation>drei Dimensionen sind nötig</translation>
    </message>
    <message>
        <source>three numbers above 0 (mm)</source>
        <translation>drei Zahlen über 0 (mm)</translation>
    </message>
    <message>
        <source>three numbers from %1 to %2</source>
        <translation>drei Zahlen von %1 bis %2</translation>
    </message>
    <message>
        <source>three numbers in mm</source>
        <translation>drei Zahlen in mm</translation>
    </message>
    <message>
        <source>three numbers within 1000 m</source>
        <translation>drei Zahlen innerhalb von 1000 m</translation>
    </message>
    <message>
        <source>three numbers, [x, y, z] in mm</source>
        <translation>drei Zahlen, [x, y, z] in mm</translation>
    </message>
    <message>
        <source>three numbers, in mm</source>
        <translation>drei Zahlen, in mm</translation>
    </message>
    <message>
        <source>three numbers, mm in the world</source>
        <translation>drei Zahlen, mm in der Welt</translation>
    </message>
    <message>
        <source>three numbers, mm in the world, of a point</source>
        <translation>drei Zahlen, mm in der Welt, bei einem Punkt</translation>
    </message>
    <message>
        <source>left out in a recipe that another extends</source>
        <translation>weggelassen in einem Rezept, das ein anderes erweitert</translation>
    </message>
    <message>
        <source>lines of more than %1 points</source>
        <translation>Linien aus mehr als %1 Punkten</translation>
    </message>
    <message>
        <source>[x, y, z] in mm, or [x, y, z, share] with a share of the height from 0 to 1</source>
        <translation>[x, y, z] in mm oder [x, y, z, Anteil] mit einem Anteil der Höhe von 0 bis 1</translation>
    </message>
    <message>
        <source>three of one length</source>
        <translation>drei gleich lange</translation>
    </message>
    <message>
        <source>three or four parts are needed</source>
        <translation>drei oder vier Teile sind nötig</translation>
    </message>
    <message>
        <source>three radii of at least 0.01 mm</source>
        <translation>drei Radien von mindestens 0,01 mm</translation>
    </message>
    <message>
        <source>three sizes of at least 0.1 mm</source>
        <translation>drei Größen von mindestens 0,1 mm</translation>
    </message>
    <message>
        <source>three sizes of at least 0.2 mm</source>
        <translation>drei Größen von mindestens 0,2 mm</translation>
    </message>
    <message>
        <source>tissue</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>too few</source>
        <translation>zu wenige</translation>
    </message>
    <message>
        <source>too long</source>
        <translation>zu lang</translation>
    </message>
    <message>
        <source>too many branches of vessels</source>
        <translation>zu viele Gefäßäste</translation>
    </message>
    <message>
        <source>too many for an organ of so many solids</source>
        <translation>zu viele für ein Organ aus so vielen Körpern</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>true or false: whether the name gives a finding away, so that a trainee sees it with the findings</source>
        <translation>true oder false: ob der Name einen Befund verrät, sodass Lernende ihn erst mit den Befunden sehen</translation>
    </message>
    <message>
        <source>true, false or an object of its parameters</source>
        <translation>true, false oder ein Objekt mit den Parametern</translation>
    </message>
    <message>
        <source>turns the image by more than a hand can on the way from the station before</source>
        <translation>dreht das Bild auf dem Weg von der Station davor um mehr, als eine Hand es kann</translation>
    </message>
    <message>
        <source>two frame names that &quot;To&quot; joins in one way only</source>
        <translation>zwei Namen von Bezugssystemen, die „To“ auf nur eine Weise verbindet</translation>
    </message>
    <message>
        <source>two heights at least 1 mm apart</source>
        <translation>zwei Höhen mit mindestens 1 mm Abstand</translation>
    </message>
    <message>
        <source>two lengths above 0 mm</source>
        <translation>zwei Längen über 0 mm</translation>
    </message>
    <message>
        <source>two numbers from 0.0001 to 100, a pixel&apos;s width and height in mm</source>
        <translation>zwei Zahlen von 0,0001 bis 100, Breite und Höhe eines Pixels in mm</translation>
    </message>
    <message>
        <source>two numbers within a million, the pixel at the middle of the face</source>
        <translation>zwei Zahlen von höchstens einer Million, das Pixel in der Mitte der Schallkopffläche</translation>
    </message>
    <message>
        <source>two places at most %1 mm apart</source>
        <translation>zwei höchstens %1 mm voneinander entfernte Orte</translation>
    </message>
    <message>
        <source>two sizes from %1 to %2</source>
        <translation>zwei Größen von %1 bis %2</translation>
    </message>
    <message>
        <source>two surfaces</source>
        <translation>zwei Oberflächen</translation>
    </message>
    <message>
        <source>two unit vectors at right angles</source>
        <translation>zwei Einheitsvektoren im rechten Winkel</translation>
    </message>
    <message>
        <source>two-dimensional, neither tissue nor flow</source>
        <translation>zweidimensional, weder Gewebe noch Fluss</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>eine unbekannte Art</translation>
    </message>
    <message>
        <source>vectors longer than 0</source>
        <translation>Vektoren länger als 0</translation>
    </message>
    <message>
        <source>virtual patient</source>
        <translation>Rezept des virtuellen Patienten</translation>
    </message>
    <message>
        <source>what grey 0 to 255 spans</source>
        <translation>was Grau 0 bis 255 umspannt</translation>
    </message>
    <message>
        <source>what the machine compensates</source>
        <translation>was das Gerät ausgleicht</translation>
    </message>
    <message>
        <source>what was just written cannot be read</source>
        <translation>das eben Geschriebene lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>what was just written is gone</source>
        <translation>was eben geschrieben wurde, ist verschwunden</translation>
    </message>
    <message>
        <source>where the amplifier ends</source>
        <translation>wo der Verstärker endet</translation>
    </message>
    <message>
        <source>where the compensation ends</source>
        <translation>wo der Ausgleich endet</translation>
    </message>
    <message>
        <source>whom to name for the recording, in words, at most 1000 characters</source>
        <translation>wer für die Aufnahme zu nennen ist, in Worten, höchstens 1000 Zeichen</translation>
    </message>
    <message>
        <source>with %1 frames a second the rhythm falls between them</source>
        <translation>bei %1 Bildern je Sekunde fällt der Rhythmus dazwischen</translation>
    </message>
    <message>
        <source>with %1 samples a second R peaks fall between them</source>
        <translation>bei %1 Abtastwerten je Sekunde fallen die R-Zacken dazwischen</translation>
    </message>
    <message>
        <source>with all it extends a list of more than %1 entries</source>
        <translation>mit allem, was es erweitert, eine Liste von mehr als %1 Einträgen</translation>
    </message>
    <message>
        <source>with depth</source>
        <translation>mit der Tiefe</translation>
    </message>
    <message>
        <source>without a shape</source>
        <translation>ohne Form</translation>
    </message>
    <message>
        <source>written as text</source>
        <translation>als Text geschrieben</translation>
    </message>
    <message>
        <source>zero</source>
        <translation>null</translation>
    </message>
    <message>
        <source>of the patient's own motion</source>
        <translation>der eigenen Bewegung des Patienten</translation>
    </message>
    <message>
        <source>a number from 0 to 1 (of the patient's own motion)</source>
        <translation>eine Zahl von 0 bis 1 (der eigenen Bewegung des Patienten)</translation>
    </message>
    <message>
        <source>breath, pulse and bowel, three numbers from 0 to 1</source>
        <translation>Atem, Puls und Darm, drei Zahlen von 0 bis 1</translation>
    </message>
    <message>
        <source>Finding how the patient moves</source>
        <translation>Die Bewegung des Patienten wird bestimmt</translation>
    </message>
    <message>
        <source>less, so that the chamber is not folded</source>
        <translation>weniger, damit sich die Kammer nicht faltet</translation>
    </message>
    <message>
        <source>less sway, a longer fade_mm or a longer wave, so that no tissue is folded</source>
        <translation>weniger Bewegung, ein längeres fade_mm oder eine längere Welle, damit sich kein Gewebe faltet</translation>
    </message>
    <message>
        <source>There are %1 times and %2 poses; give one time, one pose, or as many of one as of the other.</source>
        <translation>Es sind %1 Zeiten und %2 Posen; geben Sie eine Zeit, eine Pose oder von beiden gleich viele an.</translation>
    </message>
    <message>
        <source>The body stands still, because the scene has no live echoes or no motion; give one with --scene.</source>
        <translation>Der Körper steht still, weil die Szene keine lebendigen Echos oder keine Bewegung hat; geben Sie eine mit --scene an.</translation>
    </message>
    <message>
        <source>This case does not move; --time, --breath and --pulse change nothing.</source>
        <translation>Dieser Fall bewegt sich nicht; --time, --breath und --pulse ändern nichts.</translation>
    </message>
    <message>
        <source>Both points lie on each other; move one of them.</source>
        <translation>Beide Punkte liegen aufeinander; einen davon verschieben.</translation>
    </message>
    <message>
        <source>One axis of the ellipse has no length; move one of its ends.</source>
        <translation>Eine Achse der Ellipse hat keine Länge; eines ihrer Enden verschieben.</translation>
    </message>
    <message>
        <source>The ellipse did not settle; more points around the outline would hold it.</source>
        <translation>Die Ellipse kam nicht zur Ruhe; mehr Punkte um den Umriss würden sie halten.</translation>
    </message>
    <message>
        <source>The outline crosses itself, so its area is too small; trace it again.</source>
        <translation>Der Umriss kreuzt sich selbst, seine Fläche ist daher zu klein; neu umfahren.</translation>
    </message>
    <message>
        <source>One leg of the angle has no length; move one of its ends.</source>
        <translation>Ein Schenkel des Winkels hat keine Länge; eines seiner Enden verschieben.</translation>
    </message>
    <message>
        <source>Distance %1 has no length; move one of its ends.</source>
        <translation>Strecke %1 hat keine Länge; eines ihrer Enden verschieben.</translation>
    </message>
    <message>
        <source>The long axis has no length; move one of its ends.</source>
        <translation>Die Längsachse hat keine Länge; eines ihrer Enden verschieben.</translation>
    </message>
    <message>
        <source>The outline does not lie along its long axis; draw the axis through it.</source>
        <translation>Der Umriss liegt nicht an seiner Längsachse; die Achse durch ihn hindurch zeichnen.</translation>
    </message>
    <message>
        <source>The long axes of both planes differ by more than a fifth; one of them may be cut short.</source>
        <translation>Die Längsachsen beider Ebenen unterscheiden sich um mehr als ein Fünftel; eine davon ist vielleicht verkürzt getroffen.</translation>
    </message>
    <message>
        <source>Both points lie at the same moment; move one of them.</source>
        <translation>Beide Punkte liegen im selben Augenblick; einen davon verschieben.</translation>
    </message>
    <message>
        <source>This kind of caliper is not known.</source>
        <translation>Diese Art von Messung ist nicht bekannt.</translation>
    </message>
    <message>
        <source>A caliper of the kind &apos;%1&apos; has %2 parts, this one has %3.</source>
        <translation>Eine Messung der Art „%1“ hat %2 Teile, diese hat %3.</translation>
    </message>
    <message>
        <source>A caliper of the kind &apos;%1&apos; has %2 to %3 points in a part, this one has %4.</source>
        <translation>Eine Messung der Art „%1“ hat %2 bis %3 Punkte in einem Teil, diese hat %4.</translation>
    </message>
    <message>
        <source>A point of a caliper lies nowhere; set it again.</source>
        <translation>Ein Punkt einer Messung liegt nirgends; neu setzen.</translation>
    </message>
    <message>
        <source>A heart rate is measured over 1 to %1 cycles, not over %2.</source>
        <translation>Eine Herzfrequenz wird über 1 bis %1 Zyklen gemessen, nicht über %2.</translation>
    </message>
    <message>
        <source>No ellipse goes through these points; put them around the outline, not along a line.</source>
        <translation>Durch diese Punkte geht keine Ellipse; sie rund um den Umriss setzen, nicht auf eine Linie.</translation>
    </message>
    <message>
        <source>An ellipse needs at least %1 points; there are %2.</source>
        <translation>Eine Ellipse braucht mindestens %1 Punkte; es sind %2.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be the name of an input: it needs a letter, then letters, digits and _.</source>
        <translation>„%1“ kann keine Eingangsgröße benennen: nötig sind ein Buchstabe, dann Buchstaben, Ziffern und _.</translation>
    </message>
    <message>
        <source>The expression uses &apos;%1&apos;, which is neither an input nor a function known here.</source>
        <translation>Der Ausdruck verwendet „%1“, weder eine Eingangsgröße noch eine hier bekannte Funktion.</translation>
    </message>
    <message>
        <source>The expression does not use its input &apos;%1&apos;.</source>
        <translation>Der Ausdruck verwendet seine Eingangsgröße „%1“ nicht.</translation>
    </message>
    <message>
        <source>An expression has 1 to %1 bytes, this one has %2.</source>
        <translation>Ein Ausdruck hat 1 bis %1 Bytes, dieser hat %2.</translation>
    </message>
    <message>
        <source>The expression has a character at %1 that has no place in a formula.</source>
        <translation>Der Ausdruck hat an Stelle %1 ein Zeichen, das nicht in eine Formel gehört.</translation>
    </message>
    <message>
        <source>The expression cannot be read: %1</source>
        <translation>Der Ausdruck kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>Measurement %1 was made for %2, but gives no %3; measure it with another caliper.</source>
        <translation>Messung %1 wurde für %2 gemacht, ergibt aber keinen Wert der Art %3; mit einer anderen Messart messen.</translation>
    </message>
    <message>
        <source>two numbers, a point</source>
        <translation>zwei Zahlen, ein Punkt</translation>
    </message>
    <message>
        <source>a list of %1 to %2 points</source>
        <translation>eine Liste von %1 bis %2 Punkten</translation>
    </message>
    <message>
        <source>%1 has format %2, this program reads up to %3; update EchoWeave.</source>
        <translation>%1 hat das Format %2, dieses Programm liest Formate bis %3; EchoWeave aktualisieren.</translation>
    </message>
    <message>
        <source>a whole number from 1 to below next_number</source>
        <translation>eine ganze Zahl ab 1, kleiner als next_number</translation>
    </message>
    <message>
        <source>a number that no other measurement has</source>
        <translation>eine Nummer, die keine andere Messung hat</translation>
    </message>
    <message>
        <source>the measurement package %1</source>
        <translation>Messpaket %1</translation>
    </message>
    <message>
        <source>a letter, then letters, digits and _</source>
        <translation>ein Buchstabe, dann Buchstaben, Ziffern und _</translation>
    </message>
    <message>
        <source>a unit: 1, %, mm, cm, mm2, cm2, ml, g, kg, deg, s, ms, /min, mm/s, cm/s, weeks or days</source>
        <translation>eine Einheit: 1, %, mm, cm, mm2, cm2, ml, g, kg, deg, s, ms, /min, mm/s, cm/s, weeks oder days</translation>
    </message>
    <message>
        <source>two rising numbers, the smallest and the largest value</source>
        <translation>zwei steigende Zahlen, der kleinste und der größte Wert</translation>
    </message>
    <message>
        <source>left out of a choice</source>
        <translation>bei einer Auswahl weggelassen</translation>
    </message>
    <message>
        <source>left out, unless the measure is &quot;choice&quot;</source>
        <translation>weggelassen, außer bei der Messgröße &quot;choice&quot;</translation>
    </message>
    <message>
        <source>a label that no other entry has</source>
        <translation>ein Kürzel, das kein anderer Eintrag hat</translation>
    </message>
    <message>
        <source>the label of an item with a unit or of an earlier formula</source>
        <translation>das Kürzel eines Eintrags mit Einheit oder einer früheren Formel</translation>
    </message>
    <message>
        <source>a unit that %1 can be converted to</source>
        <translation>eine Einheit, in die sich %1 umrechnen lässt</translation>
    </message>
    <message>
        <source>an object with either &quot;percent&quot; or &quot;absolute&quot;</source>
        <translation>ein Objekt mit entweder &quot;percent&quot; oder &quot;absolute&quot;</translation>
    </message>
    <message>
        <source>%1, which the expression gives; correct the one that is wrong</source>
        <translation>%1, wie es der Ausdruck ergibt; den falschen von beiden berichtigen</translation>
    </message>
    <message>
        <source>the label of an item whose unit the result can be converted to</source>
        <translation>das Kürzel eines Eintrags, in dessen Einheit sich das Ergebnis umrechnen lässt</translation>
    </message>
    <message>
        <source>labels of formulas whose results can be converted to the chart&apos;s unit</source>
        <translation>Kürzel von Formeln, deren Ergebnisse sich in die Einheit der Kurve umrechnen lassen</translation>
    </message>
    <message>
        <source>left out of a chart with &quot;lms&quot;</source>
        <translation>bei einer Kurve mit &quot;lms&quot; weggelassen</translation>
    </message>
    <message>
        <source>left out, unless the chart has &quot;lms&quot;</source>
        <translation>weggelassen, außer bei einer Kurve mit &quot;lms&quot;</translation>
    </message>
    <message>
        <source>%1, which the chart gives; correct the one that is wrong</source>
        <translation>%1, wie es die Kurve ergibt; den falschen von beiden berichtigen</translation>
    </message>
    <message>
        <source>the label of an item with a unit or of a formula</source>
        <translation>das Kürzel eines Eintrags mit Einheit oder einer Formel</translation>
    </message>
    <message>
        <source>a number, when there is no &quot;low&quot;</source>
        <translation>eine Zahl, wenn &quot;low&quot; fehlt</translation>
    </message>
    <message>
        <source>labels of formulas that give a gestational age</source>
        <translation>Kürzel von Formeln, die ein Gestationsalter ergeben</translation>
    </message>
    <message>
        <source>labels of choices</source>
        <translation>Kürzel von Auswahlen</translation>
    </message>
    <message>
        <source>a word of the choices</source>
        <translation>ein Wort der Auswahl</translation>
    </message>
    <message>
        <source>the label of an item or a formula</source>
        <translation>das Kürzel eines Eintrags oder einer Formel</translation>
    </message>
    <message>
        <source>There is not enough memory to trace in this picture.</source>
        <translation>Der Speicher reicht nicht, um in diesem Bild Umrisse zu verfolgen.</translation>
    </message>
    <message>
        <source>The edges of the picture could not be traced (%1).</source>
        <translation>Die Kanten des Bildes konnten nicht verfolgt werden (%1).</translation>
    </message>
    <message>
        <source>The picture is too small to trace in: %1 x %2 pixels.</source>
        <translation>Das Bild ist zu klein, um darin Umrisse zu verfolgen: %1 x %2 Pixel.</translation>
    </message>
    <message>
        <source>The picture is too large to trace in: %1 x %2 pixels.</source>
        <translation>Das Bild ist zu groß, um darin Umrisse zu verfolgen: %1 x %2 Pixel.</translation>
    </message>
    <message>
        <source>There is no picture to trace in; freeze one first.</source>
        <translation>Es gibt kein Bild, in dem Umrisse verfolgt werden können; zuerst eines einfrieren.</translation>
    </message>
    <message>
        <source>A trace has no beginning yet; click where it begins.</source>
        <translation>Der Umriss hat noch keinen Anfang; dort klicken, wo er beginnt.</translation>
    </message>
    <message>
        <source>An outline needs at least three clicks; there are %1.</source>
        <translation>Ein Umriss braucht mindestens drei Klicks; es sind %1.</translation>
    </message>
    <message>
        <source>The package %1 has no item &apos;%2&apos;; it has %3.</source>
        <translation>Das Messpaket %1 hat keinen Eintrag „%2“; es hat %3.</translation>
    </message>
    <message>
        <source>%1 is measured on the right and on the left; say which, as in %1/right.</source>
        <translation>%1 wird rechts und links gemessen; die Seite angeben, wie in %1/right.</translation>
    </message>
    <message>
        <source>%1 has no sides; leave &apos;%2&apos; out.</source>
        <translation>%1 hat keine Seiten; „%2“ weglassen.</translation>
    </message>
    <message>
        <source>%1 is answered by one of %2.</source>
        <translation>%1 wird mit einem von %2 beantwortet.</translation>
    </message>
    <message>
        <source>%1 is measured in %2, not in &apos;%3&apos;.</source>
        <translation>%1 wird in %2 gemessen, nicht in „%3“.</translation>
    </message>
    <message>
        <source>%1 of %2 cannot be right: it lies from %3 to %4; check the value and its unit.</source>
        <translation>%1 von %2 kann nicht stimmen: möglich ist %3 bis %4; Wert und Einheit prüfen.</translation>
    </message>
    <message>
        <source>%1 is valid for %2 from %3 to %4; %5 lies outside, so nothing is computed.</source>
        <translation>%1 gilt für %2 von %3 bis %4; %5 liegt außerhalb, daher wird nichts berechnet.</translation>
    </message>
    <message>
        <source>%1 has no result for these values.</source>
        <translation>%1 hat für diese Werte kein Ergebnis.</translation>
    </message>
    <message>
        <source>%1 is valid for results from %2 to %3; these values give %4, so it says nothing.</source>
        <translation>%1 gilt für Ergebnisse von %2 bis %3; diese Werte ergeben %4, daher keine Aussage.</translation>
    </message>
    <message>
        <source>The chart %1 needs the gestational age by dates.</source>
        <translation>Die Kurve %1 braucht das Gestationsalter nach Terminen.</translation>
    </message>
    <message>
        <source>The chart %1 is valid from %2 to %3 weeks; %4 lies outside.</source>
        <translation>Die Kurve %1 gilt von %2 bis %3 Wochen; %4 liegt außerhalb.</translation>
    </message>
    <message>
        <source>The scan says %1, dates say %2: %3 days apart, more than %4, so the dates are to be replaced by the scan.</source>
        <translation>Die Messung ergibt %1, der Termin %2: %3 Tage auseinander, mehr als %4, daher den Termin nach der Messung korrigieren.</translation>
    </message>
    <message>
        <source>The scan says %1, dates say %2: %3 days apart, not more than %4, so the dates stay.</source>
        <translation>Die Messung ergibt %1, der Termin %2: %3 Tage auseinander, nicht mehr als %4, daher bleibt der Termin.</translation>
    </message>
    <message>
        <source>The folder %1 with the %2 cannot be opened: %3.</source>
        <translation>Der Ordner %1 (%2) lässt sich nicht öffnen: %3.</translation>
    </message>
    <message>
        <source>The folder %1 with the %2 cannot be read: %3.</source>
        <translation>Der Ordner %1 (%2) lässt sich nicht lesen: %3.</translation>
    </message>
    <message>
        <source>measurement packages</source>
        <translation>Messpakete</translation>
    </message>
    <message>
        <source>word lists</source>
        <translation>Wortlisten</translation>
    </message>
    <message>
        <source>body marks</source>
        <translation>Körpersymbole</translation>
    </message>
    <message>
        <source>presets</source>
        <translation>Voreinstellungen</translation>
    </message>
    <message>
        <source>two numbers, a place in mm</source>
        <translation>zwei Zahlen, ein Ort in mm</translation>
    </message>
    <message>
        <source>one line of text of 1 to %1 bytes</source>
        <translation>eine Zeile Text von 1 bis %1 Bytes</translation>
    </message>
    <message>
        <source>left out of a text</source>
        <translation>bei einem Text weggelassen werden</translation>
    </message>
    <message>
        <source>left out of an arrow</source>
        <translation>bei einem Pfeil weggelassen werden</translation>
    </message>
    <message>
        <source>a place at least 0.5 mm from at_mm</source>
        <translation>ein Ort, der mindestens 0,5 mm von at_mm entfernt ist</translation>
    </message>
    <message>
        <source>a number that no other annotation has</source>
        <translation>eine Nummer, die keine andere Beschriftung hat</translation>
    </message>
    <message>
        <source>one line of 1 to %1 bytes that no other term of the list says</source>
        <translation>eine Zeile von 1 bis %1 Bytes, die kein anderer Begriff der Liste ist</translation>
    </message>
    <message>
        <source>the word list %1</source>
        <translation>die Wortliste %1</translation>
    </message>
    <message>
        <source>small letters, digits and -</source>
        <translation>Kleinbuchstaben, Ziffern und -</translation>
    </message>
    <message>
        <source>the name of an SVG file in the folder of the mark</source>
        <translation>der Name einer SVG-Datei im Ordner des Körpersymbols</translation>
    </message>
    <message>
        <source>an id that no other variant has</source>
        <translation>eine Kennung, die keine andere Variante hat</translation>
    </message>
    <message>
        <source>the body mark %1</source>
        <translation>das Körpersymbol %1</translation>
    </message>
    <message>
        <source>two numbers from 0 to 1, a place on the drawing</source>
        <translation>zwei Zahlen von 0 bis 1, ein Ort auf der Zeichnung</translation>
    </message>
    <message>
        <source>small letters, digits, ., - and _</source>
        <translation>Kleinbuchstaben, Ziffern, ., - und _</translation>
    </message>
    <message>
        <source>the preset %1</source>
        <translation>die Voreinstellung %1</translation>
    </message>
    <message>
        <source>the knobs of %1</source>
        <translation>die Regler von %1</translation>
    </message>
    <message>
        <source>0 or one of the probe&apos;s frequencies, %1</source>
        <translation>0 oder eine der Frequenzen des Schallkopfs, %1</translation>
    </message>
    <message>
        <source>at most the depth, %1 mm</source>
        <translation>höchstens die Tiefe, %1 mm</translation>
    </message>
    <message>
        <source>false: the probe cannot fan out</source>
        <translation>false: der Schallkopf kann sich nicht auffächern</translation>
    </message>
    <message>
        <source>left out: how fast the machine is belongs to no examination</source>
        <translation>weggelassen werden: Wie schnell der Rechner ist, gehört zu keiner Untersuchung</translation>
    </message>
    <message>
        <source>The preset %1 is for the probe &apos;%2&apos;, which there is not; those there are: %3.</source>
        <translation>Die Voreinstellung %1 ist für den Schallkopf &apos;%2&apos;, den es nicht gibt; es gibt: %3.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be the name of a preset; use 1 to %2 bytes with a letter or a digit among them.</source>
        <translation>&apos;%1&apos; kann nicht der Name einer Voreinstellung sein; nehmen Sie 1 bis %2 Bytes mit einem Buchstaben oder einer Ziffer darunter.</translation>
    </message>
    <message>
        <source>The folder of presets %1 cannot be made: %2.</source>
        <translation>Der Ordner der Voreinstellungen %1 lässt sich nicht anlegen: %2.</translation>
    </message>
    <message>
        <source>Of %1 presets %2 cannot be used; correct what is listed.</source>
        <translation>Von %1 Voreinstellungen sind %2 unbrauchbar; korrigieren Sie, was aufgeführt ist.</translation>
    </message>
    <message>
        <source>0: the probe cannot steer</source>
        <translation>0: der Schallkopf kann nicht schwenken</translation>
    </message>
    <message>
        <source>an object, the knobs of the console</source>
        <translation>ein Objekt, die Regler der Konsole</translation>
    </message>
    <message>
        <source>Stopped as asked; nothing was written.</source>
        <translation>Wie gewünscht angehalten; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Making images</source>
        <translation>Bilder werden erzeugt</translation>
    </message>
    <message>
        <source>A DICOM object could not be made (%1); check that DCMTK and its dictionary are installed.</source>
        <translation>Ein DICOM-Objekt ließ sich nicht erzeugen (%1); prüfen Sie, ob DCMTK und sein Wörterbuch installiert sind.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no unique identifier of DICOM (%2); make one with newDicomUid.</source>
        <translation>„%1“ ist keine eindeutige Kennung von DICOM (%2); erzeugen Sie eine mit newDicomUid.</translation>
    </message>
    <message>
        <source>A DICOM object could not be written (%1).</source>
        <translation>Ein DICOM-Objekt ließ sich nicht schreiben (%1).</translation>
    </message>
    <message>
        <source>A picture of %1 x %2 pixels is too small for the words it must carry; give at least %3x%4.</source>
        <translation>Ein Bild von %1 x %2 Pixeln ist zu klein für die Worte, die es tragen muss; geben Sie mindestens %3x%4 an.</translation>
    </message>
    <message>
        <source>A picture of %1 x %2 pixels is larger than DICOM allows (%3 either way); give a smaller size.</source>
        <translation>Ein Bild von %1 x %2 Pixeln ist größer, als DICOM erlaubt (%3 in jeder Richtung); geben Sie eine kleinere Größe an.</translation>
    </message>
    <message>
        <source>%1 images of %2 x %3 pixels are more than one DICOM object can hold; store fewer of them, or smaller ones.</source>
        <translation>%1 Bilder von %2 x %3 Pixeln sind mehr, als ein DICOM-Objekt fasst; speichern Sie weniger oder kleinere.</translation>
    </message>
    <message>
        <source>A region of the picture has no size of a pixel, so that nobody could measure in it.</source>
        <translation>Ein Bereich des Bildes hat keine Pixelgröße, sodass niemand darin messen könnte.</translation>
    </message>
    <message>
        <source>A clip without an image cannot be stored; record some first.</source>
        <translation>Ein Clip ohne Bild lässt sich nicht speichern; nehmen Sie zuerst welche auf.</translation>
    </message>
    <message>
        <source>%1 images are more than one DICOM clip holds (%2); store fewer of them.</source>
        <translation>%1 Bilder sind mehr, als ein DICOM-Clip fasst (%2); speichern Sie weniger davon.</translation>
    </message>
    <message>
        <source>The times of the images do not rise, so that no clip can be made of them.</source>
        <translation>Die Zeiten der Bilder steigen nicht an, sodass sich kein Clip aus ihnen machen lässt.</translation>
    </message>
    <message>
        <source>Image %1 of the clip has another size or other colours than the clip; store the images apart.</source>
        <translation>Bild %1 des Clips hat eine andere Größe oder andere Farben als der Clip; speichern Sie die Bilder einzeln.</translation>
    </message>
    <message>
        <source>Writing the clip</source>
        <translation>Der Clip wird geschrieben</translation>
    </message>
    <message>
        <source>Writing images and reports</source>
        <translation>Bilder und Befunde werden geschrieben</translation>
    </message>
    <message>
        <source>In image %1 depth, zoom or orientation are not those of the first image, and all images of a DICOM clip have one scale; write a film (.mp4) or single images instead.</source>
        <translation>In Bild %1 sind Tiefe, Zoom oder Ausrichtung nicht die des ersten Bildes, und alle Bilder eines DICOM-Clips haben einen Maßstab; schreiben Sie stattdessen einen Film (.mp4) oder einzelne Bilder.</translation>
    </message>
    <message>
        <source>The structured report could not be made (%1); save the worksheet as .json or .csv instead.</source>
        <translation>Der strukturierte Befund ließ sich nicht erzeugen (%1); speichern Sie das Arbeitsblatt stattdessen als .json oder .csv.</translation>
    </message>
    <message>
        <source>The worksheet is empty; measure something first.</source>
        <translation>Das Arbeitsblatt ist leer; messen Sie zuerst etwas.</translation>
    </message>
    <message>
        <source>%1 is not there; check the name.</source>
        <translation>%1 gibt es nicht; prüfen Sie den Namen.</translation>
    </message>
    <message>
        <source>%1 is no DICOM file that can be read (%2); only such files can be sent.</source>
        <translation>%1 ist keine lesbare DICOM-Datei (%2); nur solche Dateien lassen sich senden.</translation>
    </message>
    <message>
        <source>%1 lacks an identifier that archives need; only whole DICOM objects can be sent.</source>
        <translation>%1 fehlt eine Kennung, die Archive brauchen; nur vollständige DICOM-Objekte lassen sich senden.</translation>
    </message>
    <message>
        <source>%1 is no note of an outbox; move it away, and its object is sent again.</source>
        <translation>%1 ist keine Notiz eines Postausgangs; verschieben Sie sie, und ihr Objekt wird noch einmal gesendet.</translation>
    </message>
    <message>
        <source>%1 was written by a newer version of EchoWeave; send with that one.</source>
        <translation>%1 wurde von einer neueren Version von EchoWeave geschrieben; senden Sie mit dieser.</translation>
    </message>
    <message>
        <source>The outbox %1 cannot be written; check the folder and its permissions.</source>
        <translation>Der Postausgang %1 lässt sich nicht schreiben; prüfen Sie den Ordner und seine Rechte.</translation>
    </message>
    <message>
        <source>Another program is sending from the outbox %1; wait until it has finished.</source>
        <translation>Ein anderes Programm sendet aus dem Postausgang %1; warten Sie, bis es fertig ist.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no title of a DICOM application; it has 1 to 16 letters without blanks.</source>
        <translation>„%1“ ist kein Titel einer DICOM-Anwendung; er hat 1 bis 16 Zeichen ohne Leerzeichen.</translation>
    </message>
    <message>
        <source>The archive needs a host and a port from 1 to 65535.</source>
        <translation>Das Archiv braucht einen Rechner und einen Port von 1 bis 65535.</translation>
    </message>
    <message>
        <source>The archive %1 at %2 port %3 does not answer as it should (%4).</source>
        <translation>Das Archiv %1 auf %2, Port %3, antwortet nicht, wie es soll (%4).</translation>
    </message>
    <message>
        <source>Sending to the archive</source>
        <translation>Wird an das Archiv gesendet</translation>
    </message>
    <message>
        <source>Asking the archive</source>
        <translation>Das Archiv wird gefragt</translation>
    </message>
    <message>
        <source>Stopped as asked; what was not sent yet stays in the outbox.</source>
        <translation>Wie gewünscht angehalten; was noch nicht gesendet ist, bleibt im Postausgang.</translation>
    </message>
    <message>
        <source>The archive %1 has no room now (%2).</source>
        <translation>Das Archiv %1 hat jetzt keinen Platz (%2).</translation>
    </message>
    <message>
        <source>The archive %1 cannot be asked what it has; what it said it stored is kept in the outbox.</source>
        <translation>Das Archiv %1 lässt sich nicht fragen, was es hat; was es gespeichert haben will, bleibt im Postausgang.</translation>
    </message>
    <message>
        <source>The archive %1 did not say whether it has every object.</source>
        <translation>Das Archiv %1 hat nicht gesagt, ob es jedes Objekt hat.</translation>
    </message>
    <message>
        <source>The archive %1 did not find every object that it had stored.</source>
        <translation>Das Archiv %1 hat nicht jedes Objekt gefunden, das es gespeichert hatte.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be made; check permissions and room of the disk.</source>
        <translation>„%1“ lässt sich nicht anlegen; prüfen Sie Rechte und Platz des Datenträgers.</translation>
    </message>
    <message>
        <source>Both points lie at the same depth; move one of them.</source>
        <translation>Beide Punkte liegen in derselben Tiefe; einen davon verschieben.</translation>
    </message>
    <message>
        <source>The uncertainty of an input is not known, so that of the result is not either.</source>
        <translation>Die Unsicherheit einer Eingabe ist nicht bekannt, also auch die des Ergebnisses nicht.</translation>
    </message>
    <message>
        <source>A ratio is of two quantities of one kind, but A is measured in %1 and B in %2; choose two lengths or two areas.</source>
        <translation>Ein Verhältnis haben zwei Größen derselben Art, aber A ist in %1 gemessen und B in %2; zwei Längen oder zwei Flächen wählen.</translation>
    </message>
    <message>
        <source>B is zero, and nothing can be divided by it; choose another measurement.</source>
        <translation>B ist null, und dadurch lässt sich nicht teilen; eine andere Messung wählen.</translation>
    </message>
    <message>
        <source>A is larger than B, so nothing is reduced; A is the narrow place, B the normal one.</source>
        <translation>A ist größer als B, also ist nichts verengt; A ist die enge Stelle, B die normale.</translation>
    </message>
    <message>
        <source>A volume is of three lengths, but one of them is measured in %1; choose lengths.</source>
        <translation>Ein Volumen haben drei Längen, aber eine davon ist in %1 gemessen; Längen wählen.</translation>
    </message>
    <message>
        <source>One of the three lengths is zero; choose another measurement.</source>
        <translation>Eine der drei Längen ist null; eine andere Messung wählen.</translation>
    </message>
    <message>
        <source>All three lengths are of one picture; the third one belongs to a picture at right angles to it.</source>
        <translation>Alle drei Längen sind aus einem Bild; die dritte gehört in ein Bild im rechten Winkel dazu.</translation>
    </message>
    <message>
        <source>One length stands for two of the three; measure each of them.</source>
        <translation>Eine Länge steht für zwei der drei; jede davon messen.</translation>
    </message>
    <message>
        <source>Discs of two planes need two measurements by discs; draw them in both pictures first.</source>
        <translation>Scheiben zweier Ebenen brauchen zwei Messungen mit Scheiben; sie erst in beiden Bildern zeichnen.</translation>
    </message>
    <message>
        <source>Both planes are of one picture; the second one is that at right angles to it.</source>
        <translation>Beide Ebenen sind aus einem Bild; die zweite ist die im rechten Winkel dazu.</translation>
    </message>
    <message>
        <source>This result is of %1 measurements, not of %2.</source>
        <translation>Dieses Ergebnis ist aus %1 Messungen, nicht aus %2.</translation>
    </message>
    <message>
        <source>Measurement %1, which this result was made from, was deleted.</source>
        <translation>Messung %1, aus der dieses Ergebnis entstand, wurde gelöscht.</translation>
    </message>
    <message>
        <source>Measurement %1 gives no %2; choose another one.</source>
        <translation>Messung %1 ergibt keine Größe „%2“; eine andere wählen.</translation>
    </message>
    <message>
        <source>a kind of caliper: distance, poly_line, ellipse, fitted_ellipse, trace, angle, ratio, ellipsoid, discs, biplane, interval, slope, heart_rate or depth_distance</source>
        <translation>eine Art von Messmarke: distance, poly_line, ellipse, fitted_ellipse, trace, angle, ratio, ellipsoid, discs, biplane, interval, slope, heart_rate oder depth_distance</translation>
    </message>
    <message>
        <source>a setting, or &apos;action&apos; in its place</source>
        <translation>eine Einstellung oder stattdessen &apos;action&apos;</translation>
    </message>
    <message>
        <source>one that this kind of control and what it does can have</source>
        <translation>eine, die zu dieser Art von Regler und zu dem passt, was er tut</translation>
    </message>
    <message>
        <source>an object of at most %1 actions</source>
        <translation>ein Objekt aus höchstens %1 Aktionen</translation>
    </message>
    <message>
        <source>the file of keys %1</source>
        <translation>die Tastendatei %1</translation>
    </message>
    <message>
        <source>This computer has no MIDI: %1 is not there. Plug the control surface in; if it stays so, the kernel module snd-seq is missing (sudo modprobe snd-seq).</source>
        <translation>Dieser Rechner hat kein MIDI: %1 fehlt. Schließen Sie das Reglerpult an; bleibt es so, fehlt das Kernelmodul snd-seq (sudo modprobe snd-seq).</translation>
    </message>
    <message>
        <source>MIDI cannot be used: %1.</source>
        <translation>MIDI lässt sich nicht benutzen: %1.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be listened to; another program may have it. Close that program, or plug the device in again.</source>
        <translation>„%1“ lässt sich nicht abhören; vielleicht hat es ein anderes Programm. Schließen Sie jenes, oder stecken Sie das Gerät neu an.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be listened to (%2).</source>
        <translation>„%1“ lässt sich nicht abhören (%2).</translation>
    </message>
    <message>
        <source>This EchoWeave was built without MIDI; install librtmidi-dev and build it again to use such control surfaces.</source>
        <translation>Dieses EchoWeave wurde ohne MIDI gebaut; installieren Sie librtmidi-dev und bauen Sie es neu, um solche Reglerpulte zu benutzen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be read (%2). Linux lets only root read such devices until a rule allows it; &apos;Keys and controls&apos; in the documentation has the line for it.</source>
        <translation>„%1“ lässt sich nicht lesen (%2). Linux lässt solche Geräte nur root lesen, bis eine Regel es erlaubt; die Zeile dafür steht in der Dokumentation unter „Keys and controls“.</translation>
    </message>
    <message>
        <source>This EchoWeave was built without HID; install libhidapi-dev and build it again to use jog dials and game controllers.</source>
        <translation>Dieses EchoWeave wurde ohne HID gebaut; installieren Sie libhidapi-dev und bauen Sie es neu, um Jog-Räder und Spielsteuerungen zu benutzen.</translation>
    </message>
    <message>
        <source>The recording gave %1 of the %2 frames it has, so %3 was not written; check that the file is still there.</source>
        <translation>Die Aufnahme gab %1 ihrer %2 Bilder her, deshalb wurde %3 nicht geschrieben; prüfen, ob die Datei noch da ist.</translation>
    </message>
    <message>
        <source>Nothing moves in the recording, so scan and screen were told apart by brightness alone; look closely.</source>
        <translation>In der Aufnahme bewegt sich nichts, deshalb wurden Ultraschallbild und Bildschirm allein nach der Helligkeit getrennt; genau hinsehen.</translation>
    </message>
    <message>
        <source>Too much of the scan stands still for text over it to be told from echoes; look for text and add its boxes.</source>
        <translation>Zu viel vom Ultraschallbild steht still, als dass sich Text darüber von Echos unterscheiden ließe; nach Text suchen und seine Kästen hinzufügen.</translation>
    </message>
    <message>
        <source>The outline of the scan was not found; state it in a correction.</source>
        <translation>Der Umriss des Ultraschallbilds wurde nicht gefunden; ihn in einer Korrektur angeben.</translation>
    </message>
    <message>
        <source>No evenly spaced marks of a depth scale were found; the depth has to be stated.</source>
        <translation>Es wurden keine gleichmäßigen Marken einer Tiefenskala gefunden; die Tiefe muss angegeben werden.</translation>
    </message>
    <message>
        <source>The stated outline holds no part of the pictures; correct it.</source>
        <translation>Der angegebene Umriss enthält nichts von den Bildern; ihn berichtigen.</translation>
    </message>
    <message>
        <source>A stated depth or distance of ticks must be above 0 mm.</source>
        <translation>Eine angegebene Tiefe oder ein Markenabstand muss über 0 mm liegen.</translation>
    </message>
    <message>
        <source>The distance of ticks was stated, but none were found; state the depth of the scan instead.</source>
        <translation>Ein Markenabstand wurde angegeben, aber es wurden keine Marken gefunden; stattdessen die Tiefe des Bilds angeben.</translation>
    </message>
    <message>
        <source>The stated depth (%1 mm a pixel) and the stated ticks (%2 mm a pixel) do not agree; the depth counts. Check both.</source>
        <translation>Die angegebene Tiefe (%1 mm je Pixel) und der angegebene Markenabstand (%2 mm je Pixel) passen nicht zusammen; es gilt die Tiefe. Beide prüfen.</translation>
    </message>
    <message>
        <source>four corners, clockwise from the upper left one</source>
        <translation>vier Ecken, im Uhrzeigersinn ab der linken oberen</translation>
    </message>
    <message>
        <source>x and y of each corner, in pixels</source>
        <translation>x und y jeder Ecke in Pixeln</translation>
    </message>
    <message>
        <source>larger than &quot;left_deg&quot;</source>
        <translation>größer als &quot;left_deg&quot;</translation>
    </message>
    <message>
        <source>larger than &quot;near_px&quot;</source>
        <translation>größer als &quot;near_px&quot;</translation>
    </message>
    <message>
        <source>boxes of whole pixels: x, y, width, height</source>
        <translation>Kästen aus ganzen Pixeln: x, y, Breite, Höhe</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has version %2 of its format and this program knows %3; use a newer EchoWeave.</source>
        <translation>&apos;%1&apos; hat die Formatversion %2, und dieses Programm kennt %3; ein neueres EchoWeave verwenden.</translation>
    </message>
    <message>
        <source>Looking at the frames</source>
        <translation>Bilder werden angesehen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no frames that can be read.</source>
        <translation>&apos;%1&apos; hat keine lesbaren Bilder.</translation>
    </message>
    <message>
        <source>Looking at the frames was stopped.</source>
        <translation>Das Ansehen der Bilder wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Where the scan lies is not known, so the recording cannot be cleaned; state its outline in a correction.</source>
        <translation>Die Lage des Ultraschallbilds ist nicht bekannt, deshalb lässt sich die Aufnahme nicht bereinigen; den Umriss in einer Korrektur angeben.</translation>
    </message>
    <message>
        <source>The %1 frames before it were read.</source>
        <translation>Die %1 Bilder davor wurden gelesen.</translation>
    </message>
    <message>
        <source>%1 says it holds a film, but has none; export it again.</source>
        <translation>%1 gibt an, einen Film zu enthalten, hat aber keinen; neu exportieren.</translation>
    </message>
    <message>
        <source>There is not enough memory for the film in %1; close other programs.</source>
        <translation>Der Speicher reicht nicht für den Film in %1; andere Programme schließen.</translation>
    </message>
    <message>
        <source>%1 holds poses without images; choose a recording with images.</source>
        <translation>%1 enthält Lagen ohne Bilder; eine Aufnahme mit Bildern wählen.</translation>
    </message>
    <message>
        <source>Frame %1 of %2 has another size than those before it; the %3 before it were read.</source>
        <translation>Bild %1 von %2 hat eine andere Größe als die davor; die %3 davor wurden gelesen.</translation>
    </message>
    <message>
        <source>%1 is no film, DICOM cine, TIFF, sequence or picture that is known, or its beginning is damaged.</source>
        <translation>%1 ist kein bekannter Film, keine DICOM-Bildfolge, kein TIFF, keine Sequenz und kein Bild, oder der Anfang ist beschädigt.</translation>
    </message>
    <message>
        <source>Reading the frames was stopped.</source>
        <translation>Das Lesen der Bilder wurde abgebrochen.</translation>
    </message>
    <message>
        <source>%1 is a TIFF that cannot be read: it is damaged or packed in a way that is not known; save it again.</source>
        <translation>%1 ist ein nicht lesbares TIFF: beschädigt oder auf unbekannte Art gepackt; neu speichern.</translation>
    </message>
    <message>
        <source>%1 is a film of which nothing can be read: its index is missing (the recording was not ended), it is damaged, or its codec is not installed; record or export it again.</source>
        <translation>%1 ist ein Film, von dem nichts zu lesen ist: Der Index fehlt (die Aufnahme wurde nicht beendet), die Datei ist beschädigt, oder der Codec ist nicht installiert; neu aufnehmen oder exportieren.</translation>
    </message>
    <message>
        <source>No frame of %1 can be read; get the file again, or record it once more.</source>
        <translation>Kein Bild von %1 ist lesbar; die Datei neu beschaffen oder noch einmal aufnehmen.</translation>
    </message>
    <message>
        <source>%1 ends early or is damaged: of %2 frames the first %3 were read; get the file again if the others are needed.</source>
        <translation>%1 endet zu früh oder ist beschädigt: Von %2 Bildern wurden die ersten %3 gelesen; die Datei neu beschaffen, wenn die übrigen gebraucht werden.</translation>
    </message>
    <message>
        <source>The pictures of %1 have %2 x %3 pixels, more than are read; record a smaller part of the screen.</source>
        <translation>Die Bilder von %1 haben %2 x %3 Pixel, mehr als gelesen werden; einen kleineren Teil des Bildschirms aufnehmen.</translation>
    </message>
    <message>
        <source>Films can be neither written nor read, because a part of the program is missing; install EchoWeave again.</source>
        <translation>Filme können weder geschrieben noch gelesen werden, weil ein Teil des Programms fehlt; EchoWeave neu installieren.</translation>
    </message>
    <message>
        <source>The bundle could not be written (%1); please report it.</source>
        <translation>Das Paket konnte nicht geschrieben werden (%1); bitte melden.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was changed while the case was read; do it again when nobody is writing to the case folder.</source>
        <translation>„%1“ wurde verändert, während der Fall gelesen wurde; noch einmal versuchen, wenn niemand in den Ordner des Falls schreibt.</translation>
    </message>
    <message>
        <source>Exporting the case</source>
        <translation>Fall wird exportiert</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing; put it back, or import or publish the case again.</source>
        <translation>„%1“ fehlt; zurücklegen, oder den Fall noch einmal importieren oder veröffentlichen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not what was kept: its content has changed; put the kept file back, or import or publish the case again.</source>
        <translation>„%1“ ist nicht, was aufbewahrt wurde: Der Inhalt hat sich geändert; die aufbewahrte Datei zurücklegen, oder den Fall noch einmal importieren oder veröffentlichen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not belong to the case; move it to another place.</source>
        <translation>„%1“ gehört nicht zum Fall; an einen anderen Ort verschieben.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is named by its content and holds something else: it has changed; put the kept file back or choose the volume again.</source>
        <translation>„%1“ ist nach dem Inhalt benannt und enthält etwas anderes: Die Datei hat sich geändert; die aufbewahrte Datei zurücklegen oder das Volumen noch einmal wählen.</translation>
    </message>
    <message>
        <source>The case in the bundle &apos;%1&apos; cannot be used: %2</source>
        <translation>Der Fall im Paket „%1“ kann nicht verwendet werden: %2</translation>
    </message>
    <message>
        <source>The bundle &apos;%1&apos; says that it holds the case &quot;%2&quot;, and it holds &quot;%3&quot;; ask for it to be exported again.</source>
        <translation>Das Paket „%1“ soll den Fall „%2“ enthalten, enthält aber „%3“; um einen neuen Export bitten.</translation>
    </message>
    <message>
        <source>Checking the bundle</source>
        <translation>Paket wird geprüft</translation>
    </message>
    <message>
        <source>The bundle &apos;%1&apos; was changed while it was read; do it again.</source>
        <translation>Das Paket „%1“ wurde verändert, während es gelesen wurde; noch einmal versuchen.</translation>
    </message>
    <message>
        <source>Importing the case</source>
        <translation>Fall wird importiert</translation>
    </message>
    <message>
        <source>The case folder &apos;%1&apos; cannot be read (%2); check that it is there and that you may open it.</source>
        <translation>Der Ordner „%1“ des Falls kann nicht gelesen werden (%2); prüfen, ob es ihn gibt und ob er geöffnet werden darf.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; in the case folder is a link that leads out of it, to a folder or to nothing; copy the file itself into the case folder.</source>
        <translation>„%1“ im Ordner des Falls ist eine Verknüpfung, die hinausführt, zu einem Ordner oder ins Leere; die Datei selbst in den Ordner des Falls kopieren.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; in the case folder is neither a file nor a folder; take it out of there.</source>
        <translation>„%1“ im Ordner des Falls ist weder Datei noch Ordner; von dort entfernen.</translation>
    </message>
    <message>
        <source>it is an absolute path</source>
        <translation>es ist ein absoluter Pfad</translation>
    </message>
    <message>
        <source>it is longer than %1 bytes</source>
        <translation>er ist länger als %1 Bytes</translation>
    </message>
    <message>
        <source>it has characters that not every system knows in names</source>
        <translation>er hat Zeichen, die nicht jedes System in Namen kennt</translation>
    </message>
    <message>
        <source>it leads out of the case folder</source>
        <translation>er führt aus dem Ordner des Falls hinaus</translation>
    </message>
    <message>
        <source>a part of it is empty or hidden</source>
        <translation>ein Teil davon ist leer oder verborgen</translation>
    </message>
    <message>
        <source>the library itself has a file of that name</source>
        <translation>die Bibliothek selbst hat eine Datei dieses Namens</translation>
    </message>
    <message>
        <source>%1 names the file &quot;%2&quot;, which is refused (%3); rename the file, or, when it is not yours, do not use what names it.</source>
        <translation>%1 nennt die Datei „%2“, die abgelehnt wird (%3); die Datei umbenennen, oder, wenn sie von Fremden stammt, nicht verwenden, was sie nennt.</translation>
    </message>
    <message>
        <source>%1 names %2 files, and more than %3 are not taken; divide the case.</source>
        <translation>%1 nennt %2 Dateien, und mehr als %3 werden nicht angenommen; den Fall teilen.</translation>
    </message>
    <message>
        <source>another one has that name, but for capitals</source>
        <translation>eine andere heißt ebenso, bis auf Großbuchstaben</translation>
    </message>
    <message>
        <source>%1 names files of more than %2 MiB in all, and no more is taken; divide the case.</source>
        <translation>%1 nennt Dateien von zusammen mehr als %2 MiB, und mehr wird nicht angenommen; den Fall teilen.</translation>
    </message>
    <message>
        <source>another file has the name of its folder</source>
        <translation>eine andere Datei heißt wie ihr Ordner</translation>
    </message>
    <message>
        <source>The case folder &apos;%1&apos;</source>
        <translation>Der Ordner „%1“ des Falls</translation>
    </message>
    <message>
        <source>case.json names &quot;%1&quot;, and hidden files are not handed on; give it a name without a dot in front, there and in the case folder.</source>
        <translation>case.json nennt „%1“, und verborgene Dateien werden nicht weitergegeben; dort und im Ordner des Falls einen Namen ohne Punkt am Anfang geben.</translation>
    </message>
    <message>
        <source>The volume &apos;%1&apos; cannot be put into a case as it is; save it as .mha first and choose that.</source>
        <translation>Das Volumen „%1“ kann so nicht in einen Fall gelegt werden; zuerst als .mha speichern und das wählen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is there and holds something else than its name says; move it away, or verify the case.</source>
        <translation>„%1“ ist schon da und enthält etwas anderes, als der Name sagt; wegschieben oder den Fall prüfen.</translation>
    </message>
    <message>
        <source>Putting a volume into the case</source>
        <translation>Volumen wird in den Fall gelegt</translation>
    </message>
    <message>
        <source>The bundle &apos;%1&apos; would grow from %2 KiB to %3 KiB, as no case does; do not use it.</source>
        <translation>Das Paket „%1“ würde von %2 KiB auf %3 KiB wachsen, was kein Fall tut; nicht verwenden.</translation>
    </message>
    <message>
        <source>bundle.json of &apos;%1&apos;</source>
        <translation>bundle.json von „%1“</translation>
    </message>
    <message>
        <source>The bundle &apos;%1&apos; holds no case but a &quot;%2&quot;, which this program does not know; update EchoWeave.</source>
        <translation>Das Paket „%1“ enthält keinen Fall, sondern „%2“, was dieses Programm nicht kennt; EchoWeave aktualisieren.</translation>
    </message>
    <message>
        <source>letters, digits, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;, at most 100</source>
        <translation>Buchstaben, Ziffern, „-“, „_“ und „.“, höchstens 100,</translation>
    </message>
    <message>
        <source>The bundle &apos;%1&apos; lists %2 files, and more than %3 are not taken; do not use it, or ask for a smaller one.</source>
        <translation>Das Paket „%1“ führt %2 Dateien auf, und mehr als %3 werden nicht angenommen; nicht verwenden oder um ein kleineres bitten.</translation>
    </message>
    <message>
        <source>The bundle &apos;%1&apos;</source>
        <translation>Das Paket „%1“</translation>
    </message>
    <message>
        <source>The bundle &apos;%1&apos; lists no case.json, so there is no case in it; ask for another one.</source>
        <translation>Das Paket „%1“ führt keine case.json auf, enthält also keinen Fall; um ein anderes bitten.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a case bundle; choose a file that EchoWeave has exported (.ewcase).</source>
        <translation>„%1“ ist kein Paket mit einem Fall; eine Datei wählen, die EchoWeave exportiert hat (.ewcase).</translation>
    </message>
    <message>
        <source>The bundle &apos;%1&apos; ends too early; copy or download it again.</source>
        <translation>Das Paket „%1“ endet zu früh; noch einmal kopieren oder herunterladen.</translation>
    </message>
    <message>
        <source>The bundle &apos;%1&apos; is damaged (%2); copy or download it again.</source>
        <translation>Das Paket „%1“ ist beschädigt (%2); noch einmal kopieren oder herunterladen.</translation>
    </message>
    <message>
        <source>The bundle &apos;%1&apos; holds more than its list names; do not use it.</source>
        <translation>Das Paket „%1“ enthält mehr, als seine Liste nennt; nicht verwenden.</translation>
    </message>
    <message>
        <source>The bundle &apos;%1&apos; cannot be read (%2); check the medium it is on.</source>
        <translation>Das Paket „%1“ kann nicht gelesen werden (%2); den Datenträger prüfen.</translation>
    </message>
    <message>
        <source>The bundle &apos;%1&apos; cannot be opened (%2); check that it is there and that you may read it.</source>
        <translation>Das Paket „%1“ kann nicht geöffnet werden (%2); prüfen, ob es da ist und gelesen werden darf.</translation>
    </message>
    <message>
        <source>The bundle &apos;%1&apos; holds &quot;%2&quot;, which is a link, a device or a folder instead of a file; do not use it, and ask for another one from somebody you trust.</source>
        <translation>Das Paket „%1“ enthält „%2“, eine Verknüpfung, ein Gerät oder einen Ordner statt einer Datei; nicht verwenden und um ein anderes von vertrauter Seite bitten.</translation>
    </message>
    <message>
        <source>The list of the bundle &apos;%1&apos; is too long to be that of a case; do not use it.</source>
        <translation>Die Liste des Pakets „%1“ ist zu lang für die eines Falls; nicht verwenden.</translation>
    </message>
    <message>
        <source>&quot;%2&quot; in the bundle &apos;%1&apos; is not what was put in; copy or download the bundle again.</source>
        <translation>„%2“ im Paket „%1“ ist nicht, was hineingelegt wurde; das Paket noch einmal kopieren oder herunterladen.</translation>
    </message>
    <message>
        <source>The bundle &apos;%1&apos; holds a file named &quot;%2&quot;, which is refused (%3); do not use it, and ask for another one from somebody you trust.</source>
        <translation>Das Paket „%1“ enthält eine Datei namens „%2“, die abgelehnt wird (%3); nicht verwenden und um ein anderes von vertrauter Seite bitten.</translation>
    </message>
    <message>
        <source>The bundle &apos;%1&apos; holds &quot;%2&quot; twice; do not use it, and ask for another one.</source>
        <translation>Das Paket „%1“ enthält „%2“ zweimal; nicht verwenden und um ein anderes bitten.</translation>
    </message>
    <message>
        <source>The bundle &apos;%1&apos; holds &quot;%2&quot;, which its list does not name; do not use it, and ask for another one.</source>
        <translation>Das Paket „%1“ enthält „%2“, was seine Liste nicht nennt; nicht verwenden und um ein anderes bitten.</translation>
    </message>
    <message>
        <source>The bundle &apos;%1&apos; lists &quot;%2&quot;, which is not in it; ask for it to be exported again.</source>
        <translation>Das Paket „%1“ führt „%2“ auf, was nicht darin ist; um einen neuen Export bitten.</translation>
    </message>
    <message>
        <source>What is to be published holds no case.json, so it is not a case; choose a case folder.</source>
        <translation>Was veröffentlicht werden soll, enthält keine case.json, ist also kein Fall; einen Ordner mit einem Fall wählen.</translation>
    </message>
    <message>
        <source>Publishing the case</source>
        <translation>Fall wird veröffentlicht</translation>
    </message>
    <message>
        <source>Adding up sums</source>
        <translation>Prüfsummen werden gebildet</translation>
    </message>
    <message>
        <source>64 hexadecimal digits in small letters</source>
        <translation>64 hexadezimale Ziffern in kleinen Buchstaben</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos;</source>
        <translation>Die Datei „%1“</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; cannot be reserved for editing (%2); check that you may write there, or save the case elsewhere.</source>
        <translation>Der Ordner „%1“ kann nicht zum Bearbeiten belegt werden (%2); prüfen, ob dort geschrieben werden darf, oder den Fall anderswo speichern.</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; is being edited by somebody who cannot be told; wait two minutes, or save the case elsewhere.</source>
        <translation>Der Ordner „%1“ wird von jemandem bearbeitet, den man nicht nennen kann; zwei Minuten warten oder den Fall anderswo speichern.</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; is being edited by %2 on the computer %3 since %4; wait until it is closed there, or save the case elsewhere.</source>
        <translation>Der Ordner „%1“ wird seit %4 von %2 am Rechner %3 bearbeitet; warten, bis er dort geschlossen ist, oder den Fall anderswo speichern.</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; was taken over by %2 on the computer %3 while this program did not run; save your work as another case.</source>
        <translation>Der Ordner „%1“ wurde von %2 am Rechner %3 übernommen, während dieses Programm ruhte; die Arbeit als anderen Fall speichern.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read (%2); check that it is there, that you may read it, and the medium it is on.</source>
        <translation>„%1“ kann nicht gelesen werden (%2); prüfen, ob es da ist und gelesen werden darf, und den Datenträger.</translation>
    </message>
    <message>
        <source>The place &apos;%1&apos; has %2 MiB left, and %3 MiB are needed; free some room or choose another place.</source>
        <translation>Am Ort „%1“ sind %2 MiB frei, und %3 MiB werden gebraucht; Platz schaffen oder einen anderen Ort wählen.</translation>
    </message>
    <message>
        <source>Stopped as asked before everything was checked.</source>
        <translation>Wie gewünscht abgebrochen, bevor alles geprüft war.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was not published: it has no sums, so nobody can tell whether its files have changed.</source>
        <translation>„%1“ wurde nicht veröffentlicht: Es gibt keine Prüfsummen, und niemand kann sagen, ob sich seine Dateien geändert haben.</translation>
    </message>
    <message>
        <source>%1 found; what is listed says what to do.</source>
        <translation>%1 gefunden; was aufgeführt ist, sagt, was zu tun ist.</translation>
    </message>
    <message>
        <source>The folder of cases &apos;%1&apos; cannot be listed (%2); check its permissions.</source>
        <translation>Der Ordner der Fälle „%1“ lässt sich nicht auflisten (%2); seine Zugriffsrechte prüfen.</translation>
    </message>
    <message>
        <source>The case in &apos;%1&apos; has format %2, and this program reads formats up to %3; install a newer version of EchoWeave.</source>
        <translation>Der Fall in „%1“ hat das Format %2, und dieses Programm liest Formate bis %3; eine neuere Version von EchoWeave installieren.</translation>
    </message>
    <message>
        <source>The case.json in &apos;%1&apos; has no &apos;%2&apos;; open the folder to see what else is missing.</source>
        <translation>In der case.json in „%1“ fehlt „%2“; den Ordner öffnen, um zu sehen, was noch fehlt.</translation>
    </message>
    <message>
        <source>The index of the library cannot be written (%1); close other programs that use it.</source>
        <translation>Das Verzeichnis der Bibliothek lässt sich nicht schreiben (%1); andere Programme schließen, die es benutzen.</translation>
    </message>
    <message>
        <source>The index of the library cannot be read (%1); it is made anew when the start page is opened again.</source>
        <translation>Das Verzeichnis der Bibliothek lässt sich nicht lesen (%1); es wird neu angelegt, wenn die Startseite wieder geöffnet wird.</translation>
    </message>
    <message>
        <source>The index of the library was damaged or made by another version, and was made anew from the folders.</source>
        <translation>Das Verzeichnis der Bibliothek war beschädigt oder von einer anderen Version und wurde aus den Ordnern neu angelegt.</translation>
    </message>
    <message>
        <source>The index of the library cannot be kept in &apos;%1&apos; (%2), so the library is read anew at every start; make room there or choose another folder with ECHOWEAVE_CACHE.</source>
        <translation>Das Verzeichnis der Bibliothek lässt sich nicht in „%1“ behalten (%2), deshalb wird die Bibliothek bei jedem Start neu gelesen; dort Platz schaffen oder mit ECHOWEAVE_CACHE einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>Looking at the folders of the library</source>
        <translation>Ordner der Bibliothek ansehen</translation>
    </message>
    <message>
        <source>Reading the cases of the library</source>
        <translation>Fälle der Bibliothek lesen</translation>
    </message>
    <message>
        <source>Reading the library was stopped.</source>
        <translation>Das Lesen der Bibliothek wurde angehalten.</translation>
    </message>
    <message>
        <source>No index of the library can be made (%1); close other programs to have more memory.</source>
        <translation>Es lässt sich kein Verzeichnis der Bibliothek anlegen (%1); andere Programme schließen, damit mehr Speicher frei ist.</translation>
    </message>
    <message>
        <source>Making the folders of cases</source>
        <translation>Ordner der Fälle anlegen</translation>
    </message>
    <message>
        <source>Searching as people type</source>
        <translation>Suchen, wie getippt wird</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be written; make room in the folder of temporary files.</source>
        <translation>„%1“ lässt sich nicht schreiben; im Ordner für temporäre Dateien Platz schaffen.</translation>
    </message>
    <message>
        <source>The index that was just made cannot be read; run the benchmark again.</source>
        <translation>Das eben angelegte Verzeichnis lässt sich nicht lesen; den Benchmark noch einmal starten.</translation>
    </message>
    <message>
        <source>No temporary folder can be made; set TMPDIR to a folder you may write to.</source>
        <translation>Es lässt sich kein temporärer Ordner anlegen; TMPDIR auf einen beschreibbaren Ordner setzen.</translation>
    </message>
    <message>
        <source>The time was over before the step was handed in.</source>
        <translation>Die Zeit war abgelaufen, bevor der Schritt abgegeben wurde.</translation>
    </message>
    <message>
        <source>%1 is right.</source>
        <translation>%1: richtig eingestellt.</translation>
    </message>
    <message>
        <source>%1 is too high.</source>
        <translation>%1: zu hoch.</translation>
    </message>
    <message>
        <source>%1 is too low.</source>
        <translation>%1: zu niedrig.</translation>
    </message>
    <message>
        <source>Angle to the plane %1°</source>
        <translation>Winkel zur Ebene %1°</translation>
    </message>
    <message>
        <source>Another transducer suits this examination better.</source>
        <translation>Ein anderer Schallkopf eignet sich besser für diese Untersuchung.</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Distance from the plane %1 mm</source>
        <translation>Abstand von der Ebene %1 mm</translation>
    </message>
    <message>
        <source>Dynamic range</source>
        <translation>Dynamikbereich</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Fokus</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>It is %1 %2.</source>
        <translation>Es sind %1 %2.</translation>
    </message>
    <message>
        <source>No answer was chosen yet.</source>
        <translation>Es wurde noch keine Antwort gewählt.</translation>
    </message>
    <message>
        <source>No number was entered yet.</source>
        <translation>Es wurde noch keine Zahl eingegeben.</translation>
    </message>
    <message>
        <source>Not shown: %1</source>
        <translation>Nicht gezeigt: %1</translation>
    </message>
    <message>
        <source>Nothing that fits is measured in this image yet; freeze the image and set the calipers.</source>
        <translation>In diesem Bild ist noch nichts Passendes gemessen; frieren Sie das Bild ein und setzen Sie die Messpunkte.</translation>
    </message>
    <message>
        <source>Nothing was pointed at yet; click it in the image.</source>
        <translation>Es wurde noch nichts gezeigt; klicken Sie die Stelle im Bild an.</translation>
    </message>
    <message>
        <source>Right would have been: %1</source>
        <translation>Richtig gewesen wäre: %1</translation>
    </message>
    <message>
        <source>Scan for at least %1 s more.</source>
        <translation>Schallen Sie noch mindestens %1 s.</translation>
    </message>
    <message>
        <source>Seen so far: %1 %</source>
        <translation>Bisher gesehen: %1 %</translation>
    </message>
    <message>
        <source>Shown: %1</source>
        <translation>Gezeigt: %1</translation>
    </message>
    <message>
        <source>That is right.</source>
        <translation>Das ist richtig.</translation>
    </message>
    <message>
        <source>The case has no &apos;%1&apos;; the lesson asks for something that is not there. Tell its author.</source>
        <translation>Der Fall hat kein „%1“; die Lektion verlangt etwas, das es nicht gibt. Sagen Sie es ihrem Autor.</translation>
    </message>
    <message>
        <source>The expert&apos;s scan has not been shown to its end yet.</source>
        <translation>Die Untersuchung des Experten wurde noch nicht bis zum Ende gezeigt.</translation>
    </message>
    <message>
        <source>The transducer suits the examination.</source>
        <translation>Der Schallkopf passt zur Untersuchung.</translation>
    </message>
    <message>
        <source>There is no image yet; put the probe on the body.</source>
        <translation>Es gibt noch kein Bild; setzen Sie den Schallkopf auf den Körper.</translation>
    </message>
    <message>
        <source>Transducer</source>
        <translation>Schallkopf</translation>
    </message>
    <message>
        <source>The case &apos;%1&apos;, which this step scans, is not in the library; import it first.</source>
        <translation>Der Fall „%1“, der in diesem Schritt geschallt wird, ist nicht in der Bibliothek; importieren Sie ihn zuerst.</translation>
    </message>
    <message>
        <source>Making the organs&apos; surfaces</source>
        <translation>Oberflächen der Organe werden berechnet</translation>
    </message>
    <message>
        <source>Making the organs&apos; surfaces was stopped.</source>
        <translation>Die Berechnung der Organoberflächen wurde abgebrochen.</translation>
    </message>
    <message>
        <source>A text of the attempt is not valid UTF-8 and cannot be saved; type it again.</source>
        <translation>Ein Text des Versuchs ist kein gültiges UTF-8 und kann nicht gespeichert werden; geben Sie ihn neu ein.</translation>
    </message>
    <message>
        <source>The attempt in the folder &apos;%1&apos; is left out: %2</source>
        <translation>Der Versuch im Ordner „%1“ wird ausgelassen: %2</translation>
    </message>
    <message>
        <source>The attempts in &apos;%1&apos; cannot be read (%2); check that the folder is there and that you may read it.</source>
        <translation>Die Versuche in „%1“ können nicht gelesen werden (%2); prüfen Sie, ob der Ordner da ist und Sie ihn lesen dürfen.</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; for this attempt cannot be made (%2); free some space, or choose a library you may write to.</source>
        <translation>Der Ordner „%1“ für diesen Versuch kann nicht angelegt werden (%2); schaffen Sie Platz, oder wählen Sie eine Bibliothek, in die Sie schreiben dürfen.</translation>
    </message>
    <message>
        <source>a file of the attempt&apos;s folder</source>
        <translation>eine Datei im Ordner des Versuchs</translation>
    </message>
    <message>
        <source>a moment such as &quot;2026-11-26T09:30:00Z&quot;</source>
        <translation>ein Zeitpunkt wie &quot;2026-11-26T09:30:00Z&quot;</translation>
    </message>
    <message>
        <source>a sentence</source>
        <translation>ein Satz</translation>
    </message>
    <message>
        <source>The lessons of the case have format %1, and this program reads formats up to %2; open them with a newer EchoWeave.</source>
        <translation>Die Lektionen des Falls haben das Format %1, und dieses Programm liest Formate bis %2; öffnen Sie sie mit einem neueren EchoWeave.</translation>
    </message>
    <message>
        <source>a list of texts</source>
        <translation>eine Liste von Texten</translation>
    </message>
    <message>
        <source>a relative path inside the folder parts/lessons of the case</source>
        <translation>ein relativer Pfad im Ordner parts/lessons des Falls</translation>
    </message>
    <message>
        <source>a time after begin_s</source>
        <translation>eine Zeit nach begin_s</translation>
    </message>
    <message>
        <source>an id that no other lesson of the case has</source>
        <translation>eine Kennung, die keine andere Lektion des Falls hat</translation>
    </message>
    <message>
        <source>an id that no other step of the lesson has</source>
        <translation>eine Kennung, die kein anderer Schritt der Lektion hat</translation>
    </message>
    <message>
        <source>at least lowest</source>
        <translation>mindestens lowest</translation>
    </message>
    <message>
        <source>each setting once</source>
        <translation>jede Einstellung einmal</translation>
    </message>
    <message>
        <source>left out where there are options</source>
        <translation>weggelassen, wo es Antworten zur Auswahl gibt</translation>
    </message>
    <message>
        <source>the lessons of case.json</source>
        <translation>den Lektionen von case.json</translation>
    </message>
    <message>
        <source>A question needs at least two answers to choose from, or a number.</source>
        <translation>Eine Frage braucht mindestens zwei Antworten zur Auswahl oder eine Zahl.</translation>
    </message>
    <message>
        <source>Neither the step nor the case says how far the measurement may be off; give a tolerance.</source>
        <translation>Weder der Schritt noch der Fall sagt, wie weit die Messung abweichen darf; geben Sie eine Toleranz an.</translation>
    </message>
    <message>
        <source>No measurement is chosen; choose one that the case expects.</source>
        <translation>Es ist keine Messung gewählt; wählen Sie eine, die der Fall erwartet.</translation>
    </message>
    <message>
        <source>No plane is chosen; choose one of the case&apos;s.</source>
        <translation>Es ist keine Ebene gewählt; wählen Sie eine des Falls.</translation>
    </message>
    <message>
        <source>No setting is asked for; name a probe or give a range.</source>
        <translation>Es wird keine Einstellung verlangt; nennen Sie einen Schallkopf oder geben Sie einen Bereich an.</translation>
    </message>
    <message>
        <source>No structure is chosen; choose one of the case&apos;s.</source>
        <translation>Es ist keine Struktur gewählt; wählen Sie eine des Falls.</translation>
    </message>
    <message>
        <source>None of the answers is marked as right; mark one.</source>
        <translation>Keine der Antworten ist als richtig markiert; markieren Sie eine.</translation>
    </message>
    <message>
        <source>Nothing is chosen to point at; choose a point or a structure of the case.</source>
        <translation>Es ist nichts gewählt, worauf gezeigt werden soll; wählen Sie einen Punkt oder eine Struktur des Falls.</translation>
    </message>
    <message>
        <source>The case &apos;%1&apos; expects no measurement &apos;%2&apos;; choose one that it does.</source>
        <translation>Der Fall „%1“ erwartet keine Messung „%2“; wählen Sie eine, die er erwartet.</translation>
    </message>
    <message>
        <source>The case &apos;%1&apos; has no plane &apos;%2&apos;; choose one of its own.</source>
        <translation>Der Fall „%1“ hat keine Ebene „%2“; wählen Sie eine seiner eigenen.</translation>
    </message>
    <message>
        <source>The case &apos;%1&apos; has no plane or structure &apos;%2&apos;; choose one of its own.</source>
        <translation>Der Fall „%1“ hat keine Ebene oder Struktur „%2“; wählen Sie eine seiner eigenen.</translation>
    </message>
    <message>
        <source>The case &apos;%1&apos; has no point or structure &apos;%2&apos;; choose one of its own.</source>
        <translation>Der Fall „%1“ hat keinen Punkt und keine Struktur „%2“; wählen Sie eine seiner eigenen.</translation>
    </message>
    <message>
        <source>The case &apos;%1&apos; has no structure &apos;%2&apos;; choose one of its own.</source>
        <translation>Der Fall „%1“ hat keine Struktur „%2“; wählen Sie eine seiner eigenen.</translation>
    </message>
    <message>
        <source>The case &apos;%1&apos; is not in the library; import it, or choose another.</source>
        <translation>Der Fall „%1“ ist nicht in der Bibliothek; importieren Sie ihn, oder wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>The expert&apos;s scan is not recorded yet; record it, or leave the step out.</source>
        <translation>Die Untersuchung des Experten ist noch nicht aufgezeichnet; zeichnen Sie sie auf, oder lassen Sie den Schritt weg.</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; of the lesson is not in the case folder; put it into parts/lessons, or choose another.</source>
        <translation>Die Datei „%1“ der Lektion ist nicht im Ordner des Falls; legen Sie sie in parts/lessons ab, oder wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>The lesson has no steps; add one.</source>
        <translation>Die Lektion hat keine Schritte; fügen Sie einen hinzu.</translation>
    </message>
    <message>
        <source>There is no question; write one.</source>
        <translation>Es gibt keine Frage; schreiben Sie eine.</translation>
    </message>
    <message>
        <source>There is nothing to read; write a text.</source>
        <translation>Es gibt nichts zu lesen; schreiben Sie einen Text.</translation>
    </message>
    <message>
        <source>a structure with a label, or a point or a plane</source>
        <translation>eine Struktur mit label, oder ein Punkt oder eine Ebene</translation>
    </message>
    <message>
        <source>given, and the case has no labels</source>
        <translation>angegeben, und der Fall hat keine labels</translation>
    </message>
    <message>
        <source>left out, or a number of volume.labels</source>
        <translation>weggelassen, oder eine Nummer aus volume.labels</translation>
    </message>
    <message>
        <source>missing, and the case has no patient who could know it</source>
        <translation>nicht da, und der Fall hat keinen Patienten, der ihn wissen könnte</translation>
    </message>
    <message>
        <source>the number of the structure in the labels of the volume</source>
        <translation>die Nummer der Struktur in den labels des Volumens</translation>
    </message>
    <message>
        <source>the value as it was measured</source>
        <translation>der gemessene Wert</translation>
    </message>
    <message>
        <source>There is no window in which a case could be opened.</source>
        <translation>Es gibt kein Fenster, in dem ein Fall geöffnet werden könnte.</translation>
    </message>
    <message>
        <source>an object with format and lessons</source>
        <translation>ein Objekt mit format und lessons</translation>
    </message>
    <message>
        <source>a list of at most 200 lessons</source>
        <translation>eine Liste von höchstens 200 Lektionen</translation>
    </message>
    <message>
        <source>a lesson: an object with id, title and steps</source>
        <translation>eine Lektion: ein Objekt mit id, title und steps</translation>
    </message>
    <message>
        <source>a short name, unique in the case, of 1 to 100 characters</source>
        <translation>ein kurzer Name von 1 bis 100 Zeichen, den es im Fall einmal gibt</translation>
    </message>
    <message>
        <source>a title of 1 to 200 characters that gives no finding away</source>
        <translation>ein Titel von 1 bis 200 Zeichen, der keinen Befund verrät</translation>
    </message>
    <message>
        <source>text: what one can do afterwards</source>
        <translation>Text: was man danach kann</translation>
    </message>
    <message>
        <source>a whole number from 1 (first steps) to 5 (examination)</source>
        <translation>eine ganze Zahl von 1 (erste Schritte) bis 5 (Prüfung)</translation>
    </message>
    <message>
        <source>a whole number from 1 to 600: about how long it takes</source>
        <translation>eine ganze Zahl von 1 bis 600: wie lange es ungefähr dauert</translation>
    </message>
    <message>
        <source>a list of texts: what it teaches after</source>
        <translation>eine Liste von Texten: wonach sie lehrt</translation>
    </message>
    <message>
        <source>the language of its texts, such as &quot;en&quot; or &quot;de&quot;</source>
        <translation>die Sprache der Texte, etwa &quot;en&quot; oder &quot;de&quot;</translation>
    </message>
    <message>
        <source>a list of at most 200 steps</source>
        <translation>eine Liste von höchstens 200 Schritten</translation>
    </message>
    <message>
        <source>a step: an object with id, title and task</source>
        <translation>ein Schritt: ein Objekt mit id, title und task</translation>
    </message>
    <message>
        <source>a short name, unique in the lesson, of 1 to 100 characters</source>
        <translation>ein kurzer Name von 1 bis 100 Zeichen, den es in der Lektion einmal gibt</translation>
    </message>
    <message>
        <source>&quot;read&quot;, &quot;watch&quot;, &quot;plane&quot;, &quot;sweep&quot;, &quot;measure&quot;, &quot;point&quot;, &quot;settings&quot;, &quot;answer&quot; or &quot;free&quot;</source>
        <translation>&quot;read&quot;, &quot;watch&quot;, &quot;plane&quot;, &quot;sweep&quot;, &quot;measure&quot;, &quot;point&quot;, &quot;settings&quot;, &quot;answer&quot; oder &quot;free&quot;</translation>
    </message>
    <message>
        <source>text of at most 20000 characters: what to do</source>
        <translation>Text von höchstens 20000 Zeichen: was zu tun ist</translation>
    </message>
    <message>
        <source>text of at most 20000 characters: what to look for</source>
        <translation>Text von höchstens 20000 Zeichen: worauf zu achten ist</translation>
    </message>
    <message>
        <source>text of at most 20000 characters: said when the step is over</source>
        <translation>Text von höchstens 20000 Zeichen: was nach dem Schritt gesagt wird</translation>
    </message>
    <message>
        <source>the id of the case that is scanned; left out: the case that holds the lesson</source>
        <translation>die Kennung des Falls, der geschallt wird; weggelassen: der Fall, zu dem die Lektion gehört</translation>
    </message>
    <message>
        <source>a list of at most 50 texts</source>
        <translation>eine Liste von höchstens 50 Texten</translation>
    </message>
    <message>
        <source>an object that says which aids may be switched on</source>
        <translation>ein Objekt, das sagt, welche Hilfen eingeschaltet werden dürfen</translation>
    </message>
    <message>
        <source>true or false: whether it is said while scanning how far off one is</source>
        <translation>true oder false: ob beim Schallen gesagt wird, wie weit man daneben ist</translation>
    </message>
    <message>
        <source>the least score, a number from 0 to 1</source>
        <translation>die kleinste Punktzahl, eine Zahl von 0 bis 1</translation>
    </message>
    <message>
        <source>the seconds that the step may take, a number from 5 to 7200</source>
        <translation>die Sekunden, die der Schritt dauern darf, eine Zahl von 5 bis 7200</translation>
    </message>
    <message>
        <source>text: why the patient came</source>
        <translation>Text: weshalb der Patient kam</translation>
    </message>
    <message>
        <source>a list of at most 50 pictures inside the case folder, as relative paths such as &quot;media/liver.png&quot;</source>
        <translation>eine Liste von höchstens 50 Bildern im Ordner des Falls, als relative Pfade wie &quot;media/liver.png&quot;</translation>
    </message>
    <message>
        <source>a relative path such as &quot;media/liver.png&quot;</source>
        <translation>ein relativer Pfad wie &quot;media/liver.png&quot;</translation>
    </message>
    <message>
        <source>a list of objects with when and findings</source>
        <translation>eine Liste von Objekten mit when und findings</translation>
    </message>
    <message>
        <source>an object with when and findings, each a text</source>
        <translation>ein Objekt mit when und findings, jeweils ein Text</translation>
    </message>
    <message>
        <source>a list of texts: what else it could have been</source>
        <translation>eine Liste von Texten: was es sonst hätte sein können</translation>
    </message>
    <message>
        <source>a list of at most 100 texts of 1 to 100 characters, by which the case is found</source>
        <translation>eine Liste von höchstens 100 Texten von 1 bis 100 Zeichen, unter denen der Fall gefunden wird</translation>
    </message>
    <message>
        <source>a text of 1 to 100 characters</source>
        <translation>ein Text von 1 bis 100 Zeichen</translation>
    </message>
    <message>
        <source>a whole number from 1 to 255, of a structure: its number in volume.labels</source>
        <translation>eine ganze Zahl von 1 bis 255, bei einer Struktur: ihre Nummer in volume.labels</translation>
    </message>
    <message>
        <source>an object with the name of a measurement of the patient, or with name, value, kind and unit</source>
        <translation>ein Objekt mit dem Namen einer Messung des Patienten, oder mit name, value, kind und unit</translation>
    </message>
    <message>
        <source>a number, in the measurement&apos;s unit: as it was measured</source>
        <translation>eine Zahl, in der Einheit der Messung: wie gemessen wurde</translation>
    </message>
    <message>
        <source>&quot;distance&quot;, &quot;circumference&quot;, &quot;area&quot; or &quot;angle&quot;</source>
        <translation>&quot;distance&quot;, &quot;circumference&quot;, &quot;area&quot; oder &quot;angle&quot;</translation>
    </message>
    <message>
        <source>the unit of the value: &quot;mm&quot;, &quot;cm2&quot; or &quot;deg&quot;</source>
        <translation>die Einheit des Werts: &quot;mm&quot;, &quot;cm2&quot; oder &quot;deg&quot;</translation>
    </message>
    <message>
        <source>a list of at most 1000 points, each three numbers in mm: where the calipers stood</source>
        <translation>eine Liste von höchstens 1000 Punkten, jeweils drei Zahlen in mm: wo die Messpunkte standen</translation>
    </message>
    <message>
        <source>a lesson that the course does not hold yet</source>
        <translation>eine Lektion, die der Kurs noch nicht enthält</translation>
    </message>
    <message>
        <source>given where there is no pose, and left out else</source>
        <translation>angegeben, wo keine Lage steht, und sonst weggelassen</translation>
    </message>
    <message>
        <source>The case &apos;%1&apos; has no plane &apos;%2&apos; to put the probe on; name one that it has: %3.</source>
        <translation>Der Fall „%1“ hat keine Ebene „%2“, auf die der Schallkopf gesetzt werden kann; eine nennen, die er hat: %3.</translation>
    </message>
    <message>
        <source>Recording the expert&apos;s scan was stopped.</source>
        <translation>Die Aufnahme des Expertenscans wurde abgebrochen.</translation>
    </message>
    <message>
        <source>No way on the skin leads straight from station %1 to station %2; put a station between them.</source>
        <translation>Auf der Haut führt kein gerader Weg von Station %1 zu Station %2; eine Station dazwischensetzen.</translation>
    </message>
    <message>
        <source>Recording the expert&apos;s scan</source>
        <translation>Expertenscan wird aufgenommen</translation>
    </message>
    <message>
        <source>The case &apos;%1&apos; has no lesson &apos;%2&apos;; it has %3.</source>
        <translation>Der Fall „%1“ hat keine Lektion „%2“; er hat %3.</translation>
    </message>
    <message>
        <source>The recording &apos;%1&apos; is a scan of the case &apos;%2&apos;, and the step scans &apos;%3&apos;; record it there, or choose another.</source>
        <translation>Die Aufzeichnung „%1“ ist ein Scan des Falls „%2“, und der Schritt untersucht „%3“; dort aufnehmen oder eine andere wählen.</translation>
    </message>
    <message>
        <source>A mark stands at %1 s, and the recording &apos;%2&apos; is from %3 to %4 s; move the mark.</source>
        <translation>Eine Marke steht bei %1 s, und die Aufzeichnung „%2“ reicht von %3 bis %4 s; die Marke verschieben.</translation>
    </message>
    <message>
        <source>The lessons of &apos;%1&apos; have %2; correct what is listed.</source>
        <translation>Die Lektionen von „%1“ haben %2; das Aufgelistete berichtigen.</translation>
    </message>
    <message>
        <source>The case &apos;%1&apos; has no probe &apos;%2&apos;; choose one of its own.</source>
        <translation>Der Fall „%1“ hat keinen Schallkopf „%2“; einen seiner eigenen wählen.</translation>
    </message>
    <message>
        <source>Of the course &apos;%1&apos; %2 cannot be found; import their cases, or take them out of it.</source>
        <translation>Vom Kurs „%1“ ist nicht zu finden: %2; deren Fälle importieren oder sie herausnehmen.</translation>
    </message>
    <message>
        <source>You are there: hold the probe still.</source>
        <translation>Das ist die Ebene: den Schallkopf ruhig halten.</translation>
    </message>
    <message>
        <source>Slide %1 mm %2.</source>
        <translation>%1 mm %2 schieben.</translation>
    </message>
    <message>
        <source>Rotate clockwise by %1 degrees.</source>
        <translation>Um %1 Grad im Uhrzeigersinn drehen.</translation>
    </message>
    <message>
        <source>Rotate anticlockwise by %1 degrees.</source>
        <translation>Um %1 Grad gegen den Uhrzeigersinn drehen.</translation>
    </message>
    <message>
        <source>The marker points the wrong way: turn the probe round.</source>
        <translation>Die Markierung zeigt in die falsche Richtung: den Schallkopf umdrehen.</translation>
    </message>
    <message>
        <source>Tilt the beam by %1 degrees %2.</source>
        <translation>Den Schallstrahl um %1 Grad %2 fächern.</translation>
    </message>
    <message>
        <source>Rock the beam by %1 degrees %2.</source>
        <translation>Den Schallstrahl um %1 Grad %2 kippen.</translation>
    </message>
    <message>
        <source>Press the probe in by %1 mm.</source>
        <translation>Den Schallkopf um %1 mm eindrücken.</translation>
    </message>
    <message>
        <source>Lift the probe by %1 mm.</source>
        <translation>Den Schallkopf um %1 mm anheben.</translation>
    </message>
    <message>
        <source>This plane cannot be reached from the skin; choose another one.</source>
        <translation>Diese Ebene ist von der Haut aus nicht zu erreichen; eine andere wählen.</translation>
    </message>
    <message>
        <source>towards the patient&apos;s left</source>
        <translation>zur linken Seite des Patienten</translation>
    </message>
    <message>
        <source>towards the patient&apos;s right</source>
        <translation>zur rechten Seite des Patienten</translation>
    </message>
    <message>
        <source>towards the patient&apos;s head</source>
        <translation>zum Kopf des Patienten</translation>
    </message>
    <message>
        <source>towards the patient&apos;s feet</source>
        <translation>zu den Füßen des Patienten</translation>
    </message>
    <message>
        <source>towards the patient&apos;s front</source>
        <translation>zur Vorderseite des Patienten</translation>
    </message>
    <message>
        <source>towards the patient&apos;s back</source>
        <translation>zum Rücken des Patienten</translation>
    </message>
    <message>
        <source>The probe was not seen; hold it where the tracker sees it.</source>
        <translation>Der Schallkopf wurde nicht gesehen; ihn dort halten, wo der Tracker ihn sieht.</translation>
    </message>
    <message>
        <source>The plane is found: %1 degrees and %2 mm from the expert&apos;s.</source>
        <translation>Die Ebene ist gefunden: %1 Grad und %2 mm neben der des Experten.</translation>
    </message>
    <message>
        <source>The plane is tipped by %1 degrees; %2 degrees are allowed.</source>
        <translation>Die Ebene ist um %1 Grad gekippt; erlaubt sind %2 Grad.</translation>
    </message>
    <message>
        <source>What matters lies %1 mm beside the plane; %2 mm are allowed.</source>
        <translation>Worauf es ankommt, liegt %1 mm neben der Ebene; erlaubt sind %2 mm.</translation>
    </message>
    <message>
        <source>What matters lies %1 mm elsewhere in the image; bring it to where the expert has it.</source>
        <translation>Worauf es ankommt, liegt im Bild %1 mm anderswo; es dorthin bringen, wo der Experte es hat.</translation>
    </message>
    <message>
        <source>The marker points the wrong way; left and right are exchanged.</source>
        <translation>Die Markierung zeigt in die falsche Richtung; links und rechts sind vertauscht.</translation>
    </message>
    <message>
        <source>That is it.</source>
        <translation>Das ist es.</translation>
    </message>
    <message>
        <source>The point lies %1 mm beside it.</source>
        <translation>Der Punkt liegt %1 mm daneben.</translation>
    </message>
    <message>
        <source>The images passed through %1 % of it.</source>
        <translation>Die Bilder gingen durch %1 % davon.</translation>
    </message>
    <message>
        <source>The images passed through %1 % of it; %2 % are needed.</source>
        <translation>Die Bilder gingen durch %1 % davon; nötig sind %2 %.</translation>
    </message>
    <message>
        <source>Measured: %1 %2; the expert has %3 %2.</source>
        <translation>Gemessen: %1 %2; der Experte hat %3 %2.</translation>
    </message>
    <message>
        <source>%1 %2 were measured; it is %3 %2, and %4 %2 more or less are allowed.</source>
        <translation>Gemessen wurden %1 %2; es sind %3 %2, und %4 %2 mehr oder weniger sind erlaubt.</translation>
    </message>
    <message>
        <source>The calipers stand %1 mm from where they belong.</source>
        <translation>Die Messpunkte stehen %1 mm neben ihrem Ort.</translation>
    </message>
    <message>
        <source>The plane cannot be reached from the skin.</source>
        <translation>Die Ebene ist von der Haut aus nicht zu erreichen.</translation>
    </message>
    <message>
        <source>The case has no voxels of it.</source>
        <translation>Der Fall hat davon keine Voxel.</translation>
    </message>
    <message>
        <source>It comes into no picture from the skin.</source>
        <translation>Von der Haut aus kommt es in kein Bild.</translation>
    </message>
    <message>
        <source>It fills so much of most pictures that pointing at random would do.</source>
        <translation>Es füllt so viel der meisten Bilder, dass es zufälliges Zeigen träfe.</translation>
    </message>
    <message>
        <source>It is in nearly every picture, so that there is nothing to look for.</source>
        <translation>Es ist in fast jedem Bild, sodass es nichts zu suchen gibt.</translation>
    </message>
    <message>
        <source>Calipers alone cannot measure it.</source>
        <translation>Mit Messpunkten allein ist es nicht zu messen.</translation>
    </message>
    <message>
        <source>Its tolerance is finer than calipers can be set.</source>
        <translation>Seine Toleranz ist feiner, als Messpunkte gesetzt werden können.</translation>
    </message>
    <message>
        <source>Its points do not read its value.</source>
        <translation>Seine Punkte ergeben nicht seinen Wert.</translation>
    </message>
    <message>
        <source>The case does not have this target any more; take another exercise.</source>
        <translation>Der Fall hat dieses Ziel nicht mehr; eine andere Übung nehmen.</translation>
    </message>
    <message>
        <source>No point was set; click in the image.</source>
        <translation>Es wurde kein Punkt gesetzt; ins Bild klicken.</translation>
    </message>
    <message>
        <source>These points read nothing; set the calipers that the measurement needs.</source>
        <translation>Diese Punkte ergeben nichts; die Messpunkte setzen, die die Messung braucht.</translation>
    </message>
    <message>
        <source>an exercise that is not in the list yet</source>
        <translation>eine Übung, die noch nicht in der Liste steht</translation>
    </message>
    <message>
        <source>Hands follow the compass to %1</source>
        <translation>Hände folgen dem Kompass zu %1</translation>
    </message>
    <message>
        <source>Exercises are tried: %1</source>
        <translation>Übungen werden versucht: %1</translation>
    </message>
    <message>
        <source>Simulated people work through %1</source>
        <translation>Simulierte Personen arbeiten %1 durch</translation>
    </message>
    <message>
        <source>These cases have no lessons to work through; name others.</source>
        <translation>Diese Fälle haben keine Lektionen zum Durcharbeiten; andere nennen.</translation>
    </message>
    <message>
        <source>Attempts are written</source>
        <translation>Versuche werden geschrieben</translation>
    </message>
    <message>
        <source>The benchmark was stopped.</source>
        <translation>Die Messung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>%1 has no skin over its data to start on; look at its box.</source>
        <translation>%1 hat über seinen Daten keine Haut, um dort zu beginnen; seinen Quader ansehen.</translation>
    </message>
    <message>
        <source>%1 has no volume, so that nobody can be taught with it yet.</source>
        <translation>%1 hat kein Volumen, deshalb kann noch niemand damit unterrichtet werden.</translation>
    </message>
    <message>
        <source>There is no probe &quot;%1&quot;; see resources/probes.</source>
        <translation>Es gibt keinen Schallkopf „%1“; siehe resources/probes.</translation>
    </message>
    <message>
        <source>a list of at most 100 pairs of places</source>
        <translation>eine Liste von höchstens 100 Paaren von Stellen</translation>
    </message>
    <message>
        <source>three numbers: a place in the volume&apos;s own file, in mm</source>
        <translation>drei Zahlen: eine Stelle in der Datei des Volumens, in mm</translation>
    </message>
    <message>
        <source>three numbers: a place on the body, in mm</source>
        <translation>drei Zahlen: eine Stelle am Körper, in mm</translation>
    </message>
    <message>
        <source>the id of a named place of the mannequin</source>
        <translation>die Kennung einer benannten Stelle der Puppe</translation>
    </message>
    <message>
        <source>a text of at most 200 characters</source>
        <translation>ein Text von höchstens 200 Zeichen</translation>
    </message>
    <message>
        <source>A shape between outlines needs two of them at least; trace another one in another image plane.</source>
        <translation>Eine Form zwischen Umrissen braucht mindestens zwei davon; in einer anderen Bildebene noch einen ziehen.</translation>
    </message>
    <message>
        <source>Two of the traced planes cross within the outlines, so there is no shape between them; trace planes that lie side by side.</source>
        <translation>Zwei der umfahrenen Ebenen kreuzen sich innerhalb der Umrisse, dazwischen ist also keine Form; Ebenen umfahren, die nebeneinander liegen.</translation>
    </message>
    <message>
        <source>Filling between outlines</source>
        <translation>Zwischen Umrissen wird gefüllt</translation>
    </message>
    <message>
        <source>Growing from the seed</source>
        <translation>Vom Klick aus wachsen</translation>
    </message>
    <message>
        <source>Looking for the largest piece</source>
        <translation>Das größte Stück wird gesucht</translation>
    </message>
    <message>
        <source>The volume of this case stays in its file, so nothing can be painted in it; take a case whose volume fits into memory.</source>
        <translation>Das Volumen dieses Falls bleibt in seiner Datei, darin lässt sich also nicht malen; einen Fall nehmen, dessen Volumen in den Speicher passt.</translation>
    </message>
    <message>
        <source>What is painted cannot be kept in &apos;%1&apos;, so a crash would lose it; keep it in the case often.</source>
        <translation>Das Gemalte lässt sich nicht in „%1“ sichern, ein Absturz würde es verlieren; es oft im Fall aufheben.</translation>
    </message>
    <message>
        <source>Published cases are not edited in place, for attempts of trainees refer to them; save &apos;%1&apos; as a case of your own.</source>
        <translation>Veröffentlichte Fälle werden nicht an Ort und Stelle bearbeitet, denn Versuche von Lernenden beziehen sich auf sie; „%1“ als eigenen Fall speichern.</translation>
    </message>
    <message>
        <source>Nothing is measured in the image; draw a caliper first (Scan, Measure), then take it.</source>
        <translation>Im Bild ist nichts gemessen; erst eine Messung zeichnen (Scan, Messen), dann übernehmen.</translation>
    </message>
    <message>
        <source>No caliper in the image measures this kind of figure; draw one that does, or choose another kind.</source>
        <translation>Keine Messung im Bild misst diese Art; eine solche zeichnen oder eine andere Art wählen.</translation>
    </message>
    <message>
        <source>Choose a file.</source>
        <translation>Eine Datei wählen.</translation>
    </message>
    <message>
        <source>Another case was opened meanwhile; open the case again and give it the volume once more.</source>
        <translation>Inzwischen wurde ein anderer Fall geöffnet; den Fall wieder öffnen und ihm das Volumen noch einmal geben.</translation>
    </message>
    <message>
        <source>There is no picture &apos;%1&apos;; choose it again.</source>
        <translation>Es gibt kein Bild „%1“; noch einmal wählen.</translation>
    </message>
    <message>
        <source>The picture &apos;%1&apos; is larger than 20 MB; make it smaller first.</source>
        <translation>Das Bild „%1“ ist größer als 20 MB; erst verkleinern.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a PNG or JPEG picture; save it as one of these first.</source>
        <translation>„%1“ ist kein PNG- oder JPEG-Bild; erst als eines von beiden speichern.</translation>
    </message>
    <message>
        <source>The picture &apos;%1&apos; is damaged; choose another.</source>
        <translation>Das Bild „%1“ ist beschädigt; ein anderes wählen.</translation>
    </message>
    <message>
        <source>a list of at most 20 ids of console presets, such as &quot;abdomen-convex-3.5&quot;: the case starts with the first and offers all</source>
        <translation>eine Liste von höchstens 20 Kennungen von Voreinstellungen der Konsole, etwa &quot;abdomen-convex-3.5&quot;: Der Fall beginnt mit der ersten und bietet alle an</translation>
    </message>
    <message>
        <source>the id of a console preset, such as &quot;abdomen-convex-3.5&quot;</source>
        <translation>die Kennung einer Voreinstellung der Konsole, etwa &quot;abdomen-convex-3.5&quot;</translation>
    </message>
    <message>
        <source>a list of at most 20 ids of body marks, such as &quot;abdomen&quot;, which are offered first</source>
        <translation>eine Liste von höchstens 20 Kennungen von Körpermarken, etwa &quot;abdomen&quot;, die zuerst angeboten werden</translation>
    </message>
    <message>
        <source>the id of a body mark, such as &quot;abdomen&quot;</source>
        <translation>die Kennung einer Körpermarke, etwa &quot;abdomen&quot;</translation>
    </message>
    <message>
        <source>The images show a fan of %1 degrees; what lies around it is not taken.</source>
        <translation>Die Bilder zeigen einen Fächer von %1 Grad; was um ihn liegt, wird nicht genommen.</translation>
    </message>
    <message>
        <source>A scan without a valid pose cannot be compared; choose another one.</source>
        <translation>Ein Scan ohne gültige Pose lässt sich nicht vergleichen; einen anderen wählen.</translation>
    </message>
    <message>
        <source>Putting scans of %1 and %2 poses on one clock takes %3 MiB of memory; compare shorter parts of them.</source>
        <translation>Scans von %1 und %2 Posen auf eine Uhr zu bringen braucht %3 MiB Speicher; kürzere Teile von ihnen vergleichen.</translation>
    </message>
    <message>
        <source>Putting scans on one clock</source>
        <translation>Scans auf eine Uhr bringen</translation>
    </message>
    <message>
        <source>an id that no entry before it has</source>
        <translation>eine Kennung, die kein Eintrag davor hat</translation>
    </message>
    <message>
        <source>a whole number of the scale, %1 to %2, above that of the anchor before it</source>
        <translation>eine ganze Zahl der Skala, %1 bis %2, größer als die des Ankers davor</translation>
    </message>
    <message>
        <source>without one for an end of the scale</source>
        <translation>ohne einen Eintrag für ein Ende der Skala</translation>
    </message>
    <message>
        <source>a list that says what the scores %1 and %2 look like</source>
        <translation>eine Liste, die sagt, wie die Punktzahlen %1 und %2 aussehen</translation>
    </message>
    <message>
        <source>The rating form &apos;%1&apos; is left out: %2</source>
        <translation>Der Bewertungsbogen „%1“ wird ausgelassen: %2</translation>
    </message>
    <message>
        <source>rating forms</source>
        <translation>Bewertungsbögen</translation>
    </message>
    <message>
        <source>there is a form &apos;%1&apos; of version %2 already; give yours another id, or a higher version if it is yours.</source>
        <translation>einen Bogen „%1“ der Version %2 gibt es schon; dem eigenen eine andere Kennung geben, oder eine höhere Version, wenn es der eigene ist.</translation>
    </message>
    <message>
        <source>an object with the fields lowest and highest</source>
        <translation>ein Objekt mit den Feldern lowest und highest</translation>
    </message>
    <message>
        <source>the rating form %1</source>
        <translation>Bewertungsbogen %1</translation>
    </message>
    <message>
        <source>a name of 1 to %1 bytes on one line, without blanks at its ends</source>
        <translation>ein Name von 1 bis %1 Byte in einer Zeile, ohne Leerzeichen an den Enden</translation>
    </message>
    <message>
        <source>an item that was not answered before</source>
        <translation>eine Frage, die davor nicht beantwortet ist</translation>
    </message>
    <message>
        <source>missing, since the item is not applicable</source>
        <translation>nicht vorhanden, da die Frage nicht anwendbar ist</translation>
    </message>
    <message>
        <source>32 hexadecimal digits</source>
        <translation>32 hexadezimale Ziffern</translation>
    </message>
    <message>
        <source>the rating</source>
        <translation>Bewertung</translation>
    </message>
    <message>
        <source>an item of the form &apos;%1&apos;</source>
        <translation>eine Frage des Bogens „%1“</translation>
    </message>
    <message>
        <source>not applicable</source>
        <translation>nicht anwendbar</translation>
    </message>
    <message>
        <source>a score from %1 to %2: the form asks for it always</source>
        <translation>eine Punktzahl von %1 bis %2: der Bogen fragt immer danach</translation>
    </message>
    <message>
        <source>a score from %1 to %2</source>
        <translation>eine Punktzahl von %1 bis %2</translation>
    </message>
    <message>
        <source>answered twice</source>
        <translation>zweimal beantwortet</translation>
    </message>
    <message>
        <source>answered once</source>
        <translation>einmal beantwortet</translation>
    </message>
    <message>
        <source>not answered</source>
        <translation>nicht beantwortet</translation>
    </message>
    <message>
        <source>a pass level of the form &apos;%1&apos;</source>
        <translation>eine Bestehensgrenze des Bogens „%1“</translation>
    </message>
    <message>
        <source>answered before the rating is finished</source>
        <translation>beantwortet, bevor die Bewertung abgeschlossen wird</translation>
    </message>
    <message>
        <source>without a score</source>
        <translation>ohne Punktzahl</translation>
    </message>
    <message>
        <source>a list with a score for one item at least</source>
        <translation>eine Liste mit einer Punktzahl für mindestens eine Frage</translation>
    </message>
    <message>
        <source>an object with the fields id, version and content</source>
        <translation>ein Objekt mit den Feldern id, version und content</translation>
    </message>
    <message>
        <source>The ratings in &apos;%1&apos; cannot be read (%2); check that you may read the folder.</source>
        <translation>Die Bewertungen in „%1“ können nicht gelesen werden (%2); prüfen Sie, ob Sie den Ordner lesen dürfen.</translation>
    </message>
    <message>
        <source>The rating &apos;%1&apos; is left out: %2</source>
        <translation>Die Bewertung „%1“ wird ausgelassen: %2</translation>
    </message>
    <message>
        <source>its name is not that of what it holds; a copy of another rating counts for nothing.</source>
        <translation>ihr Name passt nicht zum Inhalt; die Kopie einer anderen Bewertung zählt nicht.</translation>
    </message>
    <message>
        <source>it is of the attempt &apos;%1&apos;; move it to the folder of that attempt.</source>
        <translation>sie gehört zum Versuch „%1“; in den Ordner jenes Versuchs verschieben.</translation>
    </message>
    <message>
        <source>the form that was kept with it is not the one that was answered; restore the folder from a copy.</source>
        <translation>der dabei aufbewahrte Bogen ist nicht der beantwortete; den Ordner aus einer Kopie wiederherstellen.</translation>
    </message>
    <message>
        <source>The rating has a text that is not UTF-8; write it again.</source>
        <translation>Die Bewertung enthält einen Text, der nicht UTF-8 ist; neu schreiben.</translation>
    </message>
    <message>
        <source>There are %1 ratings of &apos;%2&apos; already; that is as many as are kept.</source>
        <translation>Es gibt schon %1 Bewertungen von „%2“; mehr werden nicht aufbewahrt.</translation>
    </message>
    <message>
        <source>The system gives no random numbers for the key of the pseudonyms; try again.</source>
        <translation>Das System liefert keine Zufallszahlen für den Schlüssel der Pseudonyme; noch einmal versuchen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not the key of the pseudonyms; restore it from a copy, or move it away: everybody then gets other codes.</source>
        <translation>„%1“ ist nicht der Schlüssel der Pseudonyme; aus einer Kopie wiederherstellen oder wegräumen: dann erhalten alle andere Codes.</translation>
    </message>
    <message>
        <source>1 to %1 small letters, digits and hyphens, the first no hyphen</source>
        <translation>1 bis %1 Kleinbuchstaben, Ziffern und Bindestriche, am Anfang kein Bindestrich</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; cannot be made (%2); free some space, or choose a library you may write to.</source>
        <translation>Der Ordner „%1“ kann nicht angelegt werden (%2); Platz schaffen, oder eine Bibliothek wählen, in die geschrieben werden darf.</translation>
    </message>
    <message>
        <source>Another window is writing into &apos;%1&apos;; try again in a moment.</source>
        <translation>Ein anderes Fenster schreibt gerade in „%1“; gleich noch einmal versuchen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be kept for yourself alone (%2); choose a place of your own.</source>
        <translation>„%1“ lässt sich nicht für Sie allein aufbewahren (%2); einen eigenen Ort wählen.</translation>
    </message>
    <message>
        <source>it is no file</source>
        <translation>es ist keine Datei</translation>
    </message>
    <message>
        <source>it belongs to another account</source>
        <translation>es gehört einem anderen Konto</translation>
    </message>
    <message>
        <source>it names no folder</source>
        <translation>es nennt keinen Ordner</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not there; check the name and the folder.</source>
        <translation>„%1“ ist nicht da; Namen und Ordner prüfen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a link, and a private file is not read through one; put the file itself there.</source>
        <translation>„%1“ ist eine Verknüpfung, und durch eine solche wird keine private Datei gelesen; die Datei selbst dorthin legen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be opened (%2); check its permissions.</source>
        <translation>„%1“ lässt sich nicht öffnen (%2); die Zugriffsrechte prüfen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not read, because %2; use a file of your own.</source>
        <translation>„%1“ wird nicht gelesen (%2); eine eigene Datei verwenden.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; can be read or changed by other accounts, so it is not trusted; close it with &apos;chmod 600&apos;, and replace what it keeps secret.</source>
        <translation>„%1“ kann von anderen Konten gelesen oder geändert werden, daher wird ihr nicht vertraut; sie mit „chmod 600“ schließen und ersetzen, was sie geheim hält.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has more than the %2 bytes allowed here; check that it is the right file.</source>
        <translation>„%1“ hat mehr als die hier erlaubten %2 Bytes; prüfen, ob es die richtige Datei ist.</translation>
    </message>
    <message>
        <source>answers are not shown</source>
        <translation>werden keine Antworten gezeigt</translation>
    </message>
    <message>
        <source>cases are not edited</source>
        <translation>werden keine Fälle bearbeitet</translation>
    </message>
    <message>
        <source>cases are not handed on</source>
        <translation>werden keine Fälle weitergegeben</translation>
    </message>
    <message>
        <source>other people&apos;s attempts are not shown</source>
        <translation>werden keine Versuche anderer gezeigt</translation>
    </message>
    <message>
        <source>attempts are not judged</source>
        <translation>werden keine Versuche bewertet</translation>
    </message>
    <message>
        <source>the lock is not changed</source>
        <translation>wird die Sperre nicht geändert</translation>
    </message>
    <message>
        <source>This library is locked for trainees, so %1; an instructor unlocks it with the passphrase (in the window, or with --unlock).</source>
        <translation>Diese Bibliothek ist für Lernende gesperrt, darum %1; eine Lehrkraft entsperrt sie mit dem Kennwort (im Fenster oder mit --unlock).</translation>
    </message>
    <message>
        <source>The lock of this library cannot be opened: %1 Whoever looks after this machine can take &quot;%2&quot; away.</source>
        <translation>Die Sperre dieser Bibliothek lässt sich nicht öffnen: %1 Wer diesen Rechner betreut, kann „%2“ entfernen.</translation>
    </message>
    <message>
        <source>That is not the passphrase of this library; type it again.</source>
        <translation>Das ist nicht das Kennwort dieser Bibliothek; noch einmal eingeben.</translation>
    </message>
    <message>
        <source>The lock &quot;%1&quot; cannot be taken away (%2); check the folder&apos;s permissions.</source>
        <translation>Die Sperre „%1“ lässt sich nicht entfernen (%2); die Zugriffsrechte des Ordners prüfen.</translation>
    </message>
    <message>
        <source>a line of the instructors&apos; log</source>
        <translation>einer Zeile im Protokoll der Lehrkräfte</translation>
    </message>
    <message>
        <source>%1 bytes in base64</source>
        <translation>%1 Bytes in Base64</translation>
    </message>
    <message>
        <source>This is no public key; it is one line that begins with %1, from &apos;echoweave key show&apos;.</source>
        <translation>Das ist kein öffentlicher Schlüssel; er ist eine Zeile, die mit %1 beginnt, von „echoweave key show“.</translation>
    </message>
    <message>
        <source>This public key is of another kind (%1); use it with a newer EchoWeave.</source>
        <translation>Dieser öffentliche Schlüssel ist von anderer Art (%1); ihn mit einem neueren EchoWeave verwenden.</translation>
    </message>
    <message>
        <source>The public key was not copied right: its checksum does not fit; copy the whole line again.</source>
        <translation>Der öffentliche Schlüssel wurde nicht richtig kopiert: Seine Prüfsumme passt nicht; die ganze Zeile noch einmal kopieren.</translation>
    </message>
    <message>
        <source>In &quot;%1&quot;: %2</source>
        <translation>In „%1“: %2</translation>
    </message>
    <message>
        <source>There is no memory that can be locked for the secret key; close other programs and try again.</source>
        <translation>Es gibt keinen Speicher, der sich für den geheimen Schlüssel sperren lässt; andere Programme schließen und es noch einmal versuchen.</translation>
    </message>
    <message>
        <source>There is a key in &quot;%1&quot; already, and without it no examination that was made for it can be judged; keep it, or move it away first.</source>
        <translation>In „%1“ liegt schon ein Schlüssel, und ohne ihn kann keine Prüfung bewertet werden, die für ihn gemacht wurde; ihn behalten oder zuerst anderswohin legen.</translation>
    </message>
    <message>
        <source>The passphrase does not open &quot;%1&quot;, or the file was changed; type it again.</source>
        <translation>Das Kennwort öffnet „%1“ nicht, oder die Datei wurde geändert; noch einmal eingeben.</translation>
    </message>
    <message>
        <source>The system gives no random numbers to make keys from; restart it, and please report it.</source>
        <translation>Das System gibt keine Zufallszahlen für Schlüssel her; es neu starten und das bitte melden.</translation>
    </message>
    <message>
        <source>There are not the %1 MiB of memory that a passphrase needs; close other programs and try again.</source>
        <translation>Die %1 MiB Speicher, die ein Kennwort braucht, sind nicht da; andere Programme schließen und es noch einmal versuchen.</translation>
    </message>
    <message>
        <source>The passphrase is too short; take at least %1 characters, best several words.</source>
        <translation>Das Kennwort ist zu kurz; mindestens %1 Zeichen nehmen, am besten mehrere Wörter.</translation>
    </message>
    <message>
        <source>The passphrase is longer than %1 bytes or holds characters that cannot be typed; take another one.</source>
        <translation>Das Kennwort ist länger als %1 Bytes oder enthält Zeichen, die sich nicht tippen lassen; ein anderes nehmen.</translation>
    </message>
    <message>
        <source>The picture is damaged; save it anew as a PNG.</source>
        <translation>Das Bild ist beschädigt; es neu als PNG speichern.</translation>
    </message>
    <message>
        <source>Pictures of an examination are PNG or JPEG, of which it is known where words may hide; save it as one.</source>
        <translation>Bilder einer Prüfung sind PNG oder JPEG, von denen bekannt ist, wo Wörter stecken können; es als ein solches speichern.</translation>
    </message>
    <message>
        <source>The picture &quot;%1&quot;: %2</source>
        <translation>Das Bild „%1“: %2</translation>
    </message>
    <message>
        <source>Sealing the answers</source>
        <translation>Antworten versiegeln</translation>
    </message>
    <message>
        <source>Say for whom the answers are sealed, with a public key from &apos;echoweave key show&apos;; without one nobody could judge the examination.</source>
        <translation>Angeben, für wen die Antworten versiegelt werden, mit einem öffentlichen Schlüssel von „echoweave key show“; ohne ihn könnte niemand die Prüfung bewerten.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be the id of an examination; take letters, digits, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;, at most 100.</source>
        <translation>„%1“ kann keine Kennung einer Prüfung sein; Buchstaben, Ziffern, „-“, „_“ und „.“ nehmen, höchstens 100.</translation>
    </message>
    <message>
        <source>The case &apos;%1&apos; is no examination: its answers are not sealed.</source>
        <translation>Der Fall „%1“ ist keine Prüfung: Seine Antworten sind nicht versiegelt.</translation>
    </message>
    <message>
        <source>The examination &apos;%1&apos; and its sealed answers do not belong together, or one of them was changed; use the bundle as it was exported.</source>
        <translation>Die Prüfung „%1“ und ihre versiegelten Antworten gehören nicht zusammen, oder eines davon wurde geändert; das Bündel so verwenden, wie es exportiert wurde.</translation>
    </message>
    <message>
        <source>The case &apos;%1&apos; is an examination already; hand on its bundle as it is.</source>
        <translation>Der Fall „%1“ ist schon eine Prüfung; sein Bündel so weitergeben, wie es ist.</translation>
    </message>
    <message>
        <source>Opening the sealed answers</source>
        <translation>Versiegelte Antworten öffnen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was changed, damaged or cut off since the examination was made; use the bundle as it was exported.</source>
        <translation>„%1“ wurde geändert, beschädigt oder abgeschnitten, seit die Prüfung gemacht wurde; das Bündel so verwenden, wie es exportiert wurde.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; holds no sealed answers; use the bundle as it was exported.</source>
        <translation>„%1“ enthält keine versiegelten Antworten; das Bündel so verwenden, wie es exportiert wurde.</translation>
    </message>
    <message>
        <source>the header of %1</source>
        <translation>dem Kopf von %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not there; use the bundle as it was exported.</source>
        <translation>„%1“ ist nicht da; das Bündel so verwenden, wie es exportiert wurde.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be opened; check its permissions.</source>
        <translation>„%1“ lässt sich nicht öffnen; die Zugriffsrechte prüfen.</translation>
    </message>
    <message>
        <source>Say for whom the answers are sealed, with 1 to %1 public keys; without one nobody could judge the examination.</source>
        <translation>Angeben, für wen die Antworten versiegelt werden, mit 1 bis %1 öffentlichen Schlüsseln; ohne einen könnte niemand die Prüfung bewerten.</translation>
    </message>
    <message>
        <source>The public key %1 cannot be used; make a new one with &apos;echoweave key new&apos;.</source>
        <translation>Der öffentliche Schlüssel %1 ist nicht brauchbar; mit „echoweave key new“ einen neuen machen.</translation>
    </message>
    <message>
        <source>The key %1 does not open the answers of the examination &apos;%2&apos;, which were sealed for %3; use that one.</source>
        <translation>Der Schlüssel %1 öffnet die Antworten der Prüfung „%2“ nicht, die für %3 versiegelt wurden; jenen verwenden.</translation>
    </message>
    <message>
        <source>the index of %1</source>
        <translation>dem Verzeichnis von %1</translation>
    </message>
    <message>
        <source>%1 names a file, &quot;%2&quot;, that is none of the case; do not use the examination.</source>
        <translation>%1 nennt eine Datei, „%2“, die keine des Falles ist; die Prüfung nicht verwenden.</translation>
    </message>
    <message>
        <source>The sealed answers do not hold what they list; use the bundle as it was exported.</source>
        <translation>Die versiegelten Antworten enthalten nicht, was sie aufführen; das Bündel so verwenden, wie es exportiert wurde.</translation>
    </message>
    <message>
        <source>The step &apos;%1&apos; of the lesson &apos;%2&apos; scans another case, &apos;%3&apos;, and an examination carries one case; let it scan its own.</source>
        <translation>Der Schritt „%1“ der Lektion „%2“ untersucht einen anderen Fall, „%3“, und eine Prüfung trägt einen einzigen; ihn den eigenen untersuchen lassen.</translation>
    </message>
    <message>
        <source>The case has no title for trainees, and its own may name the finding; give it one in the Author workspace.</source>
        <translation>Der Fall hat keinen Titel für Lernende, und sein eigener kann den Befund nennen; ihm unter Autor einen geben.</translation>
    </message>
    <message>
        <source>The case has a mannequin of its own, &apos;%1&apos;, whose file may say more than trainees should read; choose one of the program&apos;s for an examination.</source>
        <translation>Der Fall hat einen eigenen Übungskörper, „%1“, dessen Datei mehr sagen kann, als Lernende lesen sollen; für eine Prüfung einen des Programms wählen.</translation>
    </message>
    <message>
        <source>No lesson of the case asks for anything, so there is nothing to examine; give it a lesson with steps first.</source>
        <translation>Keine Lektion des Falles fragt nach etwas, darum gibt es nichts zu prüfen; ihm zuerst eine Lektion mit Schritten geben.</translation>
    </message>
    <message>
        <source>The attempt &apos;%1&apos; is at &apos;%2&apos; and not at the examination &apos;%3&apos;; judge it with its own.</source>
        <translation>Der Versuch „%1“ gehört zu „%2“ und nicht zur Prüfung „%3“; ihn mit seiner eigenen bewerten.</translation>
    </message>
    <message>
        <source>The attempt &apos;%1&apos; was made with other sealed answers than these; judge it with the bundle that its trainee had.</source>
        <translation>Der Versuch „%1“ wurde mit anderen versiegelten Antworten gemacht als diesen; ihn mit dem Bündel bewerten, das die Lernenden hatten.</translation>
    </message>
    <message>
        <source>The attempt &apos;%1&apos; is at the lesson &apos;%2&apos;, which the examination does not have.</source>
        <translation>Der Versuch „%1“ gehört zur Lektion „%2“, die es in der Prüfung nicht gibt.</translation>
    </message>
    <message>
        <source>The attempt &apos;%1&apos; names the step &apos;%2&apos;, which the examination does not have.</source>
        <translation>Der Versuch „%1“ nennt den Schritt „%2“, den es in der Prüfung nicht gibt.</translation>
    </message>
    <message>
        <source>The attempt &apos;%1&apos; is there twice; give each folder once.</source>
        <translation>Der Versuch „%1“ ist zweimal da; jeden Ordner einmal angeben.</translation>
    </message>
    <message>
        <source>Copying the attempts</source>
        <translation>Versuche kopieren</translation>
    </message>
    <message>
        <source>Nothing is measured in this image yet; freeze the image and set the calipers.</source>
        <translation>In diesem Bild ist noch nichts gemessen; das Bild einfrieren und die Messpunkte setzen.</translation>
    </message>
    <message>
        <source>The attempt &apos;%1&apos; is at an examination, whose answers are sealed; open them with &apos;echoweave case unseal&apos; and your key, and score what that makes.</source>
        <translation>Der Versuch „%1“ gehört zu einer Prüfung, deren Antworten versiegelt sind; sie mit „echoweave case unseal“ und dem eigenen Schlüssel öffnen und bewerten, was daraus wird.</translation>
    </message>
    <message>
        <source>an object with file and sha256: where the answers of an examination are</source>
        <translation>ein Objekt mit file und sha256: wo die Antworten einer Prüfung sind</translation>
    </message>
    <message>
        <source>&quot;answers.sealed&quot;</source>
        <translation>„answers.sealed“</translation>
    </message>
    <message>
        <source>Nothing can be written beside &quot;%1&quot;; choose another folder.</source>
        <translation>Neben „%1“ lässt sich nichts schreiben; einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>The picture &apos;%1&apos; is damaged.</source>
        <translation>Das Bild „%1“ ist beschädigt.</translation>
    </message>
    <message>
        <source>The answer to the step &apos;%1&apos; is no measurement with a value and a unit.</source>
        <translation>Die Antwort auf den Schritt „%1“ ist keine Messung mit Wert und Einheit.</translation>
    </message>
    <message>
        <source>The case &apos;%1&apos; is not in the library; import it, for a report of measurements names its patient.</source>
        <translation>Der Fall „%1“ ist nicht in der Bibliothek; importieren Sie ihn, denn ein Messbericht nennt seinen Patienten.</translation>
    </message>
    <message>
        <source>knew neither whose attempt it was nor other ratings</source>
        <translation>wusste weder, wessen Versuch es war, noch, wie andere bewerteten</translation>
    </message>
    <message>
        <source>knew whose attempt it was and could see other ratings</source>
        <translation>wusste, wessen Versuch es war, und konnte andere Bewertungen sehen</translation>
    </message>
    <message>
        <source>knew whose attempt it was</source>
        <translation>wusste, wessen Versuch es war</translation>
    </message>
    <message>
        <source>could see other ratings</source>
        <translation>konnte andere Bewertungen sehen</translation>
    </message>
    <message>
        <source>Items</source>
        <translation>Fragen</translation>
    </message>
    <message>
        <source>Item</source>
        <translation>Frage</translation>
    </message>
    <message>
        <source>Rating</source>
        <translation>Bewertung</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Bemerkung</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1, by %2</source>
        <translation>%1, von %2</translation>
    </message>
    <message>
        <source>Given</source>
        <translation>Abgegeben</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Gesamtwert</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Rater</source>
        <translation>Bewertende Person</translation>
    </message>
    <message>
        <source>Ratings</source>
        <translation>Bewertungen</translation>
    </message>
    <message>
        <source>Earlier scores</source>
        <translation>Frühere Ergebnisse</translation>
    </message>
    <message>
        <source>Kept as they were; they no longer count</source>
        <translation>Aufbewahrt, wie sie waren; sie zählen nicht mehr</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Scored</source>
        <translation>Ausgewertet</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>What the score was made of</source>
        <translation>Woraus das Ergebnis entstand</translation>
    </message>
    <message>
        <source>Attempt</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>Case and lesson</source>
        <translation>Fall und Lektion</translation>
    </message>
    <message>
        <source>Judged in the lesson by</source>
        <translation>In der Lektion beurteilt von</translation>
    </message>
    <message>
        <source>%1 by EchoWeave %2</source>
        <translation>%1 mit EchoWeave %2</translation>
    </message>
    <message>
        <source>Score number</source>
        <translation>Nummer des Ergebnisses</translation>
    </message>
    <message>
        <source>Version of scoring</source>
        <translation>Version der Auswertung</translation>
    </message>
    <message>
        <source>none: tasks alone, at the lesson&apos;s pass levels</source>
        <translation>keiner: nur die Aufgaben, mit den Bestehensgrenzen der Lektion</translation>
    </message>
    <message>
        <source>revision %1</source>
        <translation>Fassung %1</translation>
    </message>
    <message>
        <source>Compared with</source>
        <translation>Verglichen mit</translation>
    </message>
    <message>
        <source>no expert&apos;s attempt</source>
        <translation>keinem Versuch eines Experten</translation>
    </message>
    <message>
        <source>Key of all that went in</source>
        <translation>Schlüssel von allem, was einging</translation>
    </message>
    <message>
        <source>What the metrics are</source>
        <translation>Was die Messgrößen sind</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Messgröße</translation>
    </message>
    <message>
        <source>Definition</source>
        <translation>Definition</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>What is known of it</source>
        <translation>Was davon bekannt ist</translation>
    </message>
    <message>
        <source>What this is worth</source>
        <translation>Was das aussagt</translation>
    </message>
    <message>
        <source>When the steps were worked on; hollow: not passed then</source>
        <translation>Wann an den Schritten gearbeitet wurde; hohl: damals nicht bestanden</translation>
    </message>
    <message>
        <source>Score of each step that counts; dashed: what passes</source>
        <translation>Ergebnis jedes Schrittes, der zählt; gestrichelt: Bestehensgrenze</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Passes from</source>
        <translation>Bestanden ab</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Hints</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>not reached</source>
        <translation>nicht erreicht</translation>
    </message>
    <message>
        <source>Trainee</source>
        <translation>Lernende Person</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>Fall</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>Began</source>
        <translation>Begonnen</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Beendet</translation>
    </message>
    <message>
        <source>not finished</source>
        <translation>nicht beendet</translation>
    </message>
    <message>
        <source>Time on steps</source>
        <translation>Zeit an den Schritten</translation>
    </message>
    <message>
        <source>not scored yet</source>
        <translation>noch nicht ausgewertet</translation>
    </message>
    <message>
        <source>without a name</source>
        <translation>ohne Namen</translation>
    </message>
    <message>
        <source>%1 (passes from %2)</source>
        <translation>%1 (bestanden ab %2)</translation>
    </message>
    <message>
        <source>%1 (does not count)</source>
        <translation>%1 (zählt nicht)</translation>
    </message>
    <message>
        <source>Of the task itself</source>
        <translation>Von der Aufgabe selbst</translation>
    </message>
    <message>
        <source>Tries</source>
        <translation>Anläufe</translation>
    </message>
    <message>
        <source>%1, of which the last one counts</source>
        <translation>%1, von denen der letzte zählt</translation>
    </message>
    <message>
        <source>Images with a usable pose</source>
        <translation>Bilder mit brauchbarer Lage</translation>
    </message>
    <message>
        <source>Judged</source>
        <translation>Beurteilt</translation>
    </message>
    <message>
        <source>as in the lesson; its raw data are not there</source>
        <translation>wie in der Lektion; ihre Rohdaten sind nicht da</translation>
    </message>
    <message>
        <source>weight %1</source>
        <translation>Gewicht %1</translation>
    </message>
    <message>
        <source>no; off by default</source>
        <translation>nein; anfangs aus</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Messgrößen</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Expert</source>
        <translation>Experte</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>In the score</source>
        <translation>Im Ergebnis</translation>
    </message>
    <message>
        <source>What the task was judged by</source>
        <translation>Wonach die Aufgabe beurteilt wurde</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>(a drawing on the picture)</source>
        <translation>(eine Zeichnung auf dem Bild)</translation>
    </message>
    <message>
        <source>%1, at %2 of the scan: %3</source>
        <translation>%1, bei %2 der Untersuchung: %3</translation>
    </message>
    <message>
        <source>Comments</source>
        <translation>Kommentare</translation>
    </message>
    <message>
        <source>Stored picture: %1</source>
        <translation>Gespeichertes Bild: %1</translation>
    </message>
    <message>
        <source>Stored picture %1: %2</source>
        <translation>Gespeichertes Bild %1: %2</translation>
    </message>
    <message>
        <source>the expert</source>
        <translation>der Experte</translation>
    </message>
    <message>
        <source>this attempt</source>
        <translation>dieser Versuch</translation>
    </message>
    <message>
        <source>Way of the probe over the skin</source>
        <translation>Weg des Schallkopfs über die Haut</translation>
    </message>
    <message>
        <source>Step by step</source>
        <translation>Schritt für Schritt</translation>
    </message>
    <message>
        <source>Metrics of all attempts</source>
        <translation>Messgrößen aller Versuche</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Lowest</source>
        <translation>Kleinster Wert</translation>
    </message>
    <message>
        <source>Lower quartile</source>
        <translation>Unteres Quartil</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>Upper quartile</source>
        <translation>Oberes Quartil</translation>
    </message>
    <message>
        <source>Highest</source>
        <translation>Größter Wert</translation>
    </message>
    <message>
        <source>%1 (95 % interval %2 to %3)</source>
        <translation>%1 (95-%-Intervall %2 bis %3)</translation>
    </message>
    <message>
        <source>Agreement of two raters on each item</source>
        <translation>Übereinstimmung zweier Bewertender je Frage</translation>
    </message>
    <message>
        <source>Raters</source>
        <translation>Bewertende</translation>
    </message>
    <message>
        <source>Weighted kappa</source>
        <translation>Gewichtetes Kappa</translation>
    </message>
    <message>
        <source>Attempts that were rated</source>
        <translation>Bewertete Versuche</translation>
    </message>
    <message>
        <source>Of these by every rater</source>
        <translation>Davon von allen bewertet</translation>
    </message>
    <message>
        <source>Reliability of one rater, ICC(2,1)</source>
        <translation>Zuverlässigkeit einer bewertenden Person, ICC(2,1)</translation>
    </message>
    <message>
        <source>Reliability of their mean, ICC(2,k)</source>
        <translation>Zuverlässigkeit ihres Mittels, ICC(2,k)</translation>
    </message>
    <message>
        <source>Agreement</source>
        <translation>Übereinstimmung</translation>
    </message>
    <message>
        <source>needs two raters and two attempts that both rated, with ratings that differ</source>
        <translation>braucht zwei Bewertende und zwei Versuche, die beide bewertet haben, mit verschiedenen Bewertungen</translation>
    </message>
    <message>
        <source>%1 rates above the others by</source>
        <translation>%1 bewertet höher als die anderen um</translation>
    </message>
    <message>
        <source>Metrics, step by step</source>
        <translation>Messgrößen, Schritt für Schritt</translation>
    </message>
    <message>
        <source>The thick line is the expert&apos;s value.</source>
        <translation>Die dicke Linie ist der Wert des Experten.</translation>
    </message>
    <message>
        <source>How far raters agree</source>
        <translation>Wie weit die Bewertenden übereinstimmen</translation>
    </message>
    <message>
        <source>Ratings count that were given before the rater could see those of others. An ICC or kappa of 1 is full agreement, 0 is chance.</source>
        <translation>Es zählen Bewertungen, die abgegeben wurden, bevor die der anderen zu sehen waren. Ein ICC oder Kappa von 1 ist volle Übereinstimmung, 0 ist Zufall.</translation>
    </message>
    <message>
        <source>Pass levels by contrasting groups</source>
        <translation>Bestehensgrenzen aus gegensätzlichen Gruppen</translation>
    </message>
    <message>
        <source>Where the scores of those who should pass and of those who should not cross. Who should pass is what raters say with a form that has a pass level, where all of them say the same: their judgement, which does not know the score.</source>
        <translation>Wo sich die Ergebnisse derer, die bestehen sollen, und derer, die es nicht sollen, kreuzen. Wer bestehen soll, sagen Bewertende mit einem Bogen, der eine Bestehensgrenze hat, wo alle dasselbe sagen: ihr Urteil, das vom Ergebnis nichts weiß.</translation>
    </message>
    <message>
        <source>No level can be suggested: %1 attempts should pass and %2 should not; each group needs two or more with scores that differ, and those who should pass have to score higher.</source>
        <translation>Es kann keine Grenze vorgeschlagen werden: %1 Versuche sollen bestehen und %2 nicht; jede Gruppe braucht zwei oder mehr mit verschiedenen Ergebnissen, und wer bestehen soll, muss bessere haben.</translation>
    </message>
    <message>
        <source>%1 attempts should pass, %2 should not</source>
        <translation>%1 Versuche sollen bestehen, %2 nicht</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Passes from now</source>
        <translation>Jetzt bestanden ab</translation>
    </message>
    <message>
        <source>Suggested</source>
        <translation>Vorschlag</translation>
    </message>
    <message>
        <source>How sure</source>
        <translation>Wie sicher</translation>
    </message>
    <message>
        <source>every step</source>
        <translation>jeder Schritt</translation>
    </message>
    <message>
        <source>the groups do not differ as they should</source>
        <translation>die Gruppen unterscheiden sich nicht, wie sie sollten</translation>
    </message>
    <message>
        <source>The whole lesson</source>
        <translation>Die ganze Lektion</translation>
    </message>
    <message>
        <source>All attempts</source>
        <translation>Alle Versuche</translation>
    </message>
    <message>
        <source>Steps passed</source>
        <translation>Bestandene Schritte</translation>
    </message>
    <message>
        <source>%1 (half of them from %2 to %3)</source>
        <translation>%1 (die Hälfte von %2 bis %3)</translation>
    </message>
    <message>
        <source>Not scored yet</source>
        <translation>Noch nicht ausgewertet</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Median score</source>
        <translation>Median der Ergebnisse</translation>
    </message>
    <message>
        <source>These scores were made by different plans or versions of scoring; score all attempts again before comparing them.</source>
        <translation>Diese Ergebnisse stammen von verschiedenen Plänen oder Versionen der Auswertung; werten Sie alle Versuche neu aus, bevor Sie sie vergleichen.</translation>
    </message>
    <message>
        <source>Nobody failed a step that counts.</source>
        <translation>An keinem Schritt, der zählt, ist jemand gescheitert.</translation>
    </message>
    <message>
        <source>Hardest step: &apos;%1&apos;, which %2 of %3 did not pass.</source>
        <translation>Schwerster Schritt: „%1“, den %2 von %3 nicht bestanden.</translation>
    </message>
    <message>
        <source>Scores of the lesson; dashed: what passes</source>
        <translation>Ergebnisse der Lektion; gestrichelt: Bestehensgrenze</translation>
    </message>
    <message>
        <source>score</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Scores of each step: attempts, quartiles as a box; dashed: what passes</source>
        <translation>Ergebnisse jedes Schrittes: Versuche, Quartile als Kasten; gestrichelt: Bestehensgrenze</translation>
    </message>
    <message>
        <source>Not passed</source>
        <translation>Nicht bestanden</translation>
    </message>
    <message>
        <source>Skipped</source>
        <translation>Übersprungen</translation>
    </message>
    <message>
        <source>Not reached</source>
        <translation>Nicht erreicht</translation>
    </message>
    <message>
        <source>%1 (most fail here)</source>
        <translation>%1 (hier scheitern die meisten)</translation>
    </message>
    <message>
        <source>does not count</source>
        <translation>zählt nicht</translation>
    </message>
    <message>
        <source>%1: class</source>
        <translation>%1: Kurs</translation>
    </message>
    <message>
        <source>Nobody has tried this lesson yet.</source>
        <translation>Diese Lektion hat noch niemand versucht.</translation>
    </message>
    <message>
        <source>No attempt has a score yet; score them first (echoweave assess).</source>
        <translation>Noch kein Versuch ist ausgewertet; werten Sie sie zuerst aus (echoweave assess).</translation>
    </message>
    <message>
        <source>highest bar: %1</source>
        <translation>höchster Balken: %1</translation>
    </message>
    <message>
        <source>The picture &apos;%1&apos; is not in the attempt&apos;s folder.</source>
        <translation>Das Bild „%1“ ist nicht im Ordner des Versuchs.</translation>
    </message>
    <message>
        <source>The picture &apos;%1&apos; cannot be read, or is too large.</source>
        <translation>Das Bild „%1“ kann nicht gelesen werden oder ist zu groß.</translation>
    </message>
    <message>
        <source>The picture &apos;%1&apos; is neither a PNG nor a JPEG file.</source>
        <translation>Das Bild „%1“ ist weder eine PNG- noch eine JPEG-Datei.</translation>
    </message>
    <message>
        <source>There are no attempts to report on.</source>
        <translation>Es gibt keine Versuche, über die zu berichten wäre.</translation>
    </message>
    <message>
        <source>Writing reports was stopped.</source>
        <translation>Das Schreiben der Berichte wurde angehalten.</translation>
    </message>
    <message>
        <source>Reading attempts</source>
        <translation>Versuche werden gelesen</translation>
    </message>
    <message>
        <source>Reports of lessons</source>
        <translation>Berichte über Lektionen</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation>Alle Lektionen</translation>
    </message>
    <message>
        <source>Writing reports</source>
        <translation>Berichte werden geschrieben</translation>
    </message>
    <message>
        <source>The whole class</source>
        <translation>Der ganze Kurs</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>Simulation, training only: not for diagnosis.</source>
        <translation>Simulation, nur zur Ausbildung: nicht zur Diagnose.</translation>
    </message>
    <message>
        <source>Scores say how near the work came to the case&apos;s own truth. Metrics are figures of one attempt in one simulation: most of them have not been shown to tell skilled people from beginners, and none of them decides alone about a person.</source>
        <translation>Ergebnisse sagen, wie nahe die Arbeit der Wahrheit des Falles kam. Messgrößen sind Zahlen eines Versuchs in einer Simulation: Für die meisten ist nicht gezeigt, dass sie Geübte von Anfängern unterscheiden, und keine entscheidet allein über einen Menschen.</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>not passed</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>skipped</source>
        <translation>übersprungen</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>Watch the expert</source>
        <translation>Dem Experten zusehen</translation>
    </message>
    <message>
        <source>Find a plane</source>
        <translation>Eine Ebene finden</translation>
    </message>
    <message>
        <source>Sweep through a structure</source>
        <translation>Eine Struktur durchfahren</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Point at something</source>
        <translation>Auf etwas zeigen</translation>
    </message>
    <message>
        <source>Set the machine</source>
        <translation>Das Gerät einstellen</translation>
    </message>
    <message>
        <source>Answer a question</source>
        <translation>Eine Frage beantworten</translation>
    </message>
    <message>
        <source>Scan freely</source>
        <translation>Frei untersuchen</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rollwinkel</translation>
    </message>
    <message>
        <source>Shift in the picture</source>
        <translation>Verschiebung im Bild</translation>
    </message>
    <message>
        <source>Place of the probe</source>
        <translation>Ort des Schallkopfs</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Abdeckung</translation>
    </message>
    <message>
        <source>Value that was measured</source>
        <translation>Gemessener Wert</translation>
    </message>
    <message>
        <source>Off the expected value by</source>
        <translation>Abweichung vom erwarteten Wert</translation>
    </message>
    <message>
        <source>Calipers beside their place</source>
        <translation>Messpunkte neben ihrem Ort</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>95 % interval %1 to %2</source>
        <translation>95-%-Intervall %1 bis %2</translation>
    </message>
    <message>
        <source>Seen from the front; ring: beginning, square: end.</source>
        <translation>Von vorn gesehen; Ring: Anfang, Quadrat: Ende.</translation>
    </message>
    <message>
        <source>head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>minutes since the start</source>
        <translation>Minuten seit dem Beginn</translation>
    </message>
    <message>
        <source>seconds since the start</source>
        <translation>Sekunden seit dem Beginn</translation>
    </message>
    <message>
        <source>The attempt &apos;%1&apos; is left out: %2</source>
        <translation>Der Versuch „%1“ fehlt hier: %2</translation>
    </message>
    <message>
        <source>Scoring was stopped before this attempt.</source>
        <translation>Die Auswertung wurde vor diesem Versuch angehalten.</translation>
    </message>
    <message>
        <source>Reading the lesson &apos;%1&apos;</source>
        <translation>Die Lektion „%1“ wird gelesen</translation>
    </message>
    <message>
        <source>Scoring attempts</source>
        <translation>Versuche werden ausgewertet</translation>
    </message>
    <message>
        <source>one of the metrics that this program knows</source>
        <translation>eine der Messgrößen, die dieses Programm kennt</translation>
    </message>
    <message>
        <source>another number than the worst</source>
        <translation>eine andere Zahl als die schlechteste</translation>
    </message>
    <message>
        <source>above 0 where no metric counts</source>
        <translation>über 0, wo keine Messgröße zählt</translation>
    </message>
    <message>
        <source>the assessment plan</source>
        <translation>der Bewertungsplan</translation>
    </message>
    <message>
        <source>a step that is not in the list yet</source>
        <translation>ein Schritt, der noch nicht in der Liste ist</translation>
    </message>
    <message>
        <source>the score</source>
        <translation>das Ergebnis</translation>
    </message>
    <message>
        <source>Scoring was stopped.</source>
        <translation>Die Auswertung wurde angehalten.</translation>
    </message>
    <message>
        <source>The recording of the step &apos;%1&apos; cannot be read: %2</source>
        <translation>Die Aufzeichnung des Schrittes „%1“ kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>The step &apos;%1&apos; keeps the verdict it had: %2</source>
        <translation>Der Schritt „%1“ behält das Urteil, das er hatte: %2</translation>
    </message>
    <message>
        <source>The lesson &apos;%1&apos; of the case &apos;%2&apos; is not in the library; import the case.</source>
        <translation>Die Lektion „%1“ des Falles „%2“ ist nicht in der Bibliothek; importieren Sie den Fall.</translation>
    </message>
    <message>
        <source>The lesson has changed since it was tried, and how it was is not in the library; it is scored as it is now.</source>
        <translation>Die Lektion hat sich seit dem Versuch geändert, und wie sie war, ist nicht in der Bibliothek; sie wird ausgewertet, wie sie jetzt ist.</translation>
    </message>
    <message>
        <source>The case &apos;%1&apos; is not in the library; its steps keep the verdicts they had.</source>
        <translation>Der Fall „%1“ ist nicht in der Bibliothek; seine Schritte behalten die Urteile, die sie hatten.</translation>
    </message>
    <message>
        <source>The expert&apos;s attempt cannot be read; nothing is compared with it. %1</source>
        <translation>Der Versuch des Experten kann nicht gelesen werden; nichts wird damit verglichen. %1</translation>
    </message>
    <message>
        <source>Of 153 figures of one simulator 48 told novices from consultants; what this one says of skill has to be shown for each task.</source>
        <translation>Von 153 Größen eines Simulators unterschieden 48 Anfänger von Fachärzten; was diese über Können sagt, muss für jede Aufgabe gezeigt werden.</translation>
    </message>
    <message>
        <source>Ours; no published standard states it.</source>
        <translation>Unsere; kein veröffentlichter Standard nennt sie.</translation>
    </message>
    <message>
        <source>Common in studies of dexterity; integrated from polynomials through the poses, so that noise does not lengthen it.</source>
        <translation>Üblich in Untersuchungen der Handfertigkeit; aus Polynomen durch die Lagen integriert, damit Rauschen sie nicht verlängert.</translation>
    </message>
    <message>
        <source>From the first contact with the skin to handing in, pauses left out.</source>
        <translation>Vom ersten Kontakt mit der Haut bis zum Abgeben, ohne Pausen.</translation>
    </message>
    <message>
        <source>Time on task.</source>
        <translation>Zeit an der Aufgabe.</translation>
    </message>
    <message>
        <source>Told novices from experts in brain and spine tasks; says nothing where a step asks for a time.</source>
        <translation>Unterschied Anfänger von Experten in Aufgaben an Gehirn und Wirbelsäule; sagt nichts, wo ein Schritt eine Zeit verlangt.</translation>
    </message>
    <message>
        <source>Path length</source>
        <translation>Weglänge</translation>
    </message>
    <message>
        <source>Way of the middle of the probe&apos;s face.</source>
        <translation>Weg der Mitte der Schallkopffläche.</translation>
    </message>
    <message>
        <source>Told novices from experts in one of three tasks of one study.</source>
        <translation>Unterschied Anfänger von Experten in einer von drei Aufgaben einer Untersuchung.</translation>
    </message>
    <message>
        <source>Angular path</source>
        <translation>Winkelweg</translation>
    </message>
    <message>
        <source>Sum of all turns of the probe about any axis.</source>
        <translation>Summe aller Drehungen des Schallkopfs um beliebige Achsen.</translation>
    </message>
    <message>
        <source>Smoothness (spectral arc length)</source>
        <translation>Glätte (spektrale Bogenlänge)</translation>
    </message>
    <message>
        <source>Length of the curve of the speed&apos;s normalised spectrum up to 10 Hz, negative; nearer to 0 is smoother.</source>
        <translation>Länge der Kurve des normierten Spektrums der Geschwindigkeit bis 10 Hz, negativ; näher an 0 ist glatter.</translation>
    </message>
    <message>
        <source>Balasubramanian et al., J NeuroEng Rehabil 12:112, 2015, eq. 9.</source>
        <translation>Balasubramanian et al., J NeuroEng Rehabil 12:112, 2015, Gl. 9.</translation>
    </message>
    <message>
        <source>Smoothness (log dimensionless jerk)</source>
        <translation>Glätte (Logarithmus des dimensionslosen Rucks)</translation>
    </message>
    <message>
        <source>Jerk of the movements between two rests, made independent of their length and time; nearer to 0 is smoother.</source>
        <translation>Ruck der Bewegungen zwischen zwei Ruhen, unabhängig von ihrer Länge und Dauer gemacht; näher an 0 ist glatter.</translation>
    </message>
    <message>
        <source>Balasubramanian et al., J NeuroEng Rehabil 12:112, 2015, eq. 3.</source>
        <translation>Balasubramanian et al., J NeuroEng Rehabil 12:112, 2015, Gl. 3.</translation>
    </message>
    <message>
        <source>Jerk told novices from experts in brain and spine tasks.</source>
        <translation>Ruck unterschied Anfänger von Experten in Aufgaben an Gehirn und Wirbelsäule.</translation>
    </message>
    <message>
        <source>Working volume</source>
        <translation>Arbeitsraum</translation>
    </message>
    <message>
        <source>Volume of the convex hull of the places of the face, by its outermost points in 1024 directions.</source>
        <translation>Volumen der konvexen Hülle der Orte der Schallkopffläche, aus den äußersten Punkten in 1024 Richtungen.</translation>
    </message>
    <message>
        <source>Hulls of positions are common in studies of dexterity.</source>
        <translation>Hüllen von Orten sind in Untersuchungen der Handfertigkeit üblich.</translation>
    </message>
    <message>
        <source>Told novices from experts in brain and heart tasks.</source>
        <translation>Unterschied Anfänger von Experten in Aufgaben an Gehirn und Herz.</translation>
    </message>
    <message>
        <source>Idle share</source>
        <translation>Ruheanteil</translation>
    </message>
    <message>
        <source>Part of the time in which the probe moves slower than 2 mm/s and turns slower than 2 degrees/s.</source>
        <translation>Teil der Zeit, in dem sich der Schallkopf langsamer als 2 mm/s bewegt und langsamer als 2 Grad/s dreht.</translation>
    </message>
    <message>
        <source>Lost contact</source>
        <translation>Verlorener Kontakt</translation>
    </message>
    <message>
        <source>Part of the time after the first contact in which less than half of the face touches (gel fills 3 mm).</source>
        <translation>Teil der Zeit nach dem ersten Kontakt, in dem weniger als die Hälfte der Fläche anliegt (Gel füllt 3 mm).</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>How deep the face is pressed into the skin at its deepest point, as a mean over the time of contact. No force is measured.</source>
        <translation>Wie tief die Fläche an ihrem tiefsten Punkt in die Haut gedrückt wird, gemittelt über die Zeit des Kontakts. Eine Kraft wird nicht gemessen.</translation>
    </message>
    <message>
        <source>A mouse presses as firmly as the program says; only a tracked probe tells how firmly a hand presses.</source>
        <translation>Eine Maus drückt so fest, wie das Programm sagt; nur ein verfolgter Schallkopf sagt, wie fest eine Hand drückt.</translation>
    </message>
    <message>
        <source>As evaluations of plane finding state it (Di Vece et al., arXiv 2301.08317, 2023).</source>
        <translation>Wie es Untersuchungen der Ebenensuche angeben (Di Vece et al., arXiv 2301.08317, 2023).</translation>
    </message>
    <message>
        <source>It is the task itself, by the target that the case&apos;s author set.</source>
        <translation>Es ist die Aufgabe selbst, nach dem Ziel, das der Autor des Falles gesetzt hat.</translation>
    </message>
    <message>
        <source>Part of the voxels of the structures asked for that images passed through below a touching part of the face; shadows are not looked at.</source>
        <translation>Teil der Voxel der verlangten Strukturen, durch die Bilder unter einem anliegenden Teil der Fläche gingen; Schatten bleiben außer Betracht.</translation>
    </message>
    <message>
        <source>Plane: angle</source>
        <translation>Ebene: Winkel</translation>
    </message>
    <message>
        <source>Between the normals of the last image and of the target plane.</source>
        <translation>Zwischen den Normalen des letzten Bildes und der Zielebene.</translation>
    </message>
    <message>
        <source>Plane: roll</source>
        <translation>Ebene: Rollwinkel</translation>
    </message>
    <message>
        <source>Rotation within the plane that is left after the shortest turn of normal to normal.</source>
        <translation>Drehung in der Ebene, die nach der kürzesten Drehung von Normale zu Normale bleibt.</translation>
    </message>
    <message>
        <source>Plane: distance</source>
        <translation>Ebene: Abstand</translation>
    </message>
    <message>
        <source>Of the target&apos;s point of interest from the plane of the last image.</source>
        <translation>Des Punktes, auf den es ankommt, von der Ebene des letzten Bildes.</translation>
    </message>
    <message>
        <source>Plane: shift in the picture</source>
        <translation>Ebene: Verschiebung im Bild</translation>
    </message>
    <message>
        <source>How far the point of interest lies from where the target&apos;s picture has it, seen along the normal.</source>
        <translation>Wie weit der Punkt, auf den es ankommt, von seinem Ort im Bild des Ziels liegt, entlang der Normalen gesehen.</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>Landmarke</translation>
    </message>
    <message>
        <source>Of the click from the point, or from the nearest voxel of the structure.</source>
        <translation>Des Klicks vom Punkt oder vom nächsten Voxel der Struktur.</translation>
    </message>
    <message>
        <source>Trainees&apos; landmarks against the author&apos;s.</source>
        <translation>Landmarken der Lernenden gegen die des Autors.</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>Difference from the expected value, of that value.</source>
        <translation>Abweichung vom erwarteten Wert, bezogen auf diesen Wert.</translation>
    </message>
    <message>
        <source>Percent error against the author&apos;s reference.</source>
        <translation>Prozentualer Fehler gegen die Referenz des Autors.</translation>
    </message>
    <message>
        <source>Calipers</source>
        <translation>Messpunkte</translation>
    </message>
    <message>
        <source>Of the calipers from where they belong, in the better order; the farther of the two.</source>
        <translation>Der Messpunkte von ihrem Ort, in der besseren Reihenfolge; der weitere von beiden.</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>What is missing to all right options and no wrong one; of a number 0 within its tolerance, else 100.</source>
        <translation>Was zu allen richtigen Möglichkeiten und keiner falschen fehlt; bei einer Zahl 0 innerhalb ihrer Toleranz, sonst 100.</translation>
    </message>
    <message>
        <source>That were asked for.</source>
        <translation>Um die gebeten wurde.</translation>
    </message>
    <message>
        <source>Item 3 of OSAUS, image optimisation, as figures; ours.</source>
        <translation>Punkt 3 von OSAUS, Bildoptimierung, als Größen; unsere.</translation>
    </message>
    <message>
        <source>Gain beside the expert&apos;s</source>
        <translation>Verstärkung neben der des Experten</translation>
    </message>
    <message>
        <source>Of the last image, without its sign.</source>
        <translation>Des letzten Bildes, ohne Vorzeichen.</translation>
    </message>
    <message>
        <source>Depth beside the expert&apos;s</source>
        <translation>Tiefe neben der des Experten</translation>
    </message>
    <message>
        <source>Focus beside the expert&apos;s</source>
        <translation>Fokus neben dem des Experten</translation>
    </message>
    <message>
        <source>Distance from the expert&apos;s scan</source>
        <translation>Abstand von der Untersuchung des Experten</translation>
    </message>
    <message>
        <source>Mean distance of the poses of both scans, aligned by dynamic time warping; a turn counts with a lever of 60 mm.</source>
        <translation>Mittlerer Abstand der Lagen beider Untersuchungen, durch dynamische Zeitverzerrung zugeordnet; eine Drehung zählt mit einem Hebel von 60 mm.</translation>
    </message>
    <message>
        <source>Dynamic time warping: Sakoe and Chiba 1978; the lever is ours.</source>
        <translation>Dynamische Zeitverzerrung: Sakoe und Chiba 1978; der Hebel ist unserer.</translation>
    </message>
    <message>
        <source>No published threshold was found.</source>
        <translation>Keine veröffentlichte Grenze wurde gefunden.</translation>
    </message>
    <message>
        <source>Planes the expert visited</source>
        <translation>Ebenen, die der Experte besuchte</translation>
    </message>
    <message>
        <source>Part of the expert&apos;s planes that the trainee visited as well, within 10 mm and 15 degrees.</source>
        <translation>Teil der Ebenen des Experten, die auch besucht wurden, innerhalb von 10 mm und 15 Grad.</translation>
    </message>
    <message>
        <source>Nothing can be written to the folder &apos;%1&apos; (%2); check that you may write there.</source>
        <translation>In den Ordner „%1“ kann nichts geschrieben werden (%2); prüfen Sie, ob Sie dort schreiben dürfen.</translation>
    </message>
    <message>
        <source>No skin of %1 can be scanned, so that nobody can begin there.</source>
        <translation>Keine Haut von %1 kann untersucht werden, also kann dort niemand beginnen.</translation>
    </message>
    <message>
        <source>Looking for views of targets</source>
        <translation>Ansichten von Zielen werden gesucht</translation>
    </message>
</context>
<context>
    <name>ew::EffectInfo</name>
    <message>
        <source>Live echoes</source>
        <translation>Lebendige Echos</translation>
    </message>
    <message>
        <source>live echoes</source>
        <translation>lebendige Echos</translation>
    </message>
    <message>
        <source>Speckle is formed anew for every image, where the tissue is known</source>
        <translation>Speckle entsteht für jedes Bild neu, wo das Gewebe bekannt ist</translation>
    </message>
    <message>
        <source>Side lobes: what echoes beside a line add to it</source>
        <translation>Nebenkeulen: was Echos neben einer Linie zu ihr beitragen</translation>
    </message>
    <message>
        <source>Gain and TGC</source>
        <translation>Verstärkung und TGC</translation>
    </message>
    <message>
        <source>gain and TGC</source>
        <translation>Verstärkung und TGC</translation>
    </message>
    <message>
        <source>Gain and depth compensation act on the image</source>
        <translation>Verstärkung und Tiefenausgleich wirken auf das Bild</translation>
    </message>
    <message>
        <source>Beam width and focus</source>
        <translation>Strahlbreite und Fokus</translation>
    </message>
    <message>
        <source>beam width</source>
        <translation>Strahlbreite</translation>
    </message>
    <message>
        <source>The beam is narrow at the focus and wide elsewhere</source>
        <translation>Der Strahl ist im Fokus schmal und sonst breit</translation>
    </message>
    <message>
        <source>How much wider than recorded the beam is away from its focus</source>
        <translation>Wie viel breiter als aufgenommen der Strahl außerhalb des Fokus ist</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Slice thickness</source>
        <translation>Schichtdicke</translation>
    </message>
    <message>
        <source>slice thickness</source>
        <translation>Schichtdicke</translation>
    </message>
    <message>
        <source>The image is an average over the thickness of the beam</source>
        <translation>Das Bild ist ein Mittel über die Dicke des Strahls</translation>
    </message>
    <message>
        <source>Thickness of the slice, as a multiple of the probe&apos;s own</source>
        <translation>Dicke der Schicht als Vielfaches der Dicke der Sonde</translation>
    </message>
    <message>
        <source>%1 x</source>
        <translation>%1 x</translation>
    </message>
    <message>
        <source>Shadow and enhancement</source>
        <translation>Schatten, Verstärkung</translation>
    </message>
    <message>
        <source>shadow and enhancement</source>
        <translation>Schatten und Verstärkung</translation>
    </message>
    <message>
        <source>Dark behind stone, bone and gas, bright behind fluid</source>
        <translation>Dunkel hinter Stein, Knochen und Gas, hell hinter Flüssigkeit</translation>
    </message>
    <message>
        <source>What each millimetre of strong echoes takes from the sound behind it</source>
        <translation>Was jeder Millimeter starker Echos dem Schall dahinter nimmt</translation>
    </message>
    <message>
        <source>%1 dB/mm</source>
        <translation>%1 dB/mm</translation>
    </message>
    <message>
        <source>Reverberation</source>
        <translation>Nachhall</translation>
    </message>
    <message>
        <source>reverberation</source>
        <translation>Nachhall</translation>
    </message>
    <message>
        <source>Echoes repeated between the face and strong interfaces</source>
        <translation>Echos, die zwischen Sonde und starken Grenzflächen hin und her laufen</translation>
    </message>
    <message>
        <source>What the sound loses on each way there and back</source>
        <translation>Was der Schall auf jedem Hin- und Rückweg verliert</translation>
    </message>
    <message>
        <source>−%1 dB</source>
        <translation>−%1 dB</translation>
    </message>
    <message>
        <source>Mirror images</source>
        <translation>Spiegelbilder</translation>
    </message>
    <message>
        <source>mirror images</source>
        <translation>Spiegelbilder</translation>
    </message>
    <message>
        <source>Mirror images beyond smooth strong interfaces</source>
        <translation>Spiegelbilder hinter glatten starken Grenzflächen</translation>
    </message>
    <message>
        <source>Electronic noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>Noise of the amplifier, which depth compensation lifts</source>
        <translation>Rauschen des Verstärkers, das der Tiefenausgleich anhebt</translation>
    </message>
    <message>
        <source>Noise at the face, below full white; it grows with depth</source>
        <translation>Rauschen an der Sonde unter vollem Weiß; es wächst mit der Tiefe</translation>
    </message>
    <message>
        <source>Skin contact</source>
        <translation>Hautkontakt</translation>
    </message>
    <message>
        <source>skin contact</source>
        <translation>Hautkontakt</translation>
    </message>
    <message>
        <source>Where the face is off the skin the image goes dark and rings down</source>
        <translation>Wo die Sonde nicht aufliegt, wird das Bild dunkel und klingt nach</translation>
    </message>
    <message>
        <source>Gaps up to here are filled by gel</source>
        <translation>Spalte bis zu dieser Weite füllt das Gel</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Motion of the body</source>
        <translation>Bewegung des Körpers</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>The patient breathes, the pulse beats and the bowel moves</source>
        <translation>Der Patient atmet, der Puls schlägt und der Darm bewegt sich</translation>
    </message>
    <message>
        <source>How far tissue moves, of what the patient's own motion is</source>
        <translation>Wie weit sich Gewebe bewegt, gemessen an der eigenen Bewegung des Patienten</translation>
    </message>
</context>
<context>
    <name>ew::StepKind</name>
    <message>
        <source>live echoes</source>
        <translation>lebendige Echos</translation>
    </message>
    <message>
        <source>own grain</source>
        <translation>eigene Körnung</translation>
    </message>
    <message>
        <source>envelope</source>
        <translation>Hüllkurve</translation>
    </message>
    <message>
        <source>sample nearest</source>
        <translation>nächste abtasten</translation>
    </message>
    <message>
        <source>sample linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>sample cubic</source>
        <translation>Abtasten kubisch</translation>
    </message>
    <message>
        <source>stretch</source>
        <translation>gedehnt</translation>
    </message>
    <message>
        <source>slice thickness</source>
        <translation>Schichtdicke</translation>
    </message>
    <message>
        <source>tissues</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>shadow</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>reverberation</source>
        <translation>Nachhall</translation>
    </message>
    <message>
        <source>focus</source>
        <translation>Fokus</translation>
    </message>
    <message>
        <source>black</source>
        <translation>Schwarz</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>M-mode</source>
        <translation>M-Modus</translation>
    </message>
    <message>
        <source>scan conversion</source>
        <translation>Umsetzung</translation>
    </message>
    <message>
        <source>edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>persistence</source>
        <translation>Persistenz</translation>
    </message>
    <message>
        <source>table</source>
        <translation>Tabelle</translation>
    </message>
</context>
<context>
    <name>ew::case_authoring</name>
    <message>
        <source>Case</source>
        <translation>Fall</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Platzieren</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Ziele</translation>
    </message>
    <message>
        <source>&amp;New case…</source>
        <translation>&amp;Neuer Fall…</translation>
    </message>
</context>
<context>
    <name>ew::case_authoring::CasePanel</name>
    <message>
        <source>No case is open</source>
        <translation>Kein Fall ist geöffnet</translation>
    </message>
    <message>
        <source>Open a case from the start page, from the File menu, or by dropping its folder on the window. Then its patient, texts and volume can be edited here.</source>
        <translation>Einen Fall auf der Startseite oder im Menü Datei öffnen oder seinen Ordner auf das Fenster ziehen. Dann lassen sich Patient, Texte und Volumen hier bearbeiten.</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>Fall</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Change the title</source>
        <translation>Titel ändern</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Region</translation>
    </message>
    <message>
        <source>Change the region</source>
        <translation>Region ändern</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Change the patient&apos;s name</source>
        <translation>Namen des Patienten ändern</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Befund</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Vorgeschichte</translation>
    </message>
    <message>
        <source>Change the history</source>
        <translation>Vorgeschichte ändern</translation>
    </message>
    <message>
        <source>Indication</source>
        <translation>Fragestellung</translation>
    </message>
    <message>
        <source>Change the indication</source>
        <translation>Fragestellung ändern</translation>
    </message>
    <message>
        <source>Diagnosis</source>
        <translation>Diagnose</translation>
    </message>
    <message>
        <source>Change the diagnosis</source>
        <translation>Diagnose ändern</translation>
    </message>
    <message>
        <source>Volume in the body</source>
        <translation>Volumen im Körper</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>Copy the whole case into a new folder and go on there</source>
        <translation>Den ganzen Fall in einen neuen Ordner kopieren und dort weiterarbeiten</translation>
    </message>
    <message>
        <source>New folder for the case</source>
        <translation>Neuer Ordner für den Fall</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>keine Angabe</translation>
    </message>
    <message>
        <source>female</source>
        <translation>weiblich</translation>
    </message>
    <message>
        <source>male</source>
        <translation>männlich</translation>
    </message>
    <message>
        <source>other</source>
        <translation>divers</translation>
    </message>
    <message>
        <source>Change the patient&apos;s sex</source>
        <translation>Geschlecht ändern</translation>
    </message>
    <message>
        <source>Sex</source>
        <translation>Geschlecht</translation>
    </message>
    <message>
        <source> years</source>
        <translation> Jahre</translation>
    </message>
    <message>
        <source>Change the patient&apos;s age</source>
        <translation>Alter ändern</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Alter</translation>
    </message>
    <message>
        <source>Move the volume, %1</source>
        <translation>Volumen verschieben, %1</translation>
    </message>
    <message>
        <source>A marked field cannot be used as it is; correct it first, or undo.</source>
        <translation>Ein markiertes Feld ist so nicht brauchbar; zuerst berichtigen oder rückgängig machen.</translation>
    </message>
    <message>
        <source>● unsaved changes</source>
        <translation>● nicht gespeichert</translation>
    </message>
    <message>
        <source>saved</source>
        <translation>gespeichert</translation>
    </message>
    <message>
        <source>The case has changes that are not in its folder yet</source>
        <translation>Der Fall hat Änderungen, die noch nicht in seinem Ordner stehen</translation>
    </message>
    <message>
        <source>The folder holds the case as it is shown</source>
        <translation>Der Ordner enthält den Fall so, wie er hier steht</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>What a scan of this case has to show; nothing else is computed.</source>
        <translation>Was ein Scan dieses Falls zeigen muss; anderes wird nicht gerechnet.</translation>
    </message>
    <message>
        <source>Switch on: %1</source>
        <translation>Einschalten: %1</translation>
    </message>
    <message>
        <source>Switch off: %1</source>
        <translation>Ausschalten: %1</translation>
    </message>
    <message>
        <source>For trainees</source>
        <translation>Für Lernende</translation>
    </message>
    <message>
        <source>Change the title for trainees</source>
        <translation>Titel für Lernende ändern</translation>
    </message>
    <message>
        <source>Before the examination</source>
        <translation>Vor der Untersuchung</translation>
    </message>
    <message>
        <source>Change the findings</source>
        <translation>Befunde ändern</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Schallen</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>Attribution</source>
        <translation>Nennung</translation>
    </message>
    <message>
        <source>Change the attribution</source>
        <translation>Nennung ändern</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>Lizenz</translation>
    </message>
    <message>
        <source>Change the licence</source>
        <translation>Lizenz ändern</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Look for everything that is wrong with this case</source>
        <translation>Nach allem suchen, was an diesem Fall nicht stimmt</translation>
    </message>
    <message>
        <source>-copy</source>
        <translation>-Kopie</translation>
    </message>
    <message>
        <source>Case folders (*)</source>
        <translation>Fallordner (*)</translation>
    </message>
    <message>
        <source>one a line</source>
        <translation>je Zeile eins</translation>
    </message>
    <message>
        <source>Change the earlier examinations</source>
        <translation>Frühere Untersuchungen ändern</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Früher</translation>
    </message>
    <message>
        <source>Use the present one</source>
        <translation>Die jetzige nehmen</translation>
    </message>
    <message>
        <source>The probe begins where it is held now</source>
        <translation>Der Schallkopf beginnt dort, wo er jetzt liegt</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>The probe begins on the skin before the volume</source>
        <translation>Der Schallkopf beginnt auf der Haut vor dem Volumen</translation>
    </message>
    <message>
        <source>The volume of this case is not what is scanned at the moment; choose View, Scan the case&apos;s volume.</source>
        <translation>Geschallt wird gerade nicht das Volumen dieses Falls; „Ansicht“, „Volumen des Falles schallen“ wählen.</translation>
    </message>
    <message>
        <source>Set the start pose</source>
        <translation>Startlage setzen</translation>
    </message>
    <message>
        <source>Remove the start pose</source>
        <translation>Startlage entfernen</translation>
    </message>
    <message>
        <source>on the skin before the volume&apos;s middle</source>
        <translation>auf der Haut vor der Mitte des Volumens</translation>
    </message>
    <message>
        <source>x %1  y %2  z %3 mm</source>
        <translation>x %1  y %2  z %3 mm</translation>
    </message>
    <message>
        <source>Start pose</source>
        <translation>Startlage</translation>
    </message>
    <message>
        <source>Allow: %1</source>
        <translation>Erlauben: %1</translation>
    </message>
    <message>
        <source>Take out: %1</source>
        <translation>Herausnehmen: %1</translation>
    </message>
    <message>
        <source>%1 (unknown)</source>
        <translation>%1 (unbekannt)</translation>
    </message>
    <message>
        <source>None is ticked: all may be used.</source>
        <translation>Keiner ist angekreuzt: Alle dürfen verwendet werden.</translation>
    </message>
    <message>
        <source>At the start: %1</source>
        <translation>Am Anfang: %1</translation>
    </message>
    <message>
        <source>Probes</source>
        <translation>Schallköpfe</translation>
    </message>
    <message>
        <source>the usual one</source>
        <translation>der übliche</translation>
    </message>
    <message>
        <source>Change the mannequin</source>
        <translation>Übungskörper ändern</translation>
    </message>
    <message>
        <source>Mannequin</source>
        <translation>Übungskörper</translation>
    </message>
    <message>
        <source>Another one is shown when the case is opened again</source>
        <translation>Ein anderer erscheint, wenn der Fall wieder geöffnet wird</translation>
    </message>
    <message>
        <source>From here the probe does not see the volume; use another place, or move the volume.</source>
        <translation>Von hier sieht der Schallkopf das Volumen nicht; eine andere Stelle nehmen oder das Volumen verschieben.</translation>
    </message>
    <message>
        <source>There is no probe &apos;%1&apos;; take it out.</source>
        <translation>Es gibt keinen Schallkopf „%1“; ihn herausnehmen.</translation>
    </message>
    <message>
        <source>Nothing is wrong with this case.</source>
        <translation>An diesem Fall ist nichts auszusetzen.</translation>
    </message>
    <message>
        <source>Complaint</source>
        <translation>Beschwerden</translation>
    </message>
    <message>
        <source>Change the complaint</source>
        <translation>Beschwerden ändern</translation>
    </message>
    <message>
        <source>Laboratory</source>
        <translation>Labor</translation>
    </message>
    <message>
        <source>Change the laboratory values</source>
        <translation>Laborwerte ändern</translation>
    </message>
    <message>
        <source>Difficulty</source>
        <translation>Schwierigkeit</translation>
    </message>
    <message>
        <source>Change the difficulty</source>
        <translation>Schwierigkeit ändern</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>Schlagwörter</translation>
    </message>
    <message>
        <source>Change the tags</source>
        <translation>Schlagwörter ändern</translation>
    </message>
    <message>
        <source>Differential</source>
        <translation>Differentialdiagnosen</translation>
    </message>
    <message>
        <source>Change the differential diagnoses</source>
        <translation>Differentialdiagnosen ändern</translation>
    </message>
    <message>
        <source>1, first steps</source>
        <translation>1, erste Schritte</translation>
    </message>
    <message>
        <source>2, basic</source>
        <translation>2, Grundlagen</translation>
    </message>
    <message>
        <source>3, intermediate</source>
        <translation>3, fortgeschritten</translation>
    </message>
    <message>
        <source>4, advanced</source>
        <translation>4, anspruchsvoll</translation>
    </message>
    <message>
        <source>5, examination</source>
        <translation>5, Prüfung</translation>
    </message>
    <message>
        <source>Open a copy…</source>
        <translation>Kopie öffnen…</translation>
    </message>
    <message>
        <source>Save the case as a case of your own, and go on there</source>
        <translation>Den Fall als eigenen Fall speichern und dort weitermachen</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Voreinstellungen</translation>
    </message>
    <message>
        <source>None is ticked: the console stays as it is.</source>
        <translation>Keine ist angehakt: Die Konsole bleibt, wie sie ist.</translation>
    </message>
    <message>
        <source>Body marks</source>
        <translation>Körpermarken</translation>
    </message>
    <message>
        <source>None is ticked: those of the region come first.</source>
        <translation>Keine ist angehakt: Die der Region kommen zuerst.</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Publish…</source>
        <translation>Veröffentlichen…</translation>
    </message>
    <message>
        <source>See what is missing, then hand the case to trainees or to another workstation</source>
        <translation>Sehen, was fehlt, dann den Fall an Lernende oder an einen anderen Arbeitsplatz geben</translation>
    </message>
    <message>
        <source>Invent</source>
        <translation>Erfinden</translation>
    </message>
    <message>
        <source>Invent a name: one that nobody has</source>
        <translation>Einen Namen erfinden, den niemand hat</translation>
    </message>
    <message>
        <source>Invent a name</source>
        <translation>Einen Namen erfinden</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>noch keines</translation>
    </message>
    <message>
        <source>made from the virtual patient %1</source>
        <translation>aus dem virtuellen Patienten %1</translation>
    </message>
    <message>
        <source>Give the case a volume…</source>
        <translation>Dem Fall ein Volumen geben…</translation>
    </message>
    <message>
        <source>Another volume…</source>
        <translation>Anderes Volumen…</translation>
    </message>
    <message>
        <source>Expected measurements</source>
        <translation>Erwartete Messungen</translation>
    </message>
    <message>
        <source>Change the expected measurements</source>
        <translation>Erwartete Messungen ändern</translation>
    </message>
    <message>
        <source>Offer: %1</source>
        <translation>Anbieten: %1</translation>
    </message>
    <message>
        <source>Pictures of an earlier examination</source>
        <translation>Bilder einer früheren Untersuchung</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg)</source>
        <translation>Bilder (*.png *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>This case has no volume yet, so nothing can be scanned.</source>
        <translation>Dieser Fall hat noch kein Volumen, also lässt sich nichts schallen.</translation>
    </message>
</context>
<context>
    <name>ew::stitching</name>
    <message>
        <source>Stitching</source>
        <translation>Verbinden</translation>
    </message>
</context>
<context>
    <name>ew::stitching::CostChart</name>
    <message>
        <source>%1: %2 mm in %3</source>
        <translation>%1: %2 mm in %3</translation>
    </message>
    <message>
        <source>Known once both volumes are read</source>
        <translation>Bekannt, sobald beide Volumen gelesen sind</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>in use: %1 mm, %2</source>
        <translation>gewählt: %1 mm, %2</translation>
    </message>
    <message>
        <source>%1: %2 mm on average, 95 % below %3 mm, in %4. Click to deform this pair so.</source>
        <translation>%1: im Mittel %2 mm, 95 % unter %3 mm, in %4. Ein Klick verformt dieses Paar so.</translation>
    </message>
    <message>
        <source>fast</source>
        <translation>schnell</translation>
    </message>
    <message>
        <source>balanced</source>
        <translation>ausgewogen</translation>
    </message>
    <message>
        <source>accurate</source>
        <translation>genau</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
</context>
<context>
    <name>ew::stitching::LevelChart</name>
    <message>
        <source>The curve grows while the pair is matched</source>
        <translation>Die Kurve wächst, während das Paar zugeordnet wird</translation>
    </message>
    <message>
        <source>No levels yet: match the pair</source>
        <translation>Noch keine Stufen: das Paar zuordnen</translation>
    </message>
    <message>
        <source>matched</source>
        <translation>starr</translation>
    </message>
    <message>
        <source>deformed</source>
        <translation>verformt</translation>
    </message>
</context>
<context>
    <name>ew::stitching::PairGraph</name>
    <message>
        <source>Graph of pairs</source>
        <translation>Graph der Paare</translation>
    </message>
    <message>
        <source>%1 to %2: %3</source>
        <translation>%1 zu %2: %3</translation>
    </message>
    <message>
        <source>against what the other pairs say</source>
        <translation>gegen das, was die anderen Paare sagen</translation>
    </message>
    <message>
        <source>changed since it was matched</source>
        <translation>seit dem Zuordnen geändert</translation>
    </message>
</context>
<context>
    <name>ew::stitching::PairInspector</name>
    <message>
        <source>Correlation by level</source>
        <translation>Korrelation je Stufe</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Annehmen</translation>
    </message>
    <message>
        <source>This pair is right, whatever the figures say (Enter)</source>
        <translation>Dieses Paar stimmt, was auch immer die Zahlen sagen (Eingabe)</translation>
    </message>
    <message>
        <source>Reject</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Leave this pair out of the result (Backspace)</source>
        <translation>Dieses Paar nicht für das Ergebnis verwenden (Rücktaste)</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Überlappung</translation>
    </message>
    <message>
        <source>Of the smaller volume&apos;s covered part, how much both cover</source>
        <translation>Wie viel vom erfassten Teil des kleineren Volumens beide erfassen</translation>
    </message>
    <message>
        <source>Correlation</source>
        <translation>Korrelation</translation>
    </message>
    <message>
        <source>Grey levels now</source>
        <translation>Grauwerte jetzt</translation>
    </message>
    <message>
        <source>Plain correlation of the grey levels as they lie now: for a hand that nudges, no verdict</source>
        <translation>Einfache Korrelation der Grauwerte in der jetzigen Lage: eine Hilfe beim Schieben, kein Urteil</translation>
    </message>
    <message>
        <source>Halves differ by</source>
        <translation>Hälften weichen ab</translation>
    </message>
    <message>
        <source>Two halves of the overlap, matched apart, would place the volume this much differently</source>
        <translation>Zwei getrennt zugeordnete Hälften der Überlappung würden das Volumen um so viel anders legen</translation>
    </message>
    <message>
        <source>Smallest Jacobian</source>
        <translation>Kleinste Jacobi-Det.</translation>
    </message>
    <message>
        <source>Of the elastic step: above 0 nothing folds; 1 is no change of volume</source>
        <translation>Des elastischen Schritts: über 0 faltet sich nichts; 1 heißt keine Volumenänderung</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>That matching this pair took</source>
        <translation>Die das Zuordnen dieses Paares gebraucht hat</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Where the moving volume lies in the fixed one; in the views the arrow keys move it</source>
        <translation>Wo das bewegte Volumen im festen liegt; in den Ansichten schieben es die Pfeiltasten</translation>
    </message>
    <message>
        <source>pose of %1 by numbers</source>
        <translation>Lage von %1 mit Zahlen</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Landmarken</translation>
    </message>
    <message>
        <source>+ pick in both</source>
        <translation>+ in beiden setzen</translation>
    </message>
    <message>
        <source>Click the same place in the fixed and in the moving view (P)</source>
        <translation>Dieselbe Stelle in der festen und in der bewegten Ansicht anklicken (P)</translation>
    </message>
    <message>
        <source>Match by landmarks</source>
        <translation>Nach Landmarken zuordnen</translation>
    </message>
    <message>
        <source>Bring this pair together by these places alone</source>
        <translation>Dieses Paar allein nach diesen Stellen zusammenbringen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the chosen landmark (Delete)</source>
        <translation>Die gewählte Landmarke entfernen (Entf)</translation>
    </message>
    <message>
        <source>Match this pair again</source>
        <translation>Dieses Paar neu zuordnen</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Search without initial pose</source>
        <translation>Suche ohne Anfangslage</translation>
    </message>
    <message>
        <source>Refine from here</source>
        <translation>Von hier aus verfeinern</translation>
    </message>
    <message>
        <source>As placed manually</source>
        <translation>Wie von Hand gelegt</translation>
    </message>
    <message>
        <source>Maximum rotation</source>
        <translation>Größte Drehung</translation>
    </message>
    <message>
        <source>Rotations searched in every direction; the time grows with the third power</source>
        <translation>In allen Richtungen durchsuchte Drehungen; die Zeit wächst mit der dritten Potenz</translation>
    </message>
    <message>
        <source>Match again</source>
        <translation>Neu zuordnen</translation>
    </message>
    <message>
        <source>keep the pair as it lies</source>
        <translation>das Paar lassen, wie es liegt</translation>
    </message>
    <message>
        <source>Elastic</source>
        <translation>Elastisch</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>That the elastic step of this pair takes at its peak, the volumes themselves not counted</source>
        <translation>Den der elastische Schritt dieses Paares höchstens belegt, ohne die Volumen selbst</translation>
    </message>
    <message>
        <source>%1 mm, off</source>
        <translation>%1 mm, daneben</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>-</source>
        <translation>-</translation>
    </message>
    <message>
        <source>Double-click to rename</source>
        <translation>Doppelklick zum Umbenennen</translation>
    </message>
    <message>
        <source>This pair of places contradicts the others; look at it again or remove it</source>
        <translation>Dieses Stellenpaar widerspricht den anderen; noch einmal ansehen oder entfernen</translation>
    </message>
    <message>
        <source>Now the same place in the moving view. Escape drops it.</source>
        <translation>Nun dieselbe Stelle in der bewegten Ansicht. Esc verwirft sie.</translation>
    </message>
    <message>
        <source>Now the same place in the fixed view. Escape drops it.</source>
        <translation>Nun dieselbe Stelle in der festen Ansicht. Esc verwirft sie.</translation>
    </message>
    <message>
        <source>Click a place in the fixed view, then the same one in the moving view.</source>
        <translation>Eine Stelle in der festen Ansicht anklicken, dann dieselbe in der bewegten.</translation>
    </message>
    <message>
        <source>None yet. Three places that are seen in both volumes bring a pair together where the images alone cannot.</source>
        <translation>Noch keine. Drei Stellen, die in beiden Volumen zu sehen sind, bringen ein Paar zusammen, wo die Bilder allein es nicht können.</translation>
    </message>
    <message>
        <source>%1 mm on average, %2 mm to be expected at the far side</source>
        <translation>%1 mm im Mittel, %2 mm am fernen Ende zu erwarten</translation>
    </message>
    <message>
        <source>no overlap</source>
        <translation>keine Überlappung</translation>
    </message>
    <message>
        <source>Pair %1 to %2</source>
        <translation>Paar %1 zu %2</translation>
    </message>
    <message>
        <source>Rejected manually: the result does not use it.</source>
        <translation>Von Hand verworfen: Das Ergebnis verwendet es nicht.</translation>
    </message>
    <message>
        <source>Match it, mark landmarks in both volumes, or nudge it with the keys.</source>
        <translation>Zuordnen, Landmarken in beiden Volumen setzen oder mit den Tasten schieben.</translation>
    </message>
    <message>
        <source>The other pairs contradict it.</source>
        <translation>Die anderen Paare widersprechen ihm.</translation>
    </message>
    <message>
        <source>Changed since: match again.</source>
        <translation>Seitdem geändert: neu zuordnen.</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>How well two volumes fit is told here, once there are two.</source>
        <translation>Hier steht, wie gut zwei Volumen passen, sobald es zwei gibt.</translation>
    </message>
    <message>
        <source>Expected time</source>
        <translation>Erwartete Zeit</translation>
    </message>
    <message>
        <source>Of a search, from &apos;echoweave bench register&apos;, scaled to this pair&apos;s size and to the rotations to be searched</source>
        <translation>Einer Suche, nach „echoweave bench register“, auf die Größe dieses Paares und die zu durchsuchenden Drehungen umgerechnet</translation>
    </message>
    <message>
        <source>For all pairs that have no quality of their own: how much time is spent on accuracy</source>
        <translation>Für alle Paare ohne eigene Güte: wie viel Zeit die Genauigkeit kosten darf</translation>
    </message>
    <message>
        <source>as all</source>
        <translation>wie alle</translation>
    </message>
    <message>
        <source>For this pair alone; the command line keeps to it too</source>
        <translation>Nur für dieses Paar; auch die Kommandozeile hält sich daran</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>Erwartet</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Deform this pair again</source>
        <translation>Dieses Paar neu verformen</translation>
    </message>
    <message>
        <source>Runs the elastic step; pairs that did not change keep what they have</source>
        <translation>Führt den elastischen Schritt aus; Paare, an denen sich nichts geändert hat, behalten, was sie haben</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>That deforming this pair took; it correlates %1 after %2 before, and moves by up to %3 mm</source>
        <translation>Die das Verformen dieses Paares gebraucht hat; die Korrelation ist %1 nach %2 vorher, die größte Verschiebung %3 mm</translation>
    </message>
    <message>
        <source>Changed since: deform again.</source>
        <translation>Seitdem geändert: neu verformen.</translation>
    </message>
    <message>
        <source>Cost of accuracy</source>
        <translation>Aufwand für Genauigkeit</translation>
    </message>
    <message>
        <source>%1 mm in %2</source>
        <translation>%1 mm in %2</translation>
    </message>
    <message>
        <source>From &apos;echoweave bench register&apos;: two views of one tissue, up to 5 mm apart, with two thirds of their speckle in common, on one thread; scaled to this pair&apos;s %1 million voxels of %2 mm.</source>
        <translation>Nach „echoweave bench register“: zwei Ansichten desselben Gewebes, bis 5 mm gegeneinander verschoben, mit zwei Dritteln gemeinsamem Speckle, ein Thread; umgerechnet auf die %1 Millionen Voxel zu %2 mm dieses Paares.</translation>
    </message>
    <message numerus="yes">
        <source>Times are as %n pairs took here.</source>
        <translation>
            <numerusform>Zeiten, wie sie ein Paar hier gebraucht hat.</numerusform>
            <numerusform>Zeiten, wie sie %n Paare hier gebraucht haben.</numerusform>
        </translation>
    </message>
    <message>
        <source>Times are those of the machine of the figures until a pair was deformed here.</source>
        <translation>Bis hier ein Paar verformt wurde, gelten die Zeiten des Rechners, auf dem gemessen wurde.</translation>
    </message>
    <message>
        <source>Cost of accuracy on this machine</source>
        <translation>Aufwand für Genauigkeit auf diesem Rechner</translation>
    </message>
    <message>
        <source>Cost of accuracy, as measured elsewhere</source>
        <translation>Aufwand für Genauigkeit, anderswo gemessen</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>Quality of all pairs</source>
        <translation>Güte aller Paare</translation>
    </message>
    <message>
        <source>Of this pair alone</source>
        <translation>Nur dieses Paares</translation>
    </message>
    <message>
        <source>manual, accepted</source>
        <translation>von Hand, angenommen</translation>
    </message>
    <message>
        <source>At the far side %1 mm are to be expected; the images were not asked.</source>
        <translation>Am fernen Ende sind %1 mm zu erwarten; die Bilder wurden nicht befragt.</translation>
    </message>
    <message>
        <source>%1 (was %2, chance %3)</source>
        <translation>%1 (war %2, Zufall %3)</translation>
    </message>
    <message>
        <source>As matched; without gain and speckle. In brackets what it was at the start, and what unrelated tissue reaches by chance. It may fall: a search that has no start looks for the pose that stands out, and the start may lie on it already</source>
        <translation>Wie zugeordnet; ohne Verstärkung und Speckle. In Klammern, was es am Anfang war und was unverwandtes Gewebe durch Zufall erreicht. Es darf sinken: Eine Suche ohne Anfang sucht die Lage, die heraussticht, und der Anfang kann schon dort liegen</translation>
    </message>
    <message>
        <source>By the clock; %1 of it were work of the processor.</source>
        <translation>Nach der Uhr; %1 davon hat der Prozessor gearbeitet.</translation>
    </message>
    <message>
        <source>By the clock, as deforming went here; %1 of it are work of the processor.</source>
        <translation>Nach der Uhr, wie das Verformen hier lief; %1 davon arbeitet der Prozessor.</translation>
    </message>
</context>
<context>
    <name>ew::stitching::PlacementView</name>
    <message>
        <source>L</source>
        <comment>patient left</comment>
        <translation>L</translation>
    </message>
    <message>
        <source>P</source>
        <comment>posterior</comment>
        <translation>P</translation>
    </message>
    <message>
        <source>H</source>
        <comment>head</comment>
        <translation>K</translation>
    </message>
    <message>
        <source>Drag a box to move it, with Ctrl to turn it; right drag turns the view</source>
        <translation>Ziehen verschiebt einen Kasten, mit Strg dreht es ihn; rechts ziehen dreht die Ansicht</translation>
    </message>
    <message>
        <source>rotate %1 by %2°</source>
        <translation>%1 um %2° drehen</translation>
    </message>
    <message>
        <source>move %1 by %2 mm</source>
        <translation>%1 um %2 mm verschieben</translation>
    </message>
</context>
<context>
    <name>ew::stitching::SliceView</name>
    <message>
        <source>No deformation has been found yet. &apos;Elastic&apos; finds one.</source>
        <translation>Noch ist keine Verformung gefunden. „Elastisch“ findet eine.</translation>
    </message>
    <message>
        <source>The elastic step is switched off in this project.</source>
        <translation>Der elastische Schritt ist in diesem Projekt ausgeschaltet.</translation>
    </message>
    <message>
        <source>No seam has been cut yet. &apos;Compute mosaic&apos; cuts it.</source>
        <translation>Noch ist keine Naht geschnitten. „Mosaik berechnen“ schneidet sie.</translation>
    </message>
    <message>
        <source>There is no stitched volume yet. &apos;Compute mosaic&apos; makes it.</source>
        <translation>Noch gibt es kein zusammengefügtes Volumen. „Mosaik berechnen“ macht es.</translation>
    </message>
    <message>
        <source>Add a second volume; then pairs can be matched.</source>
        <translation>Ein zweites Volumen hinzufügen; dann lassen sich Paare zuordnen.</translation>
    </message>
    <message>
        <source>%1 is being read, or cannot be read.</source>
        <translation>%1 wird gelesen oder ist nicht lesbar.</translation>
    </message>
    <message>
        <source>Both volumes are needed here; one of them cannot be read.</source>
        <translation>Hier werden beide Volumen gebraucht; eines davon ist nicht lesbar.</translation>
    </message>
    <message>
        <source>L</source>
        <comment>patient left</comment>
        <translation>L</translation>
    </message>
    <message>
        <source>R</source>
        <comment>patient right</comment>
        <translation>R</translation>
    </message>
    <message>
        <source>P</source>
        <comment>posterior</comment>
        <translation>P</translation>
    </message>
    <message>
        <source>A</source>
        <comment>anterior</comment>
        <translation>A</translation>
    </message>
    <message>
        <source>H</source>
        <comment>head</comment>
        <translation>K</translation>
    </message>
    <message>
        <source>F</source>
        <comment>feet</comment>
        <translation>F</translation>
    </message>
    <message>
        <source>before</source>
        <translation>vorher</translation>
    </message>
    <message>
        <source>after</source>
        <translation>nachher</translation>
    </message>
    <message>
        <source>prefer %1 at the seam</source>
        <translation>%1 an der Naht vorziehen</translation>
    </message>
</context>
<context>
    <name>ew::stitching::StitchPanel</name>
    <message>
        <source>Add volumes…</source>
        <translation>Volumen hinzufügen…</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Add volumes</source>
        <translation>Volumen hinzufügen</translation>
    </message>
    <message>
        <source>Folder for the stitched volume</source>
        <translation>Ordner für das verbundene Volumen</translation>
    </message>
    <message>
        <source>Stitch volumes</source>
        <translation>Volumen verbinden</translation>
    </message>
    <message>
        <source>Add two or more volumes or sweeps that overlap, or drop their files or a stitch project here. No tracker is needed.</source>
        <translation>Zwei oder mehr Volumen oder Schwenks hinzufügen, die sich überlappen, oder ihre Dateien oder ein Stitching-Projekt hierher ziehen. Ein Tracker ist nicht nötig.</translation>
    </message>
    <message>
        <source>Reopen</source>
        <translation>Wieder öffnen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Subvolumes</source>
        <translation>Teilvolumen</translation>
    </message>
    <message>
        <source>Save the stitch project; the command line runs it identically (Ctrl+S)</source>
        <translation>Das Stitching-Projekt speichern; die Kommandozeile führt es genauso aus (Strg+S)</translation>
    </message>
    <message>
        <source>+ add</source>
        <translation>+ neu</translation>
    </message>
    <message>
        <source>Add volumes or sweeps</source>
        <translation>Volumen oder Schwenks hinzufügen</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Paare</translation>
    </message>
    <message>
        <source>Match all without tracker</source>
        <translation>Alle ohne Tracker zuordnen</translation>
    </message>
    <message>
        <source>Find how all subvolumes lie to each other, whatever is recorded about their places</source>
        <translation>Finden, wie alle Teilvolumen zueinander liegen, was auch immer über ihre Lage aufgezeichnet ist</translation>
    </message>
    <message>
        <source>Refine the poses</source>
        <translation>Lagen verfeinern</translation>
    </message>
    <message>
        <source>Start from the poses as they are recorded or set manually, and let the images refine them</source>
        <translation>Von den aufgezeichneten oder von Hand gesetzten Lagen ausgehen und sie nach den Bildern verfeinern</translation>
    </message>
    <message>
        <source>Elastic</source>
        <translation>Elastisch</translation>
    </message>
    <message>
        <source>Deform the subvolumes so that they fit where they overlap</source>
        <translation>Die Teilvolumen so verformen, dass sie in der Überlappung passen</translation>
    </message>
    <message>
        <source>elastic step on</source>
        <translation>elastischer Schritt an</translation>
    </message>
    <message>
        <source>Compute mosaic</source>
        <translation>Mosaik berechnen</translation>
    </message>
    <message>
        <source>Choose for every place the view that saw it best, and make one volume</source>
        <translation>Für jede Stelle die Ansicht wählen, die sie am besten sah, und ein Volumen machen</translation>
    </message>
    <message>
        <source>Add to case</source>
        <translation>Zum Fall hinzufügen</translation>
    </message>
    <message>
        <source>The open case takes over the stitched volume</source>
        <translation>Der offene Fall übernimmt das zusammengefügte Volumen</translation>
    </message>
    <message>
        <source>Save volume…</source>
        <translation>Volumen sichern…</translation>
    </message>
    <message>
        <source>Save volume, coverage, source and provenance in a folder</source>
        <translation>Volumen, Abdeckung, Quelle und Herkunft in einem Ordner speichern</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>Optionen</translation>
    </message>
    <message>
        <source>Fewer</source>
        <translation>Weniger</translation>
    </message>
    <message>
        <source>finest</source>
        <translation>feinster</translation>
    </message>
    <message>
        <source>The deformation has faded out this far outside the overlap</source>
        <translation>So weit außerhalb der Überlappung ist die Verformung abgeklungen</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>deepest view</source>
        <translation>tiefste Ansicht</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Cut along the surface where the views differ least; or each place from the view in whose inside it lies deepest; or a mean, which smooths speckle</source>
        <translation>Schnitt entlang der Fläche, an der sich die Ansichten am wenigsten unterscheiden; oder jede Stelle aus der Ansicht, in deren Innerem sie am tiefsten liegt; oder ein Mittel, das Speckle glättet</translation>
    </message>
    <message>
        <source>first volume</source>
        <translation>erstes Volumen</translation>
    </message>
    <message>
        <source>body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Naht</translation>
    </message>
    <message>
        <source>Fall-off</source>
        <translation>Abklingen</translation>
    </message>
    <message>
        <source>voxel spacing</source>
        <translation>Voxelabstand</translation>
    </message>
    <message>
        <source>fall-off of the deformation</source>
        <translation>Abklingen der Verformung</translation>
    </message>
    <message>
        <source>seam by %1</source>
        <translation>Naht: %1</translation>
    </message>
    <message>
        <source>axes of the %1</source>
        <translation>Achsen: %1</translation>
    </message>
    <message numerus="yes">
        <source>A project of %n volumes was not saved when the program ended.</source>
        <translation>
            <numerusform>Ein Projekt mit einem Volumen war nicht gespeichert, als das Programm endete.</numerusform>
            <numerusform>Ein Projekt mit %n Volumen war nicht gespeichert, als das Programm endete.</numerusform>
        </translation>
    </message>
    <message>
        <source>Changes to &apos;%1&apos; were not saved when the program ended.</source>
        <translation>Änderungen an „%1“ waren nicht gespeichert, als das Programm endete.</translation>
    </message>
    <message>
        <source>What the stitched volume will be, and the memory that making it takes at its peak</source>
        <translation>Was das zusammengefügte Volumen sein wird, und wie viel Speicher seine Herstellung höchstens belegt</translation>
    </message>
    <message>
        <source>%1 are free</source>
        <translation>%1 sind frei</translation>
    </message>
    <message>
        <source>Result: %1, %2</source>
        <translation>Ergebnis: %1, %2</translation>
    </message>
    <message>
        <source>Volumes, sweeps and stitch projects (*.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz *.json);;All files (*)</source>
        <translation>Volumen, Schwenks und Stitching-Projekte (*.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz *.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open a stitch project</source>
        <translation>Ein Stitching-Projekt öffnen</translation>
    </message>
    <message>
        <source>Stitch projects (*.json);;All files (*)</source>
        <translation>Stitching-Projekte (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Older than the last edit.</source>
        <translation>Älter als die letzte Bearbeitung.</translation>
    </message>
    <message>
        <source>&apos;Compute mosaic&apos; renews the stitched volume</source>
        <translation>„Mosaik berechnen“ erneuert das zusammengefügte Volumen</translation>
    </message>
    <message>
        <source>project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>Begin, open or save a stitch project</source>
        <translation>Ein Stitching-Projekt beginnen, öffnen oder speichern</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern als…</translation>
    </message>
    <message>
        <source>The stitch project has changes that are not saved.</source>
        <translation>Das Stitching-Projekt hat Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message numerus="yes">
        <source>%n more is offered after it.</source>
        <translation>
            <numerusform>Danach wird noch eines angeboten.</numerusform>
            <numerusform>Danach werden noch %n angeboten.</numerusform>
        </translation>
    </message>
    <message>
        <source>manual</source>
        <translation>von Hand</translation>
    </message>
</context>
<context>
    <name>ew::stitching::StitchSession</name>
    <message>
        <source>aligned</source>
        <translation>passt</translation>
    </message>
    <message>
        <source>cannot tell</source>
        <translation>unklar</translation>
    </message>
    <message>
        <source>not aligned</source>
        <translation>passt nicht</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>verworfen</translation>
    </message>
    <message>
        <source>not matched yet</source>
        <translation>noch nicht zugeordnet</translation>
    </message>
    <message>
        <source>Stitching</source>
        <translation>Stitching</translation>
    </message>
    <message>
        <source>1 subvolume</source>
        <translation>1 Teilvolumen</translation>
    </message>
    <message>
        <source>%1 subvolumes</source>
        <translation>%1 Teilvolumen</translation>
    </message>
    <message>
        <source>Stitching: %1</source>
        <translation>Stitching: %1</translation>
    </message>
    <message>
        <source>Stitching: %1, %2</source>
        <translation>Stitching: %1, %2</translation>
    </message>
    <message>
        <source>not saved</source>
        <translation>nicht gespeichert</translation>
    </message>
    <message>
        <source>saved</source>
        <translation>gespeichert</translation>
    </message>
    <message>
        <source>no pair needs a look</source>
        <translation>kein Paar anzusehen</translation>
    </message>
    <message>
        <source>%1 of %2 pairs need review</source>
        <translation>%1 von %2 Paaren prüfen</translation>
    </message>
    <message>
        <source>The project has no volume yet; add one before it is saved.</source>
        <translation>Das Projekt hat noch kein Volumen; vor dem Speichern eines hinzufügen.</translation>
    </message>
    <message>
        <source>Save the stitch project</source>
        <translation>Das Stitching-Projekt speichern</translation>
    </message>
    <message>
        <source>Stitch projects (*.json)</source>
        <translation>Stitching-Projekte (*.json)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message numerus="yes">
        <source>Reading %n volumes</source>
        <translation>
            <numerusform>Ein Volumen wird gelesen</numerusform>
            <numerusform>%n Volumen werden gelesen</numerusform>
        </translation>
    </message>
    <message>
        <source>add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message numerus="yes">
        <source>add %n volumes</source>
        <translation>
            <numerusform>ein Volumen hinzufügen</numerusform>
            <numerusform>%n Volumen hinzufügen</numerusform>
        </translation>
    </message>
    <message>
        <source>clear the pose of %1</source>
        <translation>Lage von %1 vergessen</translation>
    </message>
    <message>
        <source>believe the tracker about %1</source>
        <translation>dem Tracker bei %1 glauben</translation>
    </message>
    <message>
        <source>take the pose of %1 as a start</source>
        <translation>Lage von %1 als Anfang nehmen</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 zu %2</translation>
    </message>
    <message>
        <source>place %1</source>
        <translation>Stelle %1</translation>
    </message>
    <message>
        <source>landmark %1 of %2</source>
        <translation>Landmarke %1 von %2</translation>
    </message>
    <message>
        <source>remove landmark %1</source>
        <translation>Landmarke %1 entfernen</translation>
    </message>
    <message>
        <source>A landmark needs a name; type one.</source>
        <translation>Eine Landmarke braucht einen Namen; einen eingeben.</translation>
    </message>
    <message>
        <source>call landmark %1 &apos;%2&apos;</source>
        <translation>Landmarke %1 „%2“ nennen</translation>
    </message>
    <message numerus="yes">
        <source>Three places that do not lie on one line are needed; mark %n more in both volumes.</source>
        <translation>
            <numerusform>Drei Stellen, die nicht auf einer Geraden liegen, sind nötig; noch eine in beiden Volumen setzen.</numerusform>
            <numerusform>Drei Stellen, die nicht auf einer Geraden liegen, sind nötig; noch %n in beiden Volumen setzen.</numerusform>
        </translation>
    </message>
    <message>
        <source>bring %1 together by landmarks</source>
        <translation>%1 nach Landmarken zusammenbringen</translation>
    </message>
    <message>
        <source>Matching %1 by landmarks</source>
        <translation>%1 wird nach Landmarken zugeordnet</translation>
    </message>
    <message>
        <source>accept %1</source>
        <translation>%1 annehmen</translation>
    </message>
    <message>
        <source>reject %1</source>
        <translation>%1 verwerfen</translation>
    </message>
    <message>
        <source>clear decision on %1</source>
        <translation>Entscheidung über %1 löschen</translation>
    </message>
    <message>
        <source>nudge %1 by %2 mm</source>
        <translation>%1 um %2 mm schieben</translation>
    </message>
    <message>
        <source>rotate %1 by %2°</source>
        <translation>%1 um %2° drehen</translation>
    </message>
    <message>
        <source>Matching needs two volumes at least; add another one.</source>
        <translation>Zum Zuordnen braucht es mindestens zwei Volumen; noch eines hinzufügen.</translation>
    </message>
    <message>
        <source>match without tracker</source>
        <translation>ohne Tracker zuordnen</translation>
    </message>
    <message>
        <source>Matching without tracker</source>
        <translation>Zuordnen ohne Tracker</translation>
    </message>
    <message>
        <source>Refining the poses</source>
        <translation>Lagen werden verfeinert</translation>
    </message>
    <message>
        <source>There is nothing to work on yet; add two volumes or more.</source>
        <translation>Noch gibt es nichts zu tun; zwei oder mehr Volumen hinzufügen.</translation>
    </message>
    <message>
        <source>redo %1</source>
        <translation>%1 neu zuordnen</translation>
    </message>
    <message>
        <source>Matching %1 again</source>
        <translation>%1 wird neu zugeordnet</translation>
    </message>
    <message>
        <source>Stitched volume</source>
        <translation>Zusammengefügtes Volumen</translation>
    </message>
    <message>
        <source>There is no stitched volume yet; run &apos;Compute mosaic&apos; first.</source>
        <translation>Noch gibt es kein zusammengefügtes Volumen; zuerst „Mosaik berechnen“ ausführen.</translation>
    </message>
    <message>
        <source>Saving the stitched volume</source>
        <translation>Das zusammengefügte Volumen wird gespeichert</translation>
    </message>
    <message>
        <source>Saved in %1: volume.mha, coverage.mha, source.mha, level.mha and provenance.json.</source>
        <translation>Gespeichert in %1: volume.mha, coverage.mha, source.mha, level.mha und provenance.json.</translation>
    </message>
    <message>
        <source>No case is open that could take the volume; open one (Ctrl+O) or save the volume as a file.</source>
        <translation>Kein Fall ist offen, der das Volumen nehmen könnte; einen öffnen (Strg+O) oder das Volumen als Datei speichern.</translation>
    </message>
    <message>
        <source>Adding the volume to the case</source>
        <translation>Das Volumen wird dem Fall hinzugefügt</translation>
    </message>
    <message>
        <source>Another case was opened meanwhile; the volume lies in %1 and no case was changed.</source>
        <translation>Inzwischen wurde ein anderer Fall geöffnet; das Volumen liegt in %1, und kein Fall wurde geändert.</translation>
    </message>
    <message>
        <source>use the stitched volume</source>
        <translation>das zusammengefügte Volumen verwenden</translation>
    </message>
    <message>
        <source>The case now uses volumes/%1.mha.</source>
        <translation>Der Fall nutzt jetzt volumes/%1.mha.</translation>
    </message>
    <message>
        <source>It had unsaved changes before; save the case to keep them all.</source>
        <translation>Er hatte schon ungespeicherte Änderungen; den Fall speichern, um alle zu behalten.</translation>
    </message>
    <message>
        <source>A step is still running; wait for it or cancel it.</source>
        <translation>Ein Schritt läuft noch; auf ihn warten oder ihn abbrechen.</translation>
    </message>
    <message>
        <source>elastic quality %1</source>
        <translation>elastische Güte %1</translation>
    </message>
    <message>
        <source>deform %1 %2</source>
        <translation>%1 verformen: %2</translation>
    </message>
    <message>
        <source>deform %1 as all pairs</source>
        <translation>%1 wie alle Paare verformen</translation>
    </message>
    <message>
        <source>Deforming %1 again</source>
        <translation>%1 wird neu verformt</translation>
    </message>
    <message>
        <source>Restoring previous results</source>
        <translation>Frühere Ergebnisse werden gelesen</translation>
    </message>
    <message>
        <source>%1 of %2 pairs not matched</source>
        <translation>%1 von %2 nicht zugeordnet</translation>
    </message>
    <message>
        <source>%1: in the list already.</source>
        <translation>%1: schon in der Liste.</translation>
    </message>
    <message numerus="yes">
        <source>%n more could not be read either.</source>
        <translation>
            <numerusform>Auch eine weitere Datei war nicht lesbar.</numerusform>
            <numerusform>Auch %n weitere Dateien waren nicht lesbar.</numerusform>
        </translation>
    </message>
    <message>
        <source>by landmarks</source>
        <translation>Landmarken</translation>
    </message>
    <message>
        <source>manual, not checked</source>
        <translation>von Hand, ungeprüft</translation>
    </message>
    <message>
        <source>refine the poses</source>
        <translation>die Lagen verfeinern</translation>
    </message>
    <message>
        <source>Not matched by their images, because you placed them by landmarks or accepted them by hand: %1.</source>
        <translation>Nicht nach ihren Bildern zugeordnet, weil sie nach Landmarken platziert oder von Hand angenommen wurden: %1.</translation>
    </message>
    <message>
        <source>'%1' was changed by another program since it was opened here.</source>
        <translation>„%1“ wurde von einem anderen Programm geändert, seit es hier geöffnet wurde.</translation>
    </message>
    <message>
        <source>Reloading drops your changes, overwriting drops the other ones.</source>
        <translation>Neu laden verwirft die eigenen Änderungen, Überschreiben die anderen.</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Neu laden</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Überschreiben</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter …</translation>
    </message>
    <message numerus="yes">
        <source>%n files lie in other folders and are named by their whole path: to take the project to another machine, put them beside it first.</source>
        <translation>
            <numerusform>Eine Datei liegt in einem anderen Ordner und ist mit ihrem ganzen Pfad genannt; sie neben das Projekt legen, bevor es auf einen anderen Rechner kommt.</numerusform>
            <numerusform>%n Dateien liegen in anderen Ordnern und sind mit ihrem ganzen Pfad genannt; sie neben das Projekt legen, bevor es auf einen anderen Rechner kommt.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 lies in %2 already and was not saved there by this program. Replace it?</source>
        <translation>In %2 liegt schon %1, und dieses Programm hat es dort nicht gespeichert. Ersetzen?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>The patient of this case is a recipe, and the stitched volume takes its place.</source>
        <translation>Der Patient dieses Falls ist ein Rezept, und das verbundene Volumen tritt an seine Stelle.</translation>
    </message>
    <message>
        <source>What only the recipe knew goes with it: %1, %2. To keep this case as it is, save it under another name first.</source>
        <translation>Was nur das Rezept wusste, geht mit ihm: %1, %2. Um diesen Fall zu behalten, wie er ist, ihn zuerst unter einem anderen Namen speichern.</translation>
    </message>
    <message numerus="yes">
        <source>%n targets</source>
        <translation>
            <numerusform>ein Ziel</numerusform>
            <numerusform>%n Ziele</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n measurements</source>
        <translation>
            <numerusform>eine Messung</numerusform>
            <numerusform>%n Messungen</numerusform>
        </translation>
    </message>
    <message>
        <source>Replace the volume</source>
        <translation>Volumen ersetzen</translation>
    </message>
    <message>
        <source>Another case was opened meanwhile; no case was changed.</source>
        <translation>Inzwischen wurde ein anderer Fall geöffnet; kein Fall wurde geändert.</translation>
    </message>
    <message>
        <source>calibration of %1</source>
        <translation>Kalibrierung von %1</translation>
    </message>
    <message>
        <source>no calibration of %1</source>
        <translation>keine Kalibrierung von %1</translation>
    </message>
    <message>
        <source>voxel spacing of %1</source>
        <translation>Voxelabstand von %1</translation>
    </message>
</context>
<context>
    <name>ew::stitching::StitchStage</name>
    <message>
        <source>Which way the plane lies (1, 2, 3); right drag in a view turns it</source>
        <translation>Wie die Ebene liegt (1, 2, 3); rechts ziehen dreht sie</translation>
    </message>
    <message>
        <source>axial</source>
        <translation>axial</translation>
    </message>
    <message>
        <source>coronal</source>
        <translation>koronal</translation>
    </message>
    <message>
        <source>sagittal</source>
        <translation>sagittal</translation>
    </message>
    <message>
        <source>Linked</source>
        <translation>Verknüpft</translation>
    </message>
    <message>
        <source>Both cross-hairs mark the same place; unlink them to look at each volume for itself (L)</source>
        <translation>Beide Fadenkreuze zeigen dieselbe Stelle; gelöst lässt sich jedes Volumen für sich ansehen (L)</translation>
    </message>
    <message>
        <source>How both are laid over each other (C)</source>
        <translation>Wie beide übereinandergelegt werden (C)</translation>
    </message>
    <message>
        <source>checkerboard</source>
        <translation>Schachbrett</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>flicker</source>
        <translation>Wechsel</translation>
    </message>
    <message>
        <source>colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>As it was at the start, as matched, or with the elastic step (X)</source>
        <translation>Wie am Anfang, wie zugeordnet, oder mit dem elastischen Schritt (X)</translation>
    </message>
    <message>
        <source>Before and after side by side: the start at the left, the present at the right (B)</source>
        <translation>Vorher und nachher nebeneinander: links der Anfang, rechts jetzt (B)</translation>
    </message>
    <message>
        <source>Before and after</source>
        <translation>Vorher und nachher</translation>
    </message>
    <message>
        <source>What this view shows (G)</source>
        <translation>Was diese Ansicht zeigt (G)</translation>
    </message>
    <message>
        <source>placement</source>
        <translation>Anordnung</translation>
    </message>
    <message>
        <source>displacement</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>seam</source>
        <translation>Naht</translation>
    </message>
    <message>
        <source>result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Prefer</source>
        <translation>Vorziehen</translation>
    </message>
    <message>
        <source>Paint where a view is to be preferred (V); here and in the overlap</source>
        <translation>Malen, wo eine Ansicht vorgezogen werden soll (V); hier und in der Überlappung</translation>
    </message>
    <message>
        <source>The view that is preferred where you paint</source>
        <translation>Die Ansicht, die dort vorgezogen wird, wo gemalt wird</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Radius of the brush ([ and ])</source>
        <translation>Radius des Pinsels ([ und ])</translation>
    </message>
    <message>
        <source>%1 fixed</source>
        <translation>%1 fest</translation>
    </message>
    <message>
        <source>%1 moving</source>
        <translation>%1 bewegt</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>%1 and %2 over each other</source>
        <translation>%1 und %2 übereinander</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>fest</translation>
    </message>
    <message>
        <source>both</source>
        <translation>beide</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>bewegt</translation>
    </message>
    <message>
        <source>where they lie</source>
        <translation>wo sie liegen</translation>
    </message>
    <message>
        <source>10 mm grid</source>
        <translation>Gitter 10 mm</translation>
    </message>
    <message>
        <source>the result</source>
        <translation>das Ergebnis</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>matched</source>
        <translation>starr</translation>
    </message>
    <message>
        <source>elastic</source>
        <translation>elastisch</translation>
    </message>
    <message>
        <source>Arrows, PgUp, PgDown</source>
        <translation>Pfeile, Bild auf, Bild ab</translation>
    </message>
    <message>
        <source>nudge by 0.5 mm, with Shift 2 mm, with Ctrl 0.1 mm</source>
        <translation>um 0,5 mm schieben, mit Umschalt 2 mm, mit Strg 0,1 mm</translation>
    </message>
    <message>
        <source>rotate in the plane by 1°, with Shift 5°</source>
        <translation>in der Ebene um 1° drehen, mit Umschalt 5°</translation>
    </message>
    <message>
        <source>rotate out of the plane</source>
        <translation>aus der Ebene drehen</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>move the cross-hairs</source>
        <translation>Fadenkreuz bewegen</translation>
    </message>
    <message>
        <source>Wheel; , .</source>
        <translation>Rad; , .</translation>
    </message>
    <message>
        <source>step through by 1 mm, with Shift 5 mm</source>
        <translation>um 1 mm durchblättern, mit Umschalt 5 mm</translation>
    </message>
    <message>
        <source>Ctrl + wheel; + -; 0</source>
        <translation>Strg + Rad; + -; 0</translation>
    </message>
    <message>
        <source>zoom; everything in view</source>
        <translation>Lupe; alles im Bild</translation>
    </message>
    <message>
        <source>Right drag, middle drag</source>
        <translation>Rechts ziehen, Mitte ziehen</translation>
    </message>
    <message>
        <source>rotate the plane, shift it</source>
        <translation>Ebene drehen, verschieben</translation>
    </message>
    <message>
        <source>axial, coronal, sagittal</source>
        <translation>axial, koronal, sagittal</translation>
    </message>
    <message>
        <source>next, previous pair</source>
        <translation>nächstes, voriges Paar</translation>
    </message>
    <message>
        <source>overlay, start or result, before and after</source>
        <translation>Überlagerung, Anfang oder Ergebnis, vorher und nachher</translation>
    </message>
    <message>
        <source>placement, displacement, seam, result</source>
        <translation>Anordnung, Verschiebung, Naht, Ergebnis</translation>
    </message>
    <message>
        <source>cross-hairs linked or each for itself</source>
        <translation>Fadenkreuze verknüpft oder jedes für sich</translation>
    </message>
    <message>
        <source>pick landmarks, stop</source>
        <translation>Landmarken setzen, aufhören</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Entf</translation>
    </message>
    <message>
        <source>remove the chosen landmark</source>
        <translation>gewählte Landmarke entfernen</translation>
    </message>
    <message>
        <source>paint a preference, size of the brush</source>
        <translation>Vorzug malen, Größe des Pinsels</translation>
    </message>
    <message>
        <source>Enter, Backspace</source>
        <translation>Eingabe, Rücktaste</translation>
    </message>
    <message>
        <source>accept, reject the pair</source>
        <translation>Paar annehmen, verwerfen</translation>
    </message>
    <message>
        <source>undo, redo, save the project</source>
        <translation>zurück, wieder, Projekt speichern</translation>
    </message>
    <message>
        <source>Views of the volumes</source>
        <translation>Ansichten der Volumen</translation>
    </message>
</context>
<context>
    <name>ew::stitching::VolumeList</name>
    <message>
        <source>call %1 &apos;%2&apos;</source>
        <translation>%1 „%2“ nennen</translation>
    </message>
    <message>
        <source>move %1 in the list</source>
        <translation>%1 in der Liste verschieben</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>aufgezeichnet</translation>
    </message>
    <message>
        <source>manual</source>
        <translation>von Hand</translation>
    </message>
    <message>
        <source>Where the chosen volume&apos;s place comes from: found by matching, believed as the tracker&apos;s, or a start by hand</source>
        <translation>Woher die Lage des gewählten Volumens kommt: durch Zuordnen gefunden, dem Tracker geglaubt, oder von Hand als Anfang gesetzt</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>Datei…</translation>
    </message>
    <message>
        <source>Read the pose from a file with 16 numbers, row by row</source>
        <translation>Die Lage aus einer Datei mit 16 Zahlen lesen, Zeile für Zeile</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Take this volume off the list; its file stays (Delete)</source>
        <translation>Dieses Volumen von der Liste nehmen; seine Datei bleibt (Entf)</translation>
    </message>
    <message>
        <source>pose unknown</source>
        <translation>Lage unbekannt</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>nicht lesbar</translation>
    </message>
    <message>
        <source>reading…</source>
        <translation>wird gelesen…</translation>
    </message>
    <message>
        <source>%1 voxels of %2 × %3 × %4 mm</source>
        <translation>%1 Voxel zu %2 × %3 × %4 mm</translation>
    </message>
    <message>
        <source>F2 renames, Alt + up and down move it, Delete takes it off the list</source>
        <translation>F2 benennt um, Alt + auf und ab verschiebt, Entf nimmt es von der Liste</translation>
    </message>
    <message>
        <source>Pose of %1</source>
        <translation>Lage von %1</translation>
    </message>
    <message>
        <source>Transforms (*.txt *.tfm);;All files (*)</source>
        <translation>Transformationen (*.txt *.tfm);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>pose of %1 from a file</source>
        <translation>Lage von %1 aus einer Datei</translation>
    </message>
    <message>
        <source>remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>own</source>
        <translation>eigener</translation>
    </message>
    <message>
        <source>Calibration…</source>
        <translation>Kalibrierung …</translation>
    </message>
    <message>
        <source>Spacing of the volume that is made of this sweep; at the least value as fine as its pixels and frames are</source>
        <translation>Voxelabstand des Volumens, das aus diesem Schwenk wird; beim kleinsten Wert so fein wie seine Pixel und Bilder</translation>
    </message>
    <message>
        <source>A device set (.xml) that says where the pixels lie on the probe; needed by a sweep that does not say it itself</source>
        <translation>Eine Kalibrierung (.xml), die sagt, wo die Pixel am Schallkopf liegen; nötig für einen Schwenk, der es nicht selbst sagt</translation>
    </message>
    <message>
        <source>Calibration from %1; click to choose another file</source>
        <translation>Kalibrierung aus %1; klicken, um eine andere Datei zu wählen</translation>
    </message>
    <message>
        <source>Calibration of %1</source>
        <translation>Kalibrierung von %1</translation>
    </message>
    <message>
        <source>Device sets (*.xml);;All files (*)</source>
        <translation>Kalibrierungen (*.xml);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>sweep, not yet a volume</source>
        <translation>Schwenk, noch kein Volumen</translation>
    </message>
    <message>
        <source>Volumes</source>
        <translation>Volumen</translation>
    </message>
</context>
<context>
    <name>ew::ui::AnnotatedPictures</name>
    <message>
        <source>Words and arrows belong to the image, not to the strip of the M-mode. Switch to B or B + M.</source>
        <translation>Texte und Pfeile gehören ins Bild, nicht in den Streifen des M-Mode. Wechseln Sie zu B oder B + M.</translation>
    </message>
</context>
<context>
    <name>ew::ui::AnnotationLayer</name>
    <message>
        <source>Texts and arrows on the image</source>
        <translation>Texte und Pfeile im Bild</translation>
    </message>
    <message>
        <source>Text on the image</source>
        <translation>Text im Bild</translation>
    </message>
    <message>
        <source>Enter ends, Escape gives up, Tab takes the first word of the list, Ctrl+Home goes to the home position</source>
        <translation>Eingabe beendet, Esc verwirft, Tab nimmt das erste Wort der Liste, Strg+Pos1 geht zur Ausgangsstelle</translation>
    </message>
</context>
<context>
    <name>ew::ui::BodyMarkView</name>
    <message>
        <source>Body mark</source>
        <translation>Körpersymbol</translation>
    </message>
    <message>
        <source>Body mark: drag it to another corner. On a frozen image drag the probe on it, turn it with the wheel; a double click lets it follow the probe again.</source>
        <translation>Körpersymbol: Ziehen Sie es in eine andere Ecke. In einem eingefrorenen Bild lässt sich der Schallkopf darauf ziehen und mit dem Rad drehen; nach einem Doppelklick folgt er wieder dem Schallkopf.</translation>
    </message>
</context>
<context>
    <name>ew::ui::CaliperLayer</name>
    <message>
        <source>Calipers on the image</source>
        <translation>Messpunkte auf dem Bild</translation>
    </message>
    <message>
        <source>Calipers on the strip of the M-mode</source>
        <translation>Messmarken auf dem Streifen des M-Mode</translation>
    </message>
    <message>
        <source>%1 is measured in the image; in the strip measure time, heart rate, slope or depth.</source>
        <comment>a tool</comment>
        <translation>%1 wird im Bild gemessen; im Streifen misst man Zeit, Herzfrequenz, Steigung oder Tiefe.</translation>
    </message>
    <message>
        <source>%1 is measured in the strip: click there.</source>
        <comment>a tool</comment>
        <translation>%1 wird im Streifen gemessen: dort klicken.</translation>
    </message>
    <message>
        <source>Nothing is drawn there yet; click where the strip shows echoes.</source>
        <translation>Dort ist noch nichts gezeichnet; klicken, wo der Streifen Echos zeigt.</translation>
    </message>
</context>
<context>
    <name>ew::ui::CaliperWords</name>
    <message>
        <source>Distance</source>
        <translation>Distanz</translation>
    </message>
    <message>
        <source>Poly-line</source>
        <translation>Linienzug</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Fitted ellipse</source>
        <translation>Angepasste Ellipse</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>circumference</source>
        <translation>Umfang</translation>
    </message>
    <message>
        <source>area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>long axis</source>
        <translation>lange Achse</translation>
    </message>
    <message>
        <source>short axis</source>
        <translation>kurze Achse</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Distance: click both ends, or drag from one to the other.</source>
        <translation>Distanz: beide Enden anklicken oder vom einen zum anderen ziehen.</translation>
    </message>
    <message>
        <source>Poly-line: click its points, the last one twice, or Enter.</source>
        <translation>Linienzug: die Punkte anklicken, den letzten zweimal, oder Eingabe.</translation>
    </message>
    <message>
        <source>Outline: click around it or draw it; end where it began, or by Enter.</source>
        <translation>Umriss: ringsum klicken oder zeichnen; am Anfang oder mit der Eingabetaste enden.</translation>
    </message>
    <message>
        <source>Ellipse: click both ends of one axis, then how far it opens.</source>
        <translation>Ellipse: beide Enden einer Achse anklicken, dann, wie weit sie sich öffnet.</translation>
    </message>
    <message>
        <source>Fitted ellipse: click five or more points of the outline, the last one twice, or Enter.</source>
        <translation>Angepasste Ellipse: fünf oder mehr Punkte des Umrisses anklicken, den letzten zweimal, oder Eingabe.</translation>
    </message>
    <message>
        <source>Angle: click a point, the vertex, a point.</source>
        <translation>Winkel: einen Punkt, den Scheitel und einen Punkt anklicken.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>a result&apos;s name and its value</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>± from the pixel (%1 mm), the resolution along the beam (%2 mm) and the width of the beam (%3 mm).</source>
        <translation>± aus dem Pixel (%1 mm), der Auflösung entlang des Strahls (%2 mm) und der Breite des Strahls (%3 mm).</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>from a smallest to a largest value</comment>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source> R</source>
        <comment>right side, behind what was measured</comment>
        <translation> R</translation>
    </message>
    <message>
        <source> L</source>
        <comment>left side, behind what was measured</comment>
        <translation> L</translation>
    </message>
    <message>
        <source>Volume by discs</source>
        <translation>Volumen aus Scheiben</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Heart rate</source>
        <translation>Herzfrequenz</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Steigung</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>Steigung</translation>
    </message>
    <message>
        <source>heart rate</source>
        <translation>Herzfrequenz</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>Verhältnis</translation>
    </message>
    <message>
        <source>Volume by discs: click both ends of the long axis, then around the outline; end where the outline began, or by Enter.</source>
        <translation>Volumen aus Scheiben: beide Enden der langen Achse anklicken, dann um den Umriss herum; dort enden, wo der Umriss begann, oder mit der Eingabetaste.</translation>
    </message>
    <message>
        <source>Time: click both moments in the strip.</source>
        <translation>Zeit: beide Augenblicke im Streifen anklicken.</translation>
    </message>
    <message>
        <source>Heart rate: click the same moment of two beats in the strip.</source>
        <translation>Herzfrequenz: denselben Augenblick zweier Schläge im Streifen anklicken.</translation>
    </message>
    <message>
        <source>Slope: click both ends along the moving echo in the strip.</source>
        <translation>Steigung: beide Enden entlang des bewegten Echos im Streifen anklicken.</translation>
    </message>
    <message>
        <source>Depth: click both depths in the strip.</source>
        <translation>Tiefe: beide Tiefen im Streifen anklicken.</translation>
    </message>
    <message>
        <source>M%1</source>
        <comment>number of a measurement in the M-mode</comment>
        <translation>M%1</translation>
    </message>
    <message>
        <source>cross %1</source>
        <translation>Kreuz %1</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>Kante</translation>
    </message>
    <message>
        <source>same depth</source>
        <translation>gleiche Tiefe</translation>
    </message>
    <message>
        <source>horizontal</source>
        <translation>waagerecht</translation>
    </message>
    <message>
        <source>same moment</source>
        <translation>gleicher Augenblick</translation>
    </message>
    <message>
        <source>vertical</source>
        <translation>senkrecht</translation>
    </message>
    <message>
        <source>the time of a column and between two beams (%1 ms)</source>
        <translation>der Zeit einer Spalte und zwischen zwei Strahlen (%1 ms)</translation>
    </message>
    <message>
        <source>the pixel (%1 mm) and the resolution along the beam (%2 mm)</source>
        <translation>dem Pixel (%1 mm) und der Auflösung längs des Strahls (%2 mm)</translation>
    </message>
    <message>
        <source>± from %1.</source>
        <comment>what an uncertainty comes from</comment>
        <translation>± aus %1.</translation>
    </message>
    <message>
        <source>± from %1, and from %2.</source>
        <comment>what an uncertainty comes from</comment>
        <translation>± aus %1 sowie aus %2.</translation>
    </message>
    <message>
        <source>Heart beats between the cursors: %1.</source>
        <translation>Herzschläge zwischen den Marken: %1.</translation>
    </message>
    <message>
        <source>The strip has gone on and does not show its echoes any more; the value stays, and the cine loop brings them back.</source>
        <translation>Der Streifen ist weitergelaufen und zeigt diese Echos nicht mehr; der Wert bleibt, und die Cine-Schleife holt sie zurück.</translation>
    </message>
</context>
<context>
    <name>ew::ui::Calipers</name>
    <message>
        <source>Following the edge</source>
        <translation>Der Kante folgen</translation>
    </message>
    <message>
        <source>This is measured in the strip of the M-mode. Switch to B + M or M (M).</source>
        <translation>Das wird im Streifen des M-Mode gemessen. Auf B + M oder M umschalten (M).</translation>
    </message>
    <message>
        <source>Calipers measure in the image, not in the strip of the M-mode. Switch to B or B + M.</source>
        <translation>Gemessen wird im Bild, nicht im Streifen des M-Modus. Auf B oder B + M umschalten.</translation>
    </message>
    <message>
        <source>This tool measures in the image, and only the strip of the M-mode is shown. Switch to B or B + M.</source>
        <translation>Dieses Werkzeug misst im Bild, und gezeigt wird nur der Streifen des M-Mode. Auf B oder B + M umschalten.</translation>
    </message>
</context>
<context>
    <name>ew::ui::CaseFolderDialog</name>
    <message>
        <source>Save the case as a folder of its own</source>
        <translation>Fall in einem eigenen Ordner speichern</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Folder of your own cases</source>
        <translation>Ordner der eigenen Fälle</translation>
    </message>
    <message>
        <source>Name of the new folder</source>
        <translation>Name des neuen Ordners</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Choose the folder of your own cases.</source>
        <translation>Den Ordner der eigenen Fälle wählen.</translation>
    </message>
    <message>
        <source>Type a name for the new folder, without &apos;/&apos; and not beginning with &apos;.&apos;.</source>
        <translation>Dem neuen Ordner einen Namen ohne „/“ geben, der nicht mit „.“ beginnt.</translation>
    </message>
    <message>
        <source>This folder belongs to the program, and the next version replaces it; choose one of your own.</source>
        <translation>Dieser Ordner gehört zum Programm, und die nächste Version ersetzt ihn; einen eigenen wählen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is there already, and nothing in it is replaced; type another name.</source>
        <translation>„%1“ gibt es schon, und darin wird nichts ersetzt; einen anderen Namen eingeben.</translation>
    </message>
    <message>
        <source>The case will be saved in %1.</source>
        <translation>Der Fall wird in %1 gespeichert.</translation>
    </message>
    <message>
        <source>Cases in this folder are published and stay as they are; choose the folder of your own cases.</source>
        <translation>Fälle in diesem Ordner sind veröffentlicht und bleiben, wie sie sind; den Ordner der eigenen Fälle wählen.</translation>
    </message>
</context>
<context>
    <name>ew::ui::CaseInfo</name>
    <message>
        <source>female</source>
        <translation>weiblich</translation>
    </message>
    <message>
        <source>male</source>
        <translation>männlich</translation>
    </message>
    <message>
        <source>%1 years</source>
        <translation>%1 Jahre</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>Fall</translation>
    </message>
    <message>
        <source>Patient, history, indication, and what is to be shown</source>
        <translation>Patient, Anamnese, Fragestellung und was darzustellen ist</translation>
    </message>
    <message>
        <source>Indication</source>
        <translation>Fragestellung</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Anamnese</translation>
    </message>
    <message>
        <source>Previous examinations</source>
        <translation>Frühere Untersuchungen</translation>
    </message>
    <message>
        <source>Hide findings</source>
        <translation>Befund verbergen</translation>
    </message>
    <message>
        <source>Show findings</source>
        <translation>Befund zeigen</translation>
    </message>
    <message>
        <source>What a good report says: look after your own examination</source>
        <translation>Was ein guter Befund sagt: nach der eigenen Untersuchung ansehen</translation>
    </message>
    <message>
        <source>Diagnosis</source>
        <translation>Diagnose</translation>
    </message>
    <message>
        <source>Planes to show</source>
        <translation>Darzustellende Ebenen</translation>
    </message>
    <message>
        <source>Structures to show</source>
        <translation>Darzustellende Strukturen</translation>
    </message>
    <message>
        <source>Points to find</source>
        <translation>Zu findende Punkte</translation>
    </message>
    <message>
        <source>To measure</source>
        <translation>Zu messen</translation>
    </message>
    <message numerus="yes">
        <source>%n more with the findings</source>
        <translation>
            <numerusform>%n weiterer mit dem Befund</numerusform>
            <numerusform>%n weitere mit dem Befund</numerusform>
        </translation>
    </message>
    <message>
        <source>Complaint</source>
        <translation>Beschwerden</translation>
    </message>
    <message>
        <source>Laboratory</source>
        <translation>Labor</translation>
    </message>
    <message>
        <source>Differential diagnosis</source>
        <translation>Differentialdiagnose</translation>
    </message>
    <message>
        <source>Show this picture large</source>
        <translation>Dieses Bild groß zeigen</translation>
    </message>
</context>
<context>
    <name>ew::ui::CasePreparation</name>
    <message>
        <source>Preparing %1</source>
        <translation>%1 wird vorbereitet</translation>
    </message>
</context>
<context>
    <name>ew::ui::CineBar</name>
    <message>
        <source>Time line of what was scanned</source>
        <translation>Zeitleiste des Geschallten</translation>
    </message>
    <message>
        <source>Click or drag to another image (arrows: an image, with Shift ten; Home and End)</source>
        <translation>Zu einem anderen Bild klicken oder ziehen (Pfeile: ein Bild, mit Umschalt zehn; Pos1 und Ende)</translation>
    </message>
    <message>
        <source>%1 of %2   %3 s</source>
        <translation>%1 von %2   %3 s</translation>
    </message>
    <message>
        <source>Which image is shown, and how long before the freeze it was made</source>
        <translation>Welches Bild gezeigt wird und wie lange vor dem Einfrieren es entstand</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>1/4 ×</source>
        <translation>1/4 ×</translation>
    </message>
    <message>
        <source>1/2 ×</source>
        <translation>1/2 ×</translation>
    </message>
    <message>
        <source>1 ×</source>
        <translation>1 ×</translation>
    </message>
    <message>
        <source>2 ×</source>
        <translation>2 ×</translation>
    </message>
    <message>
        <source>Save what runs in the loop as a recording</source>
        <translation>Was in der Schleife läuft als Aufzeichnung speichern</translation>
    </message>
    <message>
        <source>Save clip…</source>
        <translation>Clip speichern…</translation>
    </message>
    <message>
        <source>An image back (%1, wheel; with Shift ten images)</source>
        <translation>Ein Bild zurück (%1, Rad; mit Umschalt zehn Bilder)</translation>
    </message>
    <message>
        <source>An image on (%1, wheel; with Shift ten images)</source>
        <translation>Ein Bild weiter (%1, Rad; mit Umschalt zehn Bilder)</translation>
    </message>
    <message>
        <source>The loop begins with this image; once more: with the first (%1)</source>
        <translation>Die Schleife beginnt mit diesem Bild; noch einmal: mit dem ersten (%1)</translation>
    </message>
    <message>
        <source>The loop ends with this image; once more: with the last (%1)</source>
        <translation>Die Schleife endet mit diesem Bild; noch einmal: mit dem letzten (%1)</translation>
    </message>
    <message>
        <source>Stop (%1)</source>
        <translation>Anhalten (%1)</translation>
    </message>
    <message>
        <source>Play in a loop (%1)</source>
        <translation>In einer Schleife abspielen (%1)</translation>
    </message>
</context>
<context>
    <name>ew::ui::ConsolePanel</name>
    <message>
        <source>Gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Fokus</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linear</translation>
    </message>
    <message>
        <source>Interpolated between eight voxels (2)</source>
        <translation>Zwischen acht Voxeln interpoliert (2)</translation>
    </message>
    <message>
        <source>Transducer</source>
        <translation>Schallkopf</translation>
    </message>
    <message>
        <source>Freeze</source>
        <translation>Einfrieren</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 x</source>
        <translation>%1 x</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Effects</source>
        <translation>Effekte</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Sonde</translation>
    </message>
    <message>
        <source>Dynamic range</source>
        <translation>Dynamikbereich</translation>
    </message>
    <message>
        <source>%1 dB</source>
        <translation>%1 dB</translation>
    </message>
    <message>
        <source>Grey map</source>
        <translation>Graukurve</translation>
    </message>
    <message>
        <source>Grey levels as they are (G for the next)</source>
        <translation>Grauwerte, wie sie sind (G für die nächste)</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>Weich</translation>
    </message>
    <message>
        <source>Lifts dark tissue (G for the next)</source>
        <translation>Hebt dunkles Gewebe an (G für die nächste)</translation>
    </message>
    <message>
        <source>Steep in the middle: more contrast (G for the next)</source>
        <translation>Steil in der Mitte: mehr Kontrast (G für die nächste)</translation>
    </message>
    <message>
        <source>Bright</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Brightens everything (G for the next)</source>
        <translation>Hellt alles auf (G für die nächste)</translation>
    </message>
    <message>
        <source>Clinical</source>
        <translation>Klinisch</translation>
    </message>
    <message>
        <source>As a machine shows the abdomen: black background, dark tissue, bright borders (G for the next)</source>
        <translation>Wie ein Gerät das Abdomen zeigt: schwarzer Grund, dunkles Gewebe, helle Grenzen (G für die nächste)</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>Persistence</source>
        <translation>Persistenz</translation>
    </message>
    <message>
        <source>Cubic</source>
        <translation>Kubisch</translation>
    </message>
    <message>
        <source>Interpolated between 64 voxels, sharpest (3)</source>
        <translation>Zwischen 64 Voxeln interpoliert, am schärfsten (3)</translation>
    </message>
    <message>
        <source>Adaptive</source>
        <translation>Adaptiv</translation>
    </message>
    <message>
        <source>The thickness is averaged over %1 planes</source>
        <translation>Die Dicke wird über %1 Ebenen gemittelt</translation>
    </message>
    <message>
        <source>Undo: effects of the case</source>
        <translation>Zurück zu meinen Effekten</translation>
    </message>
    <message>
        <source>Effects of the case</source>
        <translation>Effekte des Falls</translation>
    </message>
    <message>
        <source>Back to the effects as they were switched before</source>
        <translation>Zurück zu den Effekten, wie sie vorher geschaltet waren</translation>
    </message>
    <message>
        <source>Back to the effects that the case calls for</source>
        <translation>Zurück zu den Effekten, die der Fall verlangt</translation>
    </message>
    <message>
        <source>Transducer: %1 (T for the next)</source>
        <translation>Sonde: %1 (T für die nächste)</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>Higher is sharper, lower reaches deeper (H for the next)</source>
        <translation>Höher ist schärfer, tiefer reicht weiter (H für die nächste)</translation>
    </message>
    <message>
        <source>%1 MHz</source>
        <translation>%1 MHz</translation>
    </message>
    <message>
        <source>Steering</source>
        <translation>Schwenk</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Trapezoid</source>
        <translation>Trapez</translation>
    </message>
    <message>
        <source>Scan lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Apertur</translation>
    </message>
    <message>
        <source>Depths</source>
        <translation>Tiefen</translation>
    </message>
    <message>
        <source>%1–%2 mm</source>
        <translation>%1–%2 mm</translation>
    </message>
    <message>
        <source>Slice, thinnest</source>
        <translation>Dünnste Schicht</translation>
    </message>
    <message>
        <source>The image (M for the next mode)</source>
        <translation>Das Bild (M für den nächsten Modus)</translation>
    </message>
    <message>
        <source>Image and one beam over time (M for the next mode)</source>
        <translation>Bild und ein Strahl über die Zeit (M für den nächsten Modus)</translation>
    </message>
    <message>
        <source>One beam over time (M for the next mode)</source>
        <translation>Ein Strahl über die Zeit (M für den nächsten Modus)</translation>
    </message>
    <message>
        <source>M line</source>
        <translation>M-Linie</translation>
    </message>
    <message>
        <source>Sweep</source>
        <translation>Durchlauf</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Depth of the first focal zone (comma, full stop); drag the marks beside the image for the others</source>
        <translation>Tiefe der ersten Fokuszone (Komma, Punkt); die anderen neben dem Bild ziehen</translation>
    </message>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>Focal zones</source>
        <translation>Fokuszonen</translation>
    </message>
    <message>
        <source>Number of focal zones (N for the next)</source>
        <translation>Anzahl der Fokuszonen (N für die nächste)</translation>
    </message>
    <message>
        <source>Contrast</source>
        <translation>Kontrast</translation>
    </message>
    <message>
        <source>Edge enhancement</source>
        <translation>Kantenanhebung</translation>
    </message>
    <message>
        <source>Fast</source>
        <translation>Schnell</translation>
    </message>
    <message>
        <source>For a slow computer: the image follows the hand, and is coarser (1)</source>
        <translation>Für langsame Rechner: Das Bild folgt der Hand und ist gröber (1)</translation>
    </message>
    <message>
        <source>Fine</source>
        <translation>Fein</translation>
    </message>
    <message>
        <source>Smooth images (2)</source>
        <translation>Glatte Bilder (2)</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Erweitert</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>Abtastung</translation>
    </message>
    <message>
        <source>Nearest</source>
        <translation>Nächste</translation>
    </message>
    <message>
        <source>The nearest voxels, fastest (1)</source>
        <translation>Die nächsten Voxel, am schnellsten (1)</translation>
    </message>
    <message>
        <source>Focus model</source>
        <translation>Fokusmodell</translation>
    </message>
    <message>
        <source>Beam width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Coarse rows</source>
        <translation>Grobe Zeilen</translation>
    </message>
    <message>
        <source>Slice planes</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Performance…</source>
        <translation>Leistung…</translation>
    </message>
    <message>
        <source>Performance</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Invert left/right</source>
        <translation>Links/rechts spiegeln</translation>
    </message>
    <message>
        <source>Invert up/down</source>
        <translation>Oben/unten spiegeln</translation>
    </message>
    <message>
        <source>How the image is computed, and what that costs</source>
        <translation>Wie das Bild berechnet wird und was das kostet</translation>
    </message>
    <message>
        <source>Gain and TGC</source>
        <translation>Verstärkung und TGC</translation>
    </message>
    <message>
        <source>Decibels</source>
        <translation>Dezibel</translation>
    </message>
    <message>
        <source>As on a machine: along the beam, noise is amplified with the echoes</source>
        <translation>Wie am Gerät: entlang des Strahls, Rauschen wird mit den Echos verstärkt</translation>
    </message>
    <message>
        <source>Factors</source>
        <translation>Faktoren</translation>
    </message>
    <message>
        <source>As in the paper of 1998: factors on grey levels, by rows of the image</source>
        <translation>Wie im Artikel von 1998: Faktoren auf Grauwerte, nach Zeilen des Bildes</translation>
    </message>
    <message>
        <source>Overall gain (%1); double-click for neutral</source>
        <translation>Gesamtverstärkung (%1); Doppelklick für neutral</translation>
    </message>
    <message>
        <source>Depth of the image (%1)</source>
        <translation>Tiefe des Bildes (%1)</translation>
    </message>
    <message>
        <source>The marker is at the left, as usual; put it at the right (%1)</source>
        <translation>Die Marke ist links, wie üblich; nach rechts setzen (%1)</translation>
    </message>
    <message>
        <source>The marker is at the right; put it at the left, as usual (%1)</source>
        <translation>Die Marke ist rechts; nach links setzen, wie üblich (%1)</translation>
    </message>
    <message>
        <source>Keep the image, and look through the last 30 s (%1)</source>
        <translation>Das Bild festhalten und die letzten 30 s ansehen (%1)</translation>
    </message>
    <message>
        <source>What the image shows and how (%1)</source>
        <translation>Was das Bild zeigt und wie (%1)</translation>
    </message>
    <message>
        <source>What the scene does to the sound (%1)</source>
        <translation>Was die Szene mit dem Schall macht (%1)</translation>
    </message>
    <message>
        <source>The transducer and its beams (%1)</source>
        <translation>Die Sonde und ihre Strahlen (%1)</translation>
    </message>
    <message>
        <source>Every depth is blurred by the width its beam has there (%1)</source>
        <translation>Jede Tiefe wird so unscharf, wie ihr Strahl dort breit ist (%1)</translation>
    </message>
    <message>
        <source>Rows out of focus are undersampled and stretched back (%1)</source>
        <translation>Zeilen außerhalb des Fokus werden gröber abgetastet und wieder gestreckt (%1)</translation>
    </message>
    <message>
        <source>Levels this far below full white become black (%1)</source>
        <translation>So weit unter vollem Weiß wird es schwarz (%1)</translation>
    </message>
    <message>
        <source>Quality may fall while the probe moves fast, and refines at rest (%1)</source>
        <translation>Die Qualität darf sinken, solange sich die Sonde schnell bewegt, und steigt in Ruhe wieder (%1)</translation>
    </message>
    <message>
        <source>Tilts the beams of a linear array (%1)</source>
        <translation>Neigt die Strahlen einer Linearsonde (%1)</translation>
    </message>
    <message>
        <source>The lines of a linear array fan out (%1)</source>
        <translation>Die Linien einer Linearsonde fächern sich auf (%1)</translation>
    </message>
    <message>
        <source>Which beam is shown over time, from one end of the face to the other (%1)</source>
        <translation>Welcher Strahl über die Zeit gezeigt wird, von einem Ende der Sonde zum anderen (%1)</translation>
    </message>
    <message>
        <source>Time across the strip (%1)</source>
        <translation>Zeit über den Streifen (%1)</translation>
    </message>
    <message>
        <source>The probe is at the bottom; put it at the top, as usual (%1)</source>
        <translation>Die Sonde ist unten; nach oben setzen, wie üblich (%1)</translation>
    </message>
    <message>
        <source>The probe is at the top, as usual; put it at the bottom (%1)</source>
        <translation>Die Sonde ist oben, wie üblich; nach unten setzen (%1)</translation>
    </message>
    <message>
        <source>Makes borders sharper (%1)</source>
        <translation>Macht Grenzen schärfer (%1)</translation>
    </message>
    <message>
        <source>How much of the last image stays (%1)</source>
        <translation>Wie viel vom letzten Bild bleibt (%1)</translation>
    </message>
    <message>
        <source>Magnify; drag in the image to move the detail (%1)</source>
        <translation>Vergrößern; im Bild ziehen verschiebt den Ausschnitt (%1)</translation>
    </message>
    <message>
        <source>Measure what accuracy costs on this computer (%1)</source>
        <translation>Messen, was Genauigkeit auf diesem Rechner kostet (%1)</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Ausschnitt</translation>
    </message>
    <message>
        <source>Whole</source>
        <translation>Ganz</translation>
    </message>
    <message>
        <source>Wide</source>
        <translation>Panorama</translation>
    </message>
    <message>
        <source>Drag a box that fills the image then (%1)</source>
        <translation>Einen Ausschnitt aufziehen, der dann das Bild füllt (%1)</translation>
    </message>
    <message>
        <source>The whole image again (%1)</source>
        <translation>Wieder das ganze Bild (%1)</translation>
    </message>
    <message>
        <source>A wide image grows while the probe slides along its image (%1)</source>
        <translation>Ein Panoramabild wächst, während der Schallkopf in seiner Bildebene gleitet (%1)</translation>
    </message>
</context>
<context>
    <name>ew::ui::CostChart</name>
    <message>
        <source>Accuracy over time</source>
        <translation>Genauigkeit über der Zeit</translation>
    </message>
    <message>
        <source>%1: %2 ms, %3 dB</source>
        <translation>%1: %2 ms, %3 dB</translation>
    </message>
    <message>
        <source>PSNR, dB</source>
        <translation>PSNR, dB</translation>
    </message>
    <message>
        <source>RMS error, grey levels</source>
        <translation>mittlerer Fehler (RMS), Graustufen</translation>
    </message>
    <message>
        <source>time of a whole frame, ms</source>
        <translation>Zeit eines ganzen Bildes, ms</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>in use</source>
        <translation>in Gebrauch</translation>
    </message>
</context>
<context>
    <name>ew::ui::CostPanel</name>
    <message>
        <source>Cost of accuracy</source>
        <translation>Aufwand für Genauigkeit</translation>
    </message>
    <message>
        <source>Slicing</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Slice thickness</source>
        <translation>Schichtdicke</translation>
    </message>
    <message>
        <source>PSNR at least</source>
        <translation>PSNR mindestens</translation>
    </message>
    <message>
        <source> dB</source>
        <translation> dB</translation>
    </message>
    <message>
        <source>The accuracy that is wanted: peak signal to noise ratio against the reference</source>
        <translation>Die gewünschte Genauigkeit: Spitzen-Signal-Rausch-Verhältnis gegen die Referenz</translation>
    </message>
    <message>
        <source>Use the fastest that meets it</source>
        <translation>Die schnellste verwenden, die reicht</translation>
    </message>
    <message>
        <source>Sets the console to the fastest setting at or above the dashed line (Enter)</source>
        <translation>Stellt die Konsole auf die schnellste Einstellung an oder über der gestrichelten Linie (Eingabe)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close (Escape)</source>
        <translation>Schließen (Escape)</translation>
    </message>
    <message>
        <source>%1, %2 x %3 pixels, %4</source>
        <translation>%1, %2 x %3 Pixel, %4</translation>
    </message>
    <message>
        <source>Measuring the cost of accuracy</source>
        <translation>Aufwand für Genauigkeit messen</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>No setting reaches it.</source>
        <translation>Keine Einstellung erreicht das.</translation>
    </message>
    <message numerus="yes">
        <source>%n planes</source>
        <translation>
            <numerusform>%n Ebene</numerusform>
            <numerusform>%n Ebenen</numerusform>
        </translation>
    </message>
    <message>
        <source>In use: %1.</source>
        <translation>In Gebrauch: %1.</translation>
    </message>
    <message>
        <source>Open a case or a volume first; then its own slices are measured.</source>
        <translation>Zuerst einen Fall oder ein Volumen öffnen; dann werden dessen Schnitte gemessen.</translation>
    </message>
    <message>
        <source>Measuring on this machine, with the open volume …</source>
        <translation>Messung auf diesem Rechner mit dem offenen Volumen …</translation>
    </message>
    <message>
        <source>Measure what each quality costs on this machine, with the open volume.</source>
        <translation>Messen, was jede Qualität auf diesem Rechner mit dem offenen Volumen kostet.</translation>
    </message>
    <message numerus="yes">
        <source>Error of whole frames against those with 9 planes, %n poses around the present one.</source>
        <translation>
            <numerusform>Fehler ganzer Bilder gegen die mit 9 Ebenen, %n Lage.</numerusform>
            <numerusform>Fehler ganzer Bilder gegen die mit 9 Ebenen, %n Lagen um die jetzige.</numerusform>
        </translation>
    </message>
    <message>
        <source>Error of the slice against a windowed sinc (Lanczos, 10 x 10 x 10 voxels) in double precision of the same voxels, %1 pixels in %2 poses around the present one. Times are medians of whole frames with the scene&apos;s effects.</source>
        <translation>Fehler des Schnitts gegen einen gefensterten Sinc (Lanczos, 10 x 10 x 10 Voxel) derselben Voxel in doppelter Genauigkeit, %1 Pixel in %2 Lagen um die jetzige. Zeiten sind Mediane ganzer Bilder mit den Effekten der Szene.</translation>
    </message>
    <message>
        <source>Error of whole frames against the same scatterers formed as finely as possible (%1 samples along a pulse, a slice of %2 standard deviations), %3 pixels in %4 poses around the present one.</source>
        <translation>Fehler ganzer Bilder gegen dieselben Streuer, so fein wie möglich gebildet (%1 Abtastwerte je Puls, eine Schicht von %2 Standardabweichungen), %3 Pixel in %4 Lagen um die jetzige.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Noch einmal messen</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Stop measuring</source>
        <translation>Die Messung anhalten</translation>
    </message>
    <message>
        <source>Voxels are read in bricks: a slice takes %1 ms, as they lie %2 ms.</source>
        <translation>Voxel werden in Blöcken gelesen: ein Schnitt braucht %1 ms, so wie sie liegen %2 ms.</translation>
    </message>
    <message>
        <source>Voxels are read in bricks or as they lie, whichever is faster in the slice&apos;s direction: a slice takes %1 ms, in bricks alone %2 ms, as they lie alone %3 ms.</source>
        <translation>Voxel werden in Blöcken gelesen oder so, wie sie liegen, je nachdem, was in der Richtung des Schnitts schneller ist: ein Schnitt braucht %1 ms, nur in Blöcken %2 ms, nur so, wie sie liegen, %3 ms.</translation>
    </message>
    <message>
        <source>Voxels are read as they lie: a slice takes %1 ms, in bricks %2 ms.</source>
        <translation>Voxel werden gelesen, wie sie liegen: ein Schnitt braucht %1 ms, in Blöcken %2 ms.</translation>
    </message>
    <message>
        <source>Timed on this machine when the first volume of about this size was opened: slices of 200 x 140 pixels of every quality in directions of six kinds, one thread</source>
        <translation>Auf diesem Rechner gemessen, als das erste Volumen etwa dieser Größe geöffnet wurde: Schnitte von 200 x 140 Pixeln jeder Qualität in Richtungen von sechs Arten, ein Thread</translation>
    </message>
    <message>
        <source>Time each setting on the open volume, around the present pose</source>
        <translation>Jede Einstellung am offenen Volumen um die jetzige Lage messen</translation>
    </message>
</context>
<context>
    <name>ew::ui::DgcColumn</name>
    <message>
        <source>TGC %1</source>
        <translation>TGC %1</translation>
    </message>
    <message>
        <source>TGC</source>
        <translation>TGC</translation>
    </message>
    <message>
        <source>Reset TGC</source>
        <translation>TGC zurücksetzen</translation>
    </message>
    <message>
        <source>%1 to %2 mm: %3 %</source>
        <translation>%1 bis %2 mm: %3 %</translation>
    </message>
    <message>
        <source>%1 to %2 mm: %3 dB</source>
        <translation>%1 bis %2 mm: %3 dB</translation>
    </message>
    <message>
        <source>Time gain compensation: one slider for each eighth of the depth. Click to put all of them back to the middle (%1), double-click one for itself</source>
        <translation>Tiefenausgleich: ein Regler für jedes Achtel der Tiefe. Klicken stellt alle wieder in die Mitte (%1), Doppelklick einen allein</translation>
    </message>
</context>
<context>
    <name>ew::ui::FileImportDialog</name>
    <message>
        <source>Clean as a recorded screen…</source>
        <translation>Als Bildschirmaufnahme bereinigen …</translation>
    </message>
    <message>
        <source>Finds the outline of the scan, its scale and text over it; the images are shown, played and measured</source>
        <translation>Findet den Umriss des Schallbilds, seinen Maßstab und Text darüber; die Bilder werden gezeigt, abgespielt und gemessen</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>not chosen</source>
        <translation>nicht gewählt</translation>
    </message>
    <message>
        <source>Text burned into the images may stay</source>
        <translation>Eingebrannter Text in den Bildern darf bleiben</translation>
    </message>
    <message>
        <source>Part of the image</source>
        <translation>Teil des Bildes</translation>
    </message>
    <message>
        <source>Size of a pixel</source>
        <translation>Größe eines Pixels</translation>
    </message>
    <message>
        <source>Spacing to convert to</source>
        <translation>Abstand nach der Umrechnung</translation>
    </message>
    <message>
        <source>Spacing x, y, z</source>
        <translation>Abstand x, y, z</translation>
    </message>
    <message>
        <source>keep as grey</source>
        <translation>als Grau behalten</translation>
    </message>
    <message>
        <source>drop (black)</source>
        <translation>weglassen (schwarz)</translation>
    </message>
    <message>
        <source>x,y,width,height; more with blanks between them</source>
        <translation>x,y,Breite,Höhe; weitere durch Leerzeichen getrennt</translation>
    </message>
    <message>
        <source>Coloured pixels</source>
        <translation>Farbige Pixel</translation>
    </message>
    <message>
        <source>Make black</source>
        <translation>Schwärzen</translation>
    </message>
    <message>
        <source>the only one</source>
        <translation>der einzige</translation>
    </message>
    <message>
        <source>Volume number</source>
        <translation>Nummer des Volumens</translation>
    </message>
    <message>
        <source>Turn the elevational axis over</source>
        <translation>Elevationsachse umdrehen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1 x %2 x %3, %4, after %5 bytes</source>
        <translation>%1 x %2 x %3, %4, nach %5 Bytes</translation>
    </message>
    <message>
        <source>big endian</source>
        <translation>Big-Endian</translation>
    </message>
    <message>
        <source> bytes</source>
        <translation> Bytes</translation>
    </message>
    <message>
        <source>Layouts that fit the size</source>
        <translation>Aufteilungen, die zur Größe passen</translation>
    </message>
    <message>
        <source>Samples x, y, z</source>
        <translation>Werte x, y, z</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Samples begin after</source>
        <translation>Werte beginnen nach</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>the whole image, %1 x %2 pixels</source>
        <translation>das ganze Bild, %1 x %2 Pixel</translation>
    </message>
    <message>
        <source>Importing %1</source>
        <translation>%1 wird importiert</translation>
    </message>
    <message>
        <source>Save the images as a sequence</source>
        <translation>Bilder als Sequenz speichern</translation>
    </message>
    <message>
        <source>Sequences (*.igs.mha)</source>
        <translation>Sequenzen (*.igs.mha)</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>%1 wird geschrieben</translation>
    </message>
    <message>
        <source>Click a numbered part to keep it alone. Drag a rectangle over what is to become black; a right click on it takes it away. Coloured pixels are orange.</source>
        <translation>Ein Klick auf einen nummerierten Teil behält nur diesen. Ein aufgezogenes Rechteck wird schwarz; ein Rechtsklick darauf nimmt es weg. Farbige Pixel sind orange.</translation>
    </message>
    <message>
        <source>Drag a rectangle over what is to become black; a right click on it takes it away. Coloured pixels are orange.</source>
        <translation>Ein aufgezogenes Rechteck wird schwarz; ein Rechtsklick darauf nimmt es weg. Farbige Pixel sind orange.</translation>
    </message>
    <message>
        <source>drawn, or x,y,width,height</source>
        <translation>gezogen oder x,y,Breite,Höhe</translation>
    </message>
    <message>
        <source>1 to %1, not chosen</source>
        <translation>1 bis %1, nicht gewählt</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message numerus="yes">
        <source>%1 was imported; %n notes say what was decided and left out.</source>
        <translation>
            <numerusform>%1 wurde importiert; eine Anmerkung sagt, was entschieden und weggelassen wurde.</numerusform>
            <numerusform>%1 wurde importiert; %n Anmerkungen sagen, was entschieden und weggelassen wurde.</numerusform>
        </translation>
    </message>
    <message>
        <source>Reading the slices of %1</source>
        <translation>Schnitte von %1 werden gelesen</translation>
    </message>
</context>
<context>
    <name>ew::ui::FocusScale</name>
    <message>
        <source>Drag a mark to its focus depth (%1)</source>
        <translation>Eine Marke auf ihre Fokustiefe ziehen (%1)</translation>
    </message>
    <message>
        <source>Depth in cm; the focus is off (%1)</source>
        <translation>Tiefe in cm; der Fokus ist aus (%1)</translation>
    </message>
</context>
<context>
    <name>ew::ui::ImportDialog</name>
    <message>
        <source>%1 MiB</source>
        <translation>%1 MiB</translation>
    </message>
    <message>
        <source>%1 GiB</source>
        <translation>%1 GiB</translation>
    </message>
    <message>
        <source>Reconstruct sweep</source>
        <translation>Schwenk rekonstruieren</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>default</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>linear: smoother, slower</source>
        <translation>linear: glatter, langsamer</translation>
    </message>
    <message>
        <source>nearest: faster</source>
        <translation>nächster: schneller</translation>
    </message>
    <message>
        <source>mean of all views</source>
        <translation>Mittel aller Ansichten</translation>
    </message>
    <message>
        <source>weighted by confidence: shadows count less</source>
        <translation>nach Verlässlichkeit gewichtet: Schatten zählen weniger</translation>
    </message>
    <message>
        <source>maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>latest view</source>
        <translation>neueste Ansicht</translation>
    </message>
    <message>
        <source>do not fill</source>
        <translation>nicht füllen</translation>
    </message>
    <message>
        <source>Holes at most this far between measured voxels are filled and marked as interpolated</source>
        <translation>Lücken bis zu dieser Weite zwischen gemessenen Voxeln werden gefüllt und als interpoliert vermerkt</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Reference frame</source>
        <translation>Bezugssystem</translation>
    </message>
    <message>
        <source>Voxel spacing</source>
        <translation>Voxelabstand</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Interpolation</translation>
    </message>
    <message>
        <source>Compounding</source>
        <translation>Compounding</translation>
    </message>
    <message>
        <source>Fill holes up to</source>
        <translation>Lücken füllen bis</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>Reconstruct</source>
        <translation>Rekonstruieren</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Calibration of the sweep</source>
        <translation>Kalibrierung des Schwenks</translation>
    </message>
    <message>
        <source>Device sets (*.xml)</source>
        <translation>Kalibrierungen (*.xml)</translation>
    </message>
    <message>
        <source>Reading the sweep…</source>
        <translation>Der Schwenk wird gelesen…</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>default (%1)</source>
        <translation>Vorgabe (%1)</translation>
    </message>
    <message>
        <source>%1 of %2 used (%3 invalid, %4 without a pose)</source>
        <translation>%1 von %2 brauchbar (%3 ungültig, %4 ohne Lage)</translation>
    </message>
    <message>
        <source>%1 x %2 x %3 voxels, %4 x %5 x %6 mm</source>
        <translation>%1 x %2 x %3 Voxel, %4 x %5 x %6 mm</translation>
    </message>
    <message>
        <source>The volume would need more than the %1 allowed; choose a coarser spacing.</source>
        <translation>Das Volumen bräuchte mehr als die erlaubten %1; einen gröberen Voxelabstand wählen.</translation>
    </message>
    <message>
        <source>%1 while it is made, the volume itself %2</source>
        <translation>%1 beim Erzeugen, das Volumen selbst %2</translation>
    </message>
    <message>
        <source>Making a volume from %1</source>
        <translation>Aus %1 wird ein Volumen</translation>
    </message>
    <message>
        <source>Record source frame per voxel</source>
        <translation>Quellbild je Voxel festhalten</translation>
    </message>
    <message>
        <source>Then a point of the image leads to its source frame; 2 bytes a voxel more</source>
        <translation>Dann führt ein Punkt des Bildes zu seinem Quellbild; 2 Byte je Voxel mehr</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Herkunft</translation>
    </message>
    <message>
        <source>The sweep has more than %1 frames; which of them a voxel came from cannot be kept.</source>
        <translation>Der Schwenk hat mehr als %1 Bilder; aus welchem davon ein Voxel stammt, kann nicht behalten werden.</translation>
    </message>
    <message>
        <source>none given</source>
        <translation>keine angegeben</translation>
    </message>
    <message>
        <source>Device set of the recording (.xml); several with ; between them, the earlier counts where two say the same</source>
        <translation>Kalibrierung der Aufnahme (.xml); mehrere durch ; getrennt, bei gleichen Angaben zählt die frühere</translation>
    </message>
    <message>
        <source>as a tracker recorded</source>
        <translation>wie ein Tracker aufzeichnete</translation>
    </message>
    <message>
        <source>as the recording says of its motor</source>
        <translation>wie die Aufnahme von ihrem Motor sagt</translation>
    </message>
    <message>
        <source>as a motor file says</source>
        <translation>wie eine Motordatei sagt</translation>
    </message>
    <message>
        <source>sideways, evenly</source>
        <translation>seitwärts, gleichmäßig</translation>
    </message>
    <message>
        <source>tilted, evenly</source>
        <translation>gekippt, gleichmäßig</translation>
    </message>
    <message>
        <source>rotated about the beam, evenly</source>
        <translation>um den Strahl gedreht, gleichmäßig</translation>
    </message>
    <message>
        <source>motor file (.json)</source>
        <translation>Motordatei (.json)</translation>
    </message>
    <message>
        <source>From the face back to the axis the probe was tilted about; 0: about its face</source>
        <translation>Von der Schallkopffläche zurück zur Achse, um die gekippt wurde; 0: um die Fläche selbst</translation>
    </message>
    <message>
        <source>axis </source>
        <translation>Achse </translation>
    </message>
    <message>
        <source>from frame to frame</source>
        <translation>von Bild zu Bild</translation>
    </message>
    <message>
        <source>The probe moved</source>
        <translation>Der Schallkopf bewegte sich</translation>
    </message>
    <message>
        <source>How a motor moved the probe</source>
        <translation>Wie ein Motor den Schallkopf bewegte</translation>
    </message>
    <message>
        <source>Motor files (*.json)</source>
        <translation>Motordateien (*.json)</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>as the device set says, else all</source>
        <translation>wie die Kalibrierung sagt, sonst ganz</translation>
    </message>
    <message>
        <source>Of each frame this rectangle alone is used: x,y,width,height in pixels. Drag it over the image.</source>
        <translation>Von jedem Bild wird nur dieses Rechteck verwendet: x,y,Breite,Höhe in Pixeln. Es lässt sich im Bild aufziehen.</translation>
    </message>
    <message>
        <source>as the device set says, else none</source>
        <translation>wie die Kalibrierung sagt, sonst keiner</translation>
    </message>
    <message>
        <source>Of each frame this fan alone is used: left and right angle in degrees from straight down, x and y of the apex, first and last radius in pixels</source>
        <translation>Von jedem Bild wird nur dieser Fächer verwendet: linker und rechter Winkel in Grad von der Senkrechten, x und y der Spitze, erster und letzter Radius in Pixeln</translation>
    </message>
    <message>
        <source>Rectangle of frames</source>
        <translation>Rechteck der Bilder</translation>
    </message>
    <message>
        <source>Fan of frames</source>
        <translation>Fächer der Bilder</translation>
    </message>
    <message>
        <source>The first frame. Drag a rectangle over what is to be used of every frame.</source>
        <translation>Das erste Bild. Ein Rechteck über das ziehen, was von jedem Bild verwendet werden soll.</translation>
    </message>
    <message>
        <source>Choose the motor file that says how the probe moved.</source>
        <translation>Die Motordatei wählen, die sagt, wie sich der Schallkopf bewegte.</translation>
    </message>
    <message>
        <source>Say how far the probe moved from frame to frame; 0 would put all frames into one place.</source>
        <translation>Angeben, wie weit sich der Schallkopf von Bild zu Bild bewegte; 0 legte alle Bilder an dieselbe Stelle.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not %2.</source>
        <translation>„%1“ ist nicht brauchbar; erwartet: %2.</translation>
    </message>
    <message>
        <source>a fan; give left and right angle, x and y of the apex, first and last radius</source>
        <translation>ein Fächer aus linkem und rechtem Winkel, x und y der Spitze, erstem und letztem Radius</translation>
    </message>
</context>
<context>
    <name>ew::ui::JobCards</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Hält an…</translation>
    </message>
</context>
<context>
    <name>ew::ui::MainWindow</name>
    <message>
        <source>Not now</source>
        <translation>Jetzt nicht</translation>
    </message>
    <message>
        <source>%1 wants to start a lesson here. It will be told when you have worked through it, and your result.</source>
        <translation>%1 möchte hier eine Lektion starten. Es erfährt, wann Sie sie bearbeitet haben, und Ihr Ergebnis.</translation>
    </message>
    <message>
        <source>Begin the lesson</source>
        <translation>Lektion beginnen</translation>
    </message>
    <message>
        <source>There is not enough memory for this; close other programs and try again.</source>
        <translation>Dafür reicht der Speicher nicht; andere Programme schließen und noch einmal versuchen.</translation>
    </message>
    <message>
        <source>The program met a problem that it did not foresee (%1). Your work is still there: save it, and please report this with what you did.</source>
        <translation>Das Programm stieß auf ein unvorhergesehenes Problem (%1). Die Arbeit ist noch da: sie speichern, das Problem bitte melden und dabei die letzten Schritte nennen.</translation>
    </message>
    <message>
        <source>The case &apos;%1&apos; has changes that are not saved.</source>
        <translation>Der Fall „%1“ hat Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>Several files were dropped; the first one is opened.</source>
        <translation>Mehrere Dateien wurden abgelegt; die erste wird geöffnet.</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open case &amp;folder…</source>
        <translation>Fall&amp;ordner öffnen…</translation>
    </message>
    <message>
        <source>Open case folder</source>
        <translation>Fallordner öffnen</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>S&amp;tart page</source>
        <translation>S&amp;tartseite</translation>
    </message>
    <message>
        <source>&amp;Save case</source>
        <translation>Fall &amp;speichern</translation>
    </message>
    <message>
        <source>Save case &amp;as…</source>
        <translation>Fall speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Save &amp;volume as…</source>
        <translation>&amp;Volumen speichern unter…</translation>
    </message>
    <message>
        <source>Save &amp;image as…</source>
        <translation>&amp;Bild speichern unter…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Explore</source>
        <translation>&amp;Erkunden</translation>
    </message>
    <message>
        <source>&amp;Author</source>
        <translation>&amp;Gestalten</translation>
    </message>
    <message>
        <source>From the &amp;front</source>
        <translation>Von &amp;vorn</translation>
    </message>
    <message>
        <source>From the &amp;back</source>
        <translation>Von &amp;hinten</translation>
    </message>
    <message>
        <source>From the patient&apos;s &amp;right</source>
        <translation>Von &amp;rechts (Patient)</translation>
    </message>
    <message>
        <source>From the patient&apos;s &amp;left</source>
        <translation>Von &amp;links (Patient)</translation>
    </message>
    <message>
        <source>From the &amp;head</source>
        <translation>Vom &amp;Kopf</translation>
    </message>
    <message>
        <source>Look at the &amp;volume</source>
        <translation>Auf das V&amp;olumen sehen</translation>
    </message>
    <message>
        <source>Scan the &amp;case&apos;s volume</source>
        <translation>Volumen des &amp;Falles schallen</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>L&amp;ight</source>
        <translation>He&amp;ll</translation>
    </message>
    <message>
        <source>La&amp;nguage</source>
        <translation>S&amp;prache</translation>
    </message>
    <message>
        <source>System default</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>Vollb&amp;ild</translation>
    </message>
    <message>
        <source>&amp;Scan</source>
        <translation>&amp;Scan</translation>
    </message>
    <message>
        <source>&amp;Freeze</source>
        <translation>&amp;Einfrieren</translation>
    </message>
    <message>
        <source>Deeper</source>
        <translation>Tiefer</translation>
    </message>
    <message>
        <source>Shallower</source>
        <translation>Flacher</translation>
    </message>
    <message>
        <source>More gain</source>
        <translation>Mehr Verstärkung</translation>
    </message>
    <message>
        <source>Less gain</source>
        <translation>Weniger Verstärkung</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Reset TGC</source>
        <translation>TGC zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Werkzeuge</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>&amp;Tasten und Maus</translation>
    </message>
    <message>
        <source>&amp;Plugins…</source>
        <translation>&amp;Erweiterungen…</translation>
    </message>
    <message>
        <source>&amp;About EchoWeave</source>
        <translation>&amp;Über EchoWeave</translation>
    </message>
    <message>
        <source>About EchoWeave</source>
        <translation>Über EchoWeave</translation>
    </message>
    <message>
        <source>EchoWeave %1

A workstation for building and using ultrasound training cases. A simulation, not for diagnosis.

Apache License 2.0. Slicing and console follow D. Aiger and D. Cohen-Or, Real-Time Ultrasound Imaging Simulation, 1998.</source>
        <translation>EchoWeave %1

Ein Arbeitsplatz, um Ultraschall-Übungsfälle zu bauen und zu nutzen. Eine Simulation, nicht zur Diagnose.

Apache License 2.0. Schnitte und Konsole folgen D. Aiger und D. Cohen-Or, Real-Time Ultrasound Imaging Simulation, 1998.</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Sonde</translation>
    </message>
    <message>
        <source>rotate</source>
        <translation>drehen</translation>
    </message>
    <message>
        <source>back to the start</source>
        <translation>zurück zum Anfang</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>Right drag</source>
        <translation>Rechts ziehen</translation>
    </message>
    <message>
        <source>rotate the body</source>
        <translation>den Körper drehen</translation>
    </message>
    <message>
        <source>Middle drag</source>
        <translation>Mitte ziehen</translation>
    </message>
    <message>
        <source>move the body</source>
        <translation>den Körper verschieben</translation>
    </message>
    <message>
        <source>closer, farther</source>
        <translation>näher, weiter weg</translation>
    </message>
    <message>
        <source>front, back, right, left, head</source>
        <translation>vorn, hinten, rechts, links, Kopf</translation>
    </message>
    <message>
        <source>look at the volume</source>
        <translation>auf das Volumen sehen</translation>
    </message>
    <message>
        <source>freeze</source>
        <translation>einfrieren</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>reset TGC</source>
        <translation>TGC zurücksetzen</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>save the case, save it elsewhere</source>
        <translation>Fall speichern, anderswo speichern</translation>
    </message>
    <message>
        <source>undo, redo</source>
        <translation>rückgängig, wiederherstellen</translation>
    </message>
    <message>
        <source>Explore, Author</source>
        <translation>Erkunden, Gestalten</translation>
    </message>
    <message>
        <source>full screen</source>
        <translation>Vollbild</translation>
    </message>
    <message>
        <source>this page</source>
        <translation>diese Seite</translation>
    </message>
    <message>
        <source>Open a case, a volume or a sweep</source>
        <translation>Fall, Volumen oder Schwenk öffnen</translation>
    </message>
    <message>
        <source>The volume lies elsewhere in the body than its own coordinates say. Which place should the file hold?</source>
        <translation>Das Volumen liegt im Körper woanders, als seine eigenen Koordinaten sagen. Welchen Ort soll die Datei festhalten?</translation>
    </message>
    <message>
        <source>Its own coordinates keep it in place beside other volumes of the same recording.</source>
        <translation>Mit den eigenen Koordinaten bleibt es am richtigen Ort neben anderen Volumen derselben Aufnahme.</translation>
    </message>
    <message>
        <source>Its own coordinates</source>
        <translation>Seine eigenen Koordinaten</translation>
    </message>
    <message>
        <source>Its place in the body</source>
        <translation>Seinen Ort im Körper</translation>
    </message>
    <message>
        <source>Save the volume</source>
        <translation>Das Volumen speichern</translation>
    </message>
    <message>
        <source>MetaImage (*.mha *.mhd)</source>
        <translation>MetaImage (*.mha *.mhd)</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
    <message>
        <source>Saved to %1.</source>
        <translation>Gespeichert als %1.</translation>
    </message>
    <message>
        <source>Save the image</source>
        <translation>Das Bild speichern</translation>
    </message>
    <message>
        <source>scan</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Images (*.png *.mha)</source>
        <translation>Bilder (*.png *.mha)</translation>
    </message>
    <message>
        <source>a volume without a case</source>
        <translation>ein Volumen ohne Fall</translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation>etwa %1 s</translation>
    </message>
    <message>
        <source>Preparing</source>
        <translation>Wird vorbereitet</translation>
    </message>
    <message>
        <source>Will be prepared, %1</source>
        <translation>Wird noch vorbereitet, %1</translation>
    </message>
    <message>
        <source>Not prepared yet, %1; open it to begin</source>
        <translation>Noch nicht vorbereitet, %1; zum Beginnen öffnen</translation>
    </message>
    <message>
        <source>The window was not ready within %1 s; try a smaller volume.</source>
        <translation>Das Fenster war nach %1 s nicht bereit; ein kleineres Volumen versuchen.</translation>
    </message>
    <message>
        <source>The image cannot be written to &apos;%1&apos;; choose a folder you may write to.</source>
        <translation>Das Bild lässt sich nicht nach „%1“ schreiben; einen Ordner mit Schreibrecht wählen.</translation>
    </message>
    <message>
        <source>Saved to %1, and which voxels were measured to %2.</source>
        <translation>Gespeichert als %1, und welche Voxel gemessen wurden als %2.</translation>
    </message>
    <message>
        <source>&amp;Image</source>
        <translation>&amp;Bild</translation>
    </message>
    <message>
        <source>Focus shallower</source>
        <translation>Fokus flacher</translation>
    </message>
    <message>
        <source>Focus deeper</source>
        <translation>Fokus tiefer</translation>
    </message>
    <message>
        <source>Wider dynamic range</source>
        <translation>Weiterer Dynamikbereich</translation>
    </message>
    <message>
        <source>Narrower dynamic range</source>
        <translation>Engerer Dynamikbereich</translation>
    </message>
    <message>
        <source>Next grey map</source>
        <translation>Nächste Graukurve</translation>
    </message>
    <message>
        <source>More persistence</source>
        <translation>Mehr Persistenz</translation>
    </message>
    <message>
        <source>Less persistence</source>
        <translation>Weniger Persistenz</translation>
    </message>
    <message>
        <source>&amp;Effects</source>
        <translation>&amp;Effekte</translation>
    </message>
    <message>
        <source>Planes of the slice thickness</source>
        <translation>Ebenen der Schichtdicke</translation>
    </message>
    <message>
        <source>&amp;Probe</source>
        <translation>&amp;Sonde</translation>
    </message>
    <message>
        <source>Next transducer</source>
        <translation>Nächste Sonde</translation>
    </message>
    <message>
        <source>Next frequency</source>
        <translation>Nächste Frequenz</translation>
    </message>
    <message>
        <source>Steer to one side</source>
        <translation>Zur einen Seite schwenken</translation>
    </message>
    <message>
        <source>Steer to the other side</source>
        <translation>Zur anderen Seite schwenken</translation>
    </message>
    <message>
        <source>Trapezoid</source>
        <translation>Trapez</translation>
    </message>
    <message>
        <source>&amp;M-mode</source>
        <translation>&amp;M-Modus</translation>
    </message>
    <message>
        <source>B, B + M, M</source>
        <translation>B, B + M, M</translation>
    </message>
    <message>
        <source>M line to the left</source>
        <translation>M-Linie nach links</translation>
    </message>
    <message>
        <source>M line to the right</source>
        <translation>M-Linie nach rechts</translation>
    </message>
    <message>
        <source>Slower sweep</source>
        <translation>Langsamerer Durchlauf</translation>
    </message>
    <message>
        <source>Faster sweep</source>
        <translation>Schnellerer Durchlauf</translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation>&amp;Qualität</translation>
    </message>
    <message>
        <source>Cubic: sharpest</source>
        <translation>Kubisch: am schärfsten</translation>
    </message>
    <message>
        <source>Adaptive: falls while the probe moves fast</source>
        <translation>Adaptiv: sinkt, solange sich die Sonde schnell bewegt</translation>
    </message>
    <message>
        <source>Next page of the console</source>
        <translation>Nächste Seite der Konsole</translation>
    </message>
    <message>
        <source>adaptive quality</source>
        <translation>adaptive Qualität</translation>
    </message>
    <message>
        <source>next page of the console</source>
        <translation>nächste Seite der Konsole</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>focus depth</source>
        <translation>Fokustiefe</translation>
    </message>
    <message>
        <source>dynamic range</source>
        <translation>Dynamikbereich</translation>
    </message>
    <message>
        <source>grey map</source>
        <translation>Graukurve</translation>
    </message>
    <message>
        <source>persistence</source>
        <translation>Persistenz</translation>
    </message>
    <message>
        <source>M line</source>
        <translation>M-Linie</translation>
    </message>
    <message>
        <source>sweep of the M-mode</source>
        <translation>Durchlauf des M-Modus</translation>
    </message>
    <message>
        <source>Effects and probe</source>
        <translation>Effekte und Sonde</translation>
    </message>
    <message>
        <source>next transducer, next frequency</source>
        <translation>nächste Sonde, nächste Frequenz</translation>
    </message>
    <message>
        <source>steer a linear array, trapezoid</source>
        <translation>Linearsonde schwenken, Trapez</translation>
    </message>
    <message>
        <source>All that EchoWeave reads (case.json *.ewcase *.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz *.dcm *.vol *.v00 *.raw *.png *.jpg *.pgm *.mp4 *.mov *.mkv *.avi *.mpg *.mpeg *.tif *.tiff);;Cases (case.json *.ewcase);;Sweeps (*.igs.mha *.igs.mhd *.igs.nrrd *.seq.mha *.seq.nrrd *.mha *.mhd *.nrrd);;Volumes (*.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz);;Films and recorded screens (*.mp4 *.mov *.mkv *.avi *.mpg *.mpeg *.tif *.tiff *.dcm);;DICOM, Kretz, raw samples, images (*)</source>
        <translation>Alles, was EchoWeave liest (case.json *.ewcase *.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz *.dcm *.vol *.v00 *.raw *.png *.jpg *.pgm *.mp4 *.mov *.mkv *.avi *.mpg *.mpeg *.tif *.tiff);;Fälle (case.json *.ewcase);;Schwenks (*.igs.mha *.igs.mhd *.igs.nrrd *.seq.mha *.seq.nrrd *.mha *.mhd *.nrrd);;Volumen (*.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz);;Filme und Bildschirmaufnahmen (*.mp4 *.mov *.mkv *.avi *.mpg *.mpeg *.tif *.tiff *.dcm);;DICOM, Kretz, Rohdaten, Bilder (*)</translation>
    </message>
    <message>
        <source>Show source &amp;frame</source>
        <translation>&amp;Quellbild zeigen</translation>
    </message>
    <message>
        <source>which frame a point came from</source>
        <translation>aus welchem Bild ein Punkt stammt</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
    <message>
        <source>&amp;Save project</source>
        <translation>Projekt &amp;speichern</translation>
    </message>
    <message>
        <source>Save project &amp;as…</source>
        <translation>Projekt speichern &amp;unter…</translation>
    </message>
    <message>
        <source>The case &apos;%1&apos; was saved by another window or program since it was opened here.</source>
        <translation>Der Fall „%1“ wurde von einem anderen Fenster oder Programm gespeichert, seit er hier geöffnet wurde.</translation>
    </message>
    <message>
        <source>Save as keeps both, each in a folder of its own. Reload drops the changes made here. Overwrite drops the others&apos;.</source>
        <translation>„Speichern unter“ behält beide, jeden in einem eigenen Ordner. „Neu laden“ verwirft die Änderungen von hier, „Überschreiben“ die anderen.</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Neu laden</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Überschreiben</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is ready to be shown in its place.</source>
        <translation>„%1“ ist bereit und würde an seiner Stelle gezeigt.</translation>
    </message>
    <message>
        <source>The volume made from &apos;%1&apos; is not saved.</source>
        <translation>Das Volumen aus „%1“ ist nicht gespeichert.</translation>
    </message>
    <message>
        <source>Making it again takes as long as it did.</source>
        <translation>Es noch einmal zu erstellen dauert so lange wie beim ersten Mal.</translation>
    </message>
    <message>
        <source>The volume made from %1 is kept: View, Show the volume made from %1.</source>
        <translation>Das Volumen aus %1 bleibt erhalten: Ansicht, Volumen aus %1 zeigen.</translation>
    </message>
    <message>
        <source>Show the volume made from %1</source>
        <translation>Volumen aus %1 zeigen</translation>
    </message>
    <message>
        <source>The case &apos;%1&apos; has changes of %2 that were not saved when the program ended.</source>
        <translation>Der Fall „%1“ hat Änderungen vom %2, die nicht gespeichert waren, als das Programm endete.</translation>
    </message>
    <message>
        <source>Folder: %1</source>
        <translation>Ordner: %1</translation>
    </message>
    <message>
        <source>Open with these changes</source>
        <translation>Mit diesen Änderungen öffnen</translation>
    </message>
    <message>
        <source>Throw them away</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Decide later</source>
        <translation>Später entscheiden</translation>
    </message>
    <message>
        <source>Take over the changes of %1</source>
        <translation>Änderungen vom %1 übernehmen</translation>
    </message>
    <message>
        <source>The case &apos;%1&apos; belongs to the program.</source>
        <translation>Der Fall „%1“ gehört zum Programm.</translation>
    </message>
    <message>
        <source>Save a copy of your own: the next version of the program replaces what is changed in its own cases.</source>
        <translation>Eine eigene Kopie speichern: Die nächste Version des Programms ersetzt, was an seinen Fällen geändert wird.</translation>
    </message>
    <message>
        <source>Save a copy…</source>
        <translation>Kopie speichern…</translation>
    </message>
    <message>
        <source>Change the program&apos;s case</source>
        <translation>Fall des Programms ändern</translation>
    </message>
    <message>
        <source>Saved in %1.</source>
        <translation>Gespeichert in %1.</translation>
    </message>
    <message>
        <source>The case &apos;%1&apos; belongs to the program. It is copied to a folder of your own first, and changed there.</source>
        <translation>Der Fall „%1“ gehört zum Programm. Er wird zuerst in einen eigenen Ordner kopiert und dort geändert.</translation>
    </message>
    <message>
        <source>shipped case</source>
        <translation>mitgelieferter Fall</translation>
    </message>
    <message>
        <source>shipped case, not saved</source>
        <translation>mitgelieferter Fall, nicht gespeichert</translation>
        <source>Drag, arrows</source>
        <translation>Ziehen, Pfeile</translation>
    </message>
    <message>
        <source>slide over the skin, with Shift faster</source>
        <translation>über die Haut schieben, mit Umschalt schneller</translation>
    </message>
    <message>
        <source>Shift+wheel, %1</source>
        <translation>Umschalt+Rad, %1</translation>
    </message>
    <message>
        <source>rock, along the image</source>
        <translation>schaukeln, in der Bildebene</translation>
    </message>
    <message>
        <source>Wheel, %1</source>
        <translation>Rad, %1</translation>
    </message>
    <message>
        <source>tilt, out of the image</source>
        <translation>kippen, aus der Bildebene</translation>
    </message>
    <message>
        <source>Ctrl+wheel, %1</source>
        <translation>Strg+Rad, %1</translation>
    </message>
    <message>
        <source>Drag in a zoomed image</source>
        <translation>Ziehen im vergrößerten Bild</translation>
    </message>
    <message>
        <source>move the detail</source>
        <translation>Ausschnitt verschieben</translation>
    </message>
    <message>
        <source>invert left/right, up/down</source>
        <translation>links/rechts, oben/unten spiegeln</translation>
    </message>
    <message>
        <source>Ctrl+right drag</source>
        <translation>Strg+rechts ziehen</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Doppelklick</translation>
    </message>
    <message>
        <source>in a small window: swap body and scan</source>
        <translation>im kleinen Fenster: Körper und Schallbild tauschen</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>number of focal zones</source>
        <translation>Anzahl der Fokuszonen</translation>
    </message>
    <message>
        <source>edge enhancement</source>
        <translation>Kantenanhebung</translation>
    </message>
    <message>
        <source>cases</source>
        <translation>Fälle</translation>
    </message>
    <message>
        <source>open</source>
        <translation>öffnen</translation>
    </message>
    <message>
        <source>save the image</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>scan only</source>
        <translation>nur das Schallbild</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Autor</translation>
    </message>
    <message>
        <source>%1, Alt+click</source>
        <translation>%1, Alt+Klick</translation>
    </message>
    <message>
        <source>nearest, linear, cubic</source>
        <translation>nächste, linear, kubisch</translation>
    </message>
    <message>
        <source>focus model</source>
        <translation>Fokusmodell</translation>
    </message>
    <message>
        <source>performance</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>System language</source>
        <translation>Sprache des Systems</translation>
    </message>
    <message>
        <source>The window speaks the chosen language from the next start on. Close EchoWeave and open it again.</source>
        <translation>Die gewählte Sprache gilt ab dem nächsten Start. EchoWeave schließen und wieder öffnen.</translation>
    </message>
    <message>
        <source>Scan &amp;only</source>
        <translation>&amp;Nur das Schallbild</translation>
    </message>
    <message>
        <source>Number of focal zones</source>
        <translation>Anzahl der Fokuszonen</translation>
    </message>
    <message>
        <source>Next focus model</source>
        <translation>Nächstes Fokusmodell</translation>
    </message>
    <message>
        <source>More edge enhancement</source>
        <translation>Mehr Kantenanhebung</translation>
    </message>
    <message>
        <source>Less edge enhancement</source>
        <translation>Weniger Kantenanhebung</translation>
    </message>
    <message>
        <source>Invert left/right</source>
        <translation>Links/rechts spiegeln</translation>
    </message>
    <message>
        <source>Invert up/down</source>
        <translation>Oben/unten spiegeln</translation>
    </message>
    <message>
        <source>Fast: nearest voxels</source>
        <translation>Schnell: nächste Voxel</translation>
    </message>
    <message>
        <source>Fine: interpolated</source>
        <translation>Fein: interpoliert</translation>
    </message>
    <message>
        <source>&amp;Performance…</source>
        <translation>&amp;Leistung…</translation>
    </message>
    <message>
        <source>This point lies outside the image. Click a point inside the fan.</source>
        <translation>Dieser Punkt liegt außerhalb des Bildes. Einen Punkt im Schallfächer anklicken.</translation>
    </message>
    <message>
        <source>● unsaved changes</source>
        <translation>● nicht gespeichert</translation>
    </message>
    <message>
        <source>Click a point to see the recorded frame it came from</source>
        <translation>Auf einen Punkt klicken, um das aufgenommene Bild zu sehen, aus dem er stammt</translation>
    </message>
    <message>
        <source>Only a volume made here from a recorded sweep knows which frame a point came from</source>
        <translation>Nur ein hier aus einer Aufnahme gemachtes Volumen weiß, aus welchem Bild ein Punkt stammt</translation>
    </message>
    <message>
        <source>Loading thumbnails</source>
        <translation>Vorschaubilder werden geladen</translation>
    </message>
    <message>
        <source>%1   depth %2 cm   gain %3 %</source>
        <translation>%1   Tiefe %2 cm   Verstärkung %3 %</translation>
    </message>
    <message>
        <source>%1   depth %2 cm   gain %3 dB</source>
        <translation>%1   Tiefe %2 cm   Verstärkung %3 dB</translation>
    </message>
    <message>
        <source>   zoom %1</source>
        <translation>   Zoom %1</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
        <source>Click a point of the picture to see the frame it came from</source>
        <translation>Einen Punkt des Bildes anklicken, um das Bild zu sehen, aus dem er stammt</translation>
    </message>
    <message>
        <source>This volume does not say which frame a voxel came from; one that is made here from a sweep does</source>
        <translation>Dieses Volumen sagt nicht, aus welchem Bild ein Voxel stammt; eines, das hier aus einem Schwenk entsteht, sagt es</translation>
    </message>
    <message>
        <source>record, end recording</source>
        <translation>aufzeichnen, Aufzeichnung beenden</translation>
    </message>
    <message>
        <source>mark this moment of a recording</source>
        <translation>diesen Augenblick der Aufzeichnung markieren</translation>
    </message>
    <message>
        <source>The probe is moved for you. Escape takes it back.</source>
        <translation>Der Schallkopf wird geführt. Esc nimmt ihn zurück.</translation>
    </message>
    <message>
        <source>A recording is shown. Close it (Escape) to move the probe yourself.</source>
        <translation>Eine Aufzeichnung wird gezeigt. Die Aufzeichnung schließen (Esc), um den Schallkopf selbst zu bewegen.</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>Auf&amp;zeichnen</translation>
    </message>
    <message>
        <source>Mark this moment</source>
        <translation>Diesen Augenblick markieren</translation>
    </message>
    <message>
        <source>Save recording as…</source>
        <translation>Aufzeichnung speichern unter …</translation>
    </message>
    <message>
        <source>The recording is kept until another one begins. Play it below, or save it (%1).</source>
        <translation>Die Aufzeichnung bleibt, bis eine andere beginnt. Unten abspielen oder speichern (%1).</translation>
    </message>
    <message>
        <source>End &amp;recording</source>
        <translation>Aufzeichnung be&amp;enden</translation>
    </message>
    <message>
        <source>The recording of &apos;%1&apos; is not saved.</source>
        <translation>Die Aufzeichnung von „%1“ ist nicht gespeichert.</translation>
    </message>
    <message>
        <source>Save the recording</source>
        <translation>Aufzeichnung speichern</translation>
    </message>
    <message>
        <source>Sequences of poses (*.seq.mha *.mha)</source>
        <translation>Folgen von Lagen (*.seq.mha *.mha)</translation>
    </message>
    <message>
        <source>%1 is a recording of &apos;%2&apos;. Open what was scanned first, then the recording.</source>
        <translation>%1 ist eine Aufzeichnung von „%2“. Zuerst öffnen, was geschallt wurde, dann die Aufzeichnung.</translation>
    </message>
    <message numerus="yes">
        <source>%1 is open; %n notes say how it was read.</source>
        <translation>
            <numerusform>%1 ist geöffnet; eine Anmerkung sagt, wie gelesen wurde.</numerusform>
            <numerusform>%1 ist geöffnet; %n Anmerkungen sagen, wie gelesen wurde.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Breathing</source>
        <translation>A&amp;tmung</translation>
    </message>
    <message>
        <source>Breathe freely</source>
        <translation>Frei atmen</translation>
    </message>
    <message>
        <source>Breathe in and hold</source>
        <translation>Einatmen und Luft anhalten</translation>
    </message>
    <message>
        <source>Breathe out and hold</source>
        <translation>Ausatmen und Luft anhalten</translation>
    </message>
    <message>
        <source>breathe freely</source>
        <translation>frei atmen</translation>
    </message>
    <message>
        <source>breathe in and hold, breathe out and hold</source>
        <translation>einatmen und anhalten, ausatmen und anhalten</translation>
    </message>
    <message>
        <source>&amp;Cine loop</source>
        <translation>&amp;Cine-Schleife</translation>
    </message>
    <message>
        <source>Play or stop</source>
        <translation>Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>An image back</source>
        <translation>Ein Bild zurück</translation>
    </message>
    <message>
        <source>An image on</source>
        <translation>Ein Bild weiter</translation>
    </message>
    <message>
        <source>Loop from this image</source>
        <translation>Schleife ab diesem Bild</translation>
    </message>
    <message>
        <source>Loop to this image</source>
        <translation>Schleife bis zu diesem Bild</translation>
    </message>
    <message>
        <source>Save clip as…</source>
        <translation>Clip speichern unter…</translation>
    </message>
    <message>
        <source>Save the clip</source>
        <translation>Clip speichern</translation>
    </message>
    <message>
        <source>clip</source>
        <translation>clip</translation>
    </message>
    <message>
        <source>Frozen image</source>
        <translation>Eingefrorenes Bild</translation>
    </message>
    <message>
        <source>Wheel on the scan, arrows, %1</source>
        <translation>Rad über dem Schallbild, Pfeile, %1</translation>
    </message>
    <message>
        <source>an image back, on; with Shift ten</source>
        <translation>ein Bild zurück, weiter; mit Umschalt zehn</translation>
    </message>
    <message>
        <source>first, last image</source>
        <translation>erstes, letztes Bild</translation>
    </message>
    <message>
        <source>play in a loop, stop</source>
        <translation>in einer Schleife abspielen, anhalten</translation>
    </message>
    <message>
        <source>the loop begins, ends with this image</source>
        <translation>Schleife beginnt, endet mit diesem Bild</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Mea&amp;sure</source>
        <translation>Me&amp;ssen</translation>
    </message>
    <message>
        <source>measuring</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Outlines follow edges</source>
        <translation>Umrisse folgen Kanten</translation>
    </message>
    <message>
        <source>Delete all measurements</source>
        <translation>Alle Messungen löschen</translation>
    </message>
    <message>
        <source>distance, poly-line, outline</source>
        <translation>Distanz, Linienzug, Umriss</translation>
    </message>
    <message>
        <source>ellipse, fitted ellipse, angle</source>
        <translation>Ellipse, angepasste Ellipse, Winkel</translation>
    </message>
    <message>
        <source>outlines follow edges</source>
        <translation>Umrisse folgen Kanten</translation>
    </message>
    <message>
        <source>Drag a cross</source>
        <translation>Ein Kreuz ziehen</translation>
    </message>
    <message>
        <source>move a point</source>
        <translation>einen Punkt verschieben</translation>
    </message>
    <message>
        <source>Arrows, %1</source>
        <translation>Pfeile, %1</translation>
    </message>
    <message>
        <source>move the cross, set a point; with Ctrl by a pixel</source>
        <translation>Kreuz bewegen, Punkt setzen; mit Strg um ein Pixel</translation>
    </message>
    <message>
        <source>take back, put the tool down</source>
        <translation>zurücknehmen, Werkzeug weglegen</translation>
    </message>
    <message>
        <source>delete all measurements</source>
        <translation>alle Messungen löschen</translation>
    </message>
    <message>
        <source>&amp;Worksheet…</source>
        <translation>&amp;Arbeitsblatt…</translation>
    </message>
    <message>
        <source>Choose a worksheet on the page of measurements first.</source>
        <translation>Zuerst auf der Seite der Messungen ein Arbeitsblatt wählen.</translation>
    </message>
    <message>
        <source>Save the worksheet</source>
        <translation>Arbeitsblatt speichern</translation>
    </message>
    <message>
        <source>Worksheets (*.pdf *.csv *.json)</source>
        <translation>Arbeitsblätter (*.pdf *.csv *.json)</translation>
    </message>
    <message>
        <source>The worksheet '%1' is not saved.</source>
        <translation>Das Arbeitsblatt '%1' ist nicht gespeichert.</translation>
    </message>
    <message>
        <source>&amp;Annotate</source>
        <translation>&amp;Beschriften</translation>
    </message>
    <message>
        <source>Body mar&amp;k</source>
        <translation>&amp;Körpersymbol</translation>
    </message>
    <message>
        <source>Prese&amp;ts</source>
        <translation>&amp;Voreinstellungen</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Arrow</source>
        <translation>Pfeil</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>Wörter</translation>
    </message>
    <message>
        <source>Home position here</source>
        <translation>Ausgangsstelle hier</translation>
    </message>
    <message>
        <source>Delete all texts and arrows</source>
        <translation>Alle Texte und Pfeile löschen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a word and what it means</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Show the body mark</source>
        <translation>Körpersymbol zeigen</translation>
    </message>
    <message>
        <source>Follow the probe again</source>
        <translation>Wieder dem Schallkopf folgen</translation>
    </message>
    <message>
        <source>Where the probe is</source>
        <translation>Wo der Schallkopf ist</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>a body mark and its variant</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>a preset and its probe</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Save as preset…</source>
        <translation>Als Voreinstellung speichern…</translation>
    </message>
    <message>
        <source>Save as preset</source>
        <translation>Als Voreinstellung speichern</translation>
    </message>
    <message>
        <source>Name of the examination:</source>
        <translation>Name der Untersuchung:</translation>
    </message>
    <message>
        <source>Saved to %1. Give this file to others who want the same.</source>
        <translation>Gespeichert unter %1. Geben Sie diese Datei weiter, wenn andere dasselbe wollen.</translation>
    </message>
    <message>
        <source>Take over a preset file…</source>
        <translation>Datei einer Voreinstellung übernehmen…</translation>
    </message>
    <message>
        <source>Take over a preset file</source>
        <translation>Datei einer Voreinstellung übernehmen</translation>
    </message>
    <message>
        <source>Presets (*.json)</source>
        <translation>Voreinstellungen (*.json)</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is now among your presets.</source>
        <translation>&apos;%1&apos; gehört jetzt zu Ihren Voreinstellungen.</translation>
    </message>
    <message>
        <source>writing on the image</source>
        <translation>Beschriften</translation>
    </message>
    <message>
        <source>Annotate</source>
        <translation>Beschriften</translation>
    </message>
    <message>
        <source>Frozen: %1</source>
        <translation>Eingefroren: %1</translation>
    </message>
    <message>
        <source>write, with words of the region</source>
        <translation>schreiben, mit Wörtern der Region</translation>
    </message>
    <message>
        <source>freeze and write, draw an arrow</source>
        <translation>einfrieren und schreiben, einen Pfeil zeichnen</translation>
    </message>
    <message>
        <source>first word offered, home position</source>
        <translation>erstes angebotenes Wort, Ausgangsstelle</translation>
    </message>
    <message>
        <source>Drag, double click</source>
        <translation>Ziehen, Doppelklick</translation>
    </message>
    <message>
        <source>move, write anew</source>
        <translation>verschieben, neu schreiben</translation>
    </message>
    <message>
        <source>delete what is chosen, its last word</source>
        <translation>Gewähltes löschen, sein letztes Wort</translation>
    </message>
    <message>
        <source>body mark</source>
        <translation>Körpersymbol</translation>
    </message>
    <message>
        <source>Images (*.png *.mha);;DICOM images (*.dcm)</source>
        <translation>Bilder (*.png *.mha);;DICOM-Bilder (*.dcm)</translation>
    </message>
    <message>
        <source>Worksheets (*.pdf *.csv *.json);;DICOM reports (*.dcm)</source>
        <translation>Arbeitsblätter (*.pdf *.csv *.json);;DICOM-Befunde (*.dcm)</translation>
    </message>
    <message>
        <source>Waiting in the outbox, sent with what comes next: %1.</source>
        <translation>Im Postausgang warten, gesendet mit dem Nächsten: %1.</translation>
    </message>
    <message>
        <source>Refused by the archive, and offered to it again: %1 (%2).</source>
        <translation>Vom Archiv abgelehnt und ihm erneut angeboten: %1 (%2).</translation>
    </message>
    <message>
        <source>S&amp;tore image</source>
        <translation>Bild &amp;ablegen</translation>
    </message>
    <message>
        <source>&amp;Examination and archive…</source>
        <translation>&amp;Untersuchung und Archiv…</translation>
    </message>
    <message>
        <source>Image %1 is stored.</source>
        <translation>Bild %1 ist abgelegt.</translation>
    </message>
    <message>
        <source>Folder in which the examination gets a folder of its own</source>
        <translation>Ordner, in dem die Untersuchung einen eigenen Ordner bekommt</translation>
    </message>
    <message>
        <source>Saving the examination</source>
        <translation>Die Untersuchung wird gespeichert</translation>
    </message>
    <message>
        <source>Sending to %1</source>
        <translation>Wird an %1 gesendet</translation>
    </message>
    <message>
        <source>The archive %1 has everything already.</source>
        <translation>Das Archiv %1 hat schon alles.</translation>
    </message>
    <message>
        <source>The archive %1 has everything now; new to it: %2.</source>
        <translation>Das Archiv %1 hat jetzt alles; neu dort: %2.</translation>
    </message>
    <message>
        <source>Not in the archive yet, but safe in the outbox: %1. %2</source>
        <translation>Noch nicht im Archiv, aber sicher im Postausgang: %1. %2</translation>
    </message>
    <message>
        <source>Stored images that were neither saved nor sent: %1.</source>
        <translation>Abgelegte Bilder, die weder gespeichert noch gesendet sind: %1.</translation>
    </message>
    <message>
        <source>Scan to look at again (*.seq.mha);;Films (*.mp4 *.avi);;DICOM clips (*.dcm)</source>
        <translation>Scan zum Wiederansehen (*.seq.mha);;Filme (*.mp4 *.avi);;DICOM-Clips (*.dcm)</translation>
    </message>
    <message>
        <source>%1, %2 cm, %3</source>
        <comment>probe, depth and time of a stored image</comment>
        <translation>%1, %2 cm, %3</translation>
    </message>
    <message>
        <source>Points snap</source>
        <translation>Punkte rasten ein</translation>
    </message>
    <message>
        <source>&amp;Combine measurements…</source>
        <translation>Messungen &amp;verrechnen…</translation>
    </message>
    <message>
        <source>&amp;Save measurements…</source>
        <translation>Messungen &amp;sichern…</translation>
    </message>
    <message>
        <source>Measure something first: a result is computed from measurements.</source>
        <translation>Erst etwas messen: ein Ergebnis wird aus Messungen berechnet.</translation>
    </message>
    <message>
        <source>Nothing is measured yet that could be saved.</source>
        <translation>Noch ist nichts gemessen, das gesichert werden könnte.</translation>
    </message>
    <message>
        <source>Save the measurements</source>
        <translation>Messungen sichern</translation>
    </message>
    <message>
        <source>measurements</source>
        <translation>messungen</translation>
    </message>
    <message>
        <source>Measurements (*.csv *.json)</source>
        <translation>Messungen (*.csv *.json)</translation>
    </message>
    <message>
        <source>volume by discs</source>
        <translation>Volumen aus Scheiben</translation>
    </message>
    <message>
        <source>time, heart rate in the strip of the M-mode</source>
        <translation>Zeit, Herzfrequenz im Streifen des M-Mode</translation>
    </message>
    <message>
        <source>slope, depth in the strip</source>
        <translation>Steigung, Tiefe im Streifen</translation>
    </message>
    <message>
        <source>points snap; hold Ctrl to do the opposite once</source>
        <translation>Punkte rasten ein; mit Strg einmal das Gegenteil</translation>
    </message>
    <message>
        <source>combine: ratio, stenosis, volume</source>
        <translation>verrechnen: Verhältnis, Stenose, Volumen</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Undo: %1 (%2)</source>
        <translation>Rückgängig: %1 (%2)</translation>
    </message>
    <message>
        <source>The strip of the M-mode shows one beam over time, no place in an image. Switch to B or B + M, then click a point of the image.</source>
        <translation>Der Streifen des M-Modus zeigt einen Strahl über die Zeit, keinen Ort in einem Bild. Auf B oder B + M umschalten, dann einen Punkt des Bildes anklicken.</translation>
    </message>
    <message>
        <source>The image is frozen, and the probe with it. Let it run (%1): then both move again.</source>
        <translation>Das Bild steht, und mit ihm die Sonde. Lassen Sie es laufen (%1): dann bewegen sich beide wieder.</translation>
    </message>
    <message>
        <source>The image is frozen: its echoes were made with these settings. Let it run (%1), then change them.</source>
        <translation>Das Bild steht: Seine Echos entstanden mit diesen Einstellungen. Lassen Sie es laufen (%1), dann ändern Sie sie.</translation>
    </message>
    <message>
        <source>Calipers, and what they measured (%1)</source>
        <translation>Messpunkte, und was sie gemessen haben (%1)</translation>
    </message>
    <message>
        <source>while the image runs</source>
        <translation>während das Bild läuft</translation>
    </message>
    <message>
        <source>on a frozen image</source>
        <translation>auf stehendem Bild</translation>
    </message>
    <message>
        <source>with a tool in the hand</source>
        <translation>mit Werkzeug in der Hand</translation>
    </message>
    <message>
        <source>with a text or an arrow chosen</source>
        <translation>wenn Text oder Pfeil gewählt ist</translation>
    </message>
    <message>
        <source>while writing</source>
        <translation>beim Schreiben</translation>
    </message>
    <message>
        <source>everywhere</source>
        <translation>überall</translation>
    </message>
    <message>
        <source>Drag, %1</source>
        <translation>Ziehen, %1</translation>
    </message>
    <message>
        <source>Console</source>
        <translation>Konsole</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Kippen</translation>
    </message>
    <message>
        <source>Rock</source>
        <translation>Schaukeln</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Slide along the image</source>
        <translation>Längs des Bildes schieben</translation>
    </message>
    <message>
        <source>Slide across the image</source>
        <translation>Quer zum Bild schieben</translation>
    </message>
    <message>
        <source>Image of the cine loop</source>
        <translation>Bild der Schleife</translation>
    </message>
    <message>
        <source>The usual keys act meanwhile. The file stays as it is: as soon as you change a key, it is put aside and a new one is begun.</source>
        <translation>Solange wirken die üblichen Tasten. Die Datei bleibt, wie sie ist: Sobald Sie eine Taste ändern, wird sie beiseitegelegt und eine neue begonnen.</translation>
    </message>
    <message>
        <source>The file %1 cannot be put aside, so your keys are not kept.</source>
        <translation>Die Datei %1 lässt sich nicht beiseitelegen, darum werden Ihre Tasten nicht behalten.</translation>
    </message>
    <message>
        <source>What could not be read is now in %1.</source>
        <translation>Was nicht zu lesen war, liegt jetzt in %1.</translation>
    </message>
    <message>
        <source>Text, on a frozen image</source>
        <translation>Text, auf stehendem Bild</translation>
    </message>
    <message>
        <source>Show the volume that was made</source>
        <translation>Gemachtes Volumen zeigen</translation>
    </message>
    <message>
        <source>Keys and &amp;controls…</source>
        <translation>Tasten und &amp;Regler…</translation>
    </message>
    <message>
        <source>Slide to the left</source>
        <translation>Nach links schieben</translation>
    </message>
    <message>
        <source>Slide to the right</source>
        <translation>Nach rechts schieben</translation>
    </message>
    <message>
        <source>Slide up</source>
        <translation>Nach oben schieben</translation>
    </message>
    <message>
        <source>Slide down</source>
        <translation>Nach unten schieben</translation>
    </message>
    <message>
        <source>Rotate to the left</source>
        <translation>Nach links drehen</translation>
    </message>
    <message>
        <source>Rotate to the right</source>
        <translation>Nach rechts drehen</translation>
    </message>
    <message>
        <source>Rock to the left</source>
        <translation>Nach links schaukeln</translation>
    </message>
    <message>
        <source>Rock to the right</source>
        <translation>Nach rechts schaukeln</translation>
    </message>
    <message>
        <source>Tilt forward</source>
        <translation>Nach vorn kippen</translation>
    </message>
    <message>
        <source>Tilt back</source>
        <translation>Nach hinten kippen</translation>
    </message>
    <message>
        <source>Back to the start</source>
        <translation>Zurück zum Anfang</translation>
    </message>
    <message>
        <source>Images back</source>
        <translation>Bilder zurück</translation>
    </message>
    <message>
        <source>Images on</source>
        <translation>Bilder weiter</translation>
    </message>
    <message>
        <source>First image</source>
        <translation>Erstes Bild</translation>
    </message>
    <message>
        <source>Last image</source>
        <translation>Letztes Bild</translation>
    </message>
    <message>
        <source>Cross to the left</source>
        <translation>Kreuz nach links</translation>
    </message>
    <message>
        <source>Cross to the right</source>
        <translation>Kreuz nach rechts</translation>
    </message>
    <message>
        <source>Cross up</source>
        <translation>Kreuz nach oben</translation>
    </message>
    <message>
        <source>Cross down</source>
        <translation>Kreuz nach unten</translation>
    </message>
    <message>
        <source>Set a point</source>
        <translation>Punkt setzen</translation>
    </message>
    <message>
        <source>Take a point back</source>
        <translation>Punkt zurücknehmen</translation>
    </message>
    <message>
        <source>Delete the chosen text or arrow</source>
        <translation>Gewählten Text oder Pfeil löschen</translation>
    </message>
    <message>
        <source>Delete the last word of the chosen text</source>
        <translation>Letztes Wort des gewählten Textes löschen</translation>
    </message>
    <message>
        <source>End the text</source>
        <translation>Text beenden</translation>
    </message>
    <message>
        <source>Take the first word offered</source>
        <translation>Erstes angebotenes Wort nehmen</translation>
    </message>
    <message>
        <source>To the home position</source>
        <translation>Zur Grundstellung</translation>
    </message>
    <message>
        <source>Put the tool down, close, go back</source>
        <translation>Werkzeug weglegen, schließen, zurück</translation>
    </message>
    <message>
        <source>store the image, images and archive</source>
        <translation>das Bild ablegen, Bilder und Archiv</translation>
    </message>
    <message>
        <source>Magnify a box</source>
        <translation>Ausschnitt vergrößern</translation>
    </message>
    <message>
        <source>Show the whole image</source>
        <translation>Ganzes Bild zeigen</translation>
    </message>
    <message>
        <source>&amp;Wide image</source>
        <translation>Pa&amp;noramabild</translation>
    </message>
    <message>
        <source>The wide image is frozen, and made of images that are done: it can be magnified, measured and saved. %1 ends it.</source>
        <translation>Das Panoramabild ist eingefroren und aus fertigen Bildern gewebt: Es lässt sich vergrößern, messen und speichern. %1 beendet es.</translation>
    </message>
    <message>
        <source>The image is frozen, and this needs new echoes: %1 lets it run. Grey map, dynamic range, zoom and inversion can be changed now.</source>
        <translation>Das Bild ist eingefroren, und dies braucht neue Echos: %1 lässt es laufen. Graukurve, Dynamikbereich, Vergrößerung und Spiegelung lassen sich jetzt ändern.</translation>
    </message>
    <message>
        <source>A place in a wide image was seen by many images. Close it (%1), then click a point of one image.</source>
        <translation>Eine Stelle im Panoramabild haben viele Bilder gesehen. Es schließen (%1), dann auf einen Punkt eines einzelnen Bildes klicken.</translation>
    </message>
    <message>
        <source>magnify a box</source>
        <translation>Ausschnitt vergrößern</translation>
    </message>
    <message>
        <source>the whole image</source>
        <translation>ganzes Bild</translation>
    </message>
    <message>
        <source>wide image: begin, give up, hide</source>
        <translation>Panoramabild: beginnen, verwerfen, verbergen</translation>
    </message>
    <message>
        <source>P&amp;ictures</source>
        <translation>B&amp;ilder</translation>
    </message>
    <message>
        <source>One picture</source>
        <translation>Ein Bild</translation>
    </message>
    <message>
        <source>Two pictures</source>
        <translation>Zwei Bilder</translation>
    </message>
    <message>
        <source>Four pictures</source>
        <translation>Vier Bilder</translation>
    </message>
    <message>
        <source>Next number of pictures</source>
        <translation>Nächste Zahl von Bildern</translation>
    </message>
    <message>
        <source>Next picture</source>
        <translation>Nächstes Bild</translation>
    </message>
    <message>
        <source>Same scale</source>
        <translation>Gleicher Maßstab</translation>
    </message>
    <message>
        <source>A recording runs, and it is of one picture. End it (%1) to go to another.</source>
        <translation>Eine Aufnahme läuft, und zwar von einem Bild. Beenden Sie sie (%1), um zu einem anderen zu gehen.</translation>
    </message>
    <message>
        <source>This picture shows the patient&apos;s left side.</source>
        <translation>Dieses Bild zeigt die linke Seite des Patienten.</translation>
    </message>
    <message>
        <source>This picture shows the patient&apos;s right side.</source>
        <translation>Dieses Bild zeigt die rechte Seite des Patienten.</translation>
    </message>
    <message>
        <source>one, two, four pictures</source>
        <translation>ein, zwei, vier Bilder</translation>
    </message>
    <message>
        <source>Click, %1</source>
        <translation>Klick, %1</translation>
    </message>
    <message>
        <source>take another picture in hand, the next one</source>
        <translation>ein anderes Bild in die Hand nehmen, das nächste</translation>
    </message>
    <message>
        <source>A wide image is at work. Close it (%1) to go to another picture.</source>
        <translation>Ein Panoramabild ist in Arbeit. Schließen Sie es (%1), um zu einem anderen Bild zu gehen.</translation>
    </message>
    <message>
        <source>This volume does not say which frame a voxel came from. A volume that is made here from a recorded sweep does: open the sweep (%1), leave &apos;Record source frame per voxel&apos; switched on, and reconstruct it.</source>
        <translation>Dieses Volumen sagt nicht, aus welchem Bild ein Voxel stammt. Ein Volumen, das hier aus einem aufgenommenen Schwenk gemacht wird, sagt es: den Schwenk öffnen (%1), „Quellbild je Voxel festhalten“ eingeschaltet lassen und das Volumen machen.</translation>
    </message>
    <message>
        <source>Sea&amp;rch the cases</source>
        <translation>Fälle &amp;suchen</translation>
    </message>
    <message>
        <source>Point at a structure</source>
        <translation>Auf eine Struktur zeigen</translation>
    </message>
    <message>
        <source>Handles: move to the left</source>
        <translation>Griffe: nach links schieben</translation>
    </message>
    <message>
        <source>Handles: move to the right</source>
        <translation>Griffe: nach rechts schieben</translation>
    </message>
    <message>
        <source>Handles: move up</source>
        <translation>Griffe: nach oben schieben</translation>
    </message>
    <message>
        <source>Handles: move down</source>
        <translation>Griffe: nach unten schieben</translation>
    </message>
    <message>
        <source>Handles: move nearer</source>
        <translation>Griffe: heranholen</translation>
    </message>
    <message>
        <source>Handles: move away</source>
        <translation>Griffe: wegschieben</translation>
    </message>
    <message>
        <source>Handles: turn to the left</source>
        <translation>Griffe: nach links drehen</translation>
    </message>
    <message>
        <source>Handles: turn to the right</source>
        <translation>Griffe: nach rechts drehen</translation>
    </message>
    <message>
        <source>Handles: turn up</source>
        <translation>Griffe: nach oben drehen</translation>
    </message>
    <message>
        <source>Handles: turn down</source>
        <translation>Griffe: nach unten drehen</translation>
    </message>
    <message>
        <source>Handles: turn anticlockwise</source>
        <translation>Griffe: gegen den Uhrzeigersinn drehen</translation>
    </message>
    <message>
        <source>Handles: turn clockwise</source>
        <translation>Griffe: im Uhrzeigersinn drehen</translation>
    </message>
    <message>
        <source>in the 3D view, with handles</source>
        <translation>in der 3D-Ansicht, mit Griffen</translation>
    </message>
    <message>
        <source>Te&amp;xt size</source>
        <translation>Te&amp;xtgröße</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>&amp;Larger text</source>
        <translation>&amp;Größerer Text</translation>
    </message>
    <message>
        <source>&amp;Smaller text</source>
        <translation>&amp;Kleinerer Text</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Rundgang</translation>
    </message>
    <message>
        <source>The probe on the body</source>
        <translation>Der Schallkopf am Körper</translation>
    </message>
    <message>
        <source>Drag the body&apos;s skin and the probe slides there. The wheel tilts it, with Shift it rocks, with Ctrl it rotates. The arrow keys do the same.</source>
        <translation>Auf der Haut ziehen: der Schallkopf gleitet dorthin. Das Rad kippt ihn, mit Umschalt wird er geschaukelt, mit Strg gedreht. Die Pfeiltasten bewegen ihn ebenso.</translation>
    </message>
    <message>
        <source>The scan</source>
        <translation>Das Ultraschallbild</translation>
    </message>
    <message>
        <source>What the probe sees, as on a machine: the marker&apos;s dot shows which side is which, the scale how deep it is, and the sliders at the left set the gain for each depth.</source>
        <translation>Was der Schallkopf sieht, wie am Gerät: der Punkt zeigt, welche Seite welche ist, die Skala die Tiefe, und die Schieber links stellen die Verstärkung für jede Tiefe ein.</translation>
    </message>
    <message>
        <source>The console</source>
        <translation>Das Bedienfeld</translation>
    </message>
    <message>
        <source>Gain, depth, focus, transducer and what the machine does to the sound. Every control says in a tip which key it has; %1 lists them all.</source>
        <translation>Verstärkung, Tiefe, Fokus, Schallkopf und was das Gerät mit dem Schall macht. Jedes Element nennt in einem Hinweis seine Taste; %1 zeigt alle.</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>A case may bring lessons: find a plane, measure, answer. They are led through here, step by step.</source>
        <translation>Ein Fall kann Lektionen mitbringen: eine Ebene finden, messen, antworten. Hier führen sie Schritt für Schritt hindurch.</translation>
    </message>
    <message>
        <source>The cases</source>
        <translation>Die Fälle</translation>
    </message>
    <message>
        <source>Each card is a patient. Click one, or choose it with the arrows and open it with Enter; the line on a card shows how far its lessons are done.</source>
        <translation>Jede Karte ist ein Patient. Eine anklicken oder mit den Pfeilen wählen und mit der Eingabetaste öffnen; die Linie auf der Karte zeigt, wie weit ihre Lektionen erledigt sind.</translation>
    </message>
    <message>
        <source>The search</source>
        <translation>Die Suche</translation>
    </message>
    <message>
        <source>Type what is looked for: a region, a lesson, a tag. Below, filters leave only one origin, region or level.</source>
        <translation>Eintippen, was gesucht wird: eine Region, eine Lektion, ein Schlagwort. Darunter lassen Filter nur eine Herkunft, Region oder Stufe übrig.</translation>
    </message>
    <message>
        <source>The course</source>
        <translation>Der Kurs</translation>
    </message>
    <message>
        <source>Lessons in the order in which they build on each other, and the one that comes next for you.</source>
        <translation>Lektionen in der Reihenfolge, in der sie aufeinander aufbauen, und die, die als Nächste dran ist.</translation>
    </message>
    <message>
        <source>Here cases and their lessons are made, and volumes from sweeps. The keys %1 and %2 lead back and here again.</source>
        <translation>Hier entstehen Fälle und ihre Lektionen und Volumen aus Aufnahmen. Die Tasten %1 und %2 führen zurück und wieder hierher.</translation>
    </message>
    <message>
        <source>Making cases</source>
        <translation>Fälle gestalten</translation>
    </message>
    <message>
        <source>Published cases are not edited in place, for attempts of trainees refer to them. Save &apos;%1&apos; as a case of your own.</source>
        <translation>Veröffentlichte Fälle werden nicht an Ort und Stelle bearbeitet, denn Versuche von Lernenden beziehen sich auf sie. „%1“ als eigenen Fall speichern.</translation>
    </message>
    <message>
        <source>published case</source>
        <translation>veröffentlichter Fall</translation>
    </message>
    <message>
        <source>edited by somebody else</source>
        <translation>von jemand anderem bearbeitet</translation>
    </message>
    <message>
        <source>This case has no volume yet. Choose &apos;Give the case a volume…&apos; in the Case panel.</source>
        <translation>Dieser Fall hat noch kein Volumen. Unter Fall „Dem Fall ein Volumen geben…“ wählen.</translation>
    </message>
    <message>
        <source>This case has no volume yet, so there is nothing to scan. An author gives it one in Author.</source>
        <translation>Dieser Fall hat noch kein Volumen, also gibt es nichts zu schallen. Unter Gestalten lässt sich eines geben.</translation>
    </message>
    <message>
        <source>&amp;Import a case bundle…</source>
        <translation>Fallpaket &amp;importieren…</translation>
    </message>
    <message>
        <source>Import a case bundle</source>
        <translation>Fallpaket importieren</translation>
    </message>
    <message>
        <source>Case bundles (*.ewcase)</source>
        <translation>Fallpakete (*.ewcase)</translation>
    </message>
    <message>
        <source>Importing %1</source>
        <translation>%1 wird importiert</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is in the library already, as revision %2.</source>
        <translation>„%1“ ist schon in der Bibliothek, als Fassung %2.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was taken into the library as revision %2.</source>
        <translation>„%1“ wurde als Fassung %2 in die Bibliothek übernommen.</translation>
    </message>
    <message>
        <source>Lock for trainees…</source>
        <translation>Für Lernende sperren…</translation>
    </message>
    <message>
        <source>Unlock for instructors…</source>
        <translation>Für Lehrkräfte entsperren…</translation>
    </message>
    <message>
        <source>Take the lock away</source>
        <translation>Sperre entfernen</translation>
    </message>
    <message>
        <source>Lock again</source>
        <translation>Wieder sperren</translation>
    </message>
    <message>
        <source>The lock is gone: everybody at this account sees everything.</source>
        <translation>Die Sperre ist fort: Alle an diesem Konto sehen alles.</translation>
    </message>
    <message>
        <source>Lock for trainees</source>
        <translation>Für Lernende sperren</translation>
    </message>
    <message>
        <source>Until this passphrase is given again the window shows Explore alone: no Author, no answers, nobody else&apos;s attempts. The lock does not stop who reads this account&apos;s files with other programs: for examinations export cases with sealed answers.</source>
        <translation>Bis dieses Kennwort wieder eingegeben wird, zeigt das Fenster nur Erkunden: keinen Autor, keine Antworten, keine Versuche anderer. Wer die Dateien dieses Kontos mit anderen Programmen liest, wird nicht aufgehalten: für Prüfungen Fälle mit versiegelten Antworten exportieren.</translation>
    </message>
    <message>
        <source>Locked for trainees.</source>
        <translation>Für Lernende gesperrt.</translation>
    </message>
    <message>
        <source>Unlock for instructors</source>
        <translation>Für Lehrkräfte entsperren</translation>
    </message>
    <message>
        <source>The passphrase that locked this library for trainees.</source>
        <translation>Das Kennwort, mit dem diese Bibliothek für Lernende gesperrt wurde.</translation>
    </message>
    <message>
        <source>Unlocked until you lock it again or close the window.</source>
        <translation>Entsperrt, bis wieder gesperrt oder das Fenster geschlossen wird.</translation>
    </message>
</context>
<context>
    <name>ew::ui::MeasurePage</name>
    <message>
        <source>Nothing is measured yet. Choose a tool: the image freezes, and the first click sets a point.</source>
        <translation>Noch ist nichts gemessen. Ein Werkzeug wählen: Das Bild steht still, und der erste Klick setzt einen Punkt.</translation>
    </message>
    <message>
        <source>Outlines follow edges</source>
        <translation>Umrisse folgen Kanten</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete all</source>
        <translation>Alle löschen</translation>
    </message>
    <message>
        <source>has left the strip</source>
        <translation>hat den Streifen verlassen</translation>
    </message>
    <message>
        <source>Points snap</source>
        <translation>Punkte rasten ein</translation>
    </message>
    <message>
        <source>To crosses, edges, and level or plumb with the point before; a mark and a word show it before the click (%1). Hold Ctrl to do the opposite once</source>
        <translation>An Kreuzen, Kanten und waagerecht oder senkrecht zum Punkt davor; ein Zeichen und ein Wort zeigen es vor dem Klick (%1). Mit Strg einmal das Gegenteil</translation>
    </message>
    <message>
        <source>A few clicks around it are enough: the outline is brought to the edge (%1)</source>
        <translation>Wenige Klicks ringsum genügen: Der Umriss wird an die Kante gebracht (%1)</translation>
    </message>
    <message>
        <source>Undo (%1)</source>
        <translation>Rückgängig (%1)</translation>
    </message>
    <message>
        <source>Redo (%1)</source>
        <translation>Wiederholen (%1)</translation>
    </message>
    <message>
        <source>Delete the chosen measurement, or else the last one (%1)</source>
        <translation>Die gewählte Messung löschen, sonst die letzte (%1)</translation>
    </message>
    <message>
        <source>Delete all measurements (%1)</source>
        <translation>Alle Messungen löschen (%1)</translation>
    </message>
    <message>
        <source>Picture %1</source>
        <translation>Bild %1</translation>
    </message>
    <message>
        <source>Picture %1: %2</source>
        <translation>Bild %1: %2</translation>
    </message>
    <message>
        <source>Measured on another picture; a click takes that one in hand</source>
        <translation>In einem anderen Bild gemessen; ein Klick nimmt jenes in die Hand</translation>
    </message>
</context>
<context>
    <name>ew::ui::MessageBar</name>
    <message>
        <source>Dismiss (Esc)</source>
        <translation>Schließen (Esc)</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Schließen</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>%n weitere</numerusform>
            <numerusform>%n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
</context>
<context>
    <name>ew::ui::Opener</name>
    <message>
        <source>Preparing live echoes</source>
        <translation>Lebendige Echos werden vorbereitet</translation>
    </message>
    <message>
        <source>Preparing the mannequin</source>
        <translation>Der Übungskörper wird vorbereitet</translation>
    </message>
    <message>
        <source>There is no file or folder &apos;%1&apos;; check the name, or choose it with Open.</source>
        <translation>Es gibt keine Datei und keinen Ordner „%1“; den Namen prüfen oder mit Öffnen wählen.</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message numerus="yes">
        <source>The mannequin was read; %n notes say how.</source>
        <translation>
            <numerusform>Der Übungskörper wurde gelesen; eine Anmerkung sagt, wie.</numerusform>
            <numerusform>Der Übungskörper wurde gelesen; %n Anmerkungen sagen, wie.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 is open; %n notes say how it was read.</source>
        <translation>
            <numerusform>%1 ist geöffnet; eine Anmerkung sagt, wie gelesen wurde.</numerusform>
            <numerusform>%1 ist geöffnet; %n Anmerkungen sagen, wie gelesen wurde.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::ui::PluginsDialog</name>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>found</source>
        <translation>gefunden</translation>
    </message>
    <message>
        <source>not loaded</source>
        <translation>nicht geladen</translation>
    </message>
    <message>
        <source>Plugins</source>
        <translation>Erweiterungen</translation>
    </message>
    <message>
        <source>There are no plugin folders. Put a plugin&apos;s folder into lib/plugins beside the program, or name a folder in ECHOWEAVE_PLUGINS, and start again.</source>
        <translation>Es gibt keine Ordner für Erweiterungen. Den Ordner einer Erweiterung in lib/plugins neben dem Programm ablegen oder einen Ordner in ECHOWEAVE_PLUGINS nennen und neu starten.</translation>
    </message>
    <message>
        <source>No plugins were found in %1. Put a plugin&apos;s folder there and start again.</source>
        <translation>In %1 wurden keine Erweiterungen gefunden. Dort den Ordner einer Erweiterung ablegen und neu starten.</translation>
    </message>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>ew::ui::SaveFile</name>
    <message>
        <source>There is a file &apos;%1&apos; already. It would be replaced.</source>
        <translation>Es gibt schon eine Datei „%1“. Sie würde ersetzt.</translation>
    </message>
    <message>
        <source>These files are there already and would be replaced: %1.</source>
        <translation>Diese Dateien gibt es schon, sie würden ersetzt: %1.</translation>
    </message>
    <message>
        <source>Folder: %1</source>
        <translation>Ordner: %1</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Another name…</source>
        <translation>Anderer Name…</translation>
    </message>
</context>
<context>
    <name>ew::ui::SavingDialog</name>
    <message>
        <source>Saving</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Not everything is saved yet</source>
        <translation>Noch ist nicht alles gespeichert</translation>
    </message>
    <message>
        <source>The window closes as soon as it is. Closing now loses it.</source>
        <translation>Das Fenster schließt, sobald es gespeichert ist. Wer jetzt schließt, verliert es.</translation>
    </message>
    <message>
        <source>It goes on as soon as it is.</source>
        <translation>Danach geht es weiter.</translation>
    </message>
    <message>
        <source>Close and lose it</source>
        <translation>Schließen und verlieren</translation>
    </message>
    <message>
        <source>Do not close</source>
        <translation>Nicht schließen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>ew::ui::ScanView</name>
    <message>
        <source>Scan</source>
        <translation>Schallbild</translation>
    </message>
    <message>
        <source>Nothing recorded here</source>
        <translation>Hier ist nichts aufgenommen</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>Frozen</source>
        <translation>Eingefroren</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>The probe is outside the volume.</source>
        <translation>Die Sonde ist außerhalb des Volumens.</translation>
    </message>
    <message>
        <source>The probe is outside the volume. Slide it back, or press Home for the start.</source>
        <translation>Die Sonde ist außerhalb des Volumens. Zurückschieben oder mit Pos1 zum Anfang.</translation>
    </message>
    <message>
        <source>depth %1 cm   gain %2 %</source>
        <translation>Tiefe %1 cm   Verstärkung %2 %</translation>
    </message>
    <message>
        <source>depth %1 cm   gain %2 dB</source>
        <translation>Tiefe %1 cm   Verstärkung %2 dB</translation>
    </message>
    <message>
        <source>   zoom %1</source>
        <translation>   Zoom %1</translation>
    </message>
    <message>
        <source>drag: move the detail</source>
        <translation>ziehen: Ausschnitt verschieben</translation>
    </message>
    <message>
        <source>drag: slide the probe</source>
        <translation>ziehen: Sonde schieben</translation>
    </message>
    <message>
        <source>wheel: step through what was scanned</source>
        <translation>Rad: durch das Geschallte blättern</translation>
    </message>
    <message>
        <source>Nothing to scan yet. Open a case, a volume or a sweep, or drop one here.</source>
        <translation>Noch nichts zu schallen. Einen Fall, ein Volumen oder einen Schwenk öffnen oder etwas hierher ziehen.</translation>
    </message>
</context>
<context>
    <name>ew::ui::Session</name>
    <message>
        <source>This case does not move: its patient was recorded holding the breath.</source>
        <translation>Dieser Fall bewegt sich nicht: sein Patient wurde mit angehaltenem Atem aufgenommen.</translation>
    </message>
    <message>
        <source>The patient breathes, but the image does not show it: switch live echoes and motion on (Effects).</source>
        <translation>Der Patient atmet, aber das Bild zeigt es nicht: schalten Sie lebendige Echos und Bewegung ein (Effekte).</translation>
    </message>
</context>
<context>
    <name>ew::ui::ShortcutsOverlay</name>
    <message>
        <source>Keys and mouse</source>
        <translation>Tasten und Maus</translation>
    </message>
    <message>
        <source>Close this page (Escape)</source>
        <translation>Diese Seite schließen (Esc)</translation>
    </message>
</context>
<context>
    <name>ew::ui::SourceDialog</name>
    <message>
        <source>Where this comes from</source>
        <translation>Woher das kommt</translation>
    </message>
    <message>
        <source>Source frame</source>
        <translation>Quellbild</translation>
    </message>
    <message>
        <source>Sweep</source>
        <translation>Schwenk</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Voxel</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>The frame before (Left)</source>
        <translation>Das Bild davor (Links)</translation>
    </message>
    <message>
        <source>Back to the frame the voxel came from (Home)</source>
        <translation>Zurück zu dem Bild, aus dem der Voxel stammt (Pos1)</translation>
    </message>
    <message>
        <source>The frame after (Right)</source>
        <translation>Das Bild danach (Rechts)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close (Escape)</source>
        <translation>Schließen (Escape)</translation>
    </message>
    <message>
        <source>This point lies outside the volume. Click a point inside it: the thin box in the 3D view shows where it ends.</source>
        <translation>Dieser Punkt liegt außerhalb des Volumens. Einen Punkt darin anklicken: der dünne Kasten in der 3D-Ansicht zeigt, wo es endet.</translation>
    </message>
    <message>
        <source>Nothing is known here: no frame of the sweep reached this voxel, and it lies too far from the others to be filled in.</source>
        <translation>Hier ist nichts bekannt: kein Bild des Schwenks hat diesen Voxel erreicht, und er liegt zu weit von den anderen, um gefüllt zu werden.</translation>
    </message>
    <message>
        <source>Reading the frames of %1</source>
        <translation>Bilder von %1 werden gelesen</translation>
    </message>
    <message>
        <source>Reading was stopped. Ask again to go on.</source>
        <translation>Das Lesen wurde angehalten. Noch einmal fragen, um fortzufahren.</translation>
    </message>
    <message>
        <source>measured: of all frames that reached it, a pixel of the source frame lies nearest</source>
        <translation>gemessen: von allen Bildern, die ihn erreicht haben, liegt ein Pixel des Quellbildes am nächsten</translation>
    </message>
    <message>
        <source>invented: no pixel fell into it, it was filled from its neighbours, of which the source frame is the nearest</source>
        <translation>erfunden: kein Pixel fiel hinein, er wurde aus der Umgebung gefüllt, von der das Quellbild am nächsten liegt</translation>
    </message>
    <message>
        <source>absent</source>
        <translation>nicht vorhanden</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1, the source</source>
        <translation>%1, die Quelle</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n after the source</source>
        <translation>
            <numerusform>%1, %n nach der Quelle</numerusform>
            <numerusform>%1, %n nach der Quelle</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1, %n before the source</source>
        <translation>
            <numerusform>%1, %n vor der Quelle</numerusform>
            <numerusform>%1, %n vor der Quelle</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>nicht aufgezeichnet</translation>
    </message>
    <message>
        <source>%1 mm from the plane of this frame</source>
        <translation>%1 mm von der Ebene dieses Bildes</translation>
    </message>
    <message>
        <source>Reading the recording…</source>
        <translation>Die Aufnahme wird gelesen…</translation>
    </message>
</context>
<context>
    <name>ew::ui::SourcePicker</name>
    <message>
        <source>Point whose source frame is asked for</source>
        <translation>Punkt, nach dessen Quellbild gefragt wird</translation>
    </message>
    <message>
        <source>Click a point to see the frame it came from. Arrows and Enter do the same, Escape ends.</source>
        <translation>Einen Punkt anklicken, um das Bild zu sehen, aus dem er stammt. Pfeile und Eingabe tun dasselbe, Escape beendet.</translation>
    </message>
</context>
<context>
    <name>ew::ui::StartPage</name>
    <message>
        <source>Cases</source>
        <translation>Fälle</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>A sweep (.igs.mha), a volume (.mha, .mhd, .nrrd, .nii) or a case folder can also be dropped on this window.</source>
        <translation>Ein Schwenk (.igs.mha), ein Volumen (.mha, .mhd, .nrrd, .nii) oder ein Fallordner lässt sich auch auf dieses Fenster ziehen.</translation>
    </message>
    <message>
        <source>There are no cases here yet. Open a case folder, a volume or a sweep to begin.</source>
        <translation>Hier gibt es noch keine Fälle. Zum Anfang einen Fallordner, ein Volumen oder einen Schwenk öffnen.</translation>
    </message>
    <message>
        <source>Back to what is open (Escape)</source>
        <translation>Zurück zu dem, was offen ist (Esc)</translation>
    </message>
    <message>
        <source>A case folder can also be dropped on this window.</source>
        <translation>Ein Fallordner lässt sich auch auf dieses Fenster ziehen.</translation>
    </message>
    <message>
        <source>Back to the scan</source>
        <translation>Zurück zum Schallbild</translation>
    </message>
    <message>
        <source>Back to %1</source>
        <translation>Zurück zu %1</translation>
    </message>
    <message>
        <source>Open a case, a volume or a sweep (%1)</source>
        <translation>Fall, Volumen oder Schwenk öffnen (%1)</translation>
    </message>
    <message>
        <source>Search the cases</source>
        <translation>Fälle suchen</translation>
    </message>
    <message>
        <source>Each word is looked for at the beginning of the words of a case (%1)</source>
        <translation>Jedes Wort wird am Anfang der Wörter eines Falls gesucht (%1)</translation>
    </message>
    <message>
        <source>1 case</source>
        <translation>1 Fall</translation>
    </message>
    <message>
        <source>%1 cases</source>
        <translation>%1 Fälle</translation>
    </message>
    <message>
        <source>No case has all of this. Leave out a word or a filter.</source>
        <translation>Kein Fall hat all das. Ein Wort oder einen Filter weglassen.</translation>
    </message>
    <message>
        <source>Show all cases</source>
        <translation>Alle Fälle zeigen</translation>
    </message>
    <message>
        <source>The cases of the library are being read.</source>
        <translation>Die Fälle der Bibliothek werden gelesen.</translation>
    </message>
    <message>
        <source>Search by title, region, finding, tag…</source>
        <translation>Nach Titel, Region, Befund, Schlagwort suchen…</translation>
    </message>
    <message>
        <source>Search by title, region, lesson, tag…</source>
        <translation>Nach Titel, Region, Lektion, Schlagwort suchen…</translation>
    </message>
</context>
<context>
    <name>ew::ui::StatusLine</name>
    <message>
        <source>contact %1 %</source>
        <translation>Kontakt %1 %</translation>
    </message>
    <message>
        <source>Middle of the transducer&apos;s face: left, back, up from the mannequin&apos;s origin</source>
        <translation>Mitte der Schallkopffläche: links, hinten, oben vom Ursprung des Übungskörpers</translation>
    </message>
    <message>
        <source>How much of the transducer&apos;s face touches skin with something recorded below it</source>
        <translation>Wie viel der Schallkopffläche Haut berührt, unter der etwas aufgenommen ist</translation>
    </message>
    <message>
        <source>plan: %1 = %2 ms</source>
        <translation>Plan: %1 = %2 ms</translation>
    </message>
    <message>
        <source>plan: %1 ms</source>
        <translation>Plan: %1 ms</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>cubic</source>
        <translation>kubisch</translation>
    </message>
    <message>
        <source>The probe moves fast and frames take long: quality falls until it rests (Adaptive, F9)</source>
        <translation>Die Sonde bewegt sich schnell und Bilder dauern lange: Die Qualität sinkt, bis sie ruht (Adaptiv, F9)</translation>
    </message>
    <message numerus="yes">
        <source>plan: %n steps, %1 ms</source>
        <translation>
            <numerusform>Plan: %n Schritt, %1 ms</numerusform>
            <numerusform>Plan: %n Schritte, %1 ms</numerusform>
        </translation>
    </message>
    <message>
        <source>adaptive: %1</source>
        <translation>angepasst: %1</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>What the image runs, ms (median of the last frames)</source>
        <translation>Was das Bild rechnet, ms (Median der letzten Bilder)</translation>
    </message>
    <message>
        <source>estimated</source>
        <translation>geschätzt</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>From the hand to the image, ms; images: %1</source>
        <translation>Von der Hand zum Bild, ms; Bilder: %1</translation>
    </message>
    <message>
        <source>median %1, 95 % %2, 99 % %3, worst %4</source>
        <translation>Median %1, 95 % %2, 99 % %3, längste %4</translation>
    </message>
    <message>
        <source>nearest</source>
        <translation>nächste</translation>
    </message>
</context>
<context>
    <name>ew::ui::TopBar</name>
    <message>
        <source>Explore</source>
        <translation>Erkunden</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Gestalten</translation>
    </message>
    <message>
        <source>simulation, not for diagnosis</source>
        <translation>Simulation, nicht zur Diagnose</translation>
    </message>
    <message>
        <source>Scan the open case (%1)</source>
        <translation>Den offenen Fall schallen (%1)</translation>
    </message>
    <message>
        <source>Edit the case and build volumes (%1)</source>
        <translation>Den Fall bearbeiten und Volumen bauen (%1)</translation>
    </message>
</context>
<context>
    <name>ew::ui::View3D</name>
    <message>
        <source>Overview</source>
        <translation>Übersicht</translation>
    </message>
    <message>
        <source>Look from the front and above, where the fan is seen best</source>
        <translation>Von vorn und oben sehen, wo der Fächer am besten zu sehen ist</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation>Von vorn sehen</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Look from the patient&apos;s right</source>
        <translation>Von der rechten Seite des Patienten sehen</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Look from the patient&apos;s left</source>
        <translation>Von der linken Seite des Patienten sehen</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>Look from the head</source>
        <translation>Vom Kopf her sehen</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ganz</translation>
    </message>
    <message>
        <source>Show the whole volume</source>
        <translation>Das ganze Volumen zeigen</translation>
    </message>
    <message>
        <source>Translucent</source>
        <translation>Durchscheinend</translation>
    </message>
    <message>
        <source>Make the body translucent</source>
        <translation>Den Körper durchscheinend machen</translation>
    </message>
    <message>
        <source>drag: slide on skin   wheel: tilt   Shift: rock   Ctrl: rotate   right drag: look around</source>
        <translation>Ziehen: gleiten   Rad: kippen   Umschalt: schaukeln   Strg: drehen   rechts ziehen: umsehen</translation>
    </message>
    <message>
        <source>Body with probe</source>
        <translation>Körper mit Schallkopf</translation>
    </message>
</context>
<context>
    <name>ew::ui::WorkstationHost</name>
    <message>
        <source>This panel could not be opened; Help, Plugins says more.</source>
        <translation>Dieser Bereich ließ sich nicht öffnen; mehr unter Hilfe, Erweiterungen.</translation>
    </message>
</context>
<context>
    <name>ew::ui::PictureChooser</name>
    <message>
        <source>The image as the file holds it</source>
        <translation>Das Bild, wie es in der Datei steht</translation>
    </message>
    <message>
        <source>No image can be shown yet.</source>
        <translation>Noch kann kein Bild gezeigt werden.</translation>
    </message>
</context>
<context>
    <name>ew::case_authoring::ExaminationsField</name>
    <message>
        <source>Add an examination</source>
        <translation>Untersuchung hinzufügen</translation>
    </message>
    <message>
        <source>when</source>
        <translation>wann</translation>
    </message>
    <message>
        <source>kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>what it said</source>
        <translation>was sie ergab</translation>
    </message>
    <message>
        <source>Add laboratory values</source>
        <translation>Laborwerte hinzufügen</translation>
    </message>
</context>
<context>
    <name>ew::ui::ReplayBar</name>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>Begin again at the end</source>
        <translation>Am Ende von vorn beginnen</translation>
    </message>
    <message>
        <source>Save the recording</source>
        <translation>Aufzeichnung speichern</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern …</translation>
    </message>
    <message>
        <source>Close the recording and scan on (Escape)</source>
        <translation>Aufzeichnung schließen und weiter schallen (Esc)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Pause (%1)</source>
        <translation>Anhalten (%1)</translation>
    </message>
    <message>
        <source>Play (%1)</source>
        <translation>Abspielen (%1)</translation>
    </message>
</context>
<context>
    <name>ew::ui::TimeLine</name>
    <message>
        <source>Time line of the recording</source>
        <translation>Zeitleiste der Aufzeichnung</translation>
    </message>
    <message>
        <source>Click or drag to another moment (arrows: a second, with Shift five; Home and End)</source>
        <translation>Zu einem anderen Augenblick klicken oder ziehen (Pfeile: eine Sekunde, mit Umschalt fünf; Pos1 und Ende)</translation>
    </message>
    <message>
        <source>%1 of %2 s</source>
        <translation>%1 von %2 s</translation>
    </message>
</context>
<context>
    <name>ew::ui::WorksheetDialog</name>
    <message>
        <source>Worksheet</source>
        <translation>Arbeitsblatt</translation>
    </message>
    <message>
        <source>Simulation, training only: not for diagnosis.</source>
        <translation>Simulation, nur zur Ausbildung: nicht zur Diagnose.</translation>
    </message>
    <message>
        <source>Remove a value</source>
        <translation>Einen Wert entfernen</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>As PDF to print, as CSV for tables, as JSON for programs</source>
        <translation>Als PDF zum Drucken, als CSV für Tabellen, als JSON für Programme</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>32w1d</source>
        <translation>32w1d</translation>
    </message>
    <message>
        <source>Weeks and days since the last period: 32w1d. Charts and redating need it.</source>
        <translation>Wochen und Tage seit der letzten Regel: 32w1d. Kurven und Terminkorrektur brauchen es.</translation>
    </message>
    <message>
        <source>Gestational age by dates</source>
        <translation>Schwangerschaftsalter nach Daten</translation>
    </message>
    <message>
        <source>not answered</source>
        <translation>nicht beantwortet</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>an item and its side</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Write weeks and days, as 32w1d, from 0w to 45w.</source>
        <translation>Wochen und Tage schreiben, etwa 32w1d, von 0w bis 45w.</translation>
    </message>
    <message>
        <source>Nothing is entered yet. Choose an item on the page of measurements and measure it in the image.</source>
        <translation>Noch ist nichts eingetragen. Auf der Seite der Messungen einen Punkt wählen und ihn im Bild messen.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>an item and its value</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <comment>an item, its side and its value</comment>
        <translation>%1, %2: %3</translation>
    </message>
</context>
<context>
    <name>ew::ui::WorksheetList</name>
    <message>
        <source>Which worksheet the measurements go to</source>
        <translation>In welches Arbeitsblatt die Messungen eingehen</translation>
    </message>
    <message>
        <source>Worksheet</source>
        <translation>Arbeitsblatt</translation>
    </message>
    <message>
        <source>Show worksheet…</source>
        <translation>Arbeitsblatt zeigen…</translation>
    </message>
    <message>
        <source>No worksheet</source>
        <translation>Kein Arbeitsblatt</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>an item and its side</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1
%2</source>
        <comment>an item, and where its calipers go</comment>
        <translation>%1
%2</translation>
    </message>
    <message>
        <source>Results, usual ranges and charts, answers; save it (%1)</source>
        <translation>Ergebnisse, übliche Bereiche und Kurven, Antworten; sichern (%1)</translation>
    </message>
    <message>
        <source>Measured on picture %1</source>
        <translation>Gemessen in Bild %1</translation>
    </message>
</context>
<context>
    <name>ew::ui::WorksheetWords</name>
    <message>
        <source>Simulation, training only: not for diagnosis.</source>
        <translation>Simulation, nur zur Ausbildung: nicht zur Diagnose.</translation>
    </message>
    <message>
        <source>Gestational age by dates: %1</source>
        <translation>Schwangerschaftsalter nach Daten: %1</translation>
    </message>
    <message>
        <source>usual</source>
        <translation>üblich</translation>
    </message>
    <message>
        <source>low</source>
        <translation>niedrig</translation>
    </message>
    <message>
        <source>high</source>
        <translation>hoch</translation>
    </message>
    <message>
        <source>%1 (usual: %2)</source>
        <comment>verdict and range</comment>
        <translation>%1 (üblich: %2)</translation>
    </message>
    <message>
        <source>%1 (usual in %3: %2)</source>
        <comment>verdict, range and whom it is for</comment>
        <translation>%1 (üblich bei %3: %2)</translation>
    </message>
    <message>
        <source>percentile %1 (%2 to %3), %4</source>
        <comment>percentile, its range, and the chart</comment>
        <translation>Perzentile %1 (%2 bis %3), %4</translation>
    </message>
    <message>
        <source>mean of %1</source>
        <comment>of several values</comment>
        <translation>Mittel aus %1</translation>
    </message>
    <message>
        <source>by %1</source>
        <comment>a formula</comment>
        <translation>nach %1</translation>
    </message>
    <message>
        <source>from %1</source>
        <comment>values</comment>
        <translation>aus %1</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>%1 ± %2 d</source>
        <comment>gestational age and days</comment>
        <translation>%1 ± %2 d</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>what was measured, and its side</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
</context>
<context>
    <name>ew::ui::ExaminationDialog</name>
    <message>
        <source>Examination</source>
        <translation>Untersuchung</translation>
    </message>
    <message>
        <source>Stored images</source>
        <translation>Abgelegte Bilder</translation>
    </message>
    <message>
        <source>No image is stored yet. &apos;Store image&apos; in the menu &apos;File&apos; keeps what the scan shows, with all that is measured and written on it.</source>
        <translation>Noch ist kein Bild gespeichert. „Bild ablegen“ im Menü „Datei“ behält, was der Scan zeigt, mit allem, was darauf gemessen und geschrieben ist.</translation>
    </message>
    <message>
        <source>Remove image</source>
        <translation>Bild entfernen</translation>
    </message>
    <message>
        <source>Every image and report says that it is a simulation and not for diagnosis.</source>
        <translation>Auf jedem Bild und Befund steht, dass er eine Simulation ist und nicht zur Diagnose dient.</translation>
    </message>
    <message>
        <source>Save as DICOM files…</source>
        <translation>Als DICOM-Dateien speichern…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Send to the archive</source>
        <translation>An das Archiv senden</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archiv</translation>
    </message>
    <message>
        <source>name or address of its machine</source>
        <translation>Name oder Adresse seines Rechners</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>as its administrator calls it</source>
        <translation>wie seine Verwaltung es nennt</translation>
    </message>
    <message>
        <source>Application entity title: 1 to 16 letters without blanks</source>
        <translation>Titel der Anwendung (AE Title): 1 bis 16 Zeichen ohne Leerzeichen</translation>
    </message>
    <message>
        <source>knows this program as</source>
        <translation>kennt dieses Programm als</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Rechner</translation>
    </message>
    <message>
        <source>AE title</source>
        <translation>AE-Titel</translation>
    </message>
    <message>
        <source>Test the connection</source>
        <translation>Verbindung prüfen</translation>
    </message>
    <message>
        <source>Asking…</source>
        <translation>Wird gefragt…</translation>
    </message>
    <message>
        <source>Asking the archive</source>
        <translation>Das Archiv wird gefragt</translation>
    </message>
    <message>
        <source>The archive answers.</source>
        <translation>Das Archiv antwortet.</translation>
    </message>
    <message>
        <source>No worksheet is filled.</source>
        <translation>Kein Arbeitsblatt ist ausgefüllt.</translation>
    </message>
    <message>
        <source>Worksheets: %1</source>
        <translation>Arbeitsblätter: %1</translation>
    </message>
    <message>
        <source>Sending…</source>
        <translation>Wird gesendet…</translation>
    </message>
    <message>
        <source>Stored images and a report of each worksheet; copies wait in the outbox until the archive has them</source>
        <translation>Gespeicherte Bilder und ein Befund für jedes Arbeitsblatt; Kopien warten im Postausgang, bis das Archiv sie hat</translation>
    </message>
    <message>
        <source>Name the archive first: host and AE title</source>
        <translation>Nennen Sie zuerst das Archiv: Rechner und AE-Titel</translation>
    </message>
</context>
<context>
    <name>ew::ui::FindingWords</name>
    <message>
        <source>Ratio A / B</source>
        <translation>Verhältnis A / B</translation>
    </message>
    <message>
        <source>A in percent of B</source>
        <translation>A in Prozent von B</translation>
    </message>
    <message>
        <source>Stenosis, 1 - A / B</source>
        <translation>Stenose, 1 - A / B</translation>
    </message>
    <message>
        <source>Volume, ellipsoid</source>
        <translation>Volumen, Ellipsoid</translation>
    </message>
    <message>
        <source>Volume, discs of two planes</source>
        <translation>Volumen, Scheiben zweier Ebenen</translation>
    </message>
    <message>
        <source>A, narrow</source>
        <translation>A, eng</translation>
    </message>
    <message>
        <source>B, normal</source>
        <translation>B, normal</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>First plane</source>
        <translation>Erste Ebene</translation>
    </message>
    <message>
        <source>Second plane</source>
        <translation>Zweite Ebene</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>R%1</source>
        <comment>number of a result over several measurements</comment>
        <translation>R%1</translation>
    </message>
    <message>
        <source>Image %1: %2</source>
        <comment>an image&apos;s number, and a measurement in it</comment>
        <translation>Bild %1: %2</translation>
    </message>
    <message>
        <source>%1, %2 %3</source>
        <comment>a measurement, what of it, its value</comment>
        <translation>%1, %2 %3</translation>
    </message>
    <message>
        <source>%1 = %2</source>
        <comment>an input and what it is</comment>
        <translation>%1 = %2</translation>
    </message>
    <message>
        <source>From %1.</source>
        <translation>Aus %1.</translation>
    </message>
    <message>
        <source>± from those of its inputs, which share no point: correlation 0.</source>
        <translation>± aus denen der Eingaben, die keinen Punkt gemeinsam haben: Korrelation 0.</translation>
    </message>
    <message>
        <source>± from those of its inputs, which share points: correlation %1.</source>
        <translation>± aus denen der Eingaben, die Punkte gemeinsam haben: Korrelation %1.</translation>
    </message>
</context>
<context>
    <name>ew::ui::CombineDialog</name>
    <message>
        <source>Combine measurements</source>
        <translation>Messungen verrechnen</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>What is computed from the measurements below</source>
        <translation>Was aus den Messungen darunter berechnet wird</translation>
    </message>
    <message>
        <source>A measurement of any image of this patient, and what of it</source>
        <translation>Eine Messung aus irgendeinem Bild dieser Person, und was davon</translation>
    </message>
    <message>
        <source>Add to the list</source>
        <translation>In die Liste</translation>
    </message>
    <message>
        <source>Nothing is measured by discs yet. Take the tool for volumes by discs, and draw axis and outline in both planes.</source>
        <translation>Mit Scheiben ist noch nichts gemessen. Das Werkzeug für Volumen aus Scheiben nehmen und in beiden Ebenen Achse und Umriss zeichnen.</translation>
    </message>
    <message>
        <source>Nothing is measured yet that this could be computed from. Measure it first; this window may stay open.</source>
        <translation>Noch ist nichts gemessen, woraus dies berechnet werden könnte. Erst messen; dieses Fenster darf offen bleiben.</translation>
    </message>
</context>
<context>
    <name>ew::ui::ResultsList</name>
    <message>
        <source>Combine…</source>
        <translation>Verrechnen…</translation>
    </message>
    <message>
        <source>Ratio, stenosis, or volume from measurements of any image (%1)</source>
        <translation>Verhältnis, Stenose oder Volumen aus Messungen beliebiger Bilder (%1)</translation>
    </message>
    <message>
        <source>Save list…</source>
        <translation>Liste sichern…</translation>
    </message>
    <message>
        <source>All measurements of all images and their results, as CSV or JSON</source>
        <translation>Alle Messungen aller Bilder und ihre Ergebnisse, als CSV oder JSON</translation>
    </message>
    <message>
        <source>Delete result</source>
        <translation>Ergebnis löschen</translation>
    </message>
    <message>
        <source>Delete the chosen result; its measurements stay</source>
        <translation>Das gewählte Ergebnis löschen; seine Messungen bleiben</translation>
    </message>
</context>
<context>
    <name>ew::ui::StripTools</name>
    <message>
        <source>%1 in the strip</source>
        <comment>a tool</comment>
        <translation>%1 im Streifen</translation>
    </message>
    <message>
        <source>Heart beats</source>
        <translation>Herzschläge</translation>
    </message>
    <message>
        <source>Over how many heart beats the heart rate is measured; the more, the smaller its uncertainty</source>
        <translation>Über wie viele Herzschläge die Herzfrequenz gemessen wird; je mehr, desto kleiner die Unsicherheit</translation>
    </message>
</context>
<context>
    <name>ew::ui::ControlSurface</name>
    <message>
        <source>%1: off, or not there now.</source>
        <translation>%1: aus oder gerade nicht vorhanden.</translation>
    </message>
    <message>
        <source>%1: turn the knob up until it meets %2.</source>
        <translation>%1: Drehen Sie den Regler auf, bis er %2 erreicht.</translation>
    </message>
    <message>
        <source>%1: turn the knob down until it meets %2.</source>
        <translation>%1: Drehen Sie den Regler zu, bis er %2 erreicht.</translation>
    </message>
</context>
<context>
    <name>ew::ui::ControlWords</name>
    <message>
        <source>control %1, channel %2</source>
        <translation>Regler %1, Kanal %2</translation>
    </message>
    <message>
        <source>control %1 (14 bits), channel %2</source>
        <translation>Regler %1 (14 Bit), Kanal %2</translation>
    </message>
    <message>
        <source>parameter %1, channel %2</source>
        <translation>Parameter %1, Kanal %2</translation>
    </message>
    <message>
        <source>note %1, channel %2</source>
        <translation>Note %1, Kanal %2</translation>
    </message>
    <message>
        <source>fader (pitch bend), channel %1</source>
        <translation>Fader (Pitch Bend), Kanal %1</translation>
    </message>
    <message>
        <source>axis or wheel %1</source>
        <translation>Achse oder Rad %1</translation>
    </message>
    <message>
        <source>button %1.%2</source>
        <translation>Taste %1.%2</translation>
    </message>
    <message>
        <source>knob or fader</source>
        <translation>Drehregler oder Fader</translation>
    </message>
    <message>
        <source>encoder (1, 127)</source>
        <translation>Endlosregler (1, 127)</translation>
    </message>
    <message>
        <source>encoder (65, 63)</source>
        <translation>Endlosregler (65, 63)</translation>
    </message>
    <message>
        <source>encoder (1, 65)</source>
        <translation>Endlosregler (1, 65)</translation>
    </message>
    <message>
        <source>jog wheel</source>
        <translation>Jog-Rad</translation>
    </message>
    <message>
        <source>button</source>
        <translation>Taste</translation>
    </message>
    <message>
        <source>Press the button that shall do it.</source>
        <translation>Drücken Sie die Taste, die es tun soll.</translation>
    </message>
    <message>
        <source>Turn the knob, or move the fader, that shall do it.</source>
        <translation>Bewegen Sie den Regler oder Fader, der es tun soll.</translation>
    </message>
    <message>
        <source>Turn it on, a good way.</source>
        <translation>Drehen Sie ein gutes Stück weiter.</translation>
    </message>
    <message>
        <source>Now turn it back a little to the other side.</source>
        <translation>Drehen Sie nun ein wenig zur anderen Seite zurück.</translation>
    </message>
    <message>
        <source>That is a button, and this setting needs a knob. Turn a knob, or bind the button to an action instead.</source>
        <translation>Das ist eine Taste, und diese Einstellung braucht einen Regler. Drehen Sie einen Regler, oder binden Sie die Taste an eine Aktion.</translation>
    </message>
</context>
<context>
    <name>ew::ui::KeyMap</name>
    <message>
        <source>&apos;%1&apos; is the name of no key that can be given to &apos;%2&apos;.</source>
        <translation>„%1“ ist der Name keiner Taste, die „%2“ haben kann.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is given to &apos;%2&apos; and to another action; that one has it.</source>
        <translation>„%1“ ist „%2“ und einer anderen Aktion gegeben; jene hat sie.</translation>
    </message>
</context>
<context>
    <name>ew::ui::KeysDialog</name>
    <message>
        <source>Keys and controls</source>
        <translation>Tasten und Regler</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Controls</source>
        <translation>Regler</translation>
    </message>
    <message>
        <source>What the keyboard and foot pedals do</source>
        <translation>Was Tastatur und Fußschalter tun</translation>
    </message>
    <message>
        <source>What knobs, faders, jog wheels and buttons of other devices do</source>
        <translation>Was Regler, Fader, Jog-Räder und Tasten anderer Geräte tun</translation>
    </message>
    <message>
        <source>Reset all keys</source>
        <translation>Alle Tasten zurücksetzen</translation>
    </message>
    <message>
        <source>Give every action its usual keys again; controls stay</source>
        <translation>Jeder Aktion wieder ihre üblichen Tasten geben; Regler bleiben</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Datei öffnen…</translation>
    </message>
    <message>
        <source>Take over keys and controls that somebody saved</source>
        <translation>Tasten und Regler übernehmen, die jemand gesichert hat</translation>
    </message>
    <message>
        <source>Save as a file…</source>
        <translation>Als Datei sichern…</translation>
    </message>
    <message>
        <source>Save your keys and controls, to give them to others</source>
        <translation>Ihre Tasten und Regler sichern, um sie weiterzugeben</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close; everything is kept already</source>
        <translation>Schließen; alles ist schon gesichert</translation>
    </message>
    <message>
        <source>Open keys and controls</source>
        <translation>Tasten und Regler öffnen</translation>
    </message>
    <message>
        <source>Keys and controls (*.json)</source>
        <translation>Tasten und Regler (*.json)</translation>
    </message>
    <message>
        <source>Give every action its usual keys again?</source>
        <translation>Jeder Aktion wieder ihre üblichen Tasten geben?</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Alle zurücksetzen</translation>
    </message>
    <message>
        <source>Bound. It acts from now on.</source>
        <translation>Gebunden. Er wirkt ab jetzt.</translation>
    </message>
    <message>
        <source>Bound. Until now this control did &apos;%1&apos;; it does that no longer.</source>
        <translation>Gebunden. Bisher tat dieser Regler „%1“; das tut er nicht mehr.</translation>
    </message>
    <message>
        <source>Find an action or a key</source>
        <translation>Aktion oder Taste suchen</translation>
    </message>
    <message>
        <source>Part of an action&apos;s name, of its group or of a key: freeze, 3D, F13</source>
        <translation>Teil des Namens einer Aktion, ihrer Gruppe oder einer Taste: einfrieren, 3D, F13</translation>
    </message>
    <message>
        <source>Actions and their keys</source>
        <translation>Aktionen und ihre Tasten</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wann</translation>
    </message>
    <message>
        <source>Click here, then press a key</source>
        <translation>Hier klicken, dann Taste drücken</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>Neue Taste</translation>
    </message>
    <message>
        <source>Takes the next key, also F13 to F24, media keys and a foot pedal; Escape leaves it</source>
        <translation>Nimmt die nächste Taste, auch F13 bis F24, Medientasten und einen Fußschalter; Escape verlässt das Feld</translation>
    </message>
    <message>
        <source>Usual keys</source>
        <translation>Übliche Tasten</translation>
    </message>
    <message>
        <source>Give this action its usual keys again</source>
        <translation>Dieser Aktion wieder ihre üblichen Tasten geben</translation>
    </message>
    <message>
        <source>Do what the sentence says</source>
        <translation>Tun, was der Satz sagt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Leave everything as it is</source>
        <translation>Alles lassen, wie es ist</translation>
    </message>
    <message>
        <source>This key has no name on this system, so nothing can be bound to it.</source>
        <translation>Diese Taste hat auf diesem System keinen Namen, darum lässt sie sich nicht belegen.</translation>
    </message>
    <message>
        <source>A usual key of this action now does &apos;%1&apos;. Take it away there?</source>
        <translation>Eine übliche Taste dieser Aktion tut jetzt „%1“. Dort wegnehmen?</translation>
    </message>
    <message>
        <source>Take it away</source>
        <translation>Wegnehmen</translation>
    </message>
    <message>
        <source>Chosen by you; usually: %1</source>
        <translation>Von Ihnen gewählt; üblich: %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>in its panel</source>
        <translation>in seiner Tafel</translation>
    </message>
    <message>
        <source>A key of a panel: the plugin decides about it</source>
        <translation>Taste einer Tafel: Das Plugin bestimmt sie</translation>
    </message>
    <message>
        <source>Choose an action above</source>
        <translation>Oben eine Aktion wählen</translation>
    </message>
    <message>
        <source>%1: always this key</source>
        <translation>%1: immer diese Taste</translation>
    </message>
    <message>
        <source>Take this key away from the action</source>
        <translation>Der Aktion diese Taste wegnehmen</translation>
    </message>
    <message>
        <source>Take %1 away</source>
        <translation>%1 wegnehmen</translation>
    </message>
    <message>
        <source>%1 does that already.</source>
        <translation>%1 tut das schon.</translation>
    </message>
    <message>
        <source>An action has at most %1 keys; take one away first.</source>
        <translation>Eine Aktion hat höchstens %1 Tasten; nehmen Sie erst eine weg.</translation>
    </message>
    <message>
        <source>%1 always does &apos;%2&apos;; press another key.</source>
        <translation>%1 tut immer „%2“; drücken Sie eine andere Taste.</translation>
    </message>
    <message>
        <source>%1 now does &apos;%2&apos;. Take it away there?</source>
        <translation>%1 tut jetzt „%2“. Dort wegnehmen?</translation>
    </message>
    <message>
        <source>%1 does &apos;%2&apos; from now on.</source>
        <translation>%1 tut ab jetzt „%2“.</translation>
    </message>
    <message>
        <source>What the control shall do</source>
        <translation>Was der Regler tun soll</translation>
    </message>
    <message>
        <source>A setting for a knob, or an action for a button</source>
        <translation>Eine Einstellung für einen Regler oder eine Aktion für eine Taste</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>Anlernen</translation>
    </message>
    <message>
        <source>Bind what you move next</source>
        <translation>Binden, was Sie als Nächstes bewegen</translation>
    </message>
    <message>
        <source>Controls and what they do</source>
        <translation>Regler, und was sie tun</translation>
    </message>
    <message>
        <source>Does</source>
        <translation>Tut</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Regler</translation>
    </message>
    <message>
        <source>Read as</source>
        <translation>Gelesen als</translation>
    </message>
    <message>
        <source>Reversed</source>
        <translation>Umgekehrt</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>The chosen control does nothing any more</source>
        <translation>Der gewählte Regler tut nichts mehr</translation>
    </message>
    <message>
        <source>Button: %1: %2</source>
        <translation>Taste: %1: %2</translation>
    </message>
    <message>
        <source>How %1 is read</source>
        <translation>Wie %1 gelesen wird</translation>
    </message>
    <message>
        <source>How its values are read; change it when it moves the wrong way or jumps</source>
        <translation>Wie seine Werte gelesen werden; ändern, wenn er falsch herum wirkt oder springt</translation>
    </message>
    <message>
        <source>%1, reversed</source>
        <translation>%1, umgekehrt</translation>
    </message>
    <message>
        <source>To the right is less</source>
        <translation>Rechts ist weniger</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Choose what a knob or a button shall do, press Learn, then move it.</source>
        <translation>Wählen Sie, was ein Regler oder eine Taste tun soll, drücken Sie Anlernen und bewegen Sie ihn.</translation>
    </message>
    <message>
        <source>No control surface is plugged in.</source>
        <translation>Kein Reglerpult ist angeschlossen.</translation>
    </message>
    <message>
        <source>Plugged in: %1.</source>
        <translation>Angeschlossen: %1.</translation>
    </message>
    <message>
        <source>Save keys and controls</source>
        <translation>Tasten und Regler sichern</translation>
    </message>
    <message>
        <source>Saved to %1. Whoever opens it here has the same keys and controls.</source>
        <translation>Gesichert in %1. Wer die Datei hier öffnet, hat dieselben Tasten und Regler.</translation>
    </message>
    <message>
        <source>Your keys stay as they are.</source>
        <translation>Ihre Tasten bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>The keys and controls of this file take the place of yours.</source>
        <translation>Die Tasten und Regler dieser Datei treten an die Stelle Ihrer eigenen.</translation>
    </message>
    <message>
        <source>Save yours as a file first if you want to have them back.</source>
        <translation>Sichern Sie Ihre zuvor als Datei, wenn Sie sie wiederhaben wollen.</translation>
    </message>
    <message>
        <source>Take them over</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Taken over from %1.</source>
        <translation>Übernommen aus %1.</translation>
    </message>
    <message>
        <source>Taken over from %1, but: %2</source>
        <translation>Übernommen aus %1, aber: %2</translation>
    </message>
</context>
<context>
    <name>ew::ui::BoxZoom</name>
    <message>
        <source>Box to be magnified</source>
        <translation>Ausschnitt, der vergrößert wird</translation>
    </message>
    <message>
        <source>A recording shows what it showed. Close it (Escape), then zoom.</source>
        <translation>Eine Aufnahme zeigt, was sie zeigte. Sie schließen (Escape), dann vergrößern.</translation>
    </message>
    <message>
        <source>A box is drawn in the image. Switch to B or B + M (M).</source>
        <translation>Ein Ausschnitt wird im Bild aufgezogen. Auf B oder B + M umschalten (M).</translation>
    </message>
    <message>
        <source>Drag from one corner of the box to the other; Escape leaves the image as it is.</source>
        <translation>Von einer Ecke des Ausschnitts zur anderen ziehen; Escape lässt das Bild, wie es ist.</translation>
    </message>
    <message>
        <source>Drag a box around what is to be magnified</source>
        <translation>Einen Ausschnitt um das ziehen, was vergrößert werden soll</translation>
    </message>
</context>
<context>
    <name>ew::ui::ZoomOverview</name>
    <message>
        <source>The whole image, with the part that is shown</source>
        <translation>Das ganze Bild mit dem Ausschnitt, der gezeigt wird</translation>
    </message>
    <message>
        <source>The whole image: drag the box to move the detail</source>
        <translation>Das ganze Bild: den Rahmen ziehen, um den Ausschnitt zu verschieben</translation>
    </message>
</context>
<context>
    <name>ew::ui::WideScan</name>
    <message>
        <source>A wide image grows from a scan that runs. Close the recording (Escape) first.</source>
        <translation>Ein Panoramabild wächst aus einem laufenden Schallbild. Zuerst die Aufnahme schließen (Escape).</translation>
    </message>
    <message>
        <source>A wide image grows from B-mode images. Switch to B (M) first.</source>
        <translation>Ein Panoramabild wächst aus B-Bildern. Zuerst auf B umschalten (M).</translation>
    </message>
    <message>
        <source>Slide the probe slowly along its image. Freezing ends the wide image, Escape gives it up.</source>
        <translation>Den Schallkopf langsam in seiner Bildebene gleiten lassen. Einfrieren beendet das Panoramabild, Escape verwirft es.</translation>
    </message>
    <message>
        <source>The wide image was given up.</source>
        <translation>Das Panoramabild wurde verworfen.</translation>
    </message>
    <message>
        <source>No image was woven into the wide one: the probe has no position.</source>
        <translation>Kein Bild wurde in das Panoramabild gewebt: Der Schallkopf hat keine Lage.</translation>
    </message>
    <message>
        <source>The probe has no position: its images are not woven.</source>
        <translation>Der Schallkopf hat keine Lage: Seine Bilder werden nicht eingewebt.</translation>
    </message>
    <message>
        <source>Tilted out of the plane of the wide image, by more than %1°: not woven. Tilt back.</source>
        <translation>Um mehr als %1° aus der Ebene des Panoramabildes gekippt: nicht eingewebt. Zurückkippen.</translation>
    </message>
    <message>
        <source>Beside the plane of the wide image, by more than %1 mm: not woven. Slide back.</source>
        <translation>Mehr als %1 mm neben der Ebene des Panoramabildes: nicht eingewebt. Zurückgleiten.</translation>
    </message>
    <message>
        <source>Too fast: there would be a gap. Go back to where the wide image ends, and slide slower.</source>
        <translation>Zu schnell: Es entstünde eine Lücke. Zum Ende des Panoramabildes zurückgehen und langsamer gleiten.</translation>
    </message>
    <message>
        <source>The wide image is as large as it can be. Freezing keeps it.</source>
        <translation>Das Panoramabild ist so groß, wie es werden kann. Einfrieren behält es.</translation>
    </message>
</context>
<context>
    <name>ew::ui::WideLayer</name>
    <message>
        <source>Wide image, %1 cm across</source>
        <translation>Panoramabild, %1 cm breit</translation>
    </message>
</context>
<context>
    <name>ew::ui::KeptPicture</name>
    <message>
        <source>Another picture</source>
        <translation>Ein anderes Bild</translation>
    </message>
    <message>
        <source>Click to measure or write on this picture, or to scan where there is none yet (%1: the next picture)</source>
        <translation>Klicken, um in diesem Bild zu messen oder zu schreiben, oder um hier zu scannen, wo noch keines ist (%1: das nächste Bild)</translation>
    </message>
    <message>
        <source>No picture here yet. Click to scan here.</source>
        <translation>Hier ist noch kein Bild. Klicken, um hier zu schallen.</translation>
    </message>
</context>
<context>
    <name>ew::ui::PictureGrid</name>
    <message>
        <source>A recording is shown. Close it (Escape) to go to another picture.</source>
        <translation>Eine Aufnahme wird gezeigt. Schließen Sie sie (Esc), um zu einem anderen Bild zu gehen.</translation>
    </message>
    <message>
        <source>%1 right</source>
        <comment>number of a picture, and the patient&apos;s side</comment>
        <translation>%1 rechts</translation>
    </message>
    <message>
        <source>%1 left</source>
        <comment>number of a picture, and the patient&apos;s side</comment>
        <translation>%1 links</translation>
    </message>
    <message>
        <source>The volume was moved: the other pictures were made where it lay before, and are gone.</source>
        <translation>Das Volumen wurde verschoben: Die anderen Bilder entstanden an seinem alten Ort und sind fort.</translation>
    </message>
</context>
<context>
    <name>ew::ui::PictureButtons</name>
    <message>
        <source>One picture (%1: the next number of pictures)</source>
        <translation>Ein Bild (%1: die nächste Zahl von Bildern)</translation>
    </message>
    <message>
        <source>Two pictures beside each other (%1: the next number of pictures)</source>
        <translation>Zwei Bilder nebeneinander (%1: die nächste Zahl von Bildern)</translation>
    </message>
    <message>
        <source>Four pictures (%1: the next number of pictures)</source>
        <translation>Vier Bilder (%1: die nächste Zahl von Bildern)</translation>
    </message>
    <message>
        <source>L/R</source>
        <comment>the next of several pictures</comment>
        <translation>L/R</translation>
    </message>
    <message>
        <source>Next picture: a running scan goes on in it, a frozen one is kept (%1)</source>
        <translation>Nächstes Bild: Ein laufender Scan geht dort weiter, ein eingefrorener bleibt (%1)</translation>
    </message>
    <message>
        <source>1 : 1</source>
        <comment>all pictures at the same scale</comment>
        <translation>1 : 1</translation>
    </message>
    <message>
        <source>All pictures at the scale of the one that shows most</source>
        <translation>Alle Bilder im Maßstab dessen, das am meisten zeigt</translation>
    </message>
</context>
<context>
    <name>ew::ui::ScreenDialog</name>
    <message>
        <source>Film or recorded screen</source>
        <translation>Film oder aufgezeichneter Bildschirm</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>nicht gefunden</translation>
    </message>
    <message>
        <source>fan</source>
        <translation>Fächer</translation>
    </message>
    <message>
        <source>straight sides</source>
        <translation>gerade Seiten</translation>
    </message>
    <message>
        <source>Shape of the scan&apos;s outline; another one begins anew and is then dragged into place</source>
        <translation>Form des Schallbild-Umrisses; eine andere beginnt neu und wird dann an ihren Platz gezogen</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>Look again within this outline</source>
        <translation>In diesem Umriss noch einmal suchen</translation>
    </message>
    <message>
        <source>Looks for text and for the depth scale once more, with the outline as it was corrected</source>
        <translation>Sucht Text und Tiefenskala noch einmal, mit dem berichtigten Umriss</translation>
    </message>
    <message>
        <source>Back to what was found</source>
        <translation>Zurück zum Gefundenen</translation>
    </message>
    <message>
        <source>Takes back what was corrected of outline and boxes</source>
        <translation>Nimmt zurück, was an Umriss und Kästen berichtigt wurde</translation>
    </message>
    <message>
        <source>Measure distances</source>
        <translation>Strecken messen</translation>
    </message>
    <message>
        <source>Click or drag from one end to the other, in any frame; Backspace takes the last one away</source>
        <translation>Von einem Ende zum anderen klicken oder ziehen, in jedem Bild; die Rücktaste nimmt die letzte Strecke weg</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importieren …</translation>
    </message>
    <message>
        <source>Writes the cleaned recording; nothing else of it is stored</source>
        <translation>Schreibt die bereinigte Aufnahme; sonst wird nichts von ihr gespeichert</translation>
    </message>
    <message>
        <source>Depth of the scan as the screen states it, from its near to its far edge</source>
        <translation>Tiefe des Schallbilds, wie sie der Bildschirm angibt, vom nahen bis zum fernen Rand</translation>
    </message>
    <message>
        <source>Distance of neighbouring marks of the depth scale that was found</source>
        <translation>Abstand benachbarter Marken der gefundenen Tiefenskala</translation>
    </message>
    <message>
        <source>Depth of the scan</source>
        <translation>Tiefe des Schallbilds</translation>
    </message>
    <message>
        <source>Distance of marks</source>
        <translation>Abstand der Marken</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>How far the recording was read</source>
        <translation>Wie weit die Aufnahme gelesen ist</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Frame that is shown (arrows: a frame, with Shift ten; Home and End)</source>
        <translation>Gezeigtes Bild (Pfeile: ein Bild, mit Umschalt zehn; Pos1 und Ende)</translation>
    </message>
    <message>
        <source>%1 of %2   %3 s</source>
        <translation>%1 von %2   %3 s</translation>
    </message>
    <message>
        <source>Which frame is shown, and how long after the first</source>
        <translation>Welches Bild gezeigt wird, und wie lange nach dem ersten</translation>
    </message>
    <message>
        <source>Cleaned</source>
        <translation>Bereinigt</translation>
    </message>
    <message>
        <source>Shows the frames as they will be stored</source>
        <translation>Zeigt die Bilder, wie sie gespeichert werden</translation>
    </message>
    <message>
        <source>Drag the round handles to the edges of the scan, and the square one to move all of it. Click a box to keep what is below it, or drag a new box over text. H and Ctrl with arrows do for the mouse.</source>
        <translation>Die runden Griffe an die Ränder des Schallbilds ziehen, den eckigen, um alles zu verschieben. Ein Klick auf einen Kasten lässt stehen, was darunter liegt; über Text einen neuen Kasten ziehen. H und Strg mit Pfeilen ersetzen die Maus.</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>Looking for text and the depth scale within the outline …</source>
        <translation>Text und Tiefenskala werden im Umriss gesucht …</translation>
    </message>
    <message>
        <source>Reading the recording and looking for the scan …</source>
        <translation>Die Aufnahme wird gelesen und das Schallbild gesucht …</translation>
    </message>
    <message>
        <source>No text over the scan is taken out.</source>
        <translation>Aus dem Schallbild wird kein Text genommen.</translation>
    </message>
    <message>
        <source>The outline of the scan was not found. Choose its shape and drag it into place, then look again within it.</source>
        <translation>Der Umriss des Schallbilds wurde nicht gefunden. Seine Form wählen, ihn an seinen Platz ziehen und dann darin noch einmal suchen.</translation>
    </message>
    <message>
        <source>Check the outline, the scale and the boxes of text. Everything outside the outline becomes black.</source>
        <translation>Umriss, Maßstab und Textkästen prüfen. Alles außerhalb des Umrisses wird schwarz.</translation>
    </message>
    <message>
        <source>%1 marks were found, %2 pixels apart.</source>
        <translation>%1 Marken wurden gefunden, je %2 Pixel auseinander.</translation>
    </message>
    <message>
        <source>No marks were found.</source>
        <translation>Keine Marken wurden gefunden.</translation>
    </message>
    <message>
        <source>A pixel is %1 mm, the scan %2 mm deep.</source>
        <translation>Ein Pixel misst %1 mm, das Schallbild ist %2 mm tief.</translation>
    </message>
    <message>
        <source>Type how far apart they are, or the depth.</source>
        <translation>Ihren Abstand oder die Tiefe eintippen.</translation>
    </message>
    <message>
        <source>Type the depth that the screen states.</source>
        <translation>Die Tiefe eintippen, die der Bildschirm angibt.</translation>
    </message>
    <message>
        <source>Reading a frame</source>
        <translation>Ein Bild wird gelesen</translation>
    </message>
    <message>
        <source>Stop (space)</source>
        <translation>Anhalten (Leertaste)</translation>
    </message>
    <message>
        <source>Play in a loop (space)</source>
        <translation>In einer Schleife abspielen (Leertaste)</translation>
    </message>
    <message>
        <source>%1 pixels</source>
        <translation>%1 Pixel</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>State the depth to measure in mm.</source>
        <translation>Um in mm zu messen, die Tiefe angeben.</translation>
    </message>
    <message>
        <source>Save the cleaned recording</source>
        <translation>Die bereinigte Aufnahme speichern</translation>
    </message>
    <message>
        <source>%1 cleaned</source>
        <translation>%1 bereinigt</translation>
    </message>
    <message>
        <source>Sequences (*.igs.mha)</source>
        <translation>Sequenzen (*.igs.mha)</translation>
    </message>
    <message>
        <source>The recording itself is not written over; choose another name.</source>
        <translation>Die Aufnahme selbst wird nicht überschrieben; einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>%1 wird geschrieben</translation>
    </message>
    <message>
        <source>The cleaned recording was written to %1.</source>
        <translation>Die bereinigte Aufnahme wurde nach %1 geschrieben.</translation>
    </message>
    <message>
        <source>Writing the cleaned recording to %1 …</source>
        <translation>Die bereinigte Aufnahme wird nach %1 geschrieben …</translation>
    </message>
    <message>
        <source>Writing was stopped; nothing was stored.</source>
        <translation>Das Schreiben wurde abgebrochen; gespeichert ist nichts.</translation>
    </message>
    <message>
        <source>The cleaned recording was written to %1. Nothing else of it was stored.</source>
        <translation>Die bereinigte Aufnahme wurde nach %1 geschrieben. Sonst wurde nichts von ihr gespeichert.</translation>
    </message>
    <message>
        <source>Boxes of text over the scan that are filled: %1</source>
        <translation>Gefüllte Textkästen über dem Schallbild: %1</translation>
    </message>
</context>
<context>
    <name>ew::ui::ScreenView</name>
    <message>
        <source>A frame of the recording, with the outline of the scan and boxes of text</source>
        <translation>Ein Bild der Aufnahme mit dem Umriss des Schallbilds und Textkästen</translation>
    </message>
    <message>
        <source>No frame can be shown yet.</source>
        <translation>Noch lässt sich kein Bild zeigen.</translation>
    </message>
</context>
<context>
    <name>ew::ui::CardView</name>
    <message>
        <source>Cases</source>
        <translation>Fälle</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>ew::ui::CaseCatalogue</name>
    <message>
        <source>%1 of %2 lessons passed</source>
        <translation>%1 von %2 Lektionen bestanden</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>Erste Schritte</translation>
    </message>
    <message>
        <source>Basic</source>
        <translation>Grundlagen</translation>
    </message>
    <message>
        <source>Intermediate</source>
        <translation>Aufbau</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Fortgeschritten</translation>
    </message>
    <message>
        <source>Examination</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Shipped with EchoWeave</source>
        <translation>Mit EchoWeave geliefert</translation>
    </message>
    <message>
        <source>Your own</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>Published</source>
        <translation>Veröffentlicht</translation>
    </message>
    <message>
        <source>1 lesson</source>
        <translation>1 Lektion</translation>
    </message>
    <message>
        <source>%1 lessons</source>
        <translation>%1 Lektionen</translation>
    </message>
</context>
<context>
    <name>ew::ui::CaseFilters</name>
    <message>
        <source>Where cases come from</source>
        <translation>Woher Fälle kommen</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Region</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>Schlagwort</translation>
    </message>
    <message>
        <source>With lessons</source>
        <translation>Mit Lektionen</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alle zeigen</translation>
    </message>
    <message>
        <source>Clear the search and all filters</source>
        <translation>Suche und alle Filter leeren</translation>
    </message>
    <message>
        <source>All origins</source>
        <translation>Jede Herkunft</translation>
    </message>
    <message>
        <source>All regions</source>
        <translation>Alle Regionen</translation>
    </message>
    <message>
        <source>All levels</source>
        <translation>Alle Stufen</translation>
    </message>
    <message>
        <source>All tags</source>
        <translation>Alle Schlagwörter</translation>
    </message>
</context>
<context>
    <name>ew::ui::LibraryBrowser</name>
    <message>
        <source>Reading the library</source>
        <translation>Bibliothek lesen</translation>
    </message>
    <message>
        <source>Further cases of the library that cannot be read: %1.</source>
        <translation>Weitere Fälle der Bibliothek, die sich nicht lesen lassen: %1.</translation>
    </message>
</context>
<context>
    <name>ew::ui::RecentStrip</name>
    <message>
        <source>Recently opened</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
</context>
<context>
    <name>ew::lessons</name>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
</context>
<context>
    <name>ew::lessons::LessonList</name>
    <message>
        <source>First steps</source>
        <translation>Erste Schritte</translation>
    </message>
    <message>
        <source>Basic</source>
        <translation>Grundlagen</translation>
    </message>
    <message>
        <source>Intermediate</source>
        <translation>Fortgeschritten</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Anspruchsvoll</translation>
    </message>
    <message>
        <source>Examination</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>%1, about %2 min</source>
        <translation>%1, etwa %2 min</translation>
    </message>
    <message>
        <source>%1 of %2 steps passed</source>
        <translation>%1 von %2 Schritten bestanden</translation>
    </message>
    <message>
        <source>Go on at step %1</source>
        <translation>Weiter bei Schritt %1</translation>
    </message>
    <message>
        <source>Begin again</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>ew::lessons::OutcomePage</name>
    <message>
        <source>Stop</source>
        <translation>Aufhören</translation>
    </message>
    <message>
        <source>Next exercise</source>
        <translation>Nächste Übung</translation>
    </message>
    <message>
        <source>Not right yet: %1</source>
        <translation>Noch nicht richtig: %1</translation>
    </message>
    <message>
        <source>Right: %1</source>
        <translation>Richtig: %1</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Passed: %1</source>
        <translation>Bestanden: %1</translation>
    </message>
    <message>
        <source>Skipped: %1</source>
        <translation>Übersprungen: %1</translation>
    </message>
    <message>
        <source>Not passed yet: %1</source>
        <translation>Noch nicht bestanden: %1</translation>
    </message>
    <message>
        <source>%1 of 100 points, %2 needed</source>
        <translation>%1 von 100 Punkten, %2 nötig</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Nächster Schritt</translation>
    </message>
    <message>
        <source>Lesson passed: %1</source>
        <translation>Lektion bestanden: %1</translation>
    </message>
    <message>
        <source>Lesson finished: %1</source>
        <translation>Lektion beendet: %1</translation>
    </message>
    <message>
        <source>%1 of %2 steps passed</source>
        <translation>%1 von %2 Schritten bestanden</translation>
    </message>
    <message>
        <source>Back to the lessons</source>
        <translation>Zurück zu den Lektionen</translation>
    </message>
    <message>
        <source>Handed in: %1</source>
        <translation>Abgegeben: %1</translation>
    </message>
    <message>
        <source>An instructor judges it afterwards.</source>
        <translation>Eine Lehrkraft bewertet es hinterher.</translation>
    </message>
    <message>
        <source>Examination handed in: %1</source>
        <translation>Prüfung abgegeben: %1</translation>
    </message>
    <message>
        <source>%1 of %2 steps handed in; an instructor judges them afterwards.</source>
        <translation>%1 von %2 Schritten abgegeben; eine Lehrkraft bewertet sie hinterher.</translation>
    </message>
</context>
<context>
    <name>ew::lessons::StepPage</name>
    <message>
        <source>Translucent skin</source>
        <translation>Durchscheinende Haut</translation>
    </message>
    <message>
        <source>Organs in the body</source>
        <translation>Organe im Körper</translation>
    </message>
    <message>
        <source>What was recorded</source>
        <translation>Was aufgenommen wurde</translation>
    </message>
    <message>
        <source>My path</source>
        <translation>Mein Weg</translation>
    </message>
    <message>
        <source>The expert&apos;s plane</source>
        <translation>Ebene des Experten</translation>
    </message>
    <message>
        <source>Outline in the image</source>
        <translation>Umriss im Bild</translation>
    </message>
    <message>
        <source>Next movement</source>
        <translation>Nächste Bewegung</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
    <message>
        <source>Back to the lessons; the lesson can be gone on with later</source>
        <translation>Zurück zu den Lektionen; die Lektion kann später fortgesetzt werden</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Überspringen</translation>
    </message>
    <message>
        <source>Leave this step out; it counts as not passed</source>
        <translation>Diesen Schritt auslassen; er gilt als nicht bestanden</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
    <message>
        <source>Look for: %1</source>
        <translation>Achten Sie auf: %1</translation>
    </message>
    <message>
        <source>Show a hint</source>
        <translation>Hinweis zeigen</translation>
    </message>
    <message>
        <source>Show another hint</source>
        <translation>Weiteren Hinweis zeigen</translation>
    </message>
    <message>
        <source>No more hints</source>
        <translation>Keine weiteren Hinweise</translation>
    </message>
    <message>
        <source>Your answer</source>
        <translation>Ihre Antwort</translation>
    </message>
    <message>
        <source>More than one answer is right.</source>
        <translation>Mehr als eine Antwort ist richtig.</translation>
    </message>
    <message>
        <source>Point at it</source>
        <translation>Darauf zeigen</translation>
    </message>
    <message>
        <source>Then click in the image; on the keyboard arrows and Enter</source>
        <translation>Dann im Bild klicken; mit der Tastatur Pfeile und Eingabe</translation>
    </message>
    <message>
        <source>Click what is asked for. Arrows and Enter do the same, Escape ends.</source>
        <translation>Klicken Sie das Gesuchte an. Pfeile und Eingabe tun dasselbe, Escape beendet.</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Rest</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Play again</source>
        <translation>Noch einmal abspielen</translation>
    </message>
    <message>
        <source>The picture &apos;%1&apos; cannot be shown.</source>
        <translation>Das Bild „%1“ kann nicht gezeigt werden.</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>noch %1</translation>
    </message>
</context>
<context>
    <name>ew::lessons::PlayerPanel</name>
    <message>
        <source>No lessons here</source>
        <translation>Hier gibt es keine Lektionen</translation>
    </message>
    <message>
        <source>Open a case that has lessons: the start page says how many each has.</source>
        <translation>Öffnen Sie einen Fall mit Lektionen: Die Startseite sagt, wie viele jeder hat.</translation>
    </message>
    <message>
        <source>The lesson was changed since this attempt began; its steps are those of today.</source>
        <translation>Die Lektion wurde seit Beginn dieses Versuchs geändert; es gelten die Schritte von heute.</translation>
    </message>
    <message>
        <source>The step that was running when the program ended was not kept; it begins anew.</source>
        <translation>Der Schritt, der lief, als das Programm endete, wurde nicht behalten; er beginnt von vorn.</translation>
    </message>
</context>
<context>
    <name>ew::lessons::LessonPlayer</name>
    <message>
        <source>Getting the step ready…</source>
        <translation>Der Schritt wird vorbereitet…</translation>
    </message>
    <message>
        <source>Getting the step ready</source>
        <translation>Schritt vorbereiten</translation>
    </message>
    <message>
        <source>Opening the case of this step…</source>
        <translation>Der Fall dieses Schritts wird geöffnet…</translation>
    </message>
    <message>
        <source>The volume of this case is being made ready…</source>
        <translation>Das Volumen dieses Falls wird vorbereitet…</translation>
    </message>
    <message>
        <source>The lesson was left because another case was opened; it can be gone on with in its own case.</source>
        <translation>Die Lektion wurde verlassen, weil ein anderer Fall geöffnet wurde; sie kann in ihrem eigenen Fall fortgesetzt werden.</translation>
    </message>
</context>
<context>
    <name>ew::ui::BodyAidsView</name>
    <message>
        <source>Showing organs</source>
        <translation>Organe zeigen</translation>
    </message>
</context>
<context>
    <name>ew::ui::CourseStrip</name>
    <message>
        <source>The case of this lesson is not in the library.</source>
        <translation>Der Fall dieser Lektion ist nicht in der Bibliothek.</translation>
    </message>
    <message>
        <source>%1 · about %2 min · %3</source>
        <translation>%1 · etwa %2 min · %3</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1. You have passed all lessons that are here.</source>
        <translation>%1. Alle Lektionen, die hier sind, sind bestanden.</translation>
    </message>
    <message>
        <source>%1. Next: %2 (%3)</source>
        <translation>%1. Als Nächstes: %2 (%3)</translation>
    </message>
    <message>
        <source>%1 of %2 lessons passed</source>
        <translation>%1 von %2 Lektionen bestanden</translation>
    </message>
    <message>
        <source>Course: %1</source>
        <translation>Kurs: %1</translation>
    </message>
    <message>
        <source>Go on with %1</source>
        <translation>Weiter mit %1</translation>
    </message>
    <message>
        <source>You stopped in step %1 of %2 of the lesson “%3”.</source>
        <translation>Unterbrochen bei Schritt %1 von %2 der Lektion „%3“.</translation>
    </message>
    <message>
        <source>Show all lessons of the course in their order</source>
        <translation>Alle Lektionen des Kurses in ihrer Reihenfolge zeigen</translation>
    </message>
    <message>
        <source>Show the next lesson alone</source>
        <translation>Nur die nächste Lektion zeigen</translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation>Alle Lektionen</translation>
    </message>
    <message>
        <source>Fewer</source>
        <translation>Weniger</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Once more</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Not begun yet</source>
        <translation>Noch nicht begonnen</translation>
    </message>
    <message>
        <source>%1 of %2 steps passed</source>
        <translation>%1 von %2 Schritten bestanden</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Stopped in step %1 of %2</source>
        <translation>Bei Schritt %1 von %2 unterbrochen</translation>
    </message>
</context>
<context>
    <name>ew::ui::CaseLessons</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>This lesson has no steps yet.</source>
        <translation>Diese Lektion hat noch keine Schritte.</translation>
    </message>
    <message>
        <source>%1, last on %2</source>
        <translation>%1, zuletzt am %2</translation>
    </message>
    <message>
        <source>%1, about %2 min · %3</source>
        <translation>%1, etwa %2 min · %3</translation>
    </message>
    <message>
        <source>Open the case without a lesson</source>
        <translation>Den Fall ohne Lektion öffnen</translation>
    </message>
    <message>
        <source>Lessons of %1</source>
        <translation>Lektionen von %1</translation>
    </message>
</context>
<context>
    <name>ew::lessons::ExerciseCard</name>
    <message>
        <source>Go on with exercises</source>
        <translation>Mit Übungen weitermachen</translation>
    </message>
    <message>
        <source>Start exercises</source>
        <translation>Übungen beginnen</translation>
    </message>
    <message>
        <source>Known well: %1</source>
        <translation>Gut bekannt: %1</translation>
    </message>
    <message>
        <source>Still hard: %1</source>
        <translation>Noch schwierig: %1</translation>
    </message>
    <message>
        <source>Of %1 exercises tried, none is due before %2. There may be new ones.</source>
        <translation>Von %1 versuchten Übungen ist vor dem %2 keine fällig. Neue kann es geben.</translation>
    </message>
    <message>
        <source>Of %1 exercises tried, %2 are due.</source>
        <translation>Von %1 versuchten Übungen sind %2 fällig.</translation>
    </message>
    <message>
        <source>Of %1 exercises tried, one is due.</source>
        <translation>Von %1 versuchten Übungen ist eine fällig.</translation>
    </message>
    <message>
        <source>The program asks you for planes, organs and measurements of this case, and again for what was hard.</source>
        <translation>Das Programm fragt nach Ebenen, Organen und Messungen dieses Falls, und wieder nach dem, was schwierig war.</translation>
    </message>
    <message>
        <source>Learning as</source>
        <translation>Es lernt</translation>
    </message>
    <message>
        <source>Kept with your attempts, so that several people can learn at one workstation. It may stay empty.</source>
        <translation>Wird mit den Versuchen aufbewahrt, damit mehrere Personen an einem Arbeitsplatz lernen können. Kann leer bleiben.</translation>
    </message>
    <message>
        <source>Your name, if you like</source>
        <translation>Name, wenn gewünscht</translation>
    </message>
    <message>
        <source>Some exercises give away what this case has. They come by themselves once its lessons are finished.</source>
        <translation>Manche Übungen verraten, was dieser Fall hat. Sie kommen von selbst, sobald seine Lektionen beendet sind.</translation>
    </message>
    <message>
        <source>Ask for findings, too</source>
        <translation>Auch nach Befunden fragen</translation>
    </message>
    <message>
        <source>Teach yourself</source>
        <translation>Selbst üben</translation>
    </message>
</context>
<context>
    <name>ew::lessons::ExercisePlayer</name>
    <message>
        <source>Back to the lessons; what was judged is kept</source>
        <translation>Zurück zu den Lektionen; was beurteilt wurde, bleibt</translation>
    </message>
    <message>
        <source>Take another one; this one does not count</source>
        <translation>Eine andere nehmen; diese zählt nicht</translation>
    </message>
    <message>
        <source>Then a little easier: level %1.</source>
        <translation>Dann etwas leichter: Stufe %1.</translation>
    </message>
    <message>
        <source>Then a little harder: level %1.</source>
        <translation>Dann etwas schwieriger: Stufe %1.</translation>
    </message>
    <message>
        <source>It comes again in %1 days.</source>
        <translation>Sie kommt in %1 Tagen wieder.</translation>
    </message>
    <message>
        <source>It comes again tomorrow.</source>
        <translation>Sie kommt morgen wieder.</translation>
    </message>
    <message>
        <source>It comes again in a few minutes.</source>
        <translation>Sie kommt in wenigen Minuten wieder.</translation>
    </message>
    <message>
        <source>Level %1 of %2</source>
        <translation>Stufe %1 von %2</translation>
    </message>
    <message>
        <source>There is nothing here that the program could ask for: no plane can be reached from the skin, no organ is told apart by pointing, and nothing is measured with calipers.</source>
        <translation>Hier gibt es nichts, wonach das Programm fragen könnte: keine Ebene ist von der Haut aus zu erreichen, kein Organ durch Zeigen zu unterscheiden, und nichts wird mit Messkreuzen gemessen.</translation>
    </message>
    <message>
        <source>Getting the exercise ready</source>
        <translation>Die Übung wird vorbereitet</translation>
    </message>
    <message>
        <source>Getting the exercise ready…</source>
        <translation>Die Übung wird vorbereitet …</translation>
    </message>
    <message>
        <source>The volume of this case is being made ready…</source>
        <translation>Das Volumen dieses Falls wird vorbereitet …</translation>
    </message>
    <message>
        <source>Looking for exercises</source>
        <translation>Übungen werden gesucht</translation>
    </message>
    <message>
        <source>Looking for exercises in this case…</source>
        <translation>Übungen in diesem Fall werden gesucht …</translation>
    </message>
</context>
<context>
    <name>ew::ui::BodyTools</name>
    <message>
        <source>Move: %1</source>
        <translation>Schieben: %1</translation>
    </message>
    <message>
        <source>Turn about: %1</source>
        <translation>Drehen um: %1</translation>
    </message>
    <message>
        <source>%1: %2 mm</source>
        <translation>%1: %2 mm</translation>
    </message>
    <message>
        <source>about %1: %2°</source>
        <translation>um %1: %2°</translation>
    </message>
</context>
<context>
    <name>ew::sdk::PlacementFields</name>
    <message>
        <source>Towards the patient&apos;s left</source>
        <translation>Zur linken Seite des Patienten</translation>
    </message>
    <message>
        <source>Towards the back</source>
        <translation>Zum Rücken</translation>
    </message>
    <message>
        <source>Towards the head</source>
        <translation>Zum Kopf</translation>
    </message>
    <message>
        <source>Turn about the x axis</source>
        <translation>Drehung um die x-Achse</translation>
    </message>
    <message>
        <source>Turn about the y axis</source>
        <translation>Drehung um die y-Achse</translation>
    </message>
    <message>
        <source>Turn about the z axis</source>
        <translation>Drehung um die z-Achse</translation>
    </message>
</context>
<context>
    <name>ew::case_authoring::PairList</name>
    <message>
        <source>Place %1</source>
        <translation>Stelle %1</translation>
    </message>
    <message>
        <source>What place %1 is called</source>
        <translation>Wie Stelle %1 heißt</translation>
    </message>
    <message>
        <source>How far the place in the volume then lies from the place on the body</source>
        <translation>Wie weit die Stelle im Volumen dann von der Stelle am Körper entfernt liegt</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Where place %1 is on the body</source>
        <translation>Wo Stelle %1 am Körper ist</translation>
    </message>
    <message>
        <source>On the body…</source>
        <translation>Am Körper …</translation>
    </message>
    <message>
        <source>Click on the skin</source>
        <translation>Auf die Haut klicken</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Click in the image</source>
        <translation>Ins Bild klicken</translation>
    </message>
    <message>
        <source>In the image ✓</source>
        <translation>Im Bild ✓</translation>
    </message>
    <message>
        <source>In the image…</source>
        <translation>Im Bild …</translation>
    </message>
    <message>
        <source>Point at the place in the scan image again</source>
        <translation>Die Stelle im Schallbild noch einmal zeigen</translation>
    </message>
    <message>
        <source>Point at the place in the scan image</source>
        <translation>Die Stelle im Schallbild zeigen</translation>
    </message>
    <message>
        <source>Clicked ✓ (%1, %2, %3)</source>
        <translation>Geklickt ✓ (%1, %2, %3)</translation>
    </message>
    <message>
        <source>not clicked yet</source>
        <translation>noch nicht geklickt</translation>
    </message>
</context>
<context>
    <name>ew::case_authoring::PlacePanel</name>
    <message>
        <source>No case is open</source>
        <translation>Kein Fall ist geöffnet</translation>
    </message>
    <message>
        <source>Open a case. Then its volume can be placed in the body here.</source>
        <translation>Einen Fall öffnen. Dann lässt sich hier sein Volumen im Körper platzieren.</translation>
    </message>
    <message>
        <source>On the skin</source>
        <translation>An der Haut</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Bewegen</translation>
    </message>
    <message>
        <source>By places</source>
        <translation>Nach Stellen</translation>
    </message>
    <message>
        <source>Move the volume, %1</source>
        <translation>Volumen bewegen, %1</translation>
    </message>
    <message>
        <source>Part of the near face that touches the skin</source>
        <translation>Anteil der nahen Fläche, der die Haut berührt</translation>
    </message>
    <message>
        <source>Near face</source>
        <translation>Nahe Fläche</translation>
    </message>
    <message>
        <source>The side of the volume on which the probe was</source>
        <translation>Die Seite des Volumens, auf der der Schallkopf war</translation>
    </message>
    <message>
        <source>Handles</source>
        <translation>Griffe</translation>
    </message>
    <message>
        <source>Arrows and rings in the 3D view: drag one (Shift: whole millimetres and degrees), or use the arrows, Page up and Page down there; with Alt they turn</source>
        <translation>Pfeile und Ringe in der 3D-Ansicht: einen ziehen (Umschalt: ganze Millimeter und Grad) oder dort die Pfeiltasten, Bild auf und Bild ab drücken; mit Alt drehen sie</translation>
    </message>
    <message>
        <source>Put on the skin…</source>
        <translation>Auf die Haut setzen …</translation>
    </message>
    <message>
        <source>Click on the body: the near face is put flush on the skin there</source>
        <translation>Auf den Körper klicken: Dort wird die nahe Fläche bündig auf die Haut gesetzt</translation>
    </message>
    <message>
        <source>Usual place</source>
        <translation>Übliche Stelle</translation>
    </message>
    <message>
        <source>Where a probe is usually put for the region of this case</source>
        <translation>Wo ein Schallkopf für die Region dieses Falls üblicherweise aufgesetzt wird</translation>
    </message>
    <message>
        <source>Flip left and right</source>
        <translation>Links und rechts tauschen</translation>
    </message>
    <message>
        <source>Half a turn about the beams</source>
        <translation>Eine halbe Drehung um die Schallstrahlen</translation>
    </message>
    <message>
        <source>Flip the volume left and right</source>
        <translation>Links und rechts des Volumens tauschen</translation>
    </message>
    <message>
        <source>Turn 90° back</source>
        <translation>90° zurückdrehen</translation>
    </message>
    <message>
        <source>A quarter turn about the beams, anticlockwise as seen from outside</source>
        <translation>Eine Vierteldrehung um die Schallstrahlen, von außen gesehen gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Turn the volume by 90°</source>
        <translation>Volumen um 90° drehen</translation>
    </message>
    <message>
        <source>Turn 90° on</source>
        <translation>90° weiterdrehen</translation>
    </message>
    <message>
        <source>A quarter turn about the beams, clockwise as seen from outside</source>
        <translation>Eine Vierteldrehung um die Schallstrahlen, von außen gesehen im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Point at the same places in the image and on the body: three at least, not on one line. A fourth shows which one is wrong.</source>
        <translation>Dieselben Stellen im Bild und am Körper zeigen: mindestens drei, nicht auf einer Geraden. Eine vierte zeigt, welche falsch ist.</translation>
    </message>
    <message>
        <source>Name a place</source>
        <translation>Stelle benennen</translation>
    </message>
    <message>
        <source>Remove a place</source>
        <translation>Stelle entfernen</translation>
    </message>
    <message>
        <source>Choose a place on the body</source>
        <translation>Stelle am Körper wählen</translation>
    </message>
    <message>
        <source>Add a place</source>
        <translation>Stelle hinzufügen</translation>
    </message>
    <message>
        <source>Place by these</source>
        <translation>Danach platzieren</translation>
    </message>
    <message>
        <source>Place the volume by places</source>
        <translation>Volumen nach Stellen platzieren</translation>
    </message>
    <message>
        <source>The volume of this case is not what is scanned at the moment, so that nobody can say how it lies. Give the case a volume, prepare it, or choose View, Scan the case&apos;s volume.</source>
        <translation>Zurzeit wird nicht das Volumen dieses Falls geschallt, deshalb lässt sich nicht sagen, wie es liegt. Dem Fall ein Volumen geben, ihn vorbereiten oder Ansicht, Volumen des Falls schallen wählen.</translation>
    </message>
    <message>
        <source>towards the left</source>
        <translation>nach links</translation>
    </message>
    <message>
        <source>towards the right</source>
        <translation>nach rechts</translation>
    </message>
    <message>
        <source>towards the back</source>
        <translation>nach hinten</translation>
    </message>
    <message>
        <source>towards the front</source>
        <translation>nach vorn</translation>
    </message>
    <message>
        <source>towards the head</source>
        <translation>zum Kopf</translation>
    </message>
    <message>
        <source>towards the feet</source>
        <translation>zu den Füßen</translation>
    </message>
    <message>
        <source>the side %1</source>
        <translation>die Seite %1</translation>
    </message>
    <message>
        <source>as the beams were recorded</source>
        <translation>wie die Schallstrahlen aufgenommen wurden</translation>
    </message>
    <message>
        <source>Choose the near face</source>
        <translation>Nahe Fläche wählen</translation>
    </message>
    <message>
        <source>The near face lies on the skin.</source>
        <translation>Die nahe Fläche liegt an der Haut.</translation>
    </message>
    <message>
        <source>The near face stands off the skin; move the volume in, or turn it flush.</source>
        <translation>Die nahe Fläche steht von der Haut ab; das Volumen hineinschieben oder bündig drehen.</translation>
    </message>
    <message>
        <source>The near face lies below the skin; move the volume out.</source>
        <translation>Die nahe Fläche liegt unter der Haut; das Volumen herausschieben.</translation>
    </message>
    <message>
        <source>%1 % of the near face touch the skin (within %2 mm). Largest gap %3 mm, deepest below %4 mm. %5 % of the volume lie outside the body.</source>
        <translation>%1 % der nahen Fläche berühren die Haut (auf %2 mm). Größter Spalt %3 mm, tiefste Stelle darunter %4 mm. %5 % des Volumens liegen außerhalb des Körpers.</translation>
    </message>
    <message>
        <source>across</source>
        <translation>quer</translation>
    </message>
    <message>
        <source>along the beams</source>
        <translation>entlang der Schallstrahlen</translation>
    </message>
    <message>
        <source>along the sweep</source>
        <translation>entlang des Schwenks</translation>
    </message>
    <message>
        <source>Move the volume by its handles</source>
        <translation>Volumen an den Griffen bewegen</translation>
    </message>
    <message>
        <source>Nobody has said where a probe is usually put on this mannequin; use the handles, or click on the skin.</source>
        <translation>Für diese Puppe ist nicht bekannt, wo ein Schallkopf üblicherweise aufgesetzt wird; die Griffe benutzen oder auf die Haut klicken.</translation>
    </message>
    <message>
        <source>Put the volume at its usual place</source>
        <translation>Volumen an die übliche Stelle setzen</translation>
    </message>
    <message>
        <source>Click where the middle of the near face is to lie. Escape leaves it where it is.</source>
        <translation>Dorthin klicken, wo die Mitte der nahen Fläche liegen soll. Esc lässt sie, wo sie ist.</translation>
    </message>
    <message>
        <source>Put the volume on the skin</source>
        <translation>Volumen auf die Haut setzen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not fit with the others: it lies %2 mm off and is left out. Point at it again. The others lie %3 mm apart on average.</source>
        <translation>„%1“ passt nicht zu den anderen: Die Stelle liegt %2 mm daneben und bleibt außer Betracht. Sie noch einmal zeigen. Die anderen liegen im Mittel %3 mm auseinander.</translation>
    </message>
    <message>
        <source>The places lie %1 mm apart on average; the worst is &apos;%2&apos; with %3 mm.</source>
        <translation>Die Stellen liegen im Mittel %1 mm auseinander; am schlechtesten ist „%2“ mit %3 mm.</translation>
    </message>
    <message>
        <source>Place %1</source>
        <translation>Stelle %1</translation>
    </message>
    <message>
        <source>Move the volume so that the places lie on each other as well as may be</source>
        <translation>Das Volumen so bewegen, dass die Stellen möglichst gut aufeinanderliegen</translation>
    </message>
    <message>
        <source>Three complete pairs are needed, not on one line</source>
        <translation>Drei vollständige Paare sind nötig, nicht auf einer Geraden</translation>
    </message>
    <message>
        <source>The volume of this case is not what is scanned at the moment; choose View, Scan the case&apos;s volume.</source>
        <translation>Zurzeit wird nicht das Volumen dieses Falls geschallt; Ansicht, Volumen des Falls schallen wählen.</translation>
    </message>
    <message>
        <source>Click the place in the image; move the probe before, if it is not to be seen. Escape ends.</source>
        <translation>Die Stelle im Bild anklicken; vorher den Schallkopf bewegen, wenn sie nicht zu sehen ist. Esc beendet.</translation>
    </message>
    <message>
        <source>Point at a place in the volume</source>
        <translation>Stelle im Volumen zeigen</translation>
    </message>
    <message>
        <source>Click the place on the body. Escape ends.</source>
        <translation>Die Stelle am Körper anklicken. Esc beendet.</translation>
    </message>
    <message>
        <source>Point at a place on the body</source>
        <translation>Stelle am Körper zeigen</translation>
    </message>
    <message>
        <source>Part of the volume lies outside the body; turn it round, so that the beams look inwards.</source>
        <translation>Ein Teil des Volumens liegt außerhalb des Körpers; umdrehen, sodass die Schallstrahlen nach innen zeigen.</translation>
    </message>
    <message>
        <source>The near face is tipped: one side stands off the skin, another lies below it; turn it flush.</source>
        <translation>Die nahe Fläche ist gekippt: Eine Seite steht von der Haut ab, eine andere liegt darunter; bündig drehen.</translation>
    </message>
</context>
<context>
    <name>ew::lessons::AnswerForm</name>
    <message>
        <source>Answered by</source>
        <translation>Antwort durch</translation>
    </message>
    <message>
        <source>choosing</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>Change how a question is answered</source>
        <translation>Art der Antwort ändern</translation>
    </message>
    <message>
        <source>Add an answer</source>
        <translation>Antwort hinzufügen</translation>
    </message>
    <message>
        <source>Answer %1</source>
        <translation>Antwort %1</translation>
    </message>
    <message>
        <source>Right is</source>
        <translation>Richtig ist</translation>
    </message>
    <message>
        <source>Change the right number</source>
        <translation>Richtige Zahl ändern</translation>
    </message>
    <message>
        <source>Off by at most</source>
        <translation>Höchstens daneben</translation>
    </message>
    <message>
        <source>Change how far a number may be off</source>
        <translation>Erlaubte Abweichung einer Zahl ändern</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Change the unit of a number</source>
        <translation>Einheit einer Zahl ändern</translation>
    </message>
    <message>
        <source>right</source>
        <translation>richtig</translation>
    </message>
    <message>
        <source>Answer %1 is right</source>
        <translation>Antwort %1 ist richtig</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove answer %1</source>
        <translation>Antwort %1 entfernen</translation>
    </message>
    <message>
        <source>Change an answer</source>
        <translation>Antwort ändern</translation>
    </message>
    <message>
        <source>what can be chosen</source>
        <translation>was zur Wahl steht</translation>
    </message>
    <message>
        <source>why it is right or wrong</source>
        <translation>warum sie richtig oder falsch ist</translation>
    </message>
    <message>
        <source>Mark a right answer</source>
        <translation>Richtige Antwort kennzeichnen</translation>
    </message>
    <message>
        <source>Remove an answer</source>
        <translation>Antwort entfernen</translation>
    </message>
</context>
<context>
    <name>ew::lessons::EditorPanel</name>
    <message>
        <source>No case is open</source>
        <translation>Kein Fall ist geöffnet</translation>
    </message>
    <message>
        <source>Open a case from the start page or the File menu. Then its lessons are made here.</source>
        <translation>Einen Fall auf der Startseite oder im Menü Datei öffnen. Dann entstehen hier seine Lektionen.</translation>
    </message>
    <message>
        <source>Back to editing</source>
        <translation>Zurück zum Bearbeiten</translation>
    </message>
    <message>
        <source>Leave the trial; nothing of it is kept</source>
        <translation>Die Probe verlassen; nichts davon wird behalten</translation>
    </message>
    <message>
        <source>As a trainee sees it; nothing is kept.</source>
        <translation>Wie Lernende es sehen; nichts wird behalten.</translation>
    </message>
    <message>
        <source>The expert's scan is being recorded; stop it first.</source>
        <translation>Die Untersuchung des Experten wird gerade aufgenommen; zuerst die Aufnahme beenden.</translation>
    </message>
</context>
<context>
    <name>ew::lessons::ExpertTake</name>
    <message>
        <source>The recording of the expert's scan is paused, because another case was opened; it goes on in its own case.</source>
        <translation>Die Aufnahme der Untersuchung ruht, weil ein anderer Fall geöffnet wurde; sie geht in ihrem eigenen Fall weiter.</translation>
    </message>
    <message>
        <source>An expert's scan is being recorded and not kept yet.</source>
        <translation>Eine Untersuchung des Experten wird aufgenommen und ist noch nicht behalten.</translation>
    </message>
</context>
<context>
    <name>ew::lessons::FieldForm</name>
    <message>
        <source>%1 (not there any more)</source>
        <translation>%1 (nicht mehr vorhanden)</translation>
    </message>
</context>
<context>
    <name>ew::lessons::LessonDocument</name>
    <message>
        <source>Read</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>A text to read, perhaps with a picture</source>
        <translation>Ein Text zum Lesen, vielleicht mit einem Bild</translation>
    </message>
    <message>
        <source>Watch the expert</source>
        <translation>Dem Experten zusehen</translation>
    </message>
    <message>
        <source>Your own scan is played and rests at its marks</source>
        <translation>Die eigene Untersuchung läuft ab und hält an ihren Marken</translation>
    </message>
    <message>
        <source>Set a plane</source>
        <translation>Ebene einstellen</translation>
    </message>
    <message>
        <source>A target plane of the case is to be set</source>
        <translation>Eine Zielebene des Falls ist einzustellen</translation>
    </message>
    <message>
        <source>Sweep through</source>
        <translation>Durchfahren</translation>
    </message>
    <message>
        <source>A structure is to be seen from end to end</source>
        <translation>Eine Struktur ist von einem Ende zum anderen zu zeigen</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>A measurement that the case expects is to be taken</source>
        <translation>Eine Messung, die der Fall erwartet, ist vorzunehmen</translation>
    </message>
    <message>
        <source>Point at it</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>A point or a structure is to be clicked in the image</source>
        <translation>Ein Punkt oder eine Struktur ist im Bild anzuklicken</translation>
    </message>
    <message>
        <source>Set the machine</source>
        <translation>Gerät einstellen</translation>
    </message>
    <message>
        <source>Transducer and settings are to be right</source>
        <translation>Schallkopf und Einstellungen sollen stimmen</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>A question with answers to choose from, or a number</source>
        <translation>Eine Frage mit Antworten zur Auswahl, oder mit einer Zahl</translation>
    </message>
    <message>
        <source>Scan freely</source>
        <translation>Frei untersuchen</translation>
    </message>
    <message>
        <source>The trainee scans at will; what is to be shown is ticked off</source>
        <translation>Lernende untersuchen nach eigenem Ermessen; was zu zeigen ist, wird abgehakt</translation>
    </message>
</context>
<context>
    <name>ew::lessons::LessonPage</name>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>Back to the lessons of the case</source>
        <translation>Zurück zu den Lektionen des Falls</translation>
    </message>
    <message>
        <source>Try this lesson</source>
        <translation>Lektion erproben</translation>
    </message>
    <message>
        <source>Work through it as a trainee does; no attempt is kept</source>
        <translation>Sie durcharbeiten wie Lernende; kein Versuch wird behalten</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>A lesson is a list of steps. Add the first one.</source>
        <translation>Eine Lektion ist eine Liste von Schritten. Den ersten hinzufügen.</translation>
    </message>
    <message>
        <source>Enter edits a step, Alt+Up and Alt+Down move it, Del removes it</source>
        <translation>Eingabe bearbeitet einen Schritt, Alt+Auf und Alt+Ab verschieben ihn, Entf entfernt ihn</translation>
    </message>
    <message>
        <source>Add a step</source>
        <translation>Schritt hinzufügen</translation>
    </message>
    <message>
        <source>Behind the chosen one; choose what the trainee does</source>
        <translation>Hinter dem gewählten; auswählen, was Lernende tun</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Edit the chosen step</source>
        <translation>Den gewählten Schritt bearbeiten</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Put a copy behind the chosen step</source>
        <translation>Eine Kopie hinter den gewählten Schritt setzen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the chosen step; undo brings it back</source>
        <translation>Den gewählten Schritt entfernen; Rückgängig holt ihn zurück</translation>
    </message>
    <message>
        <source>Move the chosen step up (Alt+Up)</source>
        <translation>Den gewählten Schritt nach oben schieben (Alt+Auf)</translation>
    </message>
    <message>
        <source>Move the chosen step down (Alt+Down)</source>
        <translation>Den gewählten Schritt nach unten schieben (Alt+Ab)</translation>
    </message>
    <message>
        <source>Remove a step</source>
        <translation>Schritt entfernen</translation>
    </message>
    <message>
        <source>%1 (copy)</source>
        <translation>%1 (Kopie)</translation>
    </message>
    <message>
        <source>Duplicate a step</source>
        <translation>Schritt duplizieren</translation>
    </message>
    <message>
        <source>Move a step</source>
        <translation>Schritt verschieben</translation>
    </message>
    <message>
        <source>About the lesson</source>
        <translation>Zur Lektion</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Change a lesson's title</source>
        <translation>Titel einer Lektion ändern</translation>
    </message>
    <message>
        <source>It is read before the examination: name no finding in it.</source>
        <translation>Er wird vor der Untersuchung gelesen: keinen Befund darin nennen.</translation>
    </message>
    <message>
        <source>Aim</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Change a lesson's aim</source>
        <translation>Ziel einer Lektion ändern</translation>
    </message>
    <message>
        <source>what one can do afterwards</source>
        <translation>was man danach kann</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Change a lesson's level</source>
        <translation>Stufe einer Lektion ändern</translation>
    </message>
    <message>
        <source>Takes about</source>
        <translation>Dauert etwa</translation>
    </message>
    <message>
        <source>min</source>
        <translation>min</translation>
    </message>
    <message>
        <source>Change how long a lesson takes</source>
        <translation>Dauer einer Lektion ändern</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>Schlagwörter</translation>
    </message>
    <message>
        <source>Change a lesson's tags</source>
        <translation>Schlagwörter einer Lektion ändern</translation>
    </message>
    <message>
        <source>one a line</source>
        <translation>eines je Zeile</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>Quellen</translation>
    </message>
    <message>
        <source>Change a lesson's sources</source>
        <translation>Quellen einer Lektion ändern</translation>
    </message>
    <message>
        <source>what it teaches after, one a line</source>
        <translation>wonach sie lehrt, eine je Zeile</translation>
    </message>
    <message>
        <source>Written in</source>
        <translation>Verfasst auf</translation>
    </message>
    <message>
        <source>English</source>
        <translation>Englisch</translation>
    </message>
    <message>
        <source>German</source>
        <translation>Deutsch</translation>
    </message>
    <message>
        <source>French</source>
        <translation>Französisch</translation>
    </message>
    <message>
        <source>Spanish</source>
        <translation>Spanisch</translation>
    </message>
    <message>
        <source>Change a lesson's language</source>
        <translation>Sprache einer Lektion ändern</translation>
    </message>
    <message>
        <source>Add a step first</source>
        <translation>Zuerst einen Schritt hinzufügen</translation>
    </message>
</context>
<context>
    <name>ew::lessons::LessonsPage</name>
    <message>
        <source>From a template</source>
        <translation>Aus einer Vorlage</translation>
    </message>
    <message>
        <source>Lessons of this case</source>
        <translation>Lektionen dieses Falls</translation>
    </message>
    <message>
        <source>There is none yet. Begin with the usual outline, or with an empty lesson.</source>
        <translation>Es gibt noch keine. Mit den üblichen Schritten oder mit einer leeren Lektion beginnen.</translation>
    </message>
    <message>
        <source>Enter edits a lesson, Alt+Up and Alt+Down move it, Del removes it</source>
        <translation>Eingabe bearbeitet eine Lektion, Alt+Auf und Alt+Ab verschieben sie, Entf entfernt sie</translation>
    </message>
    <message>
        <source>New lesson</source>
        <translation>Neue Lektion</translation>
    </message>
    <message>
        <source>Make a lesson: empty, or with the steps that a lesson usually has</source>
        <translation>Eine Lektion anlegen: leer, oder mit den Schritten, die eine Lektion meist hat</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Edit the chosen lesson and its steps</source>
        <translation>Die gewählte Lektion und ihre Schritte bearbeiten</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Put a copy behind the chosen lesson</source>
        <translation>Eine Kopie hinter die gewählte Lektion setzen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the chosen lesson; undo brings it back</source>
        <translation>Die gewählte Lektion entfernen; Rückgängig holt sie zurück</translation>
    </message>
    <message>
        <source>Move the chosen lesson up (Alt+Up)</source>
        <translation>Die gewählte Lektion nach oben schieben (Alt+Auf)</translation>
    </message>
    <message>
        <source>Move the chosen lesson down (Alt+Down)</source>
        <translation>Die gewählte Lektion nach unten schieben (Alt+Ab)</translation>
    </message>
    <message>
        <source>Write what trainees read in another language</source>
        <translation>Was Lernende lesen, in einer anderen Sprache schreiben</translation>
    </message>
    <message>
        <source>Remove them</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove scans and pictures that no lesson names; undo cannot bring them back</source>
        <translation>Untersuchungen und Bilder entfernen, die keine Lektion nennt; Rückgängig holt sie nicht zurück</translation>
    </message>
    <message>
        <source>%1 (copy)</source>
        <translation>%1 (Kopie)</translation>
    </message>
    <message>
        <source>Duplicate a lesson</source>
        <translation>Lektion duplizieren</translation>
    </message>
    <message>
        <source>Remove a lesson</source>
        <translation>Lektion entfernen</translation>
    </message>
    <message>
        <source>Move a lesson</source>
        <translation>Lektion verschieben</translation>
    </message>
    <message>
        <source>Empty</source>
        <translation>Leer</translation>
    </message>
    <message>
        <source>With the usual steps</source>
        <translation>Mit den üblichen Schritten</translation>
    </message>
    <message>
        <source>Before you begin</source>
        <translation>Vor dem Beginn</translation>
    </message>
    <message>
        <source>Set up the machine</source>
        <translation>Das Gerät einstellen</translation>
    </message>
    <message>
        <source>Watch the expert</source>
        <translation>Dem Experten zusehen</translation>
    </message>
    <message>
        <source>Find the plane</source>
        <translation>Die Ebene finden</translation>
    </message>
    <message>
        <source>Sweep through the organ</source>
        <translation>Das Organ durchfahren</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>What do you see?</source>
        <translation>Was ist zu sehen?</translation>
    </message>
    <message>
        <source>Scan on your own</source>
        <translation>Selbst untersuchen</translation>
    </message>
    <message>
        <source>Add a lesson</source>
        <translation>Lektion hinzufügen</translation>
    </message>
    <message>
        <source>1 step</source>
        <translation>1 Schritt</translation>
    </message>
    <message>
        <source>%1 steps</source>
        <translation>%1 Schritte</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>1 thing missing</source>
        <translation>1 Angabe fehlt</translation>
    </message>
    <message>
        <source>%1 things missing</source>
        <translation>%1 Angaben fehlen</translation>
    </message>
    <message>
        <source>Translations…</source>
        <translation>Übersetzungen…</translation>
    </message>
    <message>
        <source>One file of the lessons, %1, is named by none of them.</source>
        <translation>Eine Datei der Lektionen, %1, wird von keiner genannt.</translation>
    </message>
    <message>
        <source>%1 files of the lessons are named by none of them.</source>
        <translation>%1 Dateien der Lektionen werden von keiner genannt.</translation>
    </message>
    <message>
        <source>Remove files</source>
        <translation>Dateien entfernen</translation>
    </message>
    <message>
        <source>Scans and pictures that no lesson names are removed from the case folder. Undoing an earlier edit cannot bring them back.</source>
        <translation>Untersuchungen und Bilder, die keine Lektion nennt, werden aus dem Ordner des Falls entfernt. Eine frühere Änderung rückgängig zu machen holt sie nicht zurück.</translation>
    </message>
    <message>
        <source>Not every file could be removed (%1).</source>
        <translation>Nicht jede Datei konnte entfernt werden (%1).</translation>
    </message>
</context>
<context>
    <name>ew::lessons::ReadForm</name>
    <message>
        <source>Choose a picture…</source>
        <translation>Bild wählen…</translation>
    </message>
    <message>
        <source>PNG or JPEG; it is kept without what is written in the file about patient, place and time</source>
        <translation>PNG oder JPEG; es wird ohne das behalten, was in der Datei über Patient, Ort und Zeit steht</translation>
    </message>
    <message>
        <source>Remove it</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>The step goes without a picture; undo brings it back</source>
        <translation>Der Schritt kommt ohne Bild aus; Rückgängig holt es zurück</translation>
    </message>
    <message>
        <source>Choose a picture</source>
        <translation>Bild wählen</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg)</source>
        <translation>Bilder (*.png *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>Remove a picture</source>
        <translation>Bild entfernen</translation>
    </message>
    <message>
        <source>No picture.</source>
        <translation>Kein Bild.</translation>
    </message>
    <message>
        <source>The picture '%1' cannot be shown.</source>
        <translation>Das Bild „%1“ kann nicht gezeigt werden.</translation>
    </message>
</context>
<context>
    <name>ew::lessons::SettingsForm</name>
    <message>
        <source>Take the present settings</source>
        <translation>Jetzige Einstellungen übernehmen</translation>
    </message>
    <message>
        <source>The transducer and the settings of the console, each within what still gives a good image</source>
        <translation>Der Schallkopf und die Einstellungen der Konsole, jede in dem Bereich, der noch ein gutes Bild gibt</translation>
    </message>
    <message>
        <source>Right transducers; none chosen: any</source>
        <translation>Richtige Schallköpfe; keiner gewählt: jeder</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>Dynamic range</source>
        <translation>Dynamikbereich</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Fokus</translation>
    </message>
    <message>
        <source>Settings that are right</source>
        <translation>Richtige Einstellungen</translation>
    </message>
    <message>
        <source>lowest that is right</source>
        <translation>kleinster richtiger Wert</translation>
    </message>
    <message>
        <source>highest that is right</source>
        <translation>größter richtiger Wert</translation>
    </message>
    <message>
        <source>%1 (not there any more)</source>
        <translation>%1 (nicht mehr vorhanden)</translation>
    </message>
    <message>
        <source>Choose the right transducers</source>
        <translation>Richtige Schallköpfe wählen</translation>
    </message>
    <message>
        <source>Choose a setting</source>
        <translation>Einstellung wählen</translation>
    </message>
    <message>
        <source>Change a range of settings</source>
        <translation>Bereich einer Einstellung ändern</translation>
    </message>
    <message>
        <source>Nothing is scanned; open a case that has a volume first.</source>
        <translation>Es wird nichts untersucht; zuerst einen Fall mit Volumen öffnen.</translation>
    </message>
</context>
<context>
    <name>ew::lessons::StepEditor</name>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Back to the steps of the lesson</source>
        <translation>Zurück zu den Schritten der Lektion</translation>
    </message>
    <message>
        <source>The step before</source>
        <translation>Der Schritt davor</translation>
    </message>
    <message>
        <source>The step after</source>
        <translation>Der Schritt danach</translation>
    </message>
    <message>
        <source>Try this step</source>
        <translation>Schritt erproben</translation>
    </message>
    <message>
        <source>Work through it as a trainee does; no attempt is kept</source>
        <translation>Sie durcharbeiten wie Lernende; kein Versuch wird behalten</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Change a step's title</source>
        <translation>Titel eines Schritts ändern</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Frage</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Was zu tun ist</translation>
    </message>
    <message>
        <source>Change what a step says</source>
        <translation>Text eines Schritts ändern</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Look for</source>
        <translation>Achten auf</translation>
    </message>
    <message>
        <source>Change what to look for</source>
        <translation>Ändern, worauf zu achten ist</translation>
    </message>
    <message>
        <source>Hints</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>Change the hints</source>
        <translation>Hinweise ändern</translation>
    </message>
    <message>
        <source>one a line, in the order in which they are asked for</source>
        <translation>einer je Zeile, in der Reihenfolge, in der nach ihnen gefragt wird</translation>
    </message>
    <message>
        <source>Judging</source>
        <translation>Beurteilung</translation>
    </message>
    <message>
        <source>Passed from</source>
        <translation>Bestanden ab</translation>
    </message>
    <message>
        <source>Change from when on a step is passed</source>
        <translation>Ändern, ab wann ein Schritt bestanden ist</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>Innerhalb von</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>any time</source>
        <translation>beliebiger Zeit</translation>
    </message>
    <message>
        <source>Change the time of a step</source>
        <translation>Zeit eines Schritts ändern</translation>
    </message>
    <message>
        <source>Said after</source>
        <translation>Danach gesagt</translation>
    </message>
    <message>
        <source>Change what is said after a step</source>
        <translation>Ändern, was nach einem Schritt gesagt wird</translation>
    </message>
    <message>
        <source>May be switched on:</source>
        <translation>Darf eingeschaltet werden:</translation>
    </message>
    <message>
        <source>Choose the aids of a step</source>
        <translation>Hilfen eines Schritts wählen</translation>
    </message>
    <message>
        <source>Say while scanning how far off one is</source>
        <translation>Beim Untersuchen sagen, wie weit man daneben ist</translation>
    </message>
    <message>
        <source>Choose whether a step gives feedback</source>
        <translation>Rückmeldung eines Schritts wählen</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>Untersucht</translation>
    </message>
    <message>
        <source>this case</source>
        <translation>diesen Fall</translation>
    </message>
    <message>
        <source>Choose which case a step scans</source>
        <translation>Wählen, welchen Fall ein Schritt untersucht</translation>
    </message>
</context>
<context>
    <name>ew::lessons::TargetForm</name>
    <message>
        <source>Choose…</source>
        <translation>Auswählen…</translation>
    </message>
    <message>
        <source>Choose a target</source>
        <translation>Ziel wählen</translation>
    </message>
    <message>
        <source>Change a tolerance</source>
        <translation>Toleranz ändern</translation>
    </message>
    <message>
        <source>At least</source>
        <translation>Mindestens</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Change how long is scanned</source>
        <translation>Dauer der Untersuchung ändern</translation>
    </message>
    <message>
        <source>To be shown meanwhile:</source>
        <translation>Dabei zu zeigen:</translation>
    </message>
    <message>
        <source>The case has neither planes nor structures; make them on the page Targets.</source>
        <translation>Der Fall hat weder Ebenen noch Strukturen; sie auf der Seite Ziele anlegen.</translation>
    </message>
    <message>
        <source>%1 (not there any more)</source>
        <translation>%1 (nicht mehr vorhanden)</translation>
    </message>
    <message>
        <source>Choose what is to be shown</source>
        <translation>Wählen, was zu zeigen ist</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>The case has no planes</source>
        <translation>Der Fall hat keine Ebenen</translation>
    </message>
    <message>
        <source>as the plane says</source>
        <translation>wie die Ebene sagt</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>Innerhalb von</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>and within</source>
        <translation>und innerhalb von</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>The case has no structures</source>
        <translation>Der Fall hat keine Strukturen</translation>
    </message>
    <message>
        <source>To be seen</source>
        <translation>Zu zeigen</translation>
    </message>
    <message>
        <source>Change how much is to be seen</source>
        <translation>Ändern, wie viel zu zeigen ist</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>The case expects none</source>
        <translation>Der Fall erwartet keine</translation>
    </message>
    <message>
        <source>Choose a measurement</source>
        <translation>Messung wählen</translation>
    </message>
    <message>
        <source>Off by at most</source>
        <translation>Höchstens daneben</translation>
    </message>
    <message>
        <source>as the case says</source>
        <translation>wie der Fall sagt</translation>
    </message>
    <message>
        <source>In the unit of the measurement.</source>
        <translation>In der Einheit der Messung.</translation>
    </message>
    <message>
        <source>Point or structure</source>
        <translation>Punkt oder Struktur</translation>
    </message>
    <message>
        <source>The case has neither</source>
        <translation>Der Fall hat beides nicht</translation>
    </message>
</context>
<context>
    <name>ew::lessons::TimeLine</name>
    <message>
        <source>Drag the ends to show a part, drag marks to move them, click to look. Keys: arrows, Home, End, [ and ]</source>
        <translation>Die Enden ziehen, um einen Teil zu zeigen, Marken ziehen, um sie zu verschieben, klicken, um hinzusehen. Tasten: Pfeile, Pos1, Ende, [ und ]</translation>
    </message>
    <message>
        <source>The recording along its time</source>
        <translation>Die Aufnahme entlang ihrer Zeit</translation>
    </message>
</context>
<context>
    <name>ew::lessons::WatchForm</name>
    <message>
        <source>The expert's scan</source>
        <translation>Die Untersuchung des Experten</translation>
    </message>
    <message>
        <source>Then scan as the trainee is to see it, with mouse or keys</source>
        <translation>Dann so untersuchen, wie Lernende es sehen sollen, mit Maus oder Tasten</translation>
    </message>
    <message>
        <source>Choose a recording…</source>
        <translation>Aufnahme wählen…</translation>
    </message>
    <message>
        <source>One that was saved from this body before (.seq.mha)</source>
        <translation>Eine, die von diesem Körper schon gespeichert ist (.seq.mha)</translation>
    </message>
    <message>
        <source>Choose a recording</source>
        <translation>Aufnahme wählen</translation>
    </message>
    <message>
        <source>Recordings of a scan (*.seq.mha *.igs.mha *.mha)</source>
        <translation>Aufnahmen einer Untersuchung (*.seq.mha *.igs.mha *.mha)</translation>
    </message>
    <message>
        <source>The recording is as long as it may be, %1 min; stop it here.</source>
        <translation>Die Aufnahme ist so lang, wie sie sein darf, %1 min; sie hier beenden.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>End the recording and keep it in the case</source>
        <translation>Die Aufnahme beenden und im Fall behalten</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>End the recording without keeping it</source>
        <translation>Die Aufnahme beenden, ohne sie zu behalten</translation>
    </message>
    <message>
        <source>Mark this moment</source>
        <translation>Diesen Moment markieren</translation>
    </message>
    <message>
        <source>It is described afterwards; the trainee's view rests there</source>
        <translation>Er wird danach beschrieben; die Sicht der Lernenden hält dort an</translation>
    </message>
    <message>
        <source>Keeping the recording…</source>
        <translation>Die Aufnahme wird behalten…</translation>
    </message>
    <message>
        <source>Keeping the expert's scan</source>
        <translation>Untersuchung des Experten behalten</translation>
    </message>
    <message>
        <source>Record the expert's scan</source>
        <translation>Untersuchung des Experten aufnehmen</translation>
    </message>
    <message>
        <source>Mark %1</source>
        <translation>Marke %1</translation>
    </message>
    <message>
        <source>Paused at %1 of at most %2</source>
        <translation>Pause bei %1 von höchstens %2</translation>
    </message>
    <message>
        <source>● Recording: %1 of at most %2</source>
        <translation>● Aufnahme: %1 von höchstens %2</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Mark this moment (%1)</source>
        <translation>Diesen Moment markieren (%1)</translation>
    </message>
    <message>
        <source>Record here</source>
        <translation>Hier aufnehmen</translation>
    </message>
    <message>
        <source>Record again</source>
        <translation>Neu aufnehmen</translation>
    </message>
    <message>
        <source>Another step's scan is being recorded; end that first.</source>
        <translation>Für einen anderen Schritt wird gerade aufgenommen; zuerst diese Aufnahme beenden.</translation>
    </message>
    <message>
        <source>Scan now, as the trainee is to see it.</source>
        <translation>Jetzt so untersuchen, wie Lernende es sehen sollen.</translation>
    </message>
    <message>
        <source>Nothing is recorded yet.</source>
        <translation>Noch ist nichts aufgenommen.</translation>
    </message>
    <message>
        <source>This step scans another case. Record the scan there, save it, and choose it here.</source>
        <translation>Dieser Schritt untersucht einen anderen Fall. Dort aufnehmen, speichern und die Aufnahme hier wählen.</translation>
    </message>
    <message>
        <source>Reading the expert's scan</source>
        <translation>Untersuchung des Experten lesen</translation>
    </message>
    <message>
        <source>%1 recorded, %2 images; trainees see %3.</source>
        <translation>%1 aufgenommen, %2 Bilder; Lernende sehen %3.</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Play the part that trainees see; the probe follows it</source>
        <translation>Den Teil abspielen, den Lernende sehen; der Schallkopf folgt ihm</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Begin here</source>
        <translation>Hier beginnen</translation>
    </message>
    <message>
        <source>Trainees see the scan from here on ([)</source>
        <translation>Lernende sehen die Untersuchung von hier an ([)</translation>
    </message>
    <message>
        <source>End here</source>
        <translation>Hier enden</translation>
    </message>
    <message>
        <source>Trainees see the scan up to here (])</source>
        <translation>Lernende sehen die Untersuchung bis hierher (])</translation>
    </message>
    <message>
        <source>Marks: the trainee's view rests there and shows the sentence.</source>
        <translation>Marken: Die Sicht der Lernenden hält dort an und zeigt den Satz.</translation>
    </message>
    <message>
        <source>Put a mark where the time line stands</source>
        <translation>Eine Marke setzen, wo die Zeitleiste steht</translation>
    </message>
    <message>
        <source>Move a mark</source>
        <translation>Marke verschieben</translation>
    </message>
    <message>
        <source>Look at this moment</source>
        <translation>Diesen Moment ansehen</translation>
    </message>
    <message>
        <source>Move here</source>
        <translation>Hierher</translation>
    </message>
    <message>
        <source>Move the mark to where the time line stands</source>
        <translation>Die Marke dorthin verschieben, wo die Zeitleiste steht</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove this mark</source>
        <translation>Diese Marke entfernen</translation>
    </message>
    <message>
        <source>Change a mark</source>
        <translation>Marke ändern</translation>
    </message>
    <message>
        <source>Remove a mark</source>
        <translation>Marke entfernen</translation>
    </message>
    <message>
        <source>Rest</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Choose the part that is shown</source>
        <translation>Gezeigten Teil wählen</translation>
    </message>
    <message>
        <source>Mark a moment</source>
        <translation>Moment markieren</translation>
    </message>
</context>
<context>
    <name>ew::lessons::WordsPage</name>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>Back to the lessons of the case</source>
        <translation>Zurück zu den Lektionen des Falls</translation>
    </message>
    <message>
        <source>Language of the translation</source>
        <translation>Sprache der Übersetzung</translation>
    </message>
    <message>
        <source>German</source>
        <translation>Deutsch</translation>
    </message>
    <message>
        <source>English</source>
        <translation>Englisch</translation>
    </message>
    <message>
        <source>French</source>
        <translation>Französisch</translation>
    </message>
    <message>
        <source>Spanish</source>
        <translation>Spanisch</translation>
    </message>
    <message>
        <source>Translations</source>
        <translation>Übersetzungen</translation>
    </message>
    <message>
        <source>Only texts that have none yet</source>
        <translation>Nur Texte, die noch keine haben</translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>what is shown in its place</source>
        <translation>was an seiner Stelle gezeigt wird</translation>
    </message>
    <message>
        <source>Translation</source>
        <translation>Übersetzung</translation>
    </message>
    <message>
        <source>Keep and go to the next</source>
        <translation>Behalten und weiter</translation>
    </message>
    <message>
        <source>Written into the case folder at once</source>
        <translation>Wird sofort in den Ordner des Falls geschrieben</translation>
    </message>
    <message>
        <source>Every text has a translation.</source>
        <translation>Jeder Text hat eine Übersetzung.</translation>
    </message>
    <message>
        <source>%1 of %2 texts have none yet.</source>
        <translation>%1 von %2 Texten haben noch keine.</translation>
    </message>
</context>
<context>
    <name>ew::ui::Tour</name>
    <message>
        <source>Tour</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
    <message>
        <source>Leave the tour (Escape). Help, Tour begins it again.</source>
        <translation>Den Rundgang verlassen (Esc). Hilfe, Rundgang beginnt ihn wieder.</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
</context>
<context>
    <name>ew::case_authoring::PaintWork</name>
    <message>
        <source>What was painted is not kept in the case yet.</source>
        <translation>Das Gemalte ist noch nicht im Fall aufgehoben.</translation>
    </message>
    <message>
        <source>The volume of this case is not what is scanned at the moment; choose View, Scan the case&apos;s volume.</source>
        <translation>Das Volumen dieses Falls ist nicht das, was gerade geschallt wird; Ansicht, Volumen des Falls schallen wählen.</translation>
    </message>
    <message>
        <source>Click inside the structure; it grows from there to its edges. Escape ends.</source>
        <translation>In die Struktur klicken; sie wächst von dort bis zu ihren Rändern. Escape beendet.</translation>
    </message>
    <message>
        <source>Draw around the structure with the button held. The wheel still moves the probe. Escape ends.</source>
        <translation>Die Struktur mit gehaltener Taste umfahren. Das Rad bewegt weiter den Schallkopf. Escape beendet.</translation>
    </message>
    <message>
        <source>Erase with the button held. The wheel still moves the probe. Escape ends.</source>
        <translation>Mit gehaltener Taste löschen. Das Rad bewegt weiter den Schallkopf. Escape beendet.</translation>
    </message>
    <message>
        <source>Paint with the button held. The wheel still moves the probe. Escape ends.</source>
        <translation>Mit gehaltener Taste malen. Das Rad bewegt weiter den Schallkopf. Escape beendet.</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Malen</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Umfahren</translation>
    </message>
    <message>
        <source>Growing the structure</source>
        <translation>Struktur wächst</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>Wachsen lassen</translation>
    </message>
    <message>
        <source>%1 ml grew, up to the farthest distance; it may go on beyond it.</source>
        <translation>%1 ml sind gewachsen, bis zur größten Entfernung; dahinter kann es weitergehen.</translation>
    </message>
    <message>
        <source>More than %1 ml are like this place, so it would have run out of the structure; nothing was labelled. Click elsewhere, allow more, or paint a border first.</source>
        <translation>Mehr als %1 ml gleichen dieser Stelle, es wäre also aus der Struktur ausgelaufen; nichts wurde markiert. Anderswo klicken, mehr zulassen oder erst eine Grenze malen.</translation>
    </message>
    <message>
        <source>Nothing grows from here: the place is an edge, or no echo was recorded there. Click inside the structure.</source>
        <translation>Von hier wächst nichts: Die Stelle ist ein Rand, oder dort wurde kein Echo aufgenommen. In die Struktur klicken.</translation>
    </message>
    <message>
        <source>Fill between outlines</source>
        <translation>Zwischen Umrissen füllen</translation>
    </message>
    <message>
        <source>Keep the largest piece</source>
        <translation>Größtes Stück behalten</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Keeping what is painted</source>
        <translation>Gemaltes wird gesichert</translation>
    </message>
    <message>
        <source>Keeping the structures in the case</source>
        <translation>Strukturen werden im Fall aufgehoben</translation>
    </message>
    <message>
        <source>Paint structures</source>
        <translation>Strukturen malen</translation>
    </message>
    <message>
        <source>Preparing labels</source>
        <translation>Markierungen werden vorbereitet</translation>
    </message>
    <message>
        <source>What was painted was not kept in its case; it is offered when that is opened again.</source>
        <translation>Das Gemalte wurde nicht in seinem Fall aufgehoben; es wird angeboten, wenn der Fall wieder geöffnet wird.</translation>
    </message>
    <message>
        <source>Remove the structure</source>
        <translation>Struktur entfernen</translation>
    </message>
    <message>
        <source>Removing the structure</source>
        <translation>Struktur wird entfernt</translation>
    </message>
</context>
<context>
    <name>ew::case_authoring::StructurePage</name>
    <message>
        <source>An organ of the virtual patient:</source>
        <translation>Ein Organ des virtuellen Patienten:</translation>
    </message>
    <message>
        <source>Organ</source>
        <translation>Organ</translation>
    </message>
    <message>
        <source>Choose the organ</source>
        <translation>Organ wählen</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Malen</translation>
    </message>
    <message>
        <source>Paint the structure into the scan with the button held</source>
        <translation>Die Struktur mit gehaltener Taste ins Schallbild malen</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Take voxels out of the structure</source>
        <translation>Voxel aus der Struktur nehmen</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Umfahren</translation>
    </message>
    <message>
        <source>Draw around the structure in several image planes; what lies between is filled</source>
        <translation>Die Struktur in mehreren Bildebenen umfahren; was dazwischen liegt, wird gefüllt</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>Wachsen lassen</translation>
    </message>
    <message>
        <source>Click inside; the structure grows to where its echoes end</source>
        <translation>Hineinklicken; die Struktur wächst, bis ihre Echos enden</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>a ball</source>
        <translation>eine Kugel</translation>
    </message>
    <message>
        <source>flat, in the image plane</source>
        <translation>flach, in der Bildebene</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>At most from the click</source>
        <translation>Höchstens vom Klick</translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Höchstens</translation>
    </message>
    <message>
        <source>Leave other structures as they are</source>
        <translation>Andere Strukturen lassen, wie sie sind</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>What the structure consists of: stone, bone and gas throw shadows, fluid brightens what lies behind it</source>
        <translation>Woraus die Struktur besteht: Stein, Knochen und Gas werfen Schatten, Flüssigkeit hellt auf, was dahinter liegt</translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>Choose the tissue</source>
        <translation>Gewebe wählen</translation>
    </message>
    <message>
        <source>Fill between the outlines that were traced in several image planes</source>
        <translation>Zwischen den Umrissen füllen, die in mehreren Bildebenen gezogen wurden</translation>
    </message>
    <message>
        <source>Largest piece</source>
        <translation>Größtes Stück</translation>
    </message>
    <message>
        <source>Keep the largest connected piece of the structure alone</source>
        <translation>Nur das größte zusammenhängende Stück der Struktur behalten</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Round the structure off</source>
        <translation>Die Struktur abrunden</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Give up everything that was painted since it was kept last</source>
        <translation>Alles aufgeben, was seit dem letzten Aufheben gemalt wurde</translation>
    </message>
    <message>
        <source>Keep in the case</source>
        <translation>Im Fall aufheben</translation>
    </message>
    <message>
        <source>Put what was painted into the case, as one step that can be undone</source>
        <translation>Das Gemalte in den Fall übernehmen, als ein Schritt, der sich zurücknehmen lässt</translation>
    </message>
    <message>
        <source>Choose an organ</source>
        <translation>Ein Organ wählen</translation>
    </message>
    <message>
        <source>numbers of its own</source>
        <translation>eigene Zahlen</translation>
    </message>
    <message>
        <source>Label %1, %2 ml</source>
        <translation>Markierung %1, %2 ml</translation>
    </message>
    <message>
        <source>Label %1, nothing is labelled yet: choose a tool and work in the scan.</source>
        <translation>Markierung %1, noch ist nichts markiert: ein Werkzeug wählen und im Schallbild arbeiten.</translation>
    </message>
    <message>
        <source>Fill between %1 outlines</source>
        <translation>Zwischen %1 Umrissen füllen</translation>
    </message>
    <message>
        <source>No stroke to take back</source>
        <translation>Kein Strich, der zurückzunehmen wäre</translation>
    </message>
    <message>
        <source>Take back: %1 (Ctrl+Z)</source>
        <translation>Zurücknehmen: %1 (Strg+Z)</translation>
    </message>
    <message>
        <source>No stroke to bring back</source>
        <translation>Kein Strich, der wiederzuholen wäre</translation>
    </message>
    <message>
        <source>Bring back: %1 (Ctrl+Shift+Z)</source>
        <translation>Wiederholen: %1 (Strg+Umschalt+Z)</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>Es wird gearbeitet …</translation>
    </message>
    <message>
        <source>● painted, not kept in the case yet</source>
        <translation>● gemalt, noch nicht im Fall aufgehoben</translation>
    </message>
    <message>
        <source>The case holds what is shown.</source>
        <translation>Der Fall enthält, was zu sehen ist.</translation>
    </message>
    <message>
        <source>Fill between outlines</source>
        <translation>Zwischen Umrissen füllen</translation>
    </message>
    <message>
        <source>Draw around the structure in two image planes at least; then the shape between them can be filled</source>
        <translation>Die Struktur in mindestens zwei Bildebenen umfahren; dann lässt sich die Form dazwischen füllen</translation>
    </message>
</context>
<context>
    <name>ew::case_authoring::PointPage</name>
    <message>
        <source>Click in the scan</source>
        <translation>Ins Schallbild klicken</translation>
    </message>
    <message>
        <source>The next clicks into the image put the point there</source>
        <translation>Die nächsten Klicks ins Bild setzen den Punkt dorthin</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Near enough</source>
        <translation>Nah genug</translation>
    </message>
    <message>
        <source>Change the tolerance</source>
        <translation>Toleranz ändern</translation>
    </message>
    <message>
        <source>At %1, %2, %3 mm of the volume</source>
        <translation>Bei %1, %2, %3 mm im Volumen</translation>
    </message>
    <message>
        <source>It lies nowhere yet: click it in the scan.</source>
        <translation>Er liegt noch nirgends: ihn ins Schallbild klicken.</translation>
    </message>
    <message>
        <source>Click the point. Arrows and Enter do the same, Escape ends.</source>
        <translation>Auf den Punkt klicken. Pfeile und Eingabetaste tun dasselbe, Escape beendet.</translation>
    </message>
    <message>
        <source>Move the point</source>
        <translation>Punkt verschieben</translation>
    </message>
</context>
<context>
    <name>ew::case_authoring::PlanePage</name>
    <message>
        <source>Use the present image plane</source>
        <translation>Die jetzige Bildebene nehmen</translation>
    </message>
    <message>
        <source>The plane becomes the one that the probe images now</source>
        <translation>Die Ebene wird die, die der Schallkopf jetzt abbildet</translation>
    </message>
    <message>
        <source>The volume of this case is not what is scanned at the moment; choose View, Scan the case&apos;s volume.</source>
        <translation>Das Volumen dieses Falls ist nicht das, was gerade geschallt wird; Ansicht, Volumen des Falls schallen wählen.</translation>
    </message>
    <message>
        <source>Take the plane</source>
        <translation>Ebene übernehmen</translation>
    </message>
    <message>
        <source>Go there</source>
        <translation>Dorthin gehen</translation>
    </message>
    <message>
        <source>Put the probe where the plane was taken</source>
        <translation>Den Schallkopf dorthin setzen, wo die Ebene aufgenommen wurde</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>Höchstens entfernt</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Tilted at most</source>
        <translation>Höchstens gekippt</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Change the tolerance</source>
        <translation>Toleranz ändern</translation>
    </message>
    <message>
        <source>The patient&apos;s own plane of this name is kept by the patient</source>
        <translation>Die eigene Ebene des Patienten mit diesem Namen kennt der Patient</translation>
    </message>
    <message>
        <source>The standard plane of that name, as the patient has it.</source>
        <translation>Die Standardebene dieses Namens, wie der Patient sie hat.</translation>
    </message>
    <message>
        <source>%1 mm and %2° away</source>
        <translation>%1 mm und %2° entfernt</translation>
    </message>
    <message>
        <source>%1: within the tolerance</source>
        <translation>%1: innerhalb der Toleranz</translation>
    </message>
</context>
<context>
    <name>ew::case_authoring::TargetsPanel</name>
    <message>
        <source>No case is open</source>
        <translation>Kein Fall ist offen</translation>
    </message>
    <message>
        <source>Open a case from the start page or the File menu. Then what a trainee is to find in it can be pointed out here.</source>
        <translation>Einen Fall von der Startseite oder aus dem Menü Datei öffnen. Dann lässt sich hier zeigen, was Lernende darin finden sollen.</translation>
    </message>
    <message>
        <source>Something was painted in this case before, and not kept in it.</source>
        <translation>In diesem Fall wurde schon etwas gemalt und nicht aufgehoben.</translation>
    </message>
    <message>
        <source>Go on with it</source>
        <translation>Damit weitermachen</translation>
    </message>
    <message>
        <source>Show what was painted; it is kept in the case when you say so</source>
        <translation>Das Gemalte zeigen; in den Fall kommt es erst mit „Im Fall aufheben“</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Give up what was painted then</source>
        <translation>Das damals Gemalte aufgeben</translation>
    </message>
    <message>
        <source>What is to be found</source>
        <translation>Was zu finden ist</translation>
    </message>
    <message>
        <source>Nothing yet. Put the probe where something is to be seen, then add a point, a plane or a structure.</source>
        <translation>Noch nichts. Den Schallkopf dorthin halten, wo etwas zu sehen ist, dann einen Punkt, eine Ebene oder eine Struktur hinzufügen.</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Ziele</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Add a point, in the middle of the image</source>
        <translation>Einen Punkt hinzufügen, in der Mitte des Bildes</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Add the present image plane</source>
        <translation>Die jetzige Bildebene hinzufügen</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>Add a structure, which is painted or grown in the scan</source>
        <translation>Eine Struktur hinzufügen, die im Schallbild gemalt wird oder wächst</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Move the target up</source>
        <translation>Ziel nach oben</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Move the target down</source>
        <translation>Ziel nach unten</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the target</source>
        <translation>Ziel entfernen</translation>
    </message>
    <message>
        <source>Name of the target</source>
        <translation>Name des Ziels</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Its name gives the finding away</source>
        <translation>Der Name verrät den Befund</translation>
    </message>
    <message>
        <source>A trainee sees it with the findings, not before</source>
        <translation>Lernende sehen es mit den Befunden, nicht vorher</translation>
    </message>
    <message>
        <source>Change what gives the finding away</source>
        <translation>Ändern, was den Befund verrät</translation>
    </message>
    <message>
        <source>The volume of this case is not what is scanned at the moment; choose View, Scan the case&apos;s volume.</source>
        <translation>Das Volumen dieses Falls ist nicht das, was gerade geschallt wird; Ansicht, Volumen des Falls schallen wählen.</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>Punkt hinzufügen</translation>
    </message>
    <message>
        <source>Add a plane</source>
        <translation>Ebene hinzufügen</translation>
    </message>
    <message>
        <source>The patient&apos;s organs are known once the volume is scanned; choose View, Scan the case&apos;s volume.</source>
        <translation>Die Organe des Patienten sind bekannt, sobald das Volumen geschallt wird; Ansicht, Volumen des Falls schallen wählen.</translation>
    </message>
    <message>
        <source>Add a structure</source>
        <translation>Struktur hinzufügen</translation>
    </message>
    <message>
        <source>All 255 labels are taken; remove a structure first.</source>
        <translation>Alle 255 Markierungen sind vergeben; zuerst eine Struktur entfernen.</translation>
    </message>
    <message>
        <source>Move the target</source>
        <translation>Ziel verschieben</translation>
    </message>
    <message>
        <source>A target needs a name.</source>
        <translation>Ein Ziel braucht einen Namen.</translation>
    </message>
    <message>
        <source>Rename the target</source>
        <translation>Ziel umbenennen</translation>
    </message>
    <message>
        <source>point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>Steps of lessons that ask for it: %1. They follow when it is renamed.</source>
        <translation>Schritte von Lektionen, die danach fragen: %1. Beim Umbenennen ziehen sie mit.</translation>
    </message>
    <message>
        <source>+ Point</source>
        <translation>+ Punkt</translation>
    </message>
    <message>
        <source>+ Plane</source>
        <translation>+ Ebene</translation>
    </message>
    <message>
        <source>+ Structure</source>
        <translation>+ Struktur</translation>
    </message>
</context>
<context>
    <name>ew::case_authoring::NamedTissue</name>
    <message>
        <source>Soft tissue</source>
        <translation>Weichgewebe</translation>
    </message>
    <message>
        <source>Fluid (bile, urine)</source>
        <translation>Flüssigkeit (Galle, Urin)</translation>
    </message>
    <message>
        <source>Blood</source>
        <translation>Blut</translation>
    </message>
    <message>
        <source>Fat</source>
        <translation>Fett</translation>
    </message>
    <message>
        <source>Muscle</source>
        <translation>Muskel</translation>
    </message>
    <message>
        <source>Stone</source>
        <translation>Stein</translation>
    </message>
    <message>
        <source>Calcification</source>
        <translation>Verkalkung</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Gas</source>
        <translation>Gas</translation>
    </message>
</context>
<context>
    <name>ew::case_authoring::Section</name>
    <message>
        <source>complete</source>
        <translation>vollständig</translation>
    </message>
    <message>
        <source>1 missing</source>
        <translation>1 fehlt</translation>
    </message>
    <message>
        <source>%1 missing</source>
        <translation>%1 fehlen</translation>
    </message>
    <message>
        <source>Before the case can be published: %1</source>
        <translation>Bevor der Fall veröffentlicht werden kann: %1</translation>
    </message>
</context>
<context>
    <name>ew::case_authoring::RightsForm</name>
    <message>
        <source>Recording</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>Whom to name, and under which licence it may be passed on. Needed before the case is published.</source>
        <translation>Wer zu nennen ist und unter welcher Lizenz sie weitergegeben werden darf. Nötig, bevor der Fall veröffentlicht wird.</translation>
    </message>
    <message>
        <source>Attribution</source>
        <translation>Nennung</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>Lizenz</translation>
    </message>
</context>
<context>
    <name>ew::case_authoring::SourceField</name>
    <message>
        <source>A volume</source>
        <translation>Ein Volumen</translation>
    </message>
    <message>
        <source>MetaImage, NRRD, NIfTI, DICOM or a Kretz file.</source>
        <translation>MetaImage, NRRD, NIfTI, DICOM oder eine Kretz-Datei.</translation>
    </message>
    <message>
        <source>A recorded sweep</source>
        <translation>Ein aufgenommener Schwenk</translation>
    </message>
    <message>
        <source>Images with the probe&apos;s poses; the volume is made from them.</source>
        <translation>Bilder mit den Lagen der Sonde; daraus wird das Volumen gemacht.</translation>
    </message>
    <message>
        <source>A stitched result</source>
        <translation>Ein verbundenes Ergebnis</translation>
    </message>
    <message>
        <source>A project of the Stitching panel, or the folder it was saved to.</source>
        <translation>Ein Projekt aus „Verbinden“ oder der Ordner, in den es gespeichert wurde.</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Noch nichts</translation>
    </message>
    <message>
        <source>Texts and lessons first; the volume can be given later.</source>
        <translation>Erst Texte und Lektionen; das Volumen kann später gegeben werden.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>no file chosen</source>
        <translation>keine Datei gewählt</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Spacing of the volume</source>
        <translation>Abstand im Volumen</translation>
    </message>
    <message>
        <source>as fine as the images</source>
        <translation>so fein wie die Bilder</translation>
    </message>
    <message>
        <source>Choose a stitched result</source>
        <translation>Ein verbundenes Ergebnis wählen</translation>
    </message>
    <message>
        <source>Stitch projects and results (*.json volume.mha);;All files (*)</source>
        <translation>Projekte und Ergebnisse (*.json volume.mha);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Choose a volume or a sweep</source>
        <translation>Ein Volumen oder einen Schwenk wählen</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Leave out what lies around the fan</source>
        <translation>Weglassen, was um den Fächer liegt</translation>
    </message>
    <message>
        <source>Where the recording does not say it, the fan is found in its images. Without this the black around it counts as tissue without echoes.</source>
        <translation>Wo die Aufnahme ihn nicht nennt, wird der Fächer in ihren Bildern gefunden. Ohne dies gilt das Schwarz um ihn als Gewebe ohne Echos.</translation>
    </message>
</context>
<context>
    <name>ew::case_authoring::NewCaseDialog</name>
    <message>
        <source>about %1 s</source>
        <translation>etwa %1 s</translation>
    </message>
    <message>
        <source>about %1 min</source>
        <translation>etwa %1 min</translation>
    </message>
    <message>
        <source>New case</source>
        <translation>Neuer Fall</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>for authors; may name the finding</source>
        <translation>für Autoren; darf den Befund nennen</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>gives no finding away; can be written later</source>
        <translation>verrät keinen Befund; kann später geschrieben werden</translation>
    </message>
    <message>
        <source>For trainees</source>
        <translation>Für Lernende</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Region</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Folder of your own cases</source>
        <translation>Ordner der eigenen Fälle</translation>
    </message>
    <message>
        <source>Name of the new folder</source>
        <translation>Name des neuen Ordners</translation>
    </message>
    <message>
        <source>What will be made</source>
        <translation>Was gemacht wird</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>What the case is made from</source>
        <translation>Woraus der Fall gemacht wird</translation>
    </message>
    <message>
        <source>What it is about</source>
        <translation>Worum es geht</translation>
    </message>
    <message>
        <source>Where it is kept</source>
        <translation>Wo er liegt</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 von %2: %3</translation>
    </message>
    <message>
        <source>Make the case</source>
        <translation>Fall anlegen</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>This file cannot become a case.</source>
        <translation>Aus dieser Datei kann kein Fall werden.</translation>
    </message>
    <message>
        <source>Give the case a title.</source>
        <translation>Dem Fall einen Titel geben.</translation>
    </message>
    <message>
        <source>Choose the folder of your own cases.</source>
        <translation>Den Ordner der eigenen Fälle wählen.</translation>
    </message>
    <message>
        <source>Type a name for the new folder, without &apos;/&apos; and not beginning with &apos;.&apos;.</source>
        <translation>Einen Namen für den neuen Ordner eingeben, ohne „/“ und nicht mit „.“ am Anfang.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is there already, and nothing in it is replaced; type another name.</source>
        <translation>„%1“ gibt es schon, und nichts darin wird ersetzt; einen anderen Namen eingeben.</translation>
    </message>
    <message>
        <source>An empty form.</source>
        <translation>Ein leeres Formular.</translation>
    </message>
    <message>
        <source>The file is being looked at.</source>
        <translation>Die Datei wird angesehen.</translation>
    </message>
    <message>
        <source>Looking at what the case needs</source>
        <translation>Ansehen, was der Fall braucht</translation>
    </message>
    <message>
        <source>A case without a volume. It opens, and says how to give it one.</source>
        <translation>Ein Fall ohne Volumen. Er öffnet sich und sagt, wie er eines bekommt.</translation>
    </message>
    <message>
        <source>A volume of %1 × %2 × %3 voxels, %4 × %5 × %6 mm each.</source>
        <translation>Ein Volumen von %1 × %2 × %3 Voxeln, je %4 × %5 × %6 mm.</translation>
    </message>
    <message>
        <source>A volume that is stitched first; its size shows then.</source>
        <translation>Ein Volumen, das erst verbunden wird; seine Größe zeigt sich dann.</translation>
    </message>
    <message>
        <source>Memory: %1
Disk: at most %2
Time: %3</source>
        <translation>Speicher: %1
Platte: höchstens %2
Zeit: %3</translation>
    </message>
    <message>
        <source>Making the case %1</source>
        <translation>Fall %1 wird angelegt</translation>
    </message>
</context>
<context>
    <name>ew::case_authoring::GiveVolumeDialog</name>
    <message>
        <source>Another volume for the case</source>
        <translation>Ein anderes Volumen für den Fall</translation>
    </message>
    <message>
        <source>Give the case a volume</source>
        <translation>Dem Fall ein Volumen geben</translation>
    </message>
    <message>
        <source>The volume keeps its place in the body. Targets and measurements that only the present volume knows are left out; undo brings everything back.</source>
        <translation>Das Volumen behält seinen Platz im Körper. Ziele und Messungen, die nur das jetzige Volumen kennt, fallen weg; Rückgängig bringt alles zurück.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Replace the volume</source>
        <translation>Volumen ersetzen</translation>
    </message>
    <message>
        <source>Give the volume</source>
        <translation>Volumen geben</translation>
    </message>
    <message>
        <source>Putting the volume into the case</source>
        <translation>Volumen wird in den Fall gelegt</translation>
    </message>
    <message>
        <source>Left out with the old volume: targets %1, measurements %2.</source>
        <translation>Mit dem alten Volumen weggefallen: Ziele %1, Messungen %2.</translation>
    </message>
</context>
<context>
    <name>ew::case_authoring::PicturesField</name>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>Take this picture out of the case</source>
        <translation>Dieses Bild aus dem Fall nehmen</translation>
    </message>
    <message>
        <source>Add pictures…</source>
        <translation>Bilder hinzufügen…</translation>
    </message>
    <message>
        <source>PNG or JPEG; kept without what their files say of patient and device. Look that no name stands in the picture itself.</source>
        <translation>PNG oder JPEG; ohne das, was ihre Dateien über Patient und Gerät sagen. Darauf achten, dass im Bild selbst kein Name steht.</translation>
    </message>
</context>
<context>
    <name>ew::case_authoring::MeasurementsField</name>
    <message>
        <source>Add a measurement</source>
        <translation>Messung hinzufügen</translation>
    </message>
    <message>
        <source>measurement %1</source>
        <translation>Messung %1</translation>
    </message>
    <message>
        <source>what is measured</source>
        <translation>was gemessen wird</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>known by the patient</source>
        <translation>kennt der Patient</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>circumference</source>
        <translation>Umfang</translation>
    </message>
    <message>
        <source>area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>The value is the virtual patient&apos;s; choose a kind to give one</source>
        <translation>Der Wert ist der des virtuellen Patienten; eine Art wählen, um einen anzugeben</translation>
    </message>
    <message>
        <source>Take caliper</source>
        <translation>Messung holen</translation>
    </message>
    <message>
        <source>Take the caliper I have drawn: value, kind and where it stands</source>
        <translation>Die gezeichnete Messung übernehmen: Wert, Art und wo sie steht</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>usual tolerance</source>
        <translation>übliche Toleranz</translation>
    </message>
    <message>
        <source>Gives the finding away</source>
        <translation>Verrät den Befund</translation>
    </message>
    <message>
        <source>A trainee sees the name with the findings only</source>
        <translation>Lernende sehen den Namen erst mit den Befunden</translation>
    </message>
</context>
<context>
    <name>ew::case_authoring::PublishDialog</name>
    <message>
        <source>Publish the case</source>
        <translation>Fall veröffentlichen</translation>
    </message>
    <message>
        <source>A click on a line leads to where it is written.</source>
        <translation>Ein Klick auf eine Zeile führt dorthin, wo es steht.</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Write the case into one file, for another workstation</source>
        <translation>Den Fall in eine Datei schreiben, für einen anderen Arbeitsplatz</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Publish</source>
        <translation>Veröffentlichen</translation>
    </message>
    <message>
        <source>The case is being checked.</source>
        <translation>Der Fall wird geprüft.</translation>
    </message>
    <message>
        <source>Checking the case</source>
        <translation>Fall wird geprüft</translation>
    </message>
    <message>
        <source>Missing: %1   To look at: %2</source>
        <translation>Fehlt: %1   Anzusehen: %2</translation>
    </message>
    <message>
        <source>Can be published. To look at: %1</source>
        <translation>Kann veröffentlicht werden. Anzusehen: %1</translation>
    </message>
    <message>
        <source>Ready to be published</source>
        <translation>Bereit zum Veröffentlichen</translation>
    </message>
    <message>
        <source>Trainees see the case as it is now; later edits wait for the next revision</source>
        <translation>Lernende sehen den Fall, wie er jetzt ist; spätere Änderungen warten auf die nächste Fassung</translation>
    </message>
    <message>
        <source>Something is still missing, see the list</source>
        <translation>Es fehlt noch etwas, siehe Liste</translation>
    </message>
    <message>
        <source>Publishing the case</source>
        <translation>Fall wird veröffentlicht</translation>
    </message>
    <message>
        <source>Nothing has changed since revision %1; it stays the one that trainees see.</source>
        <translation>Seit Fassung %1 hat sich nichts geändert; sie bleibt die, die Lernende sehen.</translation>
    </message>
    <message>
        <source>Published as revision %1. Trainees find it on the start page.</source>
        <translation>Als Fassung %1 veröffentlicht. Lernende finden sie auf der Startseite.</translation>
    </message>
    <message>
        <source>Export the case</source>
        <translation>Fall exportieren</translation>
    </message>
    <message>
        <source>Case bundles (*.ewcase)</source>
        <translation>Fallpakete (*.ewcase)</translation>
    </message>
    <message>
        <source>Exporting the case</source>
        <translation>Fall wird exportiert</translation>
    </message>
    <message>
        <source>Exported to %1, as it is now; trainees here see another revision, or none. Another workstation takes it with File, Import a case bundle.</source>
        <translation>Nach %1 exportiert, wie er jetzt ist; Lernende hier sehen eine andere Revision oder keine. Ein anderer Arbeitsplatz übernimmt ihn mit Datei, Fallpaket importieren.</translation>
    </message>
    <message>
        <source>Revision %1 was exported to %2. Another workstation takes it with File, Import a case bundle.</source>
        <translation>Revision %1 wurde nach %2 exportiert. Ein anderer Arbeitsplatz übernimmt ihn mit Datei, Fallpaket importieren.</translation>
    </message>
    <message>
        <source>Examination…</source>
        <translation>Prüfung…</translation>
    </message>
    <message>
        <source>Write what trainees may read into one file, and the answers so that an instructor&apos;s key alone opens them</source>
        <translation>Was Lernende lesen dürfen, in eine Datei schreiben, und die Antworten so, dass nur der Schlüssel einer Lehrkraft sie öffnet</translation>
    </message>
    <message>
        <source>Export is for practice: whoever opens the file can read the answers in it. An examination carries them sealed, and is judged afterwards.</source>
        <translation>Exportieren ist zum Üben: Wer die Datei öffnet, kann die Antworten darin lesen. Eine Prüfung trägt sie versiegelt und wird hinterher bewertet.</translation>
    </message>
    <message>
        <source>The public key of whoever judges the examination</source>
        <translation>Der öffentliche Schlüssel derer, die die Prüfung bewerten</translation>
    </message>
    <message>
        <source>Public keys (*.pub);;All files (*)</source>
        <translation>Öffentliche Schlüssel (*.pub);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Export an examination</source>
        <translation>Eine Prüfung exportieren</translation>
    </message>
    <message>
        <source>examination</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Exporting an examination</source>
        <translation>Prüfung exportieren</translation>
    </message>
    <message>
        <source>Exported to %1, the answers sealed for the key %2. Keep this file: attempts at it are judged with it alone.</source>
        <translation>Nach %1 exportiert, die Antworten für den Schlüssel %2 versiegelt. Diese Datei behalten: Versuche daran werden nur mit ihr bewertet.</translation>
    </message>
</context>
<context>
    <name>ew::ui::AccessDialog</name>
    <message>
        <source>Passphrase</source>
        <translation>Kennwort</translation>
    </message>
    <message>
        <source>Once more</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Entsperren</translation>
    </message>
    <message>
        <source>The two passphrases differ; type them again.</source>
        <translation>Die beiden Kennwörter sind verschieden; noch einmal eingeben.</translation>
    </message>
</context>
<context>
    <name>ew::review</name>
    <message>
        <source>Valid pose</source>
        <translation>Gültige Pose</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Freeze</source>
        <translation>Standbild</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>Marken</translation>
    </message>
    <message>
        <source>Comments</source>
        <translation>Kommentare</translation>
    </message>
    <message>
        <source>Expert</source>
        <translation>Experte</translation>
    </message>
    <message>
        <source>Trainee</source>
        <translation>Lernende</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Durchsicht</translation>
    </message>
    <message>
        <source>Compare trainees' scans with the expert's</source>
        <translation>Scans von Lernenden mit dem des Experten vergleichen</translation>
    </message>
</context>
<context>
    <name>ew::review::BodyView</name>
    <message>
        <source>Regions: off</source>
        <translation>Regionen: aus</translation>
    </message>
    <message>
        <source>Seen by the trainee</source>
        <translation>Von Lernenden gesehen</translation>
    </message>
    <message>
        <source>Seen by the expert</source>
        <translation>Vom Experten gesehen</translation>
    </message>
    <message>
        <source>Missed by the trainee</source>
        <translation>Von Lernenden verpasst</translation>
    </message>
    <message>
        <source>Seen by neither</source>
        <translation>Von niemandem gesehen</translation>
    </message>
    <message>
        <source>Both scans on the body</source>
        <translation>Beide Scans am Körper</translation>
    </message>
    <message>
        <source>The volume is too large to be kept in memory; its regions are not counted.</source>
        <translation>Das Volumen ist zu groß für den Arbeitsspeicher; seine Regionen werden nicht gezählt.</translation>
    </message>
    <message>
        <source>Both scans have to be of one case for this.</source>
        <translation>Dafür müssen beide Scans denselben Fall zeigen.</translation>
    </message>
    <message>
        <source>%1 % of the volume</source>
        <translation>%1 % des Volumens</translation>
    </message>
    <message>
        <source>longest %1 s</source>
        <translation>längstens %1 s</translation>
    </message>
</context>
<context>
    <name>ew::review::ClassPage</name>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>ausgelassen</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>not passed</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>How %1 stands</source>
        <translation>Wie %1 steht</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>noch nicht</translation>
    </message>
    <message>
        <source>competent</source>
        <translation>sicher</translation>
    </message>
    <message>
        <source>The two groups part at %1 (95 % interval %2 to %3).</source>
        <translation>Die beiden Gruppen trennen sich bei %1 (95-%-Intervall %2 bis %3).</translation>
    </message>
    <message>
        <source>These two groups do not suggest a level: those who should pass do not score higher, or no score differs.</source>
        <translation>Diese beiden Gruppen legen keine Grenze nahe: Wer bestehen sollte, hat nicht mehr Punkte, oder die Punkte sind alle gleich.</translation>
    </message>
    <message>
        <source>Two of each group at least are needed: %1 competent, %2 not yet.</source>
        <translation>Von jeder Gruppe sind mindestens zwei nötig: %1 sicher, %2 noch nicht.</translation>
    </message>
    <message>
        <source>Back to the scans</source>
        <translation>Zurück zu den Scans</translation>
    </message>
    <message>
        <source>Steps of the lesson</source>
        <translation>Schritte der Lektion</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>Middle half</source>
        <translation>Mittlere Hälfte</translation>
    </message>
    <message>
        <source>Click a heading to sort; the scores of the middle half of all attempts lie between the two last figures</source>
        <translation>Eine Überschrift anklicken, um zu sortieren; zwischen den beiden letzten Werten liegt die mittlere Hälfte aller Versuche</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Kennzahl</translation>
    </message>
    <message>
        <source>Pass level of this step</source>
        <translation>Bestehensgrenze dieses Schritts</translation>
    </message>
    <message>
        <source>To find a pass level, say of people you know how they stand; the level then lies where both groups part.</source>
        <translation>Um eine Bestehensgrenze zu finden, geben Sie an, wie bekannte Personen stehen; die Grenze liegt dann dort, wo sich beide Gruppen trennen.</translation>
    </message>
    <message>
        <source>Attempts at this step</source>
        <translation>Versuche an diesem Schritt</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>Wer</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Stands</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>Use this level</source>
        <translation>Diese Grenze verwenden</translation>
    </message>
    <message>
        <source>No lesson is chosen</source>
        <translation>Keine Lektion gewählt</translation>
    </message>
    <message>
        <source>%1: one attempt</source>
        <translation>%1: ein Versuch</translation>
    </message>
    <message>
        <source>%1: %2 attempts</source>
        <translation>%1: %2 Versuche</translation>
    </message>
    <message>
        <source>Every step that was ended was passed.</source>
        <translation>Jeder beendete Schritt wurde bestanden.</translation>
    </message>
    <message>
        <source>Most fail at “%1”: %2 of %3 who ended it did not pass.</source>
        <translation>Die meisten scheitern bei „%1“: %2 von %3, die ihn beendeten, haben nicht bestanden.</translation>
    </message>
    <message>
        <source>%1: most fail here</source>
        <translation>%1: Hier scheitern die meisten</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Median %1, mean %2; %3 of %4 passed, %5 left the step out.</source>
        <translation>Median %1, Mittel %2; %3 von %4 bestanden, %5 ließen den Schritt aus.</translation>
    </message>
    <message>
        <source>Median %1, mean %2, from %3 to %4 %5</source>
        <translation>Median %1, Mittel %2, von %3 bis %4 %5</translation>
    </message>
</context>
<context>
    <name>ew::review::CommentsPage</name>
    <message>
        <source>You are</source>
        <translation>Sie sind</translation>
    </message>
    <message>
        <source>your name, as others read it</source>
        <translation>Ihr Name, wie andere ihn lesen</translation>
    </message>
    <message>
        <source>Your name</source>
        <translation>Ihr Name</translation>
    </message>
    <message>
        <source>Comments</source>
        <translation>Kommentare</translation>
    </message>
    <message>
        <source>Text of the comment</source>
        <translation>Text des Kommentars</translation>
    </message>
    <message>
        <source>type a comment</source>
        <translation>Kommentar schreiben</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Undo brings it back</source>
        <translation>Rückgängig bringt ihn zurück</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Keeps your comments beside the attempt (Ctrl+S); they are also kept when another scan is chosen</source>
        <translation>Legt Ihre Kommentare beim Versuch ab (Strg+S); das geschieht auch, wenn ein anderer Scan gewählt wird</translation>
    </message>
    <message>
        <source>somebody</source>
        <translation>jemand</translation>
    </message>
    <message>
        <source>(drawing)</source>
        <translation>(Zeichnung)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>author: comment</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>No comments yet: write below the images what you see at a moment, and draw on the image.</source>
        <translation>Noch keine Kommentare: Schreiben Sie unter den Bildern, was Sie in einem Moment sehen, und zeichnen Sie ins Bild.</translation>
    </message>
    <message>
        <source>Comments are kept beside an attempt; choose a step that was recorded.</source>
        <translation>Kommentare liegen bei einem Versuch; wählen Sie einen Schritt, der aufgezeichnet wurde.</translation>
    </message>
</context>
<context>
    <name>ew::review::DistributionChart</name>
    <message>
        <source>No values</source>
        <translation>Keine Werte</translation>
    </message>
    <message>
        <source>%1 values from %2 to %3, median %4</source>
        <translation>%1 Werte von %2 bis %3, Median %4</translation>
    </message>
    <message>
        <source>Nobody has a value here yet</source>
        <translation>Hier hat noch niemand einen Wert</translation>
    </message>
    <message>
        <source>pass level</source>
        <translation>Bestehensgrenze</translation>
    </message>
</context>
<context>
    <name>ew::review::PictureView</name>
    <message>
        <source>The trainee's image</source>
        <translation>Das Bild der Lernenden</translation>
    </message>
    <message>
        <source>The expert's image</source>
        <translation>Das Bild des Experten</translation>
    </message>
    <message>
        <source>Opening …</source>
        <translation>Wird geöffnet …</translation>
    </message>
    <message>
        <source>No attempt is chosen.</source>
        <translation>Es ist kein Versuch gewählt.</translation>
    </message>
    <message>
        <source>This step was not recorded in this attempt.</source>
        <translation>Dieser Schritt wurde in diesem Versuch nicht aufgezeichnet.</translation>
    </message>
    <message>
        <source>Nothing to compare with is chosen.</source>
        <translation>Es ist nichts zum Vergleichen gewählt.</translation>
    </message>
    <message>
        <source>The pose of the probe is not known here</source>
        <translation>Die Pose des Schallkopfs ist hier nicht bekannt</translation>
    </message>
</context>
<context>
    <name>ew::review::RatingPage</name>
    <message>
        <source>Rating form</source>
        <translation>Bewertungsbogen</translation>
    </message>
    <message>
        <source>On the whole</source>
        <translation>Insgesamt</translation>
    </message>
    <message>
        <source>Remark on the whole</source>
        <translation>Bemerkung insgesamt</translation>
    </message>
    <message>
        <source>Kind of examination</source>
        <translation>Art der Untersuchung</translation>
    </message>
    <message>
        <source>Keep as a draft</source>
        <translation>Entwurf behalten</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Abschließen</translation>
    </message>
    <message>
        <source>Counts from now on; another one by you would be the next revision, and this one is kept</source>
        <translation>Zählt ab jetzt; eine weitere von Ihnen wäre die nächste Revision, und diese bleibt erhalten</translation>
    </message>
    <message>
        <source>No rating form was found.</source>
        <translation>Kein Bewertungsbogen gefunden.</translation>
    </message>
    <message>
        <source>Choose an attempt to rate it.</source>
        <translation>Wählen Sie einen Versuch, um ihn zu bewerten.</translation>
    </message>
    <message>
        <source>Say who you are, on the page of comments; ratings are kept by their raters.</source>
        <translation>Sagen Sie auf der Seite der Kommentare, wer Sie sind; Bewertungen werden nach ihren Verfassern abgelegt.</translation>
    </message>
    <message>
        <source>Names are shown: this rating does not count as blinded.</source>
        <translation>Namen werden gezeigt: Diese Bewertung gilt nicht als verblindet.</translation>
    </message>
    <message>
        <source>Blinded: names are not shown, and others' ratings only when yours is finished.</source>
        <translation>Verblindet: Namen werden nicht gezeigt, und andere Bewertungen erst, wenn Ihre abgeschlossen ist.</translation>
    </message>
    <message>
        <source>not applicable</source>
        <translation>nicht anwendbar</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Bemerkung</translation>
    </message>
    <message>
        <source>Remark on %1</source>
        <translation>Bemerkung zu %1</translation>
    </message>
    <message>
        <source>Finished, revision %1</source>
        <translation>Abgeschlossen, Revision %1</translation>
    </message>
    <message>
        <source>A draft, which does not count yet</source>
        <translation>Ein Entwurf, der noch nicht zählt</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <comment>rater, form: total</comment>
        <translation>%1, %2: %3</translation>
    </message>
    <message>
        <source>Another rater has finished; you see it when you have.</source>
        <translation>Eine andere Person hat bewertet; Sie sehen es, wenn Sie fertig sind.</translation>
    </message>
    <message>
        <source>%1 other raters have finished; you see it when you have.</source>
        <translation>%1 andere Personen haben bewertet; Sie sehen es, wenn Sie fertig sind.</translation>
    </message>
    <message>
        <source>Total %1 of %2</source>
        <translation>Gesamt %1 von %2</translation>
    </message>
    <message>
        <source>No item is rated yet</source>
        <translation>Noch kein Punkt bewertet</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>not passed</source>
        <translation>nicht bestanden</translation>
    </message>
</context>
<context>
    <name>ew::review::ReportButton</name>
    <message>
        <source>Report on the class …</source>
        <translation>Bericht über die Klasse …</translation>
    </message>
    <message>
        <source>Report …</source>
        <translation>Bericht …</translation>
    </message>
    <message>
        <source>Writes a page or a PDF about all attempts at this lesson; names are in it only while they are shown</source>
        <translation>Schreibt eine Seite oder ein PDF über alle Versuche an dieser Lektion; Namen stehen nur darin, während sie gezeigt werden</translation>
    </message>
    <message>
        <source>Writes a page or a PDF about this attempt; the name is in it only while names are shown</source>
        <translation>Schreibt eine Seite oder ein PDF über diesen Versuch; der Name steht nur darin, während Namen gezeigt werden</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Page for browsers (*.html)</source>
        <translation>Seite für Browser (*.html)</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>class.pdf</source>
        <translation>Klasse.pdf</translation>
    </message>
    <message>
        <source>attempt.pdf</source>
        <translation>Versuch.pdf</translation>
    </message>
</context>
<context>
    <name>ew::review::ReviewColumn</name>
    <message>
        <source>%1 of %2 passed</source>
        <translation>%1 von %2 bestanden</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>Scans</translation>
    </message>
    <message>
        <source>Comments</source>
        <translation>Kommentare</translation>
    </message>
    <message>
        <source>Scores</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Rating</source>
        <translation>Bewertung</translation>
    </message>
</context>
<context>
    <name>ew::review::ReviewSession</name>
    <message>
        <source>Looking for attempts</source>
        <translation>Suche nach Versuchen</translation>
    </message>
    <message>
        <source>Opening the scans</source>
        <translation>Öffnen der Scans</translation>
    </message>
    <message>
        <source>Opening was stopped; choose the step again.</source>
        <translation>Das Öffnen wurde abgebrochen; wählen Sie den Schritt noch einmal.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>person: step</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>without a name</source>
        <translation>ohne Namen</translation>
    </message>
    <message>
        <source>without a code</source>
        <translation>ohne Kürzel</translation>
    </message>
    <message>
        <source>Aligning the scans</source>
        <translation>Angleichen der Scans</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Durchsicht</translation>
    </message>
    <message>
        <source>not saved</source>
        <translation>nicht gespeichert</translation>
    </message>
    <message>
        <source>Comments on an attempt are not saved.</source>
        <translation>Kommentare zu einem Versuch sind nicht gespeichert.</translation>
    </message>
    <message>
        <source>comment</source>
        <translation>Kommentar</translation>
    </message>
    <message>
        <source>remove the comment</source>
        <translation>Kommentar entfernen</translation>
    </message>
    <message>
        <source>Scoring the attempts</source>
        <translation>Auswerten der Versuche</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>Schreiben des Berichts</translation>
    </message>
    <message>
        <source>The report is in %1.</source>
        <translation>Der Bericht liegt in %1.</translation>
    </message>
</context>
<context>
    <name>ew::review::ReviewStage</name>
    <message>
        <source>Both scans</source>
        <translation>Beide Scans</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>Neu suchen</translation>
    </message>
    <message>
        <source>Nothing to review yet</source>
        <translation>Noch nichts durchzusehen</translation>
    </message>
    <message>
        <source>When trainees have worked through lessons at this library, their attempts are listed at the left. Open a case with lessons to see its expert's scans.</source>
        <translation>Wenn Lernende in dieser Bibliothek Lektionen bearbeitet haben, stehen ihre Versuche links. Öffnen Sie einen Fall mit Lektionen, um die Scans des Experten zu sehen.</translation>
    </message>
    <message>
        <source>Regions of the volume</source>
        <translation>Regionen des Volumens</translation>
    </message>
    <message>
        <source>Which regions of the volume were seen, and which were not (H)</source>
        <translation>Welche Regionen des Volumens gesehen wurden und welche nicht (H)</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>The planes where the probe rested or the image was frozen</source>
        <translation>Die Ebenen, in denen der Schallkopf ruhte oder das Bild stand</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation>Von vorn ansehen</translation>
    </message>
    <message>
        <source>To the event before (P)</source>
        <translation>Zum Ereignis davor (P)</translation>
    </message>
    <message>
        <source>Play or rest (Space)</source>
        <translation>Abspielen oder anhalten (Leertaste)</translation>
    </message>
    <message>
        <source>To the next event (N)</source>
        <translation>Zum nächsten Ereignis (N)</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Speed (- and +)</source>
        <translation>Tempo (- und +)</translation>
    </message>
    <message>
        <source>The loop begins here; again: no longer ([)</source>
        <translation>Die Schleife beginnt hier; noch einmal: nicht mehr ([)</translation>
    </message>
    <message>
        <source>The loop ends here; again: no longer (])</source>
        <translation>Die Schleife endet hier; noch einmal: nicht mehr (])</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Goes on from the beginning at the end</source>
        <translation>Geht am Ende von vorn weiter</translation>
    </message>
    <message>
        <source>One clock</source>
        <translation>Eine Uhr</translation>
    </message>
    <message>
        <source>Both scans go on in the same seconds, each from its beginning</source>
        <translation>Beide Scans laufen in denselben Sekunden, jeder von seinem Anfang an</translation>
    </message>
    <message>
        <source>Aligned</source>
        <translation>Angeglichen</translation>
    </message>
    <message>
        <source>The expert's scan follows the trainee's probe: the same places at the same time (T)</source>
        <translation>Der Scan des Experten folgt dem Schallkopf der Lernenden: dieselben Orte zur selben Zeit (T)</translation>
    </message>
    <message>
        <source>The expert's scan begins later by</source>
        <translation>Der Scan des Experten beginnt später um</translation>
    </message>
    <message>
        <source>The expert's scan begins so much later than the trainee's</source>
        <translation>So viel später als der Scan der Lernenden beginnt der des Experten</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>Draw a line on the trainee's image (D)</source>
        <translation>Eine Linie ins Bild der Lernenden zeichnen (D)</translation>
    </message>
    <message>
        <source>Arrow</source>
        <translation>Pfeil</translation>
    </message>
    <message>
        <source>Draw an arrow on the trainee's image</source>
        <translation>Einen Pfeil ins Bild der Lernenden zeichnen</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>Draw a circle on the trainee's image, from its middle</source>
        <translation>Einen Kreis ins Bild der Lernenden zeichnen, von seiner Mitte aus</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Take away what was drawn (Escape)</source>
        <translation>Das Gezeichnete wegnehmen (Escape)</translation>
    </message>
    <message>
        <source>What do you see at this moment?</source>
        <translation>Was sehen Sie in diesem Moment?</translation>
    </message>
    <message>
        <source>Comment at this moment</source>
        <translation>Kommentar zu diesem Moment</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Kommentar</translation>
    </message>
    <message>
        <source>Keep text and drawing as a comment at this moment (Enter)</source>
        <translation>Text und Zeichnung als Kommentar zu diesem Moment behalten (Eingabe)</translation>
    </message>
    <message>
        <source>play both scans, or rest</source>
        <translation>beide Scans abspielen oder anhalten</translation>
    </message>
    <message>
        <source>half a second back or on; with Shift one image</source>
        <translation>eine halbe Sekunde zurück oder weiter; mit Umschalt ein Bild</translation>
    </message>
    <message>
        <source>to the beginning or the end</source>
        <translation>zum Anfang oder zum Ende</translation>
    </message>
    <message>
        <source>the loop begins or ends here; again: no longer</source>
        <translation>die Schleife beginnt oder endet hier; noch einmal: nicht mehr</translation>
    </message>
    <message>
        <source>to the next event, or the one before</source>
        <translation>zum nächsten Ereignis oder zu dem davor</translation>
    </message>
    <message>
        <source>slower or faster</source>
        <translation>langsamer oder schneller</translation>
    </message>
    <message>
        <source>aligned, or on one clock</source>
        <translation>angeglichen oder auf einer Uhr</translation>
    </message>
    <message>
        <source>which regions are shown in the body</source>
        <translation>welche Regionen im Körper gezeigt werden</translation>
    </message>
    <message>
        <source>draw on the trainee's image</source>
        <translation>ins Bild der Lernenden zeichnen</translation>
    </message>
    <message>
        <source>write a comment at this moment</source>
        <translation>einen Kommentar zu diesem Moment schreiben</translation>
    </message>
</context>
<context>
    <name>ew::review::ScansPage</name>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Show names</source>
        <translation>Namen zeigen</translation>
    </message>
    <message>
        <source>Off: people are called by codes, so that you judge what you see and not whom you know</source>
        <translation>Aus: Personen heißen nach Kürzeln, damit Sie beurteilen, was Sie sehen, und nicht, wen Sie kennen</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Compared with</source>
        <translation>Verglichen mit</translation>
    </message>
    <message>
        <source>Class overview</source>
        <translation>Klassenübersicht</translation>
    </message>
    <message>
        <source>How all attempts at this lesson went, step by step</source>
        <translation>Wie alle Versuche an dieser Lektion verliefen, Schritt für Schritt</translation>
    </message>
    <message>
        <source>Recording …</source>
        <translation>Aufzeichnung …</translation>
    </message>
    <message>
        <source>Reviews the recording of a scan from a file, in place of an attempt's</source>
        <translation>Sieht die Aufzeichnung eines Scans aus einer Datei durch, an Stelle der eines Versuchs</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>Neu suchen</translation>
    </message>
    <message>
        <source>Looks for attempts that were made meanwhile</source>
        <translation>Sucht nach Versuchen, die inzwischen gemacht wurden</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <comment>case – lesson</comment>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>One attempt belongs to a lesson that is not in this library.</source>
        <translation>Ein Versuch gehört zu einer Lektion, die nicht in dieser Bibliothek ist.</translation>
    </message>
    <message>
        <source>%1 attempts belong to lessons that are not in this library.</source>
        <translation>%1 Versuche gehören zu Lektionen, die nicht in dieser Bibliothek sind.</translation>
    </message>
    <message>
        <source>Looking …</source>
        <translation>Suche …</translation>
    </message>
    <message>
        <source>No attempts yet</source>
        <translation>Noch keine Versuche</translation>
    </message>
    <message>
        <source>Nobody has tried it yet</source>
        <translation>Noch hat es niemand versucht</translation>
    </message>
    <message>
        <source>not finished</source>
        <translation>nicht beendet</translation>
    </message>
    <message>
        <source>%1 (not recorded)</source>
        <translation>%1 (nicht aufgezeichnet)</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>Expert: %1</source>
        <translation>Experte: %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>person, when</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>A recording …</source>
        <translation>Eine Aufzeichnung …</translation>
    </message>
    <message>
        <source>Open a recording of a scan</source>
        <translation>Aufzeichnung eines Scans öffnen</translation>
    </message>
    <message>
        <source>Recordings of scans (*.seq.mha *.igs.mha *.mha);;All files (*)</source>
        <translation>Aufzeichnungen von Scans (*.seq.mha *.igs.mha *.mha);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>ew::review::ScoresPage</name>
    <message>
        <source>version %1</source>
        <translation>Version %1</translation>
    </message>
    <message>
        <source>Off by default: it tells simulated novices from experts with an area of %1 (%2 to %3).</source>
        <translation>Gewöhnlich aus: Sie trennt simulierte Anfänger von Experten mit einer Fläche von %1 (%2 bis %3).</translation>
    </message>
    <message>
        <source>Off by default: it was not studied.</source>
        <translation>Gewöhnlich aus: Sie wurde nicht untersucht.</translation>
    </message>
    <message>
        <source>Figures of this step</source>
        <translation>Kennzahlen dieses Schritts</translation>
    </message>
    <message>
        <source>Also figures that are off by default</source>
        <translation>Auch sonst ausgelassene zeigen</translation>
    </message>
    <message>
        <source>Figures that did not tell simulated novices from experts, or were not studied; one that is given a weight counts all the same</source>
        <translation>Kennzahlen, die simulierte Anfänger nicht von Experten trennten oder nicht untersucht wurden; eine mit Gewicht zählt trotzdem</translation>
    </message>
    <message>
        <source>Score the attempts</source>
        <translation>Versuche auswerten</translation>
    </message>
    <message>
        <source>Works out all scores of this lesson from what was recorded; earlier scores are kept</source>
        <translation>Berechnet alle Punkte dieser Lektion aus den Aufzeichnungen; frühere Punkte bleiben erhalten</translation>
    </message>
    <message>
        <source>Pass level</source>
        <translation>Bestehensgrenze</translation>
    </message>
    <message>
        <source>The least score that passes this step</source>
        <translation>Die kleinste Punktzahl, mit der dieser Schritt bestanden ist</translation>
    </message>
    <message>
        <source>Weight in the lesson</source>
        <translation>Gewicht in der Lektion</translation>
    </message>
    <message>
        <source>How much this step counts in the score of the lesson, beside the others</source>
        <translation>Wie viel dieser Schritt in den Punkten der Lektion zählt, neben den anderen</translation>
    </message>
    <message>
        <source>Weight of the task</source>
        <translation>Gewicht der Aufgabe</translation>
    </message>
    <message>
        <source>How much the task itself counts in the score of the step, beside the figures that count</source>
        <translation>Wie viel die Aufgabe selbst in den Punkten des Schritts zählt, neben den Kennzahlen, die zählen</translation>
    </message>
    <message>
        <source>Counts with weight</source>
        <translation>Zählt mit Gewicht</translation>
    </message>
    <message>
        <source>0: this figure does not count</source>
        <translation>0: Diese Kennzahl zählt nicht</translation>
    </message>
    <message>
        <source>Worth nothing at</source>
        <translation>Nichts wert bei</translation>
    </message>
    <message>
        <source>A figure like this, or worse, gives nothing</source>
        <translation>Ein solcher Wert oder ein schlechterer gibt nichts</translation>
    </message>
    <message>
        <source>Worth all at</source>
        <translation>Alles wert bei</translation>
    </message>
    <message>
        <source>A figure like this, or better, gives everything</source>
        <translation>Ein solcher Wert oder ein besserer gibt alles</translation>
    </message>
    <message>
        <source>No step is chosen</source>
        <translation>Kein Schritt gewählt</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>ausgelassen</translation>
    </message>
    <message>
        <source>handed in, not judged yet</source>
        <translation>abgegeben, noch nicht beurteilt</translation>
    </message>
    <message>
        <source>not passed</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>%1, pass level %2: %3</source>
        <translation>%1, Bestehensgrenze %2: %3</translation>
    </message>
    <message>
        <source>The task alone %1. Poses known in %2 of the images. Scored with revision %3 of what counts.</source>
        <translation>Die Aufgabe allein %1. Posen in %2 der Bilder bekannt. Ausgewertet nach Revision %3 dessen, was zählt.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>As it was judged in the lesson; it was not scored since.</source>
        <translation>Wie es in der Lektion beurteilt wurde; seither nicht ausgewertet.</translation>
    </message>
    <message>
        <source>This attempt has not ended this step</source>
        <translation>Dieser Versuch hat diesen Schritt nicht beendet</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Kennzahl</translation>
    </message>
    <message>
        <source>%1 (counts)</source>
        <translation>%1 (zählt)</translation>
    </message>
    <message>
        <source>Scoring …</source>
        <translation>Wird ausgewertet …</translation>
    </message>
</context>
<context>
    <name>ew::review::TrackView</name>
    <message>
        <source>Both scans along the time</source>
        <translation>Beide Scans entlang der Zeit</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <comment>who, when: what</comment>
        <translation>%1, %2: %3</translation>
    </message>
    <message>
        <source>%1: %2 % of the face touches</source>
        <translation>%1: %2 % der Kopffläche berühren</translation>
    </message>
    <message>
        <source>%1, %2: from %3 to %4</source>
        <comment>who, what</comment>
        <translation>%1, %2: von %3 bis %4</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>who: what track</comment>
        <translation>%1: %2</translation>
    </message>
</context>
</TS>
