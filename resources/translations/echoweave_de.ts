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
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>What a scan of this case has to show; nothing else is computed.</source>
        <translation>Was ein Scan dieses Falls zeigen muss; anderes wird nicht gerechnet.</translation>
    </message>
    <message>
        <source>Gain and DGC</source>
        <translation>Verstärkung und DGC</translation>
    </message>
    <message>
        <source>The trainee sets gain and depth compensation</source>
        <translation>Verstärkung und Tiefenausgleich stellt der Lernende ein</translation>
    </message>
    <message>
        <source>Beam width and focus</source>
        <translation>Strahlbreite und Fokus</translation>
    </message>
    <message>
        <source>The beam is narrow at the focus and wide elsewhere</source>
        <translation>Der Strahl ist im Fokus schmal und sonst breit</translation>
    </message>
    <message>
        <source>Slice thickness</source>
        <translation>Schichtdicke</translation>
    </message>
    <message>
        <source>The picture is an average over the thickness of the beam</source>
        <translation>Das Bild ist ein Mittel über die Dicke des Strahls</translation>
    </message>
    <message>
        <source>Shadow and enhancement</source>
        <translation>Schatten, Verstärkung</translation>
    </message>
    <message>
        <source>Dark behind stone, bone and gas, bright behind fluid</source>
        <translation>Dunkel hinter Stein, Knochen und Gas, hell hinter Flüssigkeit</translation>
    </message>
    <message>
        <source>Reverberation and mirror images</source>
        <translation>Nachhall und Spiegelbilder</translation>
    </message>
    <message>
        <source>Repeated and mirrored echoes of strong interfaces</source>
        <translation>Wiederholte und gespiegelte Echos starker Grenzflächen</translation>
    </message>
    <message>
        <source>Electronic noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>Noise of the amplifier, which grows with depth</source>
        <translation>Rauschen des Verstärkers, das mit der Tiefe wächst</translation>
    </message>
    <message>
        <source>Skin contact</source>
        <translation>Hautkontakt</translation>
    </message>
    <message>
        <source>Where the face is off the skin the picture goes dark</source>
        <translation>Wo die Sonde nicht aufliegt, wird das Bild dunkel</translation>
    </message>
    <message>
        <source>Switch on: %1</source>
        <translation>Einschalten: %1</translation>
    </message>
    <message>
        <source>Switch off: %1</source>
        <translation>Ausschalten: %1</translation>
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
        <source>How far from a volume&apos;s border its weight reaches full height</source>
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
        <source>Coverage from the volume&apos;s file</source>
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
    <name>ew::ui::CasePreparation</name>
    <message>
        <source>Preparing %1</source>
        <translation>%1 wird vorbereitet</translation>
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
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Magnify about the middle of the picture (Z, Shift+Z)</source>
        <translation>Um die Bildmitte vergrößern (Z, Umschalt+Z)</translation>
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
        <source>What the picture shows and how (F10)</source>
        <translation>Was das Bild zeigt und wie (F10)</translation>
    </message>
    <message>
        <source>What the scene does to the sound (F10)</source>
        <translation>Was die Szene mit dem Schall macht (F10)</translation>
    </message>
    <message>
        <source>The transducer and its beams (F10)</source>
        <translation>Die Sonde und ihre Strahlen (F10)</translation>
    </message>
    <message>
        <source>Depth of the first focus (comma, full stop); drag the marks beside the picture for the others</source>
        <translation>Tiefe des ersten Fokus (Komma, Punkt); die anderen mit den Marken neben dem Bild ziehen</translation>
    </message>
    <message>
        <source>Foci</source>
        <translation>Fokusse</translation>
    </message>
    <message>
        <source>Focus by</source>
        <translation>Fokus durch</translation>
    </message>
    <message>
        <source>Kernel</source>
        <translation>Faltung</translation>
    </message>
    <message>
        <source>Every depth is blurred by the width its beam has there (Shift+N)</source>
        <translation>Jede Tiefe wird so unscharf, wie ihr Strahl dort breit ist (Umschalt+N)</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Streckung</translation>
    </message>
    <message>
        <source>Rows out of focus are undersampled and stretched back (Shift+N)</source>
        <translation>Zeilen außerhalb des Fokus werden gröber abgetastet und wieder gestreckt (Umschalt+N)</translation>
    </message>
    <message>
        <source>Dynamic range</source>
        <translation>Dynamikbereich</translation>
    </message>
    <message>
        <source>Levels this far below full white become black (R, Shift+R)</source>
        <translation>So weit unter vollem Weiß wird es schwarz (R, Umschalt+R)</translation>
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
        <source>Hard</source>
        <translation>Hart</translation>
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
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>Edge enhancement (B, Shift+B)</source>
        <translation>Kantenanhebung (B, Umschalt+B)</translation>
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
        <source>How much of the last picture stays (P, Shift+P)</source>
        <translation>Wie viel vom letzten Bild stehen bleibt (P, Umschalt+P)</translation>
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
        <translation>Anpassen</translation>
    </message>
    <message>
        <source>Quality may fall while the probe moves fast, and refines at rest (F9)</source>
        <translation>Die Qualität darf sinken, solange sich die Sonde schnell bewegt, und steigt in Ruhe wieder (F9)</translation>
    </message>
    <message>
        <source>Cost…</source>
        <translation>Preis …</translation>
    </message>
    <message>
        <source>Cost of accuracy</source>
        <translation>Preis der Genauigkeit</translation>
    </message>
    <message>
        <source>Measure what accuracy costs on this machine (Ctrl+K)</source>
        <translation>Messen, was Genauigkeit auf diesem Rechner kostet (Strg+K)</translation>
    </message>
    <message>
        <source>Gain and DGC</source>
        <translation>Verstärkung und DGC</translation>
    </message>
    <message>
        <source>Whether gain and DGC act at all</source>
        <translation>Ob Verstärkung und DGC überhaupt wirken</translation>
    </message>
    <message>
        <source>Beam width and focus</source>
        <translation>Strahlbreite und Fokus</translation>
    </message>
    <message>
        <source>How much wider than recorded the beam is away from its focus</source>
        <translation>Wie viel breiter als aufgenommen der Strahl außerhalb des Fokus ist</translation>
    </message>
    <message>
        <source>The beam is narrow at the focus and wide elsewhere (F2)</source>
        <translation>Der Strahl ist im Fokus schmal und sonst breit (F2)</translation>
    </message>
    <message>
        <source>Slice thickness</source>
        <translation>Schichtdicke</translation>
    </message>
    <message>
        <source>Thickness of the slice, as a multiple of the probe&apos;s own</source>
        <translation>Dicke der Schicht als Vielfaches der Dicke der Sonde</translation>
    </message>
    <message>
        <source>The picture is an average over the thickness of the beam (F3)</source>
        <translation>Das Bild ist ein Mittel über die Dicke des Strahls (F3)</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>The thickness is averaged over %1 planes (Shift+F3 for the next)</source>
        <translation>Die Dicke wird über %1 Ebenen gemittelt (Umschalt+F3 für die nächste Zahl)</translation>
    </message>
    <message>
        <source>%1 dB/mm</source>
        <translation>%1 dB/mm</translation>
    </message>
    <message>
        <source>Shadow and enhancement</source>
        <translation>Schatten, Verstärkung</translation>
    </message>
    <message>
        <source>What each millimetre of strong echoes takes from the sound behind it</source>
        <translation>Was jeder Millimeter starker Echos dem Schall dahinter nimmt</translation>
    </message>
    <message>
        <source>Dark behind stone, bone and gas, bright behind fluid (F4)</source>
        <translation>Dunkel hinter Stein, Knochen und Gas, hell hinter Flüssigkeit (F4)</translation>
    </message>
    <message>
        <source>−%1 dB</source>
        <translation>−%1 dB</translation>
    </message>
    <message>
        <source>Reverberation</source>
        <translation>Nachhall</translation>
    </message>
    <message>
        <source>What the sound loses on each way there and back</source>
        <translation>Was der Schall auf jedem Hin- und Rückweg verliert</translation>
    </message>
    <message>
        <source>Echoes repeated between the face and strong interfaces (F5)</source>
        <translation>Echos, die zwischen Sonde und starken Grenzflächen hin und her laufen (F5)</translation>
    </message>
    <message>
        <source>Mirror images</source>
        <translation>Spiegelbilder</translation>
    </message>
    <message>
        <source>Mirror images beyond smooth strong interfaces (F6)</source>
        <translation>Spiegelbilder hinter glatten starken Grenzflächen (F6)</translation>
    </message>
    <message>
        <source>Electronic noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>Noise at the face, below full white; it grows with depth</source>
        <translation>Rauschen an der Sonde unter vollem Weiß; es wächst mit der Tiefe</translation>
    </message>
    <message>
        <source>Noise of the amplifier, which depth compensation lifts (F7)</source>
        <translation>Rauschen des Verstärkers, das der Tiefenausgleich anhebt (F7)</translation>
    </message>
    <message>
        <source>Skin contact</source>
        <translation>Hautkontakt</translation>
    </message>
    <message>
        <source>Gaps up to here are filled by gel</source>
        <translation>Spalte bis zu dieser Weite füllt das Gel</translation>
    </message>
    <message>
        <source>Where the face is off the skin the picture goes dark and rings down (F8)</source>
        <translation>Wo die Sonde nicht aufliegt, wird das Bild dunkel und klingt nach (F8)</translation>
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
        <source>Tilts the beams of a linear array (J, L)</source>
        <translation>Neigt die Strahlen einer Linearsonde (J, L)</translation>
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
        <source>The lines of a linear array fan out (V)</source>
        <translation>Die Linien einer Linearsonde fächern sich auf (V)</translation>
    </message>
    <message>
        <source>Scan lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Auflage</translation>
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
        <source>Which beam is shown over time, from one end of the face to the other (Ctrl+Left, Ctrl+Right)</source>
        <translation>Welcher Strahl über die Zeit gezeigt wird, von einem Ende der Sonde zum anderen (Strg+Links, Strg+Rechts)</translation>
    </message>
    <message>
        <source>Sweep</source>
        <translation>Durchlauf</translation>
    </message>
    <message>
        <source>Time across the strip (Y, Shift+Y)</source>
        <translation>Zeit über den Streifen (Y, Umschalt+Y)</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Kippen</translation>
    </message>
    <message>
        <source>The probe is at the bottom; put it at the top, as usual (U)</source>
        <translation>Die Sonde ist unten; nach oben setzen, wie üblich (U)</translation>
    </message>
    <message>
        <source>The probe is at the top, as usual; put it at the bottom (U)</source>
        <translation>Die Sonde ist oben, wie üblich; nach unten setzen (U)</translation>
    </message>
    <message>
        <source>Number of focus depths (N for the next)</source>
        <translation>Anzahl der Fokustiefen (N für die nächste Zahl)</translation>
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
        <translation>Preis der Genauigkeit</translation>
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
        <translation>Preis der Genauigkeit messen</translation>
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
        <source>Time each setting on the open volume, around the present pose</source>
        <translation>Jede Einstellung am offenen Volumen um die jetzige Lage messen</translation>
    </message>
