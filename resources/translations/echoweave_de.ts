<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>ew::EffectInfo</name>
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
</context>
<context>
    <name>ew::StepKind</name>
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
    <name>ew::door::PluginFault</name>
    <message>
        <source>The plugin &apos;%1&apos; could not start (%3); the rest of the program is not affected.</source>
        <translation>Die Erweiterung „%1“ ließ sich nicht starten (%3); das übrige Programm ist davon nicht betroffen.</translation>
    </message>
    <message>
        <source>The panel &apos;%2&apos; of the plugin &apos;%1&apos; could not be opened (%3); the rest of the program is not affected.</source>
        <translation>Der Bereich „%2“ der Erweiterung „%1“ ließ sich nicht öffnen (%3); das übrige Programm ist davon nicht betroffen.</translation>
    </message>
    <message>
        <source>The command &apos;%2&apos; of the plugin &apos;%1&apos; stopped unexpectedly (%3); please report it with the command you gave.</source>
        <translation>Der Befehl „%2“ der Erweiterung „%1“ brach unerwartet ab (%3); bitte melden Sie es mit dem Befehl, den Sie gegeben haben.</translation>
    </message>
    <message>
        <source>There is not enough memory for &apos;%2&apos; of the plugin &apos;%1&apos;; use a coarser spacing or a smaller input.</source>
        <translation>Für „%2“ der Erweiterung „%1“ reicht der Speicher nicht; nehmen Sie einen gröberen Abstand oder eine kleinere Eingabe.</translation>
    </message>
    <message>
        <source>There is not enough memory for &apos;%2&apos; of the plugin &apos;%1&apos;; close other programs or choose a coarser spacing.</source>
        <translation>Für „%2“ der Erweiterung „%1“ reicht der Speicher nicht; schließen Sie andere Programme oder wählen Sie einen gröberen Abstand.</translation>
    </message>
    <message>
        <source>&apos;%2&apos; of the plugin &apos;%1&apos; stopped unexpectedly (%3); please report it with what you did.</source>
        <translation>„%2“ der Erweiterung „%1“ brach unerwartet ab (%3); bitte melden Sie es und was Sie getan haben.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; could not take over the result of &apos;%2&apos; (%3); please report it with what you did.</source>
        <translation>Die Erweiterung „%1“ konnte das Ergebnis von „%2“ nicht übernehmen (%3); bitte melden Sie es und was Sie getan haben.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; could not follow a change of the case (%3); what its panel shows may be out of date.</source>
        <translation>Die Erweiterung „%1“ konnte einer Änderung des Falls nicht folgen (%3); was ihr Bereich zeigt, kann veraltet sein.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; could not undo the last step (%3); save under another name before you go on.</source>
        <translation>Die Erweiterung „%1“ konnte den letzten Schritt nicht zurücknehmen (%3); speichern Sie unter einem anderen Namen, bevor Sie weitermachen.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; could not redo the step (%3); save under another name before you go on.</source>
        <translation>Die Erweiterung „%1“ konnte den Schritt nicht wiederholen (%3); speichern Sie unter einem anderen Namen, bevor Sie weitermachen.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; could not save (%3); try another name or folder.</source>
        <translation>Die Erweiterung „%1“ konnte nicht speichern (%3); versuchen Sie es mit einem anderen Namen oder Ordner.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; could not say what its panel holds (%3); save under another name before you go on.</source>
        <translation>Die Erweiterung „%1“ konnte nicht sagen, was ihr Bereich enthält (%3); speichern Sie unter einem anderen Namen, bevor Sie weitermachen.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; could not follow the scan (%3); what it shows may be out of date.</source>
        <translation>Die Erweiterung „%1“ konnte dem Scan nicht folgen (%3); was sie zeigt, kann veraltet sein.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; could not move the probe (%3); press Escape to take the probe back.</source>
        <translation>Die Erweiterung „%1“ konnte den Schallkopf nicht bewegen (%3); mit Esc nehmen Sie ihn zurück.</translation>
    </message>
    <message>
        <source>&apos;%2&apos; of the plugin &apos;%1&apos; did not come to its end (%3); please report it with what you did.</source>
        <translation>„%2“ der Erweiterung „%1“ kam nicht zu Ende (%3); bitte melden Sie es und was Sie getan haben.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; could not say what it still holds (%3); save your work before you close the window.</source>
        <translation>Die Erweiterung „%1“ konnte nicht sagen, was sie noch enthält (%3); speichern Sie Ihre Arbeit, bevor Sie das Fenster schließen.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; met a problem that it did not foresee (%3); save your work, and please report it with what you did.</source>
        <translation>Die Erweiterung „%1“ stieß auf ein unvorhergesehenes Problem (%3); speichern Sie Ihre Arbeit, und bitte melden Sie es und was Sie getan haben.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; did not end in order (%3); nothing of your work is affected.</source>
        <translation>Die Erweiterung „%1“ endete nicht ordentlich (%3); Ihre Arbeit ist davon nicht betroffen.</translation>
    </message>
