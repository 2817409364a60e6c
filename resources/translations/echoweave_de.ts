<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
    <context>
        <name>ew::case_authoring</name>
        <message>
            <source>Case</source>
            <translation>Fall</translation>
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
            <translation>Öffnen Sie einen Fall auf der Startseite, im Menü Datei, oder ziehen Sie seinen Ordner auf das Fenster. Dann lassen sich Patient, Texte und Volumen hier bearbeiten.</translation>
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
            <source>Change the patient's name</source>
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
            <source>Change the patient's sex</source>
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
            <source>Change the patient's age</source>
            <translation>Alter ändern</translation>
        </message>
        <message>
            <source>Age</source>
            <translation>Alter</translation>
        </message>
        <message>
            <source>Move the volume</source>
            <translation>Volumen verschieben</translation>
        </message>
        <message>
            <source>A marked field cannot be used as it is; correct it first, or undo.</source>
            <translation>Ein markiertes Feld ist so nicht brauchbar; bitte erst berichtigen oder rückgängig machen.</translation>
        </message>
        <message>
            <source>● not saved</source>
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
    </context>
    <context>
        <name>ew::stitching</name>
        <message>
            <source>Stitching</source>
            <translation>Verbinden</translation>
        </message>
    </context>
    <context>
        <name>ew::stitching::StitchPanel</name>
        <message>
            <source>Add volumes…</source>
            <translation>Volumen hinzufügen…</translation>
        </message>
        <message>
            <source>Join volumes into one</source>
            <translation>Volumen zu einem verbinden</translation>
        </message>
        <message>
            <source>Add two or more volumes whose places are known, or drop their files or a stitch project here.</source>
            <translation>Fügen Sie zwei oder mehr Volumen mit bekannter Lage hinzu, oder ziehen Sie ihre Dateien oder ein Projekt hierher.</translation>
        </message>
        <message>
            <source>Volumes</source>
            <translation>Volumen</translation>
        </message>
        <message>
            <source>Add…</source>
            <translation>Hinzufügen…</translation>
        </message>
        <message>
            <source>Add volume files or a stitch project</source>
            <translation>Volumendateien oder ein Projekt hinzufügen</translation>
        </message>
        <message>
            <source>Place</source>
            <translation>Lage</translation>
        </message>
        <message>
            <source>Transform…</source>
            <translation>Transformation…</translation>
        </message>
        <message>
            <source>Take the place from a file with 16 numbers, row by row</source>
            <translation>Die Lage aus einer Datei mit 16 Zahlen lesen, Zeile für Zeile</translation>
        </message>
        <message>
            <source>Coverage…</source>
            <translation>Abdeckung…</translation>
        </message>
        <message>
            <source>Say which voxels were measured, from a coverage file</source>
            <translation>Aus einer Datei lesen, welche Voxel gemessen wurden</translation>
        </message>
        <message>
            <source>Remove</source>
            <translation>Entfernen</translation>
        </message>
        <message>
            <source>Take this volume off the list; its file stays</source>
            <translation>Dieses Volumen aus der Liste nehmen; seine Datei bleibt</translation>
        </message>
        <message>
            <source>Result</source>
            <translation>Ergebnis</translation>
        </message>
        <message>
            <source>mm</source>
            <translation>mm</translation>
        </message>
        <message>
            <source>finest of the volumes</source>
            <translation>der feinste der Volumen</translation>
        </message>
        <message>
            <source>none: plain mean</source>
            <translation>keiner: einfaches Mittel</translation>
        </message>
        <message>
            <source>How far from a volume's border its weight reaches full height</source>
            <translation>Wie weit vom Rand eines Volumens sein Gewicht die volle Höhe erreicht</translation>
        </message>
        <message>
            <source>of the first volume</source>
            <translation>des ersten Volumens</translation>
        </message>
        <message>
            <source>of the body</source>
            <translation>des Körpers</translation>
        </message>
        <message>
            <source>Voxel spacing</source>
            <translation>Voxelabstand</translation>
        </message>
        <message>
            <source>Feather</source>
            <translation>Übergang</translation>
        </message>
        <message>
            <source>Axes</source>
            <translation>Achsen</translation>
        </message>
        <message>
            <source>Stitch</source>
            <translation>Verbinden</translation>
        </message>
        <message>
            <source>Save result…</source>
            <translation>Ergebnis speichern…</translation>
        </message>
        <message>
            <source>Save project…</source>
            <translation>Projekt speichern…</translation>
        </message>
        <message>
            <source>Keep the list, the places and the options for later or for the command line</source>
            <translation>Liste, Lagen und Optionen für später oder für die Kommandozeile aufheben</translation>
        </message>
        <message>
            <source>Reading %1</source>
            <translation>%1 wird gelesen</translation>
        </message>
        <message>
            <source>Transform of %1</source>
            <translation>Transformation von %1</translation>
        </message>
        <message>
            <source>Transforms (*.txt *.tfm);;All files (*)</source>
            <translation>Transformationen (*.txt *.tfm);;Alle Dateien (*)</translation>
        </message>
        <message>
            <source>Coverage of %1</source>
            <translation>Abdeckung von %1</translation>
        </message>
        <message>
            <source>Volumes (*.mha *.mhd *.nrrd *.nii *.nii.gz);;All files (*)</source>
            <translation>Volumen (*.mha *.mhd *.nrrd *.nii *.nii.gz);;Alle Dateien (*)</translation>
        </message>
        <message>
            <source>%1 voxels of %2 × %3 × %4 mm</source>
            <translation>%1 Voxel zu %2 × %3 × %4 mm</translation>
        </message>
        <message>
            <source>No coverage: every voxel counts as measured</source>
            <translation>Keine Abdeckung: jeder Voxel gilt als gemessen</translation>
        </message>
        <message>
            <source>Coverage from the volume's file</source>
            <translation>Abdeckung aus der Volumendatei</translation>
        </message>
        <message>
            <source>Coverage from %1</source>
            <translation>Abdeckung aus %1</translation>
        </message>
        <message>
            <source>%1 voxels of %2 × %3 × %4 mm; needs %5</source>
            <translation>%1 Voxel zu %2 × %3 × %4 mm; braucht %5</translation>
        </message>
        <message>
            <source> of %1 free</source>
            <translation> von %1 frei</translation>
        </message>
        <message>
            <source>Stitching…</source>
            <translation>Verbindet…</translation>
        </message>
        <message numerus="yes">
            <source>Stitching %n volume(s)</source>
            <translation>
                <numerusform>%n Volumen wird verbunden</numerusform>
                <numerusform>%n Volumen werden verbunden</numerusform>
            </translation>
        </message>
        <message>
            <source>Done in %1 s.</source>
            <translation>Fertig in %1 s.</translation>
        </message>
        <message>
            <source> %1 % of the covered voxels overlap; there the volumes differ by %2 grey levels.</source>
            <translation> %1 % der abgedeckten Voxel überlappen; dort unterscheiden sich die Volumen um %2 Graustufen.</translation>
        </message>
        <message>
            <source>Stitched volume</source>
            <translation>Verbundenes Volumen</translation>
        </message>
        <message>
            <source>Saving the stitched volume</source>
            <translation>Das verbundene Volumen wird gespeichert</translation>
        </message>
        <message>
            <source>Saved in %1: volume.mha, coverage.mha, source.mha and provenance.json.</source>
            <translation>Gespeichert in %1: volume.mha, coverage.mha, source.mha und provenance.json.</translation>
        </message>
        <message>
            <source>Add volumes</source>
            <translation>Volumen hinzufügen</translation>
        </message>
        <message>
            <source>Volumes and stitch projects (*.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz *.json);;All files (*)</source>
            <translation>Volumen und Projekte (*.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz *.json);;Alle Dateien (*)</translation>
        </message>
        <message>
            <source>Folder for the stitched volume</source>
            <translation>Ordner für das verbundene Volumen</translation>
        </message>
        <message>
            <source>Save the stitch project</source>
            <translation>Projekt speichern</translation>
        </message>
        <message>
            <source>Stitch projects (*.json)</source>
            <translation>Projekte (*.json)</translation>
        </message>
        <message>
            <source>The project was saved as %1.</source>
            <translation>Das Projekt wurde als %1 gespeichert.</translation>
        </message>
        <message numerus="yes">
            <source>Reading %n volumes</source>
            <translation>
                <numerusform>%n Volumen werden gelesen</numerusform>
                <numerusform>%n Volumen werden gelesen</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>ew::ui::ConsolePanel</name>
        <message>
            <source>Gain</source>
            <translation>Verstärkung</translation>
        </message>
        <message>
            <source>Overall gain (Ctrl+Up, Ctrl+Down)</source>
            <translation>Gesamtverstärkung (Strg+Auf, Strg+Ab)</translation>
        </message>
        <message>
            <source>Depth</source>
            <translation>Tiefe</translation>
        </message>
        <message>
            <source>Depth of the picture (Page Up, Page Down)</source>
            <translation>Tiefe des Bildes (Bild auf, Bild ab)</translation>
        </message>
        <message>
            <source>Focus</source>
            <translation>Fokus</translation>
        </message>
        <message>
            <source>Depth of the focus mark</source>
            <translation>Tiefe der Fokusmarke</translation>
        </message>
        <message>
            <source>Zoom</source>
            <translation>Zoom</translation>
        </message>
        <message>
            <source>Magnify about the middle of the picture (Z, Shift+Z)</source>
            <translation>Um die Bildmitte vergrößern (Z, Umschalt+Z)</translation>
        </message>
        <message>
            <source>DGC</source>
            <translation>DGC</translation>
        </message>
        <message>
            <source>Depth gain compensation: one slider for each eighth of the depth, near on top</source>
            <translation>Tiefenausgleich: ein Schieber für jedes Achtel der Tiefe, nah oben</translation>
        </message>
        <message>
            <source>Reset</source>
            <translation>Zurücksetzen</translation>
        </message>
        <message>
            <source>All eight sliders back to the middle (Ctrl+0)</source>
            <translation>Alle acht Schieber zurück in die Mitte (Strg+0)</translation>
        </message>
        <message>
            <source>DGC %1</source>
            <translation>DGC %1</translation>
        </message>
        <message>
            <source>Quality</source>
            <translation>Qualität</translation>
        </message>
        <message>
            <source>Weave</source>
            <translation>Weben</translation>
        </message>
        <message>
            <source>Linear</source>
            <translation>Linear</translation>
        </message>
        <message>
            <source>Nearest voxels, fastest (1)</source>
            <translation>Nächste Voxel, am schnellsten (1)</translation>
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
            <source>Flip</source>
            <translation>Spiegeln</translation>
        </message>
        <message>
            <source>The marker is at the left, as usual; put it at the right (X)</source>
            <translation>Die Marke ist links, wie üblich; nach rechts setzen (X)</translation>
        </message>
        <message>
            <source>The marker is at the right; put it at the left, as usual (X)</source>
            <translation>Die Marke ist rechts; nach links setzen, wie üblich (X)</translation>
        </message>
        <message>
            <source>Freeze</source>
            <translation>Einfrieren</translation>
        </message>
        <message>
            <source>Keep the picture (Space or F)</source>
            <translation>Das Bild festhalten (Leertaste oder F)</translation>
        </message>
        <message>
            <source>Transducer: %1</source>
            <translation>Schallkopf: %1</translation>
        </message>
        <message>
            <source>%1 to %2 mm: %3 %</source>
            <translation>%1 bis %2 mm: %3 %</translation>
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
            <source>Make a volume from a sweep</source>
            <translation>Aus einem Schwenk ein Volumen machen</translation>
        </message>
        <message>
            <source>none: the sweep says everything itself</source>
            <translation>keine: der Schwenk sagt selbst alles</translation>
        </message>
        <message>
            <source>Choose…</source>
            <translation>Wählen…</translation>
        </message>
        <message>
            <source>as the sweep suggests</source>
            <translation>wie der Schwenk vorschlägt</translation>
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
            <source>brightest view</source>
            <translation>hellste Ansicht</translation>
        </message>
        <message>
            <source>latest view</source>
            <translation>letzte Ansicht</translation>
        </message>
        <message>
            <source> voxels</source>
            <translation> Voxel</translation>
        </message>
        <message>
            <source>leave holes</source>
            <translation>Löcher lassen</translation>
        </message>
        <message>
            <source>Holes at most this far between measured voxels are filled and marked as interpolated</source>
            <translation>Löcher bis zu dieser Weite zwischen gemessenen Voxeln werden gefüllt und als interpoliert vermerkt</translation>
        </message>
        <message>
            <source>Calibration</source>
            <translation>Kalibrierung</translation>
        </message>
        <message>
            <source>Coordinates of</source>
            <translation>Koordinaten von</translation>
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
            <source>Overlap</source>
            <translation>Überlappung</translation>
        </message>
        <message>
            <source>Fill holes up to</source>
            <translation>Löcher füllen bis</translation>
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
            <source>Make the volume</source>
            <translation>Volumen erzeugen</translation>
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
            <translation>Gerätebeschreibungen (*.xml)</translation>
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
            <source>as the sweep suggests (%1)</source>
            <translation>wie der Schwenk vorschlägt (%1)</translation>
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
            <translation>Das Volumen bräuchte mehr als die erlaubten %1; bitte einen gröberen Abstand wählen.</translation>
        </message>
        <message>
            <source>%1 while it is made, the volume itself %2</source>
            <translation>%1 beim Erzeugen, das Volumen selbst %2</translation>
        </message>
        <message>
            <source>Making a volume from %1</source>
            <translation>Aus %1 wird ein Volumen</translation>
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
            <source>Undo: %1 (Ctrl+Z)</source>
            <translation>Rückgängig: %1 (Strg+Z)</translation>
        </message>
        <message>
            <source>The case '%1' has changes that are not saved.</source>
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
            <source>Save &amp;picture as…</source>
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
            <source>From the patient's &amp;right</source>
            <translation>Von &amp;rechts (Patient)</translation>
        </message>
        <message>
            <source>From the patient's &amp;left</source>
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
            <source>Scan the &amp;case's volume</source>
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
            <source>As the system</source>
            <translation>Wie das System</translation>
        </message>
        <message>
            <source>The language changes at the next start.</source>
            <translation>Die Sprache wechselt beim nächsten Start.</translation>
        </message>
        <message>
            <source>F&amp;ull screen</source>
            <translation>Vollb&amp;ild</translation>
        </message>
        <message>
            <source>&amp;Scan</source>
            <translation>&amp;Schall</translation>
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
            <source>Reset DGC</source>
            <translation>DGC zurücksetzen</translation>
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
            <source>Drag</source>
            <translation>Ziehen</translation>
        </message>
        <message>
            <source>slide over the skin</source>
            <translation>über die Haut gleiten</translation>
        </message>
        <message>
            <source>Wheel</source>
            <translation>Mausrad</translation>
        </message>
        <message>
            <source>tilt</source>
            <translation>kippen</translation>
        </message>
        <message>
            <source>Shift + wheel</source>
            <translation>Umschalt + Rad</translation>
        </message>
        <message>
            <source>rock</source>
            <translation>schaukeln</translation>
        </message>
        <message>
            <source>Ctrl + wheel</source>
            <translation>Strg + Rad</translation>
        </message>
        <message>
            <source>rotate</source>
            <translation>drehen</translation>
        </message>
        <message>
            <source>Arrows</source>
            <translation>Pfeile</translation>
        </message>
        <message>
            <source>slide by 2 mm, with Shift 10 mm</source>
            <translation>um 2 mm gleiten, mit Umschalt 10 mm</translation>
        </message>
        <message>
            <source>Home</source>
            <translation>Pos1</translation>
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
            <source>turn the body</source>
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
            <source>Ctrl + right drag</source>
            <translation>Strg + rechts ziehen</translation>
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
            <source>Console</source>
            <translation>Konsole</translation>
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
            <source>reset DGC</source>
            <translation>DGC zurücksetzen</translation>
        </message>
        <message>
            <source>weave, linear</source>
            <translation>weben, linear</translation>
        </message>
        <message>
            <source>swap left and right</source>
            <translation>links und rechts tauschen</translation>
        </message>
        <message>
            <source>Window</source>
            <translation>Fenster</translation>
        </message>
        <message>
            <source>open a case, a volume or a sweep</source>
            <translation>Fall, Volumen oder Schwenk öffnen</translation>
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
            <source>All that EchoWeave reads (case.json *.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz);;Cases (case.json);;Sweeps (*.igs.mha *.igs.mhd *.igs.nrrd *.seq.mha *.seq.nrrd *.mha *.mhd *.nrrd);;Volumes (*.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz)</source>
            <translation>Alles, was EchoWeave liest (case.json *.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz);;Fälle (case.json);;Schwenks (*.igs.mha *.igs.mhd *.igs.nrrd *.seq.mha *.seq.nrrd *.mha *.mhd *.nrrd);;Volumen (*.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz)</translation>
        </message>
        <message>
            <source>Save the case as a new folder</source>
            <translation>Den Fall als neuen Ordner speichern</translation>
        </message>
        <message>
            <source>-copy</source>
            <translation>-Kopie</translation>
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
            <source>Save the picture</source>
            <translation>Das Bild speichern</translation>
        </message>
        <message>
            <source>scan</source>
            <translation>Bild</translation>
        </message>
        <message>
            <source>Pictures (*.png *.mha)</source>
            <translation>Bilder (*.png *.mha)</translation>
        </message>
        <message>
            <source>a volume without a case</source>
            <translation>ein Volumen ohne Fall</translation>
        </message>
        <message>
            <source>not saved</source>
            <translation>nicht gespeichert</translation>
        </message>
        <message>
            <source>Preparing the cards</source>
            <translation>Karten werden vorbereitet</translation>
        </message>
        <message>
            <source>The window was not ready within %1 s; try a smaller volume.</source>
            <translation>Das Fenster war nach %1 s nicht bereit; bitte ein kleineres Volumen versuchen.</translation>
        </message>
        <message>
            <source>The picture cannot be written to '%1'; choose a folder you may write to.</source>
            <translation>Das Bild lässt sich nicht nach „%1“ schreiben; bitte einen Ordner wählen, in den Sie schreiben dürfen.</translation>
        </message>
        <message>
            <source>Saved to %1, and which voxels were measured to %2.</source>
            <translation>Gespeichert als %1, und welche Voxel gemessen wurden als %2.</translation>
        </message>
        <message>
            <source>Weave: nearest voxels, fastest</source>
            <translation>Weben: nächste Voxel, am schnellsten</translation>
        </message>
        <message>
            <source>Linear: interpolated</source>
            <translation>Linear: interpoliert</translation>
        </message>
        <message>
            <source>Swap left and right</source>
            <translation>Links und rechts tauschen</translation>
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
    </context>
    <context>
        <name>ew::ui::Opener</name>
        <message>
            <source>Preparing the mannequin</source>
            <translation>Der Übungskörper wird vorbereitet</translation>
        </message>
        <message>
            <source>There is no file or folder '%1'; check the name, or choose it with Open.</source>
            <translation>Es gibt keine Datei und keinen Ordner „%1“; bitte den Namen prüfen oder mit Öffnen wählen.</translation>
        </message>
        <message>
            <source>Opening %1</source>
            <translation>%1 wird geöffnet</translation>
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
            <source>There are no plugin folders. Put a plugin's folder into lib/plugins beside the program, or name a folder in ECHOWEAVE_PLUGINS, and start again.</source>
            <translation>Es gibt keine Ordner für Erweiterungen. Legen Sie den Ordner einer Erweiterung in lib/plugins neben dem Programm ab, oder nennen Sie einen Ordner in ECHOWEAVE_PLUGINS, und starten Sie neu.</translation>
        </message>
        <message>
            <source>No plugins were found in %1. Put a plugin's folder there and start again.</source>
            <translation>In %1 wurden keine Erweiterungen gefunden. Legen Sie dort den Ordner einer Erweiterung ab und starten Sie neu.</translation>
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
        <name>ew::ui::ScanView</name>
        <message>
            <source>Scan</source>
            <translation>Schallbild</translation>
        </message>
        <message>
            <source>Nothing to scan yet. Open a case, a volume or a sweep (Ctrl+O), or drop one here.</source>
            <translation>Noch nichts zu schallen. Öffnen Sie einen Fall, ein Volumen oder einen Schwenk (Strg+O), oder ziehen Sie etwas hierher.</translation>
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
            <source>depth %1 mm   gain %2 %   zoom %3</source>
            <translation>Tiefe %1 mm   Verstärkung %2 %   Zoom %3</translation>
        </message>
        <message>
            <source>The probe is beside the volume.</source>
            <translation>Die Sonde steht neben dem Volumen.</translation>
        </message>
        <message>
            <source>The probe is beside the volume. Slide it back, or press Home for the start.</source>
            <translation>Die Sonde steht neben dem Volumen. Schieben Sie sie zurück, oder drücken Sie Pos1 für den Anfang.</translation>
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
            <source>Open a case, a volume or a sweep (Ctrl+O)</source>
            <translation>Fall, Volumen oder Schwenk öffnen (Strg+O)</translation>
        </message>
        <message>
            <source>Recently opened</source>
            <translation>Zuletzt geöffnet</translation>
        </message>
        <message>
            <source>A sweep (.igs.mha), a volume (.mha, .mhd, .nrrd, .nii) or a case folder can also be dropped on this window.</source>
            <translation>Ein Schwenk (.igs.mha), ein Volumen (.mha, .mhd, .nrrd, .nii) oder ein Fallordner lässt sich auch auf dieses Fenster ziehen.</translation>
        </message>
        <message>
            <source>There are no cases here yet. Open a case folder, a volume or a sweep to begin.</source>
            <translation>Hier gibt es noch keine Fälle. Öffnen Sie zum Anfang einen Fallordner, ein Volumen oder einen Schwenk.</translation>
        </message>
    </context>
    <context>
        <name>ew::ui::StatusLine</name>
        <message>
            <source>sample weave</source>
            <translation>gewebt</translation>
        </message>
        <message>
            <source>sample linear</source>
            <translation>linear</translation>
        </message>
        <message>
            <source>stretch</source>
            <translation>gedehnt</translation>
        </message>
        <message>
            <source>table</source>
            <translation>Tabelle</translation>
        </message>
        <message>
            <source>depth %1 mm</source>
            <translation>Tiefe %1 mm</translation>
        </message>
        <message>
            <source>contact %1 %</source>
            <translation>Kontakt %1 %</translation>
        </message>
        <message>
            <source>Middle of the transducer's face: left, back, up from the mannequin's origin</source>
            <translation>Mitte der Schallkopffläche: links, hinten, oben vom Ursprung des Übungskörpers</translation>
        </message>
        <message>
            <source>What the picture runs and how long each step takes (median of the last frames)</source>
            <translation>Was für das Bild gerechnet wird und wie lange jeder Schritt dauert (Median der letzten Bilder)</translation>
        </message>
        <message>
            <source>How much of the transducer's face touches the skin</source>
            <translation>Wie viel der Schallkopffläche die Haut berührt</translation>
        </message>
        <message>
            <source>plan: %1 = %2 ms</source>
            <translation>Plan: %1 = %2 ms</translation>
        </message>
        <message>
            <source>plan: %1 ms</source>
            <translation>Plan: %1 ms</translation>
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
            <source>Scan the open case (Ctrl+1)</source>
            <translation>Den offenen Fall schallen (Strg+1)</translation>
        </message>
        <message>
            <source>Edit the case and build volumes (Ctrl+2)</source>
            <translation>Den Fall bearbeiten und Volumen bauen (Strg+2)</translation>
        </message>
        <message>
            <source>simulation, not for diagnosis</source>
            <translation>Simulation, nicht zur Diagnose</translation>
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
            <source>Look from the patient's right</source>
            <translation>Von der rechten Seite des Patienten sehen</translation>
        </message>
        <message>
            <source>Left</source>
            <translation>Links</translation>
        </message>
        <message>
            <source>Look from the patient's left</source>
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
            <source>See through</source>
            <translation>Durchsicht</translation>
        </message>
        <message>
            <source>Make the body translucent</source>
            <translation>Den Körper durchscheinend machen</translation>
        </message>
        <message>
            <source>drag: slide on skin   wheel: tilt   Shift: rock   Ctrl: rotate   right drag: look around</source>
            <translation>Ziehen: gleiten   Rad: kippen   Umschalt: schaukeln   Strg: drehen   rechts ziehen: umsehen</translation>
        </message>
    </context>
    <context>
        <name>ew::ui::WorkstationHost</name>
        <message>
            <source>A panel could not be opened (%1); see Help, Plugins.</source>
            <translation>Ein Bereich ließ sich nicht öffnen (%1); siehe Hilfe, Erweiterungen.</translation>
        </message>
    </context>
</TS>