</context>
<context>
    <name>ew::ui::DgcColumn</name>
    <message>
        <source>DGC %1</source>
        <translation>DGC %1</translation>
    </message>
    <message>
        <source>DGC</source>
        <translation>DGC</translation>
    </message>
    <message>
        <source>Reset DGC</source>
        <translation>DGC zurücksetzen</translation>
    </message>
    <message>
        <source>Depth gain compensation: one slider for each eighth of the depth. Click to put all of them back to the middle (Ctrl+0)</source>
        <translation>Tiefenausgleich: ein Regler für jedes Achtel der Tiefe. Ein Klick stellt alle wieder in die Mitte (Strg+0)</translation>
    </message>
    <message>
        <source>%1 to %2 mm: %3 %</source>
        <translation>%1 bis %2 mm: %3 %</translation>
    </message>
</context>
<context>
    <name>ew::ui::FileImportDialog</name>
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
        <source>Text burned into the pictures may stay</source>
        <translation>Eingebrannter Text in den Bildern darf bleiben</translation>
    </message>
    <message>
        <source>Part of the picture</source>
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
        <source>the whole picture, %1 x %2 pixels</source>
        <translation>das ganze Bild, %1 x %2 Pixel</translation>
    </message>
    <message>
        <source>Importing %1</source>
        <translation>%1 wird importiert</translation>
    </message>
    <message>
        <source>Save the pictures as a sequence</source>
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
        <source>Wrote %1; reconstruct it with a file that says how the probe moved.</source>
        <translation>%1 wurde geschrieben; mit einer Datei, die die Bewegung des Schallkopfs beschreibt, lässt sich daraus ein Volumen rekonstruieren.</translation>
    </message>