</context>
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
        <source>Move the volume, %1</source>
        <translation>Volumen verschieben, %1</translation>
    </message>
    <message>
        <source>A marked field cannot be used as it is; correct it first, or undo.</source>
        <translation>Ein markiertes Feld ist so nicht brauchbar; bitte erst berichtigen oder rückgängig machen.</translation>
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
        <translation>eine Zeile je Befund</translation>
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
        <translation>Geschallt wird gerade nicht das Volumen dieses Falls; wählen Sie Ansicht, Volumen des Falls schallen.</translation>
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
        <translation>Von hier sieht der Schallkopf das Volumen nicht; nehmen Sie eine andere Stelle oder verschieben Sie das Volumen.</translation>
    </message>
    <message>
        <source>There is no probe &apos;%1&apos;; take it out.</source>
        <translation>Es gibt keinen Schallkopf „%1“; nehmen Sie ihn heraus.</translation>
    </message>
    <message>
        <source>Nothing is wrong with this case.</source>
        <translation>An diesem Fall ist nichts auszusetzen.</translation>
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
        <translation>Noch keine Stufen: Ordnen Sie das Paar zu</translation>
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
        <translation>Klicken Sie dieselbe Stelle in der festen und in der bewegten Ansicht an (P)</translation>
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
        <translation>Dieses Stellenpaar widerspricht den anderen; sehen Sie es noch einmal an oder entfernen Sie es</translation>
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
        <translation>Klicken Sie eine Stelle in der festen Ansicht an, dann dieselbe in der bewegten.</translation>
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
        <translation>Ordnen Sie es zu, setzen Sie Landmarken in beiden Volumen, oder schieben Sie es mit den Tasten.</translation>
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
    <name>ew::stitching::Phrases</name>
    <message>
        <source>Inspecting %1</source>
        <translation>%1 wird untersucht</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>Registering %1 and %2</source>
        <translation>%1 und %2 werden zugeordnet</translation>
    </message>
    <message>
        <source>Deforming %1 and %2</source>
        <translation>%1 und %2 werden verformt</translation>
    </message>
    <message>
        <source>Registering</source>
        <translation>Zuordnen</translation>
    </message>
    <message>
        <source>Preparing images</source>
        <translation>Bilder werden vorbereitet</translation>
    </message>
    <message>
        <source>Preparing the images</source>
        <translation>Bilder werden vorbereitet</translation>
    </message>
    <message>
        <source>Comparing images</source>
        <translation>Bilder werden verglichen</translation>
    </message>
    <message>
        <source>Comparing</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Looking for shadows</source>
        <translation>Schatten werden gesucht</translation>
    </message>
    <message>
        <source>Searching for large motion</source>
        <translation>Große Bewegungen werden gesucht</translation>
    </message>
    <message>
        <source>Writing out the displacements</source>
        <translation>Verschiebungen werden ausgeschrieben</translation>
    </message>
    <message>
        <source>Warping the moving volume</source>
        <translation>Das bewegte Volumen wird verformt</translation>
    </message>
    <message>
        <source>Inverting the deformation</source>
        <translation>Die Verformung wird umgekehrt</translation>
    </message>
    <message>
        <source>Placing subvolumes</source>
        <translation>Teilvolumen werden platziert</translation>
    </message>
    <message>
        <source>Looking at overlaps</source>
        <translation>Überlappungen werden angesehen</translation>
    </message>
    <message>
        <source>Combining deformations</source>
        <translation>Verformungen werden zusammengeführt</translation>
    </message>
    <message>
        <source>Unfolding</source>
        <translation>Faltungen werden entfernt</translation>
    </message>
    <message>
        <source>Comparing views</source>
        <translation>Ansichten werden verglichen</translation>
    </message>
    <message>
        <source>Looking for seams</source>
        <translation>Nähte werden gesucht</translation>
    </message>
    <message>
        <source>Cutting seams</source>
        <translation>Nähte werden geschnitten</translation>
    </message>
    <message>
        <source>Measuring distances from the border</source>
        <translation>Abstände vom Rand werden gemessen</translation>
    </message>
    <message>
        <source>Blending</source>
        <translation>Mischen</translation>
    </message>
    <message>
        <source>Copying</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Reading frames</source>
        <translation>Bilder werden gelesen</translation>
    </message>
    <message>
        <source>Reading voxels</source>
        <translation>Voxel werden gelesen</translation>
    </message>
    <message>
        <source>Writing voxels</source>
        <translation>Voxel werden geschrieben</translation>
    </message>
    <message>
        <source>Writing vectors</source>
        <translation>Vektoren werden geschrieben</translation>
    </message>
    <message>
        <source>Pasting frames</source>
        <translation>Bilder werden eingefügt</translation>
    </message>
    <message>
        <source>Estimating confidence</source>
        <translation>Verlässlichkeit wird geschätzt</translation>
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
        <source>Reading frames at the voxels</source>
        <translation>Bilder werden an den Voxeln gelesen</translation>
    </message>
    <message>
        <source>Comparing sweeps</source>
        <translation>Schwenks werden verglichen</translation>
    </message>
    <message>
        <source>Converting scan lines</source>
        <translation>Bildzeilen werden umgewandelt</translation>
    </message>
    <message>
        <source>The stitch project has no volumes; add some.</source>
        <translation>Das Stitching-Projekt hat keine Volumen; fügen Sie welche hinzu.</translation>
    </message>
    <message>
        <source>The project has no volume yet; add one before it is saved.</source>
        <translation>Das Projekt hat noch kein Volumen; fügen Sie eines hinzu, bevor es gespeichert wird.</translation>
    </message>
    <message>
        <source>The step %1 would need %2 MiB of memory, more than the %3 MiB allowed; use a coarser spacing_mm or fewer volumes at a time.</source>
        <translation>Der Schritt „%1“ bräuchte %2 MiB Speicher, mehr als die erlaubten %3 MiB; nehmen Sie einen gröberen Voxelabstand oder weniger Volumen auf einmal.</translation>
    </message>
    <message>
        <source>The reconstruction of &apos;%1&apos; is not there.</source>
        <translation>Die Rekonstruktion von „%1“ ist nicht da.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be written (%2); choose another folder.</source>
        <translation>„%1“ kann nicht geschrieben werden (%2); wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; gave no volume; check what kind of file it is.</source>
        <translation>„%1“ ergab kein Volumen; prüfen Sie, was für eine Datei es ist.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in the stitch project is %2; it must be %3.</source>
        <translation>„%1“ im Stitching-Projekt ist %2; es muss %3 sein.</translation>
    </message>
    <message>
        <source>not known here</source>
        <translation>hier nicht bekannt</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>nicht vorhanden</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>eines von %1</translation>
    </message>
    <message>
        <source>The stitch project has format %1, and this program reads formats up to %2; open it with a newer EchoWeave.</source>
        <translation>Das Stitching-Projekt hat das Format %1, und dieses Programm liest Formate bis %2; öffnen Sie es mit einem neueren EchoWeave.</translation>
    </message>
    <message>
        <source>The transform in &apos;%1&apos; cannot be used. %2</source>
        <translation>Die Transformation in „%1“ ist nicht zu gebrauchen. %2</translation>
    </message>
    <message>
        <source>The stitch project nests deeper than %1 levels, which no file of this program does; check that it is the right file.</source>
        <translation>Das Stitching-Projekt ist tiefer als %1 Ebenen geschachtelt, wie keine Datei dieses Programms; prüfen Sie, ob es die richtige Datei ist.</translation>
    </message>
    <message>
        <source>The stitch project is not valid JSON: it breaks at line %1, column %2; correct it there or restore an earlier copy.</source>
        <translation>Das Stitching-Projekt ist kein gültiges JSON: Es bricht in Zeile %1, Spalte %2 ab; berichtigen Sie es dort oder nehmen Sie eine frühere Kopie.</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; cannot be written (%2); choose one you may write to.</source>
        <translation>In den Ordner „%1“ kann nicht geschrieben werden (%2); wählen Sie einen, in den Sie schreiben dürfen.</translation>
    </message>
    <message>
        <source>Another run is at work in &apos;%1&apos;; wait until it has ended, or choose another folder.</source>
        <translation>In „%1“ arbeitet schon ein anderer Lauf; warten Sie, bis er zu Ende ist, oder wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read; check the medium it is on.</source>
        <translation>„%1“ kann nicht gelesen werden; prüfen Sie den Datenträger.</translation>
    </message>
    <message>
        <source>The file that keeps unsaved work (&apos;%1&apos;) is damaged; it is left where it is and nothing was reopened.</source>
        <translation>Die Datei mit ungespeicherter Arbeit („%1“) ist beschädigt; sie bleibt, wo sie ist, und nichts wurde wieder geöffnet.</translation>
    </message>
    <message>
        <source>A volume needs a name; type one.</source>
        <translation>Ein Volumen braucht einen Namen; geben Sie einen ein.</translation>
    </message>
    <message>
        <source>Another volume is called &apos;%1&apos; already; choose another name.</source>
        <translation>Ein anderes Volumen heißt schon „%1“; wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>There is one volume alone.</source>
        <translation>Es gibt nur ein Volumen.</translation>
    </message>
    <message>
        <source>The recorded places were taken as they are.</source>
        <translation>Die aufgezeichneten Lagen wurden übernommen, wie sie sind.</translation>
    </message>
    <message>
        <source>There is no volume to stitch; add at least one.</source>
        <translation>Es gibt kein Volumen zu verbinden; fügen Sie mindestens eines hinzu.</translation>
    </message>
    <message>
        <source>At most %1 volumes can be stitched at once; stitch them in groups.</source>
        <translation>Höchstens %1 Volumen können auf einmal verbunden werden; verbinden Sie sie in Gruppen.</translation>
    </message>
    <message>
        <source>Stitching would need more memory than there is, and the limit is %1; choose a coarser spacing, or check whether one of the volumes is placed far away.</source>
        <translation>Das Verbinden bräuchte mehr Speicher, als es gibt, und die Grenze ist %1; wählen Sie einen gröberen Voxelabstand oder prüfen Sie, ob eines der Volumen weit entfernt liegt.</translation>
    </message>
    <message>
        <source>Stitching would need %1, and the limit is %2; choose a coarser spacing, or check whether one of the volumes is placed far away.</source>
        <translation>Das Verbinden bräuchte %1, und die Grenze ist %2; wählen Sie einen gröberen Voxelabstand oder prüfen Sie, ob eines der Volumen weit entfernt liegt.</translation>
    </message>
    <message>
        <source>Joining would need %1 MiB, and the limit is %2 MiB; choose a coarser spacing or smaller blocks.</source>
        <translation>Das Zusammenfügen bräuchte %1 MiB, und die Grenze ist %2 MiB; wählen Sie einen gröberen Voxelabstand oder kleinere Blöcke.</translation>
    </message>
    <message>
        <source>Volume &apos;%1&apos; cannot be stitched. %2</source>
        <translation>Das Volumen „%1“ kann nicht verbunden werden. %2</translation>
    </message>
    <message>
        <source>The spacing of the result must be a positive number of mm, or 0 for the finest of the inputs.</source>
        <translation>Der Voxelabstand des Ergebnisses muss eine positive Zahl in mm sein, oder 0 für den feinsten der Eingaben.</translation>
    </message>
    <message>
        <source>The feather width must be 0 or a positive number of mm.</source>
        <translation>Die Breite des Auslaufens muss 0 oder eine positive Zahl in mm sein.</translation>
    </message>
    <message>
        <source>The weight of interpolated voxels must be above 0 and at most 1.</source>
        <translation>Das Gewicht interpolierter Voxel muss über 0 und höchstens 1 sein.</translation>
    </message>
    <message>
        <source>The options of the equalisation are out of range; use cells and knots above 0.</source>
        <translation>Die Einstellungen des Angleichens liegen außerhalb ihres Bereichs; nehmen Sie Zellen und Knoten über 0.</translation>
    </message>
    <message>
        <source>The blocks of a join must be at least 8 voxels wide.</source>
        <translation>Die Blöcke müssen mindestens 8 Voxel breit sein.</translation>
    </message>
    <message>
        <source>The seams were found for another grid; find them again for this one.</source>
        <translation>Die Nähte wurden für ein anderes Gitter gefunden; suchen Sie sie für dieses neu.</translation>
    </message>
    <message>
        <source>The seams have levels of other volumes; find them again.</source>
        <translation>Die Nähte haben Pegel anderer Volumen; suchen Sie sie neu.</translation>
    </message>
    <message>
        <source>The seams name more volumes than there are; find them again.</source>
        <translation>Die Nähte nennen mehr Volumen, als es gibt; suchen Sie sie neu.</translation>
    </message>
    <message>
        <source>Its grey correction has a number that cannot be used.</source>
        <translation>Seine Graukorrektur enthält eine Zahl, die nicht zu gebrauchen ist.</translation>
    </message>
    <message>
        <source>Its bend has a displacement too many, too few or without a number.</source>
        <translation>Seine Verformung hat eine Verschiebung zu viel, zu wenig oder ohne Zahl.</translation>
    </message>
    <message>
        <source>The cells of the seam must be wider than 0 mm.</source>
        <translation>Die Zellen der Naht müssen breiter als 0 mm sein.</translation>
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
        <source>The weights of a seam must be 0 or positive.</source>
        <translation>Die Gewichte einer Naht müssen 0 oder positiv sein.</translation>
    </message>
    <message>
        <source>A stroke of the seam editor names a volume that is not there, or has no place or radius.</source>
        <translation>Ein Strich des Nahteditors nennt ein Volumen, das es nicht gibt, oder hat keinen Ort oder Radius.</translation>
    </message>
    <message>
        <source>The %1 volume has %2 echo values for %3 voxels.</source>
        <translation>Im %1 Volumen sind %2 Echowerte für %3 Voxel.</translation>
    </message>
    <message>
        <source>The coverage of the %1 volume has %2 values for %3 voxels.</source>
        <translation>Die Abdeckung des %1 Volumens hat %2 Werte für %3 Voxel.</translation>
    </message>
    <message>
        <source>The direction of the beam of the %1 volume is no direction.</source>
        <translation>Die Strahlrichtung des %1 Volumens ist keine Richtung.</translation>
    </message>
    <message>
        <source>The apex of the beams of the %1 volume is no place.</source>
        <translation>Der Scheitel der Strahlen des %1 Volumens ist kein Ort.</translation>
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
        <source>No voxel of the %1 volume was measured; choose a volume that holds an echo.</source>
        <translation>Kein Voxel des %1 Volumens wurde gemessen; wählen Sie ein Volumen, das ein Echo enthält.</translation>
    </message>
    <message>
        <source>The control grid has %1 displacements for %2 nodes; write it anew.</source>
        <translation>Das Kontrollgitter hat %1 Verschiebungen für %2 Knoten; schreiben Sie es neu.</translation>
    </message>
    <message>
        <source>The deformation folds in %1 of its control grid and has no inverse; register again with a stiffer grid.</source>
        <translation>Die Verformung faltet sich in %1 ihres Kontrollgitters und hat keine Umkehrung; ordnen Sie mit einem steiferen Gitter neu zu.</translation>
    </message>
    <message>
        <source>The moving volume holds another number of voxels than its grid says; write it anew.</source>
        <translation>Das bewegte Volumen enthält eine andere Zahl von Voxeln, als sein Gitter sagt; schreiben Sie es neu.</translation>
    </message>
    <message>
        <source>The %1 volume has more than 2^30 voxels; resample it to a coarser spacing first.</source>
        <translation>Im %1 Volumen sind mehr als 2^30 Voxel; rechnen Sie es erst auf einen gröberen Voxelabstand um.</translation>
    </message>
    <message>
        <source>The option %1 is %2; it must be %3.</source>
        <translation>Die Einstellung %1 ist %2; sie muss %3 sein.</translation>
    </message>
    <message>
        <source>The covariance of %1 %2; a covariance is symmetric and no variance is negative.</source>
        <translation>Die Kovarianz von %1 %2; eine Kovarianz ist symmetrisch, und keine Varianz ist negativ.</translation>
    </message>
    <message>
        <source>There is no subvolume to place; add at least one.</source>
        <translation>Es gibt kein Teilvolumen zu platzieren; fügen Sie mindestens eines hinzu.</translation>
    </message>
    <message>
        <source>The option %1 must be above 0.</source>
        <translation>Die Einstellung %1 muss über 0 sein.</translation>
    </message>
    <message>
        <source>At least one iteration is needed.</source>
        <translation>Mindestens ein Durchgang ist nötig.</translation>
    </message>
    <message>
        <source>The pose of %1 cannot be used: %2</source>
        <translation>Die Lage von %1 ist nicht zu gebrauchen: %2</translation>
    </message>
    <message>
        <source>The centre of the tracker&apos;s covariance of %1 is not a number.</source>
        <translation>Die Mitte der Tracker-Kovarianz von %1 ist keine Zahl.</translation>
    </message>
    <message>
        <source>%1 names a subvolume that does not exist; there are %2.</source>
        <translation>%1 nennt ein Teilvolumen, das es nicht gibt; es sind %2.</translation>
    </message>
    <message>
        <source>%1 joins %2 with itself.</source>
        <translation>%1 verbindet %2 mit sich selbst.</translation>
    </message>
    <message>
        <source>The transform of the pair %1 cannot be used: %2</source>
        <translation>Die Transformation des Paares %1 ist nicht zu gebrauchen: %2</translation>
    </message>
    <message>
        <source>The pair %1 has a centre that is not a number or a trust outside 0..1.</source>
        <translation>Das Paar %1 hat eine Mitte, die keine Zahl ist, oder ein Vertrauen außerhalb von 0..1.</translation>
    </message>
    <message>
        <source>The solver of poses failed (%1).</source>
        <translation>Das Lösen der Lagen ist fehlgeschlagen (%1).</translation>
    </message>
    <message>
        <source>The pick error of landmarks must be a length above 0 mm.</source>
        <translation>Der Klickfehler der Landmarken muss eine Länge über 0 mm sein.</translation>
    </message>
    <message>
        <source>The landmark %1 has a coordinate that is not a number; correct or remove it.</source>
        <translation>Die Landmarke %1 hat eine Koordinate, die keine Zahl ist; berichtigen oder entfernen Sie sie.</translation>
    </message>
    <message>
        <source>A volume is missing: name two.</source>
        <translation>Ein Volumen fehlt: nennen Sie zwei.</translation>
    </message>
    <message>
        <source>Regions and windows need a side above 0 mm.</source>
        <translation>Gebiete und Fenster brauchen eine Seite über 0 mm.</translation>
    </message>
    <message>
        <source>The deformation has another number of vectors than its lattice has nodes.</source>
        <translation>Die Verformung hat eine andere Zahl von Vektoren, als ihr Gitter Knoten hat.</translation>
    </message>
    <message>
        <source>The matching option %1 is %2; it must be %3.</source>
        <translation>Die Einstellung %1 des Zuordnens ist %2; sie muss %3 sein.</translation>
    </message>
    <message>
        <source>The registration option %1 is %2; it must be %3.</source>
        <translation>Die Einstellung %1 des Zuordnens ist %2; sie muss %3 sein.</translation>
    </message>
    <message>
        <source>The images at voxels of %1 mm are too large to register; ask for a coarser finest level.</source>
        <translation>Die Bilder mit Voxeln zu %1 mm sind zu groß zum Zuordnen; verlangen Sie eine gröbere feinste Stufe.</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>festen</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>bewegten</translation>
    </message>
    <message>
        <source>There is no file &quot;%1&quot;; check its name and folder.</source>
        <translation>Es gibt keine Datei „%1“; prüfen Sie Namen und Ordner.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read (%2); check its permissions.</source>
        <translation>„%1“ kann nicht gelesen werden (%2); prüfen Sie die Zugriffsrechte.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be opened; check its permissions.</source>
        <translation>„%1“ kann nicht geöffnet werden; prüfen Sie die Zugriffsrechte.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a regular file; choose a file.</source>
        <translation>„%1“ ist keine gewöhnliche Datei; wählen Sie eine Datei.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has an ending that is not read; give a .mha, .mhd, .nrrd, .nhdr, .nii or .nii.gz file.</source>
        <translation>„%1“ hat eine Endung, die nicht gelesen wird; geben Sie eine Datei .mha, .mhd, .nrrd, .nhdr, .nii oder .nii.gz.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a MetaImage: a header line has no &quot;=&quot;; check what kind of file it is.</source>
        <translation>„%1“ ist kein MetaImage: Eine Kopfzeile hat kein „=“; prüfen Sie, was für eine Datei es ist.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a NRRD file; check what kind of file it is.</source>
        <translation>„%1“ ist keine NRRD-Datei; prüfen Sie, was für eine Datei es ist.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a text header followed by samples; check what kind of file it is.</source>
        <translation>„%1“ ist kein Textkopf mit Abtastwerten danach; prüfen Sie, was für eine Datei es ist.</translation>
    </message>
    <message>
        <source>The header of &quot;%1&quot; ends before it says where the samples are (ElementDataFile); get the file again.</source>
        <translation>Der Kopf von „%1“ endet, bevor er sagt, wo die Abtastwerte sind (ElementDataFile); besorgen Sie die Datei neu.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is too short: its header promises %2 bytes of samples, the file has %3; get the file again.</source>
        <translation>„%1“ ist zu kurz: Ihr Kopf verspricht %2 Byte, die Datei hat %3; besorgen Sie die Datei neu.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is too short: its header promises %2 compressed bytes, the file has %3; get the file again.</source>
        <translation>„%1“ ist zu kurz: Ihr Kopf verspricht %2 gepackte Byte, die Datei hat %3; besorgen Sie die Datei neu.</translation>
    </message>
    <message>
        <source>The compressed samples of &quot;%1&quot; are damaged; get the file again.</source>
        <translation>Die gepackten Abtastwerte von „%1“ sind beschädigt; besorgen Sie die Datei neu.</translation>
    </message>
    <message>
        <source>The compressed samples of &quot;%1&quot; break off after %2 unpacked bytes; get the file again.</source>
        <translation>Die gepackten Abtastwerte von „%1“ brechen nach %2 ausgepackten Byte ab; besorgen Sie die Datei neu.</translation>
    </message>
    <message>
        <source>In &quot;%1&quot;, %2 is &quot;%3&quot;, but %4 is needed; correct the header or export the file again.</source>
        <translation>In „%1“ ist %2 „%3“, nötig ist aber %4; berichtigen Sie den Kopf oder exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; keeps its samples in &quot;%2&quot;, which is not there; put both files into one folder.</source>
        <translation>„%1“ hat seine Abtastwerte in „%2“, das nicht da ist; legen Sie beide Dateien in einen Ordner.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; holds no voxels (%2); choose a file with samples in it.</source>
        <translation>„%1“ enthält keine Voxel (%2); wählen Sie eine Datei mit Inhalt.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has %2 values per sample, but one value or a colour is needed; export the echo levels alone.</source>
        <translation>„%1“ hat %2 Werte je Punkt, nötig ist einer oder eine Farbe; exportieren Sie nur die Echopegel.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a recorded sweep, not a volume; reconstruct it first.</source>
        <translation>„%1“ ist ein aufgezeichneter Schwenk, kein Volumen; rekonstruieren Sie ihn zuerst.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a volume, not a recorded sweep; open it as a volume.</source>
        <translation>„%1“ ist ein Volumen, kein aufgezeichneter Schwenk; öffnen Sie es als Volumen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written (%2); choose another place or free some room.</source>
        <translation>„%1“ kann nicht geschrieben werden (%2); wählen Sie einen anderen Ort oder schaffen Sie Platz.</translation>
    </message>
    <message>
        <source>The sweep would become %1 x %2 x %3 voxels and need %4 MiB, more than the %5 MiB allowed; give a coarser spacing_mm.</source>
        <translation>Aus dem Schwenk würden %1 × %2 × %3 Voxel, und er bräuchte %4 MiB, mehr als die erlaubten %5 MiB; geben Sie einen gröberen Voxelabstand an.</translation>
    </message>
    <message>
        <source>The sweep has no frame with a usable pose; check the tracking of the recording.</source>
        <translation>Der Schwenk hat kein Bild mit brauchbarer Lage; prüfen Sie den Tracker der Aufnahme.</translation>
    </message>
    <message>
        <source>The volume has no voxels along axis %1; check the file&apos;s dimensions.</source>
        <translation>Das Volumen hat keine Voxel entlang der Achse %1; prüfen Sie die Größe in der Datei.</translation>
    </message>
    <message>
        <source>The voxel spacing along axis %1 is not a positive number; check the file&apos;s spacing.</source>
        <translation>Der Voxelabstand entlang der Achse %1 ist keine positive Zahl; prüfen Sie den Abstand in der Datei.</translation>
    </message>
    <message>
        <source>The volume&apos;s origin is not finite; check the file&apos;s offset.</source>
        <translation>Der Ursprung des Volumens ist nicht endlich; prüfen Sie den Versatz in der Datei.</translation>
    </message>
    <message>
        <source>The volume has more voxels than can be handled; use a coarser spacing.</source>
        <translation>Das Volumen hat mehr Voxel, als zu bewältigen sind; nehmen Sie einen gröberen Abstand.</translation>
    </message>
    <message>
        <source>The direction of axis %1 is not of unit length; check the file&apos;s orientation matrix.</source>
        <translation>Die Richtung der Achse %1 hat nicht die Länge eins; prüfen Sie die Ausrichtung in der Datei.</translation>
    </message>
    <message>
        <source>The directions of the volume&apos;s axes lie in one plane; check the file&apos;s orientation matrix.</source>
        <translation>Die Richtungen der Achsen liegen in einer Ebene; prüfen Sie die Ausrichtung in der Datei.</translation>
    </message>
    <message>
        <source>The pose is not a rotation with a translation: %1. Give 16 numbers, row by row, with orthonormal axes and a last row of 0 0 0 1.</source>
        <translation>Die Lage ist keine Drehung mit Verschiebung: %1. Geben Sie 16 Zahlen, Zeile für Zeile, mit orthonormalen Achsen und 0 0 0 1 als letzter Zeile.</translation>
    </message>
    <message>
        <source>There is not enough memory for this; close other programs or choose a coarser spacing.</source>
        <translation>Dafür reicht der Speicher nicht; schließen Sie andere Programme oder wählen Sie einen gröberen Abstand.</translation>
    </message>
    <message>
        <source>There is not enough memory for a volume of %1; use a coarser spacing.</source>
        <translation>Für ein Volumen von %1 reicht der Speicher nicht; nehmen Sie einen gröberen Abstand.</translation>
    </message>
    <message>
        <source>The work stopped unexpectedly (%1); nothing was changed, please report it with what you did.</source>
        <translation>Die Arbeit brach unerwartet ab (%1); nichts wurde geändert, bitte melden Sie es und was Sie getan haben.</translation>
    </message>
    <message>
        <source>There is not enough memory for &apos;%2&apos; of the plugin &apos;%1&apos;; close other programs or choose a coarser spacing.</source>
        <translation>Für „%2“ der Erweiterung „%1“ reicht der Speicher nicht; schließen Sie andere Programme oder wählen Sie einen gröberen Abstand.</translation>
    </message>
    <message>
        <source>&apos;%2&apos; of the plugin &apos;%1&apos; stopped unexpectedly (%3); please report it with what you did.</source>
        <translation>„%2“ der Erweiterung „%1“ brach unerwartet ab (%3); bitte melden Sie es und was Sie getan haben.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in the stitch project cannot be used. %2</source>
        <translation>„%1“ im Stitching-Projekt ist nicht zu gebrauchen. %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; and &apos;%2&apos; could not be bent together. %3</source>
        <translation>„%1“ und „%2“ konnten nicht miteinander verformt werden. %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; and &apos;%2&apos; could not be registered. %3</source>
        <translation>„%1“ und „%2“ konnten nicht zugeordnet werden. %3</translation>
    </message>
    <message>
        <source>Searching poses</source>
        <translation>Lagen werden gesucht</translation>
    </message>
    <message>
        <source>&apos;%1&apos; holds %2; a transform is 16 numbers, row by row.</source>
        <translation>„%1“ enthält %2; eine Transformation sind 16 Zahlen, Zeile für Zeile.</translation>
    </message>
    <message>
        <source>something that is not a number</source>
        <translation>etwas, das keine Zahl ist</translation>
    </message>
    <message>
        <source>%1 numbers</source>
        <translation>%1 Zahlen</translation>
    </message>
    <message>
        <source>Checking for residual motion</source>
        <translation>Restbewegung wird gesucht</translation>
    </message>
    <message>
        <source>'%1' is not a result that was written here before, and would be lost; move it away or choose another folder.</source>
        <translation>„%1“ ist kein Ergebnis, das hier früher geschrieben wurde, und ginge verloren; verschieben Sie die Datei oder wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>'%1' is read by this project and would be written over by its result; choose another folder.</source>
        <translation>„%1“ wird von diesem Projekt gelesen und würde von seinem Ergebnis überschrieben; wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>'%1' lies among the intermediate results of '%2', which come and go; copy it to a place of its own or choose another folder.</source>
        <translation>„%1“ liegt unter den Zwischenergebnissen von „%2“, die kommen und gehen; kopieren Sie die Datei an einen eigenen Ort oder wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>The reconstruction of '%1' was damaged.</source>
        <translation>Die Rekonstruktion von „%1“ war beschädigt.</translation>
    </message>
    <message>
        <source>There is no way from the pixels (frame Image) to %1: nothing can be reached from Image; %2.</source>
        <translation>Es führt kein Weg von den Pixeln (Rahmen Image) zu %1: Von Image aus ist nichts zu erreichen; %2.</translation>
    </message>
    <message>
        <source>There is no way from the pixels (frame Image) to %1: nothing can be reached from Image, and %2 stand apart; %3.</source>
        <translation>Es führt kein Weg von den Pixeln (Rahmen Image) zu %1: Von Image aus ist nichts zu erreichen, und %2 stehen für sich; %3.</translation>
    </message>
    <message>
        <source>There is no way from the pixels (frame Image) to %1: from Image only %2 can be reached; %3.</source>
        <translation>Es führt kein Weg von den Pixeln (Rahmen Image) zu %1: Von Image aus ist nur %2 zu erreichen; %3.</translation>
    </message>
    <message>
        <source>There is no way from the pixels (frame Image) to %1: from Image only %2 can be reached, and %3 stand apart; %4.</source>
        <translation>Es führt kein Weg von den Pixeln (Rahmen Image) zu %1: Von Image aus ist nur %2 zu erreichen, und %3 stehen für sich; %4.</translation>
    </message>
    <message>
        <source>give the device set (.xml) with the calibration from Image to %1</source>
        <translation>geben Sie die Gerätedatei (.xml) mit der Kalibrierung von Image zu %1 an</translation>
    </message>
    <message>
        <source>the device set given has no transform from or to Image, give the one this sweep was recorded with</source>
        <translation>die angegebene Gerätedatei hat keine Transformation von oder zu Image; geben Sie die an, mit der dieser Schwenk aufgenommen wurde</translation>
    </message>
    <message>
        <source>name one of those frames as the target, or give the device set (.xml) that leads on</source>
        <translation>geben Sie die Gerätedatei (.xml) an, die weiterführt</translation>
    </message>
    <message>
        <source>the recording holds no tracked poses, so it cannot be placed: choose one recorded with a tracker</source>
        <translation>die Aufnahme enthält keine verfolgten Lagen und kann nicht platziert werden: Wählen Sie eine, die mit einem Tracker aufgenommen wurde</translation>
    </message>
    <message>
        <source>"%1" was made by somebody else in the meantime and is left as it is; choose another name.</source>
        <translation>„%1“ wurde inzwischen von jemand anderem angelegt und bleibt, wie es ist; wählen Sie einen anderen Namen.</translation>
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
    <name>ew::stitching::Reasons</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>any distance</source>
        <translation>beliebig viel</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <comment>end of a list</comment>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>number %1</source>
        <translation>Nummer %1</translation>
    </message>
    <message>
        <source>&apos;%1&apos;</source>
        <translation>„%1“</translation>
    </message>
    <message>
        <source>The fixed volume holds no echo.</source>
        <translation>Das feste Volumen enthält kein Echo.</translation>
    </message>
    <message>
        <source>The moving volume holds no echo.</source>
        <translation>Das bewegte Volumen enthält kein Echo.</translation>
    </message>
    <message>
        <source>The fixed volume covers nothing as thick as three voxels of %1. Without coverage, black at the border is outside.</source>
        <translation>Das feste Volumen erfasst nichts, was drei Voxel zu %1 dick wäre. Ohne Abdeckung gilt Schwarz am Rand als außerhalb.</translation>
    </message>
    <message>
        <source>The moving volume covers nothing as thick as three voxels of %1. Without coverage, black at the border is outside.</source>
        <translation>Das bewegte Volumen erfasst nichts, was drei Voxel zu %1 dick wäre. Ohne Abdeckung gilt Schwarz am Rand als außerhalb.</translation>
    </message>
    <message>
        <source>The fixed volume is too thin: it takes three voxels of %1 in every direction.</source>
        <translation>Das feste Volumen ist zu dünn: In jeder Richtung braucht es drei Voxel zu %1.</translation>
    </message>
    <message>
        <source>The moving volume is too thin: it takes three voxels of %1 in every direction.</source>
        <translation>Das bewegte Volumen ist zu dünn: In jeder Richtung braucht es drei Voxel zu %1.</translation>
    </message>
    <message>
        <source>The fixed volume shows no structure: it is the same grey nearly everywhere.</source>
        <translation>Das feste Volumen zeigt keine Struktur: Es ist fast überall gleich grau.</translation>
    </message>
    <message>
        <source>The moving volume shows no structure: it is the same grey nearly everywhere.</source>
        <translation>Das bewegte Volumen zeigt keine Struktur: Es ist fast überall gleich grau.</translation>
    </message>
    <message>
        <source>The two do not overlap at the start: bring them closer, or search without places.</source>
        <translation>Am Anfang überlappen sich die beiden nicht: Bringen Sie sie näher zusammen oder suchen Sie ohne Lagen.</translation>
    </message>
    <message>
        <source>The overlap is too small: fewer than 50 voxels are covered by both volumes.</source>
        <translation>Die Überlappung ist zu klein: Beide Volumen erfassen gemeinsam weniger als 50 Voxel.</translation>
    </message>
    <message>
        <source>What overlaps does not hold the pose: it may slide or turn.</source>
        <translation>Was sich überlappt, hält die Lage nicht fest: Sie kann gleiten oder sich drehen.</translation>
    </message>
    <message>
        <source>The overlap is too small to tell.</source>
        <translation>Die Überlappung ist zu klein für ein Urteil.</translation>
    </message>
    <message>
        <source>Near this start the images agree no better than unrelated tissue does.</source>
        <translation>Nahe diesem Anfang stimmen die Bilder nicht besser überein als fremdes Gewebe.</translation>
    </message>
    <message>
        <source>The images agree hardly better than unrelated tissue does.</source>
        <translation>Die Bilder stimmen kaum besser überein als fremdes Gewebe.</translation>
    </message>
    <message>
        <source>Halves of the overlap, matched apart, contradict each other by %1: the start may be too far off.</source>
        <translation>Getrennt zugeordnete Hälften der Überlappung widersprechen sich um %1: Vielleicht liegt der Anfang zu weit daneben.</translation>
    </message>
    <message>
        <source>Halves of the overlap, matched apart, agree to %1.</source>
        <translation>Getrennt zugeordnete Hälften der Überlappung stimmen auf %1 überein.</translation>
    </message>
    <message>
        <source>Descending from the start led nowhere; a search about it found a pose %1 and %2 from it.</source>
        <translation>Der Abstieg vom Start führte nirgendwohin; eine Suche um ihn herum fand eine Lage %1 und %2 davon entfernt.</translation>
    </message>
    <message>
        <source>No pose brings the two into agreement over %1 overlap.</source>
        <translation>Keine Lage bringt die beiden über %1 Überlappung zur Übereinstimmung.</translation>
    </message>
    <message>
        <source>The overlap found is too small to tell it from chance.</source>
        <translation>Die gefundene Überlappung ist zu klein, um Zufall auszuschließen.</translation>
    </message>
    <message>
        <source>The best of %1 turns with all shifts agrees no better than unrelated tissue does.</source>
        <translation>Auch die beste von %1 Drehungen mit allen Verschiebungen stimmt nicht besser überein als fremdes Gewebe.</translation>
    </message>
    <message>
        <source>The best pose agrees hardly better than unrelated tissue does.</source>
        <translation>Die beste Lage stimmt kaum besser überein als fremdes Gewebe.</translation>
    </message>
    <message>
        <source>Two different poses agree almost equally (margin %1): the structure repeats. A start or landmarks must choose.</source>
        <translation>Zwei verschiedene Lagen stimmen fast gleich gut überein (Abstand %1): Die Struktur wiederholt sich. Ein Anfang oder Landmarken müssen entscheiden.</translation>
    </message>
    <message>
        <source>Halves of the overlap, matched apart, contradict each other by %1.</source>
        <translation>Getrennt zugeordnete Hälften der Überlappung widersprechen sich um %1.</translation>
    </message>
    <message>
        <source>One pose stands out by a margin of %1; halves of the overlap, matched apart, agree to %2.</source>
        <translation>Eine Lage ragt mit dem Abstand %1 heraus; getrennt zugeordnete Hälften der Überlappung stimmen auf %2 überein.</translation>
    </message>
    <message>
        <source>Shadows and other streaks were taken out, which drew the volumes %1 and %2 elsewhere.</source>
        <translation>Schatten und andere Streifen wurden herausgenommen; sie hatten die Volumen um %1 und %2 anderswohin gezogen.</translation>
    </message>
    <message>
        <source>What agrees are mostly streaks, such as shadows along the beam, which turn with the probe: without them the volumes agree hardly better than unrelated tissue does.</source>
        <translation>Was übereinstimmt, sind vor allem Streifen wie Schatten längs des Strahls, die sich mit der Sonde drehen: Ohne sie stimmen die Volumen kaum besser überein als fremdes Gewebe.</translation>
    </message>
    <message>
        <source>What agrees are mostly streaks, such as shadows along the beam, which turn with the probe: without them the pose lies %1 and %2 elsewhere. A tracker or landmarks can decide.</source>
        <translation>Was übereinstimmt, sind vor allem Streifen wie Schatten längs des Strahls, die sich mit der Sonde drehen: Ohne sie liegt die Lage %1 und %2 anderswo. Ein Tracker oder Landmarken können entscheiden.</translation>
    </message>
    <message numerus="yes">
        <source>Three places that are not on one line are needed; mark %n more.</source>
        <translation>
            <numerusform>Drei Stellen, die nicht auf einer Geraden liegen, sind nötig; setzen Sie noch eine.</numerusform>
            <numerusform>Drei Stellen, die nicht auf einer Geraden liegen, sind nötig; setzen Sie noch %n.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: the place of an earlier pair again.</source>
        <translation>%1: noch einmal die Stelle eines früheren Paares.</translation>
    </message>
    <message>
        <source>The places lie on one line, so that the turn about it is free: add one beside the line.</source>
        <translation>Die Stellen liegen auf einer Geraden, sodass die Drehung um sie frei bleibt: Setzen Sie eine neben der Geraden.</translation>
    </message>
    <message>
        <source>The places in one volume are the mirror image of those in the other: left and right were confused, or one file is mirrored.</source>
        <translation>Die Stellen im einen Volumen sind das Spiegelbild derer im anderen: Links und rechts wurden verwechselt, oder eine Datei ist gespiegelt.</translation>
    </message>
    <message>
        <source>The three pairs contradict each other by %1, and three cannot say which is wrong: correct one or add a fourth.</source>
        <translation>Die drei Paare widersprechen sich um %1, und drei können nicht sagen, welches falsch ist: Berichtigen Sie eines oder setzen Sie ein viertes.</translation>
    </message>
    <message>
        <source>The pairs contradict each other: no rigid transform brings more than %1 of %2 together. Pick them again.</source>
        <translation>Die Paare widersprechen sich: Keine starre Lage bringt mehr als %1 von %2 zusammen. Setzen Sie sie neu.</translation>
    </message>
    <message>
        <source>One can read the pairs in two ways: without %1, or without %2. Add a pair or correct one.</source>
        <translation>Die Paare lassen sich auf zwei Arten lesen: ohne %1 oder ohne %2. Setzen Sie ein weiteres Paar oder berichtigen Sie eines.</translation>
    </message>
    <message>
        <source>%1 pairs agree within %2.</source>
        <translation>%1 Paare stimmen auf %2 überein.</translation>
    </message>
    <message>
        <source>%1 pairs agree within %2; off by %3: %4.</source>
        <translation>%1 Paare stimmen auf %2 überein; um %3 daneben: %4.</translation>
    </message>
    <message>
        <source>Placed by hand.</source>
        <translation>Von Hand gelegt.</translation>
    </message>
    <message>
        <source>One of the volumes has no part that may be believed.</source>
        <translation>Eines der Volumen hat keinen Teil, dem zu trauen ist.</translation>
    </message>
    <message>
        <source>The volumes do not overlap where they were placed.</source>
        <translation>Wo die Volumen liegen, überlappen sie sich nicht.</translation>
    </message>
    <message>
        <source>The overlap shows no structure that could be followed.</source>
        <translation>Die Überlappung zeigt keine Struktur, der sich folgen ließe.</translation>
    </message>
    <message>
        <source>No bending brought the volumes closer than they were; none was made.</source>
        <translation>Keine Verformung brachte die Volumen näher zusammen, als sie waren; es bleibt dabei.</translation>
    </message>
    <message>
        <source>No bending brought the volumes together; none was made.</source>
        <translation>Keine Verformung brachte die Volumen zusammen; es bleibt dabei.</translation>
    </message>
    <message>
        <source>The volumes contradict each other: bent, they agree no better than unrelated tissue does.</source>
        <translation>Die Volumen widersprechen sich: Auch verformt stimmen sie nicht besser überein als fremdes Gewebe.</translation>
    </message>
    <message>
        <source>Too little structure is shared to tell whether the bend is right.</source>
        <translation>Die Volumen haben zu wenig Struktur gemeinsam, um die Verformung zu beurteilen.</translation>
    </message>
    <message>
        <source>Bent, the volumes agree.</source>
        <translation>Verformt stimmen die Volumen überein.</translation>
    </message>
    <message>
        <source>The bend misses motion: at %1 of the places that can tell, tissue lies %2 from where the bend puts it.</source>
        <translation>Der Verformung entgeht Bewegung: An %1 der Stellen, die es zeigen können, liegt Gewebe %2 neben dem Ort, den sie angibt.</translation>
    </message>
    <message>
        <source>%1 with %2</source>
        <translation>%1 mit %2</translation>
    </message>
    <message>
        <source>the tracker&apos;s pose of %1</source>
        <translation>die Lage von %1 nach dem Tracker</translation>
    </message>
    <message>
        <source>Nothing joins these %1 parts: %2. Match a pair between them.</source>
        <translation>Diese %1 Teile verbindet nichts: %2. Ordnen Sie ein Paar zwischen ihnen zu.</translation>
    </message>
    <message>
        <source>The pairs leave %1 free to slide or turn.</source>
        <translation>Die Paare lassen %1 gleiten oder sich drehen.</translation>
    </message>
    <message>
        <source>%1 (by %2 and %3)</source>
        <translation>%1 (um %2 und %3)</translation>
    </message>
    <message>
        <source>Wrong, and left out: %1.</source>
        <translation>Falsch und weggelassen: %1.</translation>
    </message>
    <message>
        <source>It could as well be %1: they lie on the same loop. Match another pair across it.</source>
        <translation>Ebenso gut könnte es %1 sein: Sie liegen auf derselben Schleife. Ordnen Sie ein weiteres Paar quer dazu zu.</translation>
    </message>
    <message>
        <source>No loop checks %1.</source>
        <translation>Keine Schleife prüft %1.</translation>
    </message>
    <message>
        <source>The optimisation of the poses did not converge.</source>
        <translation>Die Optimierung der Lagen konvergierte nicht.</translation>
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
        <translation>Fügen Sie ein zweites Volumen hinzu; dann lassen sich Paare zuordnen.</translation>
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
        <translation>Fügen Sie zwei oder mehr Volumen oder Schwenks hinzu, die sich überlappen, oder ziehen Sie ihre Dateien oder ein Stitching-Projekt hierher. Ein Tracker ist nicht nötig.</translation>
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
        <translation>Das Projekt hat noch kein Volumen; fügen Sie eines hinzu, bevor Sie es speichern.</translation>
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
        <translation>Eine Landmarke braucht einen Namen; geben Sie einen ein.</translation>
    </message>
    <message>
        <source>call landmark %1 &apos;%2&apos;</source>
        <translation>Landmarke %1 „%2“ nennen</translation>
    </message>
    <message numerus="yes">
        <source>Three places that do not lie on one line are needed; mark %n more in both volumes.</source>
        <translation>
            <numerusform>Drei Stellen, die nicht auf einer Geraden liegen, sind nötig; setzen Sie noch eine in beiden Volumen.</numerusform>
            <numerusform>Drei Stellen, die nicht auf einer Geraden liegen, sind nötig; setzen Sie noch %n in beiden Volumen.</numerusform>
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
        <translation>Zum Zuordnen braucht es mindestens zwei Volumen; fügen Sie noch eines hinzu.</translation>
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
        <translation>Noch gibt es nichts zu tun; fügen Sie zwei oder mehr Volumen hinzu.</translation>
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
        <translation>Noch gibt es kein zusammengefügtes Volumen; führen Sie erst „Mosaik berechnen“ aus.</translation>
    </message>
    <message>
        <source>Saving the stitched volume</source>
        <translation>Das zusammengefügte Volumen wird gespeichert</translation>
    </message>
    <message>
        <source>Saved in %1: volume.mha, coverage.mha, source.mha and provenance.json.</source>
        <translation>Gespeichert in %1: volume.mha, coverage.mha, source.mha und provenance.json.</translation>
    </message>
    <message>
        <source>No case is open that could take the volume; open one (Ctrl+O) or save the volume as a file.</source>
        <translation>Kein Fall ist offen, der das Volumen nehmen könnte; öffnen Sie einen (Strg+O) oder speichern Sie das Volumen als Datei.</translation>
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
        <translation>Er hatte schon ungespeicherte Änderungen; speichern Sie den Fall, um alle zu behalten.</translation>
    </message>
    <message>
        <source>A step is still running; wait for it or cancel it.</source>
        <translation>Ein Schritt läuft noch; warten Sie auf ihn oder brechen Sie ihn ab.</translation>
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
        <translation>Nicht nach ihren Bildern zugeordnet, weil Sie sie nach Landmarken platziert oder von Hand angenommen haben: %1.</translation>
    </message>
    <message>
        <source>'%1' was changed by another program since it was opened here.</source>
        <translation>„%1“ wurde von einem anderen Programm geändert, seit es hier geöffnet wurde.</translation>
    </message>
    <message>
        <source>Reloading drops your changes, overwriting drops the other ones.</source>
        <translation>Neu laden verwirft Ihre Änderungen, Überschreiben die anderen.</translation>
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
            <numerusform>Eine Datei liegt in einem anderen Ordner und ist mit ihrem ganzen Pfad genannt: Legen Sie sie neben das Projekt, bevor Sie es auf einen anderen Rechner mitnehmen.</numerusform>
            <numerusform>%n Dateien liegen in anderen Ordnern und sind mit ihrem ganzen Pfad genannt: Legen Sie sie neben das Projekt, bevor Sie es auf einen anderen Rechner mitnehmen.</numerusform>
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
        <translation>Was nur das Rezept wusste, geht mit ihm: %1, %2. Um diesen Fall zu behalten, wie er ist, speichern Sie ihn zuerst unter einem anderen Namen.</translation>
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
        <translation>Die Ansicht, die dort vorgezogen wird, wo Sie malen</translation>
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
        <translation>Eine Gerätedatei (.xml), die sagt, wo die Pixel am Schallkopf liegen; nötig für einen Schwenk, der es nicht selbst sagt</translation>
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
        <translation>Gerätedateien (*.xml);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>sweep, not yet a volume</source>
        <translation>Schwenk, noch kein Volumen</translation>
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
        <translation>Wählen Sie den Ordner Ihrer eigenen Fälle.</translation>
    </message>
    <message>
        <source>Type a name for the new folder, without &apos;/&apos; and not beginning with &apos;.&apos;.</source>
        <translation>Geben Sie dem neuen Ordner einen Namen ohne „/“, der nicht mit „.“ beginnt.</translation>
    </message>
    <message>
        <source>This folder belongs to the program, and the next version replaces it; choose one of your own.</source>
        <translation>Dieser Ordner gehört zum Programm, und die nächste Version ersetzt ihn; wählen Sie einen eigenen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is there already, and nothing in it is replaced; type another name.</source>
        <translation>„%1“ gibt es schon, und darin wird nichts ersetzt; geben Sie einen anderen Namen ein.</translation>
    </message>
    <message>
        <source>The case will be saved in %1.</source>
        <translation>Der Fall wird in %1 gespeichert.</translation>
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
        <source>Depth of the image (Page Up, Page Down)</source>
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
        <source>Keep the image (Space or F)</source>
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
        <source>What the image shows and how (F10)</source>
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
        <source>Every depth is blurred by the width its beam has there (Shift+N)</source>
        <translation>Jede Tiefe wird so unscharf, wie ihr Strahl dort breit ist (Umschalt+N)</translation>
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
        <source>Quality may fall while the probe moves fast, and refines at rest (F9)</source>
        <translation>Die Qualität darf sinken, solange sich die Sonde schnell bewegt, und steigt in Ruhe wieder (F9)</translation>
    </message>
    <message>
        <source>The thickness is averaged over %1 planes (Shift+F3 for the next)</source>
        <translation>Die Dicke wird über %1 Ebenen gemittelt (Umschalt+F3 für die nächste Zahl)</translation>
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
        <source>The probe is at the bottom; put it at the top, as usual (U)</source>
        <translation>Die Sonde ist unten; nach oben setzen, wie üblich (U)</translation>
    </message>
    <message>
        <source>The probe is at the top, as usual; put it at the bottom (U)</source>
        <translation>Die Sonde ist oben, wie üblich; nach unten setzen (U)</translation>
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
        <source>Makes borders sharper (B, Shift+B)</source>
        <translation>Macht Grenzen schärfer (B, Umschalt+B)</translation>
    </message>
    <message>
        <source>How much of the last image stays (P, Shift+P)</source>
        <translation>Wie viel vom letzten Bild bleibt (P, Umschalt+P)</translation>
    </message>
    <message>
        <source>Magnify; drag in the image to move the detail (Z, Shift+Z)</source>
        <translation>Vergrößern; im Bild ziehen verschiebt den Ausschnitt (Z, Umschalt+Z)</translation>
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
        <source>Measure what accuracy costs on this computer (Ctrl+K)</source>
        <translation>Messen, was Genauigkeit auf diesem Rechner kostet (Strg+K)</translation>
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
        <translation>nach Vertrauen gewichtet: Schatten zählen weniger</translation>
    </message>
    <message>
        <source>maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>latest view</source>
        <translation>letzte Ansicht</translation>
    </message>
    <message>
        <source>do not fill</source>
        <translation>nicht füllen</translation>
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
        <translation>Gerätebeschreibung der Aufnahme (.xml); mehrere durch ; getrennt, bei gleichen Angaben zählt die frühere</translation>
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
        <translation>Von der Auflage zurück zur Achse, um die gekippt wurde; 0: um die Auflage selbst</translation>
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
        <translation>wie die Gerätebeschreibung sagt, sonst ganz</translation>
    </message>
    <message>
        <source>Of each frame this rectangle alone is used: x,y,width,height in pixels. Drag it over the image.</source>
        <translation>Von jedem Bild wird nur dieses Rechteck verwendet: x,y,Breite,Höhe in Pixeln. Es lässt sich im Bild aufziehen.</translation>
    </message>
    <message>
        <source>as the device set says, else none</source>
        <translation>wie die Gerätebeschreibung sagt, sonst keiner</translation>
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
        <translation>Das erste Bild. Ziehen Sie ein Rechteck über das, was von jedem Bild verwendet werden soll.</translation>
    </message>
    <message>
        <source>Choose the motor file that says how the probe moved.</source>
        <translation>Bitte die Motordatei wählen, die sagt, wie sich der Schallkopf bewegte.</translation>
    </message>
    <message>
        <source>Say how far the probe moved from frame to frame; 0 would put all frames into one place.</source>
        <translation>Bitte angeben, wie weit sich der Schallkopf von Bild zu Bild bewegte; 0 legte alle Bilder an dieselbe Stelle.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not %2.</source>
        <translation>„%1“ ist nicht %2.</translation>
    </message>
    <message>
        <source>a fan; give left and right angle, x and y of the apex, first and last radius</source>
        <translation>ein Fächer; nötig sind linker und rechter Winkel, x und y der Spitze, erster und letzter Radius</translation>
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
        <source>There is not enough memory for this; close other programs and try again.</source>
        <translation>Dafür reicht der Speicher nicht; schließen Sie andere Programme und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The program met a problem that it did not foresee (%1). Your work is still there: save it, and please report this with what you did.</source>
        <translation>Das Programm stieß auf ein unvorhergesehenes Problem (%1). Ihre Arbeit ist noch da: speichern Sie sie, und bitte melden Sie dies und was Sie getan haben.</translation>
    </message>
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
        <translation>Das Fenster war nach %1 s nicht bereit; bitte ein kleineres Volumen versuchen.</translation>
    </message>
    <message>
        <source>The image cannot be written to &apos;%1&apos;; choose a folder you may write to.</source>
        <translation>Das Bild lässt sich nicht nach „%1“ schreiben; bitte einen Ordner wählen, in den Sie schreiben dürfen.</translation>
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
        <source>All that EchoWeave reads (case.json *.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz *.dcm *.vol *.v00 *.raw *.png *.jpg *.pgm);;Cases (case.json);;Sweeps (*.igs.mha *.igs.mhd *.igs.nrrd *.seq.mha *.seq.nrrd *.mha *.mhd *.nrrd);;Volumes (*.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz);;DICOM, Kretz, raw samples, images (*)</source>
        <translation>Alles, was EchoWeave liest (case.json *.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz *.dcm *.vol *.v00 *.raw *.png *.jpg *.pgm);;Fälle (case.json);;Schwenks (*.igs.mha *.igs.mhd *.igs.nrrd *.seq.mha *.seq.nrrd *.mha *.mhd *.nrrd);;Volumen (*.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz);;DICOM, Kretz, Rohdaten, Bilder (*)</translation>
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
        <source>The strip of the M-mode shows one beam over time, no place in an image. Switch to B or B + M (M), then click a point of the image.</source>
        <translation>Der Streifen des M-Modus zeigt einen Strahl über die Zeit, keinen Ort in einem Bild. Auf B oder B + M umschalten (M), dann einen Punkt des Bildes anklicken.</translation>
    </message>
    <message>
        <source>This volume does not say which frame a voxel came from. A volume that is made here from a recorded sweep does: open the sweep (Ctrl+O), leave &apos;Keep which frame each voxel came from&apos; switched on, and make the volume.</source>
        <translation>Dieses Volumen sagt nicht, aus welchem Bild ein Voxel stammt. Ein Volumen, das hier aus einem aufgenommenen Schwenk gemacht wird, sagt es: den Schwenk öffnen (Strg+O), „Behalten, aus welchem Bild jeder Voxel stammt“ eingeschaltet lassen und das Volumen machen.</translation>
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
        <translation>Speichern Sie eine eigene Kopie: Die nächste Version des Programms ersetzt, was an seinen Fällen geändert wird.</translation>
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
        <source>The image is frozen, and the probe with it. Space or F lets both move again.</source>
        <translation>Das Bild ist eingefroren und mit ihm die Sonde. Leertaste oder F lässt beide wieder los.</translation>
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
        <translation>Die gewählte Sprache gilt ab dem nächsten Start. Schließen Sie EchoWeave und öffnen Sie es wieder.</translation>
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
        <translation>Dieser Punkt liegt außerhalb des Bildes. Klicken Sie auf einen Punkt im Schallfächer.</translation>
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
        <translation>Der Schallkopf wird für Sie bewegt. Esc nimmt ihn zurück.</translation>
    </message>
    <message>
        <source>A recording is shown. Close it (Escape) to move the probe yourself.</source>
        <translation>Eine Aufzeichnung wird gezeigt. Schließen Sie sie (Esc), um den Schallkopf selbst zu bewegen.</translation>
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
        <translation>Die Aufzeichnung bleibt, bis eine andere beginnt. Spielen Sie sie unten ab oder speichern Sie sie (%1).</translation>
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
        <translation>%1 ist eine Aufzeichnung von „%2“. Öffnen Sie zuerst, was geschallt wurde, dann die Aufzeichnung.</translation>
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
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>The probe is outside the volume.</source>
        <translation>Die Sonde ist außerhalb des Volumens.</translation>
    </message>
    <message>
        <source>The probe is outside the volume. Slide it back, or press Home for the start.</source>
        <translation>Die Sonde ist außerhalb des Volumens. Schieben Sie sie zurück, oder drücken Sie Pos1 für den Anfang.</translation>
    </message>
    <message>
        <source>depth %1 cm   gain %2 %</source>
        <translation>Tiefe %1 cm   Verstärkung %2 %</translation>
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
        <source>Pause (Space)</source>
        <translation>Anhalten (Leertaste)</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>Abspielen (Leertaste)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
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
        <translation>Klicken oder ziehen Sie zu einem anderen Augenblick (Pfeile: eine Sekunde, mit Umschalt fünf; Pos1 und Ende)</translation>
    </message>
</context>
</TS>