</context>
<context>
    <name>ew::ui::FocusScale</name>
    <message>
        <source>Drag a mark to its focus depth (comma, full stop)</source>
        <translation>Eine Marke auf ihre Fokustiefe ziehen (Komma, Punkt)</translation>
    </message>
    <message>
        <source>Depth in cm; the focus is off (F2)</source>
        <translation>Tiefe in cm; der Fokus ist aus (F2)</translation>
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
        <source>weighted by confidence: shadows count less</source>
        <translation>nach Vertrauen gewichtet: Schatten zählen weniger</translation>
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
    <message>
        <source>Keep which frame each voxel came from</source>
        <translation>Behalten, aus welchem Bild jeder Voxel stammt</translation>
    </message>
    <message>
        <source>Then a point of the picture leads to its source frame; 2 bytes a voxel more</source>
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
        <source>Preparing the cards</source>
        <translation>Karten werden vorbereitet</translation>
    </message>
    <message>
        <source>The window was not ready within %1 s; try a smaller volume.</source>
        <translation>Das Fenster war nach %1 s nicht bereit; bitte ein kleineres Volumen versuchen.</translation>
    </message>
    <message>
        <source>The picture cannot be written to &apos;%1&apos;; choose a folder you may write to.</source>
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
        <source>Number of foci</source>
        <translation>Anzahl der Fokusse</translation>
    </message>
    <message>
        <source>Focus by kernel or stretch</source>
        <translation>Fokus durch Faltung oder Streckung</translation>
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
        <source>Stronger edges</source>
        <translation>Kanten stärker</translation>
    </message>
    <message>
        <source>Weaker edges</source>
        <translation>Kanten schwächer</translation>
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
        <source>Swap top and bottom</source>
        <translation>Oben und unten tauschen</translation>
    </message>
    <message>
        <source>&amp;Effects</source>
        <translation>&amp;Effekte</translation>
    </message>
    <message>
        <source>Beam width and focus</source>
        <translation>Strahlbreite und Fokus</translation>
    </message>
    <message>
        <source>Slice thickness</source>
        <translation>Schichtdicke</translation>
    </message>
    <message>
        <source>Planes of the slice thickness</source>
        <translation>Ebenen der Schichtdicke</translation>
    </message>
    <message>
        <source>Shadow and enhancement</source>
        <translation>Schatten, Verstärkung</translation>
    </message>
    <message>
        <source>Reverberation</source>
        <translation>Nachhall</translation>
    </message>
    <message>
        <source>Mirror images</source>
        <translation>Spiegelbilder</translation>
    </message>
    <message>
        <source>Electronic noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>Skin contact</source>
        <translation>Hautkontakt</translation>
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
        <translation>Anpassen: sinkt, solange sich die Sonde schnell bewegt</translation>
    </message>
    <message>
        <source>Next page of the console</source>
        <translation>Nächste Seite der Konsole</translation>
    </message>
    <message>
        <source>&amp;Cost of accuracy…</source>
        <translation>&amp;Preis der Genauigkeit …</translation>
    </message>
    <message>
        <source>weave, linear, cubic</source>
        <translation>Weben, linear, kubisch</translation>
    </message>
    <message>
        <source>adaptive quality</source>
        <translation>Qualität anpassen</translation>
    </message>
    <message>
        <source>next page of the console</source>
        <translation>nächste Seite der Konsole</translation>
    </message>
    <message>
        <source>cost of accuracy</source>
        <translation>Preis der Genauigkeit</translation>
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
        <source>number of foci, kernel or stretch</source>
        <translation>Fokusse, Faltung oder Streckung</translation>
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
        <source>edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>persistence</source>
        <translation>Persistenz</translation>
    </message>
    <message>
        <source>swap left and right, top and bottom</source>
        <translation>links/rechts, oben/unten tauschen</translation>
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
        <source>beam width, slice thickness</source>
        <translation>Strahlbreite, Schichtdicke</translation>
    </message>
    <message>
        <source>shadow and enhancement</source>
        <translation>Schatten und Verstärkung</translation>
    </message>
    <message>
        <source>reverberation, mirror images</source>
        <translation>Nachhall, Spiegelbilder</translation>
    </message>
    <message>
        <source>noise, skin contact</source>
        <translation>Rauschen, Hautkontakt</translation>
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
        <source>All that EchoWeave reads (case.json *.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz *.dcm *.vol *.v00 *.raw *.png *.jpg *.pgm);;Cases (case.json);;Sweeps (*.igs.mha *.igs.mhd *.igs.nrrd *.seq.mha *.seq.nrrd *.mha *.mhd *.nrrd);;Volumes (*.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz);;DICOM, Kretz, raw samples, pictures (*)</source>
        <translation>Alles, was EchoWeave liest (case.json *.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz *.dcm *.vol *.v00 *.raw *.png *.jpg *.pgm);;Fälle (case.json);;Schwenks (*.igs.mha *.igs.mhd *.igs.nrrd *.seq.mha *.seq.nrrd *.mha *.mhd *.nrrd);;Volumen (*.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz);;DICOM, Kretz, Rohdaten, Bilder (*)</translation>
    </message>
    <message>
        <source>Where does this &amp;come from?</source>
        <translation>&amp;Woher kommt das?</translation>
    </message>
    <message>
        <source>I, Alt + click</source>
        <translation>I, Alt + Klick</translation>
    </message>
    <message>
        <source>which frame a point came from</source>
        <translation>aus welchem Bild ein Punkt stammt</translation>
    </message>
    <message>
        <source>The strip of the M-mode shows one beam over time, no place in a picture. Switch to B or B + M (M), then click a point of the picture.</source>
        <translation>Der Streifen des M-Modus zeigt einen Strahl über die Zeit, keinen Ort in einem Bild. Auf B oder B + M umschalten (M), dann einen Punkt des Bildes anklicken.</translation>
    </message>
    <message>
        <source>This point lies beside the image. Click a point inside the fan.</source>
        <translation>Dieser Punkt liegt neben dem Bild. Einen Punkt innerhalb des Fächers anklicken.</translation>
    </message>
    <message>
        <source>This volume does not say which frame a voxel came from. A volume that is made here from a recorded sweep does: open the sweep (Ctrl+O), leave &apos;Keep which frame each voxel came from&apos; switched on, and make the volume.</source>
        <translation>Dieses Volumen sagt nicht, aus welchem Bild ein Voxel stammt. Ein Volumen, das hier aus einem aufgenommenen Schwenk gemacht wird, sagt es: den Schwenk öffnen (Strg+O), „Behalten, aus welchem Bild jeder Voxel stammt“ eingeschaltet lassen und das Volumen machen.</translation>
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
        <source>There is no file or folder &apos;%1&apos;; check the name, or choose it with Open.</source>
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
        <source>There are no plugin folders. Put a plugin&apos;s folder into lib/plugins beside the program, or name a folder in ECHOWEAVE_PLUGINS, and start again.</source>
        <translation>Es gibt keine Ordner für Erweiterungen. Legen Sie den Ordner einer Erweiterung in lib/plugins neben dem Programm ab, oder nennen Sie einen Ordner in ECHOWEAVE_PLUGINS, und starten Sie neu.</translation>
    </message>
    <message>
        <source>No plugins were found in %1. Put a plugin&apos;s folder there and start again.</source>
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
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
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
        <source>Middle of the transducer&apos;s face: left, back, up from the mannequin&apos;s origin</source>
        <translation>Mitte der Schallkopffläche: links, hinten, oben vom Ursprung des Übungskörpers</translation>
    </message>
    <message>
        <source>How much of the transducer&apos;s face touches the skin</source>
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
    <message>
        <source>sample cubic</source>
        <translation>Abtasten kubisch</translation>
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
        <source>noise</source>
        <translation>Rauschen</translation>
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
        <source>M-mode</source>
        <translation>M-Modus</translation>
    </message>
    <message>
        <source>weave</source>
        <translation>Weben</translation>
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
        <translation>Die Sonde bewegt sich schnell und Bilder dauern lange: Die Qualität sinkt, bis sie ruht (Anpassen, F9)</translation>
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
        <source>What the picture runs, ms (median of the last frames)</source>
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
        <source>From the hand to the picture, ms; pictures: %1</source>
        <translation>Von der Hand zum Bild, ms; Bilder: %1</translation>
    </message>
    <message>
        <source>median %1, 95 % %2, 99 % %3, worst %4</source>
        <translation>Median %1, 95 % %2, 99 % %3, längste %4</translation>
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
