<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>AtlasTexts</name>
    <message>
        <source>Umbilical notch</source>
        <translation>Nabelkerbe</translation>
    </message>
    <message>
        <source>Falciform ligament</source>
        <translation>Sichelband</translation>
    </message>
    <message>
        <source>Anterior margin</source>
        <translation>Vorderrand</translation>
    </message>
    <message>
        <source>Vena cava</source>
        <translation>Vena cava</translation>
    </message>
    <message>
        <source>Portal vein&apos;s entrance</source>
        <translation>Eintritt der Pfortader</translation>
    </message>
    <message>
        <source>Gallbladder&apos;s bed</source>
        <translation>Gallenblasenbett</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>vorgeschlagen</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>moved</source>
        <translation>verschoben</translation>
    </message>
    <message>
        <source>not visible</source>
        <translation>nicht sichtbar</translation>
    </message>
    <message>
        <source>from %1 livers (%2), %3 mm</source>
        <translation>aus %1 Lebern (%2), %3 mm</translation>
    </message>
    <message>
        <source>found in the CT</source>
        <translation>im CT gefunden</translation>
    </message>
    <message>
        <source>placed by hand</source>
        <translation>von Hand gesetzt</translation>
    </message>
    <message>
        <source>follows the notch as the portal vein shows it</source>
        <translation>folgt der Nabelkerbe, wie die Pfortader sie zeigt</translation>
    </message>
    <message>
        <source>follows what the CT shows (%1)</source>
        <translation>folgt dem, was das CT zeigt (%1)</translation>
    </message>
    <message>
        <source>follows the notch that you placed</source>
        <translation>folgt der Nabelkerbe, die Sie gesetzt haben</translation>
    </message>
    <message>
        <source>follows what you placed (%1)</source>
        <translation>folgt dem, was Sie gesetzt haben (%1)</translation>
    </message>
    <message>
        <source>%1 on %2 % of its course</source>
        <translation>%1, auf %2 % des Verlaufs</translation>
    </message>
    <message>
        <source>%1; drawn to where the portal vein&apos;s umbilical part shows it</source>
        <translation>%1; dorthin gezogen, wo die Pars umbilicalis der Pfortader sie zeigt</translation>
    </message>
    <message>
        <source>%1; drawn to the plane of the portal vein&apos;s umbilical part on %2 % of its course</source>
        <translation>%1; auf %2 % des Verlaufs zur Ebene der Pars umbilicalis der Pfortader gezogen</translation>
    </message>
    <message>
        <source>%1; drawn to the ridge found in the CT on %2 % of its course</source>
        <translation>%1; auf %2 % des Verlaufs zur im CT gefundenen Kante gezogen</translation>
    </message>
    <message>
        <source>%1; placed by hand on %2 % of its course</source>
        <translation>%1; auf %2 % des Verlaufs von Hand gesetzt</translation>
    </message>
</context>
<context>
    <name>BeingMade</name>
    <message>
        <source>A new model is being made: look at it first.</source>
        <translation>Ein neues Modell entsteht: Sehen Sie es zuerst an.</translation>
    </message>
</context>
<context>
    <name>CloudFigures</name>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Distance from the camera</source>
        <translation>Abstand von der Kamera</translation>
    </message>
    <message>
        <source>%1 to %2 mm</source>
        <translation>%1 bis %2 mm</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>dense</source>
        <translation>dicht</translation>
    </message>
    <message>
        <source>features</source>
        <translation>Merkmale</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>%1 cm²</source>
        <translation>%1 cm²</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>%1 per cm² (needs %2)</source>
        <translation>%1 je cm² (nötig: %2)</translation>
    </message>
    <message>
        <source>Dense enough</source>
        <translation>Dicht genug</translation>
    </message>
    <message>
        <source>%1 % of the surface</source>
        <translation>%1 % der Oberfläche</translation>
    </message>
    <message>
        <source>Depth&apos;s deviation</source>
        <translation>Streuung der Tiefe</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Rows off by</source>
        <translation>Zeilen versetzt um</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>Epipolar error</source>
        <translation>Epipolarfehler</translation>
    </message>
    <message>
        <source>Of the organ seen</source>
        <translation>Vom Organ gesehen</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>The regions were drawn on another frame: move them to where they belong now, or clear them.</source>
        <translation>Die Bereiche wurden auf einem anderen Bild gezeichnet: verschieben Sie sie dorthin, wo sie jetzt hingehören, oder löschen Sie sie.</translation>
    </message>
    <message>
        <source>Fewer points per cm² than registration needs: choose another method, or look closer.</source>
        <translation>Weniger Punkte je cm², als die Registrierung braucht: wählen Sie ein anderes Verfahren oder gehen Sie näher heran.</translation>
    </message>
    <message>
        <source>The pictures&apos; rows do not agree with the calibration: calibrate the laparoscope again.</source>
        <translation>Die Zeilen der Bilder passen nicht zur Kalibrierung: kalibrieren Sie das Laparoskop neu.</translation>
    </message>
</context>
<context>
    <name>EditTexts</name>
    <message>
        <source>A click here cuts %1 ml off: %2.</source>
        <translation>Ein Klick hier schneidet %1 ml ab: %2.</translation>
    </message>
    <message>
        <source>A click here moves %1 ml: %2 → %3.</source>
        <translation>Ein Klick hier verschiebt %1 ml: %2 → %3.</translation>
    </message>
    <message>
        <source>A click here makes a vessel of %1 ml.</source>
        <translation>Ein Klick hier macht ein Gefäß von %1 ml.</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Malen</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
    <message>
        <source>Scissors</source>
        <translation>Schere</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwellenwert</translation>
    </message>
    <message>
        <source>Grow from seeds</source>
        <translation>Aus Saatpunkten wachsen</translation>
    </message>
    <message>
        <source>Level tracing</source>
        <translation>Isolinie</translation>
    </message>
    <message>
        <source>Islands</source>
        <translation>Inseln</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>Löcher füllen</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>Interpolate between slices</source>
        <translation>Zwischen Schichten füllen</translation>
    </message>
    <message>
        <source>Logical</source>
        <translation>Verknüpfen</translation>
    </message>
    <message>
        <source>Move branch</source>
        <translation>Ast umhängen</translation>
    </message>
    <message>
        <source>No tool</source>
        <translation>Kein Werkzeug</translation>
    </message>
    <message>
        <source>Choose a label and a tool.</source>
        <translation>Ein Label und ein Werkzeug wählen.</translation>
    </message>
    <message>
        <source>Drag in a slice. Ctrl erases. Shift + wheel: size.</source>
        <translation>In einer Schicht ziehen. Strg radiert. Umschalt + Rad: Größe.</translation>
    </message>
    <message>
        <source>Drag in a slice. Ctrl paints. Shift + wheel: size.</source>
        <translation>In einer Schicht ziehen. Strg malt. Umschalt + Rad: Größe.</translation>
    </message>
    <message>
        <source>Draw around it, in a slice or in 3D. Ctrl fills instead of erasing, and the other way.</source>
        <translation>Umfahren, in einer Schicht oder in 3D. Strg füllt, statt zu radieren, und umgekehrt.</translation>
    </message>
    <message>
        <source>Everything between two intensities becomes the label.</source>
        <translation>Alles zwischen zwei Intensitäten bekommt das Label.</translation>
    </message>
    <message>
        <source>What is labelled grows into what is not, along like intensities. Paint a few strokes of each label first.</source>
        <translation>Was ein Label hat, wächst in das, was keines hat, entlang ähnlicher Intensitäten. Zuerst von jedem Label ein paar Striche malen.</translation>
    </message>
    <message>
        <source>Click where the region of like intensity ends. Ctrl erases.</source>
        <translation>Dort klicken, wo das Gebiet ähnlicher Intensität endet. Strg radiert.</translation>
    </message>
    <message>
        <source>Click an island of the label. Ctrl does the opposite.</source>
        <translation>Eine Insel des Labels anklicken. Strg tut das Gegenteil.</translation>
    </message>
    <message>
        <source>Separate pieces of the label.</source>
        <translation>Getrennte Stücke des Labels.</translation>
    </message>
    <message>
        <source>Closes what the label encloses.</source>
        <translation>Schließt, was das Label umschließt.</translation>
    </message>
    <message>
        <source>All labels at once, without gaps between them.</source>
        <translation>Alle Labels zugleich, ohne Lücken dazwischen.</translation>
    </message>
    <message>
        <source>All labels at once, without gaps between them; each keeps its volume.</source>
        <translation>Alle Labels zugleich, ohne Lücken dazwischen; jedes behält sein Volumen.</translation>
    </message>
    <message>
        <source>Evens the label&apos;s surface.</source>
        <translation>Ebnet die Oberfläche des Labels.</translation>
    </message>
    <message>
        <source>Grows or shrinks the label by a distance.</source>
        <translation>Lässt das Label um einen Abstand wachsen oder schrumpfen.</translation>
    </message>
    <message>
        <source>Paint the label in some slices; those between are filled.</source>
        <translation>Das Label in einigen Schichten malen; die dazwischen werden gefüllt.</translation>
    </message>
    <message>
        <source>Combines two labels.</source>
        <translation>Verknüpft zwei Labels.</translation>
    </message>
    <message>
        <source>Click a vessel: what hangs on it beyond its thinnest place goes to the other tree. Ctrl does the other of the two.</source>
        <translation>Ein Gefäß anklicken: was jenseits seiner dünnsten Stelle daran hängt, kommt zum anderen Baum. Strg tut das andere von beiden.</translation>
    </message>
    <message>
        <source>New labels are on their way: wait for them, or cancel that.</source>
        <translation>Neue Labels sind unterwegs: warten Sie darauf, oder brechen Sie das ab.</translation>
    </message>
    <message>
        <source>A new segmentation waits for your decision.</source>
        <translation>Eine neue Segmentierung wartet auf Ihre Entscheidung.</translation>
    </message>
    <message>
        <source>The label is locked.</source>
        <translation>Das Label ist gesperrt.</translation>
    </message>
    <message>
        <source>The label is empty.</source>
        <translation>Das Label ist leer.</translation>
    </message>
    <message>
        <source>The other label is empty.</source>
        <translation>Das andere Label ist leer.</translation>
    </message>
    <message>
        <source>Choose another second label.</source>
        <translation>Ein anderes zweites Label wählen.</translation>
    </message>
    <message>
        <source>Two labels or more must grow.</source>
        <translation>Mindestens zwei Labels müssen wachsen.</translation>
    </message>
    <message>
        <source>Not started</source>
        <translation>Nicht begonnen</translation>
    </message>
    <message>
        <source>In progress</source>
        <translation>In Arbeit</translation>
    </message>
    <message>
        <source>To review</source>
        <translation>Zu prüfen</translation>
    </message>
    <message>
        <source>Approved</source>
        <translation>Freigegeben</translation>
    </message>
    <message>
        <source>Scissors: fill inside</source>
        <translation>Schere: innen füllen</translation>
    </message>
    <message>
        <source>Scissors: erase inside</source>
        <translation>Schere: innen radieren</translation>
    </message>
    <message>
        <source>Scissors: erase outside</source>
        <translation>Schere: außen radieren</translation>
    </message>
    <message>
        <source>Level tracing: erase</source>
        <translation>Isolinie: radieren</translation>
    </message>
    <message>
        <source>Islands: keep largest</source>
        <translation>Inseln: größte behalten</translation>
    </message>
    <message>
        <source>Islands: remove small</source>
        <translation>Inseln: kleine entfernen</translation>
    </message>
    <message>
        <source>Islands: keep clicked</source>
        <translation>Inseln: angeklickte behalten</translation>
    </message>
    <message>
        <source>Islands: remove clicked</source>
        <translation>Inseln: angeklickte entfernen</translation>
    </message>
    <message>
        <source>Islands: split</source>
        <translation>Inseln: trennen</translation>
    </message>
    <message>
        <source>Smooth: median</source>
        <translation>Glätten: Median</translation>
    </message>
    <message>
        <source>Smooth: closing</source>
        <translation>Glätten: Schließen</translation>
    </message>
    <message>
        <source>Smooth: opening</source>
        <translation>Glätten: Öffnen</translation>
    </message>
    <message>
        <source>Smooth: joint</source>
        <translation>Glätten: gemeinsam</translation>
    </message>
    <message>
        <source>Margin: grow</source>
        <translation>Rand: wachsen</translation>
    </message>
    <message>
        <source>Margin: shrink</source>
        <translation>Rand: schrumpfen</translation>
    </message>
    <message>
        <source>Logical: copy</source>
        <translation>Verknüpfen: kopieren</translation>
    </message>
    <message>
        <source>Logical: add</source>
        <translation>Verknüpfen: hinzufügen</translation>
    </message>
    <message>
        <source>Logical: subtract</source>
        <translation>Verknüpfen: abziehen</translation>
    </message>
    <message>
        <source>Logical: intersect</source>
        <translation>Verknüpfen: Schnitt</translation>
    </message>
    <message>
        <source>Logical: invert</source>
        <translation>Verknüpfen: umkehren</translation>
    </message>
    <message>
        <source>Logical: clear</source>
        <translation>Verknüpfen: leeren</translation>
    </message>
    <message>
        <source>Logical: fill</source>
        <translation>Verknüpfen: alles füllen</translation>
    </message>
    <message>
        <source>Cut branch off</source>
        <translation>Ast abschneiden</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Segmentieren</translation>
    </message>
    <message>
        <source>Import labels</source>
        <translation>Labels importieren</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Vessel path</source>
        <translation>Gefäßweg</translation>
    </message>
    <message>
        <source>Click the two ends of a missing piece of vessel. Ctrl adds a point between.</source>
        <translation>Klicken Sie die beiden Enden des fehlenden Gefäßstücks an. Strg fügt einen Punkt dazwischen hinzu.</translation>
    </message>
    <message>
        <source>First choose a vessel in the list of labels: portal vein, hepatic veins, vena cava or artery.</source>
        <translation>Erst ein Gefäß in der Liste der Labels wählen: Pfortader, Lebervenen, Hohlvene oder Arterie.</translation>
    </message>
    <message>
        <source>Segment, corrections kept</source>
        <translation>Segmentieren, Korrekturen behalten</translation>
    </message>
    <message>
        <source>Correct around a click</source>
        <translation>Um einen Klick korrigieren</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>Wachsen</translation>
    </message>
    <message>
        <source>Interpolate</source>
        <translation>Auffüllen</translation>
    </message>
</context>
<context>
    <name>ErrorPhrases</name>
    <message>
        <source>is not of a recording</source>
        <translation>gehört zu keiner Aufnahme</translation>
    </message>
    <message>
        <source>Give a folder that &apos;glisson track&apos; filled, or what was written beside a recording</source>
        <translation>Geben Sie einen Ordner an, den &apos;glisson track&apos; gefüllt hat, oder was neben einer Aufnahme geschrieben wurde</translation>
    </message>
    <message>
        <source>Give the file NAME.frames.jsonl that was written beside it</source>
        <translation>Geben Sie die Datei NAME.frames.jsonl an, die daneben geschrieben wurde</translation>
    </message>
    <message>
        <source>does not exist</source>
        <translation>gibt es nicht</translation>
    </message>
    <message>
        <source>is neither a file nor a folder</source>
        <translation>ist weder Datei noch Ordner</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>kann nicht geöffnet werden</translation>
    </message>
    <message>
        <source>cannot be opened (%1)</source>
        <translation>kann nicht geöffnet werden (%1)</translation>
    </message>
    <message>
        <source>cannot be read (%1)</source>
        <translation>kann nicht gelesen werden (%1)</translation>
    </message>
    <message>
        <source>cannot be started (%1)</source>
        <translation>kann nicht gestartet werden (%1)</translation>
    </message>
    <message>
        <source>the program that reads foreign files is missing</source>
        <translation>das Programm, das fremde Dateien liest, fehlt</translation>
    </message>
    <message>
        <source>a library of Glisson is missing or cannot be loaded</source>
        <translation>eine Bibliothek von Glisson fehlt oder kann nicht geladen werden</translation>
    </message>
    <message>
        <source>cannot run</source>
        <translation>läuft nicht</translation>
    </message>
    <message>
        <source>could not be written</source>
        <translation>konnte nicht geschrieben werden</translation>
    </message>
    <message>
        <source>is shorter than expected</source>
        <translation>ist kürzer als erwartet</translation>
    </message>
    <message>
        <source>has no room for a volume of %1 MB</source>
        <translation>hat keinen Platz für ein Volumen von %1 MB</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>are missing</source>
        <translation>fehlen</translation>
    </message>
    <message>
        <source>is damaged</source>
        <translation>ist beschädigt</translation>
    </message>
    <message>
        <source>ends early: the slice was cut</source>
        <translation>endet zu früh: Die Schicht wurde abgeschnitten</translation>
    </message>
    <message>
        <source>is followed by no element: bytes were put in among them</source>
        <translation>wird von keinem Element gefolgt: Es wurden Bytes eingefügt</translation>
    </message>
    <message>
        <source>say fewer pixels than the slice holds</source>
        <translation>nennen weniger Bildpunkte, als die Schicht enthält</translation>
    </message>
    <message>
        <source>stands in some slices and is missing in others</source>
        <translation>steht in einigen Schichten und fehlt in anderen</translation>
    </message>
    <message>
        <source>is another than in %1</source>
        <translation>ist anders als in %1</translation>
    </message>
    <message>
        <source>is &quot;%1&quot; where %2 says &quot;%3&quot;</source>
        <translation>ist „%1“, während %2 „%3“ sagt</translation>
    </message>
    <message>
        <source>is %1 where the file holds %2 bytes of voxels</source>
        <translation>ist %1, die Datei enthält aber %2 Bytes an Voxeln</translation>
    </message>
    <message>
        <source>holds &quot;%1&quot;, which its number type does not hold</source>
        <translation>enthält „%1“, was sein Zahlentyp nicht fasst</translation>
    </message>
    <message>
        <source>holds more than 5000 folders, which no series has</source>
        <translation>enthält mehr als 5000 Ordner, was keine Serie hat</translation>
    </message>
    <message>
        <source>holds folders in folders more than 32 deep, which no series has</source>
        <translation>enthält Ordner in Ordnern mehr als 32 tief, was keine Serie hat</translation>
    </message>
    <message>
        <source>holds more than %1 points or cells, more than the mesh of an organ needs</source>
        <translation>enthält mehr als %1 Punkte oder Zellen, mehr als das Netz eines Organs braucht</translation>
    </message>
    <message>
        <source>Correct the type, or export the volume again</source>
        <translation>Berichtigen Sie den Typ, oder exportieren Sie das Volumen erneut</translation>
    </message>
    <message>
        <source>Ask where it comes from; unpack it yourself and name the file if it is good</source>
        <translation>Fragen Sie, woher es kommt; entpacken Sie es selbst und nennen Sie die Datei, wenn sie gut ist</translation>
    </message>
    <message>
        <source>Make the mesh coarser</source>
        <translation>Vergröbern Sie das Netz</translation>
    </message>
    <message>
        <source>is damaged or ends early</source>
        <translation>ist beschädigt oder endet zu früh</translation>
    </message>
    <message>
        <source>is damaged or not of the format that its name claims</source>
        <translation>ist beschädigt oder nicht von dem Format, das der Name behauptet</translation>
    </message>
    <message>
        <source>is damaged: the program that reads it broke down</source>
        <translation>ist beschädigt: Das Programm, das es liest, ist daran zerbrochen</translation>
    </message>
    <message>
        <source>is an empty folder</source>
        <translation>ist ein leerer Ordner</translation>
    </message>
    <message>
        <source>holds no file: %1 is a pipe, a socket, a device or a link to no file</source>
        <translation>enthält keine Datei: %1 ist eine Pipe, ein Socket, ein Gerät oder ein Verweis auf keine Datei</translation>
    </message>
    <message>
        <source>stands twice</source>
        <translation>steht zweimal da</translation>
    </message>
    <message>
        <source>ends early</source>
        <translation>endet zu früh</translation>
    </message>
    <message>
        <source>cannot be unpacked: it is damaged</source>
        <translation>kann nicht entpackt werden: Es ist beschädigt</translation>
    </message>
    <message>
        <source>holds more than 100000 files, which no series has</source>
        <translation>enthält mehr als 100000 Dateien, so viele hat keine Serie</translation>
    </message>
    <message>
        <source>unpacks to more than a hundred times its size, which no images do</source>
        <translation>wird entpackt mehr als hundertmal so groß, das wird kein Bild</translation>
    </message>
    <message>
        <source>needs more space for temporary files than is free in %1</source>
        <translation>braucht mehr Platz für temporäre Dateien, als in %1 frei ist</translation>
    </message>
    <message>
        <source>is a single DICOM slice</source>
        <translation>ist eine einzelne DICOM-Schicht</translation>
    </message>
    <message>
        <source>holds a single slice, not a volume</source>
        <translation>enthält eine einzelne Schicht, kein Volumen</translation>
    </message>
    <message>
        <source>holds no DICOM image</source>
        <translation>enthält kein DICOM-Bild</translation>
    </message>
    <message>
        <source>is an archive, not a file of labels</source>
        <translation>ist ein Archiv, keine Datei mit Labels</translation>
    </message>
    <message>
        <source>is no folder of DICOM slices</source>
        <translation>ist kein Ordner mit DICOM-Schichten</translation>
    </message>
    <message>
        <source>holds %1 series: %2</source>
        <translation>enthält %1 Serien: %2</translation>
    </message>
    <message>
        <source>cannot be chosen in a file that holds one volume</source>
        <translation>kann in einer Datei mit einem Volumen nicht gewählt werden</translation>
    </message>
    <message>
        <source>is a DICOM file that cannot be read</source>
        <translation>ist eine DICOM-Datei, die nicht gelesen werden kann</translation>
    </message>
    <message>
        <source>is a DICOM image that cannot be read</source>
        <translation>ist ein DICOM-Bild, das nicht gelesen werden kann</translation>
    </message>
    <message>
        <source>has no tag (%1), so that its place in the patient is unknown</source>
        <translation>hat das Feld (%1) nicht, sein Ort im Patienten ist deshalb unbekannt</translation>
    </message>
    <message>
        <source>holds a direction whose length is not 1</source>
        <translation>enthält eine Richtung, deren Länge nicht 1 ist</translation>
    </message>
    <message>
        <source>is %1 mm, which is no pixel&apos;s</source>
        <translation>ist %1 mm, so groß ist kein Pixel</translation>
    </message>
    <message>
        <source>is %1 mm, which is no voxel&apos;s</source>
        <translation>ist %1 mm, so groß ist kein Voxel</translation>
    </message>
    <message>
        <source>is %1, which makes no intensities of the pixels</source>
        <translation>ist %1, daraus werden aus Pixeln keine Intensitäten</translation>
    </message>
    <message>
        <source>is a colour picture, not a slice of a volume</source>
        <translation>ist ein Farbbild, keine Schicht eines Volumens</translation>
    </message>
    <message>
        <source>holds several frames in one file</source>
        <translation>enthält mehrere Bilder in einer Datei</translation>
    </message>
    <message>
        <source>has another size than the other slices</source>
        <translation>hat eine andere Größe als die anderen Schichten</translation>
    </message>
    <message>
        <source>has another orientation or pixel spacing than the other slices</source>
        <translation>hat eine andere Ausrichtung oder Pixelgröße als die anderen Schichten</translation>
    </message>
    <message>
        <source>lie at the same place: %1</source>
        <translation>liegen an derselben Stelle: %1</translation>
    </message>
    <message>
        <source>has pixels that cannot be decoded</source>
        <translation>hat Pixel, die nicht entpackt werden können</translation>
    </message>
    <message>
        <source>hold fewer pixels than they claim</source>
        <translation>enthalten weniger Pixel, als sie behaupten</translation>
    </message>
    <message>
        <source>gives its intensities by a table (Modality LUT), which is not read</source>
        <translation>gibt seine Intensitäten durch eine Tabelle (Modality LUT) an, die nicht gelesen wird</translation>
    </message>
    <message>
        <source>has pixels in a number format that is not known</source>
        <translation>hat Pixel in einem unbekannten Zahlenformat</translation>
    </message>
    <message>
        <source>is a number format that is not known</source>
        <translation>ist ein unbekanntes Zahlenformat</translation>
    </message>
    <message>
        <source>has an extension that is not known</source>
        <translation>hat eine unbekannte Endung</translation>
    </message>
    <message>
        <source>is a flat picture, not a volume</source>
        <translation>ist ein flaches Bild, kein Volumen</translation>
    </message>
    <message>
        <source>is that of a flat picture, not of a volume</source>
        <translation>ist der eines flachen Bildes, nicht eines Volumens</translation>
    </message>
    <message>
        <source>is that of a colour picture</source>
        <translation>ist der eines Farbbildes</translation>
    </message>
    <message>
        <source>is a series of %1 volumes, not one volume</source>
        <translation>ist eine Reihe von %1 Volumina, nicht eines</translation>
    </message>
    <message>
        <source>claims %1 voxels of %2 value(s)</source>
        <translation>behauptet %1 Voxel zu je %2 Wert(en)</translation>
    </message>
    <message>
        <source>is %1 mm, which is no patient&apos;s</source>
        <translation>ist %1 mm, so ist kein Patient</translation>
    </message>
    <message>
        <source>is (%1) mm, which is nowhere near a scanner</source>
        <translation>ist (%1) mm, das ist weit weg von jedem Scanner</translation>
    </message>
    <message>
        <source>has axes that are not at right angles (a sheared volume)</source>
        <translation>hat Achsen, die nicht senkrecht aufeinander stehen (ein geschertes Volumen)</translation>
    </message>
    <message>
        <source>has an axis of %1 mm from voxel to voxel, which is no patient&apos;s</source>
        <translation>hat eine Achse mit %1 mm von Voxel zu Voxel, so ist kein Patient</translation>
    </message>
    <message>
        <source>is read differently by two readers</source>
        <translation>wird von zwei Lesern verschieden gelesen</translation>
    </message>
    <message>
        <source>are read differently by two readers, by up to %1 mm</source>
        <translation>werden von zwei Lesern um bis zu %1 mm verschieden gelesen</translation>
    </message>
    <message>
        <source>are counted differently by two readers</source>
        <translation>werden von zwei Lesern verschieden gezählt</translation>
    </message>
    <message>
        <source>end early: the file is damaged</source>
        <translation>enden zu früh: Die Datei ist beschädigt</translation>
    </message>
    <message>
        <source>says that the voxels are compressed, but they are not, or are damaged</source>
        <translation>sagt, die Voxel seien gepackt, aber sie sind es nicht oder sind beschädigt</translation>
    </message>
    <message>
        <source>says fewer voxels than the file holds (%1 of %2 bytes or more)</source>
        <translation>nennt weniger Voxel, als die Datei enthält (%1 von %2 Bytes oder mehr)</translation>
    </message>
    <message>
        <source>needs more memory than there is</source>
        <translation>braucht mehr Speicher, als da ist</translation>
    </message>
    <message>
        <source>hold a value that is not a number</source>
        <translation>enthalten einen Wert, der keine Zahl ist</translation>
    </message>
    <message>
        <source>hold %1, which is no %2</source>
        <translation>enthalten %1, das ist kein Wert dieser Art (%2)</translation>
    </message>
    <message>
        <source>run from %1 to %2 only: too few grey levels when rounded</source>
        <translation>reichen nur von %1 bis %2: gerundet zu wenige Graustufen</translation>
    </message>
    <message>
        <source>run from %1 to %2, beyond 16-bit integers</source>
        <translation>reichen von %1 bis %2, über ganze Zahlen von 16 Bit hinaus</translation>
    </message>
    <message>
        <source>hold %1 values each (a colour or vector image)</source>
        <translation>enthalten je %1 Werte (ein Farb- oder Vektorbild)</translation>
    </message>
    <message>
        <source>are both 0: the file does not say which way the patient lies</source>
        <translation>sind beide 0: Die Datei sagt nicht, wie herum der Patient liegt</translation>
    </message>
    <message>
        <source>place the volume differently, by up to %1 mm</source>
        <translation>setzen das Volumen um bis zu %1 mm verschieden</translation>
    </message>
    <message>
        <source>is not a NRRD file</source>
        <translation>ist keine NRRD-Datei</translation>
    </message>
    <message>
        <source>is not that of a NIfTI-1 file</source>
        <translation>ist nicht der einer NIfTI-1-Datei</translation>
    </message>
    <message>
        <source>is not a VTK image file (.vti)</source>
        <translation>ist keine VTK-Bilddatei (.vti)</translation>
    </message>
    <message>
        <source>is %1 voxels where %2 are expected</source>
        <translation>ist %1 Voxel groß, erwartet sind %2</translation>
    </message>
    <message>
        <source>has the right size but lies elsewhere in the patient</source>
        <translation>hat die richtige Größe, liegt aber anderswo im Patienten</translation>
    </message>
    <message>
        <source>has an extension that volumes are not written to</source>
        <translation>hat eine Endung, unter der keine Volumina geschrieben werden</translation>
    </message>
    <message>
        <source>stands for %1, which is no structure</source>
        <translation>steht für %1, das ist keine Struktur</translation>
    </message>
    <message>
        <source>nothing of the liver is left after the codes were applied</source>
        <translation>von der Leber bleibt nichts, nachdem die Codes angewandt wurden</translation>
    </message>
    <message>
        <source>the liver lies to the left of the vena cava: the volume is mirrored, or the liver&apos;s right part was removed</source>
        <translation>die Leber liegt links der Vena cava: Das Volumen ist gespiegelt, oder der rechte Teil der Leber wurde entfernt</translation>
    </message>
    <message>
        <source>none of them is the liver&apos;s parenchyma</source>
        <translation>keiner davon ist das Parenchym der Leber</translation>
    </message>
    <message>
        <source>lies in tissue of %1 HU, which no liver has in the portal venous phase</source>
        <translation>liegt in Gewebe von %1 HE, das hat keine Leber in der portalvenösen Phase</translation>
    </message>
    <message>
        <source>is not there, and was not to be segmented</source>
        <translation>ist nicht da und sollte nicht segmentiert werden</translation>
    </message>
    <message>
        <source>would need %1 million voxels</source>
        <translation>brauchte %1 Millionen Voxel</translation>
    </message>
    <message>
        <source>is not a list of points</source>
        <translation>ist keine Liste von Punkten</translation>
    </message>
    <message>
        <source>is not a point</source>
        <translation>ist kein Punkt</translation>
    </message>
    <message>
        <source>is nowhere near a patient</source>
        <translation>liegt weit weg von jedem Patienten</translation>
    </message>
    <message>
        <source>is not a JSON object of seeds</source>
        <translation>ist kein JSON-Objekt mit Klicks</translation>
    </message>
    <message>
        <source>is not a list of lesions</source>
        <translation>ist keine Liste von Läsionen</translation>
    </message>
    <message>
        <source>is no structure that seeds are read for</source>
        <translation>ist keine Struktur, für die Klicks gelesen werden</translation>
    </message>
    <message>
        <source>lies outside the image</source>
        <translation>liegt außerhalb des Bildes</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>ist leer</translation>
    </message>
    <message>
        <source>are more than there are labels for</source>
        <translation>sind mehr, als es Kennzeichen gibt</translation>
    </message>
    <message>
        <source>holds too little of the image</source>
        <translation>enthält zu wenig vom Bild</translation>
    </message>
    <message>
        <source>has no point in the region</source>
        <translation>hat keinen Punkt im Gebiet</translation>
    </message>
    <message>
        <source>is locked</source>
        <translation>ist gesperrt</translation>
    </message>
    <message>
        <source>has no click on the liver, beside it, on its veins or on a lesion that the case does not have</source>
        <translation>hat keinen Klick auf die Leber, neben sie, auf ihre Venen oder auf eine Läsion, den der Fall nicht hat</translation>
    </message>
    <message>
        <source>has no point</source>
        <translation>hat keinen Punkt</translation>
    </message>
    <message>
        <source>grow to nothing: the clicks do not lie in liver tissue</source>
        <translation>wachsen nicht: Die Klicks liegen nicht in Lebergewebe</translation>
    </message>
    <message>
        <source>exists and is not a case</source>
        <translation>gibt es schon und ist kein Fall</translation>
    </message>
    <message>
        <source>is not a Glisson case</source>
        <translation>ist kein Fall von Glisson</translation>
    </message>
    <message>
        <source>is malformed (%1)</source>
        <translation>ist fehlerhaft (%1)</translation>
    </message>
    <message>
        <source>is not valid JSON</source>
        <translation>ist kein gültiges JSON</translation>
    </message>
    <message>
        <source>holds a number that is larger than any</source>
        <translation>enthält eine Zahl, die größer ist als jede</translation>
    </message>
    <message>
        <source>is a link that leads out of the case, or to nothing</source>
        <translation>ist ein Verweis, der aus dem Fall oder ins Leere führt</translation>
    </message>
    <message>
        <source>names &quot;%1&quot;, which lies outside the case</source>
        <translation>nennt &quot;%1&quot;, das außerhalb des Falls liegt</translation>
    </message>
    <message>
        <source>the case has never been saved</source>
        <translation>der Fall wurde nie gespeichert</translation>
    </message>
    <message>
        <source>there is no step to undo</source>
        <translation>es gibt keinen Schritt zurückzunehmen</translation>
    </message>
    <message>
        <source>there is no step to redo</source>
        <translation>es gibt keinen Schritt zu wiederholen</translation>
    </message>
    <message>
        <source>the video has only %1 frames</source>
        <translation>das Video hat nur %1 Bilder</translation>
    </message>
    <message>
        <source>was refused: what is known contradicts it</source>
        <translation>wurde abgelehnt: Was bekannt ist, widerspricht ihr</translation>
    </message>
    <message>
        <source>has no tetrahedra</source>
        <translation>hat keine Tetraeder</translation>
    </message>
    <message>
        <source>is not this model&apos;s (%1 nodes, the model has %2)</source>
        <translation>ist nicht die dieses Modells (%1 Knoten, das Modell hat %2)</translation>
    </message>
    <message>
        <source>the cloud has no points</source>
        <translation>die Wolke hat keine Punkte</translation>
    </message>
    <message>
        <source>has a coordinate that is not a number</source>
        <translation>hat eine Koordinate, die keine Zahl ist</translation>
    </message>
    <message>
        <source>is of no known mesh format (&quot;%1&quot;)</source>
        <translation>hat kein bekanntes Netzformat (&quot;%1&quot;)</translation>
    </message>
    <message>
        <source>is no surface format (&quot;%1&quot;)</source>
        <translation>ist kein Format für Oberflächen (&quot;%1&quot;)</translation>
    </message>
    <message>
        <source>is no tetrahedral mesh format (&quot;%1&quot;)</source>
        <translation>ist kein Format für Tetraedernetze (&quot;%1&quot;)</translation>
    </message>
    <message>
        <source>is larger than 300 MB, more than the mesh of an organ needs</source>
        <translation>ist größer als 300 MB, mehr als das Netz eines Organs braucht</translation>
    </message>
    <message>
        <source>names a vertex that is not there</source>
        <translation>nennt eine Ecke, die es nicht gibt</translation>
    </message>
    <message>
        <source>names a point that is not there</source>
        <translation>nennt einen Punkt, den es nicht gibt</translation>
    </message>
    <message>
        <source>is inverted (volume %1 mm3)</source>
        <translation>ist umgestülpt (Volumen %1 mm3)</translation>
    </message>
    <message>
        <source>is flat</source>
        <translation>ist flach</translation>
    </message>
    <message>
        <source>the file ends here</source>
        <translation>die Datei endet hier</translation>
    </message>
    <message>
        <source>is not a PLY file (its first line is not &quot;ply&quot;)</source>
        <translation>ist keine PLY-Datei (die erste Zeile ist nicht &quot;ply&quot;)</translation>
    </message>
    <message>
        <source>claims %1 x %2 pixels, more than any camera has</source>
        <translation>behauptet %1 x %2 Pixel, mehr als jede Kamera hat</translation>
    </message>
    <message>
        <source>is not a whole picture that can be read</source>
        <translation>ist kein ganzes Bild, das gelesen werden kann</translation>
    </message>
    <message>
        <source>has no extension of a picture</source>
        <translation>hat keine Endung eines Bildes</translation>
    </message>
    <message>
        <source>is not a video that can be read</source>
        <translation>ist kein Video, das gelesen werden kann</translation>
    </message>
    <message>
        <source>does not say its size or frame rate</source>
        <translation>nennt weder Größe noch Bildrate</translation>
    </message>
    <message>
        <source>is damaged after %1 frames: the program that reads it broke down</source>
        <translation>ist nach %1 Bildern beschädigt: Das Programm, das es liest, ist daran zerbrochen</translation>
    </message>
    <message>
        <source>breaks off after %1 frames of %2</source>
        <translation>bricht nach %1 von %2 Bildern ab</translation>
    </message>
    <message>
        <source>is %1, the left video %2</source>
        <translation>ist %1 groß, das linke Video %2</translation>
    </message>
    <message>
        <source>is %1, the left picture %2</source>
        <translation>ist %1 groß, das linke Bild %2</translation>
    </message>
    <message>
        <source>is %1, the pictures before %2</source>
        <translation>ist %1 groß, die Bilder davor %2</translation>
    </message>
    <message>
        <source>is for pictures of %1, the pictures are %2</source>
        <translation>ist für Bilder von %1, die Bilder sind %2 groß</translation>
    </message>
    <message>
        <source>left and right pictures differ in size</source>
        <translation>linkes und rechtes Bild sind verschieden groß</translation>
    </message>
    <message>
        <source>has another frame rate than the left video</source>
        <translation>hat eine andere Bildrate als das linke Video</translation>
    </message>
    <message>
        <source>have no frames within %1 ms of each other (%2 s and %3 s)</source>
        <translation>haben keine Bilder, die weniger als %1 ms auseinanderliegen (%2 s und %3 s)</translation>
    </message>
    <message>
        <source>leaves %1 from (%2, %3) of views of %4</source>
        <translation>lässt von Ansichten von %4 nur %1 ab (%2, %3)</translation>
    </message>
    <message>
        <source>is no device</source>
        <translation>ist kein Gerät</translation>
    </message>
    <message>
        <source>is an address of a kind that is not opened</source>
        <translation>ist eine Adresse von einer Art, die nicht geöffnet wird</translation>
    </message>
    <message>
        <source>names a source outside this computer (%1)</source>
        <translation>nennt eine Quelle außerhalb dieses Rechners (%1)</translation>
    </message>
    <message>
        <source>names pictures that nobody here has chosen (%1)</source>
        <translation>nennt Bilder, die hier niemand gewählt hat (%1)</translation>
    </message>
    <message>
        <source>Choose the source again</source>
        <translation>Die Quelle noch einmal wählen</translation>
    </message>
    <message>
        <source>Open them yourself if you trust the case</source>
        <translation>Sie selbst öffnen, wenn dem Fall zu trauen ist</translation>
    </message>
    <message>
        <source>Give them by --video, if you trust the case</source>
        <translation>Sie mit --video angeben, wenn dem Fall zu trauen ist</translation>
    </message>
    <message>
        <source>Enter that source yourself where pictures are opened, if you trust it</source>
        <translation>Diese Quelle selbst eingeben, wo Bilder geöffnet werden, wenn ihr zu trauen ist</translation>
    </message>
    <message>
        <source>is not a name for a recording</source>
        <translation>ist kein Name für eine Aufnahme</translation>
    </message>
    <message>
        <source>cannot be opened for recording</source>
        <translation>kann nicht zur Aufnahme geöffnet werden</translation>
    </message>
    <message>
        <source>the disk is full after %1 frames</source>
        <translation>die Platte ist nach %1 Bildern voll</translation>
    </message>
    <message>
        <source>not one frame was recorded</source>
        <translation>nicht ein Bild wurde aufgenommen</translation>
    </message>
    <message>
        <source>holds no pictures</source>
        <translation>enthält keine Bilder</translation>
    </message>
    <message>
        <source>holds no pair (%1 left pictures, %2 right ones)</source>
        <translation>enthält kein Paar (%1 linke Bilder, %2 rechte)</translation>
    </message>
    <message>
        <source>hold %1 and %2 pictures with no name in common</source>
        <translation>enthalten %1 und %2 Bilder ohne gemeinsamen Namen</translation>
    </message>
    <message>
        <source>is no folder</source>
        <translation>ist kein Ordner</translation>
    </message>
    <message>
        <source>is black in both views</source>
        <translation>ist in beiden Ansichten schwarz</translation>
    </message>
    <message>
        <source>shows nothing in the left view</source>
        <translation>zeigt in der linken Ansicht nichts</translation>
    </message>
    <message>
        <source>shows nothing in the right view</source>
        <translation>zeigt in der rechten Ansicht nichts</translation>
    </message>
    <message>
        <source>is the same picture in both views</source>
        <translation>ist in beiden Ansichten dasselbe Bild</translation>
    </message>
    <message>
        <source>fits the calibration better when left and right are swapped</source>
        <translation>passt besser zur Kalibrierung, wenn links und rechts getauscht sind</translation>
    </message>
    <message>
        <source>shows nothing in common in its two views</source>
        <translation>zeigt in beiden Ansichten nichts Gemeinsames</translation>
    </message>
    <message>
        <source>are the same picture</source>
        <translation>sind dasselbe Bild</translation>
    </message>
    <message>
        <source>gives %1 points (%2 and %3 features, %4 matches), too few for a surface</source>
        <translation>gibt %1 Punkte (%2 und %3 Merkmale, %4 Paare), zu wenige für eine Oberfläche</translation>
    </message>
    <message>
        <source>hold none of the pair&apos;s %1 points</source>
        <translation>enthalten keinen der %1 Punkte des Paares</translation>
    </message>
    <message>
        <source>belong to frame %1 (%2), not to this pair (%3)</source>
        <translation>gehören zu Bild %1 (%2), nicht zu diesem Paar (%3)</translation>
    </message>
    <message>
        <source>is not a calibration (too large, or not text)</source>
        <translation>ist keine Kalibrierung (zu groß oder kein Text)</translation>
    </message>
    <message>
        <source>is not an OpenCV YAML file</source>
        <translation>ist keine YAML-Datei von OpenCV</translation>
    </message>
    <message>
        <source>is XML, which is not read</source>
        <translation>ist XML, das wird nicht gelesen</translation>
    </message>
    <message>
        <source>is not a rotation (determinant %1)</source>
        <translation>ist keine Drehung (Determinante %1)</translation>
    </message>
    <message>
        <source>is zero: the cameras have no baseline</source>
        <translation>ist null: Die Kameras haben keinen Abstand</translation>
    </message>
    <message>
        <source>gives a baseline of %1 mm, where a stereo laparoscope has 1 to 30 mm</source>
        <translation>gibt einen Kameraabstand von %1 mm, ein Stereolaparoskop hat 1 bis 30 mm</translation>
    </message>
    <message>
        <source>puts the right camera %1 mm to the left of the left one</source>
        <translation>setzt die rechte Kamera %1 mm links neben die linke</translation>
    </message>
    <message>
        <source>are swapped: the right camera would lie %1 mm to the left of the left one</source>
        <translation>sind vertauscht: Die rechte Kamera läge %1 mm links von der linken</translation>
    </message>
    <message>
        <source>is not a matrix</source>
        <translation>ist keine Matrix</translation>
    </message>
    <message>
        <source>Check the path</source>
        <translation>Prüfen Sie den Pfad</translation>
    </message>
    <message>
        <source>Check its permissions</source>
        <translation>Prüfen Sie die Rechte</translation>
    </message>
    <message>
        <source>Check permissions and space</source>
        <translation>Prüfen Sie Rechte und freien Platz</translation>
    </message>
    <message>
        <source>Install Glisson again</source>
        <translation>Installieren Sie Glisson neu</translation>
    </message>
    <message>
        <source>Free space for temporary files</source>
        <translation>Schaffen Sie Platz für temporäre Dateien</translation>
    </message>
    <message>
        <source>Free space for temporary files, or set TMPDIR to a larger disk</source>
        <translation>Schaffen Sie Platz für temporäre Dateien, oder setzen Sie TMPDIR auf einen größeren Datenträger</translation>
    </message>
    <message>
        <source>Free some space, set TMPDIR to a larger disk, or unpack it yourself and name the folder</source>
        <translation>Schaffen Sie Platz, setzen Sie TMPDIR auf einen größeren Datenträger, oder entpacken Sie es selbst und nennen Sie den Ordner</translation>
    </message>
    <message>
        <source>Choose another name</source>
        <translation>Wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>Choose another file</source>
        <translation>Wählen Sie eine andere Datei</translation>
    </message>
    <message>
        <source>Choose such a name</source>
        <translation>Wählen Sie einen solchen Namen</translation>
    </message>
    <message>
        <source>Choose a folder NAME.glisson</source>
        <translation>Wählen Sie einen Ordner NAME.glisson</translation>
    </message>
    <message>
        <source>Choose a folder NAME.glisson to save it to</source>
        <translation>Wählen Sie einen Ordner NAME.glisson, in den er gespeichert wird</translation>
    </message>
    <message>
        <source>Correct it there or write the file anew</source>
        <translation>Berichtigen Sie es dort oder schreiben Sie die Datei neu</translation>
    </message>
    <message>
        <source>Write the file anew</source>
        <translation>Schreiben Sie die Datei neu</translation>
    </message>
    <message>
        <source>Restore the case from a copy</source>
        <translation>Stellen Sie den Fall aus einer Kopie wieder her</translation>
    </message>
    <message>
        <source>Restore the case from a copy; nothing outside its folder is opened</source>
        <translation>Stellen Sie den Fall aus einer Kopie wieder her; außerhalb seines Ordners wird nichts geöffnet</translation>
    </message>
    <message>
        <source>Put a copy of what it means in its place, or remove it</source>
        <translation>Legen Sie eine Kopie dessen, was gemeint ist, an seine Stelle, oder entfernen Sie es</translation>
    </message>
    <message>
        <source>Fetch the archive again, or unpack it yourself and name the folder</source>
        <translation>Holen Sie das Archiv noch einmal, oder entpacken Sie es selbst und nennen Sie den Ordner</translation>
    </message>
    <message>
        <source>Unpack it yourself and name the folder of the series</source>
        <translation>Entpacken Sie es selbst und nennen Sie den Ordner der Serie</translation>
    </message>
    <message>
        <source>Ask where it comes from; unpack it yourself and name the folder if it is good</source>
        <translation>Fragen Sie, woher es kommt; ist es gut, entpacken Sie es selbst und nennen Sie den Ordner</translation>
    </message>
    <message>
        <source>The header is damaged, or crop the volume</source>
        <translation>Der Kopf ist beschädigt, oder schneiden Sie das Volumen zu</translation>
    </message>
    <message>
        <source>The header is damaged: export the volume again</source>
        <translation>Der Kopf ist beschädigt: Exportieren Sie das Volumen noch einmal</translation>
    </message>
    <message>
        <source>Correct the header, or export the volume again</source>
        <translation>Berichtigen Sie den Kopf, oder exportieren Sie das Volumen noch einmal</translation>
    </message>
    <message>
        <source>Check that the file&apos;s unit is the millimetre and correct its header</source>
        <translation>Prüfen Sie, ob die Einheit der Datei der Millimeter ist, und berichtigen Sie den Kopf</translation>
    </message>
    <message>
        <source>Correct the file&apos;s header</source>
        <translation>Berichtigen Sie den Kopf der Datei</translation>
    </message>
    <message>
        <source>Correct the header</source>
        <translation>Berichtigen Sie den Kopf</translation>
    </message>
    <message>
        <source>Resample the volume to a rectangular grid</source>
        <translation>Rechnen Sie das Volumen auf ein rechtwinkliges Gitter um</translation>
    </message>
    <message>
        <source>Resample the series to a rectangular grid</source>
        <translation>Rechnen Sie die Serie auf ein rechtwinkliges Gitter um</translation>
    </message>
    <message>
        <source>Export it again</source>
        <translation>Exportieren Sie es noch einmal</translation>
    </message>
    <message>
        <source>Export the volume again</source>
        <translation>Exportieren Sie das Volumen noch einmal</translation>
    </message>
    <message>
        <source>Export the series again</source>
        <translation>Exportieren Sie die Serie noch einmal</translation>
    </message>
    <message>
        <source>Export the series again, uncompressed</source>
        <translation>Exportieren Sie die Serie noch einmal, ungepackt</translation>
    </message>
    <message>
        <source>Export the series again as 16-bit integers</source>
        <translation>Exportieren Sie die Serie noch einmal als ganze Zahlen von 16 Bit</translation>
    </message>
    <message>
        <source>Export the series with RescaleSlope and RescaleIntercept</source>
        <translation>Exportieren Sie die Serie mit RescaleSlope und RescaleIntercept</translation>
    </message>
    <message>
        <source>Export the series from the scanner again, not from a viewer</source>
        <translation>Exportieren Sie die Serie noch einmal vom Scanner, nicht aus einem Betrachter</translation>
    </message>
    <message>
        <source>Export the whole series again, or resample it</source>
        <translation>Exportieren Sie die ganze Serie noch einmal, oder rechnen Sie sie um</translation>
    </message>
    <message>
        <source>Export it as 16-bit integers</source>
        <translation>Exportieren Sie es als ganze Zahlen von 16 Bit</translation>
    </message>
    <message>
        <source>Export a single time point</source>
        <translation>Exportieren Sie einen einzigen Zeitpunkt</translation>
    </message>
    <message>
        <source>Export a single volume</source>
        <translation>Exportieren Sie ein einziges Volumen</translation>
    </message>
    <message>
        <source>Export a volume with one value a voxel</source>
        <translation>Exportieren Sie ein Volumen mit einem Wert je Voxel</translation>
    </message>
    <message>
        <source>Export the file anew</source>
        <translation>Exportieren Sie die Datei neu</translation>
    </message>
    <message>
        <source>The file is damaged: export it again</source>
        <translation>Die Datei ist beschädigt: Exportieren Sie sie noch einmal</translation>
    </message>
    <message>
        <source>The file is damaged, or its exporter is: export it anew</source>
        <translation>Die Datei oder ihr Exporteur ist schadhaft: Exportieren Sie sie neu</translation>
    </message>
    <message>
        <source>Remove it from the folder</source>
        <translation>Entfernen Sie es aus dem Ordner</translation>
    </message>
    <message>
        <source>Remove it from the folder (is it a scout view?)</source>
        <translation>Entfernen Sie es aus dem Ordner (ist es eine Übersichtsaufnahme?)</translation>
    </message>
    <message>
        <source>Keep one phase or one copy only</source>
        <translation>Behalten Sie nur eine Phase oder eine Kopie</translation>
    </message>
    <message>
        <source>Convert it to NIfTI or to single slices</source>
        <translation>Wandeln Sie es in NIfTI oder in einzelne Schichten um</translation>
    </message>
    <message>
        <source>Convert the volume to millimetres</source>
        <translation>Rechnen Sie das Volumen in Millimeter um</translation>
    </message>
    <message>
        <source>Name a volume</source>
        <translation>Nennen Sie ein Volumen</translation>
    </message>
    <message>
        <source>Name the folder that holds the DICOM slices</source>
        <translation>Nennen Sie den Ordner mit den DICOM-Schichten</translation>
    </message>
    <message>
        <source>Name the folder that holds the series</source>
        <translation>Nennen Sie den Ordner, der die Serie enthält</translation>
    </message>
    <message>
        <source>Name a folder with the whole series</source>
        <translation>Nennen Sie einen Ordner mit der ganzen Serie</translation>
    </message>
    <message>
        <source>Choose one by its number or UID, or put each into a folder of its own</source>
        <translation>Wählen Sie eine durch Nummer oder UID, oder legen Sie jede in einen eigenen Ordner</translation>
    </message>
    <message>
        <source>Choose one of these by its UID</source>
        <translation>Wählen Sie eine davon durch ihre UID</translation>
    </message>
    <message>
        <source>Leave the series out, or name the folder that holds the DICOM slices</source>
        <translation>Lassen Sie die Serie weg, oder nennen Sie den Ordner mit den DICOM-Schichten</translation>
    </message>
    <message>
        <source>Check that this is the right file</source>
        <translation>Prüfen Sie, ob dies die richtige Datei ist</translation>
    </message>
    <message>
        <source>Scale the intensities so that they span several hundred (a CT&apos;s unit is HU)</source>
        <translation>Skalieren Sie die Intensitäten auf einige hundert (die Einheit eines CT ist HE)</translation>
    </message>
    <message>
        <source>Scale the intensities to -32768 ... 32767</source>
        <translation>Skalieren Sie die Intensitäten auf -32768 ... 32767</translation>
    </message>
    <message>
        <source>Set one of them, or convert the original DICOM series</source>
        <translation>Setzen Sie einen davon, oder wandeln Sie die ursprüngliche DICOM-Serie um</translation>
    </message>
    <message>
        <source>Find out which is right and write the file anew with that one</source>
        <translation>Finden Sie heraus, was richtig ist, und schreiben Sie die Datei damit neu</translation>
    </message>
    <message>
        <source>Resample one of the two volumes to the other&apos;s grid</source>
        <translation>Rechnen Sie eines der beiden Volumina auf das Gitter des anderen um</translation>
    </message>
    <message>
        <source>Check origin, spacing and direction of the two volumes</source>
        <translation>Prüfen Sie Ursprung, Abstand und Richtung beider Volumina</translation>
    </message>
    <message>
        <source>Use .nrrd, .nii.gz, .nii or .mha</source>
        <translation>Nehmen Sie .nrrd, .nii.gz, .nii oder .mha</translation>
    </message>
    <message>
        <source>Put it beside the header</source>
        <translation>Legen Sie es neben den Kopf</translation>
    </message>
    <message>
        <source>Save the segmentation from Slicer again</source>
        <translation>Speichern Sie die Segmentierung noch einmal aus Slicer</translation>
    </message>
    <message>
        <source>Give the codes of this file: which number is parenchyma, portal_vein and so on</source>
        <translation>Geben Sie die Codes dieser Datei an: welche Zahl parenchyma, portal_vein und so weiter ist</translation>
    </message>
    <message>
        <source>Correct the direction in the file&apos;s header if left and right are swapped; after a right hepatectomy import it with &apos;glisson model --left-liver&apos;</source>
        <translation>Berichtigen Sie die Richtung im Kopf der Datei, wenn links und rechts vertauscht sind; nach einer rechten Hemihepatektomie importieren Sie mit &apos;glisson model --left-liver&apos;</translation>
    </message>
    <message>
        <source>Say which code means what with --codes FILE (see &apos;glisson model --help&apos;)</source>
        <translation>Sagen Sie mit --codes DATEI, welcher Code was bedeutet (siehe &apos;glisson model --help&apos;)</translation>
    </message>
    <message>
        <source>Click inside the parenchyma of a CT in Hounsfield units</source>
        <translation>Klicken Sie in das Parenchym eines CT in Hounsfield-Einheiten</translation>
    </message>
    <message>
        <source>Click inside the parenchyma, away from vessels and lesions</source>
        <translation>Klicken Sie in das Parenchym, weg von Gefäßen und Läsionen</translation>
    </message>
    <message>
        <source>Unlock it, or click another structure</source>
        <translation>Entsperren Sie sie, oder klicken Sie eine andere Struktur an</translation>
    </message>
    <message>
        <source>Add one, or leave --correct out</source>
        <translation>Fügen Sie einen hinzu, oder lassen Sie --correct weg</translation>
    </message>
    <message>
        <source>Click at least one point inside the liver</source>
        <translation>Klicken Sie mindestens einen Punkt in der Leber an</translation>
    </message>
    <message>
        <source>Click the largest ones</source>
        <translation>Klicken Sie die größten an</translation>
    </message>
    <message>
        <source>Segment the liver too, or paint it first</source>
        <translation>Segmentieren Sie auch die Leber, oder malen Sie sie zuerst</translation>
    </message>
    <message>
        <source>Choose a smaller region or a coarser spacing</source>
        <translation>Wählen Sie ein kleineres Gebiet oder ein gröberes Gitter</translation>
    </message>
    <message>
        <source>Draw the region around the liver</source>
        <translation>Ziehen Sie das Gebiet um die Leber</translation>
    </message>
    <message>
        <source>Import a CT first</source>
        <translation>Importieren Sie zuerst ein CT</translation>
    </message>
    <message>
        <source>Check that the seeds belong to this image and are in mm (LPS)</source>
        <translation>Prüfen Sie, ob die Klicks zu diesem Bild gehören und in mm sind (LPS)</translation>
    </message>
    <message>
        <source>Write lists of [x, y, z] in mm, patient coordinates (LPS)</source>
        <translation>Schreiben Sie Listen aus [x, y, z] in mm, Patientenkoordinaten (LPS)</translation>
    </message>
    <message>
        <source>Use liver, portal_vein, hepatic_veins, vena_cava, gallbladder, lesions, lesion_diameters_mm or background</source>
        <translation>Nehmen Sie liver, portal_vein, hepatic_veins, vena_cava, gallbladder, lesions, lesion_diameters_mm oder background</translation>
    </message>
    <message>
        <source>Edit the labels first</source>
        <translation>Bearbeiten Sie zuerst die Kennzeichen</translation>
    </message>
    <message>
        <source>Only what was undone last can be redone</source>
        <translation>Nur was zuletzt zurückgenommen wurde, kann wiederholt werden</translation>
    </message>
    <message>
        <source>Choose an earlier frame</source>
        <translation>Wählen Sie ein früheres Bild</translation>
    </message>
    <message>
        <source>Build the model again</source>
        <translation>Bauen Sie das Modell noch einmal</translation>
    </message>
    <message>
        <source>Build the model anew</source>
        <translation>Bauen Sie das Modell neu</translation>
    </message>
    <message>
        <source>Reconstruct the surface again</source>
        <translation>Rekonstruieren Sie die Oberfläche noch einmal</translation>
    </message>
    <message>
        <source>Reconstruct or export it again</source>
        <translation>Rekonstruieren oder exportieren Sie sie noch einmal</translation>
    </message>
    <message>
        <source>Register again with a better cloud, or accept it knowing its doubts</source>
        <translation>Registrieren Sie noch einmal mit einer besseren Wolke, oder nehmen Sie sie im Wissen um die Zweifel an</translation>
    </message>
    <message>
        <source>Remove the point or export the cloud again</source>
        <translation>Entfernen Sie den Punkt, oder exportieren Sie die Wolke noch einmal</translation>
    </message>
    <message>
        <source>The file is damaged: copy it again</source>
        <translation>Die Datei ist beschädigt: Kopieren Sie sie noch einmal</translation>
    </message>
    <message>
        <source>Use PNG, JPEG, BMP or TIFF, and copy it again if it was cut off</source>
        <translation>Nehmen Sie PNG, JPEG, BMP oder TIFF, und kopieren Sie es noch einmal, falls es abgeschnitten wurde</translation>
    </message>
    <message>
        <source>Use .png, .jpg or .bmp</source>
        <translation>Nehmen Sie .png, .jpg oder .bmp</translation>
    </message>
    <message>
        <source>Use a video in .mkv, .mp4 or .avi, and copy it again if it was cut off</source>
        <translation>Nehmen Sie ein Video in .mkv, .mp4 oder .avi, und kopieren Sie es noch einmal, falls es abgeschnitten wurde</translation>
    </message>
    <message>
        <source>Convert it to .mkv</source>
        <translation>Wandeln Sie es in .mkv um</translation>
    </message>
    <message>
        <source>Copy the video again, or record it anew</source>
        <translation>Kopieren Sie das Video noch einmal, oder nehmen Sie es neu auf</translation>
    </message>
    <message>
        <source>Check that the camera is connected, that no other program uses it, and its number</source>
        <translation>Prüfen Sie, ob die Kamera angeschlossen ist, ob ein anderes Programm sie benutzt, und ihre Nummer</translation>
    </message>
    <message>
        <source>Write device: and its number, as device:0</source>
        <translation>Schreiben Sie device: und die Nummer, wie device:0</translation>
    </message>
    <message>
        <source>Both views are of one size; give two files otherwise</source>
        <translation>Beide Ansichten sind gleich groß; geben Sie sonst zwei Dateien</translation>
    </message>
    <message>
        <source>Both views of a stereo video have one size</source>
        <translation>Beide Ansichten eines Stereovideos sind gleich groß</translation>
    </message>
    <message>
        <source>Record both views at one rate</source>
        <translation>Nehmen Sie beide Ansichten mit einer Rate auf</translation>
    </message>
    <message>
        <source>Record both views at once, from one trigger</source>
        <translation>Nehmen Sie beide Ansichten zugleich auf, von einem Auslöser</translation>
    </message>
    <message>
        <source>Give pictures of one size</source>
        <translation>Geben Sie Bilder einer Größe</translation>
    </message>
    <message>
        <source>Crop within the picture</source>
        <translation>Schneiden Sie innerhalb des Bildes zu</translation>
    </message>
    <message>
        <source>Use rtsp, rtsps, rtp, srt, udp, http or https</source>
        <translation>Nehmen Sie rtsp, rtsps, rtp, srt, udp, http oder https</translation>
    </message>
    <message>
        <source>Use .mkv: a recording that is cut off can still be read there</source>
        <translation>Nehmen Sie .mkv: Eine abgebrochene Aufnahme kann dort noch gelesen werden</translation>
    </message>
    <message>
        <source>Name them so that only the side differs, as left-001.png and right-001.png, or put them into folders left and right</source>
        <translation>Nennen Sie sie so, dass nur die Seite verschieden ist, wie left-001.png und right-001.png, oder legen Sie sie in Ordner left und right</translation>
    </message>
    <message>
        <source>Give the picture of each camera</source>
        <translation>Geben Sie das Bild jeder Kamera</translation>
    </message>
    <message>
        <source>Give the picture of each camera; one of them may be lost</source>
        <translation>Geben Sie das Bild jeder Kamera; eines davon mag verloren sein</translation>
    </message>
    <message>
        <source>Give two pictures of one moment of one scope</source>
        <translation>Geben Sie zwei Bilder eines Augenblicks von einem Laparoskop</translation>
    </message>
    <message>
        <source>Give both views of one moment</source>
        <translation>Geben Sie beide Ansichten eines Augenblicks</translation>
    </message>
    <message>
        <source>Give the mask of this left picture</source>
        <translation>Geben Sie die Maske dieses linken Bildes</translation>
    </message>
    <message>
        <source>Draw the mask on the left image</source>
        <translation>Zeichnen Sie die Maske auf dem linken Bild</translation>
    </message>
    <message>
        <source>Swap the two images, or the calibration&apos;s cameras</source>
        <translation>Tauschen Sie die beiden Bilder oder die Kameras der Kalibrierung</translation>
    </message>
    <message>
        <source>Check the light and the connection, or take another frame</source>
        <translation>Prüfen Sie Licht und Verbindung, oder nehmen Sie ein anderes Bild</translation>
    </message>
    <message>
        <source>Check the left camera&apos;s connection, or take another frame</source>
        <translation>Prüfen Sie die Verbindung der linken Kamera, oder nehmen Sie ein anderes Bild</translation>
    </message>
    <message>
        <source>Check the right camera&apos;s connection, or take another frame</source>
        <translation>Prüfen Sie die Verbindung der rechten Kamera, oder nehmen Sie ein anderes Bild</translation>
    </message>
    <message>
        <source>Check that both images show the same tissue sharply and lit, that a mask lies on it, and that the calibration is of this laparoscope</source>
        <translation>Prüfen Sie, ob beide Bilder dasselbe Gewebe scharf und hell zeigen, ob eine Maske darauf liegt, und ob die Kalibrierung von diesem Laparoskop ist</translation>
    </message>
    <message>
        <source>Draw them where the liver is reconstructed, or reconstruct densely</source>
        <translation>Zeichnen Sie sie, wo die Leber rekonstruiert ist, oder rekonstruieren Sie dicht</translation>
    </message>
    <message>
        <source>Load the pair that they were clicked on, or click them again on this one</source>
        <translation>Laden Sie das Paar, auf dem sie geklickt wurden, oder klicken Sie sie auf diesem neu</translation>
    </message>
    <message>
        <source>Use the calibration of this laparoscope at this image size</source>
        <translation>Nehmen Sie die Kalibrierung dieses Laparoskops bei dieser Bildgröße</translation>
    </message>
    <message>
        <source>Use the calibration of this scope at this resolution</source>
        <translation>Nehmen Sie die Kalibrierung dieses Laparoskops bei dieser Auflösung</translation>
    </message>
    <message>
        <source>Load this laparoscope&apos;s calibration, or calibrate it again</source>
        <translation>Laden Sie die Kalibrierung dieses Laparoskops, oder kalibrieren Sie es neu</translation>
    </message>
    <message>
        <source>Write the calibration anew or calibrate again</source>
        <translation>Schreiben Sie die Kalibrierung neu, oder kalibrieren Sie noch einmal</translation>
    </message>
    <message>
        <source>Save the calibration as YAML (.yml)</source>
        <translation>Speichern Sie die Kalibrierung als YAML (.yml)</translation>
    </message>
    <message>
        <source>Left and right are swapped, or R and T map right to left: x_right = R x_left + T</source>
        <translation>Links und rechts sind vertauscht, oder R und T führen von rechts nach links: x_right = R x_left + T</translation>
    </message>
    <message>
        <source>Check the unit</source>
        <translation>Prüfen Sie die Einheit</translation>
    </message>
    <message>
        <source>Give .vtp, legacy .vtk, .stl, .obj or .ply</source>
        <translation>Geben Sie .vtp, altes .vtk, .stl, .obj oder .ply</translation>
    </message>
    <message>
        <source>was corrected by hand and would be replaced</source>
        <translation>wurde von Hand berichtigt und würde ersetzt</translation>
    </message>
    <message>
        <source>is no lesion&apos;s</source>
        <translation>hat keine Läsion</translation>
    </message>
    <message>
        <source>belongs to a lesion without a point</source>
        <translation>gehört zu einer Läsion ohne Punkt</translation>
    </message>
    <message>
        <source>Write one number for each lesion, in mm; 0 where it is not known</source>
        <translation>Schreiben Sie für jede Läsion eine Zahl, in mm; 0, wo sie nicht bekannt ist</translation>
    </message>
    <message>
        <source>Write 3 to 250 mm, or 0 where it is not known</source>
        <translation>Schreiben Sie 3 bis 250 mm, oder 0, wo er nicht bekannt ist</translation>
    </message>
    <message>
        <source>Write the point of this lesion, too, or 0</source>
        <translation>Schreiben Sie auch den Punkt dieser Läsion, oder 0</translation>
    </message>
    <message>
        <source>is named as DICOM, but is none</source>
        <translation>heißt wie DICOM, ist aber keines</translation>
    </message>
    <message>
        <source>is %1, not between %2 and %3</source>
        <translation>ist %1, nicht zwischen %2 und %3</translation>
    </message>
    <message>
        <source>is not followed in the last frame</source>
        <translation>wird im letzten Bild nicht verfolgt</translation>
    </message>
    <message>
        <source>is not followed in pictures</source>
        <translation>wird nicht in Bildern verfolgt</translation>
    </message>
    <message>
        <source>would be outside of the picture</source>
        <translation>läge außerhalb des Bildes</translation>
    </message>
    <message>
        <source>is behind the camera</source>
        <translation>liegt hinter der Kamera</translation>
    </message>
    <message>
        <source>is more than 40 mm from where it is drawn</source>
        <translation>ist mehr als 40 mm von dort entfernt, wo sie gezeichnet ist</translation>
    </message>
    <message>
        <source>takes no shape that would meet it</source>
        <translation>nimmt keine Form an, die dazu passt</translation>
    </message>
    <message>
        <source>Wait until it is followed again</source>
        <translation>Warten Sie, bis es wieder verfolgt wird</translation>
    </message>
    <message>
        <source>Track a stereo video</source>
        <translation>Verfolgen Sie ein Stereovideo</translation>
    </message>
    <message>
        <source>Drag to where the picture shows it</source>
        <translation>Ziehen Sie dorthin, wo das Bild es zeigt</translation>
    </message>
    <message>
        <source>Correct what the picture shows</source>
        <translation>Korrigieren Sie, was das Bild zeigt</translation>
    </message>
    <message>
        <source>Drag less far, or register again</source>
        <translation>Ziehen Sie weniger weit, oder registrieren Sie neu</translation>
    </message>
    <message>
        <source>has seeds already</source>
        <translation>hat schon Saatpunkte</translation>
    </message>
    <message>
        <source>shows nothing as large, compact and even as a liver</source>
        <translation>zeigt nichts, das so groß, kompakt und gleichmäßig ist wie eine Leber</translation>
    </message>
    <message>
        <source>Click the liver yourself</source>
        <translation>Klicken Sie die Leber selbst an</translation>
    </message>
    <message>
        <source>Delete them first, or add more by hand</source>
        <translation>Löschen Sie sie zuerst, oder fügen Sie von Hand weitere hinzu</translation>
    </message>
    <message>
        <source>is used by another program</source>
        <translation>wird von einem anderen Programm benutzt</translation>
    </message>
    <message>
        <source>cannot be listened at (%1)</source>
        <translation>kann nicht abgehört werden (%1)</translation>
    </message>
    <message>
        <source>is no numeric address</source>
        <translation>ist keine Adresse in Zahlen</translation>
    </message>
    <message>
        <source>is no number from 0 to 65535</source>
        <translation>ist keine Zahl von 0 bis 65535</translation>
    </message>
    <message>
        <source>Close that program, or give another port</source>
        <translation>Schließen Sie jenes Programm, oder geben Sie einen anderen Port an</translation>
    </message>
    <message>
        <source>Give an address of this computer, and a port above 1023</source>
        <translation>Geben Sie eine Adresse dieses Rechners und einen Port über 1023 an</translation>
    </message>
    <message>
        <source>Give ADDRESS:PORT with a numeric address, as 127.0.0.1:18944</source>
        <translation>Geben Sie ADRESSE:PORT mit einer Adresse in Zahlen an, etwa 127.0.0.1:18944</translation>
    </message>
    <message>
        <source>was corrected by hand on the voxels of another CT</source>
        <translation>wurde auf den Voxeln eines anderen CTs von Hand korrigiert</translation>
    </message>
    <message>
        <source>was made of another CT, other seeds or other labels</source>
        <translation>stammt von einem anderen CT, anderen Saatpunkten oder anderen Labels</translation>
    </message>
    <message>
        <source>Lock it (--lock), keep what was corrected (--keep-edited), or allow it (--replace-edited)</source>
        <translation>Sperren Sie es (--lock), behalten Sie das Korrigierte (--keep-edited) oder erlauben Sie es (--replace-edited)</translation>
    </message>
    <message>
        <source>Open this CT as a new case, or allow it (--replace-edited)</source>
        <translation>Öffnen Sie dieses CT als neuen Fall oder erlauben Sie es (--replace-edited)</translation>
    </message>
    <message>
        <source>Segment again</source>
        <translation>Segmentieren Sie erneut</translation>
    </message>
    <message>
        <source>no server of OpenIGTLink answers</source>
        <translation>kein OpenIGTLink-Server antwortet</translation>
    </message>
    <message>
        <source>sends what is no message of OpenIGTLink</source>
        <translation>sendet, was keine Nachricht von OpenIGTLink ist</translation>
    </message>
    <message>
        <source>send no pictures of 8 bits that can be used</source>
        <translation>senden keine brauchbaren Bilder mit 8 Bit</translation>
    </message>
    <message>
        <source>send no pairs within %1 ms of each other</source>
        <translation>senden keine Paare innerhalb von %1 ms</translation>
    </message>
    <message>
        <source>has closed before a picture came</source>
        <translation>hat geschlossen, bevor ein Bild kam</translation>
    </message>
    <message>
        <source>is empty or longer than 20 letters</source>
        <translation>ist leer oder länger als 20 Buchstaben</translation>
    </message>
    <message>
        <source>is the same for both views</source>
        <translation>ist für beide Ansichten derselbe</translation>
    </message>
    <message>
        <source>Start it, and check its address and port</source>
        <translation>Starten Sie ihn, und prüfen Sie Adresse und Port</translation>
    </message>
    <message>
        <source>Start the server again</source>
        <translation>Starten Sie den Server erneut</translation>
    </message>
    <message>
        <source>Check that this is the port of PLUS, or of another server of OpenIGTLink</source>
        <translation>Prüfen Sie, ob dies der Port von PLUS oder einem anderen OpenIGTLink-Server ist</translation>
    </message>
    <message>
        <source>Check the names of the two devices, and that they are on</source>
        <translation>Prüfen Sie die Namen der beiden Geräte und ob sie eingeschaltet sind</translation>
    </message>
    <message>
        <source>Give HOST:PORT/LEFT,RIGHT with the names of the two devices</source>
        <translation>Geben Sie ADRESSE:PORT/LINKS,RECHTS mit den Namen der beiden Geräte an</translation>
    </message>
    <message>
        <source>Give HOST:PORT/NAME with the name of the tool&apos;s transform</source>
        <translation>Geben Sie ADRESSE:PORT/NAME mit dem Namen der Transformation des Werkzeugs an</translation>
    </message>
    <message>
        <source>is encrypted</source>
        <translation>ist verschlüsselt</translation>
    </message>
    <message>
        <source>is one of several parts of an archive</source>
        <translation>ist einer von mehreren Teilen eines Archivs</translation>
    </message>
    <message>
        <source>is packed in a way that is not read here</source>
        <translation>ist auf eine Weise gepackt, die hier nicht gelesen wird</translation>
    </message>
    <message>
        <source>is named as a DICOM directory, but is none or is damaged</source>
        <translation>heißt wie ein DICOM-Verzeichnis, ist aber keines oder ist beschädigt</translation>
    </message>
    <message>
        <source>names files that are all missing, %1 first</source>
        <translation>nennt Dateien, die alle fehlen, zuerst %1</translation>
    </message>
    <message>
        <source>Unpack it with its password and name the folder</source>
        <translation>Entpacken Sie es mit seinem Passwort und nennen Sie den Ordner</translation>
    </message>
    <message>
        <source>Unpack it yourself and name the folder</source>
        <translation>Entpacken Sie es selbst und nennen Sie den Ordner</translation>
    </message>
    <message>
        <source>Unpack it yourself and name the file of labels in it</source>
        <translation>Entpacken Sie es selbst und nennen Sie die Datei mit den Labels darin</translation>
    </message>
    <message>
        <source>Give labels as .seg.nrrd, .nii, .nii.gz, .nrrd, .nhdr, .mha, .mhd, .vti or a DICOM segmentation</source>
        <translation>Geben Sie die Labels als .seg.nrrd, .nii, .nii.gz, .nrrd, .nhdr, .mha, .mhd, .vti oder als DICOM-Segmentierung an</translation>
    </message>
    <message>
        <source>Unpack them yourself and name the folder</source>
        <translation>Entpacken Sie sie selbst und nennen Sie den Ordner</translation>
    </message>
    <message>
        <source>Copy the whole medium, not its DICOMDIR alone</source>
        <translation>Kopieren Sie den ganzen Datenträger, nicht nur seine DICOMDIR</translation>
    </message>
    <message>
        <source>Give a folder of DICOM slices, .zip, .tar.gz, .nii, .nii.gz, .nrrd, .nhdr, .mha, .mhd or .vti</source>
        <translation>Geben Sie einen Ordner mit DICOM-Schichten, .zip, .tar.gz, .nii, .nii.gz, .nrrd, .nhdr, .mha, .mhd oder .vti an</translation>
    </message>
    <message>
        <source>is no ONNX network that can be run here (%1)</source>
        <translation>ist kein ONNX-Netz, das hier laufen kann (%1)</translation>
    </message>
    <message>
        <source>broke the program that runs networks: it is damaged or needs too much memory</source>
        <translation>hat das Programm abstürzen lassen, das Netze rechnet: es ist beschädigt oder braucht zu viel Speicher</translation>
    </message>
    <message>
        <source>took the network more than 120 s for one answer</source>
        <translation>das Netz brauchte mehr als 120 s für eine Antwort</translation>
    </message>
    <message>
        <source>cannot be computed for an input of %1 (%2)</source>
        <translation>lassen sich für eine Eingabe von %1 nicht rechnen (%2)</translation>
    </message>
    <message>
        <source>holds what is no number</source>
        <translation>enthält etwas, das keine Zahl ist</translation>
    </message>
    <message>
        <source>is %1, neither slices nor a block</source>
        <translation>ist %1, weder Schichten noch ein Block</translation>
    </message>
    <message>
        <source>is %1, not one CT at a time</source>
        <translation>ist %1, nicht ein CT auf einmal</translation>
    </message>
    <message>
        <source>is %1 where the network&apos;s input is %2</source>
        <translation>ist %1, die Eingabe des Netzes aber %2</translation>
    </message>
    <message>
        <source>is missing where the network leaves its input&apos;s size open</source>
        <translation>fehlt, obwohl das Netz die Größe seiner Eingabe offenlässt</translation>
    </message>
    <message>
        <source>is no field of a network&apos;s sheet</source>
        <translation>ist kein Feld im Blatt eines Netzes</translation>
    </message>
    <message>
        <source>names no label</source>
        <translation>nennt kein Label</translation>
    </message>
    <message>
        <source>is missing where no channel is the background</source>
        <translation>fehlt, obwohl kein Kanal der Hintergrund ist</translation>
    </message>
    <message>
        <source>is not two numbers, the lower first</source>
        <translation>sind nicht zwei Zahlen, die kleinere zuerst</translation>
    </message>
    <message>
        <source>Export it again as ONNX (opset 11), with its weights inside the file</source>
        <translation>Exportieren Sie es noch einmal als ONNX (opset 11), mit den Gewichten in der Datei</translation>
    </message>
    <message>
        <source>Copy it again, or use smaller tiles (&quot;tile&quot;)</source>
        <translation>Kopieren Sie es noch einmal, oder nehmen Sie kleinere Kacheln (&quot;tile&quot;)</translation>
    </message>
    <message>
        <source>Use smaller tiles (&quot;tile&quot;), or a smaller network</source>
        <translation>Nehmen Sie kleinere Kacheln (&quot;tile&quot;) oder ein kleineres Netz</translation>
    </message>
    <message>
        <source>Write the size of the network&apos;s input</source>
        <translation>Schreiben Sie die Größe der Eingabe des Netzes</translation>
    </message>
    <message>
        <source>Write the network&apos;s sheet beside it (see the manual)</source>
        <translation>Schreiben Sie das Blatt des Netzes daneben (siehe Handbuch)</translation>
    </message>
    <message>
        <source>Name one label a channel in &quot;channels&quot;, and export a network whose output has the size of its input</source>
        <translation>Nennen Sie in &quot;channels&quot; ein Label für jeden Kanal, und exportieren Sie ein Netz, dessen Ausgabe so groß ist wie seine Eingabe</translation>
    </message>
    <message>
        <source>Check the window (&quot;window_hu&quot;) and the network&apos;s weights</source>
        <translation>Prüfen Sie das Fenster (&quot;window_hu&quot;) und die Gewichte des Netzes</translation>
    </message>
    <message>
        <source>Give the size of the network&apos;s input as &quot;tile&quot;, or export a network of other layers</source>
        <translation>Geben Sie die Größe der Eingabe des Netzes als &quot;tile&quot; an, oder exportieren Sie ein Netz mit anderen Schichten</translation>
    </message>
    <message>
        <source>holds a fraction of a voxel</source>
        <translation>enthält einen Bruchteil eines Voxels</translation>
    </message>
    <message>
        <source>Write whole numbers</source>
        <translation>Schreiben Sie ganze Zahlen</translation>
    </message>
    <message>
        <source>names no channel</source>
        <translation>nennt keinen Kanal</translation>
    </message>
    <message>
        <source>is not two numbers</source>
        <translation>sind nicht zwei Zahlen</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;</source>
        <translation>ist „%1“</translation>
    </message>
    <message>
        <source>names &quot;%1&quot;, which is no channel</source>
        <translation>nennt „%1“, was kein Kanal ist</translation>
    </message>
    <message>
        <source>is missing where all channels are liver, or none is</source>
        <translation>fehlt, wo alle Kanäle Leber sind oder keiner</translation>
    </message>
    <message>
        <source>is not one number for each colour</source>
        <translation>ist nicht eine Zahl je Farbe</translation>
    </message>
    <message>
        <source>holds a fraction of a pixel</source>
        <translation>enthält Bruchteile eines Pixels</translation>
    </message>
    <message>
        <source>is %1, not 1 x %2 x rows x columns</source>
        <translation>ist %1, nicht 1 x %2 x Zeilen x Spalten</translation>
    </message>
    <message>
        <source>Write one name for each output channel, as [&quot;liver&quot;, &quot;tool&quot;]</source>
        <translation>Schreiben Sie je Ausgangskanal einen Namen, etwa [&quot;liver&quot;, &quot;tool&quot;]</translation>
    </message>
    <message>
        <source>List the channels that may be liver, as [&quot;liver&quot;]</source>
        <translation>Nennen Sie die Kanäle, die Leber sein können, etwa [&quot;liver&quot;]</translation>
    </message>
    <message>
        <source>Write names that stand in &quot;channels&quot;</source>
        <translation>Schreiben Sie Namen, die in &quot;channels&quot; stehen</translation>
    </message>
    <message>
        <source>Say what a score must exceed, as 0.5</source>
        <translation>Sagen Sie, was ein Wert übersteigen muss, etwa 0.5</translation>
    </message>
    <message>
        <source>Write &quot;rgb&quot;, &quot;bgr&quot; or &quot;grey&quot;</source>
        <translation>Schreiben Sie &quot;rgb&quot;, &quot;bgr&quot; oder &quot;grey&quot;</translation>
    </message>
    <message>
        <source>Write mean and sd of colours from 0 to 1, or neither</source>
        <translation>Schreiben Sie mean und sd von Farben von 0 bis 1, oder keines von beiden</translation>
    </message>
    <message>
        <source>Write [rows, columns]</source>
        <translation>Schreiben Sie [Zeilen, Spalten]</translation>
    </message>
    <message>
        <source>Export a network of one picture, and say its colours (&quot;colours&quot;)</source>
        <translation>Exportieren Sie ein Netz für ein Bild und nennen Sie seine Farben (&quot;colours&quot;)</translation>
    </message>
    <message>
        <source>is not CT, and only a CT says what grey a liver has before it is clicked</source>
        <translation>ist kein CT, und nur ein CT sagt, welchen Grauwert eine Leber hat, bevor sie angeklickt ist</translation>
    </message>
    <message>
        <source>is not known: nothing tells what its grey values mean</source>
        <translation>ist nicht bekannt: nichts sagt, was die Grauwerte bedeuten</translation>
    </message>
    <message>
        <source>is not brighter than the liver in this MRI</source>
        <translation>ist in dieser MRT nicht heller als die Leber</translation>
    </message>
    <message>
        <source>hardly stands out from fat and air in this MRI</source>
        <translation>hebt sich in dieser MRT kaum von Fett und Luft ab</translation>
    </message>
    <message>
        <source>shows much that is far brighter than the liver</source>
        <translation>zeigt vieles, das viel heller ist als die Leber</translation>
    </message>
    <message>
        <source>shows no body</source>
        <translation>zeigt keinen Körper</translation>
    </message>
    <message>
        <source>is told by its DICOM files, and is another one</source>
        <translation>steht in den DICOM-Dateien und ist eine andere</translation>
    </message>
    <message>
        <source>Open a T1 series with fat suppression in the venous phase, or import labels instead</source>
        <translation>Öffnen Sie eine fettunterdrückte T1-Serie in der venösen Phase, oder importieren Sie stattdessen Labels</translation>
    </message>
    <message>
        <source>Import it again and say whether it is CT or MRI, or import labels instead</source>
        <translation>Importieren Sie es noch einmal und sagen Sie, ob es CT oder MRT ist, oder importieren Sie stattdessen Labels</translation>
    </message>
    <message>
        <source>Import a CT or MRI first</source>
        <translation>Importieren Sie zuerst ein CT oder eine MRT</translation>
    </message>
    <message>
        <source>Leave the choice out</source>
        <translation>Lassen Sie die Angabe weg</translation>
    </message>
    <message>
        <source>lies there already and is none of the surfaces that are written</source>
        <translation>liegt dort schon und ist keine der Oberflächen, die geschrieben werden</translation>
    </message>
    <message>
        <source>Name a folder; it is made if there is none</source>
        <translation>Nennen Sie einen Ordner; er wird angelegt, wenn es ihn nicht gibt</translation>
    </message>
    <message>
        <source>Choose an empty folder</source>
        <translation>Wählen Sie einen leeren Ordner</translation>
    </message>
    <message>
        <source>Use stl, ply, obj or vtp</source>
        <translation>Möglich sind stl, ply, obj und vtp</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is none that surfaces are written in</source>
        <translation>„%1“ ist keines, in dem Oberflächen geschrieben werden</translation>
    </message>
    <message>
        <source>is missing, or no vector a vertex</source>
        <translation>fehlt oder hat nicht je Eckpunkt einen Vektor</translation>
    </message>
    <message>
        <source>is no share from 0 to 1 of each vertex</source>
        <translation>hat nicht je Eckpunkt einen Anteil von 0 bis 1</translation>
    </message>
    <message>
        <source>do not belong to this atlas.json</source>
        <translation>gehören nicht zu dieser atlas.json</translation>
    </message>
    <message>
        <source>holds something else than an atlas</source>
        <translation>enthält etwas anderes als einen Atlas</translation>
    </message>
    <message>
        <source>are none in this folder</source>
        <translation>gibt es in diesem Ordner nicht</translation>
    </message>
    <message>
        <source>has two of the name %1</source>
        <translation>hat zwei mit dem Namen %1</translation>
    </message>
    <message>
        <source>has no surface</source>
        <translation>hat keine Oberfläche</translation>
    </message>
    <message>
        <source>has no fine surface</source>
        <translation>hat keine feine Oberfläche</translation>
    </message>
    <message>
        <source>holds %1 ml</source>
        <translation>enthält %1 ml</translation>
    </message>
    <message>
        <source>is mirrored: its mirror image looks like a liver and it does not</source>
        <translation>ist gespiegelt: ihr Spiegelbild sieht wie eine Leber aus, sie selbst nicht</translation>
    </message>
    <message>
        <source>is missing, or has several columns</source>
        <translation>fehlt oder hat mehrere Spalten</translation>
    </message>
    <message>
        <source>are not as many as the trees</source>
        <translation>sind nicht so viele wie die Bäume</translation>
    </message>
    <message>
        <source>hold a number that is not finite</source>
        <translation>enthalten eine Zahl, die nicht endlich ist</translation>
    </message>
    <message>
        <source>hold what is no label or no node</source>
        <translation>enthalten etwas, das keine Bezeichnung oder kein Knoten ist</translation>
    </message>
    <message>
        <source>names a tree that is not there</source>
        <translation>nennt einen Baum, den es nicht gibt</translation>
    </message>
    <message>
        <source>hold a node that is not there</source>
        <translation>enthalten einen Knoten, den es nicht gibt</translation>
    </message>
    <message>
        <source>a beam does not join two nodes of one tree</source>
        <translation>ein Balken verbindet nicht zwei Knoten eines Baums</translation>
    </message>
    <message>
        <source>landmarks are read in LPS millimetres only</source>
        <translation>Landmarken werden nur in LPS-Millimetern gelesen</translation>
    </message>
    <message>
        <source>holds no landmark</source>
        <translation>enthält keine Landmarke</translation>
    </message>
    <message>
        <source>is no covariance</source>
        <translation>ist keine Kovarianz</translation>
    </message>
    <message>
        <source>is not %1 finite numbers a node</source>
        <translation>hat nicht %1 endliche Zahlen je Knoten</translation>
    </message>
    <message>
        <source>is not 3 lengths, or those of the nodes are none</source>
        <translation>sind nicht 3 Längen, oder die der Knoten sind keine</translation>
    </message>
    <message>
        <source>is negative</source>
        <translation>ist negativ</translation>
    </message>
    <message>
        <source>is no probability</source>
        <translation>ist keine Wahrscheinlichkeit</translation>
    </message>
    <message>
        <source>there is no model that they belong to</source>
        <translation>es gibt kein Modell, zu dem sie gehören</translation>
    </message>
    <message>
        <source>there is no model that it belongs to</source>
        <translation>es gibt kein Modell, zu dem sie gehört</translation>
    </message>
    <message>
        <source>does not belong to this case&apos;s model</source>
        <translation>gehört nicht zum Modell dieses Falls</translation>
    </message>
    <message>
        <source>names node %1 of %2</source>
        <translation>nennt Knoten %1 von %2</translation>
    </message>
    <message>
        <source>names node %1</source>
        <translation>nennt Knoten %1</translation>
    </message>
    <message>
        <source>names triangle %1</source>
        <translation>nennt Dreieck %1</translation>
    </message>
    <message>
        <source>names vertex %1 of %2</source>
        <translation>nennt Eckpunkt %1 von %2</translation>
    </message>
    <message>
        <source>holds nothing of the mesh</source>
        <translation>enthält nichts vom Netz</translation>
    </message>
    <message>
        <source>holds node %1, which is held already</source>
        <translation>enthält Knoten %1, der schon gehalten wird</translation>
    </message>
    <message>
        <source>is not a node of the mesh or its position not finite</source>
        <translation>ist kein Knoten des Netzes, oder seine Lage ist nicht endlich</translation>
    </message>
    <message>
        <source>is not a node of the mesh</source>
        <translation>ist kein Knoten des Netzes</translation>
    </message>
    <message>
        <source>fix every node of the mesh</source>
        <translation>halten jeden Knoten des Netzes fest</translation>
    </message>
    <message>
        <source>is %1, out of range</source>
        <translation>ist %1, außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>belongs to no tetrahedron</source>
        <translation>gehört zu keinem Tetraeder</translation>
    </message>
    <message>
        <source>are in %1 pieces that share no node</source>
        <translation>liegen in %1 Stücken, die keinen Knoten gemeinsam haben</translation>
    </message>
    <message>
        <source>holds none</source>
        <translation>enthält keine</translation>
    </message>
    <message>
        <source>has %1 values for %2 tetrahedra</source>
        <translation>hat %1 Werte für %2 Tetraeder</translation>
    </message>
    <message>
        <source>has %1 values for %2 nodes</source>
        <translation>hat %1 Werte für %2 Knoten</translation>
    </message>
    <message>
        <source>must be one positive number a tetrahedron</source>
        <translation>muss je Tetraeder eine positive Zahl sein</translation>
    </message>
    <message>
        <source>is not finite</source>
        <translation>ist nicht endlich</translation>
    </message>
    <message>
        <source>is not one of the %1 of the boundary surface</source>
        <translation>ist keines der %1 der Oberfläche</translation>
    </message>
    <message>
        <source>is free to move</source>
        <translation>ist frei beweglich</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, which is not a posture</source>
        <translation>ist „%1“, das ist keine Lage</translation>
    </message>
    <message>
        <source>is not known</source>
        <translation>ist nicht bekannt</translation>
    </message>
    <message>
        <source>is not positive</source>
        <translation>ist nicht positiv</translation>
    </message>
    <message>
        <source>is missing: nothing holds the model in a static solve</source>
        <translation>fehlt: nichts hält das Modell im statischen Gleichgewicht</translation>
    </message>
    <message>
        <source>hold coordinates that are not finite</source>
        <translation>enthalten Koordinaten, die nicht endlich sind</translation>
    </message>
    <message>
        <source>there are none</source>
        <translation>es gibt keine</translation>
    </message>
    <message>
        <source>a coordinate is not a finite number</source>
        <translation>eine Koordinate ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>a tetrahedral mesh is not written as &quot;%1&quot;</source>
        <translation>ein Tetraedernetz wird nicht als „%1“ geschrieben</translation>
    </message>
    <message>
        <source>a surface is not written as &quot;%1&quot;</source>
        <translation>eine Oberfläche wird nicht als „%1“ geschrieben</translation>
    </message>
    <message>
        <source>does not hold three finite numbers</source>
        <translation>enthält nicht drei endliche Zahlen</translation>
    </message>
    <message>
        <source>holds more than three numbers</source>
        <translation>enthält mehr als drei Zahlen</translation>
    </message>
    <message>
        <source>holds no nodes</source>
        <translation>enthält keine Knoten</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no node of a mesh of %2</source>
        <translation>„%1“ ist kein Knoten eines Netzes mit %2</translation>
    </message>
    <message>
        <source>is a tetrahedron without four points</source>
        <translation>ist ein Tetraeder ohne vier Punkte</translation>
    </message>
    <message>
        <source>is of VTK type %1, neither a linear tetrahedron nor a polygon</source>
        <translation>ist vom VTK-Typ %1, weder ein lineares Tetraeder noch ein Vieleck</translation>
    </message>
    <message>
        <source>is not a legacy VTK file (no &quot;# vtk DataFile Version&quot;)</source>
        <translation>ist keine alte VTK-Datei (ohne „# vtk DataFile Version“)</translation>
    </message>
    <message>
        <source>is not a gmsh mesh (no $MeshFormat)</source>
        <translation>ist kein Netz von gmsh (ohne $MeshFormat)</translation>
    </message>
    <message>
        <source>is neither a whole binary STL nor an ascii one</source>
        <translation>ist weder eine ganze binäre STL-Datei noch eine aus Text</translation>
    </message>
    <message>
        <source>has no property &quot;%1&quot;</source>
        <translation>hat die Eigenschaft „%1“ nicht</translation>
    </message>
    <message>
        <source>holds &quot;%1&quot;, which is no number</source>
        <translation>enthält „%1“, das ist keine Zahl</translation>
    </message>
    <message>
        <source>has rows but no properties</source>
        <translation>hat Zeilen, aber keine Eigenschaften</translation>
    </message>
    <message>
        <source>the file ends before it, and the header announces %1</source>
        <translation>die Datei endet davor, und der Kopf kündigt %1 an</translation>
    </message>
    <message>
        <source>has a list longer than the file</source>
        <translation>hat eine Liste, die länger ist als die Datei</translation>
    </message>
    <message>
        <source>holds more than a mesh does, with the rows before it</source>
        <translation>enthält mit den Zeilen davor mehr als ein Netz</translation>
    </message>
    <message>
        <source>has the same nodes as tetrahedron %1</source>
        <translation>hat dieselben Knoten wie Tetraeder %1</translation>
    </message>
    <message>
        <source>there is no liver in them</source>
        <translation>darin ist keine Leber</translation>
    </message>
    <message>
        <source>is in several large pieces (%1 ml and %2 ml)</source>
        <translation>besteht aus mehreren großen Stücken (%1 ml und %2 ml)</translation>
    </message>
    <message>
        <source>has several large pieces (%1 and %2)</source>
        <translation>hat mehrere große Stücke (%1 und %2)</translation>
    </message>
    <message>
        <source>are empty, and a DICOM segmentation holds at least one</source>
        <translation>sind leer, und eine DICOM-Segmentierung enthält mindestens eine</translation>
    </message>
    <message>
        <source>are empty</source>
        <translation>sind leer</translation>
    </message>
    <message>
        <source>is not a finite point</source>
        <translation>ist kein endlicher Punkt</translation>
    </message>
    <message>
        <source>%1 would give more than 200000 vertices</source>
        <translation>%1 ergäbe mehr als 200000 Eckpunkte</translation>
    </message>
    <message>
        <source>there are more than 240</source>
        <translation>es gibt mehr als 240</translation>
    </message>
    <message>
        <source>all are degenerate</source>
        <translation>alle sind entartet</translation>
    </message>
    <message>
        <source>has holes or edges with more than two triangles</source>
        <translation>hat Löcher oder Kanten mit mehr als zwei Dreiecken</translation>
    </message>
    <message>
        <source>encloses no volume</source>
        <translation>umschließt kein Volumen</translation>
    </message>
    <message>
        <source>there is no such list</source>
        <translation>es gibt keine solche Liste</translation>
    </message>
    <message>
        <source>edits are read in LPS millimetres only</source>
        <translation>Änderungen werden nur in LPS-Millimetern gelesen</translation>
    </message>
    <message>
        <source>lies %1 mm from the vessel</source>
        <translation>liegt %1 mm vom Gefäß entfernt</translation>
    </message>
    <message>
        <source>could not be put into this format</source>
        <translation>ließ sich nicht in dieses Format bringen</translation>
    </message>
    <message>
        <source>measures %1 m across when read in %2, and a liver measures 0.08 to 0.6 m</source>
        <translation>misst %1 m, in %2 gelesen, und eine Leber misst 0,08 bis 0,6 m</translation>
    </message>
    <message>
        <source>Build the atlas again, or take another one</source>
        <translation>Bauen Sie den Atlas noch einmal, oder nehmen Sie einen anderen</translation>
    </message>
    <message>
        <source>Build the atlas again with this program</source>
        <translation>Bauen Sie den Atlas mit diesem Programm noch einmal</translation>
    </message>
    <message>
        <source>Copy both files of one atlas</source>
        <translation>Kopieren Sie beide Dateien eines Atlas</translation>
    </message>
    <message>
        <source>Name a new folder</source>
        <translation>Nennen Sie einen neuen Ordner</translation>
    </message>
    <message>
        <source>Name a case or a folder of cases</source>
        <translation>Nennen Sie einen Fall oder einen Ordner mit Fällen</translation>
    </message>
    <message>
        <source>Give %1 livers at least</source>
        <translation>Geben Sie mindestens %1 Lebern an</translation>
    </message>
    <message>
        <source>Give each liver once</source>
        <translation>Geben Sie jede Leber einmal an</translation>
    </message>
    <message>
        <source>Build the model of the liver first</source>
        <translation>Bauen Sie zuerst das Modell der Leber</translation>
    </message>
    <message>
        <source>Build the model from labels or surfaces</source>
        <translation>Bauen Sie das Modell aus Bezeichnungen oder Oberflächen</translation>
    </message>
    <message>
        <source>Give the closed surface of the liver</source>
        <translation>Geben Sie die geschlossene Oberfläche der Leber an</translation>
    </message>
    <message>
        <source>Give the whole liver&apos;s surface</source>
        <translation>Geben Sie die Oberfläche der ganzen Leber an</translation>
    </message>
    <message>
        <source>Mend left and right in the file&apos;s header, or leave this liver out</source>
        <translation>Berichtigen Sie links und rechts im Kopf der Datei, oder lassen Sie diese Leber weg</translation>
    </message>
    <message>
        <source>Write it as a list of [x, y, z] in millimetres (LPS)</source>
        <translation>Schreiben Sie es als Liste von [x, y, z] in Millimetern (LPS)</translation>
    </message>
    <message>
        <source>Give anterior_margin, umbilical_notch or vena_cava</source>
        <translation>Geben Sie anterior_margin, umbilical_notch oder vena_cava an</translation>
    </message>
    <message>
        <source>Convert them, or correct the two fields</source>
        <translation>Rechnen Sie sie um, oder berichtigen Sie die beiden Felder</translation>
    </message>
    <message>
        <source>Give 3 x 3 numbers, symmetric and without negative variances, or leave it out</source>
        <translation>Geben Sie 3 x 3 Zahlen an, symmetrisch und ohne negative Varianzen, oder lassen Sie es weg</translation>
    </message>
    <message>
        <source>Write it as &apos;glisson register&apos; does, or leave it out</source>
        <translation>Schreiben Sie es wie „glisson register“, oder lassen Sie es weg</translation>
    </message>
    <message>
        <source>Write it as &apos;glisson register&apos; does, or leave both out</source>
        <translation>Schreiben Sie es wie „glisson register“, oder lassen Sie beides weg</translation>
    </message>
    <message>
        <source>Give lengths, or leave it out</source>
        <translation>Geben Sie Längen an, oder lassen Sie es weg</translation>
    </message>
    <message>
        <source>Give a number from 0 to 1, or leave the rival out</source>
        <translation>Geben Sie eine Zahl von 0 bis 1 an, oder lassen Sie die andere Lage weg</translation>
    </message>
    <message>
        <source>Give the file that &apos;glisson register&apos; wrote for this model</source>
        <translation>Geben Sie die Datei an, die „glisson register“ für dieses Modell geschrieben hat</translation>
    </message>
    <message>
        <source>Remove the file: operations are simulated anew</source>
        <translation>Entfernen Sie die Datei: Operationen werden neu simuliert</translation>
    </message>
    <message>
        <source>The mesh has nodes 0 to %1</source>
        <translation>Das Netz hat die Knoten 0 bis %1</translation>
    </message>
    <message>
        <source>The surface has triangles 0 to %1</source>
        <translation>Die Oberfläche hat die Dreiecke 0 bis %1</translation>
    </message>
    <message>
        <source>Move or widen the region (millimetres, in the mesh&apos;s frame)</source>
        <translation>Verschieben oder erweitern Sie das Gebiet (Millimeter, im System des Netzes)</translation>
    </message>
    <message>
        <source>Keep fixed and moved nodes apart</source>
        <translation>Halten Sie feste und bewegte Knoten auseinander</translation>
    </message>
    <message>
        <source>Give 0-based indices below %1</source>
        <translation>Geben Sie Nummern von 0 bis unter %1 an</translation>
    </message>
    <message>
        <source>Leave some free to move</source>
        <translation>Lassen Sie einige frei</translation>
    </message>
    <message>
        <source>Give Young&apos;s modulus in pascals, between 1 and 1e12 (3.5 kPa is 3500)</source>
        <translation>Geben Sie den Elastizitätsmodul in Pascal an, zwischen 1 und 1e12 (3,5 kPa sind 3500)</translation>
    </message>
    <message>
        <source>Give a Poisson ratio from 0 to below 0.5</source>
        <translation>Geben Sie eine Querkontraktionszahl von 0 bis unter 0,5 an</translation>
    </message>
    <message>
        <source>Give a value between %1 and %2 %3</source>
        <translation>Geben Sie einen Wert zwischen %1 und %2 %3 an</translation>
    </message>
    <message>
        <source>Drop unused vertices from the mesh</source>
        <translation>Entfernen Sie unbenutzte Eckpunkte aus dem Netz</translation>
    </message>
    <message>
        <source>Give a tetrahedral mesh of the liver</source>
        <translation>Geben Sie ein Tetraedernetz der Leber an</translation>
    </message>
    <message>
        <source>Give one label a tetrahedron, or none</source>
        <translation>Geben Sie je Tetraeder eine Bezeichnung an, oder keine</translation>
    </message>
    <message>
        <source>Give relative moduli</source>
        <translation>Geben Sie relative Moduln an</translation>
    </message>
    <message>
        <source>Mend the mesh</source>
        <translation>Reparieren Sie das Netz</translation>
    </message>
    <message>
        <source>Correct the load</source>
        <translation>Berichtigen Sie die Last</translation>
    </message>
    <message>
        <source>Give a step between 1e-6 and 10 s</source>
        <translation>Geben Sie einen Schritt zwischen 1e-6 und 10 s an</translation>
    </message>
    <message>
        <source>Give a relative residual between 1e-12 and 0.1</source>
        <translation>Geben Sie einen relativen Rest zwischen 1e-12 und 0,1 an</translation>
    </message>
    <message>
        <source>Give 1 or more</source>
        <translation>Geben Sie 1 oder mehr an</translation>
    </message>
    <message>
        <source>Give 1 or 2</source>
        <translation>Geben Sie 1 oder 2 an</translation>
    </message>
    <message>
        <source>Name it among the fixed nodes of the integrator</source>
        <translation>Nennen Sie ihn unter den festen Knoten des Integrators</translation>
    </message>
    <message>
        <source>Take supine, prone, left_flank, right_flank, standing, none or three numbers in m/s2</source>
        <translation>Nehmen Sie supine, prone, left_flank, right_flank, standing, none oder drei Zahlen in m/s2</translation>
    </message>
    <message>
        <source>Correct it</source>
        <translation>Berichtigen Sie es</translation>
    </message>
    <message>
        <source>Take one of %1</source>
        <translation>Nehmen Sie eines von %1</translation>
    </message>
    <message>
        <source>Fix nodes or attach springs to it</source>
        <translation>Halten Sie Knoten fest, oder befestigen Sie Federn daran</translation>
    </message>
    <message>
        <source>Give 1 to 1000000</source>
        <translation>Geben Sie 1 bis 1000000 an</translation>
    </message>
    <message>
        <source>Give 1e-8 or so</source>
        <translation>Geben Sie etwa 1e-8 an</translation>
    </message>
    <message>
        <source>Build the vessel tree anew</source>
        <translation>Bauen Sie den Gefäßbaum neu</translation>
    </message>
    <message>
        <source>Give one outer radius a node</source>
        <translation>Geben Sie je Knoten einen äußeren Radius an</translation>
    </message>
    <message>
        <source>Give outer radii between 0 and 100 mm, in metres</source>
        <translation>Geben Sie äußere Radien zwischen 0 und 100 mm an, in Metern</translation>
    </message>
    <message>
        <source>Make the mesh coarser, or save it in binary</source>
        <translation>Vergröbern Sie das Netz, oder speichern Sie es binär</translation>
    </message>
    <message>
        <source>Make the mesh coarser, or leave out what is no point and no face</source>
        <translation>Vergröbern Sie das Netz, oder lassen Sie weg, was weder Punkt noch Fläche ist</translation>
    </message>
    <message>
        <source>Export the mesh anew</source>
        <translation>Exportieren Sie das Netz neu</translation>
    </message>
    <message>
        <source>Export the surface anew</source>
        <translation>Exportieren Sie die Oberfläche neu</translation>
    </message>
    <message>
        <source>Remove the vertices that the volume does not use</source>
        <translation>Entfernen Sie die Eckpunkte, die das Volumen nicht braucht</translation>
    </message>
    <message>
        <source>Merge the vertices that lie in the same place, or leave the loose pieces out</source>
        <translation>Verschmelzen Sie die Eckpunkte, die am selben Ort liegen, oder lassen Sie die losen Stücke weg</translation>
    </message>
    <message>
        <source>Give .vtu, .vtk, .msh, .vtp, .stl, .obj or .ply</source>
        <translation>Geben Sie .vtu, .vtk, .msh, .vtp, .stl, .obj oder .ply an</translation>
    </message>
    <message>
        <source>Give .vtu, legacy .vtk or .msh</source>
        <translation>Geben Sie .vtu, altes .vtk oder .msh an</translation>
    </message>
    <message>
        <source>Name the file .vtu or .vtk</source>
        <translation>Nennen Sie die Datei .vtu oder .vtk</translation>
    </message>
    <message>
        <source>Name the file .vtp, .vtk, .stl, .obj or .ply</source>
        <translation>Nennen Sie die Datei .vtp, .vtk, .stl, .obj oder .ply</translation>
    </message>
    <message>
        <source>Give a closed surface</source>
        <translation>Geben Sie eine geschlossene Oberfläche an</translation>
    </message>
    <message>
        <source>Give one node as &quot;x y z&quot; a line</source>
        <translation>Geben Sie je Zeile einen Knoten als „x y z“ an</translation>
    </message>
    <message>
        <source>Give 0-based node numbers of this mesh</source>
        <translation>Geben Sie Knotennummern dieses Netzes an, ab 0</translation>
    </message>
    <message>
        <source>Convert the mesh to linear tetrahedra</source>
        <translation>Wandeln Sie das Netz in lineare Tetraeder um</translation>
    </message>
    <message>
        <source>Give a tetrahedral mesh, or a closed surface to be meshed</source>
        <translation>Geben Sie ein Tetraedernetz an, oder eine geschlossene Oberfläche, die vernetzt wird</translation>
    </message>
    <message>
        <source>Remove one of them</source>
        <translation>Entfernen Sie eines davon</translation>
    </message>
    <message>
        <source>Swap two of its vertices, or mesh anew</source>
        <translation>Tauschen Sie zwei seiner Eckpunkte, oder vernetzen Sie neu</translation>
    </message>
    <message>
        <source>Remove it by mesh optimisation (perturb and exude), or mesh anew</source>
        <translation>Entfernen Sie es durch Netzoptimierung (perturb und exude), oder vernetzen Sie neu</translation>
    </message>
    <message>
        <source>Segment the liver first</source>
        <translation>Segmentieren Sie zuerst die Leber</translation>
    </message>
    <message>
        <source>Join them or erase those that are not liver</source>
        <translation>Verbinden Sie sie, oder löschen Sie die, die nicht Leber sind</translation>
    </message>
    <message>
        <source>Ask for 1 to 100000 beams</source>
        <translation>Verlangen Sie 1 bis 100000 Balken</translation>
    </message>
    <message>
        <source>Ask for 20 to 200000 vertices</source>
        <translation>Verlangen Sie 20 bis 200000 Eckpunkte</translation>
    </message>
    <message>
        <source>Ask for longer edges</source>
        <translation>Verlangen Sie längere Kanten</translation>
    </message>
    <message>
        <source>Place it on the vessel&apos;s entrance</source>
        <translation>Setzen Sie es an den Eintritt des Gefäßes</translation>
    </message>
    <message>
        <source>Give an edge length of 1 to 100 mm</source>
        <translation>Geben Sie eine Kantenlänge von 1 bis 100 mm an</translation>
    </message>
    <message>
        <source>Give a ratio of 0.2 to 1</source>
        <translation>Geben Sie ein Verhältnis von 0,2 bis 1 an</translation>
    </message>
    <message>
        <source>Give a ratio of 0.1 to 10</source>
        <translation>Geben Sie ein Verhältnis von 0,1 bis 10 an</translation>
    </message>
    <message>
        <source>Keep those that matter</source>
        <translation>Behalten Sie die wichtigen</translation>
    </message>
    <message>
        <source>Close it (fill its holes) before it is meshed</source>
        <translation>Schließen Sie sie (füllen Sie ihre Löcher), bevor sie vernetzt wird</translation>
    </message>
    <message>
        <source>Keep the one that is the liver, or join them</source>
        <translation>Behalten Sie das, was die Leber ist, oder verbinden Sie sie</translation>
    </message>
    <message>
        <source>Write {&quot;edits&quot;: [...]}</source>
        <translation>Schreiben Sie {&quot;edits&quot;: [...]}</translation>
    </message>
    <message>
        <source>Write {&quot;edit&quot;: &quot;prune&quot;, &quot;at&quot;: [x, y, z]} in millimetres (LPS)</source>
        <translation>Schreiben Sie {&quot;edit&quot;: &quot;prune&quot;, &quot;at&quot;: [x, y, z]} in Millimetern (LPS)</translation>
    </message>
    <message>
        <source>Choose another one</source>
        <translation>Wählen Sie ein anderes</translation>
    </message>
    <message>
        <source>Check what the file holds; no usual unit makes a liver of it</source>
        <translation>Prüfen Sie, was die Datei enthält; keine übliche Einheit macht daraus eine Leber</translation>
    </message>
    <message>
        <source>Read it in %1</source>
        <translation>Lesen Sie sie in %1</translation>
    </message>
    <message>
        <source>If it is in inches, enlarge it 25.4 times where it was made, and read it in mm</source>
        <translation>Ist sie in Zoll, vergrößern Sie sie in dem Programm, das sie gemacht hat, 25,4-fach, und lesen Sie sie in mm</translation>
    </message>
    <message>
        <source>Read it in %1; if it is in inches, enlarge it 25.4 times where it was made, and read it in mm</source>
        <translation>Lesen Sie sie in %1; ist sie in Zoll, vergrößern Sie sie in dem Programm, das sie gemacht hat, 25,4-fach, und lesen Sie sie in mm</translation>
    </message>
    <message>
        <source>cannot be followed: %1</source>
        <translation>kann nicht verfolgt werden: %1</translation>
    </message>
    <message>
        <source>is %1 x %2, the calibration&apos;s is %3 x %4</source>
        <translation>ist %1 x %2, die der Kalibrierung %3 x %4</translation>
    </message>
    <message>
        <source>is %1, the calibration&apos;s %2</source>
        <translation>ist %1, die der Kalibrierung %2</translation>
    </message>
    <message>
        <source>there are %1, the model has %2</source>
        <translation>es gibt %1, das Modell hat %2</translation>
    </message>
    <message>
        <source>the mesh has nodes 0 to %1</source>
        <translation>das Netz hat die Knoten 0 bis %1</translation>
    </message>
    <message>
        <source>is not CT, and the network&apos;s window is of Hounsfield units</source>
        <translation>ist kein CT, und das Fenster des Netzes ist in Hounsfield-Einheiten</translation>
    </message>
    <message>
        <source>is more than 1 GB</source>
        <translation>ist mehr als 1 GB</translation>
    </message>
    <message>
        <source>are %1, not one</source>
        <translation>sind %1, nicht eine</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>is not a finite number</source>
        <translation>ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>names no label code</source>
        <translation>nennt keinen Code einer Bezeichnung</translation>
    </message>
    <message>
        <source>is not a label code</source>
        <translation>ist kein Code einer Bezeichnung</translation>
    </message>
    <message>
        <source>has a normal without a direction</source>
        <translation>hat eine Normale ohne Richtung</translation>
    </message>
    <message>
        <source>has the label %1, which is none</source>
        <translation>hat die Bezeichnung %1, die es nicht gibt</translation>
    </message>
    <message>
        <source>has two columns for &quot;%1&quot;: %2 and %3</source>
        <translation>hat zwei Spalten für „%1“: %2 und %3</translation>
    </message>
    <message>
        <source>has a sigma that is no standard deviation</source>
        <translation>hat ein Sigma, das keine Standardabweichung ist</translation>
    </message>
    <message>
        <source>is missing: the file holds no points</source>
        <translation>fehlt: die Datei enthält keine Punkte</translation>
    </message>
    <message>
        <source>half of its points lie within %1 m of its middle when read in %2, which is no liver</source>
        <translation>die Hälfte ihrer Punkte liegt, in %2 gelesen, näher als %1 m an ihrer Mitte, das ist keine Leber</translation>
    </message>
    <message>
        <source>is of another moment than the video&apos;s</source>
        <translation>ist aus einem anderen Augenblick als der des Videos</translation>
    </message>
    <message>
        <source>has no mesh of tetrahedra</source>
        <translation>hat kein Tetraedernetz</translation>
    </message>
    <message>
        <source>is %1, and the mesh&apos;s is %2</source>
        <translation>ist %1, und die des Netzes ist %2</translation>
    </message>
    <message>
        <source>there are %1, at least 10 are needed</source>
        <translation>es gibt %1, mindestens 10 sind nötig</translation>
    </message>
    <message>
        <source>its place is not known</source>
        <translation>ihr Ort ist nicht bekannt</translation>
    </message>
    <message>
        <source>there are not as many as points</source>
        <translation>es gibt nicht so viele wie Punkte</translation>
    </message>
    <message>
        <source>is not of this model</source>
        <translation>ist nicht von diesem Modell</translation>
    </message>
    <message>
        <source>has been seen at %1 places only, where %2 are needed</source>
        <translation>wurde nur an %1 Stellen gesehen, %2 sind nötig</translation>
    </message>
    <message>
        <source>is not 16 numbers</source>
        <translation>sind nicht 16 Zahlen</translation>
    </message>
    <message>
        <source>its upper left 3 x 3 block is not a rotation</source>
        <translation>ihr 3 x 3 Block oben links ist keine Drehung</translation>
    </message>
    <message>
        <source>its last row is not 0 0 0 1</source>
        <translation>ihre letzte Zeile ist nicht 0 0 0 1</translation>
    </message>
    <message>
        <source>there are %1 other places, not %2</source>
        <translation>es gibt %1 andere Lagen, nicht %2</translation>
    </message>
    <message>
        <source>is not a list of numbers</source>
        <translation>ist keine Liste von Zahlen</translation>
    </message>
    <message>
        <source>is not a number</source>
        <translation>ist keine Zahl</translation>
    </message>
    <message>
        <source>has an empty picture</source>
        <translation>hat ein leeres Bild</translation>
    </message>
    <message>
        <source>is %1 pixels, the others %2</source>
        <translation>hat %1 Pixel, die anderen %2</translation>
    </message>
    <message>
        <source>is %1 pixels, its calibration is for %2</source>
        <translation>hat %1 Pixel, seine Kalibrierung ist für %2</translation>
    </message>
    <message>
        <source>is %1 pixels, the left image %2</source>
        <translation>hat %1 Pixel, das linke Bild %2</translation>
    </message>
    <message>
        <source>is %1 pixels wide, so it has no two halves</source>
        <translation>ist %1 Pixel breit und hat deshalb keine zwei Hälften</translation>
    </message>
    <message>
        <source>is %1 pixels high, so it has no two halves</source>
        <translation>ist %1 Pixel hoch und hat deshalb keine zwei Hälften</translation>
    </message>
    <message>
        <source>holds one picture twice</source>
        <translation>enthält ein Bild zweimal</translation>
    </message>
    <message>
        <source>is seen as a board of %1, where %2 inner corners are told</source>
        <translation>wird als Muster von %1 gesehen, angegeben sind %2 innere Ecken</translation>
    </message>
    <message>
        <source>%1 of %2 pairs show a board of %3 inner corners in both pictures, %4 are needed</source>
        <translation>%1 von %2 Paaren zeigen in beiden Bildern ein Muster von %3 inneren Ecken, %4 sind nötig</translation>
    </message>
    <message>
        <source>leave the focal length open (%1 px, give or take %2): all %3 show the board at nearly one slant</source>
        <translation>lassen die Brennweite offen (%1 px, plus oder minus %2): alle %3 zeigen das Muster fast gleich geneigt</translation>
    </message>
    <message>
        <source>of %1 mm gives a baseline of %2 mm, where a stereo laparoscope has 1 to 30 mm</source>
        <translation>von %1 mm ergibt eine Basis von %2 mm, ein Stereolaparoskop hat 1 bis 30 mm</translation>
    </message>
    <message>
        <source>holds a view without a name</source>
        <translation>enthält eine Ansicht ohne Namen</translation>
    </message>
    <message>
        <source>are %1 without those left out</source>
        <translation>sind %1 ohne die weggelassenen</translation>
    </message>
    <message>
        <source>is %1x%2, not 3x3</source>
        <translation>ist %1x%2, nicht 3x3</translation>
    </message>
    <message>
        <source>is %1x%2, not a vector of %3 or more numbers</source>
        <translation>ist %1x%2, kein Vektor von %3 oder mehr Zahlen</translation>
    </message>
    <message>
        <source>is %1x%2, not a vector of %3 numbers</source>
        <translation>ist %1x%2, kein Vektor von %3 Zahlen</translation>
    </message>
    <message>
        <source>is not a number of pixels from 16 to 16384</source>
        <translation>ist keine Zahl von Pixeln von 16 bis 16384</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, which is no unit of length here</source>
        <translation>ist „%1“, das ist hier keine Längeneinheit</translation>
    </message>
    <message>
        <source>uses more than the five terms k1 k2 p1 p2 k3</source>
        <translation>braucht mehr als die fünf Terme k1 k2 p1 p2 k3</translation>
    </message>
    <message>
        <source>has no calibration in it that is whole (of cameras, distortions and the transform between them, one file is missing)</source>
        <translation>enthält keine ganze Kalibrierung (von Kameras, Verzeichnungen und der Transformation zwischen ihnen fehlt eine Datei)</translation>
    </message>
    <message>
        <source>is a second file of its kind beside %1</source>
        <translation>ist eine zweite Datei dieser Art neben %1</translation>
    </message>
    <message>
        <source>holds %1 numbers, not 3x3</source>
        <translation>enthält %1 Zahlen, nicht 3x3</translation>
    </message>
    <message>
        <source>holds %1 numbers, not 4 or 5</source>
        <translation>enthält %1 Zahlen, nicht 4 oder 5</translation>
    </message>
    <message>
        <source>holds %1 numbers, not 3x4 or 4x4</source>
        <translation>enthält %1 Zahlen, nicht 3x4 oder 4x4</translation>
    </message>
    <message>
        <source>is not 0 0 0 1</source>
        <translation>ist nicht 0 0 0 1</translation>
    </message>
    <message>
        <source>is not valid OpenCV YAML (at %1)</source>
        <translation>ist kein gültiges OpenCV-YAML (bei %1)</translation>
    </message>
    <message>
        <source>is not valid OpenCV YAML</source>
        <translation>ist kein gültiges OpenCV-YAML</translation>
    </message>
    <message>
        <source>fit the calibration better when swapped (%1 matches in front of the cameras, %2 as given)</source>
        <translation>passen vertauscht besser zur Kalibrierung (%1 Treffer vor den Kameras, %2 wie angegeben)</translation>
    </message>
    <message>
        <source>is not the left one</source>
        <translation>ist nicht das linke</translation>
    </message>
    <message>
        <source>is not the number of a frame</source>
        <translation>ist keine Nummer eines Bildes</translation>
    </message>
    <message>
        <source>is not a camera matrix (fx 0 cx; 0 fy cy; 0 0 1)</source>
        <translation>ist keine Kameramatrix (fx 0 cx; 0 fy cy; 0 0 1)</translation>
    </message>
    <message>
        <source>has its principal point (%1, %2) outside the image of %3x%4</source>
        <translation>hat ihren Hauptpunkt (%1, %2) außerhalb des Bildes von %3x%4</translation>
    </message>
    <message>
        <source>is transposed: it has cx and cy in its last row</source>
        <translation>ist transponiert: cx und cy stehen in der letzten Zeile</translation>
    </message>
    <message>
        <source>has a skew of %1 (row 1, column 2), which moves pixels by up to %2 px and is not computed with</source>
        <translation>hat eine Scherung von %1 (Zeile 1, Spalte 2), die Pixel um bis zu %2 px verschiebt und mit der nicht gerechnet wird</translation>
    </message>
    <message>
        <source>moves pixels by up to %1 px by its tangential terms p1 p2, and by %2 px by its radial ones, which no lens does</source>
        <translation>verschiebt Pixel durch die tangentialen Glieder p1 p2 um bis zu %1 px und durch die radialen um %2 px, was keine Linse tut</translation>
    </message>
    <message>
        <source>gives too few points: what both views show lies %1 pixels from its epipolar lines, and is looked for within %2</source>
        <translation>ergibt zu wenige Punkte: was beide Ansichten zeigen, liegt %1 Pixel neben seinen Epipolarlinien und wird bis %2 gesucht</translation>
    </message>
    <message>
        <source>Write rows as columns, in R too; MATLAB counts pixels from 1: take 1 off cx and cy</source>
        <translation>Zeilen als Spalten schreiben, auch in R; MATLAB zählt Pixel ab 1: von cx und cy 1 abziehen</translation>
    </message>
    <message>
        <source>Calibrate without skew, which no chip has (fx 0 cx; 0 fy cy; 0 0 1)</source>
        <translation>Ohne Scherung kalibrieren, die kein Chip hat (fx 0 cx; 0 fy cy; 0 0 1)</translation>
    </message>
    <message>
        <source>Write k1 k2 p1 p2 k3 in this order (MATLAB has k1 k2 k3 apart), or calibrate again</source>
        <translation>k1 k2 p1 p2 k3 in dieser Reihenfolge schreiben (MATLAB führt k1 k2 k3 für sich) oder neu kalibrieren</translation>
    </message>
    <message>
        <source>is a case already</source>
        <translation>ist schon ein Fall</translation>
    </message>
    <message>
        <source>Choose another one for another patient; for another image of the same patient give --replace: all else stays, marked out of date</source>
        <translation>Für einen anderen Patienten einen anderen wählen; für ein anderes Bild desselben Patienten --replace angeben: Alles andere bleibt, als veraltet markiert</translation>
    </message>
    <message>
        <source>leaves nothing of the picture</source>
        <translation>lässt nichts vom Bild übrig</translation>
    </message>
    <message>
        <source>the picture could not be encoded</source>
        <translation>das Bild konnte nicht kodiert werden</translation>
    </message>
    <message>
        <source>no picture has such a name</source>
        <translation>kein Bild heißt so</translation>
    </message>
    <message>
        <source>%1 of %2 frames can be read back</source>
        <translation>%1 von %2 Bildern lassen sich wieder lesen</translation>
    </message>
    <message>
        <source>holds %1 numbers where %2 are expected</source>
        <translation>enthält %1 Zahlen, erwartet sind %2</translation>
    </message>
    <message>
        <source>holds %1, which is no number of voxels</source>
        <translation>enthält %1, das ist keine Zahl von Voxeln</translation>
    </message>
    <message>
        <source>names &quot;%1&quot;, which lies in another folder</source>
        <translation>nennt „%1“, das in einem anderen Ordner liegt</translation>
    </message>
    <message>
        <source>names %1, which is missing</source>
        <translation>nennt %1, das fehlt</translation>
    </message>
    <message>
        <source>is not that of a NIfTI-1 file that holds its voxels itself</source>
        <translation>ist nicht das einer NIfTI-1-Datei, die ihre Voxel selbst enthält</translation>
    </message>
    <message>
        <source>marks no array as the scalars</source>
        <translation>kennzeichnet kein Feld als die Skalare</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, which is no number format that is known</source>
        <translation>ist „%1“, das ist kein bekanntes Zahlenformat</translation>
    </message>
    <message>
        <source>holds fewer values than there are voxels</source>
        <translation>enthält weniger Werte, als es Voxel gibt</translation>
    </message>
    <message>
        <source>is a DICOM directory that was cut or is damaged</source>
        <translation>ist ein DICOM-Verzeichnis, das abgeschnitten oder beschädigt ist</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, not a whole number from %2 to %3</source>
        <translation>ist „%1“, keine ganze Zahl von %2 bis %3</translation>
    </message>
    <message>
        <source>cannot be written as a DICOM segmentation (%1)</source>
        <translation>können nicht als DICOM-Segmentierung geschrieben werden (%1)</translation>
    </message>
    <message>
        <source>is more than the 65535 pixels a side that DICOM counts</source>
        <translation>ist mehr als die 65535 Pixel je Seite, die DICOM zählt</translation>
    </message>
    <message>
        <source>is more than NIfTI can hold</source>
        <translation>ist mehr, als NIfTI fasst</translation>
    </message>
    <message>
        <source>cannot be searched (%1)</source>
        <translation>kann nicht durchsucht werden (%1)</translation>
    </message>
    <message>
        <source>could not be made (%1)</source>
        <translation>konnte nicht angelegt werden (%1)</translation>
    </message>
    <message>
        <source>is %1, not %2</source>
        <translation>ist %1, nicht %2</translation>
    </message>
    <message>
        <source>left what is no result of it</source>
        <translation>hinterließ etwas, das kein Ergebnis von ihm ist</translation>
    </message>
    <message>
        <source>Register again, from more of the surface</source>
        <translation>Registrieren Sie noch einmal, mit mehr von der Oberfläche</translation>
    </message>
    <message>
        <source>Register again</source>
        <translation>Registrieren Sie noch einmal</translation>
    </message>
    <message>
        <source>Register from the start</source>
        <translation>Registrieren Sie von Anfang an</translation>
    </message>
    <message>
        <source>Give both views of every frame</source>
        <translation>Geben Sie beide Ansichten jedes Bildes an</translation>
    </message>
    <message>
        <source>Use the calibration of this video</source>
        <translation>Nehmen Sie die Kalibrierung dieses Videos</translation>
    </message>
    <message>
        <source>Give a registration of this model</source>
        <translation>Geben Sie eine Registrierung dieses Modells an</translation>
    </message>
    <message>
        <source>Export a network whose input is [1, 1, rows, columns] or [1, 1, slices, rows, columns]</source>
        <translation>Exportieren Sie ein Netz mit der Eingabe [1, 1, Zeilen, Spalten] oder [1, 1, Schichten, Zeilen, Spalten]</translation>
    </message>
    <message>
        <source>Export a network whose input has a batch and a channel of 1</source>
        <translation>Exportieren Sie ein Netz, dessen Eingabe einen Stapel und einen Kanal von 1 hat</translation>
    </message>
    <message>
        <source>Open a CT</source>
        <translation>Öffnen Sie ein CT</translation>
    </message>
    <message>
        <source>Use a coarser spacing, or tiles of fewer slices</source>
        <translation>Nehmen Sie einen gröberen Abstand, oder Kacheln mit weniger Schichten</translation>
    </message>
    <message>
        <source>Use a smaller network</source>
        <translation>Nehmen Sie ein kleineres Netz</translation>
    </message>
    <message>
        <source>Export a network with one input and one output</source>
        <translation>Exportieren Sie ein Netz mit einer Eingabe und einer Ausgabe</translation>
    </message>
    <message>
        <source>Connect again</source>
        <translation>Verbinden Sie noch einmal</translation>
    </message>
    <message>
        <source>Give pixels of the picture</source>
        <translation>Geben Sie Pixel des Bildes an</translation>
    </message>
    <message>
        <source>Give lines as &apos;glisson track --correct&apos; writes them into frames.jsonl</source>
        <translation>Geben Sie Zeilen an, wie „glisson track --correct“ sie in frames.jsonl schreibt</translation>
    </message>
    <message>
        <source>Write a JSON object such as {&quot;6&quot;: &quot;parenchyma&quot;, &quot;10&quot;: &quot;portal_vein&quot;}</source>
        <translation>Schreiben Sie ein JSON-Objekt wie {&quot;6&quot;: &quot;parenchyma&quot;, &quot;10&quot;: &quot;portal_vein&quot;}</translation>
    </message>
    <message>
        <source>Codes are whole numbers from 0 to 65535, in quotes</source>
        <translation>Codes sind ganze Zahlen von 0 bis 65535, in Anführungszeichen</translation>
    </message>
    <message>
        <source>Use background, parenchyma, portal_vein, hepatic_veins, vena_cava, artery, gallbladder or lesion_1 to lesion_240 (or other_1 to other_9)</source>
        <translation>Nehmen Sie background, parenchyma, portal_vein, hepatic_veins, vena_cava, artery, gallbladder oder lesion_1 bis lesion_240 (oder other_1 bis other_9)</translation>
    </message>
    <message>
        <source>Export the cloud again as PLY</source>
        <translation>Exportieren Sie die Wolke noch einmal als PLY</translation>
    </message>
    <message>
        <source>Compute the normals again or leave nx ny nz out</source>
        <translation>Berechnen Sie die Normalen noch einmal, oder lassen Sie nx ny nz weg</translation>
    </message>
    <message>
        <source>Labels are 1 (surface), 2 (anterior margin) and 3 (umbilical notch)</source>
        <translation>Bezeichnungen sind 1 (Oberfläche), 2 (Vorderrand) und 3 (Nabelkerbe)</translation>
    </message>
    <message>
        <source>It must be a number of 0 or more</source>
        <translation>Es muss eine Zahl von 0 oder mehr sein</translation>
    </message>
    <message>
        <source>Check what the file holds</source>
        <translation>Prüfen Sie, was die Datei enthält</translation>
    </message>
    <message>
        <source>Give what &apos;glisson track&apos; wrote</source>
        <translation>Geben Sie an, was „glisson track“ geschrieben hat</translation>
    </message>
    <message>
        <source>Give a folder that &apos;glisson track&apos; filled</source>
        <translation>Geben Sie einen Ordner an, den „glisson track“ gefüllt hat</translation>
    </message>
    <message>
        <source>Give the track of this video</source>
        <translation>Geben Sie die Verfolgung dieses Videos an</translation>
    </message>
    <message>
        <source>Track the case itself: --model CASE</source>
        <translation>Verfolgen Sie den Fall selbst: --model FALL</translation>
    </message>
    <message>
        <source>Give the case whose model was tracked</source>
        <translation>Geben Sie den Fall an, dessen Modell verfolgt wurde</translation>
    </message>
    <message>
        <source>Reconstruct with more features or larger regions</source>
        <translation>Rekonstruieren Sie mit mehr Merkmalen oder größeren Gebieten</translation>
    </message>
    <message>
        <source>Place it among the landmarks</source>
        <translation>Setzen Sie sie unter die Landmarken</translation>
    </message>
    <message>
        <source>Remove the point</source>
        <translation>Entfernen Sie den Punkt</translation>
    </message>
    <message>
        <source>Give one a point, or none</source>
        <translation>Geben Sie je Punkt eine an, oder keine</translation>
    </message>
    <message>
        <source>Follow the organ for a second and show more of it</source>
        <translation>Verfolgen Sie das Organ eine Sekunde lang, und zeigen Sie mehr davon</translation>
    </message>
    <message>
        <source>Write a 4 x 4 matrix, cloud_from_model, row by row</source>
        <translation>Schreiben Sie eine 4 x 4 Matrix, cloud_from_model, Zeile für Zeile</translation>
    </message>
    <message>
        <source>Take out scale and mirroring</source>
        <translation>Nehmen Sie Maßstab und Spiegelung heraus</translation>
    </message>
    <message>
        <source>Choose one of those that it tells</source>
        <translation>Wählen Sie eine von denen, die sie nennt</translation>
    </message>
    <message>
        <source>Choose up to 100 mm</source>
        <translation>Wählen Sie bis zu 100 mm</translation>
    </message>
    <message>
        <source>Choose up to 20 mm</source>
        <translation>Wählen Sie bis zu 20 mm</translation>
    </message>
    <message>
        <source>Choose up to 1</source>
        <translation>Wählen Sie bis zu 1</translation>
    </message>
    <message>
        <source>Choose 0.3 to 5 mm</source>
        <translation>Wählen Sie 0,3 bis 5 mm</translation>
    </message>
    <message>
        <source>Write {&quot;liver&quot;: [[x, y, z], ...], ...}</source>
        <translation>Schreiben Sie {&quot;liver&quot;: [[x, y, z], ...], ...}</translation>
    </message>
    <message>
        <source>Give the pictures of both cameras</source>
        <translation>Geben Sie die Bilder beider Kameras an</translation>
    </message>
    <message>
        <source>Give a picture of each camera</source>
        <translation>Geben Sie ein Bild jeder Kamera an</translation>
    </message>
    <message>
        <source>Calibrate with pictures of one size, that of the operation</source>
        <translation>Kalibrieren Sie mit Bildern einer Größe, der der Operation</translation>
    </message>
    <message>
        <source>Count the corners where four squares meet, along each side</source>
        <translation>Zählen Sie entlang jeder Seite die Ecken, an denen vier Felder zusammenstoßen</translation>
    </message>
    <message>
        <source>Check the board&apos;s size and dictionary, and take sharp pictures of it</source>
        <translation>Prüfen Sie Größe und Wörterbuch des Musters, und machen Sie scharfe Bilder davon</translation>
    </message>
    <message>
        <source>Take sharp pictures of the whole board, with a white border around it</source>
        <translation>Machen Sie scharfe Bilder des ganzen Musters mit einem weißen Rand darum</translation>
    </message>
    <message>
        <source>Tilt the board by 20 to 40 degrees, each time another way</source>
        <translation>Neigen Sie das Muster um 20 bis 40 Grad, jedes Mal anders</translation>
    </message>
    <message>
        <source>Take more views, with the board at the edges of the picture, too</source>
        <translation>Nehmen Sie mehr Ansichten auf, auch mit dem Muster an den Rändern des Bildes</translation>
    </message>
    <message>
        <source>Give the left camera&apos;s pictures as the left ones</source>
        <translation>Geben Sie die Bilder der linken Kamera als die linken an</translation>
    </message>
    <message>
        <source>Measure the side of a square</source>
        <translation>Messen Sie die Seite eines Feldes</translation>
    </message>
    <message>
        <source>Name views as the report does</source>
        <translation>Nennen Sie Ansichten wie der Bericht</translation>
    </message>
    <message>
        <source>Keep %1 or more</source>
        <translation>Behalten Sie %1 oder mehr</translation>
    </message>
    <message>
        <source>Leave that pair out: it does not fit the others</source>
        <translation>Lassen Sie dieses Paar weg: es passt nicht zu den anderen</translation>
    </message>
    <message>
        <source>Write mm, cm or m: the unit of T</source>
        <translation>Schreiben Sie mm, cm oder m: die Einheit von T</translation>
    </message>
    <message>
        <source>Calibrate without the rational, thin-prism and tilted models</source>
        <translation>Kalibrieren Sie ohne die Modelle rational, thin-prism und tilted</translation>
    </message>
    <message>
        <source>Leave one of them in the folder</source>
        <translation>Lassen Sie eine davon im Ordner</translation>
    </message>
    <message>
        <source>Expected calib.left.intrinsic.txt (3x3), calib.left.distortion.txt (4 or 5 numbers), the same for right, and calib.l2r.txt (4x4)</source>
        <translation>Erwartet werden calib.left.intrinsic.txt (3x3), calib.left.distortion.txt (4 oder 5 Zahlen), das Gleiche für right, und calib.l2r.txt (4x4)</translation>
    </message>
    <message>
        <source>Write &quot;left&quot; here, and &quot;right&quot; as the image of each region of the right one</source>
        <translation>Schreiben Sie hier „left“, und „right“ als das Bild jedes Gebiets im rechten</translation>
    </message>
    <message>
        <source>Check image_width and image_height: the calibration is of another image size</source>
        <translation>Prüfen Sie image_width und image_height: die Kalibrierung ist von einer anderen Bildgröße</translation>
    </message>
    <message>
        <source>Check the pattern</source>
        <translation>Prüfen Sie das Muster</translation>
    </message>
    <message>
        <source>Free some space on the disk and record again</source>
        <translation>Schaffen Sie Platz auf dem Datenträger, und nehmen Sie noch einmal auf</translation>
    </message>
    <message>
        <source>Put it beside the header and name it there without a folder</source>
        <translation>Legen Sie es neben den Kopf, und nennen Sie es dort ohne Ordner</translation>
    </message>
    <message>
        <source>Export it as NIfTI-1</source>
        <translation>Exportieren Sie es als NIfTI-1</translation>
    </message>
    <message>
        <source>Export it as one .nii or .nii.gz file</source>
        <translation>Exportieren Sie es als eine Datei .nii oder .nii.gz</translation>
    </message>
    <message>
        <source>Write one scalar array on the points</source>
        <translation>Schreiben Sie ein Skalarfeld auf die Punkte</translation>
    </message>
    <message>
        <source>Export the labels as .seg.nrrd instead</source>
        <translation>Exportieren Sie die Bezeichnungen stattdessen als .seg.nrrd</translation>
    </message>
    <message>
        <source>Segment the CT first</source>
        <translation>Segmentieren Sie zuerst das CT</translation>
    </message>
    <message>
        <source>Write .nrrd instead</source>
        <translation>Schreiben Sie stattdessen .nrrd</translation>
    </message>
    <message>
        <source>Check its permissions, or copy it to a disk of this computer</source>
        <translation>Prüfen Sie die Rechte, oder kopieren Sie ihn auf einen Datenträger dieses Rechners</translation>
    </message>
    <message>
        <source>Do not trust the file; export it again</source>
        <translation>Trauen Sie der Datei nicht; exportieren Sie sie noch einmal</translation>
    </message>
    <message>
        <source>is larger than 100 MB, more than any list needs</source>
        <translation>ist größer als 100 MB, mehr als jede Liste braucht</translation>
    </message>
    <message>
        <source>is larger than 4 GB</source>
        <translation>ist größer als 4 GB</translation>
    </message>
    <message>
        <source>is larger than such a file can be</source>
        <translation>ist größer, als eine solche Datei sein kann</translation>
    </message>
    <message>
        <source>nests lists deeper than any that is read here</source>
        <translation>schachtelt Listen tiefer als jede, die hier gelesen wird</translation>
    </message>
    <message>
        <source>has no voxel of %1 within 5 mm</source>
        <translation>hat im Umkreis von 5 mm kein Voxel von %1</translation>
    </message>
    <message>
        <source>lies at the tree&apos;s root</source>
        <translation>liegt an der Wurzel des Baums</translation>
    </message>
    <message>
        <source>lies outside the volume</source>
        <translation>liegt außerhalb des Volumens</translation>
    </message>
    <message>
        <source>are not the one list of the file</source>
        <translation>sind nicht die eine Liste der Datei</translation>
    </message>
    <message>
        <source>brick %1 is missing</source>
        <translation>Baustein %1 fehlt</translation>
    </message>
    <message>
        <source>belongs to labels of another size</source>
        <translation>gehört zu Bezeichnungen anderer Größe</translation>
    </message>
    <message>
        <source>counts more steps than there are</source>
        <translation>zählt mehr Schritte, als es gibt</translation>
    </message>
    <message>
        <source>do not lead to the case&apos;s labels</source>
        <translation>führen nicht zu den Bezeichnungen des Falls</translation>
    </message>
    <message>
        <source>is not a JSON object</source>
        <translation>ist kein JSON-Objekt</translation>
    </message>
    <message>
        <source>lies on %1, not on %2</source>
        <translation>liegt auf %1, nicht auf %2</translation>
    </message>
    <message>
        <source>runs through several slices</source>
        <translation>läuft durch mehrere Schichten</translation>
    </message>
    <message>
        <source>%1 lies in air, fat or bone</source>
        <translation>%1 liegt in Luft, Fett oder Knochen</translation>
    </message>
    <message>
        <source>%1 lies in %2, which may not become the vessel there</source>
        <translation>%1 liegt in %2, das dort nicht zum Gefäß werden darf</translation>
    </message>
    <message>
        <source>has no way from %1 to %2 through soft tissue that may become the vessel</source>
        <translation>hat keinen Weg von %1 zu %2 durch Weichteile, die zum Gefäß werden dürfen</translation>
    </message>
    <message>
        <source>is %1, which is no vessel</source>
        <translation>ist %1, das ist kein Gefäß</translation>
    </message>
    <message>
        <source>%1 lies outside the volume</source>
        <translation>%1 liegt außerhalb des Volumens</translation>
    </message>
    <message>
        <source>%1 and %2 are one voxel</source>
        <translation>%1 und %2 sind ein Voxel</translation>
    </message>
    <message>
        <source>is not followed</source>
        <translation>wird nicht verfolgt</translation>
    </message>
    <message>
        <source>lies on other voxels than the CT (origin, spacing, direction or size)</source>
        <translation>liegt auf anderen Voxeln als das CT (Ursprung, Abstand, Richtung oder Größe)</translation>
    </message>
    <message>
        <source>names nothing of the liver in any segment</source>
        <translation>nennt in keinem Segment etwas von der Leber</translation>
    </message>
    <message>
        <source>is kept already</source>
        <translation>ist schon aufbewahrt</translation>
    </message>
    <message>
        <source>is one more than the %1 that can be kept</source>
        <translation>ist einer mehr als die %1, die aufbewahrt werden können</translation>
    </message>
    <message>
        <source>has not been seen often enough yet</source>
        <translation>wurde noch nicht oft genug gesehen</translation>
    </message>
    <message>
        <source>has fewer than 3 points</source>
        <translation>hat weniger als 3 Punkte</translation>
    </message>
    <message>
        <source>has %1 points</source>
        <translation>hat %1 Punkte</translation>
    </message>
    <message>
        <source>is not proposed</source>
        <translation>ist nicht vorgeschlagen</translation>
    </message>
    <message>
        <source>is none</source>
        <translation>ist keine</translation>
    </message>
    <message>
        <source>is not known, nor where a vessel enters: nothing holds the organ</source>
        <translation>ist nicht bekannt, und auch nicht, wo ein Gefäß eintritt: nichts hält das Organ</translation>
    </message>
    <message>
        <source>and the places where vessels enter lie on one line, about which the organ would turn freely</source>
        <translation>und die Stellen, an denen Gefäße eintreten, liegen auf einer Linie, um die sich das Organ frei drehen würde</translation>
    </message>
    <message>
        <source>is no number</source>
        <translation>ist keine Zahl</translation>
    </message>
    <message>
        <source>no pipe to a helper process can be made (%1)</source>
        <translation>keine Leitung zu einem Hilfsprozess kann angelegt werden (%1)</translation>
    </message>
    <message>
        <source>no socket to a helper process can be made (%1)</source>
        <translation>kein Socket zu einem Hilfsprozess kann angelegt werden (%1)</translation>
    </message>
    <message>
        <source>no socket can be made (%1)</source>
        <translation>kein Socket kann angelegt werden (%1)</translation>
    </message>
    <message>
        <source>no event can be made</source>
        <translation>kein Ereignis kann angelegt werden</translation>
    </message>
    <message>
        <source>cannot be opened to flush (%1)</source>
        <translation>kann nicht geöffnet werden, um es auf den Datenträger zu schreiben (%1)</translation>
    </message>
    <message>
        <source>was replaced while it was written</source>
        <translation>wurde ersetzt, während es geschrieben wurde</translation>
    </message>
    <message>
        <source>its permissions could not be kept (%1)</source>
        <translation>seine Rechte konnten nicht erhalten werden (%1)</translation>
    </message>
    <message>
        <source>could not be replaced (%1)</source>
        <translation>konnte nicht ersetzt werden (%1)</translation>
    </message>
    <message>
        <source>no folder for recovery can be made here (%1)</source>
        <translation>hier kann kein Ordner zur Wiederherstellung angelegt werden (%1)</translation>
    </message>
    <message>
        <source>its folder does not exist</source>
        <translation>sein Ordner existiert nicht</translation>
    </message>
    <message>
        <source>its folder cannot be written to</source>
        <translation>in seinen Ordner kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>is a file, a folder is needed here</source>
        <translation>ist eine Datei, hier ist ein Ordner nötig</translation>
    </message>
    <message>
        <source>leads to another disk</source>
        <translation>führt auf einen anderen Datenträger</translation>
    </message>
    <message>
        <source>Remove the link, or name a folder on that disk</source>
        <translation>Entfernen Sie die Verknüpfung oder nennen Sie einen Ordner auf jenem Datenträger</translation>
    </message>
    <message>
        <source>could not be completed (%1)</source>
        <translation>konnte nicht fertiggestellt werden (%1)</translation>
    </message>
    <message>
        <source>could not be written (%1)</source>
        <translation>konnte nicht geschrieben werden (%1)</translation>
    </message>
    <message>
        <source>others have saved it meanwhile, so that it stays as they left it; this run&apos;s is %1</source>
        <translation>andere haben ihn inzwischen gespeichert, er bleibt so, wie sie ihn hinterlassen haben; der dieses Laufs ist %1</translation>
    </message>
    <message>
        <source>a volume reads back differently from what was written</source>
        <translation>ein Volumen liest sich anders, als es geschrieben wurde</translation>
    </message>
    <message>
        <source>this file system has no locks, so that two programs may write one case</source>
        <translation>dieses Dateisystem hat keine Sperren, so dass zwei Programme einen Fall schreiben könnten</translation>
    </message>
    <message>
        <source>is no option of &apos;glisson %1&apos;</source>
        <translation>ist keine Option von „glisson %1“</translation>
    </message>
    <message>
        <source>unknown option</source>
        <translation>unbekannte Option</translation>
    </message>
    <message>
        <source>is needed</source>
        <translation>ist nötig</translation>
    </message>
    <message>
        <source>one of them is needed</source>
        <translation>eines davon ist nötig</translation>
    </message>
    <message>
        <source>one of --pairs, --left with --right, and --video is needed</source>
        <translation>eines von --pairs, --left mit --right und --video ist nötig</translation>
    </message>
    <message>
        <source>must end in %1</source>
        <translation>muss auf %1 enden</translation>
    </message>
    <message>
        <source>must be a number from %1 to %2</source>
        <translation>muss eine Zahl von %1 bis %2 sein</translation>
    </message>
    <message>
        <source>must be %1 numbers between commas, each from %2 to %3</source>
        <translation>müssen %1 Zahlen mit Kommas dazwischen sein, jede von %2 bis %3</translation>
    </message>
    <message>
        <source>must be a whole number from 0</source>
        <translation>muss eine ganze Zahl ab 0 sein</translation>
    </message>
    <message>
        <source>must be a whole number</source>
        <translation>muss eine ganze Zahl sein</translation>
    </message>
    <message>
        <source>must be two whole numbers, as in 14x10</source>
        <translation>müssen zwei ganze Zahlen sein, wie in 14x10</translation>
    </message>
    <message>
        <source>must be mm, cm or m</source>
        <translation>muss mm, cm oder m sein</translation>
    </message>
    <message>
        <source>must be direct, fast or reference</source>
        <translation>muss direct, fast oder reference sein</translation>
    </message>
    <message>
        <source>must be sparse, dense or auto</source>
        <translation>muss sparse, dense oder auto sein</translation>
    </message>
    <message>
        <source>must be surf, sift or akaze</source>
        <translation>muss surf, sift oder akaze sein</translation>
    </message>
    <message>
        <source>must be automatic, forces, springs or paper</source>
        <translation>muss automatic, forces, springs oder paper sein</translation>
    </message>
    <message>
        <source>must be operations or none</source>
        <translation>muss operations oder none sein</translation>
    </message>
    <message>
        <source>must hold a number such as %02d, as in &apos;cloud_%02d.ply&apos;</source>
        <translation>muss eine Zahl wie %02d enthalten, wie in &apos;cloud_%02d.ply&apos;</translation>
    </message>
    <message>
        <source>%1 arguments were given besides the options, %2 is needed</source>
        <translation>%1 Argumente neben den Optionen, nötig ist %2</translation>
    </message>
    <message>
        <source>no file of this name exists</source>
        <translation>es gibt keine Datei dieses Namens</translation>
    </message>
    <message>
        <source>needs a matrix</source>
        <translation>braucht eine Matrix</translation>
    </message>
    <message>
        <source>needs pictures</source>
        <translation>braucht Bilder</translation>
    </message>
    <message>
        <source>needs --igtl-send</source>
        <translation>braucht --igtl-send</translation>
    </message>
    <message>
        <source>is no lesion</source>
        <translation>ist keine Läsion</translation>
    </message>
    <message>
        <source>is no pixel</source>
        <translation>ist kein Pixel</translation>
    </message>
    <message>
        <source>is none of the looks</source>
        <translation>ist keine der Darstellungen</translation>
    </message>
    <message>
        <source>does not exist, and is no command</source>
        <translation>gibt es nicht, und ist kein Befehl</translation>
    </message>
    <message>
        <source>the window opens one case</source>
        <translation>das Fenster öffnet einen Fall</translation>
    </message>
    <message>
        <source>there is no display for the window, but commands work without one</source>
        <translation>es gibt keinen Bildschirm für das Fenster, aber Befehle arbeiten ohne ihn</translation>
    </message>
    <message>
        <source>is not in the video</source>
        <translation>ist nicht im Video</translation>
    </message>
    <message>
        <source>is not in the video, or was not tracked</source>
        <translation>ist nicht im Video oder wurde nicht verfolgt</translation>
    </message>
    <message>
        <source>is not in the video, or lies before the registered frame</source>
        <translation>ist nicht im Video oder liegt vor dem registrierten Bild</translation>
    </message>
    <message>
        <source>is beside the organ</source>
        <translation>liegt neben dem Organ</translation>
    </message>
    <message>
        <source>has no frame to be drawn</source>
        <translation>hat kein Bild, das gezeichnet werden kann</translation>
    </message>
    <message>
        <source>Click on the branch that is to change</source>
        <translation>Klicken Sie auf den Ast, der sich ändern soll</translation>
    </message>
    <message>
        <source>Click farther out on the branch</source>
        <translation>Klicken Sie weiter außen auf den Ast</translation>
    </message>
    <message>
        <source>Click inside the picture</source>
        <translation>Klicken Sie ins Bild</translation>
    </message>
    <message>
        <source>Click inside the vessel</source>
        <translation>Klicken Sie in das Gefäß</translation>
    </message>
    <message>
        <source>Click a part of %1</source>
        <translation>Klicken Sie auf einen Teil von %1</translation>
    </message>
    <message>
        <source>Click beside it, or change what may be edited</source>
        <translation>Klicken Sie daneben, oder ändern Sie, was bearbeitet werden darf</translation>
    </message>
    <message>
        <source>Click points between them, or change what may be edited</source>
        <translation>Klicken Sie Punkte dazwischen, oder ändern Sie, was bearbeitet werden darf</translation>
    </message>
    <message>
        <source>Click two different places</source>
        <translation>Klicken Sie zwei verschiedene Stellen</translation>
    </message>
    <message>
        <source>Choose the portal vein, the hepatic veins, the vena cava or the artery</source>
        <translation>Wählen Sie die Pfortader, die Lebervenen, die Vena cava oder die Arterie</translation>
    </message>
    <message>
        <source>Draw a disc in one slice, or use a ball</source>
        <translation>Zeichnen Sie eine Scheibe in einer Schicht, oder nehmen Sie eine Kugel</translation>
    </message>
    <message>
        <source>Write {&quot;edits&quot;: [{&quot;tool&quot;: ...}, ...]}</source>
        <translation>Schreiben Sie {&quot;edits&quot;: [{&quot;tool&quot;: ...}, ...]}</translation>
    </message>
    <message>
        <source>Write {&quot;tool&quot;: ..., ...}</source>
        <translation>Schreiben Sie {&quot;tool&quot;: ..., ...}</translation>
    </message>
    <message>
        <source>Delete the folder &apos;history&apos; of the case: only the undo steps are lost</source>
        <translation>Löschen Sie den Ordner „history“ des Falls: nur die Schritte zum Rückgängigmachen gehen verloren</translation>
    </message>
    <message>
        <source>Remove it from the case</source>
        <translation>Entfernen Sie es aus dem Fall</translation>
    </message>
    <message>
        <source>Start tracking first</source>
        <translation>Starten Sie zuerst die Verfolgung</translation>
    </message>
    <message>
        <source>Resample the segmentation to the CT&apos;s grid, or open the CT that it was drawn on</source>
        <translation>Rechnen Sie die Segmentierung auf das Gitter des CT um, oder öffnen Sie das CT, auf dem sie gezeichnet wurde</translation>
    </message>
    <message>
        <source>Say which segment means what with --codes FILE (see &apos;glisson model --help&apos;)</source>
        <translation>Sagen Sie mit --codes DATEI, welches Segment was bedeutet (siehe „glisson model --help“)</translation>
    </message>
    <message>
        <source>Look from elsewhere and reconstruct again</source>
        <translation>Blicken Sie von anderswo, und rekonstruieren Sie noch einmal</translation>
    </message>
    <message>
        <source>Forget the earlier looks, or register with these</source>
        <translation>Vergessen Sie die früheren Blicke, oder registrieren Sie mit diesen</translation>
    </message>
    <message>
        <source>Follow the organ in a stereo video for a second</source>
        <translation>Verfolgen Sie das Organ eine Sekunde lang in einem Stereovideo</translation>
    </message>
    <message>
        <source>Give the points of the contact</source>
        <translation>Geben Sie die Punkte der Berührung an</translation>
    </message>
    <message>
        <source>Give as many as are proposed: %1</source>
        <translation>Geben Sie so viele an, wie vorgeschlagen sind: %1</translation>
    </message>
    <message>
        <source>Let an atlas that knows it propose it first</source>
        <translation>Lassen Sie es zuerst von einem Atlas vorschlagen, der es kennt</translation>
    </message>
    <message>
        <source>Place notch, margin or vena cava in five cases at least, or build on another atlas</source>
        <translation>Setzen Sie Kerbe, Rand oder Hohlvene in mindestens fünf Fällen, oder bauen Sie auf einem anderen Atlas auf</translation>
    </message>
    <message>
        <source>Correct first</source>
        <translation>Korrigieren Sie zuerst</translation>
    </message>
    <message>
        <source>Place the vena cava among the landmarks</source>
        <translation>Setzen Sie die Vena cava unter die Landmarken</translation>
    </message>
    <message>
        <source>Place three points or more of the vena cava among the landmarks, where it touches the liver</source>
        <translation>Setzen Sie drei oder mehr Punkte der Vena cava unter die Landmarken, wo sie die Leber berührt</translation>
    </message>
    <message>
        <source>Remove the file&apos;s entry from case.json and transfer the atlas again</source>
        <translation>Entfernen Sie den Eintrag der Datei aus case.json, und übertragen Sie den Atlas noch einmal</translation>
    </message>
    <message>
        <source>Write it again</source>
        <translation>Schreiben Sie es noch einmal</translation>
    </message>
    <message>
        <source>Close other programs</source>
        <translation>Schließen Sie andere Programme</translation>
    </message>
    <message>
        <source>Check permissions and free space</source>
        <translation>Prüfen Sie Rechte und freien Platz</translation>
    </message>
    <message>
        <source>Check the disk</source>
        <translation>Prüfen Sie den Datenträger</translation>
    </message>
    <message>
        <source>Keep cases elsewhere</source>
        <translation>Bewahren Sie Fälle anderswo auf</translation>
    </message>
    <message>
        <source>Choose another folder</source>
        <translation>Wählen Sie einen anderen Ordner</translation>
    </message>
    <message>
        <source>Compare the two</source>
        <translation>Vergleichen Sie die beiden</translation>
    </message>
    <message>
        <source>See &apos;glisson %1 --help&apos;</source>
        <translation>Siehe „glisson %1 --help“</translation>
    </message>
    <message>
        <source>See &apos;glisson --help&apos;</source>
        <translation>Siehe „glisson --help“</translation>
    </message>
    <message>
        <source>See --help</source>
        <translation>Siehe --help</translation>
    </message>
    <message>
        <source>Check --%1</source>
        <translation>Prüfen Sie --%1</translation>
    </message>
    <message>
        <source>Check the pattern&apos;s folder and number</source>
        <translation>Prüfen Sie Ordner und Nummer des Musters</translation>
    </message>
    <message>
        <source>Give its file by --rigid FILE</source>
        <translation>Geben Sie ihre Datei mit --rigid DATEI an</translation>
    </message>
    <message>
        <source>Give --video with --calibration</source>
        <translation>Geben Sie --video mit --calibration an</translation>
    </message>
    <message>
        <source>Give lesion_1 and so on</source>
        <translation>Geben Sie lesion_1 und so weiter an</translation>
    </message>
    <message>
        <source>Give two numbers, as 480,270</source>
        <translation>Geben Sie zwei Zahlen an, etwa 480,270</translation>
    </message>
    <message>
        <source>Give frames from 0 to %1</source>
        <translation>Geben Sie Bilder von 0 bis %1 an</translation>
    </message>
    <message>
        <source>Give a pixel of the drawn organ</source>
        <translation>Geben Sie ein Pixel des gezeichneten Organs an</translation>
    </message>
    <message>
        <source>Give one on it</source>
        <translation>Geben Sie eines darauf an</translation>
    </message>
    <message>
        <source>Choose a frame that was tracked</source>
        <translation>Wählen Sie ein Bild, das verfolgt wurde</translation>
    </message>
    <message>
        <source>Choose a frame between the registered one and the video&apos;s end</source>
        <translation>Wählen Sie ein Bild zwischen dem registrierten und dem Ende des Videos</translation>
    </message>
    <message>
        <source>Give a track of this video, or register a frame that is not its last</source>
        <translation>Geben Sie eine Verfolgung dieses Videos an, oder registrieren Sie ein Bild, das nicht sein letztes ist</translation>
    </message>
    <message>
        <source>Give Young&apos;s modulus in kPa, from %1 to %2, or %3</source>
        <translation>Elastizitätsmodul in kPa angeben, von %1 bis %2, oder %3</translation>
    </message>
    <message>
        <source>Name lesion_1, lesion_2 and so on</source>
        <translation>Nennen Sie lesion_1, lesion_2 und so weiter</translation>
    </message>
    <message>
        <source>has no value</source>
        <translation>hat keinen Wert</translation>
    </message>
    <message>
        <source>Write NAME=KPA, as in lesion_1=20,lesions=12</source>
        <translation>Schreiben Sie NAME=KPA, wie lesion_1=20,lesions=12</translation>
    </message>
    <message>
        <source>is given twice</source>
        <translation>ist zweimal angegeben</translation>
    </message>
    <message>
        <source>Give it once</source>
        <translation>Geben Sie es einmal an</translation>
    </message>
    <message>
        <source>is no tissue of which stiffness can be said</source>
        <translation>ist kein Gewebe, über dessen Steifigkeit etwas gesagt werden kann</translation>
    </message>
    <message>
        <source>Name parenchyma, lesions, or lesion_1, lesion_2 and so on</source>
        <translation>Nennen Sie parenchyma, lesions oder lesion_1, lesion_2 und so weiter</translation>
    </message>
    <message>
        <source>is no lesion of this model</source>
        <translation>ist keine Läsion dieses Modells</translation>
    </message>
    <message>
        <source>are none in this model</source>
        <translation>gibt es in diesem Modell nicht</translation>
    </message>
    <message>
        <source>is no deviation</source>
        <translation>ist keine Abweichung</translation>
    </message>
    <message>
        <source>Give millimetres from 0, or leave the field out</source>
        <translation>Millimeter ab 0 angeben oder das Feld weglassen</translation>
    </message>
    <message>
        <source>are not as many as points</source>
        <translation>sind nicht so viele wie Punkte</translation>
    </message>
    <message>
        <source>Give one a point of the margin, or leave the field out</source>
        <translation>Eine je Punkt des Randes angeben oder das Feld weglassen</translation>
    </message>
    <message>
        <source>is not a place and a radius</source>
        <translation>ist nicht Ort und Radius</translation>
    </message>
    <message>
        <source>holds a negative variance</source>
        <translation>enthält eine negative Varianz</translation>
    </message>
    <message>
        <source>is of another model, other landmarks, stiffness or points</source>
        <translation>gehört zu anderem Modell, anderen Landmarken, anderer Steifigkeit oder anderen Punkten</translation>
    </message>
    <message>
        <source>the parenchyma&apos;s is said twice</source>
        <translation>die des Parenchyms ist zweimal gesagt</translation>
    </message>
    <message>
        <source>Leave it out, or --materials and --young</source>
        <translation>Lassen Sie sie weg, oder --materials und --young</translation>
    </message>
    <message>
        <source>needs a folder</source>
        <translation>braucht einen Ordner</translation>
    </message>
    <message>
        <source>Give --surfaces-out FOLDER</source>
        <translation>Geben Sie --surfaces-out ORDNER an</translation>
    </message>
    <message>
        <source>needs what was known</source>
        <translation>braucht, was bekannt war</translation>
    </message>
    <message>
        <source>Give --track NAME.frames.jsonl</source>
        <translation>Geben Sie --track NAME.frames.jsonl an</translation>
    </message>
    <message>
        <source>names what is no lesion</source>
        <translation>nennt, was keine Läsion ist</translation>
    </message>
    <message>
        <source>is not an object</source>
        <translation>ist kein Objekt</translation>
    </message>
    <message>
        <source>is not a list</source>
        <translation>ist keine Liste</translation>
    </message>
    <message>
        <source>is no text</source>
        <translation>ist kein Text</translation>
    </message>
    <message>
        <source>is not of the right kind</source>
        <translation>ist nicht von der richtigen Art</translation>
    </message>
    <message>
        <source>is unknown</source>
        <translation>ist unbekannt</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, which is unknown</source>
        <translation>ist „%1“, das ist unbekannt</translation>
    </message>
    <message>
        <source>is none that is known</source>
        <translation>ist nicht bekannt</translation>
    </message>
    <message>
        <source>is not that of an atlas</source>
        <translation>ist nicht das eines Atlas</translation>
    </message>
    <message>
        <source>holds something else than texts</source>
        <translation>enthält anderes als Texte</translation>
    </message>
    <message>
        <source>holds something else than numbers</source>
        <translation>enthält anderes als Zahlen</translation>
    </message>
    <message>
        <source>holds something else than numbers above 0</source>
        <translation>enthält anderes als Zahlen über 0</translation>
    </message>
    <message>
        <source>needs %1 rows</source>
        <translation>braucht %1 Zeilen</translation>
    </message>
    <message>
        <source>needs %1 numbers a row</source>
        <translation>braucht %1 Zahlen je Zeile</translation>
    </message>
    <message>
        <source>needs six numbers a point</source>
        <translation>braucht sechs Zahlen je Punkt</translation>
    </message>
    <message>
        <source>needs one entry a member, three at least</source>
        <translation>braucht einen Eintrag je Mitglied, mindestens drei</translation>
    </message>
    <message>
        <source>is below 1</source>
        <translation>ist unter 1</translation>
    </message>
    <message>
        <source>are fewer than 3</source>
        <translation>sind weniger als 3</translation>
    </message>
    <message>
        <source>holds no squares in its first three columns</source>
        <translation>enthält in den ersten drei Spalten keine Quadrate</translation>
    </message>
    <message>
        <source>has no shape that could be kept</source>
        <translation>hat keine Form, die man behalten könnte</translation>
    </message>
    <message>
        <source>Build on another atlas</source>
        <translation>Auf einem anderen Atlas aufbauen</translation>
    </message>
    <message>
        <source>are none</source>
        <translation>sind keine</translation>
    </message>
    <message>
        <source>are not as many as covariances and sources</source>
        <translation>sind nicht so viele wie Kovarianzen und Quellen</translation>
    </message>
    <message>
        <source>are not as many as the structure has</source>
        <translation>sind nicht so viele, wie die Struktur hat</translation>
    </message>
    <message>
        <source>holds a matrix that is no covariance</source>
        <translation>enthält eine Matrix, die keine Kovarianz ist</translation>
    </message>
    <message>
        <source>name a structure twice</source>
        <translation>nennen eine Struktur zweimal</translation>
    </message>
    <message>
        <source>name a structure that is not there</source>
        <translation>nennen eine Struktur, die es nicht gibt</translation>
    </message>
    <message>
        <source>is the structure itself</source>
        <translation>ist die Struktur selbst</translation>
    </message>
    <message>
        <source>is no point of that structure</source>
        <translation>ist kein Punkt dieser Struktur</translation>
    </message>
    <message>
        <source>needs nine numbers a point</source>
        <translation>braucht neun Zahlen je Punkt</translation>
    </message>
    <message>
        <source>entry %1 holds something that is not a number</source>
        <translation>Eintrag %1 enthält etwas, das keine Zahl ist</translation>
    </message>
    <message>
        <source>entry %1 is not a triple</source>
        <translation>Eintrag %1 hat nicht drei Zahlen</translation>
    </message>
    <message>
        <source>entry %1 is nowhere near a patient</source>
        <translation>Eintrag %1 liegt weit weg von jedem Patienten</translation>
    </message>
    <message>
        <source>has an entry that is not of six numbers</source>
        <translation>hat einen Eintrag, der nicht sechs Zahlen hat</translation>
    </message>
    <message>
        <source>has an entry that is not a number</source>
        <translation>hat einen Eintrag, der keine Zahl ist</translation>
    </message>
    <message>
        <source>holds %1 cells, not %2 x %3</source>
        <translation>enthält %1 Zellen, nicht %2 x %3</translation>
    </message>
    <message>
        <source>is of %1 points, whole.ply holds %2</source>
        <translation>gilt für %1 Punkte, whole.ply enthält %2</translation>
    </message>
    <message>
        <source>is %1, that of the case&apos;s pictures %2</source>
        <translation>ist %1, die der Bilder des Falls %2</translation>
    </message>
    <message>
        <source>says that they are of the case&apos;s pictures, there are none</source>
        <translation>sagt, sie seien aus den Bildern des Falls, aber es gibt keine</translation>
    </message>
    <message>
        <source>is not a key of a load file</source>
        <translation>ist kein Schlüssel einer Lastdatei</translation>
    </message>
    <message>
        <source>is not three numbers</source>
        <translation>hat nicht drei Zahlen</translation>
    </message>
    <message>
        <source>is not three finite numbers</source>
        <translation>hat nicht drei endliche Zahlen</translation>
    </message>
    <message>
        <source>is zero</source>
        <translation>ist null</translation>
    </message>
    <message>
        <source>is %1 Pa</source>
        <translation>ist %1 Pa</translation>
    </message>
    <message>
        <source>holds %1, which is no index</source>
        <translation>enthält %1, das ist kein Index</translation>
    </message>
    <message>
        <source>holds no load</source>
        <translation>enthält keine Last</translation>
    </message>
    <message>
        <source>has no place</source>
        <translation>hat keinen Ort</translation>
    </message>
    <message>
        <source>has several places</source>
        <translation>hat mehrere Orte</translation>
    </message>
    <message>
        <source>lies above high_mm</source>
        <translation>liegt über high_mm</translation>
    </message>
    <message>
        <source>is above 180</source>
        <translation>ist über 180</translation>
    </message>
    <message>
        <source>names no ball, box or direction</source>
        <translation>nennt keine Kugel, keinen Quader und keine Richtung</translation>
    </message>
    <message>
        <source>names no nodes</source>
        <translation>nennt keine Knoten</translation>
    </message>
    <message>
        <source>stands beside a region</source>
        <translation>steht neben einem Gebiet</translation>
    </message>
    <message>
        <source>stands beside from or to</source>
        <translation>steht neben from oder to</translation>
    </message>
    <message>
        <source>stands beside structure</source>
        <translation>steht neben structure</translation>
    </message>
    <message>
        <source>SCALARS have no LOOKUP_TABLE</source>
        <translation>SCALARS haben keine LOOKUP_TABLE</translation>
    </message>
    <message>
        <source>SCALARS have no number of components</source>
        <translation>SCALARS haben keine Zahl der Komponenten</translation>
    </message>
    <message>
        <source>an array stands before POINT_DATA and CELL_DATA</source>
        <translation>ein Feld steht vor POINT_DATA und CELL_DATA</translation>
    </message>
    <message>
        <source>announces %1 cells and holds %2</source>
        <translation>kündigt %1 Zellen an und enthält %2</translation>
    </message>
    <message>
        <source>announces %1 items, more than the file holds</source>
        <translation>kündigt %1 Einträge an, mehr als die Datei enthält</translation>
    </message>
    <message>
        <source>announces more cells than the mesh of an organ needs</source>
        <translation>kündigt mehr Zellen an, als das Netz eines Organs braucht</translation>
    </message>
    <message>
        <source>announces more numbers than a mesh needs</source>
        <translation>kündigt mehr Zahlen an, als ein Netz braucht</translation>
    </message>
    <message>
        <source>announces more numbers than the file holds</source>
        <translation>kündigt mehr Zahlen an, als die Datei enthält</translation>
    </message>
    <message>
        <source>announces more blocks than the file holds</source>
        <translation>kündigt mehr Blöcke an, als die Datei enthält</translation>
    </message>
    <message>
        <source>announces a block larger than it can be</source>
        <translation>kündigt einen Block an, der größer ist, als er sein kann</translation>
    </message>
    <message>
        <source>has no points</source>
        <translation>hat keine Punkte</translation>
    </message>
    <message>
        <source>cell %1 has no points</source>
        <translation>Zelle %1 hat keine Punkte</translation>
    </message>
    <message>
        <source>cell %1 has a list longer than the section</source>
        <translation>Zelle %1 hat eine Liste, die länger als der Abschnitt ist</translation>
    </message>
    <message>
        <source>cell %1 has offsets out of range</source>
        <translation>Zelle %1 hat Anfänge außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>cells have no CONNECTIVITY</source>
        <translation>Zellen haben keine CONNECTIVITY</translation>
    </message>
    <message>
        <source>cells have no OFFSETS</source>
        <translation>Zellen haben keine OFFSETS</translation>
    </message>
    <message>
        <source>has %1 cells and %2 cell types</source>
        <translation>hat %1 Zellen und %2 Zellarten</translation>
    </message>
    <message>
        <source>has cells without CELL_TYPES</source>
        <translation>hat Zellen ohne CELL_TYPES</translation>
    </message>
    <message>
        <source>holds a %1, neither POLYDATA nor UNSTRUCTURED_GRID</source>
        <translation>enthält %1, weder POLYDATA noch UNSTRUCTURED_GRID</translation>
    </message>
    <message>
        <source>holds an array of strings; remove it (&quot;%1&quot;)</source>
        <translation>enthält ein Feld mit Texten („%1“); entfernen Sie es</translation>
    </message>
    <message>
        <source>is neither ASCII nor BINARY</source>
        <translation>ist weder ASCII noch BINARY</translation>
    </message>
    <message>
        <source>the cells hold a number that is not whole or far too large</source>
        <translation>die Zellen enthalten eine Zahl, die nicht ganz oder viel zu groß ist</translation>
    </message>
    <message>
        <source>unknown number type &quot;%1&quot;</source>
        <translation>unbekannter Zahlentyp „%1“</translation>
    </message>
    <message>
        <source>unknown section &quot;%1&quot;</source>
        <translation>unbekannter Abschnitt „%1“</translation>
    </message>
    <message>
        <source>a tetrahedron names a node that is not there</source>
        <translation>ein Tetraeder nennt einen Knoten, den es nicht gibt</translation>
    </message>
    <message>
        <source>holds volume elements of gmsh type %1; save linear tetrahedra only</source>
        <translation>enthält Volumenelemente vom gmsh-Typ %1; speichern Sie nur lineare Tetraeder</translation>
    </message>
    <message>
        <source>is a binary gmsh file; save it as ascii</source>
        <translation>ist eine binäre gmsh-Datei; speichern Sie sie als Text (ascii)</translation>
    </message>
    <message>
        <source>is of gmsh format %1; save it in version 2 or 4</source>
        <translation>ist vom gmsh-Format %1; speichern Sie es in Version 2 oder 4</translation>
    </message>
    <message>
        <source>a face has fewer than three vertices</source>
        <translation>eine Fläche hat weniger als drei Eckpunkte</translation>
    </message>
    <message>
        <source>a face names a vertex that is not there</source>
        <translation>eine Fläche nennt einen Eckpunkt, den es nicht gibt</translation>
    </message>
    <message>
        <source>a face names no vertex number</source>
        <translation>eine Fläche nennt keine Nummer eines Eckpunkts</translation>
    </message>
    <message>
        <source>a vertex needs three numbers</source>
        <translation>ein Eckpunkt braucht drei Zahlen</translation>
    </message>
    <message>
        <source>the file ends inside a facet</source>
        <translation>die Datei endet in einer Facette</translation>
    </message>
    <message>
        <source>the file ends inside binary data</source>
        <translation>die Datei endet in binären Daten</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no entry of a PLY header</source>
        <translation>„%1“ ist kein Eintrag eines PLY-Kopfes</translation>
    </message>
    <message>
        <source>a list&apos;s count has no integer type</source>
        <translation>die Anzahl einer Liste hat keinen ganzzahligen Typ</translation>
    </message>
    <message>
        <source>a property has no name</source>
        <translation>eine Eigenschaft hat keinen Namen</translation>
    </message>
    <message>
        <source>a property stands before any element</source>
        <translation>eine Eigenschaft steht vor jedem Element</translation>
    </message>
    <message>
        <source>an element has no valid count</source>
        <translation>ein Element hat keine gültige Anzahl</translation>
    </message>
    <message>
        <source>element %1 comes a second time</source>
        <translation>Element %1 kommt ein zweites Mal</translation>
    </message>
    <message>
        <source>property %1 comes a second time</source>
        <translation>Eigenschaft %1 kommt ein zweites Mal</translation>
    </message>
    <message>
        <source>no format was named</source>
        <translation>kein Format ist genannt</translation>
    </message>
    <message>
        <source>the file ends before end_header</source>
        <translation>die Datei endet vor end_header</translation>
    </message>
    <message>
        <source>unknown format &quot;%1&quot;</source>
        <translation>unbekanntes Format „%1“</translation>
    </message>
    <message>
        <source>unknown property type &quot;%1&quot;</source>
        <translation>unbekannter Typ „%1“ einer Eigenschaft</translation>
    </message>
    <message>
        <source>expected a number, found %1</source>
        <translation>erwartet ist eine Zahl, gefunden wurde %1</translation>
    </message>
    <message>
        <source>expected a whole number, found %1</source>
        <translation>erwartet ist eine ganze Zahl, gefunden wurde %1</translation>
    </message>
    <message>
        <source>an array is closed by another element</source>
        <translation>ein Feld wird von einem anderen Element geschlossen</translation>
    </message>
    <message>
        <source>closes %1, which is not open</source>
        <translation>schließt %1, das nicht offen ist</translation>
    </message>
    <message>
        <source>elements lie in elements too deeply</source>
        <translation>Elemente liegen zu tief in Elementen</translation>
    </message>
    <message>
        <source>ends early, or is no base64</source>
        <translation>endet zu früh oder ist kein base64</translation>
    </message>
    <message>
        <source>ends inside a number</source>
        <translation>endet in einer Zahl</translation>
    </message>
    <message>
        <source>ends inside an array</source>
        <translation>endet in einem Feld</translation>
    </message>
    <message>
        <source>ends inside %1</source>
        <translation>endet in %1</translation>
    </message>
    <message>
        <source>has a type that is none</source>
        <translation>hat eine Art, die es nicht gibt</translation>
    </message>
    <message>
        <source>has an encoding that is none</source>
        <translation>hat eine Kodierung, die es nicht gibt</translation>
    </message>
    <message>
        <source>has no beginning or no end</source>
        <translation>hat keinen Anfang oder kein Ende</translation>
    </message>
    <message>
        <source>has no offset</source>
        <translation>hat keinen Anfang (offset)</translation>
    </message>
    <message>
        <source>has offsets out of range</source>
        <translation>hat Anfänge (offsets) außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>has the format &quot;%1&quot;, which is none</source>
        <translation>hat das Format „%1“, das es nicht gibt</translation>
    </message>
    <message>
        <source>has the type &quot;%1&quot;, which is no number&apos;s</source>
        <translation>hat den Typ „%1“, den keine Zahl hat</translation>
    </message>
    <message>
        <source>have no connectivity, offsets or types</source>
        <translation>haben keine connectivity, offsets oder types</translation>
    </message>
    <message>
        <source>have not three coordinates each</source>
        <translation>haben nicht je drei Koordinaten</translation>
    </message>
    <message>
        <source>hold %1 offsets where %2 cells are announced</source>
        <translation>enthalten %1 Anfänge (offsets), angekündigt sind %2 Zellen</translation>
    </message>
    <message>
        <source>holds %1 numbers or more where %2 are announced</source>
        <translation>enthält %1 Zahlen oder mehr, angekündigt sind %2</translation>
    </message>
    <message>
        <source>holds %1 numbers where %2 times %3 are announced</source>
        <translation>enthält %1 Zahlen, angekündigt sind %2 mal %3</translation>
    </message>
    <message>
        <source>holds a number that is not whole, negative or far too large</source>
        <translation>enthält eine Zahl, die nicht ganz, negativ oder viel zu groß ist</translation>
    </message>
    <message>
        <source>holds a packed block that is damaged</source>
        <translation>enthält einen gepackten Block, der beschädigt ist</translation>
    </message>
    <message>
        <source>holds more than a mesh does, with the arrays before it</source>
        <translation>enthält mit den Feldern davor mehr als ein Netz</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, neither UnstructuredGrid nor PolyData</source>
        <translation>ist „%1“, weder UnstructuredGrid noch PolyData</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, which is no count</source>
        <translation>ist „%1“, das ist keine Anzahl</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, which is not read</source>
        <translation>ist „%1“, das wird nicht gelesen</translation>
    </message>
    <message>
        <source>is missing: this is no VTK file</source>
        <translation>fehlt: Das ist keine VTK-Datei</translation>
    </message>
    <message>
        <source>lies beyond the file&apos;s end</source>
        <translation>liegt hinter dem Ende der Datei</translation>
    </message>
    <message>
        <source>an instruction does not end</source>
        <translation>eine Anweisung endet nicht</translation>
    </message>
    <message>
        <source>a comment does not end</source>
        <translation>ein Kommentar endet nicht</translation>
    </message>
    <message>
        <source>a tag does not end</source>
        <translation>ein Tag endet nicht</translation>
    </message>
    <message>
        <source>a tag or an attribute has no name</source>
        <translation>ein Tag oder ein Attribut hat keinen Namen</translation>
    </message>
    <message>
        <source>an attribute has no value in quotation marks</source>
        <translation>ein Attribut hat keinen Wert in Anführungszeichen</translation>
    </message>
    <message>
        <source>an attribute holds an entity that is not known</source>
        <translation>ein Attribut enthält ein unbekanntes Zeichenkürzel (&amp;...;)</translation>
    </message>
    <message>
        <source>an attribute&apos;s value does not end</source>
        <translation>der Wert eines Attributs endet nicht</translation>
    </message>
    <message>
        <source>an attribute&apos;s value holds a tag</source>
        <translation>der Wert eines Attributs enthält ein Tag</translation>
    </message>
    <message>
        <source>holds a document type or a section that is not read</source>
        <translation>enthält einen Dokumenttyp oder Abschnitt, der nicht gelesen wird</translation>
    </message>
    <message>
        <source>the attribute %1 has no value</source>
        <translation>das Attribut %1 hat keinen Wert</translation>
    </message>
    <message>
        <source>the attribute %1 stands twice</source>
        <translation>das Attribut %1 steht zweimal da</translation>
    </message>
    <message>
        <source>holds more volume (%1 ml) than the liver in %2 (%3 ml)</source>
        <translation>hat mehr Volumen (%1 ml) als die Leber in %2 (%3 ml)</translation>
    </message>
    <message>
        <source>holds no closed surface of 15 mm3 or more</source>
        <translation>enthält keine geschlossene Oberfläche von 15 mm3 oder mehr</translation>
    </message>
    <message>
        <source>is %1 mm large, the liver %2 mm</source>
        <translation>ist %1 mm groß, die Leber %2 mm</translation>
    </message>
    <message>
        <source>is named twice</source>
        <translation>ist zweimal genannt</translation>
    </message>
    <message>
        <source>is named twice: %1 and %2</source>
        <translation>ist zweimal genannt: %1 und %2</translation>
    </message>
    <message>
        <source>is no structure that is known</source>
        <translation>ist keine bekannte Struktur</translation>
    </message>
    <message>
        <source>is none of mm, cm, m</source>
        <translation>ist weder mm noch cm noch m</translation>
    </message>
    <message>
        <source>is RAS: x and y run the other way than in LPS</source>
        <translation>ist RAS: x und y laufen umgekehrt wie in LPS</translation>
    </message>
    <message>
        <source>the liver lies to the left of the vena cava: mirrored, in RAS, or the liver&apos;s right part was removed</source>
        <translation>die Leber liegt links der Vena cava: gespiegelt, in RAS, oder der rechte Teil der Leber wurde entfernt</translation>
    </message>
    <message>
        <source>Export all surfaces of one patient in one frame (LPS); after a right hepatectomy import them with &apos;glisson model --left-liver&apos;</source>
        <translation>Exportieren Sie alle Oberflächen eines Patienten in einem Koordinatensystem (LPS); nach einer rechten Hemihepatektomie importieren Sie mit &apos;glisson model --left-liver&apos;</translation>
    </message>
    <message>
        <source>lies elsewhere than the liver in %1</source>
        <translation>liegt anderswo als die Leber in %1</translation>
    </message>
    <message>
        <source>names no file</source>
        <translation>nennt keine Datei</translation>
    </message>
    <message>
        <source>the surface is open: it has holes, or edges with more than two triangles</source>
        <translation>die Oberfläche ist offen: Sie hat Löcher oder Kanten mit mehr als zwei Dreiecken</translation>
    </message>
    <message>
        <source>there is no surface of that name</source>
        <translation>es gibt keine Oberfläche dieses Namens</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not three numbers</source>
        <translation>„%1“ hat nicht drei Zahlen</translation>
    </message>
    <message>
        <source>&quot;edit&quot; is none of set_root, prune, join</source>
        <translation>„edit“ ist weder set_root noch prune noch join</translation>
    </message>
    <message>
        <source>has no &quot;%1&quot;</source>
        <translation>hat kein „%1“</translation>
    </message>
    <message>
        <source>is more than %1 million voxels and channels</source>
        <translation>ist mehr als %1 Millionen Voxel und Kanäle</translation>
    </message>
    <message>
        <source>is not two or three numbers</source>
        <translation>hat nicht zwei oder drei Zahlen</translation>
    </message>
    <message>
        <source>names &quot;%1&quot;, which is no label</source>
        <translation>nennt „%1“, das ist kein Label</translation>
    </message>
    <message>
        <source>holds what is no number from %1</source>
        <translation>enthält, was keine Zahl von %1 ist</translation>
    </message>
    <message>
        <source>holds what is no text</source>
        <translation>enthält, was kein Text ist</translation>
    </message>
    <message>
        <source>is no number from %1</source>
        <translation>ist keine Zahl von %1</translation>
    </message>
    <message>
        <source>has not as many numbers as it has rows and columns</source>
        <translation>hat nicht so viele Zahlen, wie es Zeilen und Spalten hat</translation>
    </message>
    <message>
        <source>is not a matrix of a calibration&apos;s size</source>
        <translation>ist keine Matrix von der Größe einer Kalibrierung</translation>
    </message>
    <message>
        <source>is not a matrix of numbers</source>
        <translation>ist keine Matrix aus Zahlen</translation>
    </message>
    <message>
        <source>has %1 vertices, which are no line</source>
        <translation>hat %1 Eckpunkte, das ist keine Linie</translation>
    </message>
    <message>
        <source>has %1 vertices, which enclose nothing</source>
        <translation>hat %1 Eckpunkte, die nichts umschließen</translation>
    </message>
    <message>
        <source>has a vertex that is not [x, y]</source>
        <translation>hat einen Eckpunkt, der nicht [x, y] ist</translation>
    </message>
    <message>
        <source>has a vertex that is not finite</source>
        <translation>hat einen Eckpunkt, der nicht endlich ist</translation>
    </message>
    <message>
        <source>has a vertex that lies far outside any picture</source>
        <translation>hat einen Eckpunkt weit außerhalb jedes Bildes</translation>
    </message>
    <message>
        <source>has a width that is not a positive number of pixels</source>
        <translation>hat eine Breite, die keine positive Zahl von Pixeln ist</translation>
    </message>
    <message>
        <source>has no label</source>
        <translation>hat kein Kennzeichen</translation>
    </message>
    <message>
        <source>has no polygon, and no curve that is a list</source>
        <translation>hat kein Polygon und keine Kurve, die eine Liste ist</translation>
    </message>
    <message>
        <source>is not one that a frame has (16 hexadecimal digits)</source>
        <translation>ist keine, die ein Bild hat (16 hexadezimale Ziffern)</translation>
    </message>
    <message>
        <source>is on no picture of a stereo laparoscope</source>
        <translation>ist auf keinem Bild eines Stereolaparoskops</translation>
    </message>
    <message>
        <source>has a negative number</source>
        <translation>hat eine negative Zahl</translation>
    </message>
    <message>
        <source>holds what is no number of pixels</source>
        <translation>enthält, was keine Zahl von Pixeln ist</translation>
    </message>
    <message>
        <source>is neither true nor false</source>
        <translation>ist weder true noch false</translation>
    </message>
    <message>
        <source>is neither True nor False</source>
        <translation>ist weder True noch False</translation>
    </message>
    <message>
        <source>is no description of a source</source>
        <translation>ist keine Beschreibung einer Quelle</translation>
    </message>
    <message>
        <source>is not [x, y, width, height]</source>
        <translation>ist nicht [x, y, Breite, Höhe]</translation>
    </message>
    <message>
        <source>is not that of a server, which sends both views</source>
        <translation>ist nicht die eines Servers, der beide Ansichten sendet</translation>
    </message>
    <message>
        <source>is one file too many for this layout</source>
        <translation>ist eine Datei zu viel für diese Anordnung</translation>
    </message>
    <message>
        <source>Add it</source>
        <translation>Fügen Sie es hinzu</translation>
    </message>
    <message>
        <source>Write a number</source>
        <translation>Schreiben Sie eine Zahl</translation>
    </message>
    <message>
        <source>Write a finite number</source>
        <translation>Schreiben Sie eine endliche Zahl</translation>
    </message>
    <message>
        <source>Write a list of numbers</source>
        <translation>Schreiben Sie eine Liste von Zahlen</translation>
    </message>
    <message>
        <source>Write a list of texts in quotes</source>
        <translation>Schreiben Sie eine Liste von Texten in Anführungszeichen</translation>
    </message>
    <message>
        <source>Write a text in quotes</source>
        <translation>Schreiben Sie einen Text in Anführungszeichen</translation>
    </message>
    <message>
        <source>Write {&quot;channels&quot;: [...], ...}</source>
        <translation>Schreiben Sie {&quot;channels&quot;: [...], ...}</translation>
    </message>
    <message>
        <source>Write [0, 1, ...]</source>
        <translation>Schreiben Sie [0, 1, ...]</translation>
    </message>
    <message>
        <source>Write [x, y, z]</source>
        <translation>Schreiben Sie [x, y, z]</translation>
    </message>
    <message>
        <source>Give millimetres, at most 10000</source>
        <translation>Millimeter angeben, höchstens 10000</translation>
    </message>
    <message>
        <source>is larger than a load can be</source>
        <translation>ist größer, als eine Last sein kann</translation>
    </message>
    <message>
        <source>Write [{...}, ...]</source>
        <translation>Schreiben Sie [{...}, ...]</translation>
    </message>
    <message>
        <source>Write {...} there</source>
        <translation>Schreiben Sie dort {...}</translation>
    </message>
    <message>
        <source>Give 0-based indices</source>
        <translation>Geben Sie Indizes ab 0 an</translation>
    </message>
    <message>
        <source>Give 0-based node numbers</source>
        <translation>Geben Sie Knotennummern ab 0 an</translation>
    </message>
    <message>
        <source>Give a direction</source>
        <translation>Geben Sie eine Richtung an</translation>
    </message>
    <message>
        <source>Give a node or a point, or leave the target out</source>
        <translation>Geben Sie einen Knoten oder einen Punkt an, oder lassen Sie das Ziel weg</translation>
    </message>
    <message>
        <source>Give a number above 0</source>
        <translation>Geben Sie eine Zahl über 0 an</translation>
    </message>
    <message>
        <source>Give at most 1e5 Pa (12 mmHg are 1600 Pa)</source>
        <translation>Geben Sie höchstens 1e5 Pa an (12 mmHg sind 1600 Pa)</translation>
    </message>
    <message>
        <source>Give at most 10000 N</source>
        <translation>Höchstens 10000 N angeben</translation>
    </message>
    <message>
        <source>Give at most 100 m/s2</source>
        <translation>Höchstens 100 m/s2 angeben</translation>
    </message>
    <message>
        <source>Give at most 1e9 N/m</source>
        <translation>Höchstens 1e9 N/m angeben</translation>
    </message>
    <message>
        <source>Give centre_mm and radius_mm, or low_mm and high_mm</source>
        <translation>Geben Sie centre_mm und radius_mm an, oder low_mm und high_mm</translation>
    </message>
    <message>
        <source>Give change, or to (and from)</source>
        <translation>Geben Sie change an, oder to (und from)</translation>
    </message>
    <message>
        <source>Give gravity, pressure, forces, springs or moved</source>
        <translation>Geben Sie gravity, pressure, forces, springs oder moved an</translation>
    </message>
    <message>
        <source>Give newton_per_metre or structure</source>
        <translation>Geben Sie newton_per_metre oder structure an</translation>
    </message>
    <message>
        <source>Give nodes or a region</source>
        <translation>Geben Sie Knoten oder ein Gebiet an</translation>
    </message>
    <message>
        <source>Give one of node, point_mm, region</source>
        <translation>Geben Sie eines von node, point_mm, region an</translation>
    </message>
    <message>
        <source>Give one or the other</source>
        <translation>Geben Sie eines von beiden an</translation>
    </message>
    <message>
        <source>Give seconds, 0 or more</source>
        <translation>Geben Sie Sekunden an, 0 oder mehr</translation>
    </message>
    <message>
        <source>Give seconds, at most 3600</source>
        <translation>Sekunden angeben, höchstens 3600</translation>
    </message>
    <message>
        <source>Leave it out to press everywhere</source>
        <translation>Lassen Sie es weg, um überall zu drücken</translation>
    </message>
    <message>
        <source>Swap the coordinates</source>
        <translation>Tauschen Sie die Koordinaten</translation>
    </message>
    <message>
        <source>Give at most 180 degrees: every direction</source>
        <translation>Geben Sie höchstens 180 Grad an: jede Richtung</translation>
    </message>
    <message>
        <source>Save it packed by ZLib, or plain</source>
        <translation>Speichern Sie es mit ZLib gepackt, oder ungepackt</translation>
    </message>
    <message>
        <source>Close it (fill its holes) in the program that made it</source>
        <translation>Schließen Sie sie (füllen Sie ihre Löcher) in dem Programm, das sie gemacht hat</translation>
    </message>
    <message>
        <source>Close the surfaces (fill their holes) in the program that made them</source>
        <translation>Schließen Sie die Oberflächen (füllen Sie ihre Löcher) in dem Programm, das sie gemacht hat</translation>
    </message>
    <message>
        <source>Export all surfaces of one patient in one frame (LPS)</source>
        <translation>Exportieren Sie alle Oberflächen eines Patienten in einem Koordinatensystem (LPS)</translation>
    </message>
    <message>
        <source>Give this file&apos;s own unit in the list of surfaces, or export it in the liver&apos;s</source>
        <translation>Geben Sie in der Liste der Oberflächen die Einheit dieser Datei an, oder exportieren Sie sie in der Einheit der Leber</translation>
    </message>
    <message>
        <source>Keep one of them</source>
        <translation>Behalten Sie eines davon</translation>
    </message>
    <message>
        <source>Name the liver&apos;s surface liver.vtk, .vtp, .stl, .obj or .ply</source>
        <translation>Nennen Sie die Oberfläche der Leber liver.vtk, .vtp, .stl, .obj oder .ply</translation>
    </message>
    <message>
        <source>The two are probably swapped: name each file by what it shows</source>
        <translation>Die beiden sind wohl vertauscht: Nennen Sie jede Datei nach dem, was sie zeigt</translation>
    </message>
    <message>
        <source>Write [rows, columns] or [slices, rows, columns]</source>
        <translation>Schreiben Sie [Zeilen, Spalten] oder [Schichten, Zeilen, Spalten]</translation>
    </message>
    <message>
        <source>Write [rows, columns] or [slices, rows, columns], in millimetres</source>
        <translation>Schreiben Sie [Zeilen, Spalten] oder [Schichten, Zeilen, Spalten], in Millimetern</translation>
    </message>
    <message>
        <source>Use smaller tiles</source>
        <translation>Nehmen Sie kleinere Kacheln</translation>
    </message>
    <message>
        <source>Give mean_hu and sd_hu, or neither</source>
        <translation>Geben Sie mean_hu und sd_hu an, oder keines von beiden</translation>
    </message>
    <message>
        <source>Say where slices, rows and columns run to, one each of R or L, A or P, I or S, as &quot;SPL&quot;</source>
        <translation>Sagen Sie, wohin Schichten, Zeilen und Spalten laufen, je eines von R oder L, A oder P, I oder S, wie &quot;SPL&quot;</translation>
    </message>
    <message>
        <source>Use background, parenchyma, portal_vein, hepatic_veins, vena_cava, artery, gallbladder or lesions</source>
        <translation>Nehmen Sie background, parenchyma, portal_vein, hepatic_veins, vena_cava, artery, gallbladder oder lesions</translation>
    </message>
    <message>
        <source>Write one name for each output channel, as [&quot;background&quot;, &quot;parenchyma&quot;]</source>
        <translation>Schreiben Sie je Ausgangskanal einen Namen, etwa [&quot;background&quot;, &quot;parenchyma&quot;]</translation>
    </message>
    <message>
        <source>Write the Hounsfield units that the network was trained on, as [-160, 240]</source>
        <translation>Schreiben Sie die Hounsfield-Einheiten, mit denen das Netz trainiert wurde, etwa [-160, 240]</translation>
    </message>
    <message>
        <source>Click three or more</source>
        <translation>Klicken Sie drei oder mehr</translation>
    </message>
    <message>
        <source>Click two or more</source>
        <translation>Klicken Sie zwei oder mehr</translation>
    </message>
    <message>
        <source>Expected {&quot;image&quot;: &quot;left&quot;, &quot;frame&quot;: 0, &quot;regions&quot;: [{&quot;label&quot;: &quot;surface&quot;, &quot;polygon&quot;: [[x, y], ...]}]}</source>
        <translation>Erwartet wird {&quot;image&quot;: &quot;left&quot;, &quot;frame&quot;: 0, &quot;regions&quot;: [{&quot;label&quot;: &quot;surface&quot;, &quot;polygon&quot;: [[x, y], ...]}]}</translation>
    </message>
    <message>
        <source>Labels are surface, anterior_margin and umbilical_notch</source>
        <translation>Bezeichnungen sind surface, anterior_margin und umbilical_notch</translation>
    </message>
    <message>
        <source>Take it out, or click the regions again</source>
        <translation>Nehmen Sie es heraus, oder klicken Sie die Gebiete noch einmal</translation>
    </message>
    <message>
        <source>Write &quot;left&quot; or &quot;right&quot; as its image</source>
        <translation>Schreiben Sie &quot;left&quot; oder &quot;right&quot; als sein Bild</translation>
    </message>
    <message>
        <source>Expected {&quot;left&quot;: &quot;scope.mkv&quot;, &quot;layout&quot;: &quot;side_by_side&quot; or &quot;top_bottom&quot; or &quot;row_interleaved&quot; or &quot;separate&quot;, ...}</source>
        <translation>Erwartet wird {&quot;left&quot;: &quot;scope.mkv&quot;, &quot;layout&quot;: &quot;side_by_side&quot; oder &quot;top_bottom&quot; oder &quot;row_interleaved&quot; oder &quot;separate&quot;, ...}</translation>
    </message>
    <message>
        <source>Name a video, a folder of pictures or a device</source>
        <translation>Nennen Sie ein Video, einen Ordner mit Bildern oder ein Gerät</translation>
    </message>
    <message>
        <source>Name both devices in one source, as igtl:127.0.0.1:18944/LEFT,RIGHT, without a layout</source>
        <translation>Nennen Sie beide Geräte in einer Quelle, wie igtl:127.0.0.1:18944/LEFT,RIGHT, ohne Anordnung</translation>
    </message>
    <message>
        <source>Separate views have a left and a right source, others one</source>
        <translation>Getrennte Ansichten haben eine linke und eine rechte Quelle, andere nur eine</translation>
    </message>
    <message>
        <source>holds no slice</source>
        <translation>enthält keine Schicht</translation>
    </message>
    <message>
        <source>are shifted against each other across their normal</source>
        <translation>sind quer zu ihrer Normalen gegeneinander verschoben</translation>
    </message>
    <message>
        <source>of one segment lie twice in one slice</source>
        <translation>eines Segments liegen zweimal in einer Schicht</translation>
    </message>
    <message>
        <source>claims more pixels than a segmentation can mean</source>
        <translation>behauptet mehr Pixel, als eine Segmentierung meinen kann</translation>
    </message>
    <message>
        <source>differ in orientation or pixel spacing</source>
        <translation>unterscheiden sich in Ausrichtung oder Pixelgröße</translation>
    </message>
    <message>
        <source>do not lie at equal steps along their normal</source>
        <translation>liegen nicht in gleichen Abständen entlang ihrer Normalen</translation>
    </message>
    <message>
        <source>does not hold one item a frame</source>
        <translation>enthält nicht einen Eintrag je Bild</translation>
    </message>
    <message>
        <source>ends early: the file was cut</source>
        <translation>endet zu früh: Die Datei wurde abgeschnitten</translation>
    </message>
    <message>
        <source>holds %1 bytes where %2 are expected: the file is damaged</source>
        <translation>enthält %1 Bytes, erwartet sind %2: Die Datei ist beschädigt</translation>
    </message>
    <message>
        <source>holds more segments than it can</source>
        <translation>enthält mehr Segmente, als möglich ist</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, of which the border is not known</source>
        <translation>ist „%1“, davon ist die Grenze nicht bekannt</translation>
    </message>
    <message>
        <source>is %1 twice</source>
        <translation>ist zweimal %1</translation>
    </message>
    <message>
        <source>is %1, which is no segment of the file</source>
        <translation>ist %1, das ist kein Segment der Datei</translation>
    </message>
    <message>
        <source>is %1, which no segmentation of bits has</source>
        <translation>ist %1, das hat keine Segmentierung aus Bits</translation>
    </message>
    <message>
        <source>is missing in a file of one slice</source>
        <translation>fehlt in einer Datei mit einer Schicht</translation>
    </message>
    <message>
        <source>is missing in a frame</source>
        <translation>fehlt in einem Bild</translation>
    </message>
    <message>
        <source>is missing in a frame, so that its place in the patient is unknown</source>
        <translation>fehlt in einem Bild, dessen Ort im Patienten deshalb unbekannt ist</translation>
    </message>
    <message>
        <source>is missing or no number</source>
        <translation>fehlt oder ist keine Zahl</translation>
    </message>
    <message>
        <source>says that it is a label map segmentation, which is not read</source>
        <translation>sagt, es sei eine Segmentierung als Labelkarte, die nicht gelesen wird</translation>
    </message>
    <message>
        <source>says that it is no segmentation but another DICOM object</source>
        <translation>sagt, es sei keine Segmentierung, sondern ein anderes DICOM-Objekt</translation>
    </message>
    <message>
        <source>says that the bits are compressed or swapped</source>
        <translation>sagt, die Bits seien gepackt oder vertauscht</translation>
    </message>
    <message>
        <source>claims more than 8192 pixels a side, which no scanner&apos;s slices have</source>
        <translation>behauptet mehr als 8192 Pixel je Seite, so viele hat keine Schicht eines Scanners</translation>
    </message>
    <message>
        <source>holds no series %1, but %2</source>
        <translation>enthält keine Serie %1, sondern %2</translation>
    </message>
    <message>
        <source>holds several series %1, but %2</source>
        <translation>enthält mehrere Serien %1, nämlich %2</translation>
    </message>
    <message>
        <source>names another patient (0010|0010, 0010|0020, 0010|0030) than %1</source>
        <translation>nennt einen anderen Patienten (0010|0010, 0010|0020, 0010|0030) als %1</translation>
    </message>
    <message>
        <source>has rows that are not of length 1</source>
        <translation>hat Zeilen, deren Länge nicht 1 ist</translation>
    </message>
    <message>
        <source>is %1, beyond what the file holds</source>
        <translation>ist %1, mehr als die Datei enthält</translation>
    </message>
    <message>
        <source>is False: voxels as text are not read</source>
        <translation>ist False: Voxel als Text werden nicht gelesen</translation>
    </message>
    <message>
        <source>is not 0</source>
        <translation>ist nicht 0</translation>
    </message>
    <message>
        <source>is not 1</source>
        <translation>ist nicht 1</translation>
    </message>
    <message>
        <source>names no single file of voxels</source>
        <translation>nennt keine einzelne Datei mit Voxeln</translation>
    </message>
    <message>
        <source>are no scale of intensities</source>
        <translation>sind keine Skala von Intensitäten</translation>
    </message>
    <message>
        <source>has an origin that is not finite</source>
        <translation>hat einen Ursprung, der nicht endlich ist</translation>
    </message>
    <message>
        <source>is %1 where the datatype says %2</source>
        <translation>ist %1, der datatype sagt aber %2</translation>
    </message>
    <message>
        <source>is %1, which is no number of voxels</source>
        <translation>ist %1, das ist keine Zahl von Voxeln</translation>
    </message>
    <message>
        <source>is neither 1 nor -1</source>
        <translation>ist weder 1 noch -1</translation>
    </message>
    <message>
        <source>is no place in the file behind its header</source>
        <translation>ist keine Stelle der Datei hinter ihrem Kopf</translation>
    </message>
    <message>
        <source>is no rotation: b, c and d are longer than 1 together</source>
        <translation>ist keine Drehung: b, c und d sind zusammen länger als 1</translation>
    </message>
    <message>
        <source>is no unit of length</source>
        <translation>ist keine Längeneinheit</translation>
    </message>
    <message>
        <source>says %1 mm from voxel to voxel, and the sform %2</source>
        <translation>sagt %1 mm von Voxel zu Voxel, die sform aber %2</translation>
    </message>
    <message>
        <source>says metres</source>
        <translation>sagt Meter</translation>
    </message>
    <message>
        <source>says micrometres</source>
        <translation>sagt Mikrometer</translation>
    </message>
    <message>
        <source>are &quot;%1&quot;</source>
        <translation>sind „%1“</translation>
    </message>
    <message>
        <source>are fewer than there are axes</source>
        <translation>sind weniger, als es Achsen gibt</translation>
    </message>
    <message>
        <source>are of fewer than three axes in space</source>
        <translation>haben weniger als drei Achsen im Raum</translation>
    </message>
    <message>
        <source>are of more than three axes in space</source>
        <translation>haben mehr als drei Achsen im Raum</translation>
    </message>
    <message>
        <source>hold a bracket that is not closed</source>
        <translation>enthalten eine Klammer, die nicht geschlossen ist</translation>
    </message>
    <message>
        <source>holds &quot;%1&quot;, which is no vector</source>
        <translation>enthält „%1“, das ist kein Vektor</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, which is no patient&apos;s</source>
        <translation>ist „%1“, das hat kein Patient</translation>
    </message>
    <message>
        <source>is missing: the file does not say which way the patient lies</source>
        <translation>fehlt: Die Datei sagt nicht, wie herum der Patient liegt</translation>
    </message>
    <message>
        <source>is more than 16</source>
        <translation>ist mehr als 16</translation>
    </message>
    <message>
        <source>is not read here</source>
        <translation>wird hier nicht gelesen</translation>
    </message>
    <message>
        <source>are %1 mm apart between %2 and %3 and %4 mm elsewhere: a slice is missing or the spacing changes</source>
        <translation>sind zwischen %2 und %3 %1 mm auseinander, sonst %4 mm: Eine Schicht fehlt, oder der Abstand wechselt</translation>
    </message>
    <message>
        <source>are shifted against each other by %1 mm from the first to the last (gantry tilt of %2 degrees)</source>
        <translation>sind von der ersten zur letzten um %1 mm gegeneinander verschoben (Neigung der Gantry: %2 Grad)</translation>
    </message>
    <message>
        <source>Choose another series</source>
        <translation>Wählen Sie eine andere Serie</translation>
    </message>
    <message>
        <source>Export it as a binary DICOM segmentation</source>
        <translation>Exportieren Sie es als binäre DICOM-Segmentierung</translation>
    </message>
    <message>
        <source>Export it without compression (Explicit VR Little Endian)</source>
        <translation>Exportieren Sie es ungepackt (Explicit VR Little Endian)</translation>
    </message>
    <message>
        <source>Export the segmentation again</source>
        <translation>Exportieren Sie die Segmentierung noch einmal</translation>
    </message>
    <message>
        <source>Name a DICOM segmentation</source>
        <translation>Nennen Sie eine DICOM-Segmentierung</translation>
    </message>
    <message>
        <source>Name a DICOM segmentation (modality SEG); of a CT open the folder of its slices</source>
        <translation>Nennen Sie eine DICOM-Segmentierung (Modalität SEG); von einem CT öffnen Sie den Ordner seiner Schichten</translation>
    </message>
    <message>
        <source>Resample the segmentation to the CT&apos;s grid</source>
        <translation>Rechnen Sie die Segmentierung auf das Gitter des CT um</translation>
    </message>
    <message>
        <source>Export the series again, of one patient</source>
        <translation>Exportieren Sie die Serie noch einmal, von einem Patienten</translation>
    </message>
    <message>
        <source>Export the volume again, as one .mha file</source>
        <translation>Exportieren Sie das Volumen noch einmal, als eine .mha-Datei</translation>
    </message>
    <message>
        <source>Apply it to the voxels</source>
        <translation>Wenden Sie es auf die Voxel an</translation>
    </message>
    <message>
        <source>Correct it to 0</source>
        <translation>Berichtigen Sie es auf 0</translation>
    </message>
    <message>
        <source>Write it with BinaryData = True</source>
        <translation>Schreiben Sie es mit BinaryData = True</translation>
    </message>
    <message>
        <source>Set them to 1 and 0</source>
        <translation>Setzen Sie sie auf 1 und 0</translation>
    </message>
    <message>
        <source>Write it as left-posterior-superior with space directions in mm</source>
        <translation>Schreiben Sie es als left-posterior-superior mit space directions in mm</translation>
    </message>
    <message>
        <source>Write it with the encoding gzip or raw</source>
        <translation>Schreiben Sie es mit der Kodierung gzip oder raw</translation>
    </message>
    <message>
        <source>Write the data without bytes before them</source>
        <translation>Schreiben Sie die Daten ohne Bytes davor</translation>
    </message>
    <message>
        <source>Write the data without lines before them</source>
        <translation>Schreiben Sie die Daten ohne Zeilen davor</translation>
    </message>
    <message>
        <source>is not %1 x %2</source>
        <translation>ist nicht %1 x %2</translation>
    </message>
    <message>
        <source>is %1, which is no number</source>
        <translation>ist %1, das ist keine Zahl</translation>
    </message>
    <message>
        <source>is %1, which is no small whole number</source>
        <translation>ist %1, das ist keine kleine ganze Zahl</translation>
    </message>
    <message>
        <source>is %1, which is no structure</source>
        <translation>ist %1, das ist keine Struktur</translation>
    </message>
    <message>
        <source>is %1, which is no text</source>
        <translation>ist %1, das ist kein Text</translation>
    </message>
    <message>
        <source>is no field that is known here</source>
        <translation>ist kein Feld, das hier bekannt ist</translation>
    </message>
    <message>
        <source>is not made of %1 numbers each</source>
        <translation>besteht nicht aus je %1 Zahlen</translation>
    </message>
    <message>
        <source>has a point that is nowhere near a patient</source>
        <translation>hat einen Punkt weit weg von jedem Patienten</translation>
    </message>
    <message>
        <source>is %1, which is locked</source>
        <translation>ist %1, das ist gesperrt</translation>
    </message>
    <message>
        <source>is the background</source>
        <translation>ist der Hintergrund</translation>
    </message>
    <message>
        <source>runs from %1 to %2</source>
        <translation>reicht von %1 bis %2</translation>
    </message>
    <message>
        <source>are fewer than two with the rivals</source>
        <translation>sind mit den Konkurrenten weniger als zwei</translation>
    </message>
    <message>
        <source>are none that may keep what they win</source>
        <translation>sind keine, die behalten dürfen, was sie gewinnen</translation>
    </message>
    <message>
        <source>name %1, which is no structure</source>
        <translation>nennen %1, das ist keine Struktur</translation>
    </message>
    <message>
        <source>is the label that the branch has</source>
        <translation>ist das Kennzeichen, das der Ast schon hat</translation>
    </message>
    <message>
        <source>has fewer than three points</source>
        <translation>hat weniger als drei Punkte</translation>
    </message>
    <message>
        <source>has fewer than two points</source>
        <translation>hat weniger als zwei Punkte</translation>
    </message>
    <message>
        <source>has a normal that is not of length 1</source>
        <translation>hat eine Normale, deren Länge nicht 1 ist</translation>
    </message>
    <message>
        <source>has a place that is not finite</source>
        <translation>hat eine Stelle, die nicht endlich ist</translation>
    </message>
    <message>
        <source>has an offset that is not finite</source>
        <translation>hat einen Versatz, der nicht endlich ist</translation>
    </message>
    <message>
        <source>is %1 thick</source>
        <translation>ist %1 dick</translation>
    </message>
    <message>
        <source>shows no view of space</source>
        <translation>zeigt keine Ansicht des Raums</translation>
    </message>
    <message>
        <source>is %1 with a high of %2</source>
        <translation>ist %1 bei einer oberen Grenze von %2</translation>
    </message>
    <message>
        <source>has the same place twice (%1 and %2)</source>
        <translation>hat dieselbe Stelle zweimal (%1 und %2)</translation>
    </message>
    <message>
        <source>is below 0.5 mm</source>
        <translation>ist unter 0,5 mm</translation>
    </message>
    <message>
        <source>leaves %1 between %2 and %3, more than 100 mm</source>
        <translation>lässt %1 zwischen %2 und %3, mehr als 100 mm</translation>
    </message>
    <message>
        <source>both places lie on one tree: a join would close a loop</source>
        <translation>beide Stellen liegen auf einem Baum: Eine Verbindung würde einen Ring schließen</translation>
    </message>
    <message>
        <source>lies %1 mm from the nearest vessel</source>
        <translation>liegt %1 mm vom nächsten Gefäß</translation>
    </message>
    <message>
        <source>one place lies on the %1, the other on the %2</source>
        <translation>eine Stelle liegt auf %1, die andere auf %2</translation>
    </message>
    <message>
        <source>the places lie %1 mm apart</source>
        <translation>die Stellen liegen %1 mm auseinander</translation>
    </message>
    <message>
        <source>there is no vessel tree</source>
        <translation>es gibt keinen Gefäßbaum</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not known</source>
        <translation>„%1“ ist nicht bekannt</translation>
    </message>
    <message>
        <source>%1 has %2 markers, too few for this board</source>
        <translation>%1 hat %2 Marken, zu wenige für dieses Muster</translation>
    </message>
    <message>
        <source>is %1 mm</source>
        <translation>ist %1 mm</translation>
    </message>
    <message>
        <source>matches itself but not the calibration (its points lie %1 pixels from their epipolar lines, %2 % of them before the cameras): the calibration is of another laparoscope, or of another zoom or focus</source>
        <translation>passt zu sich, aber nicht zur Kalibrierung (seine Punkte liegen %1 Pixel neben ihren Epipolarlinien, %2 % davon vor den Kameras): Die Kalibrierung gehört zu einem anderen Laparoskop, oder zu anderem Zoom oder anderer Schärfe</translation>
    </message>
    <message>
        <source>Give at least one</source>
        <translation>Geben Sie mindestens einen an</translation>
    </message>
    <message>
        <source>Write three lists of four numbers</source>
        <translation>Schreiben Sie drei Listen von vier Zahlen</translation>
    </message>
    <message>
        <source>Remove it, or correct its name</source>
        <translation>Entfernen Sie es, oder berichtigen Sie den Namen</translation>
    </message>
    <message>
        <source>Use background, parenchyma, portal_vein, hepatic_veins, vena_cava, artery, gallbladder, lesion_1, other_1 and so on</source>
        <translation>Nehmen Sie background, parenchyma, portal_vein, hepatic_veins, vena_cava, artery, gallbladder, lesion_1, other_1 und so weiter</translation>
    </message>
    <message>
        <source>Write a name in quotes</source>
        <translation>Schreiben Sie einen Namen in Anführungszeichen</translation>
    </message>
    <message>
        <source>Write a whole number</source>
        <translation>Schreiben Sie eine ganze Zahl</translation>
    </message>
    <message>
        <source>Write it in square brackets</source>
        <translation>Schreiben Sie es in eckigen Klammern</translation>
    </message>
    <message>
        <source>Write lists of numbers</source>
        <translation>Schreiben Sie Listen von Zahlen</translation>
    </message>
    <message>
        <source>Write true or false</source>
        <translation>Schreiben Sie true oder false</translation>
    </message>
    <message>
        <source>Choose 0, 1 or 2: the voxel axis across the slice</source>
        <translation>Wählen Sie 0, 1 oder 2: die Voxelachse quer zur Schicht</translation>
    </message>
    <message>
        <source>Choose 1 to %1</source>
        <translation>Wählen Sie 1 bis %1</translation>
    </message>
    <message>
        <source>Choose 1 and more: over what is usual</source>
        <translation>Wählen Sie 1 und mehr: über das Übliche hinaus</translation>
    </message>
    <message>
        <source>Choose a low that is not above the high</source>
        <translation>Wählen Sie eine untere Grenze, die nicht über der oberen liegt</translation>
    </message>
    <message>
        <source>Choose a structure</source>
        <translation>Wählen Sie eine Struktur</translation>
    </message>
    <message>
        <source>Choose more than 0 and at most %1</source>
        <translation>Wählen Sie mehr als 0 und höchstens %1</translation>
    </message>
    <message>
        <source>Give points of the CT&apos;s frame</source>
        <translation>Geben Sie Punkte im Koordinatensystem des CT an</translation>
    </message>
    <message>
        <source>Unlock it, or choose another one</source>
        <translation>Entsperren Sie es, oder wählen Sie ein anderes</translation>
    </message>
    <message>
        <source>Choose labels that compete</source>
        <translation>Wählen Sie Kennzeichen, die konkurrieren</translation>
    </message>
    <message>
        <source>Choose one or more to grow</source>
        <translation>Wählen Sie eines oder mehr, die wachsen sollen</translation>
    </message>
    <message>
        <source>Choose structures that have voxels</source>
        <translation>Wählen Sie Strukturen, die Voxel haben</translation>
    </message>
    <message>
        <source>Choose at least a slice&apos;s thickness</source>
        <translation>Wählen Sie mindestens die Dicke einer Schicht</translation>
    </message>
    <message>
        <source>Draw around an area</source>
        <translation>Umfahren Sie eine Fläche</translation>
    </message>
    <message>
        <source>Draw it in the view</source>
        <translation>Zeichnen Sie es in der Ansicht</translation>
    </message>
    <message>
        <source>Give metres</source>
        <translation>Geben Sie Meter an</translation>
    </message>
    <message>
        <source>Give the 3 x 4 matrix of the view</source>
        <translation>Geben Sie die 3 x 4-Matrix der Ansicht an</translation>
    </message>
    <message>
        <source>Normalise it</source>
        <translation>Normieren Sie sie</translation>
    </message>
    <message>
        <source>Choose 0.5 to 8 mm</source>
        <translation>Wählen Sie 0,5 bis 8 mm</translation>
    </message>
    <message>
        <source>Click points between them</source>
        <translation>Klicken Sie Punkte dazwischen</translation>
    </message>
    <message>
        <source>Give the two ends of the gap</source>
        <translation>Geben Sie die beiden Enden der Lücke an</translation>
    </message>
    <message>
        <source>Join trees of one kind</source>
        <translation>Verbinden Sie Bäume einer Art</translation>
    </message>
    <message>
        <source>Point at a vessel of the model</source>
        <translation>Zeigen Sie auf ein Gefäß des Modells</translation>
    </message>
    <message>
        <source>Point at places within 60 mm</source>
        <translation>Zeigen Sie auf Stellen, die höchstens 60 mm auseinander liegen</translation>
    </message>
    <message>
        <source>Point at two different trees</source>
        <translation>Zeigen Sie auf zwei verschiedene Bäume</translation>
    </message>
    <message>
        <source>A marker is smaller than its square</source>
        <translation>Eine Marke ist kleiner als ihr Feld</translation>
    </message>
    <message>
        <source>Check the board&apos;s size and dictionary</source>
        <translation>Prüfen Sie Größe und Wörterbuch des Musters</translation>
    </message>
    <message>
        <source>Count the inner corners: from 3 to 50 a side</source>
        <translation>Zählen Sie die inneren Ecken: 3 bis 50 je Seite</translation>
    </message>
    <message>
        <source>Give OpenCV&apos;s name, such as DICT_4X4_50</source>
        <translation>Geben Sie den Namen von OpenCV an, etwa DICT_4X4_50</translation>
    </message>
    <message>
        <source>Measure the side of a square: up to 200 mm</source>
        <translation>Messen Sie die Seite eines Feldes: bis zu 200 mm</translation>
    </message>
    <message>
        <source>Give a number between -1 and 0.5</source>
        <translation>Geben Sie eine Zahl zwischen -1 und 0,5 an</translation>
    </message>
    <message>
        <source>Give numbers between -1 and 0.5</source>
        <translation>Geben Sie Zahlen zwischen -1 und 0,5 an</translation>
    </message>
    <message>
        <source>Give a relative residual between 0 and 1</source>
        <translation>Geben Sie ein relatives Residuum zwischen 0 und 1 an</translation>
    </message>
    <message>
        <source>Give positive lengths in metres</source>
        <translation>Geben Sie positive Längen in Metern an</translation>
    </message>
    <message>
        <source>Give positive numbers</source>
        <translation>Geben Sie positive Zahlen an</translation>
    </message>
    <message>
        <source>Give a positive length in metres</source>
        <translation>Geben Sie eine positive Länge in Metern an</translation>
    </message>
    <message>
        <source>Give a positive number</source>
        <translation>Geben Sie eine positive Zahl an</translation>
    </message>
    <message>
        <source>Give a positive number of pixels</source>
        <translation>Geben Sie eine positive Zahl von Pixeln an</translation>
    </message>
    <message>
        <source>Give a positive number of seconds</source>
        <translation>Geben Sie eine positive Zahl von Sekunden an</translation>
    </message>
    <message>
        <source>Give a positive number up to %1</source>
        <translation>Geben Sie eine positive Zahl bis %1 an</translation>
    </message>
    <message>
        <source>Give a number from zero</source>
        <translation>Geben Sie eine Zahl ab null an</translation>
    </message>
    <message>
        <source>Give a number from %1 to %2</source>
        <translation>Geben Sie eine Zahl von %1 bis %2 an</translation>
    </message>
    <message>
        <source>Give a length from zero, in metres</source>
        <translation>Geben Sie eine Länge ab null an, in Metern</translation>
    </message>
    <message>
        <source>Give a share above 0, at most 1</source>
        <translation>Geben Sie einen Anteil über 0 und höchstens 1 an</translation>
    </message>
    <message>
        <source>Give a share from 0 to 1</source>
        <translation>Geben Sie einen Anteil von 0 bis 1 an</translation>
    </message>
    <message>
        <source>Give a share up to that of `fresh`</source>
        <translation>Geben Sie einen Anteil bis zu dem von „fresh“ an</translation>
    </message>
    <message>
        <source>Give an odd number from 5</source>
        <translation>Geben Sie eine ungerade Zahl ab 5 an</translation>
    </message>
    <message>
        <source>Give less than lies between two checks</source>
        <translation>Geben Sie weniger an, als zwischen zwei Prüfungen liegt</translation>
    </message>
    <message>
        <source>Give more than one</source>
        <translation>Geben Sie mehr als eins an</translation>
    </message>
    <message>
        <source>Give the margin at least</source>
        <translation>Geben Sie mindestens den Abstand (margin) an</translation>
    </message>
    <message>
        <source>Give %1 or more</source>
        <translation>Geben Sie %1 oder mehr an</translation>
    </message>
    <message>
        <source>Give the server&apos;s port, as 18944</source>
        <translation>Geben Sie den Port des Servers an, etwa 18944</translation>
    </message>
    <message>
        <source>Give up to 100</source>
        <translation>Geben Sie bis zu 100 an</translation>
    </message>
    <message>
        <source>Give up to 60 seconds</source>
        <translation>Geben Sie bis zu 60 Sekunden an</translation>
    </message>
    <message>
        <source>Give up to a second</source>
        <translation>Geben Sie bis zu einer Sekunde an</translation>
    </message>
    <message>
        <source>Give up to a second; 0 is half a frame</source>
        <translation>Geben Sie bis zu einer Sekunde an; 0 ist die Hälfte eines Bildes</translation>
    </message>
    <message>
        <source>has changed since it was looked at</source>
        <translation>hat sich geändert, seit es angesehen wurde</translation>
    </message>
    <message>
        <source>Look at it as it is now, and say it again</source>
        <translation>Sehen Sie es an, wie es jetzt ist, und sagen Sie es noch einmal</translation>
    </message>
    <message>
        <source>is another case</source>
        <translation>ist ein anderer Fall</translation>
    </message>
    <message>
        <source>Choose another name, or say that it is replaced</source>
        <translation>Wählen Sie einen anderen Namen, oder sagen Sie, dass er ersetzt wird</translation>
    </message>
    <message>
        <source>show %1 points of the liver&apos;s surface, at least %2 are needed</source>
        <translation>zeigen %1 Punkte der Leberoberfläche, mindestens %2 sind nötig</translation>
    </message>
    <message>
        <source>Draw a region on its surface, too</source>
        <translation>Zeichnen Sie auch einen Bereich auf ihrer Oberfläche</translation>
    </message>
    <message>
        <source>meet nothing of the model: they lie elsewhere, or their normals point away</source>
        <translation>treffen nichts vom Modell: Sie liegen anderswo, oder ihre Normalen zeigen weg</translation>
    </message>
    <message>
        <source>Give a start that is nearer, or the cloud without normals</source>
        <translation>Geben Sie einen näheren Anfang an, oder die Wolke ohne Normalen</translation>
    </message>
    <message>
        <source>are no regular stack: %1 lies %2 mm from its place</source>
        <translation>sind kein gleichmäßiger Stapel: %1 liegt %2 mm neben ihrem Platz</translation>
    </message>
    <message>
        <source>is no field of a header</source>
        <translation>ist kein Feld eines Dateikopfs</translation>
    </message>
    <message>
        <source>contradicts BinaryDataByteOrderMSB</source>
        <translation>widerspricht BinaryDataByteOrderMSB</translation>
    </message>
    <message>
        <source>is not kept</source>
        <translation>ist nicht aufgehoben</translation>
    </message>
    <message>
        <source>finds no room: the pictures of all moments may take 1 GiB</source>
        <translation>findet keinen Platz: Die Bilder aller Momente dürfen 1 GiB einnehmen</translation>
    </message>
    <message>
        <source>is longer than a title can be</source>
        <translation>ist länger, als ein Titel sein kann</translation>
    </message>
    <message>
        <source>is no time</source>
        <translation>ist kein Zeitpunkt</translation>
    </message>
    <message>
        <source>is that of another moment</source>
        <translation>ist die eines anderen Moments</translation>
    </message>
    <message>
        <source>does not hold one frame</source>
        <translation>enthält nicht genau ein Bild</translation>
    </message>
    <message>
        <source>is not the picture that was kept</source>
        <translation>ist nicht das Bild, das aufgehoben wurde</translation>
    </message>
    <message>
        <source>names a moment twice</source>
        <translation>nennt einen Moment zweimal</translation>
    </message>
    <message>
        <source>holds a number that is not finite</source>
        <translation>enthält eine Zahl, die nicht endlich ist</translation>
    </message>
    <message>
        <source>Keep a moment of the live view first</source>
        <translation>Heben Sie zuerst einen Moment der Live-Ansicht auf</translation>
    </message>
    <message>
        <source>Delete moments that are not needed any more</source>
        <translation>Löschen Sie Momente, die nicht mehr gebraucht werden</translation>
    </message>
    <message>
        <source>Choose it in the list</source>
        <translation>Wählen Sie ihn in der Liste</translation>
    </message>
    <message>
        <source>Choose one of the list</source>
        <translation>Wählen Sie einen aus der Liste</translation>
    </message>
    <message>
        <source>Shorten it to 200 letters</source>
        <translation>Kürzen Sie ihn auf 200 Buchstaben</translation>
    </message>
    <message>
        <source>Keep another frame</source>
        <translation>Heben Sie ein anderes Bild auf</translation>
    </message>
    <message>
        <source>Free some memory</source>
        <translation>Geben Sie Arbeitsspeicher frei</translation>
    </message>
    <message>
        <source>is what the organ is followed from just now</source>
        <translation>ist die, von der aus das Organ gerade verfolgt wird</translation>
    </message>
    <message>
        <source>Stop tracking first</source>
        <translation>Beenden Sie zuerst die Verfolgung</translation>
    </message>
    <message>
        <source>Click it first, or find something else anew</source>
        <translation>Zuerst anklicken oder etwas anderes neu suchen</translation>
    </message>
    <message>
        <source>Unlock it, or find something else anew</source>
        <translation>Entsperren oder etwas anderes neu suchen</translation>
    </message>
    <message>
        <source>waits for a decision</source>
        <translation>wartet auf eine Entscheidung</translation>
    </message>
    <message>
        <source>Decide about it first</source>
        <translation>Entscheiden Sie zuerst darüber</translation>
    </message>
    <message>
        <source>is locked and would be changed</source>
        <translation>ist gesperrt und würde sich ändern</translation>
    </message>
    <message>
        <source>Unlock it first</source>
        <translation>Entsperren Sie es zuerst</translation>
    </message>
</context>
<context>
    <name>Errors</name>
    <message>
        <source>%1: does not exist. Check the path.</source>
        <translation>%1: gibt es nicht. Prüfen Sie den Pfad.</translation>
    </message>
    <message>
        <source>%1: cannot be opened (%2). Check the path.</source>
        <translation>%1: kann nicht geöffnet werden (%2). Prüfen Sie den Pfad.</translation>
    </message>
    <message>
        <source>%1: could not be read to its end. Check the disk.</source>
        <translation>%1: konnte nicht bis zum Ende gelesen werden. Prüfen Sie den Datenträger.</translation>
    </message>
    <message>
        <source>%1: is a folder. Name a file in it.</source>
        <translation>%1: ist ein Ordner. Nennen Sie eine Datei darin.</translation>
    </message>
    <message>
        <source>%1: is a folder, a file is to be written here. Choose another name.</source>
        <translation>%1: ist ein Ordner, hier soll eine Datei geschrieben werden. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>%1: is a device or a pipe, not a file. Choose another name.</source>
        <translation>%1: ist ein Gerät oder eine Pipe, keine Datei. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>%1: its folder does not exist. Create it or choose another.</source>
        <translation>%1: den Ordner dafür gibt es nicht. Legen Sie ihn an oder wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>%1: could not be written (%2). Check permissions and free space.</source>
        <translation>%1: konnte nicht geschrieben werden (%2). Prüfen Sie Rechte und freien Platz.</translation>
    </message>
    <message>
        <source>%1: what was written reads back differently. Check the disk.</source>
        <translation>%1: was geschrieben wurde, liest sich anders zurück. Prüfen Sie den Datenträger.</translation>
    </message>
    <message>
        <source>%1: is a link that leads back to itself. Choose another name.</source>
        <translation>%1: ist ein Verweis, der auf sich selbst führt. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>%1: is a link that another user has put there. Choose another name or folder.</source>
        <translation>%1: ist ein Verweis, den ein anderer Benutzer dort angelegt hat. Wählen Sie einen anderen Namen oder Ordner.</translation>
    </message>
    <message>
        <source>%1: no folder can be made here (%2). Check permissions.</source>
        <translation>%1: hier kann kein Ordner angelegt werden (%2). Prüfen Sie die Rechte.</translation>
    </message>
    <message>
        <source>%1: could not be replaced (%2). Choose another name.</source>
        <translation>%1: konnte nicht ersetzt werden (%2). Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>%1: could not be flushed to disk (%2). Free some space.</source>
        <translation>%1: konnte nicht auf den Datenträger geschrieben werden (%2). Schaffen Sie Platz.</translation>
    </message>
    <message>
        <source>%1: is open for writing by %2. Close it there, or save under another name. If that program runs no longer, remove %3.</source>
        <translation>%1: ist zum Schreiben geöffnet von %2. Schließen Sie es dort, oder speichern Sie unter einem anderen Namen. Läuft jenes Programm nicht mehr, entfernen Sie %3.</translation>
    </message>
    <message>
        <source>%1: cannot be opened for writing: %2 cannot be written. Check the permissions of its folder, or open it for reading.</source>
        <translation>%1: kann nicht zum Schreiben geöffnet werden: %2 kann nicht geschrieben werden. Prüfen Sie die Rechte des Ordners, oder öffnen Sie zum Lesen.</translation>
    </message>
    <message>
        <source>%1: exists and is not a case. Choose another name.</source>
        <translation>%1: gibt es schon und ist kein Fall. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>%1: a case is a folder whose name ends in .glisson. Choose such a name.</source>
        <translation>%1: ein Fall ist ein Ordner, dessen Name auf .glisson endet. Wählen Sie einen solchen Namen.</translation>
    </message>
    <message>
        <source>%1: case.json: is missing: this folder is not a case. Choose a folder NAME.glisson.</source>
        <translation>%1: case.json: fehlt: Dieser Ordner ist kein Fall. Wählen Sie einen Ordner NAME.glisson.</translation>
    </message>
    <message>
        <source>%1: version: is %2, this program reads up to %3. Open it with a newer Glisson.</source>
        <translation>%1: version: ist %2, dieses Programm liest bis %3. Öffnen Sie ihn mit einem neueren Glisson.</translation>
    </message>
    <message>
        <source>%1: %2: is not valid JSON. Correct it there or write the file anew.</source>
        <translation>%1: %2: ist kein gültiges JSON. Berichtigen Sie es dort oder schreiben Sie die Datei neu.</translation>
    </message>
    <message>
        <source>%1: is malformed (%2). Restore the case from a copy.</source>
        <translation>%1: ist fehlerhaft (%2). Stellen Sie den Fall aus einer Kopie wieder her.</translation>
    </message>
    <message>
        <source>%1: the case reads back differently from what was written. Check the disk&apos;s free space; the old case stands.</source>
        <translation>%1: der Fall liest sich anders zurück, als er geschrieben wurde. Prüfen Sie den freien Platz; der alte Fall bleibt.</translation>
    </message>
    <message>
        <source>%1: is no file of the case and could not be kept (%2). Move it elsewhere and save again; the old case stands.</source>
        <translation>%1: ist keine Datei des Falls und konnte nicht bewahrt werden (%2). Verschieben Sie sie und speichern Sie noch einmal; der alte Fall bleibt.</translation>
    </message>
    <message>
        <source>%1: cannot be used (%2). Check the path.</source>
        <translation>%1: kann nicht benutzt werden (%2). Prüfen Sie den Pfad.</translation>
    </message>
    <message>
        <source>%1: cannot be used (%2). Check the permissions of the file and of its folders.</source>
        <translation>%1: kann nicht benutzt werden (%2). Prüfen Sie die Rechte der Datei und ihrer Ordner.</translation>
    </message>
    <message>
        <source>%1: cannot be used (%2). Free some space on the disk.</source>
        <translation>%1: kann nicht benutzt werden (%2). Schaffen Sie Platz auf dem Datenträger.</translation>
    </message>
    <message>
        <source>%1: stopped unexpectedly (%2). The case is as it was.</source>
        <translation>%1: endete unerwartet (%2). Der Fall ist, wie er war.</translation>
    </message>
    <message>
        <source>%1: memory ran out. Close other programs, or take a smaller volume or a coarser mesh.</source>
        <translation>%1: Der Speicher reichte nicht. Schließen Sie andere Programme, oder nehmen Sie ein kleineres Volumen oder ein gröberes Netz.</translation>
    </message>
    <message>
        <source>case: path: the case has never been saved. Choose a folder NAME.glisson to save it to.</source>
        <translation>Fall: Pfad: Der Fall wurde nie gespeichert. Wählen Sie einen Ordner NAME.glisson, in den er gespeichert wird.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>LeftLiverQuestion</name>
    <message>
        <source>Liver left of the vena cava</source>
        <translation>Leber links der Hohlvene</translation>
    </message>
    <message>
        <source>In %1 the liver lies left of the vena cava: has it been operated on (right liver removed), or is the image mirrored?</source>
        <translation>In %1 liegt die Leber links der Hohlvene: Wurde sie operiert (rechte Leber entfernt), oder ist das Bild gespiegelt?</translation>
    </message>
    <message>
        <source>In a mirrored image left and right are exchanged in all that follows. Where you are not sure, import nothing: look at the image, and correct the direction in the file&apos;s header if it is mirrored.</source>
        <translation>In einem gespiegelten Bild sind links und rechts in allem vertauscht, was folgt. Wenn Sie nicht sicher sind, importieren Sie nichts: Sehen Sie das Bild an, und berichtigen Sie die Richtung im Kopf der Datei, wenn es gespiegelt ist.</translation>
    </message>
    <message>
        <source>Operated on: import</source>
        <translation>Operiert: importieren</translation>
    </message>
    <message>
        <source>Mirrored or not sure: do not import</source>
        <translation>Gespiegelt oder nicht sicher: nicht importieren</translation>
    </message>
</context>
<context>
    <name>NamedVideoQuestion</name>
    <message>
        <source>Pictures named by the case</source>
        <translation>Bilder, die der Fall nennt</translation>
    </message>
    <message>
        <source>The case names these pictures. It chose them, nobody on this computer has:</source>
        <translation>Der Fall nennt diese Bilder. Er hat sie gewählt, an diesem Rechner hat es niemand getan:</translation>
    </message>
    <message>
        <source>Open them only if you trust the case. Left out, they stay named in the case, and you can open pictures at any time (Stereo &gt; Open).</source>
        <translation>Öffnen Sie sie nur, wenn Sie dem Fall trauen. Weggelassen bleiben sie im Fall genannt, und Sie können jederzeit Bilder öffnen (Stereo &gt; Öffnen).</translation>
    </message>
    <message>
        <source>Open the pictures</source>
        <translation>Die Bilder öffnen</translation>
    </message>
    <message>
        <source>Leave them out</source>
        <translation>Sie weglassen</translation>
    </message>
</context>
<context>
    <name>LesionTexts</name>
    <message>
        <source>shown</source>
        <translation>gezeigt</translation>
    </message>
    <message>
        <source>region only</source>
        <translation>nur Bereich</translation>
    </message>
    <message>
        <source>not shown</source>
        <translation>nicht gezeigt</translation>
    </message>
    <message>
        <source>±%1 mm</source>
        <translation>±%1 mm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Nearest tracked points</source>
        <translation>Nächste verfolgte Punkte</translation>
    </message>
    <message>
        <source>Nothing near it tracked for</source>
        <translation>In der Nähe nichts verfolgt seit</translation>
    </message>
</context>
<context>
    <name>Notes</name>
    <message>
        <source>The liver is smaller than 400 ml: check it in the slices.</source>
        <translation>Die Leber ist kleiner als 400 ml: in den Schichten prüfen.</translation>
    </message>
    <message>
        <source>%1 ml of tissue that looks like the liver and hangs on it were left out, as another organ. If they are liver, as a lobe behind a tumour is, click in them.</source>
        <translation>%1 ml Gewebe, das wie die Leber aussieht und an ihr hängt, wurden als ein anderes Organ weggelassen. Falls es Leber ist, wie ein Lappen hinter einem Tumor, klicken Sie hinein.</translation>
    </message>
    <message>
        <source>%1 ml of tissue in the liver are darker than it, and nobody clicked there. A tumour or cyst: click it as a lesion. Gallbladder, stomach or bowel: click it as that, or as &quot;not liver&quot;.</source>
        <translation>%1 ml Gewebe in der Leber sind dunkler als sie, und niemand hat dort geklickt. Ein Tumor oder eine Zyste: als Herd anklicken. Gallenblase, Magen oder Darm: als das oder als „Nicht Leber“ anklicken.</translation>
    </message>
    <message>
        <source>The liver ends on the border of the region that was segmented: %1 cm² there are a cut and no surface. Segment a larger region.</source>
        <translation>Die Leber endet am Rand des segmentierten Bereichs: %1 cm² dort sind ein Schnitt und keine Oberfläche. Segmentieren Sie einen größeren Bereich.</translation>
    </message>
    <message>
        <source>The liver is larger than 4000 ml: check it in the slices.</source>
        <translation>Die Leber ist größer als 4000 ml: in den Schichten prüfen.</translation>
    </message>
    <message>
        <source>A separate piece of the liver&apos;s surface was left out (%2 ml).</source>
        <translation>Ein abgetrenntes Stück der Leberoberfläche wurde weggelassen (%2 ml).</translation>
    </message>
    <message>
        <source>Separate specks of liver were left out: %1 (%3 ml).</source>
        <translation>Abgetrennte Leberreste wurden weggelassen: %1 (%3 ml).</translation>
    </message>
    <message>
        <source>No portal vein was found at its seeds: what there was stays.</source>
        <translation>An den Saatpunkten wurde keine Pfortader gefunden: Was da war, bleibt.</translation>
    </message>
    <message>
        <source>No hepatic vein was found at its seeds: what there was stays.</source>
        <translation>An den Saatpunkten wurde keine Lebervene gefunden: Was da war, bleibt.</translation>
    </message>
    <message>
        <source>%1: loose specks left out of the vessel model: %2 (%4 ml). In 3D they are drawn, over the picture with thin branches only.</source>
        <translation>%1: lose Stücke, die im Gefäßmodell fehlen: %2 (%4 ml). In 3D werden sie gezeichnet, über dem Bild nur mit dünnen Ästen.</translation>
    </message>
    <message>
        <source>%1: separate trees in the model: %2.</source>
        <translation>%1: getrennte Bäume im Modell: %2.</translation>
    </message>
    <message>
        <source>Beams along the vessels: %1.</source>
        <translation>Balken entlang der Gefäße: %1.</translation>
    </message>
    <message>
        <source>Vessel nodes just outside the mesh, tied to its surface: %1.</source>
        <translation>Gefäßknoten knapp außerhalb des Netzes, an seine Oberfläche gebunden: %1.</translation>
    </message>
    <message>
        <source>%1 of the %2 beams along the vessels lie outside the mesh and stiffen nothing: check whether vessels and liver belong together.</source>
        <translation>%1 der %2 Balken entlang der Gefäße liegen außerhalb des Netzes und versteifen nichts: Prüfen Sie, ob Gefäße und Leber zusammengehören.</translation>
    </message>
    <message>
        <source>%1 lies outside the liver and was left out.</source>
        <translation>%1 liegt außerhalb der Leber und wurde weggelassen.</translation>
    </message>
    <message>
        <source>%1: %2 % of its volume lie outside the liver or in another lesion; its elements leave that out.</source>
        <translation>%1: %2 % des Volumens liegen außerhalb der Leber oder in einer anderen Läsion; die Elemente lassen das weg.</translation>
    </message>
    <message>
        <source>%1: its surface has holes, or triangles that face the wrong way. For the vessel model each hole was closed straight across: check the vessel&apos;s ends and branches, or mend the surface in the program that made it.</source>
        <translation>%1: Die Oberfläche hat Löcher oder Dreiecke, die verkehrt herum liegen. Für das Gefäßmodell wurde jedes Loch gerade verschlossen: Prüfen Sie Enden und Äste des Gefäßes, oder bessern Sie die Oberfläche in dem Programm aus, das sie gemacht hat.</translation>
    </message>
    <message>
        <source>%1 was left out: only %3 mm³.</source>
        <translation>%1 wurde weggelassen: nur %3 mm³.</translation>
    </message>
    <message>
        <source>Crumbs of lesion surfaces left out: %1.</source>
        <translation>Weggelassene Krümel von Läsionsoberflächen: %1.</translation>
    </message>
    <message>
        <source>%1 (%3 mm across) is too small for elements of its own; it follows the tissue around it.</source>
        <translation>%1 (%3 mm groß) ist zu klein für eigene Elemente und folgt dem umgebenden Gewebe.</translation>
    </message>
    <message>
        <source>%1 got no elements of its own; it follows the tissue around it.</source>
        <translation>%1 hat keine eigenen Elemente und folgt dem umgebenden Gewebe.</translation>
    </message>
    <message>
        <source>The mesh&apos;s surface is not a clean closed one.</source>
        <translation>Die Oberfläche des Netzes ist nicht sauber geschlossen.</translation>
    </message>
    <message>
        <source>The flattest element has an angle of %1°.</source>
        <translation>Das flachste Element hat einen Winkel von %1°.</translation>
    </message>
    <message>
        <source>The mesh has %1 vertices, not as many as asked for.</source>
        <translation>Das Netz hat %1 Knoten, nicht so viele wie gewünscht.</translation>
    </message>
    <message>
        <source>The file %1 was not used: %2 shows the same structure.</source>
        <translation>Die Datei %1 wurde nicht verwendet: %2 zeigt dieselbe Struktur.</translation>
    </message>
    <message>
        <source>The file %1 was not used: its name tells no structure.</source>
        <translation>Die Datei %1 wurde nicht verwendet: Ihr Name nennt keine Struktur.</translation>
    </message>
    <message>
        <source>No anterior margin was found: the registration has one feature less.</source>
        <translation>Es wurde kein Vorderrand gefunden: Der Registrierung fehlt ein Merkmal.</translation>
    </message>
    <message>
        <source>The image ends inside the liver: %1 mm of what looks like its anterior margin are the edge of that cut and were left out. Check the margin there.</source>
        <translation>Das Bild endet in der Leber: %1 mm von dem, was wie ihr Vorderrand aussieht, sind die Kante dieses Schnitts und wurden weggelassen. Prüfen Sie dort den Rand.</translation>
    </message>
    <message>
        <source>Few points show the anterior margin: the position along it is uncertain.</source>
        <translation>Nur wenige Punkte zeigen den Vorderrand: Die Lage entlang des Randes ist unsicher.</translation>
    </message>
    <message>
        <source>The umbilical notch is not marked in both model and picture: the position along the margin is uncertain.</source>
        <translation>Die Nabelkerbe ist nicht in Modell und Bild markiert: Die Lage entlang des Randes ist unsicher.</translation>
    </message>
    <message>
        <source>The rigid start fits the points badly (more than 10 mm).</source>
        <translation>Der starre Start passt schlecht zu den Punkten (mehr als 10 mm).</translation>
    </message>
    <message>
        <source>Two rigid positions fit almost equally well; the better one was taken.</source>
        <translation>Zwei starre Lagen passen fast gleich gut; die bessere wurde genommen.</translation>
    </message>
    <message>
        <source>Two elastic laws explain the points almost equally well, but place the organ differently; the better one was taken.</source>
        <translation>Zwei Elastizitätsgesetze erklären die Punkte fast gleich gut, legen das Organ aber verschieden; das bessere wurde genommen.</translation>
    </message>
    <message>
        <source>The search for contact forces ended before it had come to rest.</source>
        <translation>Die Suche nach Kontaktkräften endete, bevor sie zur Ruhe kam.</translation>
    </message>
    <message>
        <source>Many points do not fit the model and were left aside.</source>
        <translation>Viele Punkte passen nicht zum Modell und blieben außer Betracht.</translation>
    </message>
    <message>
        <source>The model stays more than 5 mm from the points on average.</source>
        <translation>Das Modell bleibt im Mittel mehr als 5 mm von den Punkten entfernt.</translation>
    </message>
    <message>
        <source>Some elements of the mesh turned inside out.</source>
        <translation>Einige Elemente des Netzes haben sich umgestülpt.</translation>
    </message>
    <message>
        <source>The organ was still moving towards the points after the last step.</source>
        <translation>Das Organ bewegte sich nach dem letzten Schritt noch auf die Punkte zu.</translation>
    </message>
    <message>
        <source>The mechanical computation did not come to an end.</source>
        <translation>Die mechanische Rechnung kam zu keinem Ende.</translation>
    </message>
    <message>
        <source>The simulation had not come to rest at its last step.</source>
        <translation>Die Simulation war beim letzten Schritt noch nicht in Ruhe.</translation>
    </message>
    <message>
        <source>Less than a fifth of the organ&apos;s surface was seen: far from it vessels and tumours may be centimetres off.</source>
        <translation>Weniger als ein Fünftel der Organoberfläche wurde gesehen: Weit davon entfernt können Gefäße und Tumoren um Zentimeter falsch liegen.</translation>
    </message>
    <message>
        <source>Two different shapes of the organ explain the points almost equally well; the better one was taken.</source>
        <translation>Zwei verschiedene Formen des Organs erklären die Punkte fast gleich gut; die bessere wurde genommen.</translation>
    </message>
    <message>
        <source>The organ would be bent as in hardly any simulated operation.</source>
        <translation>Das Organ wäre so verformt wie in kaum einer simulierten Operation.</translation>
    </message>
    <message>
        <source>Nothing changed.</source>
        <translation>Nichts hat sich geändert.</translation>
    </message>
    <message>
        <source>There is no empty slice between two that are drawn.</source>
        <translation>Zwischen zwei gemalten Schichten liegt keine leere.</translation>
    </message>
    <message>
        <source>The region reaches the slice&apos;s edge: click where it is enclosed.</source>
        <translation>Das Gebiet reicht an den Rand der Schicht: dort klicken, wo es umschlossen ist.</translation>
    </message>
    <message>
        <source>No label was free for the smallest islands: %1 stayed as they were.</source>
        <translation>Für die kleinsten Inseln war kein Label frei: %1 blieben, wie sie waren.</translation>
    </message>
    <message>
        <source>Both pictures are dark.</source>
        <translation>Beide Bilder sind dunkel.</translation>
    </message>
    <message>
        <source>The left camera shows nothing.</source>
        <translation>Die linke Kamera zeigt nichts.</translation>
    </message>
    <message>
        <source>The right camera shows nothing.</source>
        <translation>Die rechte Kamera zeigt nichts.</translation>
    </message>
    <message>
        <source>Both pictures are the same: one camera is lost.</source>
        <translation>Beide Bilder sind gleich: eine Kamera ist ausgefallen.</translation>
    </message>
    <message>
        <source>Left and right are swapped.</source>
        <translation>Links und rechts sind vertauscht.</translation>
    </message>
    <message>
        <source>The two pictures show nothing in common.</source>
        <translation>Die beiden Bilder zeigen nichts Gemeinsames.</translation>
    </message>
    <message>
        <source>The calibration is of another laparoscope: the pictures&apos; points do not lie on its epipolar lines.</source>
        <translation>Die Kalibrierung gehört zu einem anderen Laparoskop: die Punkte der Bilder liegen nicht auf ihren Epipolarlinien.</translation>
    </message>
    <message>
        <source>The frame before comes once more.</source>
        <translation>Das vorige Bild kommt noch einmal.</translation>
    </message>
    <message>
        <source>The picture is frozen.</source>
        <translation>Das Bild steht still.</translation>
    </message>
    <message>
        <source>The left picture is frozen.</source>
        <translation>Das linke Bild steht still.</translation>
    </message>
    <message>
        <source>The right picture is frozen.</source>
        <translation>Das rechte Bild steht still.</translation>
    </message>
    <message>
        <source>Two frames have changed places.</source>
        <translation>Zwei Bilder haben die Plätze getauscht.</translation>
    </message>
    <message>
        <source>The film is interlaced: the even and the odd rows of a picture show two moments, so that points on what moves are off by its motion in half of a frame&apos;s time. Set the device to progressive, or give --video a description of the source (.json) with &quot;deinterlace&quot;: true.</source>
        <translation>Der Film ist im Zeilensprung aufgenommen: Gerade und ungerade Zeilen eines Bildes zeigen zwei Augenblicke, so dass Punkte auf dem, was sich bewegt, um dessen Bewegung in der halben Zeit eines Bildes falsch liegen. Das Gerät auf Vollbilder (progressiv) stellen, oder --video eine Beschreibung der Quelle (.json) mit &quot;deinterlace&quot;: true geben.</translation>
    </message>
    <message>
        <source>The view %1 fits far worse than the others and was left out.</source>
        <translation>Die Ansicht %1 passt weit schlechter als die anderen und wurde ausgelassen.</translation>
    </message>
    <message>
        <source>Thin side branches left out of the vessel model: %1 (%3 mm together).</source>
        <translation>Dünne Seitenäste, die im Gefäßmodell weggelassen sind: %1 (zusammen %3 mm).</translation>
    </message>
    <message>
        <source>The thickest of them has a radius of %1 mm.</source>
        <translation>Der dickste davon hat einen Radius von %1 mm.</translation>
    </message>
    <message>
        <source>%1: cut off by hand: %3 mm, tips: %5.</source>
        <translation>%1: von Hand abgeschnitten: %3 mm, Enden: %5.</translation>
    </message>
    <message>
        <source>%1: the label has not been reviewed.</source>
        <translation>%1: Das Label ist nicht geprüft.</translation>
    </message>
    <message>
        <source>%1: the label&apos;s review is in progress.</source>
        <translation>%1: Die Prüfung des Labels läuft noch.</translation>
    </message>
    <message>
        <source>%1: the label is still to be reviewed.</source>
        <translation>%1: Das Label ist noch zu prüfen.</translation>
    </message>
    <message>
        <source>The view %1 fits far worse than the others: calibrate again without it.</source>
        <translation>Die Ansicht %1 passt viel schlechter als die anderen: kalibrieren Sie neu ohne sie.</translation>
    </message>
    <message>
        <source>The case was opened without its laparoscope&apos;s calibration: load a right one and reconstruct the surface again; points and registration are out of date. Saved now, the case loses this one. (%*)</source>
        <translation>Der Fall wurde ohne die Kalibrierung seines Laparoskops geöffnet: laden Sie eine richtige und rekonstruieren Sie die Oberfläche neu; Punkte und Registrierung sind veraltet. Wird der Fall jetzt gespeichert, geht diese verloren. (%*)</translation>
    </message>
    <message>
        <source>The case was opened without its cloud of points: reconstruct the surface or import the cloud again. Saved now, the case loses what is left of it. (%*)</source>
        <translation>Der Fall wurde ohne seine Punktwolke geöffnet: rekonstruieren Sie die Oberfläche neu oder importieren Sie die Wolke noch einmal. Wird der Fall jetzt gespeichert, geht verloren, was von ihr übrig ist. (%*)</translation>
    </message>
    <message>
        <source>The case was opened without the points of the whole stereo pair: reconstruct the surface again before regions are changed. Saved now, the case loses what is left of them. (%*)</source>
        <translation>Der Fall wurde ohne die Punkte des ganzen Stereopaars geöffnet: rekonstruieren Sie die Oberfläche neu, bevor Bereiche geändert werden. Wird der Fall jetzt gespeichert, geht verloren, was von ihnen übrig ist. (%*)</translation>
    </message>
    <message>
        <source>The volume measures only %1 mm along its shortest side: a liver is larger.</source>
        <translation>Das Volumen misst an seiner kürzesten Seite nur %1 mm: Eine Leber ist größer.</translation>
    </message>
    <message>
        <source>The volume is %1 mm wide: no scanner is. Check its unit.</source>
        <translation>Das Volumen ist %1 mm breit, breiter als jeder Scanner. Prüfen Sie seine Einheit.</translation>
    </message>
    <message>
        <source>%1 of %2 slices hold nothing but one value: they may have been lost on the way.</source>
        <translation>%1 von %2 Schichten enthalten nur einen einzigen Wert: Sie sind vielleicht unterwegs verloren gegangen.</translation>
    </message>
    <message>
        <source>%1 of %2 slices are the one before over again: some may have been lost on the way.</source>
        <translation>%1 von %2 Schichten wiederholen die vorige: Vielleicht sind welche unterwegs verloren gegangen.</translation>
    </message>
    <message>
        <source>%1 % of the voxels are exactly 0: the volume may be cut off or masked.</source>
        <translation>%1 % der Voxel sind genau 0: Das Volumen ist vielleicht abgeschnitten oder maskiert.</translation>
    </message>
    <message>
        <source>Only %1 % of the voxels have the Hounsfield units of soft tissue. Either this is no CT in Hounsfield units, or the scanner&apos;s rescale slope and intercept were lost on the way. Look at water and muscle in the slices (0 and 50 HU); if they are not so, export the CT again from its DICOM series.</source>
        <translation>Nur %1 % der Voxel haben die Hounsfield-Werte von Weichgewebe. Entweder ist dies kein CT in Hounsfield-Einheiten, oder Skalierung und Achsenabschnitt (Rescale Slope und Intercept) des Scanners gingen unterwegs verloren. Sehen Sie in den Schichten nach Wasser und Muskel (0 und 50 HU); stimmt das nicht, exportieren Sie das CT neu aus seiner DICOM-Serie.</translation>
    </message>
    <message>
        <source>Hardly a voxel has the Hounsfield units of air (%1 %). Either the CT was cropped to tissue, or the scanner&apos;s rescale intercept was lost on the way. Look at water and muscle in the slices (0 and 50 HU); if they are not so, export the CT again from its DICOM series.</source>
        <translation>Kaum ein Voxel hat die Hounsfield-Werte von Luft (%1 %). Entweder wurde das CT auf Gewebe zugeschnitten, oder der Achsenabschnitt (Rescale Intercept) des Scanners ging unterwegs verloren. Sehen Sie in den Schichten nach Wasser und Muskel (0 und 50 HU); stimmt das nicht, exportieren Sie das CT neu aus seiner DICOM-Serie.</translation>
    </message>
    <message>
        <source>Shifted by %1 HU the volume would hold air and soft tissue, as a CT does: the scanner&apos;s intercept was probably lost or added twice. Do not trust what is segmented from such values.</source>
        <translation>Um %1 HU verschoben, enthielte das Volumen Luft und Weichgewebe wie ein CT: Der Achsenabschnitt (Intercept) des Scanners ging wahrscheinlich verloren oder wurde doppelt addiert. Vertrauen Sie dem nicht, was aus solchen Werten segmentiert wird.</translation>
    </message>
    <message>
        <source>The case was opened without its video, which the case has chosen and nobody here. If you trust it, open it yourself (Stereo &gt; Open; on the command line --video of render and overlay). (%*)</source>
        <translation>Der Fall wurde ohne sein Video geöffnet, das der Fall gewählt hat und niemand hier. Öffnen Sie es selbst, wenn Sie ihm trauen (Stereo &gt; Öffnen; auf der Kommandozeile --video von render und overlay). (%*)</translation>
    </message>
    <message>
        <source>The case is open for writing by %*. It was opened for reading here: saved now, it needs another name.</source>
        <translation>Der Fall ist zum Schreiben geöffnet von %*. Hier wurde er zum Lesen geöffnet: Zum Speichern braucht er einen anderen Namen.</translation>
    </message>
    <message>
        <source>The folder around the case cannot be written to. It was opened for reading: save it elsewhere.</source>
        <translation>In den Ordner um den Fall kann nicht geschrieben werden. Er wurde zum Lesen geöffnet: Speichern Sie ihn anderswo.</translation>
    </message>
    <message>
        <source>Others have saved this case since it was opened here. Theirs stays as it is; yours was saved as %*. Compare the two.</source>
        <translation>Andere haben diesen Fall gespeichert, seit er hier geöffnet wurde. Ihrer bleibt, wie er ist; der Ihre wurde gespeichert als %*. Vergleichen Sie die beiden.</translation>
    </message>
    <message>
        <source>A file of the case was changed by another program since it was saved. What it held is kept as %*.</source>
        <translation>Eine Datei des Falls wurde seit dem Speichern von einem anderen Programm geändert. Ihr Inhalt ist aufbewahrt als %*.</translation>
    </message>
    <message>
        <source>The shape that fits the points would turn the organ inside out.</source>
        <translation>Die Form, die zu den Punkten passt, würde das Organ umstülpen.</translation>
    </message>
    <message>
        <source>Liver seed %1 had no effect: nothing joins its surroundings to the rest of the liver. Click between the two, or take it away.</source>
        <translation>Leber-Saatpunkt %1 hatte keine Wirkung: Nichts verbindet seine Umgebung mit der übrigen Leber. Einen Saatpunkt dazwischen setzen oder diesen entfernen.</translation>
    </message>
    <message>
        <source>Liver seed %1 had no effect: %2 lies there. Take one of the two away.</source>
        <translation>Leber-Saatpunkt %1 hatte keine Wirkung: Dort liegt %2. Eines von beiden entfernen.</translation>
    </message>
    <message>
        <source>&quot;Not liver&quot; seed %1 had no effect: %2 lies there. Take one of the two away.</source>
        <translation>Saatpunkt %1 „Nicht Leber“ hatte keine Wirkung: Dort liegt %2. Eines von beiden entfernen.</translation>
    </message>
    <message>
        <source>The cloud&apos;s points scatter by %1 mm about a smooth surface (limit %2 mm).</source>
        <translation>Die Punkte der Wolke streuen um %1 mm um eine glatte Oberfläche (Grenze %2 mm).</translation>
    </message>
    <message>
        <source>The cloud&apos;s mirror image fits as well or nearly so (log odds %1, limit %2): it has not been recognised as this liver.</source>
        <translation>Das Spiegelbild der Wolke passt ebenso gut oder fast (logarithmierte Chance %1, Grenze %2): Sie wurde nicht als diese Leber erkannt.</translation>
    </message>
    <message>
        <source>The registration was refused: what is known contradicts it.</source>
        <translation>Die Registrierung wurde verworfen: Was bekannt ist, widerspricht ihr.</translation>
    </message>
    <message>
        <source>The registration was refused, and somebody uses it nevertheless.</source>
        <translation>Die Registrierung wurde verworfen, und jemand verwendet sie dennoch.</translation>
    </message>
    <message>
        <source>The model has no vena cava: nothing says where the organ is held. Let the atlas propose it.</source>
        <translation>Das Modell hat keine Vena cava: nichts sagt, wo das Organ gehalten wird. Lassen Sie den Atlas sie vorschlagen.</translation>
    </message>
    <message>
        <source>Where the organ is held (vena cava) comes from statistics alone, with a deviation of %1 mm.</source>
        <translation>Wo das Organ gehalten wird (Vena cava), kommt allein aus der Statistik, mit einer Abweichung von %1 mm.</translation>
    </message>
    <message>
        <source>The umbilical notch comes from statistics alone, with a deviation of %1 mm.</source>
        <translation>Die Nabelkerbe stammt allein aus der Statistik, mit einer Abweichung von %1 mm.</translation>
    </message>
    <message>
        <source>%1 % of the anterior margin that the registration uses come from statistics alone.</source>
        <translation>%1 % des Vorderrands, den die Registrierung verwendet, stammen nur aus der Statistik.</translation>
    </message>
    <message>
        <source>%1 % of the proposed anterior margin come from statistics alone: the registration does not use them.</source>
        <translation>%1 % des vorgeschlagenen Vorderrands stammen allein aus der Statistik: Die Registrierung verwendet sie nicht.</translation>
    </message>
    <message>
        <source>This liver&apos;s shape is %1 times as unusual as the atlas knows: the proposals are uncertain.</source>
        <translation>Die Form dieser Leber ist %1-mal so ungewöhnlich, wie der Atlas sie kennt: die Vorschläge sind unsicher.</translation>
    </message>
    <message>
        <source>This liver&apos;s size lies %1 deviations from the atlas&apos; mean: the proposals are uncertain.</source>
        <translation>Die Größe dieser Leber liegt %1 Standardabweichungen vom Mittel des Atlas: die Vorschläge sind unsicher.</translation>
    </message>
    <message>
        <source>The atlas does not fit this liver: %1 mm apart on average.</source>
        <translation>Der Atlas passt nicht auf diese Leber: im Mittel %1 mm Abstand.</translation>
    </message>
    <message>
        <source>The atlas is folded on this liver (%1 % of its surface).</source>
        <translation>Der Atlas ist auf dieser Leber gefaltet (%1 % der Oberfläche).</translation>
    </message>
    <message>
        <source>This liver is turned by %1° against the atlas: check how the patient lies.</source>
        <translation>Diese Leber ist um %1° gegen den Atlas gedreht: prüfen Sie, wie der Patient liegt.</translation>
    </message>
    <message>
        <source>This is not the shape of a whole liver: a part is missing, it is much changed, or left and right are mixed up.</source>
        <translation>Das ist nicht die Form einer ganzen Leber: Ein Teil fehlt, sie ist stark verändert, oder links und rechts sind vertauscht.</translation>
    </message>
    <message>
        <source>The mirror image of this liver fits the atlas nearly as well: check left and right.</source>
        <translation>Das Spiegelbild dieser Leber passt fast ebenso gut auf den Atlas: prüfen Sie links und rechts.</translation>
    </message>
    <message>
        <source>The liver&apos;s surface is open: the proposals are uncertain.</source>
        <translation>Die Oberfläche der Leber ist offen: die Vorschläge sind unsicher.</translation>
    </message>
    <message>
        <source>The liver&apos;s surface has %1 pieces; the largest was taken.</source>
        <translation>Die Oberfläche der Leber hat %1 Teile; das größte wurde genommen.</translation>
    </message>
    <message>
        <source>%1: the image shows it %2 mm from where the atlas expects it. Check the segmentation.</source>
        <translation>%1: Das Bild zeigt es %2 mm von dort, wo der Atlas es erwartet. Prüfen Sie die Segmentierung.</translation>
    </message>
    <message>
        <source>%1: by the portal vein it lies %2 mm from where it was placed by hand. Check both.</source>
        <translation>%1: Nach der Pfortader liegt es %2 mm von dort, wo es von Hand gesetzt wurde. Prüfen Sie beides.</translation>
    </message>
    <message>
        <source>This atlas does not know how one landmark depends on another: none follows what was placed by hand.</source>
        <translation>Dieser Atlas weiß nicht, wie Landmarken voneinander abhängen: Keine folgt dem, was von Hand gesetzt wurde.</translation>
    </message>
    <message>
        <source>The segmented portal vein does not show the umbilical part of its left branch: notch and falciform ligament come from statistics. Is the left branch there?</source>
        <translation>Die segmentierte Pfortader zeigt die Pars umbilicalis ihres linken Astes nicht: Kerbe und Sichelband kommen aus der Statistik. Ist der linke Ast da?</translation>
    </message>
    <message>
        <source>What looks like the portal vein&apos;s umbilical part does not lie where it should, and was not used for the notch: check that portal and hepatic veins are not swapped, and whether the round ligament lies on the right.</source>
        <translation>Was wie die Pars umbilicalis der Pfortader aussieht, liegt nicht dort, wo sie liegen sollte, und wurde für die Kerbe nicht benutzt: Prüfen Sie, ob Pfortader und Lebervenen vertauscht sind und ob das runde Leberband rechts liegt.</translation>
    </message>
    <message>
        <source>The liver %1 differs from the others and counts less.</source>
        <translation>Die Leber %1 weicht von den anderen ab und zählt weniger.</translation>
    </message>
    <message>
        <source>%1: too few livers show it, so that the atlas does not know it.</source>
        <translation>%1: Zu wenige Lebern zeigen es, so dass der Atlas es nicht kennt.</translation>
    </message>
    <message>
        <source>%1: too few livers show it; taken over from the atlas &apos;%2&apos;.</source>
        <translation>%1: Zu wenige Lebern zeigen es; aus dem Atlas „%2“ übernommen.</translation>
    </message>
    <message>
        <source>The image ends inside the liver: %1 cm² of its surface are a cut and no surface. Take a whole CT, or register nothing of what lies there.</source>
        <translation>Das Bild endet in der Leber: %1 cm² ihrer Oberfläche sind ein Schnitt und keine Oberfläche. Nehmen Sie ein ganzes CT, oder registrieren Sie nichts, was dort liegt.</translation>
    </message>
    <message>
        <source>Something denser than any bone, as metal is, lies in %1 slices of the liver or next to them: its streaks may have taken liver away or added to it. Check these slices.</source>
        <translation>Etwas, das dichter ist als jeder Knochen, wie Metall, liegt in %1 Schichten der Leber oder daneben: Seine Streifen haben vielleicht Leber weggenommen oder hinzugefügt. Prüfen Sie diese Schichten.</translation>
    </message>
    <message>
        <source>Points of the cloud that were there twice were left out: %1.</source>
        <translation>Doppelte Punkte der Wolke wurden weggelassen: %1.</translation>
    </message>
    <message>
        <source>Normals of the cloud that faced away from the camera were turned: %1. It saw the side that faces it.</source>
        <translation>Normalen der Punktwolke, die von der Kamera weg zeigten, wurden umgedreht: %1. Sie hat die Seite gesehen, die ihr zugewandt ist.</translation>
    </message>
    <message>
        <source>Points of the cloud at the lens itself were left out: %1. Such a point has no depth.</source>
        <translation>Punkte der Wolke am Objektiv selbst wurden weggelassen: %1. Ein solcher Punkt hat keine Tiefe.</translation>
    </message>
    <message>
        <source>Points of the cloud that lie behind the camera: %1. The organ is registered to them, but no picture shows it there. If they are from OpenGL or VTK, turn them by 180° about x.</source>
        <translation>Punkte der Wolke, die hinter der Kamera liegen: %1. Das Organ wird mit ihnen registriert, aber kein Bild zeigt es dort. Sind sie aus OpenGL oder VTK, drehen Sie sie um 180° um x.</translation>
    </message>
    <message>
        <source>The organ would have to be larger or smaller by %1 % (limit %2 %) to fit the points: check the calibration (distance of the cameras, zoom) and the unit of the cloud.</source>
        <translation>Das Organ müsste um %1 % größer oder kleiner sein (Grenze %2 %), um zu den Punkten zu passen: Prüfen Sie die Kalibrierung (Abstand der Kameras, Zoom) und die Einheit der Wolke.</translation>
    </message>
    <message>
        <source>The CT ends inside the liver (%1 cm² are a cut): there the model has a surface that the organ has not.</source>
        <translation>Das CT endet in der Leber (%1 cm² sind ein Schnitt): Dort hat das Modell eine Oberfläche, die das Organ nicht hat.</translation>
    </message>
    <message>
        <source>The organ is expected to be off by %1 mm on average (limit %2 mm).</source>
        <translation>Das Organ liegt voraussichtlich im Mittel um %1 mm falsch (Grenze %2 mm).</translation>
    </message>
    <message>
        <source>%1 is expected to be off by %2 mm on average (limit %3 mm).</source>
        <translation>%1 liegt voraussichtlich im Mittel um %2 mm falsch (Grenze %3 mm).</translation>
    </message>
    <message>
        <source>%1 % of the points face another way than the model there (limit %2 %).</source>
        <translation>%1 % der Punkte zeigen in eine andere Richtung als dort das Modell (Grenze %2 %).</translation>
    </message>
    <message>
        <source>The marked margin lies %1 mm from the model&apos;s (limit %2 mm).</source>
        <translation>Der markierte Rand liegt %1 mm von dem des Modells entfernt (Grenze %2 mm).</translation>
    </message>
    <message>
        <source>The organ would be bent %1 times as much as operations and tools explain (limit %2).</source>
        <translation>Das Organ wäre %1-mal so stark verformt, wie Operationen und Werkzeuge erklären (Grenze %2).</translation>
    </message>
    <message>
        <source>%1 was not found: nothing at its seeds differs from the liver. What there was of it stays. Drag across it in a slice to tell its diameter, or paint it.</source>
        <translation>%1 wurde nicht gefunden: An ihren Saatpunkten unterscheidet sich nichts von der Leber. Was davon da war, bleibt. Ziehen Sie in einer Schicht quer darüber, um den Durchmesser anzugeben, oder malen Sie sie.</translation>
    </message>
    <message>
        <source>%1: of its seeds, %2 had no effect. Nothing there differs from the liver, and what the others found does not reach there. Paint what is missing.</source>
        <translation>%1: Von ihren Saatpunkten blieben %2 ohne Wirkung. Dort unterscheidet sich nichts von der Leber, und was die anderen fanden, reicht nicht bis dorthin. Malen Sie, was fehlt.</translation>
    </message>
    <message>
        <source>The points are explained by %1 forces of tools (limit %2): by so many nearly anything is.</source>
        <translation>Die Punkte werden durch %1 Kräfte von Werkzeugen erklärt (Grenze %2): mit so vielen lässt sich fast alles erklären.</translation>
    </message>
    <message>
        <source>A person has chosen this place among several; the points alone gave it %1 %.</source>
        <translation>Jemand hat diesen Ort unter mehreren gewählt; die Punkte allein gaben ihm %1 %.</translation>
    </message>
    <message>
        <source>%1 is brighter than the liver: a vein, or a lesion that takes up contrast. Check it in the slices.</source>
        <translation>%1 ist heller als die Leber: eine Vene oder eine Läsion, die Kontrastmittel aufnimmt. In den Schichten prüfen.</translation>
    </message>
    <message>
        <source>%1 is brighter than the liver, and a vein goes on at %2 % of its surface: it may be a piece of that vein. Check it in the slices.</source>
        <translation>%1 ist heller als die Leber, und an %2 % der Oberfläche geht eine Vene weiter: Es kann ein Stück dieser Vene sein. In den Schichten prüfen.</translation>
    </message>
    <message>
        <source>%1: no border was found where its diameter was drawn. It is a ball of that diameter: check it in the slices.</source>
        <translation>%1: Wo der Durchmesser gezogen wurde, fand sich kein Rand. Markiert ist eine Kugel dieses Durchmessers: in den Schichten prüfen.</translation>
    </message>
    <message>
        <source>The image shows no vessel on the way: it was made as thin as can be. Check it in the slices.</source>
        <translation>Das Bild zeigt auf dem Weg kein Gefäß: Es wurde so dünn wie möglich gemacht. Prüfen Sie es in den Schichten.</translation>
    </message>
    <message>
        <source>On %1 % of the way the image shows no radius: it was taken from the rest. Check it there.</source>
        <translation>Auf %1 % des Weges zeigt das Bild keinen Radius: Er wurde vom Rest übernommen. Prüfen Sie es dort.</translation>
    </message>
    <message>
        <source>A file of the case was changed outside of Glisson since it was saved: %*. Check what it holds.</source>
        <translation>Eine Datei des Falls wurde seit dem Sichern außerhalb von Glisson geändert: %*. Prüfen Sie, was sie enthält.</translation>
    </message>
    <message>
        <source>The seeds in the liver are a proposal: look at what is segmented from them, slice by slice.</source>
        <translation>Die Saatpunkte in der Leber sind ein Vorschlag: Sehen Sie Schicht für Schicht an, was daraus segmentiert wird.</translation>
    </message>
    <message>
        <source>By this calibration %1 % of the left picture, from its edges on, has no ray: nothing is drawn there, and points there are wrong. Calibrate with boards in the corners, too, and without k3.</source>
        <translation>Nach dieser Kalibrierung haben %1 % des linken Bildes, von seinen Rändern her, keinen Strahl: Dort wird nichts gezeichnet, und Punkte dort sind falsch. Auch mit Tafeln in den Ecken und ohne k3 kalibrieren.</translation>
    </message>
    <message>
        <source>By this calibration %1 % of the right picture, from its edges on, has no ray: points there are wrong. Calibrate with boards in the corners, too, and without k3.</source>
        <translation>Nach dieser Kalibrierung haben %1 % des rechten Bildes, von seinen Rändern her, keinen Strahl: Punkte dort sind falsch. Auch mit Tafeln in den Ecken und ohne k3 kalibrieren.</translation>
    </message>
    <message>
        <source>The DICOMDIR names files that are not there: slices may be missing. Copy the whole medium. (%*)</source>
        <translation>Die DICOMDIR nennt Dateien, die nicht da sind: Schichten können fehlen. Kopieren Sie den ganzen Datenträger. (%*)</translation>
    </message>
    <message>
        <source>%1: one more look helps most at %2. Expected error then %4 mm instead of %3 mm.</source>
        <translation>%1: Am meisten hilft ein weiterer Blick auf %2. Erwarteter Fehler danach %4 mm statt %3 mm.</translation>
    </message>
    <message>
        <source>%1: mark the anterior margin where it is seen. Expected error then %3 mm instead of %2 mm.</source>
        <translation>%1: Markieren Sie den Vorderrand, wo er zu sehen ist. Erwarteter Fehler danach %3 mm statt %2 mm.</translation>
    </message>
    <message>
        <source>%1: mark the umbilical notch, which is seen. Expected error then %3 mm instead of %2 mm.</source>
        <translation>%1: Markieren Sie die Nabelkerbe, die zu sehen ist. Erwarteter Fehler danach %3 mm statt %2 mm.</translation>
    </message>
    <message>
        <source>the left lobe&apos;s dome</source>
        <translation>die Kuppel des linken Lappens</translation>
    </message>
    <message>
        <source>the left lobe&apos;s underside</source>
        <translation>die Unterseite des linken Lappens</translation>
    </message>
    <message>
        <source>the left lobe&apos;s front</source>
        <translation>die Vorderseite des linken Lappens</translation>
    </message>
    <message>
        <source>the left lobe&apos;s side</source>
        <translation>die Außenseite des linken Lappens</translation>
    </message>
    <message>
        <source>the left lobe&apos;s back</source>
        <translation>die Rückseite des linken Lappens</translation>
    </message>
    <message>
        <source>the right lobe&apos;s dome</source>
        <translation>die Kuppel des rechten Lappens</translation>
    </message>
    <message>
        <source>the right lobe&apos;s underside</source>
        <translation>die Unterseite des rechten Lappens</translation>
    </message>
    <message>
        <source>the right lobe&apos;s front</source>
        <translation>die Vorderseite des rechten Lappens</translation>
    </message>
    <message>
        <source>the right lobe&apos;s side</source>
        <translation>die Außenseite des rechten Lappens</translation>
    </message>
    <message>
        <source>the right lobe&apos;s back</source>
        <translation>die Rückseite des rechten Lappens</translation>
    </message>
    <message>
        <source>the liver&apos;s dome</source>
        <translation>die Kuppel der Leber</translation>
    </message>
    <message>
        <source>the liver&apos;s underside</source>
        <translation>die Unterseite der Leber</translation>
    </message>
    <message>
        <source>the liver&apos;s front</source>
        <translation>die Vorderseite der Leber</translation>
    </message>
    <message>
        <source>the liver&apos;s side</source>
        <translation>die Außenseite der Leber</translation>
    </message>
    <message>
        <source>the liver&apos;s back</source>
        <translation>die Rückseite der Leber</translation>
    </message>
    <message>
        <source>Pieces too small for a lesion became parenchyma: %1.</source>
        <translation>Für eine Läsion zu kleine Stücke wurden Parenchym: %1.</translation>
    </message>
    <message>
        <source>The segmentation names another DICOM frame of reference than the CT, as one of another scan does: check in the slices that it lies on this liver.</source>
        <translation>Die Segmentierung nennt ein anderes DICOM-Bezugssystem als das CT, wie die einer anderen Aufnahme: Prüfen Sie in den Schichten, ob sie auf dieser Leber liegt.</translation>
    </message>
    <message>
        <source>Segments that the file does not say to be anything of the liver were left out: %*.</source>
        <translation>Segmente, von denen die Datei nicht sagt, dass sie zur Leber gehören, wurden weggelassen: %*.</translation>
    </message>
    <message>
        <source>Labels of which the codes say nothing were left out: %*.</source>
        <translation>Labels, über die die Codes nichts sagen, wurden weggelassen: %*.</translation>
    </message>
    <message>
        <source>No label was free for the smallest pieces of %1: %2 stayed with it.</source>
        <translation>Für die kleinsten Stücke von %1 war kein Label frei: %2 blieben dabei.</translation>
    </message>
    <message>
        <source>%1 lay in %2 pieces more than 5 mm apart: each is a lesion of its own now.</source>
        <translation>%1 lag in %2 Stücken, die mehr als 5 mm auseinander liegen: jedes ist jetzt eine eigene Läsion.</translation>
    </message>
    <message>
        <source>%1 lies in %2 pieces more than 5 mm apart, and is judged as one, at the middle of all. Split it into islands and build the model again.</source>
        <translation>%1 liegt in %2 Stücken, die mehr als 5 mm auseinander liegen, und wird als eine beurteilt, in der Mitte von allen. Teilen Sie sie in Inseln und erzeugen Sie das Modell neu.</translation>
    </message>
    <message>
        <source>The mesh does not say what its labels mean. They were taken as Glisson&apos;s own: %*. If they mean something else, write Glisson&apos;s into it: 1 is the parenchyma, 16 the first lesion.</source>
        <translation>Das Netz sagt nicht, was seine Labels bedeuten. Sie wurden als Glissons eigene genommen: %*. Bedeuten sie etwas anderes, schreiben Sie Glissons hinein: 1 ist das Parenchym, 16 die erste Läsion.</translation>
    </message>
    <message>
        <source>The file does not say what its numbers mean. They were taken as Glisson&apos;s own: %*. If they mean something else, import it again by &apos;glisson model --labels FILE --codes FILE&apos;.</source>
        <translation>Die Datei sagt nicht, was ihre Zahlen bedeuten. Sie wurden als Glissons eigene genommen: %*. Bedeuten sie etwas anderes, mit „glisson model --labels DATEI --codes DATEI“ erneut importieren.</translation>
    </message>
    <message>
        <source>With a probability of %1 % (limit %2 %) the organ lies more than 2 cm from here: other places explain the points as well. Mark the notch, show more of the organ, keep this look and add another one, or place it by hand.</source>
        <translation>Mit einer Wahrscheinlichkeit von %1 % (Grenze %2 %) liegt das Organ mehr als 2 cm von hier: Auch andere Lagen erklären die Punkte. Markieren Sie die Kerbe, zeigen Sie mehr vom Organ, merken Sie diesen Blick und fügen Sie einen weiteren hinzu, oder platzieren Sie es von Hand.</translation>
    </message>
    <message>
        <source>%1: nobody has reviewed what is proposed.</source>
        <translation>%1: Niemand hat den Vorschlag geprüft.</translation>
    </message>
    <message>
        <source>%1: what was placed by hand is used instead of the proposal. Clear it to use the proposal.</source>
        <translation>%1: Verwendet wird, was von Hand gesetzt wurde, statt des Vorschlags. Löschen Sie es, um den Vorschlag zu verwenden.</translation>
    </message>
    <message>
        <source>With a probability of %1 % (limit %2 %) the organ has moved or been bent between the looks: no one shape explains them. Forget the earlier looks and register with the present points alone.</source>
        <translation>Mit einer Wahrscheinlichkeit von %1 % (Grenze %2 %) hat sich das Organ zwischen den Blicken bewegt oder verbogen: Keine eine Form erklärt sie. Verwerfen Sie die früheren Blicke und registrieren Sie nur mit den jetzigen Punkten.</translation>
    </message>
    <message>
        <source>The case was opened without the operations that were simulated on its model: the next registration simulates them anew. (%*)</source>
        <translation>Der Fall wurde ohne die Operationen geöffnet, die auf seinem Modell simuliert worden waren: Die nächste Registrierung simuliert sie neu. (%*)</translation>
    </message>
    <message>
        <source>The case %1 was left out: nobody has approved its liver, vena cava, gallbladder or portal vein.</source>
        <translation>Der Fall %1 blieb weg: Niemand hat seine Leber, Vena cava, Gallenblase oder Pfortader freigegeben.</translation>
    </message>
    <message>
        <source>%1 has no elements of its own: its stiffness changes nothing. Build the model finer at lesions.</source>
        <translation>%1 hat keine eigenen Elemente: Ihre Steifigkeit ändert nichts. Das Modell an Läsionen feiner bauen.</translation>
    </message>
    <message>
        <source>The former registration could not be read and was left out (%*).</source>
        <translation>Die frühere Registrierung war nicht lesbar und wurde weggelassen (%*).</translation>
    </message>
    <message>
        <source>%1 is no lesion of this model: what is said of its stiffness is left out.</source>
        <translation>%1 ist keine Läsion dieses Modells: Was über ihre Steifigkeit gesagt ist, wird weggelassen.</translation>
    </message>
    <message>
        <source>%1 ml of the hepatic veins lie outside of the liver: they have grown on into the vena cava. Click the vena cava, too, and segment again.</source>
        <translation>%1 ml der Lebervenen liegen außerhalb der Leber: Sie sind in die Hohlvene weitergewachsen. Klicken Sie auch die Hohlvene an, und segmentieren Sie noch einmal.</translation>
    </message>
    <message>
        <source>No vena cava was found at its seeds: what there was stays.</source>
        <translation>An ihren Klicks wurde keine Hohlvene gefunden: Was da war, bleibt.</translation>
    </message>
    <message>
        <source>The gallbladder has %1 ml, more than a full one mostly has: it may have run on into a cyst, fluid or bowel beside it. Check it in the slices.</source>
        <translation>Die Gallenblase hat %1 ml, mehr als eine volle meist hat: Sie ist vielleicht in eine Zyste, Flüssigkeit oder Darm daneben übergelaufen. In den Schichten prüfen.</translation>
    </message>
    <message>
        <source>Only %1 ml of the vena cava were found: its seeds may lie in a clot or tumour. Click it elsewhere, too, and segment again.</source>
        <translation>Nur %1 ml der Hohlvene wurden gefunden: ihre Saatpunkte liegen vielleicht in einem Gerinnsel oder Tumor. Auch anderswo hineinklicken und neu segmentieren.</translation>
    </message>
    <message>
        <source>%1 ml of the hepatic veins lie outside of the liver: perhaps in a part of the vena cava that its seeds did not find. Click the vena cava there, too, and segment again.</source>
        <translation>%1 ml der Lebervenen liegen außerhalb der Leber: vielleicht in einem Teil der Hohlvene, den deren Saatpunkte nicht fanden. Auch dort in die Hohlvene klicken und neu segmentieren.</translation>
    </message>
    <message>
        <source>No gallbladder was found at its seeds: what there was stays.</source>
        <translation>An ihren Klicks wurde keine Gallenblase gefunden: Was da war, bleibt.</translation>
    </message>
    <message>
        <source>The liver lies to the left of the vena cava: left and right may be swapped in the image.</source>
        <translation>Die Leber liegt links von der Hohlvene: Links und rechts sind im Bild vielleicht vertauscht.</translation>
    </message>
    <message>
        <source>By its shape this liver fits the atlas clearly better with %1 exchanged. Check in the slices, or where the file comes from, that it lies on the patient&apos;s right and its dome towards the head. If not, correct the orientation in the file&apos;s header (surfaces: export them in LPS) and import it again.</source>
        <translation>Ihrer Form nach passt diese Leber deutlich besser zum Atlas, wenn vertauscht ist: %1. Prüfen Sie in den Schichten oder dort, woher die Datei kommt, ob sie rechts im Patienten liegt und ihre Kuppel zum Kopf hin. Wenn nicht, berichtigen Sie die Orientierung im Kopf der Datei (Oberflächen: in LPS exportieren) und importieren Sie sie neu.</translation>
    </message>
    <message>
        <source>left and right</source>
        <translation>links und rechts</translation>
    </message>
    <message>
        <source>front and back</source>
        <translation>vorn und hinten</translation>
    </message>
    <message>
        <source>head and feet</source>
        <translation>Kopf und Füße</translation>
    </message>
    <message>
        <source>left and right, front and back (as between RAS and LPS)</source>
        <translation>links und rechts, vorn und hinten (wie zwischen RAS und LPS)</translation>
    </message>
    <message>
        <source>left and right, head and feet</source>
        <translation>links und rechts, Kopf und Füße</translation>
    </message>
    <message>
        <source>front and back, head and feet</source>
        <translation>vorn und hinten, Kopf und Füße</translation>
    </message>
    <message>
        <source>left and right, front and back, head and feet</source>
        <translation>links und rechts, vorn und hinten, Kopf und Füße</translation>
    </message>
    <message>
        <source>%1 goes on as far as a click looks for its border, and perhaps farther: draw its diameter.</source>
        <translation>%1 reicht so weit, wie ein Klick nach ihrem Rand sucht, und vielleicht weiter: Zeichnen Sie ihren Durchmesser.</translation>
    </message>
    <message>
        <source>%1 comes within %2 mm of the liver&apos;s surface, where the CT does not show its border: whether liver covers it is not known. Check it in the slices.</source>
        <translation>%1 kommt der Leberoberfläche auf weniger als %2 mm nahe, wo das CT ihren Rand nicht zeigt: Ob Leber sie bedeckt, ist nicht bekannt. Prüfen Sie sie in den Schichten.</translation>
    </message>
    <message>
        <source>The portal vein is hardly brighter than the liver where it was clicked: in this phase it cannot be told from it, and most or all of it is missing. Take the portal venous phase.</source>
        <translation>Die Pfortader ist dort, wo sie angeklickt wurde, kaum heller als die Leber: In dieser Phase lässt sie sich nicht von ihr unterscheiden, und das meiste oder alles von ihr fehlt. Nehmen Sie die portalvenöse Phase.</translation>
    </message>
    <message>
        <source>The hepatic veins are hardly brighter than the liver where they were clicked: in this phase they cannot be told from it, and most or all of them are missing. Take the portal venous phase.</source>
        <translation>Die Lebervenen sind dort, wo sie angeklickt wurden, kaum heller als die Leber: In dieser Phase lassen sie sich nicht von ihr unterscheiden, und das meiste oder alles von ihnen fehlt. Nehmen Sie die portalvenöse Phase.</translation>
    </message>
    <message>
        <source>Portal vein seed %1 had no effect: no branch of it was found within 5 mm. Click in the middle of the vein, or take the seed away.</source>
        <translation>Der Saatpunkt %1 der Pfortader hatte keine Wirkung: Im Umkreis von 5 mm wurde kein Ast von ihr gefunden. In die Mitte der Vene klicken oder den Saatpunkt entfernen.</translation>
    </message>
    <message>
        <source>Hepatic vein seed %1 had no effect: no branch of them was found within 5 mm. Click in the middle of a vein, or take the seed away.</source>
        <translation>Der Saatpunkt %1 der Lebervenen hatte keine Wirkung: Im Umkreis von 5 mm wurde kein Ast von ihnen gefunden. In die Mitte einer Vene klicken oder den Saatpunkt entfernen.</translation>
    </message>
    <message>
        <source>The case was opened without a kept moment, which cannot be read. The others are there. Saved now, the case loses what is left of it. (%*)</source>
        <translation>Der Fall wurde ohne einen aufgehobenen Moment geöffnet, der nicht gelesen werden kann. Die anderen sind da. Jetzt gespeichert, verliert der Fall, was von ihm übrig ist. (%*)</translation>
    </message>
    <message>
        <source>The written file&apos;s format holds places only, none of these doubts: name it .vtp or .vtk and they go along.</source>
        <translation>Das Format der geschriebenen Datei enthält nur Orte, keinen dieser Zweifel: Als .vtp oder .vtk benannt nimmt sie sie mit.</translation>
    </message>
</context>
<context>
    <name>Obstacles</name>
    <message>
        <source>Open a CT first.</source>
        <translation>Zuerst ein CT öffnen.</translation>
    </message>
    <message>
        <source>Place at least one seed in the liver.</source>
        <translation>Mindestens einen Saatpunkt in die Leber setzen.</translation>
    </message>
    <message>
        <source>Segment the CT or import labels first.</source>
        <translation>Zuerst das CT segmentieren oder Labels importieren.</translation>
    </message>
    <message>
        <source>Build a model first.</source>
        <translation>Zuerst ein Modell bauen.</translation>
    </message>
    <message>
        <source>Place or accept the landmarks first.</source>
        <translation>Zuerst die Landmarken setzen oder übernehmen.</translation>
    </message>
    <message>
        <source>Load the laparoscope&apos;s calibration first.</source>
        <translation>Zuerst die Kalibrierung des Laparoskops laden.</translation>
    </message>
    <message>
        <source>The case has no stereo video (Stereo, Video…).</source>
        <translation>Der Fall hat kein Stereovideo (Stereo, Video…).</translation>
    </message>
    <message>
        <source>The case names no pictures that nobody here has chosen.</source>
        <translation>Der Fall nennt keine Bilder, die hier niemand gewählt hat.</translation>
    </message>
    <message>
        <source>Load a stereo pair or a video frame first.</source>
        <translation>Zuerst ein Stereobildpaar oder ein Videobild laden.</translation>
    </message>
    <message>
        <source>Reconstruct the surface first (Stereo).</source>
        <translation>Zuerst die Oberfläche rekonstruieren (Stereo).</translation>
    </message>
    <message>
        <source>Register first.</source>
        <translation>Zuerst registrieren.</translation>
    </message>
    <message>
        <source>The labels are out of date: segment or import them again (Segmentation).</source>
        <translation>Die Labels sind veraltet: erneut segmentieren oder importieren (Segmentierung).</translation>
    </message>
    <message>
        <source>The model is out of date: build it again (Model).</source>
        <translation>Das Modell ist veraltet: neu erstellen (Modell).</translation>
    </message>
    <message>
        <source>The model is another one than was checked: look at it again (Model).</source>
        <translation>Das Modell ist ein anderes als das geprüfte: noch einmal ansehen (Modell).</translation>
    </message>
    <message>
        <source>The landmarks are those of another model: look at them and accept them (Landmarks).</source>
        <translation>Die Landmarken gehören zu einem anderen Modell: ansehen und annehmen (Landmarken).</translation>
    </message>
    <message>
        <source>The frame is of a former video: take one of the present video (Stereo).</source>
        <translation>Das Bild stammt aus einem früheren Video: eines des jetzigen nehmen (Stereo).</translation>
    </message>
    <message>
        <source>The regions are those of another frame: draw them again or clear them (Stereo).</source>
        <translation>Die Regionen gehören zu einem anderen Bild: neu zeichnen oder löschen (Stereo).</translation>
    </message>
    <message>
        <source>The points are out of date: reconstruct the surface again (Stereo).</source>
        <translation>Die Punkte sind veraltet: Oberfläche erneut rekonstruieren (Stereo).</translation>
    </message>
    <message>
        <source>The registration is out of date: register again.</source>
        <translation>Die Registrierung ist veraltet: neu registrieren.</translation>
    </message>
    <message>
        <source>There is no %1 yet.</source>
        <translation>Noch nicht vorhanden: %1.</translation>
    </message>
    <message>
        <source>%1 is out of date: make it anew.</source>
        <translation>Nicht mehr aktuell: %1. Neu erstellen.</translation>
    </message>
    <message>
        <source>Let the atlas propose the landmarks first.</source>
        <translation>Lassen Sie zuerst den Atlas die Landmarken vorschlagen.</translation>
    </message>
    <message>
        <source>The proposed landmarks are those of another model: let the atlas propose them again.</source>
        <translation>Die vorgeschlagenen Landmarken gehören zu einem anderen Modell: lassen Sie den Atlas sie neu vorschlagen.</translation>
    </message>
    <message>
        <source>Draw regions on the frame first (Stereo).</source>
        <translation>Zuerst Bereiche auf das Bild zeichnen (Stereo).</translation>
    </message>
    <message>
        <source>Look at the model and say whether it is right first (Model).</source>
        <translation>Zuerst das Modell ansehen und sagen, ob es stimmt (Modell).</translation>
    </message>
    <message>
        <source>Review the labels first (Segmentation).</source>
        <translation>Zuerst die Beschriftung prüfen (Segmentierung).</translation>
    </message>
    <message>
        <source>The registration was refused: register again, or use it nevertheless (see its doubts).</source>
        <translation>Die Registrierung wurde abgelehnt: neu registrieren oder dennoch verwenden (siehe ihre Zweifel).</translation>
    </message>
    <message>
        <source>%1 was refused: make it anew, or accept it.</source>
        <translation>%1 wurde abgelehnt: neu machen oder annehmen.</translation>
    </message>
    <message>
        <source>The seeds are those of another CT: place them again (Segmentation).</source>
        <translation>Die Saatpunkte sind die eines anderen CTs: neu setzen (Segmentierung).</translation>
    </message>
    <message>
        <source>The CT was not opened from its DICOM folder, so whose it is is not known.</source>
        <translation>Das CT wurde nicht aus seinem DICOM-Ordner geöffnet; von wem es ist, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>No new segmentation waits for a decision.</source>
        <translation>Keine neue Segmentierung wartet auf eine Entscheidung.</translation>
    </message>
    <message>
        <source>No earlier look is kept (Stereo).</source>
        <translation>Kein früherer Blick ist gemerkt (Stereo).</translation>
    </message>
    <message>
        <source>There is no former registration to go back to.</source>
        <translation>Es gibt keine frühere Registrierung, zu der man zurückkehren könnte.</translation>
    </message>
    <message>
        <source>Nobody has said how stiff the liver is (Model).</source>
        <translation>Niemand hat gesagt, wie steif die Leber ist (Modell).</translation>
    </message>
    <message>
        <source>No operations have been simulated on this model: register it.</source>
        <translation>Auf diesem Modell wurden keine Operationen simuliert: registrieren Sie es.</translation>
    </message>
    <message>
        <source>No moment of the live view is kept (Guidance).</source>
        <translation>Kein Moment der Live-Ansicht ist aufgehoben (Navigation).</translation>
    </message>
    <message>
        <source>The organ is followed from the place it has now: stop tracking first.</source>
        <translation>Das Organ wird von seinem jetzigen Ort aus verfolgt: Beenden Sie zuerst die Verfolgung.</translation>
    </message>
    <message>
        <source>Nothing is locked (Segmentation).</source>
        <translation>Nichts ist gesperrt (Segmentierung).</translation>
    </message>
</context>
<context>
    <name>Overlay</name>
    <message>
        <source>registered</source>
        <translation>registriert</translation>
    </message>
    <message>
        <source>not registered yet</source>
        <translation>noch nicht registriert</translation>
    </message>
    <message>
        <source>too few points are tracked</source>
        <translation>zu wenige Punkte werden verfolgt</translation>
    </message>
    <message>
        <source>the tracked points contradict one another</source>
        <translation>die verfolgten Punkte widersprechen einander</translation>
    </message>
    <message>
        <source>the model does not fit what the camera sees</source>
        <translation>das Modell passt nicht zu dem, was die Kamera sieht</translation>
    </message>
    <message>
        <source>the mechanical computation failed</source>
        <translation>die mechanische Rechnung ist gescheitert</translation>
    </message>
    <message>
        <source>an earlier step has changed since the registration</source>
        <translation>ein früherer Schritt hat sich seit der Registrierung geändert</translation>
    </message>
    <message>
        <source>No overlay: %1</source>
        <translation>Keine Einblendung: %1</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>Bild %1</translation>
    </message>
    <message>
        <source>age %1 ms</source>
        <translation>Alter %1 ms</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation>%1 Bilder/s</translation>
    </message>
    <message>
        <source>residual %1 mm</source>
        <translation>Restabstand %1 mm</translation>
    </message>
    <message>
        <source>Registration in doubt</source>
        <translation>Registrierung zweifelhaft</translation>
    </message>
    <message>
        <source>Research software: not for clinical use</source>
        <translation>Forschungssoftware: nicht für den klinischen Gebrauch</translation>
    </message>
    <message>
        <source>Portal vein</source>
        <translation>Pfortader</translation>
    </message>
    <message>
        <source>Hepatic veins</source>
        <translation>Lebervenen</translation>
    </message>
    <message>
        <source>Hepatic artery</source>
        <translation>Leberarterie</translation>
    </message>
    <message>
        <source>Lesion</source>
        <translation>Läsion</translation>
    </message>
    <message>
        <source>Model not checked</source>
        <translation>Modell nicht geprüft</translation>
    </message>
    <message>
        <source>the camera sees the organ elsewhere; register again</source>
        <translation>die Kamera sieht das Organ woanders; neu registrieren</translation>
    </message>
    <message>
        <source>the picture stands still; check the camera</source>
        <translation>das Bild steht still; Kamera prüfen</translation>
    </message>
    <message>
        <source>the two views do not show the same moment; check the cameras</source>
        <translation>die beiden Ansichten zeigen nicht denselben Augenblick; Kameras prüfen</translation>
    </message>
    <message>
        <source>the camera sees the organ elsewhere</source>
        <translation>die Kamera sieht das Organ anderswo</translation>
    </message>
    <message>
        <source>the picture stands still</source>
        <translation>das Bild steht still</translation>
    </message>
    <message>
        <source>the two views do not fit together</source>
        <translation>die beiden Ansichten passen nicht zusammen</translation>
    </message>
    <message>
        <source>part of the organ is covered</source>
        <translation>ein Teil des Organs ist verdeckt</translation>
    </message>
    <message>
        <source>the picture has lost light or contrast</source>
        <translation>dem Bild fehlt Licht oder Kontrast</translation>
    </message>
    <message>
        <source>nothing in the picture moves</source>
        <translation>im Bild bewegt sich nichts</translation>
    </message>
    <message>
        <source>Outline and lesions&apos; regions only: %1</source>
        <translation>Nur Umriss und Bereiche der Läsionen: %1</translation>
    </message>
    <message>
        <source>known well enough</source>
        <translation>genau genug bekannt</translation>
    </message>
    <message>
        <source>as the whole overlay</source>
        <translation>wie das ganze Overlay</translation>
    </message>
    <message>
        <source>how far off it may be is not known; register again</source>
        <translation>wie weit sie daneben liegen kann, ist nicht bekannt; neu registrieren</translation>
    </message>
    <message>
        <source>the registration was refused</source>
        <translation>die Registrierung wurde abgelehnt</translation>
    </message>
    <message>
        <source>the registration does not know it better</source>
        <translation>die Registrierung weiß es nicht genauer</translation>
    </message>
    <message>
        <source>the organ has changed its shape, and what is tracked lies far away</source>
        <translation>das Organ hat seine Form geändert, und was verfolgt wird, liegt weit entfernt</translation>
    </message>
    <message>
        <source>nothing near it has been tracked for a while</source>
        <translation>in ihrer Nähe wurde eine Weile nichts verfolgt</translation>
    </message>
    <message>
        <source>Lesion %1</source>
        <translation>Läsion %1</translation>
    </message>
    <message>
        <source>±%1 mm</source>
        <translation>±%1 mm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Depth along the sight</source>
        <translation>Tiefe in Blickrichtung</translation>
    </message>
    <message>
        <source>Depth, shortest way</source>
        <translation>Tiefe, kürzester Weg</translation>
    </message>
    <message>
        <source>Expected error</source>
        <translation>Erwarteter Fehler</translation>
    </message>
    <message>
        <source>95 % within</source>
        <translation>95 % innerhalb</translation>
    </message>
    <message>
        <source>From the mark</source>
        <translation>Von der Marke</translation>
    </message>
    <message>
        <source>valid</source>
        <translation>gültig</translation>
    </message>
    <message>
        <source>known roughly</source>
        <translation>nur ungefähr bekannt</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>%1 not shown: %2</source>
        <translation>%1 nicht gezeigt: %2</translation>
    </message>
    <message>
        <source>%1 as its region only: %2</source>
        <translation>%1 nur als Bereich: %2</translation>
    </message>
    <message>
        <source>VALID</source>
        <translation>GÜLTIG</translation>
    </message>
    <message>
        <source>DEGRADED</source>
        <translation>EINGESCHRÄNKT</translation>
    </message>
    <message>
        <source>WITHDRAWN</source>
        <translation>ZURÜCKGEZOGEN</translation>
    </message>
    <message>
        <source>Other lesions not known well enough: %1</source>
        <translation>Weitere Läsionen nicht genau genug bekannt: %1</translation>
    </message>
    <message>
        <source>Lines: every 10 mm below the surface</source>
        <translation>Linien: alle 10 mm unter der Oberfläche</translation>
    </message>
    <message>
        <source>only proposed, not registered</source>
        <translation>nur vorgeschlagen, nicht registriert</translation>
    </message>
    <message>
        <source>Outline and margin: %1</source>
        <translation>Umriss und Rand: %1</translation>
    </message>
    <message>
        <source>PROPOSED</source>
        <translation>VORGESCHLAGEN</translation>
    </message>
    <message>
        <source>NOT LIVE</source>
        <translation>NICHT LIVE</translation>
    </message>
    <message>
        <source>the mask network takes most of the organ for something else</source>
        <translation>das Maskennetz hält das meiste des Organs für etwas anderes</translation>
    </message>
    <message>
        <source>one of the two views shows nothing, or too little</source>
        <translation>eine der beiden Ansichten zeigt nichts oder zu wenig</translation>
    </message>
    <message>
        <source>left and right view seem to be swapped</source>
        <translation>linke und rechte Ansicht scheinen vertauscht zu sein</translation>
    </message>
    <message>
        <source>too little can be made out in the picture</source>
        <translation>im Bild ist zu wenig zu erkennen</translation>
    </message>
    <message>
        <source>Wipe the lens of that view; check its camera and cable.</source>
        <translation>Wischen Sie die Linse dieser Ansicht ab; prüfen Sie Kamera und Kabel.</translation>
    </message>
    <message>
        <source>Check that the two cameras, or their videos, are in the right order.</source>
        <translation>Prüfen Sie, ob die beiden Kameras oder ihre Videos in der richtigen Reihenfolge sind.</translation>
    </message>
    <message>
        <source>Clear the smoke, wipe the lens, check lamp and focus.</source>
        <translation>Entfernen Sie den Rauch, wischen Sie die Linse ab, prüfen Sie Lampe und Schärfe.</translation>
    </message>
    <message>
        <source>the mask network leaves too little of the organ</source>
        <translation>das Maskennetz lässt zu wenig vom Organ übrig</translation>
    </message>
    <message>
        <source>Landmarks not reviewed</source>
        <translation>Landmarken nicht geprüft</translation>
    </message>
    <message>
        <source>Landmarks from statistics</source>
        <translation>Landmarken aus Statistik</translation>
    </message>
    <message>
        <source>Register the model to what the camera sees.</source>
        <translation>Registrieren Sie das Modell auf das, was die Kamera sieht.</translation>
    </message>
    <message>
        <source>Show the part of the organ that was seen when it was registered, free of smoke and tools.</source>
        <translation>Zeigen Sie den Teil des Organs, der bei der Registrierung zu sehen war, frei von Rauch und Instrumenten.</translation>
    </message>
    <message>
        <source>Show the part of the organ that was seen when it was registered, and hold still for a moment.</source>
        <translation>Zeigen Sie den Teil des Organs, der bei der Registrierung zu sehen war, und halten Sie einen Augenblick still.</translation>
    </message>
    <message>
        <source>Register again (R), or choose a new frame and register that.</source>
        <translation>Registrieren Sie neu (R), oder wählen Sie ein neues Bild und registrieren Sie dieses.</translation>
    </message>
    <message>
        <source>Start tracking again.</source>
        <translation>Starten Sie die Verfolgung neu.</translation>
    </message>
    <message>
        <source>Run the steps again that are out of date, then register.</source>
        <translation>Führen Sie die veralteten Schritte noch einmal aus, dann registrieren Sie.</translation>
    </message>
    <message>
        <source>Register again (R), or correct by hand (C).</source>
        <translation>Registrieren Sie neu (R), oder korrigieren Sie von Hand (C).</translation>
    </message>
    <message>
        <source>Check the camera and its cable.</source>
        <translation>Prüfen Sie die Kamera und ihr Kabel.</translation>
    </message>
    <message>
        <source>Move the laparoscope a little, or wait for a breath.</source>
        <translation>Bewegen Sie das Laparoskop ein wenig, oder warten Sie auf einen Atemzug.</translation>
    </message>
    <message>
        <source>Check that both cameras run, in the right order, at the same time, and as they were calibrated.</source>
        <translation>Prüfen Sie, ob beide Kameras laufen, in der richtigen Reihenfolge, zur selben Zeit und so, wie sie kalibriert wurden.</translation>
    </message>
    <message>
        <source>Take away what covers it, or show another part of the organ.</source>
        <translation>Nehmen Sie weg, was es verdeckt, oder zeigen Sie einen anderen Teil des Organs.</translation>
    </message>
    <message>
        <source>Clear the smoke, wipe the lens, check the lamp.</source>
        <translation>Lassen Sie den Rauch ab, wischen Sie die Linse, prüfen Sie die Lampe.</translation>
    </message>
    <message>
        <source>Read its doubts, on the right; then register again, or use it nevertheless.</source>
        <translation>Lesen Sie rechts ihre Zweifel; registrieren Sie dann neu, oder verwenden Sie sie dennoch.</translation>
    </message>
    <message>
        <source>Use this place, refine it, or put it back.</source>
        <translation>Nehmen Sie diese Lage, verfeinern Sie sie, oder setzen Sie sie zurück.</translation>
    </message>
    <message>
        <source>Show more of the organ; if the network is wrong, remove it.</source>
        <translation>Zeigen Sie mehr vom Organ; irrt das Netz, so entfernen Sie es.</translation>
    </message>
</context>
<context>
    <name>Review</name>
    <message>
        <source>Labels that nobody has reviewed: %1.</source>
        <translation>Labels, die niemand geprüft hat: %1.</translation>
    </message>
    <message>
        <source>Labels under review: %1.</source>
        <translation>Labels in Prüfung: %1.</translation>
    </message>
    <message>
        <source>Labels still to be reviewed: %1.</source>
        <translation>Labels, die noch zu prüfen sind: %1.</translation>
    </message>
</context>
<context>
    <name>SaveName</name>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>%1 is there already.</source>
        <translation>%1 gibt es schon.</translation>
    </message>
    <message>
        <source>Replacing it deletes what it holds.</source>
        <translation>Beim Ersetzen wird gelöscht, was darin ist.</translation>
    </message>
    <message>
        <source>In %1 there are already: %2.</source>
        <translation>In %1 gibt es schon: %2.</translation>
    </message>
    <message>
        <source>Replacing them deletes what they hold.</source>
        <translation>Beim Ersetzen wird gelöscht, was darin ist.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
</context>
<context>
    <name>SeriesTexts</name>
    <message>
        <source>derived from other images</source>
        <translation>aus anderen Bildern abgeleitet</translation>
    </message>
    <message>
        <source>neither CT nor MR</source>
        <translation>weder CT noch MRT</translation>
    </message>
    <message>
        <source>few slices</source>
        <translation>wenige Schichten</translation>
    </message>
    <message>
        <source>not axial</source>
        <translation>nicht axial</translation>
    </message>
    <message>
        <source>reformatted</source>
        <translation>reformatiert</translation>
    </message>
    <message>
        <source>screenshot or sheet</source>
        <translation>Bildschirmfoto oder Blatt</translation>
    </message>
    <message>
        <source>scout (localizer)</source>
        <translation>Übersichtsaufnahme (Localizer)</translation>
    </message>
    <message>
        <source>several frames in a file: cannot be read</source>
        <translation>mehrere Bilder in einer Datei: nicht lesbar</translation>
    </message>
    <message>
        <source>mask: two grey values only</source>
        <translation>Maske: nur zwei Grauwerte</translation>
    </message>
    <message>
        <source>no images (report, contours or segmentation)</source>
        <translation>keine Bilder (Befund, Konturen oder Segmentierung)</translation>
    </message>
    <message>
        <source>native</source>
        <translation>nativ</translation>
    </message>
    <message>
        <source>arterial</source>
        <translation>arteriell</translation>
    </message>
    <message>
        <source>portal venous</source>
        <translation>portalvenös</translation>
    </message>
    <message>
        <source>delayed</source>
        <translation>spät</translation>
    </message>
    <message>
        <source>slices %1 mm thick</source>
        <translation>Schichten %1 mm dick</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1, slices %2 mm thick</source>
        <translation>%1, Schichten %2 mm dick</translation>
    </message>
    <message>
        <source>no description</source>
        <translation>ohne Beschreibung</translation>
    </message>
</context>
<context>
    <name>Texts</name>
    <message>
        <source>Reading the volume</source>
        <translation>Volumen lesen</translation>
    </message>
    <message>
        <source>Reading the labels</source>
        <translation>Labels lesen</translation>
    </message>
    <message>
        <source>Storing what the volume is</source>
        <translation>Angabe zum Volumen übernehmen</translation>
    </message>
    <message>
        <source>Storing the seeds</source>
        <translation>Saatpunkte übernehmen</translation>
    </message>
    <message>
        <source>Segmenting</source>
        <translation>Segmentieren</translation>
    </message>
    <message>
        <source>Building the model</source>
        <translation>Modell bauen</translation>
    </message>
    <message>
        <source>Building the model from surfaces</source>
        <translation>Modell aus Oberflächen bauen</translation>
    </message>
    <message>
        <source>Reading the mesh</source>
        <translation>Netz lesen</translation>
    </message>
    <message>
        <source>Storing the landmarks</source>
        <translation>Landmarken übernehmen</translation>
    </message>
    <message>
        <source>Storing the stiffness</source>
        <translation>Steifigkeit übernehmen</translation>
    </message>
    <message>
        <source>Going back to the former registration</source>
        <translation>Zurück zur früheren Registrierung</translation>
    </message>
    <message>
        <source>Reading the calibration</source>
        <translation>Kalibrierung lesen</translation>
    </message>
    <message>
        <source>Reading the stereo pair</source>
        <translation>Stereobildpaar lesen</translation>
    </message>
    <message>
        <source>Opening the video</source>
        <translation>Video öffnen</translation>
    </message>
    <message>
        <source>Reading the video&apos;s frame</source>
        <translation>Videobild lesen</translation>
    </message>
    <message>
        <source>Storing the regions</source>
        <translation>Bereiche übernehmen</translation>
    </message>
    <message>
        <source>Reconstructing the surface</source>
        <translation>Oberfläche rekonstruieren</translation>
    </message>
    <message>
        <source>Reading the cloud</source>
        <translation>Punktwolke lesen</translation>
    </message>
    <message>
        <source>Registering</source>
        <translation>Registrieren</translation>
    </message>
    <message>
        <source>Reading the registration</source>
        <translation>Registrierung lesen</translation>
    </message>
    <message>
        <source>Starting the tracking</source>
        <translation>Verfolgung starten</translation>
    </message>
    <message>
        <source>Stopping the tracking</source>
        <translation>Verfolgung beenden</translation>
    </message>
    <message>
        <source>Opening the case</source>
        <translation>Fall öffnen</translation>
    </message>
    <message>
        <source>Saving the case</source>
        <translation>Fall speichern</translation>
    </message>
    <message>
        <source>looking for the frame</source>
        <translation>Bild suchen</translation>
    </message>
    <message>
        <source>looking through the video</source>
        <translation>das Video durchsehen</translation>
    </message>
    <message>
        <source>reading slices</source>
        <translation>Schichten lesen</translation>
    </message>
    <message>
        <source>unpacking</source>
        <translation>entpacken</translation>
    </message>
    <message>
        <source>reading labels</source>
        <translation>Labels lesen</translation>
    </message>
    <message>
        <source>reading the mesh</source>
        <translation>Netz lesen</translation>
    </message>
    <message>
        <source>reading files</source>
        <translation>Dateien lesen</translation>
    </message>
    <message>
        <source>writing files</source>
        <translation>Dateien schreiben</translation>
    </message>
    <message>
        <source>checking what was written</source>
        <translation>Geschriebenes prüfen</translation>
    </message>
    <message>
        <source>saved</source>
        <translation>gespeichert</translation>
    </message>
    <message>
        <source>preparing</source>
        <translation>vorbereiten</translation>
    </message>
    <message>
        <source>growing from the seeds</source>
        <translation>von den Saatpunkten wachsen</translation>
    </message>
    <message>
        <source>fitting the liver&apos;s surface</source>
        <translation>Leberoberfläche anpassen</translation>
    </message>
    <message>
        <source>growing the vessels</source>
        <translation>Gefäße wachsen</translation>
    </message>
    <message>
        <source>cleaning up</source>
        <translation>aufräumen</translation>
    </message>
    <message>
        <source>looking around the click</source>
        <translation>um den Klick schauen</translation>
    </message>
    <message>
        <source>making surfaces</source>
        <translation>Oberflächen bilden</translation>
    </message>
    <message>
        <source>reading surfaces</source>
        <translation>Oberflächen lesen</translation>
    </message>
    <message>
        <source>choosing the element size</source>
        <translation>Elementgröße wählen</translation>
    </message>
    <message>
        <source>preparing the mesh</source>
        <translation>Netz vorbereiten</translation>
    </message>
    <message>
        <source>filling with elements</source>
        <translation>mit Elementen füllen</translation>
    </message>
    <message>
        <source>improving the elements</source>
        <translation>Elemente verbessern</translation>
    </message>
    <message>
        <source>removing flat elements</source>
        <translation>flache Elemente entfernen</translation>
    </message>
    <message>
        <source>finding vessel centrelines</source>
        <translation>Mittellinien der Gefäße suchen</translation>
    </message>
    <message>
        <source>finding the anterior margin</source>
        <translation>Vorderrand suchen</translation>
    </message>
    <message>
        <source>measuring the mesh</source>
        <translation>Netz vermessen</translation>
    </message>
    <message>
        <source>finding points</source>
        <translation>Punkte suchen</translation>
    </message>
    <message>
        <source>matching points</source>
        <translation>Punkte zuordnen</translation>
    </message>
    <message>
        <source>refining matches</source>
        <translation>Zuordnungen verfeinern</translation>
    </message>
    <message>
        <source>fitting the surface</source>
        <translation>Oberfläche anpassen</translation>
    </message>
    <message>
        <source>finishing</source>
        <translation>abschließen</translation>
    </message>
    <message>
        <source>rigid start</source>
        <translation>starrer Start</translation>
    </message>
    <message>
        <source>elastic deformation</source>
        <translation>elastische Verformung</translation>
    </message>
    <message>
        <source>contact forces</source>
        <translation>Kontaktkräfte</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Leber</translation>
    </message>
    <message>
        <source>Portal vein</source>
        <translation>Pfortader</translation>
    </message>
    <message>
        <source>Hepatic veins</source>
        <translation>Lebervenen</translation>
    </message>
    <message>
        <source>Vena cava</source>
        <translation>Vena cava</translation>
    </message>
    <message>
        <source>Hepatic artery</source>
        <translation>Leberarterie</translation>
    </message>
    <message>
        <source>Gallbladder</source>
        <translation>Gallenblase</translation>
    </message>
    <message>
        <source>Lesion %1</source>
        <translation>Läsion %1</translation>
    </message>
    <message>
        <source>Not done</source>
        <translation>Offen</translation>
    </message>
    <message>
        <source>Up to date</source>
        <translation>Aktuell</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Veraltet</translation>
    </message>
    <message>
        <source>simulated operations</source>
        <translation>simulierte Operationen</translation>
    </message>
    <message>
        <source>most probable shape</source>
        <translation>wahrscheinlichste Form</translation>
    </message>
    <message>
        <source>Simulating</source>
        <translation>Simulieren</translation>
    </message>
    <message>
        <source>looking for tubes</source>
        <translation>röhrenförmige Strukturen suchen</translation>
    </message>
    <message>
        <source>steps in time</source>
        <translation>Zeitschritte</translation>
    </message>
    <message>
        <source>looking for the equilibrium</source>
        <translation>Gleichgewicht suchen</translation>
    </message>
    <message>
        <source>shaping a synthetic liver</source>
        <translation>synthetische Leber formen</translation>
    </message>
    <message>
        <source>growing its vessels</source>
        <translation>ihre Gefäße wachsen</translation>
    </message>
    <message>
        <source>making its CT</source>
        <translation>ihr CT erzeugen</translation>
    </message>
    <message>
        <source>measuring the true surfaces</source>
        <translation>wahre Oberflächen vermessen</translation>
    </message>
    <message>
        <source>inflating the abdomen</source>
        <translation>Bauchraum aufblasen</translation>
    </message>
    <message>
        <source>letting the patient breathe</source>
        <translation>Patienten atmen lassen</translation>
    </message>
    <message>
        <source>letting the heart beat</source>
        <translation>Herz schlagen lassen</translation>
    </message>
    <message>
        <source>placing the laparoscope</source>
        <translation>Laparoskop einführen</translation>
    </message>
    <message>
        <source>filming the liver</source>
        <translation>Leber filmen</translation>
    </message>
    <message>
        <source>following the film</source>
        <translation>dem Film folgen</translation>
    </message>
    <message>
        <source>Preparing the trial of a load</source>
        <translation>Belastungsversuch wird vorbereitet</translation>
    </message>
    <message>
        <source>Ending the trial of a load</source>
        <translation>Belastungsversuch wird beendet</translation>
    </message>
    <message>
        <source>preparing the elements</source>
        <translation>Elemente werden vorbereitet</translation>
    </message>
    <message>
        <source>preparing the solver</source>
        <translation>Löser wird vorbereitet</translation>
    </message>
    <message>
        <source>Editing the labels</source>
        <translation>Labels bearbeiten</translation>
    </message>
    <message>
        <source>Preparing a preview</source>
        <translation>Vorschau vorbereiten</translation>
    </message>
    <message>
        <source>Undoing</source>
        <translation>Rückgängig machen</translation>
    </message>
    <message>
        <source>Redoing</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Storing the review</source>
        <translation>Prüfstand speichern</translation>
    </message>
    <message>
        <source>looking at voxels</source>
        <translation>Voxel ansehen</translation>
    </message>
    <message>
        <source>Editing the vessel trees</source>
        <translation>Gefäßbäume bearbeiten</translation>
    </message>
    <message>
        <source>Noting the check of the model</source>
        <translation>Prüfung des Modells vermerken</translation>
    </message>
    <message>
        <source>looking for the board</source>
        <translation>Tafel suchen</translation>
    </message>
    <message>
        <source>calibrating each camera</source>
        <translation>jede Kamera kalibrieren</translation>
    </message>
    <message>
        <source>calibrating both together</source>
        <translation>beide zusammen kalibrieren</translation>
    </message>
    <message>
        <source>holding each view against the others</source>
        <translation>jede Ansicht gegen die anderen halten</translation>
    </message>
    <message>
        <source>Calibrating the laparoscope</source>
        <translation>Laparoskop kalibrieren</translation>
    </message>
    <message>
        <source>Writing the labels</source>
        <translation>Labels werden geschrieben</translation>
    </message>
    <message>
        <source>pulling and pressing the organ</source>
        <translation>am Organ ziehen und drücken</translation>
    </message>
    <message>
        <source>registering livers</source>
        <translation>Lebern werden registriert</translation>
    </message>
    <message>
        <source>pulling, registering and following organs</source>
        <translation>Organe werden gezogen, registriert und verfolgt</translation>
    </message>
    <message>
        <source>handling the liver</source>
        <translation>Leber wird bewegt</translation>
    </message>
    <message>
        <source>Keeping a copy for recovery</source>
        <translation>Sicherungskopie anlegen</translation>
    </message>
    <message>
        <source>Opening the copy</source>
        <translation>Sicherungskopie öffnen</translation>
    </message>
    <message>
        <source>Accepting the registration</source>
        <translation>Registrierung wird übernommen</translation>
    </message>
    <message>
        <source>Proposing the landmarks</source>
        <translation>Landmarken werden vorgeschlagen</translation>
    </message>
    <message>
        <source>Storing the review of a landmark</source>
        <translation>Prüfung einer Landmarke wird gespeichert</translation>
    </message>
    <message>
        <source>laying the atlas on the liver</source>
        <translation>Atlas wird auf die Leber gelegt</translation>
    </message>
    <message>
        <source>bending the atlas</source>
        <translation>Atlas wird gebogen</translation>
    </message>
    <message>
        <source>fitting the atlas to the surface</source>
        <translation>Atlas wird an die Oberfläche angepasst</translation>
    </message>
    <message>
        <source>bringing the template onto each liver</source>
        <translation>Vorlage wird auf jede Leber gebracht</translation>
    </message>
    <message>
        <source>foretelling each liver by the others</source>
        <translation>jede Leber wird aus den anderen vorhergesagt</translation>
    </message>
    <message>
        <source>reading livers</source>
        <translation>Lebern werden gelesen</translation>
    </message>
    <message>
        <source>Taking a step of the review back</source>
        <translation>Einen Schritt der Durchsicht zurücknehmen</translation>
    </message>
    <message>
        <source>Taking the other place</source>
        <translation>Der andere Ort wird übernommen</translation>
    </message>
    <message>
        <source>killing the program at work</source>
        <translation>das Programm mitten in der Arbeit abbrechen</translation>
    </message>
    <message>
        <source>Looking for series</source>
        <translation>Serien suchen</translation>
    </message>
    <message>
        <source>Correcting by hand</source>
        <translation>Korrektur von Hand</translation>
    </message>
    <message>
        <source>Taking a correction back</source>
        <translation>Zurücknehmen einer Korrektur</translation>
    </message>
    <message>
        <source>Looking for the liver</source>
        <translation>Die Leber suchen</translation>
    </message>
    <message>
        <source>comparing tissues</source>
        <translation>Gewebe vergleichen</translation>
    </message>
    <message>
        <source>Storing the decision about the new segmentation</source>
        <translation>Entscheidung über die neue Segmentierung wird gespeichert</translation>
    </message>
    <message>
        <source>Registering again</source>
        <translation>Erneutes Registrieren</translation>
    </message>
    <message>
        <source>Taking the other registration</source>
        <translation>Wechsel zur anderen Registrierung</translation>
    </message>
    <message>
        <source>Segmenting by your network</source>
        <translation>Segmentieren mit Ihrem Netz</translation>
    </message>
    <message>
        <source>Correcting around a click</source>
        <translation>Korrigieren um einen Klick</translation>
    </message>
    <message>
        <source>reading the network</source>
        <translation>Netz wird gelesen</translation>
    </message>
    <message>
        <source>running the network</source>
        <translation>Netz rechnet</translation>
    </message>
    <message>
        <source>Choosing the mask network</source>
        <translation>Wahl des Maskennetzes</translation>
    </message>
    <message>
        <source>taking off the coils&apos; brightness</source>
        <translation>nehme die Helligkeit der Spulen heraus</translation>
    </message>
    <message>
        <source>Keeping the look</source>
        <translation>Blick wird gemerkt</translation>
    </message>
    <message>
        <source>Forgetting the looks</source>
        <translation>Blicke werden verworfen</translation>
    </message>
    <message>
        <source>shapes with altered supports</source>
        <translation>Formen mit veränderten Auflagern</translation>
    </message>
    <message>
        <source>Simulating operations</source>
        <translation>Operationen werden simuliert</translation>
    </message>
    <message>
        <source>Writing the surfaces</source>
        <translation>Oberflächen schreiben</translation>
    </message>
    <message>
        <source>Building an atlas</source>
        <translation>Ein Atlas wird gebaut</translation>
    </message>
    <message>
        <source>Keeping the moment</source>
        <translation>Moment wird aufgehoben</translation>
    </message>
    <message>
        <source>Storing a moment&apos;s title</source>
        <translation>Titel eines Moments wird abgelegt</translation>
    </message>
    <message>
        <source>Deleting a moment</source>
        <translation>Moment wird gelöscht</translation>
    </message>
    <message>
        <source>Storing what is locked</source>
        <translation>Gesperrtes wird gespeichert</translation>
    </message>
</context>
<context>
    <name>UnitQuestion</name>
    <message>
        <source>Unit of length</source>
        <translation>Längeneinheit</translation>
    </message>
    <message>
        <source>In which unit are the lengths in %1?</source>
        <translation>In welcher Einheit sind die Längen in %1?</translation>
    </message>
    <message>
        <source>The file does not say. Glisson itself writes millimetres.</source>
        <translation>Die Datei sagt es nicht. Glisson selbst schreibt Millimeter.</translation>
    </message>
</context>
<context>
    <name>cli</name>
    <message>
        <source>Show this help.</source>
        <translation>Zeigt diese Hilfe.</translation>
    </message>
    <message>
        <source>Seed of everything random.</source>
        <translation>Startwert für alles Zufällige.</translation>
    </message>
    <message>
        <source>Write the figures to this file, as one flat JSON object.</source>
        <translation>Schreibt die Kennzahlen als ein flaches JSON-Objekt in diese Datei.</translation>
    </message>
    <message>
        <source> Default: %1.</source>
        <translation> Vorgabe: %1.</translation>
    </message>
    <message>
        <source>note: </source>
        <translation>Hinweis: </translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>The main job from end to end: a patient becomes a model, an in-silico theatre deforms and films the liver, the model is registered to the pictures and follows the video; ends with an overlay video and a report with the true errors.</source>
        <translation>Der ganze Weg: Aus einem Patienten wird ein Modell, ein virtueller Operationssaal verformt und filmt die Leber, das Modell wird auf die Bilder registriert und folgt dem Video. Am Ende stehen ein Video mit Einblendung und ein Bericht mit den wahren Fehlern.</translation>
    </message>
    <message>
        <source>The folder for the results.</source>
        <translation>Ordner für die Ergebnisse.</translation>
    </message>
    <message>
        <source>Another patient than the synthetic one: a case, a label map, or surfaces (a folder by structure, or one file).</source>
        <translation>Ein anderer Patient als der synthetische: ein Fall, eine Labelkarte oder Oberflächen (ein Ordner nach Strukturen oder eine Datei).</translation>
    </message>
    <message>
        <source>What a label map&apos;s codes mean (JSON).</source>
        <translation>Was die Codes einer Labelkarte bedeuten (JSON).</translation>
    </message>
    <message>
        <source>Unit of surfaces: mm, cm or m.</source>
        <translation>Einheit von Oberflächen: mm, cm oder m.</translation>
    </message>
    <message>
        <source>Vertices of the model.</source>
        <translation>Knoten des Modells.</translation>
    </message>
    <message>
        <source>Length of the film, at 30 frames a second.</source>
        <translation>Länge des Films in Bildern, 30 je Sekunde.</translation>
    </message>
    <message>
        <source>Distance of the laparoscope, mm (80 to 160).</source>
        <translation>Abstand des Laparoskops, mm (80 bis 160).</translation>
    </message>
    <message>
        <source>Share of the surface in the patch of the paper&apos;s protocol.</source>
        <translation>Anteil der Oberfläche im Ausschnitt nach dem Protokoll der Veröffentlichung.</translation>
    </message>
    <message>
        <source>Which member of the synthetic population.</source>
        <translation>Welches Mitglied der synthetischen Population.</translation>
    </message>
    <message>
        <source>Do not open the window at the end.</source>
        <translation>Am Ende das Fenster nicht öffnen.</translation>
    </message>
    <message>
        <source>Glisson: planning and guidance of minimally invasive liver surgery. Research software: not for clinical use.</source>
        <translation>Glisson: Planung und Führung minimalinvasiver Leberchirurgie. Forschungssoftware: nicht für den klinischen Gebrauch.</translation>
    </message>
    <message>
        <source>Usage: glisson [CASE]              open the window</source>
        <translation>Aufruf: glisson [CASE]             öffnet das Fenster</translation>
    </message>
    <message>
        <source>       glisson COMMAND [OPTIONS]   work without a display; &apos;glisson COMMAND --help&apos; tells more</source>
        <translation>        glisson COMMAND [OPTIONS]  arbeitet ohne Bildschirm; &apos;glisson COMMAND --help&apos; sagt mehr</translation>
    </message>
    <message>
        <source>The model: a case (NAME.glisson), a tetrahedral mesh (.vtu, legacy .vtk, .msh), a closed surface (.vtk .vtp .stl .obj .ply) or a folder of surfaces.</source>
        <translation>Das Modell: ein Fall (NAME.glisson), ein Tetraedernetz (.vtu, altes .vtk, .msh), eine geschlossene Oberfläche (.vtk .vtp .stl .obj .ply) oder ein Ordner mit Oberflächen.</translation>
    </message>
    <message>
        <source>Unit of the model&apos;s files and of what is written: mm, cm or m.</source>
        <translation>Einheit der Modelldateien und der Ergebnisse: mm, cm oder m.</translation>
    </message>
    <message>
        <source>Vertices wanted when a surface is meshed.</source>
        <translation>Gewünschte Knoten, wenn eine Oberfläche vernetzt wird.</translation>
    </message>
    <message>
        <source>Landmarks of the model (JSON, LPS mm).</source>
        <translation>Landmarken des Modells (JSON, LPS mm).</translation>
    </message>
    <message>
        <source>What the liver is made of: %1.</source>
        <translation>Woraus die Leber besteht: %1.</translation>
    </message>
    <message>
        <source>Parenchyma only: no vessels, no capsule.</source>
        <translation>Nur Parenchym: keine Gefäße, keine Kapsel.</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of the parenchyma, Pa.</source>
        <translation>Elastizitätsmodul des Parenchyms, Pa.</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio of the parenchyma.</source>
        <translation>Querdehnzahl des Parenchyms.</translation>
    </message>
    <message>
        <source>Young&apos;s moduli, kPa, as lesion_1=20,lesions=12: of parenchyma (or healthy, cirrhotic), lesion_1, lesion_2, ... and lesions (all others) (or soft, as_liver, stiff). What is not named is as the case says, or as the liver.</source>
        <translation>Elastizitätsmoduln, kPa, wie lesion_1=20,lesions=12: von parenchyma (oder healthy, cirrhotic), lesion_1, lesion_2, ... und lesions (alle anderen) (oder soft, as_liver, stiff). Was nicht genannt ist, ist wie im Fall gesagt oder wie die Leber.</translation>
    </message>
    <message>
        <source>The case&apos;s folder, NAME.glisson.</source>
        <translation>Ordner des Falls, NAME.glisson.</translation>
    </message>
    <message>
        <source>The volume.</source>
        <translation>Das Volumen.</translation>
    </message>
    <message>
        <source>What was clicked (JSON, LPS mm).</source>
        <translation>Was angeklickt wurde (JSON, LPS mm).</translation>
    </message>
    <message>
        <source>What the expert&apos;s codes mean (JSON).</source>
        <translation>Was die Codes des Experten bedeuten (JSON).</translation>
    </message>
    <message>
        <source>Builds the biomechanical model: tetrahedra, vessels, anterior margin.</source>
        <translation>Baut das biomechanische Modell: Tetraeder, Gefäße, Vorderrand.</translation>
    </message>
    <message>
        <source>Labels to take instead of the case&apos;s.</source>
        <translation>Labels statt derer des Falls.</translation>
    </message>
    <message>
        <source>What their codes mean: JSON, {&quot;6&quot;: &quot;parenchyma&quot;, &quot;10&quot;: &quot;portal_vein&quot;, ...}.</source>
        <translation>Was ihre Codes bedeuten: JSON, {&quot;6&quot;: &quot;parenchyma&quot;, &quot;10&quot;: &quot;portal_vein&quot;, ...}.</translation>
    </message>
    <message>
        <source>Takes labels or surfaces of a liver that lies left of the vena cava, as after a right hepatectomy: they are refused as mirrored otherwise.</source>
        <translation>Nimmt Labels oder Oberflächen einer Leber an, die links der Vena cava liegt, wie nach einer rechten Hemihepatektomie: Sonst werden sie als gespiegelt abgelehnt.</translation>
    </message>
    <message>
        <source>Unit of the surfaces: mm, cm or m.</source>
        <translation>Einheit der Oberflächen: mm, cm oder m.</translation>
    </message>
    <message>
        <source>Vertices wanted.</source>
        <translation>Gewünschte Knoten.</translation>
    </message>
    <message>
        <source>A fine surface of the liver: adds the distances. Read after everything else.</source>
        <translation>Eine feine Oberfläche der Leber: fügt die Abstände hinzu. Wird erst nach allem anderen gelesen.</translation>
    </message>
    <message>
        <source>Also write the mesh here (.vtu, .vtk).</source>
        <translation>Netz auch hierhin schreiben (.vtu, .vtk).</translation>
    </message>
    <message>
        <source>Plain mechanics: a load on the model. Writes deformed meshes with displacement and von Mises stress, and steps.csv with energies, residuals and time per step.</source>
        <translation>Reine Mechanik: eine Last auf dem Modell. Schreibt verformte Netze mit Verschiebung und Von-Mises-Spannung und steps.csv mit Energien, Restfehlern und Zeit je Schritt.</translation>
    </message>
    <message>
        <source>Steps of the dynamics.</source>
        <translation>Schritte der Dynamik.</translation>
    </message>
    <message>
        <source>Time step, s.</source>
        <translation>Zeitschritt, s.</translation>
    </message>
    <message>
        <source>The equilibrium instead of the dynamics.</source>
        <translation>Das Gleichgewicht statt der Dynamik.</translation>
    </message>
    <message>
        <source>Linear solver: direct (a fresh factor every step), fast (two-level conjugate gradients, for %1 tetrahedra and more) or reference (CHOLMOD).</source>
        <translation>Linearer Löser: direct (in jedem Schritt neu zerlegt), fast (zweistufige konjugierte Gradienten, ab %1 Tetraedern) oder reference (CHOLMOD).</translation>
    </message>
    <message>
        <source>Relative residual of the fast solver.</source>
        <translation>Relativer Restfehler des Lösers fast.</translation>
    </message>
    <message>
        <source>Write a mesh every so many steps (the last is always written).</source>
        <translation>Nach je so vielen Schritten ein Netz schreiben (das letzte immer).</translation>
    </message>
    <message>
        <source>The non-linear law instead of the co-rotational one.</source>
        <translation>Das nichtlineare Stoffgesetz statt des korotierten.</translation>
    </message>
    <message>
        <source>From CT to overlay video on the built-in synthetic patient, or another</source>
        <translation>Vom CT zum Video mit Einblendung, am eingebauten synthetischen Patienten oder einem anderen</translation>
    </message>
    <message>
        <source>Read a CT into a case</source>
        <translation>Ein CT in einen Fall einlesen</translation>
    </message>
    <message>
        <source>Segment liver, vessels and lesions from seeds</source>
        <translation>Leber, Gefäße und Läsionen aus Saatpunkten segmentieren</translation>
    </message>
    <message>
        <source>Build the biomechanical model</source>
        <translation>Das biomechanische Modell bauen</translation>
    </message>
    <message>
        <source>Stereo pair to labelled cloud</source>
        <translation>Vom Stereobildpaar zur beschrifteten Punktwolke</translation>
    </message>
    <message>
        <source>Register the model to a cloud</source>
        <translation>Das Modell auf eine Punktwolke registrieren</translation>
    </message>
    <message>
        <source>Follow a stereo video or a series of clouds</source>
        <translation>Einem Stereovideo oder einer Reihe von Punktwolken folgen</translation>
    </message>
    <message>
        <source>Draw one frame with its overlay</source>
        <translation>Ein Bild mit seiner Einblendung zeichnen</translation>
    </message>
    <message>
        <source>Record the overlay video</source>
        <translation>Das Video mit Einblendung aufzeichnen</translation>
    </message>
    <message>
        <source>Plain mechanics: gravity, pressure, springs, fixed nodes</source>
        <translation>Reine Mechanik: Schwerkraft, Druck, Federn, feste Knoten</translation>
    </message>
    <message>
        <source>Turns a stereo pair into a labelled cloud in the left camera&apos;s frame.</source>
        <translation>Macht aus einem Stereobildpaar eine beschriftete Punktwolke im Bezugssystem der linken Kamera.</translation>
    </message>
    <message>
        <source>The left picture.</source>
        <translation>Das linke Bild.</translation>
    </message>
    <message>
        <source>The right picture.</source>
        <translation>Das rechte Bild.</translation>
    </message>
    <message>
        <source>What of the left picture is tissue (non-zero).</source>
        <translation>Was im linken Bild Gewebe ist (nicht null).</translation>
    </message>
    <message>
        <source>Clicked regions (JSON): only what lies in one is kept, with its label.</source>
        <translation>Angeklickte Bereiche (JSON): Nur was darin liegt, bleibt, mit dessen Beschriftung.</translation>
    </message>
    <message>
        <source>The cloud (PLY).</source>
        <translation>Die Punktwolke (PLY).</translation>
    </message>
    <message>
        <source>Unit of the cloud and of --truth: mm, cm or m.</source>
        <translation>Einheit der Punktwolke und von --truth: mm, cm oder m.</translation>
    </message>
    <message>
        <source>A surface in the left camera&apos;s frame, or its depth map (.pfm, mm): adds the distances. Read after everything else.</source>
        <translation>Eine Oberfläche im Bezugssystem der linken Kamera oder deren Tiefenkarte (.pfm, mm): fügt die Abstände hinzu. Wird erst nach allem anderen gelesen.</translation>
    </message>
    <message>
        <source>Registers a model to a cloud: rigid start, then elastically. What is written keeps the model&apos;s node order and unit and is in the cloud&apos;s frame; its field data cloud_from_model is the rigid part.</source>
        <translation>Registriert ein Modell auf eine Punktwolke: erst starr, dann elastisch. Das Ergebnis behält Knotenreihenfolge und Einheit des Modells und liegt im Bezugssystem der Punktwolke; das Datenfeld cloud_from_model ist der starre Anteil.</translation>
    </message>
    <message>
        <source>The cloud (PLY); an integer property label is optional: 1 surface, 2 anterior margin, 3 umbilical notch.</source>
        <translation>Die Punktwolke (PLY); die ganzzahlige Eigenschaft label kann fehlen: 1 Oberfläche, 2 Vorderrand, 3 Nabelkerbe.</translation>
    </message>
    <message>
        <source>Unit of the cloud: mm, cm or m. Without it, the model&apos;s.</source>
        <translation>Einheit der Punktwolke: mm, cm oder m. Ohne sie die des Modells.</translation>
    </message>
    <message>
        <source>Rigid start: auto, none (the cloud is in the model&apos;s frame; what is judged by where the camera stood is not), or a file with a 4 x 4 matrix cloud_from_model.</source>
        <translation>Starrer Start: auto, none (die Punktwolke liegt im Koordinatensystem des Modells; was nach dem Ort der Kamera beurteilt wird, wird es nicht) oder eine Datei mit einer 4 x 4-Matrix cloud_from_model.</translation>
    </message>
    <message>
        <source>Nodes that stay where the rigid start puts them (0-based numbers).</source>
        <translation>Knoten, die bleiben, wo der starre Start sie hinlegt (Nummern ab 0).</translation>
    </message>
    <message>
        <source>What is known of the deformation before the cloud is seen: operations (simulated on this model; needs the vena cava&apos;s landmark) or none (elasticity alone, the paper&apos;s method).</source>
        <translation>Was vor dem Blick auf die Punktwolke über die Verformung bekannt ist: operations (an diesem Modell simuliert; braucht die Landmarke der Vena cava) oder none (nur Elastizität, das Verfahren der Veröffentlichung).</translation>
    </message>
    <message>
        <source>True node positions (.xyz or a mesh): adds the errors. Read after everything else.</source>
        <translation>Wahre Knotenpositionen (.xyz oder ein Netz): fügt die Fehler hinzu. Wird erst nach allem anderen gelesen.</translation>
    </message>
    <message>
        <source>The registered mesh (.vtu), or surface (.vtp) when a surface was given.</source>
        <translation>Das registrierte Netz (.vtu), oder die Oberfläche (.vtp), wenn eine gegeben war.</translation>
    </message>
    <message>
        <source>What &apos;glisson register&apos; wrote for this model and the first frame.</source>
        <translation>Was &apos;glisson register&apos; für dieses Modell und das erste Bild geschrieben hat.</translation>
    </message>
    <message>
        <source>Stereo video, views side by side.</source>
        <translation>Stereovideo, beide Ansichten nebeneinander.</translation>
    </message>
    <message>
        <source>The right view, when it is a file of its own.</source>
        <translation>Die rechte Ansicht, wenn sie eine eigene Datei ist.</translation>
    </message>
    <message>
        <source>OpenCV YAML of the laparoscope.</source>
        <translation>OpenCV-YAML des Laparoskops.</translation>
    </message>
    <message>
        <source>Series of clouds instead of a video, e.g. &apos;cloud_%02d.ply&apos;.</source>
        <translation>Reihe von Punktwolken statt eines Videos, z. B. &apos;cloud_%02d.ply&apos;.</translation>
    </message>
    <message>
        <source>Unit of the clouds: mm, cm or m. Without it, the model&apos;s.</source>
        <translation>Einheit der Punktwolken: mm, cm oder m. Ohne sie die des Modells.</translation>
    </message>
    <message>
        <source>Nodes that do not move (0-based numbers).</source>
        <translation>Knoten, die sich nicht bewegen (Nummern ab 0).</translation>
    </message>
    <message>
        <source>Series of true node positions, e.g. &apos;truth_%02d.xyz&apos;; may lack frames. Read after everything else.</source>
        <translation>Reihe wahrer Knotenpositionen, z. B. &apos;truth_%02d.xyz&apos;; Bilder dürfen fehlen. Wird erst nach allem anderen gelesen.</translation>
    </message>
    <message>
        <source>The folder for the meshes.</source>
        <translation>Ordner für die Netze.</translation>
    </message>
    <message>
        <source>Draws one frame of the case&apos;s video with vessels and tumours, followed from the registered frame. Where the position is not known, the picture says so and shows no overlay.</source>
        <translation>Zeichnet ein Bild aus dem Video des Falls mit Gefäßen und Tumoren, verfolgt vom registrierten Bild aus. Ist die Lage nicht bekannt, sagt das Bild es und zeigt keine Einblendung.</translation>
    </message>
    <message>
        <source>The case&apos;s folder, NAME.glisson, with a registration and a video.</source>
        <translation>Ordner des Falls, NAME.glisson, mit Registrierung und Video.</translation>
    </message>
    <message>
        <source>Number of the frame, from 0.</source>
        <translation>Nummer des Bildes, ab 0.</translation>
    </message>
    <message>
        <source>The picture (.png, .jpg).</source>
        <translation>Das Bild (.png, .jpg).</translation>
    </message>
    <message>
        <source>Follows the case&apos;s video and records it with vessels and tumours drawn in.</source>
        <translation>Folgt dem Video des Falls und zeichnet es mit Gefäßen und Tumoren auf.</translation>
    </message>
    <message>
        <source>The case&apos;s video, where it is opened without it: it lies outside of the case, and nobody here has chosen it yet.</source>
        <translation>Das Video des Falls, wo er ohne es geöffnet wird: Es liegt außerhalb des Falls, und hier hat es noch niemand gewählt.</translation>
    </message>
    <message>
        <source>Record only so many frames.</source>
        <translation>Nur so viele Bilder aufzeichnen.</translation>
    </message>
    <message>
        <source>The video (.mkv).</source>
        <translation>Das Video (.mkv).</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>Bild %1</translation>
    </message>
    <message>
        <source>The load (JSON): gravity, pressure, forces, springs, fixed; see the manual.</source>
        <translation>Die Last (JSON): Schwerkraft, Druck, Kräfte, Federn, feste Knoten; siehe Handbuch.</translation>
    </message>
    <message>
        <source>Edits the labels by a script of the window&apos;s tools. Each edit is a step that can be undone in the window.</source>
        <translation>Bearbeitet die Labels nach einem Skript mit den Werkzeugen des Fensters. Jede Bearbeitung ist ein Schritt, der im Fenster rückgängig gemacht werden kann.</translation>
    </message>
    <message>
        <source>The edits (JSON, LPS mm).</source>
        <translation>Die Bearbeitungen (JSON, LPS mm).</translation>
    </message>
    <message>
        <source>Undo so many steps first.</source>
        <translation>Zuerst so viele Schritte rückgängig machen.</translation>
    </message>
    <message>
        <source>Redo so many steps first, after those that are undone.</source>
        <translation>Zuerst so viele Schritte wiederholen, nach denen, die rückgängig gemacht werden.</translation>
    </message>
    <message>
        <source>How far a label has come: STRUCTURE=STATE, several with commas.</source>
        <translation>Wie weit ein Label ist: STRUKTUR=ZUSTAND, mehrere mit Kommas.</translation>
    </message>
    <message>
        <source>Nothing to do: give --script, --undo, --redo or --review.</source>
        <translation>Nichts zu tun: --script, --undo, --redo oder --review angeben.</translation>
    </message>
    <message>
        <source>Labels of an expert: adds Dice coefficients. Read after everything else.</source>
        <translation>Labels eines Experten: ergänzt Dice-Koeffizienten. Wird nach allem anderen gelesen.</translation>
    </message>
    <message>
        <source>Mean edge length wanted, mm, instead of a number of vertices.</source>
        <translation>Gewünschte mittlere Kantenlänge, mm, statt einer Zahl von Ecken.</translation>
    </message>
    <message>
        <source>Edge length in lesions over that elsewhere, 0.1 to 1.</source>
        <translation>Kantenlänge in Läsionen zu der anderswo, 0.1 bis 1.</translation>
    </message>
    <message>
        <source>Edge length in and next to vessels over that elsewhere, 0.2 to 1.</source>
        <translation>Kantenlänge in und neben Gefäßen zu der anderswo, 0.2 bis 1.</translation>
    </message>
    <message>
        <source>--region %1: write two opposite corners, X0,Y0,Z0,X1,Y1,Z1 in LPS millimetres.</source>
        <translation>--region %1: zwei gegenüberliegende Ecken schreiben, X0,Y0,Z0,X1,Y1,Z1 in LPS-Millimetern.</translation>
    </message>
    <message>
        <source>Which DICOM series, where there are several: its UID or number.</source>
        <translation>Welche DICOM-Serie, wenn es mehrere gibt: ihre UID oder Nummer.</translation>
    </message>
    <message>
        <source>Of the liver&apos;s contour, mm.</source>
        <translation>Der Leberkontur, mm.</translation>
    </message>
    <message>
        <source>Find these anew and keep the other labels: liver, portal_vein, hepatic_veins, vena_cava, gallbladder, lesions, with commas.</source>
        <translation>Diese neu suchen und die anderen Labels behalten: liver, portal_vein, hepatic_veins, vena_cava, gallbladder, lesions, mit Kommas.</translation>
    </message>
    <message>
        <source>Only inside this box, and keep the labels outside: X0,Y0,Z0,X1,Y1,Z1, LPS mm.</source>
        <translation>Nur in diesem Quader, und die Labels außerhalb behalten: X0,Y0,Z0,X1,Y1,Z1, LPS mm.</translation>
    </message>
    <message>
        <source>real CT: Dice of the liver</source>
        <translation>echtes CT: Dice der Leber</translation>
    </message>
    <message>
        <source>real CT: Dice of the portal vein in the liver</source>
        <translation>echtes CT: Dice der Pfortader in der Leber</translation>
    </message>
    <message>
        <source>real CT: Dice of the hepatic veins in the liver</source>
        <translation>echtes CT: Dice der Lebervenen in der Leber</translation>
    </message>
    <message>
        <source>real CT: ways from the root to a tip of the portal vein found</source>
        <translation>echtes CT: Wege von der Wurzel zu einer Spitze der Pfortader gefunden</translation>
    </message>
    <message>
        <source>real CT: ways from the root to a tip of the hepatic veins found</source>
        <translation>echtes CT: Wege von der Wurzel zu einer Spitze der Lebervenen gefunden</translation>
    </message>
    <message>
        <source>real CT: portal vein after the strokes</source>
        <translation>echtes CT: Pfortader nach den Strichen</translation>
    </message>
    <message>
        <source>real CT: hepatic veins after the strokes</source>
        <translation>echtes CT: Lebervenen nach den Strichen</translation>
    </message>
    <message>
        <source>real CT: vertices to the fine surface, mean, mm</source>
        <translation>echtes CT: Ecken zur feinen Oberfläche, Mittel, mm</translation>
    </message>
    <message>
        <source>real CT: least dihedral angle, degrees</source>
        <translation>echtes CT: kleinster Flächenwinkel, Grad</translation>
    </message>
    <message>
        <source>real CT: tetrahedra of the fine model</source>
        <translation>echtes CT: Tetraeder des feinen Modells</translation>
    </message>
    <message>
        <source>real CT: volume error of the fine model</source>
        <translation>echtes CT: Volumenfehler des feinen Modells</translation>
    </message>
    <message>
        <source>in silico: Dice of the liver</source>
        <translation>in silico: Dice der Leber</translation>
    </message>
    <message>
        <source>in silico: centrelines to the true trees, mean, voxels</source>
        <translation>in silico: Mittellinien zu den wahren Bäumen, Mittel, Voxel</translation>
    </message>
    <message>
        <source>in silico: branches above 2 mm radius found</source>
        <translation>in silico: gefundene Äste über 2 mm Radius</translation>
    </message>
    <message>
        <source>in silico: false loops</source>
        <translation>in silico: falsche Schleifen</translation>
    </message>
    <message>
        <source>in silico, segmented by clicks: centrelines to the true trees, mean, voxels</source>
        <translation>in silico, durch Klicks segmentiert: Mittellinien zu den wahren Bäumen, Mittel, Voxel</translation>
    </message>
    <message>
        <source>in silico: vertices to the fine surface, mean, mm</source>
        <translation>in silico: Ecken zur feinen Oberfläche, Mittel, mm</translation>
    </message>
    <message>
        <source>in silico: least dihedral angle, degrees</source>
        <translation>in silico: kleinster Flächenwinkel, Grad</translation>
    </message>
    <message>
        <source>in silico: volume error of the fine model</source>
        <translation>in silico: Volumenfehler des feinen Modells</translation>
    </message>
    <message>
        <source>met</source>
        <translation>erfüllt</translation>
    </message>
    <message>
        <source>NOT MET</source>
        <translation>NICHT ERFÜLLT</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>%1: leave out what is measured in silico.</source>
        <translation>%1: Was in silico gemessen wird, auslassen.</translation>
    </message>
    <message>
        <source>Folder for the page with the figures. In a checkout they go to packaging/figures, unless some could not be measured.</source>
        <translation>Ordner für die Seite mit den Zahlen. In einem Checkout kommen sie nach packaging/figures, außer wenn einige nicht gemessen werden konnten.</translation>
    </message>
    <message>
        <source>The figures were written to %1.</source>
        <translation>Die Zahlen wurden nach %1 geschrieben.</translation>
    </message>
    <message>
        <source>Folder of the real data; what is not there is left out.</source>
        <translation>Ordner der echten Daten; was nicht da ist, wird ausgelassen.</translation>
    </message>
    <message>
        <source>Folder of the clicks on it.</source>
        <translation>Ordner der Klicks darauf.</translation>
    </message>
    <message>
        <source>Folder for cases, scripts and pictures.</source>
        <translation>Ordner für Fälle, Skripte und Bilder.</translation>
    </message>
    <message>
        <source>%1: is no proof. See &apos;glisson prove --help&apos;.</source>
        <translation>%1: kein Nachweis. Siehe &apos;glisson prove --help&apos;.</translation>
    </message>
    <message>
        <source>%1: the board is found in the left picture only</source>
        <translation>%1: die Tafel ist nur im linken Bild zu finden</translation>
    </message>
    <message>
        <source>%1: the board is found in the right picture only</source>
        <translation>%1: die Tafel ist nur im rechten Bild zu finden</translation>
    </message>
    <message>
        <source>%1: no board is found</source>
        <translation>%1: keine Tafel gefunden</translation>
    </message>
    <message>
        <source>%1: has no partner</source>
        <translation>%1: hat keinen Partner</translation>
    </message>
    <message>
        <source>view, left px, right px, distance mm, tilt degrees, rows px by a calibration without it, rows px by the reference</source>
        <translation>Ansicht, links px, rechts px, Abstand mm, Neigung Grad, Zeilen px nach einer Kalibrierung ohne sie, Zeilen px nach der Vergleichskalibrierung</translation>
    </message>
    <message>
        <source>  left out</source>
        <translation>  ausgelassen</translation>
    </message>
    <message>
        <source>  fits far worse than the others: leave it out (--drop-outliers)</source>
        <translation>  passt weit schlechter als die anderen: auslassen (--drop-outliers)</translation>
    </message>
    <message>
        <source>A folder of picture pairs whose names differ in left and right only, or with folders left and right in it.</source>
        <translation>Ein Ordner mit Bildpaaren, deren Namen sich nur in left und right unterscheiden, oder mit Ordnern left und right darin.</translation>
    </message>
    <message>
        <source>The left pictures: a folder, or a pattern such as &apos;shots/left-*.png&apos;.</source>
        <translation>Die linken Bilder: ein Ordner oder ein Muster wie &apos;shots/left-*.png&apos;.</translation>
    </message>
    <message>
        <source>The right pictures, likewise.</source>
        <translation>Die rechten Bilder, ebenso.</translation>
    </message>
    <message>
        <source>Stereo video of the board, views side by side.</source>
        <translation>Stereovideo der Tafel, Ansichten nebeneinander.</translation>
    </message>
    <message>
        <source>Inner corners of the board, columns and rows.</source>
        <translation>Innere Ecken der Tafel, Spalten und Zeilen.</translation>
    </message>
    <message>
        <source>Side of a square, millimetres.</source>
        <translation>Seite eines Quadrats, Millimeter.</translation>
    </message>
    <message>
        <source>A ChArUco board: the dictionary of its markers, as DICT_4X4_50.</source>
        <translation>Eine ChArUco-Tafel: das Wörterbuch ihrer Marker, etwa DICT_4X4_50.</translation>
    </message>
    <message>
        <source>Side of a ChArUco marker, millimetres.</source>
        <translation>Seite eines ChArUco-Markers, Millimeter.</translation>
    </message>
    <message>
        <source>Views to use at most; those that differ most are kept.</source>
        <translation>Höchstzahl der Ansichten; die verschiedensten bleiben.</translation>
    </message>
    <message>
        <source>Another calibration to compare with: YAML, or a folder of plain text.</source>
        <translation>Eine andere Kalibrierung zum Vergleich: YAML oder ein Ordner mit einfachem Text.</translation>
    </message>
    <message>
        <source>Leave out the views that fit far worse than the others.</source>
        <translation>Ansichten auslassen, die weit schlechter passen als die anderen.</translation>
    </message>
    <message>
        <source>Estimate the third radial distortion term too.</source>
        <translation>Auch den dritten radialen Verzeichnungsterm schätzen.</translation>
    </message>
    <message>
        <source>Picture of where the boards were, both cameras.</source>
        <translation>Bild davon, wo die Tafeln waren, beide Kameras.</translation>
    </message>
    <message>
        <source>Instead of pictures: a calibration in plain text files (3x3, 4x4), to be written as YAML; needs --size.</source>
        <translation>Statt Bildern: eine Kalibrierung in einfachen Textdateien (3x3, 4x4), die als YAML geschrieben wird; braucht --size.</translation>
    </message>
    <message>
        <source>Width and height of the pictures, for --text.</source>
        <translation>Breite und Höhe der Bilder, für --text.</translation>
    </message>
    <message>
        <source>Unit of the translation in --text: mm, cm or m.</source>
        <translation>Einheit der Verschiebung in --text: mm, cm oder m.</translation>
    </message>
    <message>
        <source>The calibration (OpenCV YAML, mm).</source>
        <translation>Die Kalibrierung (OpenCV-YAML, mm).</translation>
    </message>
    <message>
        <source>Calibrates a stereo laparoscope from pictures of a chessboard or ChArUco board, and tells how far to trust it.</source>
        <translation>Kalibriert ein Stereolaparoskop aus Bildern einer Schachbrett- oder ChArUco-Tafel und sagt, wie weit man ihr trauen kann.</translation>
    </message>
    <message>
        <source>OpenCV YAML: M1 D1 M2 D2 R T image_width image_height unit; or a folder of plain text files (3x3, 4x4).</source>
        <translation>OpenCV-YAML: M1 D1 M2 D2 R T image_width image_height unit; oder ein Ordner mit einfachen Textdateien (3x3, 4x4).</translation>
    </message>
    <message>
        <source>Features (sparse, the paper&apos;s), semi-global matching (dense), or auto: dense where features leave fewer than 0.7 points per cm2.</source>
        <translation>Merkmale (sparse, wie im Artikel), halbglobaler Abgleich (dense) oder auto: dense, wo Merkmale weniger als 0,7 Punkte je cm2 lassen.</translation>
    </message>
    <message>
        <source>The same as --method dense.</source>
        <translation>Dasselbe wie --method dense.</translation>
    </message>
    <message>
        <source>Kind of features.</source>
        <translation>Art der Merkmale.</translation>
    </message>
    <message>
        <source>Edit the labels by a script of the window&apos;s tools</source>
        <translation>Labels nach einem Skript mit den Werkzeugen des Fensters bearbeiten</translation>
    </message>
    <message>
        <source>Calibrate a stereo laparoscope from pictures of a board</source>
        <translation>Ein Stereolaparoskop aus Bildern einer Tafel kalibrieren</translation>
    </message>
    <message>
        <source>Measure the proofs&apos; figures again</source>
        <translation>Die Zahlen der Nachweise noch einmal messen</translation>
    </message>
    <message>
        <source>real liver, features: points</source>
        <translation>echte Leber, Merkmale: Punkte</translation>
    </message>
    <message>
        <source>real liver, features: median to the CT surface, mm</source>
        <translation>echte Leber, Merkmale: Median zur CT-Oberfläche, mm</translation>
    </message>
    <message>
        <source>real liver, features: share within 3 mm</source>
        <translation>echte Leber, Merkmale: Anteil innerhalb 3 mm</translation>
    </message>
    <message>
        <source>real liver, features: median without the common offset, mm</source>
        <translation>echte Leber, Merkmale: Median ohne gemeinsamen Versatz, mm</translation>
    </message>
    <message>
        <source>real liver, dense: median to the CT surface, mm</source>
        <translation>echte Leber, dicht: Median zur CT-Oberfläche, mm</translation>
    </message>
    <message>
        <source>real liver, dense: share of the region covered</source>
        <translation>echte Leber, dicht: abgedeckter Anteil der Region</translation>
    </message>
    <message>
        <source>real liver, dense: median without the common offset, mm</source>
        <translation>echte Leber, dicht: Median ohne gemeinsamen Versatz, mm</translation>
    </message>
    <message>
        <source>real chessboards: joint stereo rms, pixels</source>
        <translation>echte Schachbretter: gemeinsamer Stereo-RMS, Pixel</translation>
    </message>
    <message>
        <source>real chessboards: views that fit better left out than by the reference</source>
        <translation>echte Schachbretter: Ansichten, die ausgelassen besser passen als nach der Vergleichskalibrierung</translation>
    </message>
    <message>
        <source>silicone heart: rows, rms, pixels</source>
        <translation>Silikonherz: Zeilen, RMS, Pixel</translation>
    </message>
    <message>
        <source>in silico: largest bias of any trial, mm</source>
        <translation>in silico: größte systematische Abweichung eines Versuchs, mm</translation>
    </message>
    <message>
        <source>in silico: normalised error, median of the trials (1: sigma is right)</source>
        <translation>in silico: normierter Fehler, Median der Versuche (1: Sigma stimmt)</translation>
    </message>
    <message>
        <source>%1 is not there and is left out.</source>
        <translation>%1 ist nicht da und wird ausgelassen.</translation>
    </message>
    <message>
        <source>Picture of where there are enough points, and where they are missing.</source>
        <translation>Bild davon, wo genug Punkte sind und wo sie fehlen.</translation>
    </message>
    <message>
        <source>The case is there already, and this is another image of its patient: it takes the former one&apos;s place; all else stays, marked out of date.</source>
        <translation>Den Fall gibt es schon, und dies ist ein anderes Bild seines Patienten: Es tritt an die Stelle des bisherigen; alles andere bleibt, als veraltet markiert.</translation>
    </message>
    <message>
        <source>--%1 %2: %3 is the same file. Choose another name.</source>
        <translation>--%1 %2: %3 ist dieselbe Datei. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>%1: is the video that is drawn into. Choose another name.</source>
        <translation>%1: ist das Video, in das gezeichnet wird. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>--%1: is given twice. Leave one of them out.</source>
        <translation>--%1: ist zweimal angegeben. Lassen Sie eines davon weg.</translation>
    </message>
    <message>
        <source>--%1: has no value. See &apos;glisson %2 --help&apos;.</source>
        <translation>--%1: hat keinen Wert. Siehe &apos;glisson %2 --help&apos;.</translation>
    </message>
    <message>
        <source>glisson %1: an argument is empty. See &apos;glisson %1 --help&apos;.</source>
        <translation>glisson %1: Ein Argument ist leer. Siehe &apos;glisson %1 --help&apos;.</translation>
    </message>
    <message>
        <source>Looks through a stereo video for faults: black, frozen, duplicated, swapped or exchanged frames, a lost camera, interlaced rows, a calibration of another scope.</source>
        <translation>Sieht ein Stereovideo auf Fehler durch: schwarze, stehende, doppelte, vertauschte oder umgestellte Bilder, eine ausgefallene Kamera, Zeilensprung, die Kalibrierung eines anderen Laparoskops.</translation>
    </message>
    <message>
        <source>Stereo video, folder of picture pairs, or description of a source (.json).</source>
        <translation>Stereovideo, Ordner mit Bildpaaren oder Beschreibung einer Quelle (.json).</translation>
    </message>
    <message>
        <source>OpenCV YAML of the laparoscope, or a folder of plain text.</source>
        <translation>OpenCV-YAML des Laparoskops oder ein Ordner mit einfachem Text.</translation>
    </message>
    <message>
        <source>Hold each N-th frame against the calibration.</source>
        <translation>Jedes N-te Bild gegen die Kalibrierung halten.</translation>
    </message>
    <message>
        <source>frame %1: %2</source>
        <translation>Bild %1: %2</translation>
    </message>
    <message>
        <source>Look through a stereo video for faults</source>
        <translation>Ein Stereovideo auf Fehler durchsehen</translation>
    </message>
    <message>
        <source>Closed surfaces to take instead of labels: a folder by structure, a list (JSON) of structures and files, or one file.</source>
        <translation>Geschlossene Oberflächen statt Labels: ein Ordner nach Strukturen, eine Liste (JSON) von Strukturen und Dateien oder eine Datei.</translation>
    </message>
    <message>
        <source>What is changed in the vessel trees (JSON, LPS mm).</source>
        <translation>Was an den Gefäßbäumen geändert wird (JSON, LPS mm).</translation>
    </message>
    <message>
        <source>Beams of all vessels together, about: where they have more, the thinnest and shortest side branches are left out, vessels of 4 mm across and more stay.</source>
        <translation>Balken aller Gefäße zusammen, ungefähr: haben sie mehr, werden die dünnsten und kürzesten Seitenäste weggelassen, Gefäße ab 4 mm Durchmesser bleiben.</translation>
    </message>
    <message>
        <source>real CT: least dihedral angle of the fine model, degrees</source>
        <translation>echtes CT: kleinster Flächenwinkel des feinen Modells, Grad</translation>
    </message>
    <message>
        <source>real CT: volume error of lesions above 1 ml, largest</source>
        <translation>echtes CT: größter Volumenfehler der Läsionen über 1 ml</translation>
    </message>
    <message>
        <source>live: frames over 10 mm that are not valid, share</source>
        <translation>live: Anteil der Bilder über 10 mm, die nicht gültig sind</translation>
    </message>
    <message>
        <source>live: frames under 3 mm without a fault that are valid, share</source>
        <translation>live: Anteil der Bilder unter 3 mm ohne Fehler, die gültig sind</translation>
    </message>
    <message>
        <source>live: longest time until an overlay goes, s</source>
        <translation>live: längste Zeit, bis eine Einblendung verschwindet, s</translation>
    </message>
    <message>
        <source>cancelled; nothing was written.</source>
        <translation>abgebrochen; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>cancelled; %1 holds what was finished (%2), marked as incomplete.</source>
        <translation>abgebrochen; was fertig war (%2), liegt in %1, als unvollständig gekennzeichnet.</translation>
    </message>
    <message>
        <source>cancelled; %1 holds what was done before.</source>
        <translation>abgebrochen; was vorher fertig war, liegt in %1.</translation>
    </message>
    <message>
        <source>This was cut short: what is here is not all.</source>
        <translation>Dies wurde abgebrochen: Was hier liegt, ist nicht alles.</translation>
    </message>
    <message>
        <source>Follows a stereo video, or a series of clouds, from a registered start. Every frame is processed; one mesh a frame is written, numbered like its input, and a line of frames.jsonl with the level, the reason and the pose. What Ctrl-C or an error cuts short is kept and marked INCOMPLETE.</source>
        <translation>Verfolgt ein Stereovideo oder eine Reihe von Punktwolken ab einem registrierten Anfang. Jedes Bild wird verarbeitet; je Bild wird ein Netz geschrieben, nummeriert wie seine Eingabe, und eine Zeile von frames.jsonl mit Stufe, Grund und Lage. Was Strg-C oder ein Fehler abbricht, wird behalten und mit INCOMPLETE gekennzeichnet.</translation>
    </message>
    <message>
        <source>How clouds are followed: forces, springs, or automatic, each as in &apos;glisson register&apos;.</source>
        <translation>Wie Punktwolken verfolgt werden: forces (Kräfte), springs (Federn) oder automatic, jeweils wie bei &apos;glisson register&apos;.</translation>
    </message>
    <message>
        <source>Steps of the springs towards each cloud.</source>
        <translation>Schritte der Federn auf jede Punktwolke zu.</translation>
    </message>
    <message>
        <source>live: longest time until a right overlay is back after a jump, s</source>
        <translation>live: längste Zeit, bis nach einem Sprung eine richtige Einblendung zurück ist, s</translation>
    </message>
    <message>
        <source>live: error over that of a model that stays, in the worst scenario</source>
        <translation>live: Fehler im Verhältnis zu einem Modell, das stehen bleibt, im schlechtesten Fall</translation>
    </message>
    <message>
        <source>live: single lesions over 10 mm off that are not drawn as such, share</source>
        <translation>live: einzelne Herde mit über 10 mm Fehler, die nicht als solche gezeichnet werden, Anteil</translation>
    </message>
    <message>
        <source>live: single lesions under 3 mm off without a fault that are, share</source>
        <translation>live: einzelne Herde mit unter 3 mm Fehler ohne Störung, die gezeichnet werden, Anteil</translation>
    </message>
    <message>
        <source>live, long: mean error since the start where the organ has moved, mm</source>
        <translation>live, lang: mittlerer Fehler seit dem Anfang, wo sich das Organ bewegt hat, mm</translation>
    </message>
    <message>
        <source>live, long: how far it has moved there, mean, mm</source>
        <translation>live, lang: wie weit es sich dort bewegt hat, im Mittel, mm</translation>
    </message>
    <message>
        <source>live, long: error over the organ&apos;s own motion, in the worst film (hands, tools)</source>
        <translation>live, lang: Fehler geteilt durch die eigene Bewegung des Organs, im schlechtesten Film (Hände, Werkzeuge)</translation>
    </message>
    <message>
        <source>live, long: frames over 10 mm at a lesion that are shown</source>
        <translation>live, lang: gezeigte Bilder, die an einem Herd um mehr als 10 mm falsch sind</translation>
    </message>
    <message>
        <source>registrations over 10 mm at a lesion, refused or doubted, share</source>
        <translation>Registrierungen mit über 10 mm an einem Herd, verworfen oder angezweifelt, Anteil</translation>
    </message>
    <message>
        <source>registrations under 3 mm at all lesions, doubted, share</source>
        <translation>Registrierungen mit unter 3 mm an allen Herden, angezweifelt, Anteil</translation>
    </message>
    <message>
        <source>lesions within their 95 % ellipsoid, share, at least</source>
        <translation>Herde innerhalb ihres 95-%-Ellipsoids, Anteil, mindestens</translation>
    </message>
    <message>
        <source>lesions outside of their 95 % ellipsoid, share</source>
        <translation>Herde außerhalb ihres 95-%-Ellipsoids, Anteil</translation>
    </message>
    <message>
        <source>expected against true error of a lesion, correlation</source>
        <translation>Erwarteter gegen wahren Fehler eines Herdes, Korrelation</translation>
    </message>
    <message>
        <source>mean error, 30 % of the surface seen, mm</source>
        <translation>Mittlerer Fehler, 30 % der Oberfläche gesehen, mm</translation>
    </message>
    <message>
        <source>mean error, 20 % of the surface seen, mm</source>
        <translation>Mittlerer Fehler, 20 % der Oberfläche gesehen, mm</translation>
    </message>
    <message>
        <source>registrations over 2.5 mm on average, 30 % seen, not doubted, share</source>
        <translation>Registrierungen mit über 2,5 mm im Mittel bei 30 % gesehener Fläche, nicht angezweifelt, Anteil</translation>
    </message>
    <message>
        <source>registrations over 4 mm on average, 20 % seen, not doubted, share</source>
        <translation>Registrierungen mit über 4 mm im Mittel bei 20 % gesehener Fläche, nicht angezweifelt, Anteil</translation>
    </message>
    <message>
        <source>registrations over 6 mm on average, 10 % seen, not doubted, share</source>
        <translation>Registrierungen mit über 6 mm im Mittel bei 10 % gesehener Fläche, nicht angezweifelt, Anteil</translation>
    </message>
    <message>
        <source>cases in which the best rigid alignment is beaten, share</source>
        <translation>Fälle, in denen die beste starre Ausrichtung übertroffen wird, Anteil</translation>
    </message>
    <message>
        <source>elastic_sequence: mean error of the first of its frames, mm</source>
        <translation>elastic_sequence: mittlerer Fehler des ersten Bildes, mm</translation>
    </message>
    <message>
        <source>elastic_sequence: mean error over its 50 frames, followed, mm</source>
        <translation>elastic_sequence: mittlerer Fehler über die 50 Bilder, verfolgt, mm</translation>
    </message>
    <message>
        <source>held organs: mean error of the worst of them, clouds without noise, mm</source>
        <translation>gehaltene Organe: mittlerer Fehler des schlechtesten, Punktwolken ohne Rauschen, mm</translation>
    </message>
    <message>
        <source>held organs: mean error of the worst frame of any, followed, clouds without noise, mm</source>
        <translation>gehaltene Organe: mittlerer Fehler des schlechtesten Bildes, verfolgt, Punktwolken ohne Rauschen, mm</translation>
    </message>
    <message>
        <source>loose organs, place unknown: mean error, clouds without noise, mm</source>
        <translation>lose Organe, Ort unbekannt: mittlerer Fehler, Punktwolken ohne Rauschen, mm</translation>
    </message>
    <message>
        <source>live: largest error at a lesion with a scope in a hand, mean over frames, mm</source>
        <translation>live: größter Fehler an einer Läsion, Endoskop in einer Hand, Mittel über die Bilder, mm</translation>
    </message>
    <message>
        <source>There is one processor core: the live view needs two.</source>
        <translation>Es gibt einen Prozessorkern: Die Live-Ansicht braucht zwei.</translation>
    </message>
    <message>
        <source>There are %1 GB of memory: large CTs need 8.</source>
        <translation>Es gibt %1 GB Arbeitsspeicher: Große CTs brauchen 8.</translation>
    </message>
    <message>
        <source>%1 has %2 GB left: archives are unpacked there.</source>
        <translation>In %1 sind noch %2 GB frei: Dort werden Archive entpackt.</translation>
    </message>
    <message>
        <source>There is no display: the window cannot open, all else works.</source>
        <translation>Es gibt keinen Bildschirm: Das Fenster kann nicht öffnen, alles andere geht.</translation>
    </message>
    <message>
        <source>Tells what the program finds on this machine, tries out what it needs and says what is missing. Reads no patient&apos;s data.</source>
        <translation>Sagt, was das Programm auf dieser Maschine findet, probiert aus, was es braucht, und sagt, was fehlt. Liest keine Patientendaten.</translation>
    </message>
    <message>
        <source>missing: </source>
        <translation>fehlt: </translation>
    </message>
    <message>
        <source>Does the same over and over, frames, opening and saving, edits with undo, and looks whether memory, file descriptors and threads stay what they are.</source>
        <translation>Tut dasselbe wieder und wieder, Bilder, Öffnen und Speichern, Bearbeitungen mit Rückgängig, und sieht nach, ob Speicher, Dateideskriptoren und Threads bleiben, was sie sind.</translation>
    </message>
    <message>
        <source>A case with a video and a registration; else one is made.</source>
        <translation>Ein Fall mit Video und Registrierung; sonst wird einer gemacht.</translation>
    </message>
    <message>
        <source>Frames to follow and draw.</source>
        <translation>Bilder, die verfolgt und gezeichnet werden.</translation>
    </message>
    <message>
        <source>Times to open and save the case.</source>
        <translation>Wie oft der Fall geöffnet und gespeichert wird.</translation>
    </message>
    <message>
        <source>Edits with their undo.</source>
        <translation>Bearbeitungen, jede mit ihrem Rückgängig.</translation>
    </message>
    <message>
        <source>Times to kill the program at work (import, save, record) and look what is left.</source>
        <translation>Wie oft das Programm bei der Arbeit (Import, Speichern, Aufnahme) abgeschossen und nachgesehen wird, was übrig bleibt.</translation>
    </message>
    <message>
        <source>Also write the figures here, as a page.</source>
        <translation>Die Zahlen auch hierhin schreiben, als Seite.</translation>
    </message>
    <message>
        <source>Tell what this machine has and lacks for the program</source>
        <translation>Sagen, was diese Maschine für das Programm hat und was ihr fehlt</translation>
    </message>
    <message>
        <source>Work for long and look whether memory, files and threads stay what they are</source>
        <translation>Lange arbeiten und nachsehen, ob Speicher, Dateien und Threads bleiben, was sie sind</translation>
    </message>
    <message>
        <source>real CTs, ten clicks of a layperson: Dice of the liver, median</source>
        <translation>echte CTs, zehn Klicks eines Laien: Dice der Leber, Median</translation>
    </message>
    <message>
        <source>real CTs, ten clicks of a layperson: Dice of the liver, worst</source>
        <translation>echte CTs, zehn Klicks eines Laien: Dice der Leber, schlechtester</translation>
    </message>
    <message>
        <source>real CT, altered, ten clicks of a layperson: Dice of the liver, median</source>
        <translation>echtes CT, verändert, zehn Klicks eines Laien: Dice der Leber, Median</translation>
    </message>
    <message>
        <source>real CT, altered, ten clicks of a layperson: Dice of the liver, worst</source>
        <translation>echtes CT, verändert, zehn Klicks eines Laien: Dice der Leber, schlechtester</translation>
    </message>
    <message>
        <source>in silico, ill livers, ten clicks of a layperson: Dice of the liver, median</source>
        <translation>in silico, kranke Lebern, zehn Klicks eines Laien: Dice der Leber, Median</translation>
    </message>
    <message>
        <source>in silico, ill livers, ten clicks of a layperson: Dice of the liver, worst</source>
        <translation>in silico, kranke Lebern, zehn Klicks eines Laien: Dice der Leber, schlechtester</translation>
    </message>
    <message>
        <source>in silico, ill livers, ten clicks and three corrections: Dice of the liver, worst</source>
        <translation>in silico, kranke Lebern, zehn Klicks und drei Korrekturen: Dice der Leber, schlechtester</translation>
    </message>
    <message>
        <source>real CT, altered, ten clicks and three corrections: Dice of the liver, worst</source>
        <translation>reales CT, verändert, zehn Klicks und drei Korrekturen: Dice der Leber, schlechtester</translation>
    </message>
    <message>
        <source>real CTs, ten clicks and three corrections: Dice of the liver, worst</source>
        <translation>reale CT, zehn Klicks und drei Korrekturen: Dice der Leber, schlechtester</translation>
    </message>
    <message>
        <source>real CT, lesions above 1 ml, one click: Dice, median</source>
        <translation>echtes CT, Läsionen über 1 ml, ein Klick: Dice, Median</translation>
    </message>
    <message>
        <source>in silico, lesions above 1 ml, one click: Dice, median</source>
        <translation>in silico, Läsionen über 1 ml, ein Klick: Dice, Median</translation>
    </message>
    <message>
        <source>How the shape is found: forces (few contact forces on the surface, elastic law by evidence), springs, paper (springs with --prior none, as published) or automatic (forces where operations are known and for a bare mesh with --fixed; springs where no force is worth its price, and otherwise).</source>
        <translation>Wie die Form gefunden wird: forces (wenige Kontaktkräfte auf der Oberfläche, elastisches Gesetz nach Evidenz), springs (Federn), paper (Federn mit --prior none, wie veröffentlicht) oder automatic (Kräfte, wo Operationen bekannt sind, und für ein bloßes Netz mit --fixed; Federn, wo keine Kraft ihren Preis wert ist, und sonst).</translation>
    </message>
    <message>
        <source>Write the result even if it is refused; its doubts stay with it. Without this a refused registration writes no file, and the exit code is 3.</source>
        <translation>Das Ergebnis schreiben, auch wenn es verworfen wird; seine Zweifel bleiben dabei. Ohne dies schreibt eine verworfene Registrierung keine Datei, und der Rückgabewert ist 3.</translation>
    </message>
    <message>
        <source>The registration was refused: what is known contradicts it (see the notes above). No mesh was written. Give a cloud that shows more of this patient&apos;s liver with less noise, mark margin and notch, or start from --rigid FILE; --accept-doubts writes it nevertheless.</source>
        <translation>Die Registrierung wurde verworfen: Was bekannt ist, widerspricht ihr (siehe die Hinweise oben). Es wurde kein Netz geschrieben. Geben Sie eine Wolke, die mehr von der Leber dieses Patienten mit weniger Rauschen zeigt, markieren Sie Rand und Kerbe oder beginnen Sie mit --rigid FILE; --accept-doubts schreibt sie dennoch.</translation>
    </message>
    <message>
        <source>--lock %1: is no label. Use parenchyma, portal_vein, hepatic_veins, vena_cava, gallbladder or lesion_1, lesion_2, ..., with commas.</source>
        <translation>--lock %1: ist kein Label. Verwenden Sie parenchyma, portal_vein, hepatic_veins, vena_cava, gallbladder oder lesion_1, lesion_2, ..., mit Kommas.</translation>
    </message>
    <message>
        <source>These labels neither lose nor gain a voxel: parenchyma, portal_vein, hepatic_veins, vena_cava, gallbladder, lesion_1, ..., with commas.</source>
        <translation>Diese Labels verlieren und gewinnen kein Voxel: parenchyma, portal_vein, hepatic_veins, vena_cava, gallbladder, lesion_1, ..., mit Kommas.</translation>
    </message>
    <message>
        <source>live, heart: frames over 10 mm that are not valid, share</source>
        <translation>live, Herz: Bilder über 10 mm, die nicht gültig sind, Anteil</translation>
    </message>
    <message>
        <source>live, heart: frames under 3 mm without a fault that are valid, share</source>
        <translation>live, Herz: Bilder unter 3 mm ohne Fehler, die gültig sind, Anteil</translation>
    </message>
    <message>
        <source>live, tissue: frames over 10 mm that are not valid, share</source>
        <translation>live, Gewebe: Bilder über 10 mm, die nicht gültig sind, Anteil</translation>
    </message>
    <message>
        <source>live, tissue: frames under 3 mm without a fault that are valid, share</source>
        <translation>live, Gewebe: Bilder unter 3 mm ohne Fehler, die gültig sind, Anteil</translation>
    </message>
    <message>
        <source>live, tissue: longest time until an overlay goes, s</source>
        <translation>live, Gewebe: längste Zeit, bis eine Überlagerung verschwindet, s</translation>
    </message>
    <message>
        <source>live, tissue: largest error at a place below the surface with a scope in a hand, mean over frames, mm</source>
        <translation>live, Gewebe: größter Fehler an einer Stelle unter der Oberfläche bei gehaltenem Laparoskop, Mittel über die Bilder, mm</translation>
    </message>
    <message>
        <source>live, tissue: longest time until a right overlay is back after a jump, s</source>
        <translation>live, Gewebe: längste Zeit, bis nach einem Sprung eine richtige Einblendung zurück ist, s</translation>
    </message>
    <message>
        <source>live, tissue: error over that of a model that stays, in the worst scenario</source>
        <translation>live, Gewebe: Fehler im Verhältnis zu einem Modell, das stehen bleibt, im schlechtesten Fall</translation>
    </message>
    <message>
        <source>live, heart: longest time until an overlay goes, s</source>
        <translation>live, Herz: längste Zeit, bis eine Einblendung verschwindet, s</translation>
    </message>
    <message>
        <source>live, heart: largest error at a place below the surface with a scope in a hand, mean over frames, mm</source>
        <translation>live, Herz: größter Fehler an einer Stelle unter der Oberfläche bei gehaltenem Laparoskop, Mittel über die Bilder, mm</translation>
    </message>
    <message>
        <source>live, heart: longest time until a right overlay is back after a jump, s</source>
        <translation>live, Herz: längste Zeit, bis nach einem Sprung eine richtige Einblendung zurück ist, s</translation>
    </message>
    <message>
        <source>live, heart: error over that of a model that stays, in the worst scenario</source>
        <translation>live, Herz: Fehler im Verhältnis zu einem Modell, das stehen bleibt, im schlechtesten Fall</translation>
    </message>
    <message>
        <source>Each liver foretold by the others (mm, in silico where the livers are synthetic):</source>
        <translation>Jede Leber aus den anderen vorhergesagt (mm, in silico, wo die Lebern synthetisch sind):</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>%1: %2 livers, %3 vertices, %4 modes</source>
        <translation>%1: %2 Lebern, %3 Punkte, %4 Moden</translation>
    </message>
    <message>
        <source>%1: from %2 livers (%3), %4 mm</source>
        <translation>%1: aus %2 Lebern (%3), %4 mm</translation>
    </message>
    <message>
        <source>; with its notch known: %1</source>
        <translation>; mit bekannter Nabelkerbe: %1</translation>
    </message>
    <message>
        <source>; follows: %1</source>
        <translation>; folgt: %1</translation>
    </message>
    <message>
        <source>No landmark follows another: this atlas does not know how they depend.</source>
        <translation>Keine Landmarke folgt einer anderen: Dieser Atlas weiß nicht, wie sie voneinander abhängen.</translation>
    </message>
    <message>
        <source>%1 differs from the others: weight %2</source>
        <translation>%1 weicht von den anderen ab: Gewicht %2</translation>
    </message>
    <message>
        <source>--accept: %1 is no structure.</source>
        <translation>--accept: %1 ist keine Struktur.</translation>
    </message>
    <message>
        <source>Landmarks that the CT does not show. &apos;build CASE... --out A&apos; makes an atlas of reviewed cases, &apos;evaluate CASE...&apos; foretells each of them by the others, &apos;show&apos; tells what an atlas knows, &apos;transfer --case C&apos; proposes landmarks on a patient&apos;s liver.</source>
        <translation>Landmarken, die das CT nicht zeigt. „build FALL... --out A“ macht einen Atlas aus geprüften Fällen, „evaluate FALL...“ sagt jeden aus den anderen vorher, „show“ sagt, was ein Atlas weiß, „transfer --case C“ schlägt Landmarken auf der Leber eines Patienten vor.</translation>
    </message>
    <message>
        <source>build, evaluate, show or transfer.</source>
        <translation>build, evaluate, show oder transfer.</translation>
    </message>
    <message>
        <source>Cases with a model, for build and evaluate: five at least.</source>
        <translation>Fälle mit einem Modell, für build und evaluate: mindestens fünf.</translation>
    </message>
    <message>
        <source>An atlas&apos; folder instead of the built-in atlas.</source>
        <translation>Ordner eines Atlas anstelle des eingebauten.</translation>
    </message>
    <message>
        <source>Folder for the atlas that is built.</source>
        <translation>Ordner für den Atlas, der gebaut wird.</translation>
    </message>
    <message>
        <source>Name of the atlas that is built.</source>
        <translation>Name des Atlas, der gebaut wird.</translation>
    </message>
    <message>
        <source>Proposals to accept unseen, with commas: umbilical_notch, vena_cava, ...</source>
        <translation>Vorschläge, die ungesehen angenommen werden, mit Kommas: umbilical_notch, vena_cava, ...</translation>
    </message>
    <message>
        <source>Add this many livers of the synthetic population, from --seed on.</source>
        <translation>So viele Lebern der synthetischen Population hinzunehmen, ab --seed.</translation>
    </message>
    <message>
        <source>What the livers do not show of how patients differ, mm, added to every landmark.</source>
        <translation>Was die Lebern davon nicht zeigen, wie sich Patienten unterscheiden, mm, zu jeder Landmarke hinzugefügt.</translation>
    </message>
    <message>
        <source>Begin with the synthetic template instead of an atlas.</source>
        <translation>Mit der synthetischen Vorlage statt mit einem Atlas beginnen.</translation>
    </message>
    <message>
        <source>Keep the atlas&apos; mean liver and its modes, and learn from the cases where structures lie on it.</source>
        <translation>Die mittlere Leber des Atlas und ihre Moden behalten und aus den Fällen lernen, wo Strukturen auf ihr liegen.</translation>
    </message>
    <message>
        <source>Keep of the cases means and mean squares alone: no names, no single liver.</source>
        <translation>Von den Fällen nur Mittel und mittlere Quadrate behalten: keine Namen, keine einzelne Leber.</translation>
    </message>
    <message>
        <source>Add the label maps of --data that served development, as this file says where notch, falciform ligament and margin lie on them.</source>
        <translation>Die Labelkarten aus --data hinzunehmen, die der Entwicklung dienten; diese Datei sagt, wo Kerbe, Ligamentum falciforme und Rand auf ihnen liegen.</translation>
    </message>
    <message>
        <source>Folder of the real data.</source>
        <translation>Ordner der echten Daten.</translation>
    </message>
    <message>
        <source>%1: is no action. See &apos;glisson atlas --help&apos;.</source>
        <translation>%1: ist keine Aktion. Siehe „glisson atlas --help“.</translation>
    </message>
    <message>
        <source>Measures the proofs&apos; figures again, against experts&apos; labels and known truths. %1.</source>
        <translation>Misst die Zahlen der Nachweise neu, gegen die Labels von Fachleuten und bekannte Wahrheiten. %1.</translation>
    </message>
    <message>
        <source>Which: %1.</source>
        <translation>Welcher: %1.</translation>
    </message>
    <message>
        <source>From the CT to the model</source>
        <translation>Von der CT zum Modell</translation>
    </message>
    <message>
        <source>From the laparoscope&apos;s pictures to clouds</source>
        <translation>Von den Bildern des Laparoskops zu Punktwolken</translation>
    </message>
    <message>
        <source>How far off a registration is, and whether it says so</source>
        <translation>Wie weit eine Registrierung abweicht, und ob sie es sagt</translation>
    </message>
    <message>
        <source>What the live overlay says of itself when something is wrong</source>
        <translation>Was das Live-Overlay von sich sagt, wenn etwas nicht stimmt</translation>
    </message>
    <message>
        <source>Bare organs that are pulled at a few places</source>
        <translation>Organe ohne Anatomie, die an wenigen Stellen gezogen werden</translation>
    </message>
    <message>
        <source>Landmarks that the CT does not show</source>
        <translation>Landmarken, die die CT nicht zeigt</translation>
    </message>
    <message>
        <source>%1: leave the validation patients alone, as when limits are set.</source>
        <translation>%1: die Validierungspatienten nicht anrühren, wie beim Festlegen von Grenzen.</translation>
    </message>
    <message>
        <source>Landmarks that the CT does not show: build, show and transfer an atlas</source>
        <translation>Landmarken, die das CT nicht zeigt: einen Atlas bauen, zeigen und übertragen</translation>
    </message>
    <message>
        <source>real livers by the others: surface, mean, mm</source>
        <translation>echte Lebern aus den anderen: Oberfläche, Mittel, mm</translation>
    </message>
    <message>
        <source>real livers by the others: surface, worst liver, mm</source>
        <translation>echte Lebern aus den anderen: Oberfläche, schlechteste Leber, mm</translation>
    </message>
    <message>
        <source>real livers by the others: correspondence, worst liver, mm</source>
        <translation>echte Lebern aus den anderen: Korrespondenz, schlechteste Leber, mm</translation>
    </message>
    <message>
        <source>real livers by the others: vena cava&apos;s contact, mean, mm</source>
        <translation>echte Lebern aus den anderen: Kontakt der Vena cava, Mittel, mm</translation>
    </message>
    <message>
        <source>real livers by the others: vena cava&apos;s contact, worst liver, mm</source>
        <translation>echte Lebern aus den anderen: Kontakt der Vena cava, schlechteste Leber, mm</translation>
    </message>
    <message>
        <source>real livers by the others: portal vein&apos;s entrance, mean, mm</source>
        <translation>echte Lebern aus den anderen: Eintritt der Pfortader, Mittel, mm</translation>
    </message>
    <message>
        <source>real livers by the others: portal vein&apos;s entrance, worst liver, mm</source>
        <translation>echte Lebern aus den anderen: Eintritt der Pfortader, schlechteste Leber, mm</translation>
    </message>
    <message>
        <source>real livers by the others: truth within the 95 % ellipsoids, at least</source>
        <translation>echte Lebern aus den anderen: Wahrheit in den 95-%-Ellipsoiden, mindestens</translation>
    </message>
    <message>
        <source>real livers by the others: truth within the 95 % ellipsoids, at most</source>
        <translation>echte Lebern aus den anderen: Wahrheit in den 95-%-Ellipsoiden, höchstens</translation>
    </message>
    <message>
        <source>validation livers by the others: truth within the 95 % ellipsoids</source>
        <translation>Lebern der Validierung aus den anderen: Wahrheit in den 95-%-Ellipsoiden</translation>
    </message>
    <message>
        <source>real livers by the built-in atlas: vena cava&apos;s contact, mean, mm</source>
        <translation>echte Lebern mit dem eingebauten Atlas: Kontakt der Vena cava, Mittel, mm</translation>
    </message>
    <message>
        <source>real livers by the built-in atlas: truth within the 95 % ellipsoids</source>
        <translation>echte Lebern mit dem eingebauten Atlas: Wahrheit in den 95-%-Ellipsoiden</translation>
    </message>
    <message>
        <source>validation livers by the built-in atlas: truth within the 95 % ellipsoids</source>
        <translation>Lebern der Validierung mit dem eingebauten Atlas: Wahrheit in den 95-%-Ellipsoiden</translation>
    </message>
    <message>
        <source>real livers mirrored: share that is refused</source>
        <translation>echte Lebern gespiegelt: Anteil, der abgelehnt wird</translation>
    </message>
    <message>
        <source>transfer to a real liver, slowest, s</source>
        <translation>Übertragung auf eine echte Leber, langsamste, s</translation>
    </message>
    <message>
        <source>building from the real livers, s</source>
        <translation>Bau aus den echten Lebern, s</translation>
    </message>
    <message>
        <source>in silico: surface, mean, mm</source>
        <translation>in silico: Oberfläche, Mittel, mm</translation>
    </message>
    <message>
        <source>real livers by the others: umbilical notch, mean, mm</source>
        <translation>echte Lebern aus den anderen: Nabelkerbe, Mittel, mm</translation>
    </message>
    <message>
        <source>real livers by the others: umbilical notch, worst liver, mm</source>
        <translation>echte Lebern aus den anderen: Nabelkerbe, schlechteste Leber, mm</translation>
    </message>
    <message>
        <source>real livers by the built-in atlas and the portal vein: umbilical notch, mean, mm</source>
        <translation>echte Lebern mit dem eingebauten Atlas und der Pfortader: Nabelkerbe, Mittel, mm</translation>
    </message>
    <message>
        <source>in silico: umbilical notch, mean, mm</source>
        <translation>in silico: Nabelkerbe, Mittel, mm</translation>
    </message>
    <message>
        <source>in silico: umbilical notch, worst liver, mm</source>
        <translation>in silico: Nabelkerbe, schlechteste Leber, mm</translation>
    </message>
    <message>
        <source>in silico: anterior margin, mean, mm</source>
        <translation>in silico: Vorderrand, Mittel, mm</translation>
    </message>
    <message>
        <source>in silico: truth within the 95 % ellipsoids, at least</source>
        <translation>in silico: Wahrheit in den 95-%-Ellipsoiden, mindestens</translation>
    </message>
    <message>
        <source>in silico: truth within the 95 % ellipsoids, at most</source>
        <translation>in silico: Wahrheit in den 95-%-Ellipsoiden, höchstens</translation>
    </message>
    <message>
        <source>registration with the atlas&apos;s landmarks: error over that with none</source>
        <translation>Registrierung mit den Landmarken des Atlas: Fehler über dem ohne Landmarken</translation>
    </message>
    <message>
        <source>registration: two patients of either set and one share that is seen; pulled: two organs of a kind.</source>
        <translation>registration: zwei Patienten jeder Menge und ein sichtbarer Anteil; pulled: zwei Organe jeder Art.</translation>
    </message>
    <message>
        <source>%1: follow a scope in a fast hand, tools that lift and press, and 3,000 frames, too.</source>
        <translation>%1: folgt auch einem Laparoskop in schneller Hand, Werkzeugen, die heben und drücken, und 3.000 Bildern.</translation>
    </message>
    <message>
        <source>%1: keep what DIR/registration_SEED.csv holds of a run that was cut short.</source>
        <translation>%1: behält, was DIR/registration_SEED.csv von einem abgebrochenen Lauf schon enthält.</translation>
    </message>
    <message>
        <source>This computer&apos;s kernel does not shut in the programs that read foreign files: read only files that you trust.</source>
        <translation>Der Kernel dieses Rechners schließt die Programme nicht ein, die fremde Dateien lesen: nur Dateien lesen, denen Sie vertrauen.</translation>
    </message>
    <message>
        <source>A pixel of the left picture where a tool touches the organ: the lesion&apos;s distance from there is told, too.</source>
        <translation>Ein Pixel des linken Bildes, wo ein Instrument das Organ berührt: auch der Abstand der Läsion von dort wird genannt.</translation>
    </message>
    <message>
        <source>How depth is told: %1.</source>
        <translation>Wie Tiefe gezeigt wird: %1.</translation>
    </message>
    <message>
        <source>Draw thin distal branches of vessels, too.</source>
        <translation>Auch dünne ferne Äste der Gefäße zeichnen.</translation>
    </message>
    <message>
        <source>A folder that &apos;glisson track&apos; filled for this case and video: what was known then is drawn again, and nothing is followed.</source>
        <translation>Ein Ordner, den &apos;glisson track&apos; für diesen Fall und dieses Video gefüllt hat: Was damals bekannt war, wird wieder gezeichnet, und nichts wird verfolgt.</translation>
    </message>
    <message>
        <source>A folder that &apos;glisson track&apos; filled for this case and video, or NAME.frames.jsonl that the window wrote beside a recording: what was known then is drawn again, and nothing is followed.</source>
        <translation>Ein Ordner, den &apos;glisson track&apos; für diesen Fall und dieses Video gefüllt hat, oder NAME.frames.jsonl, das das Fenster neben eine Aufnahme geschrieben hat: was damals bekannt war, wird noch einmal gezeichnet, und nichts wird verfolgt.</translation>
    </message>
    <message>
        <source>Look at this lesion and tell its numbers, as lesion_1.</source>
        <translation>Diese Läsion betrachten und ihre Zahlen nennen, etwa lesion_1.</translation>
    </message>
    <message>
        <source>The file of --rigid is near the right place only: refined rigidly first, as a model that was placed by hand.</source>
        <translation>Die Datei von --rigid liegt nur in der Nähe des richtigen Ortes: wird zuerst starr verfeinert wie ein von Hand angelegtes Modell.</translation>
    </message>
    <message>
        <source>Takes the N-th of the other places where the organ may be (rival_N_probability, rival_N_away_mm) instead of the most probable one.</source>
        <translation>Nimmt den N-ten der anderen Orte, an denen das Organ liegen kann (rival_N_probability, rival_N_away_mm), statt des wahrscheinlichsten.</translation>
    </message>
    <message>
        <source>Also write a page on the registration: how it ended, how far off organ and lesions may be, where else the organ may be, its doubts.</source>
        <translation>Schreibt auch eine Seite über die Registrierung: wie sie endete, wie weit Organ und Läsionen daneben liegen können, wo das Organ sonst liegen kann, ihre Zweifel.</translation>
    </message>
    <message>
        <source>How unusual the livers were that --added-deviation was set on, over what is usual: it grows only beyond that.</source>
        <translation>Wie ungewöhnlich die Lebern waren, an denen --added-deviation festgelegt wurde, über dem Üblichen: erst darüber hinaus wächst es.</translation>
    </message>
    <message>
        <source>number %1</source>
        <translation>Nummer %1</translation>
    </message>
    <message>
        <source>%1 slices</source>
        <translation>%1 Schichten</translation>
    </message>
    <message>
        <source>Only tell which DICOM series there are, the likeliest first.</source>
        <translation>Nur sagen, welche DICOM-Serien es gibt, die wahrscheinlichste zuerst.</translation>
    </message>
    <message>
        <source>real CT, lesions above 1 ml, a line drawn across: Dice, median</source>
        <translation>echtes CT, Läsionen über 1 ml, ein Strich quer durch: Dice, Median</translation>
    </message>
    <message>
        <source>in silico, lesions above 1 ml, a line drawn across: Dice, median</source>
        <translation>in silico, Läsionen über 1 ml, ein Strich quer durch: Dice, Median</translation>
    </message>
    <message>
        <source>real CT, altered: Dice of the portal vein in the liver, median</source>
        <translation>echtes CT, verändert: Dice der Pfortader in der Leber, Median</translation>
    </message>
    <message>
        <source>real CT, altered: Dice of the hepatic veins in the liver, median</source>
        <translation>echtes CT, verändert: Dice der Lebervenen in der Leber, Median</translation>
    </message>
    <message>
        <source>in silico, ill livers: Dice of the portal vein in the liver, median</source>
        <translation>in silico, kranke Lebern: Dice der Pfortader in der Leber, Median</translation>
    </message>
    <message>
        <source>in silico, ill livers: Dice of the hepatic veins in the liver, median</source>
        <translation>in silico, kranke Lebern: Dice der Lebervenen in der Leber, Median</translation>
    </message>
    <message>
        <source>A video in %1 could not be written and read back here: OpenCV&apos;s FFmpeg lacks it.</source>
        <translation>Ein Video in %1 ließ sich hier nicht schreiben und wieder lesen: OpenCVs FFmpeg kann es nicht.</translation>
    </message>
    <message>
        <source>Corrections by hand, a line of JSON each: {&quot;frame&quot;: 12, &quot;correct&quot;: {&quot;view&quot;: &quot;left&quot;, &quot;from&quot;: [480, 270], &quot;to&quot;: [492, 274]}}: what is drawn at the one pixel is seen at the other; &quot;correct&quot;: &quot;undo&quot; takes the last one back. What frames.jsonl says of corrections can be given.</source>
        <translation>Korrekturen von Hand, je eine Zeile JSON: {&quot;frame&quot;: 12, &quot;correct&quot;: {&quot;view&quot;: &quot;left&quot;, &quot;from&quot;: [480, 270], &quot;to&quot;: [492, 274]}}: Was an dem einen Pixel gezeichnet ist, wird an dem anderen gesehen; &quot;correct&quot;: &quot;undo&quot; nimmt die letzte zurück. Was frames.jsonl an Korrekturen nennt, kann angegeben werden.</translation>
    </message>
    <message>
        <source>Also write the labels here (.seg.nrrd, .nii.gz; .dcm: DICOM segmentation).</source>
        <translation>Die Labels auch hierher schreiben (.seg.nrrd, .nii.gz; .dcm: DICOM-Segmentierung).</translation>
    </message>
    <message>
        <source>Look for the liver without a click in it. Look at what comes of it.</source>
        <translation>Die Leber ohne einen Klick suchen. Sehen Sie sich an, was daraus wird.</translation>
    </message>
    <message>
        <source>Correct the case&apos;s labels around the clicks on the liver, beside it, on its veins and on lesions that the case does not have yet; the labels elsewhere stay.</source>
        <translation>Die Labels des Falls um die Klicks auf die Leber, neben sie, auf ihre Venen und auf Läsionen korrigieren, die der Fall noch nicht hat; anderswo bleiben die Labels.</translation>
    </message>
    <message>
        <source>Listens at this address and tells programs that connect by OpenIGTLink (3D Slicer, CustusX, PLUS) of each frame: level, pose, surfaces. Without an address 127.0.0.1:18944, which other computers do not reach; port 0: a free one.</source>
        <translation>Wartet an dieser Adresse und teilt Programmen, die sich über OpenIGTLink verbinden (3D Slicer, CustusX, PLUS), jedes Bild mit: Stufe, Lage, Oberflächen. Ohne Adresse 127.0.0.1:18944, das andere Rechner nicht erreichen; Port 0: ein freier.</translation>
    </message>
    <message>
        <source>With --igtl-send: begins when a program has connected.</source>
        <translation>Mit --igtl-send: beginnt, wenn sich ein Programm verbunden hat.</translation>
    </message>
    <message>
        <source>OpenIGTLink: listening at %1.</source>
        <translation>OpenIGTLink: wartet an %1.</translation>
    </message>
    <message>
        <source>OpenIGTLink: listening at %1, where other computers may reach it.</source>
        <translation>OpenIGTLink: wartet an %1, wo andere Rechner es erreichen können.</translation>
    </message>
    <message>
        <source>Of labels that were corrected by hand keep each voxel that was, and replace the rest.</source>
        <translation>Von Labels, die von Hand korrigiert wurden, jedes korrigierte Voxel behalten und den Rest ersetzen.</translation>
    </message>
    <message>
        <source>Replace labels that were corrected by hand, corrections and all. Without these two it is only told what would change.</source>
        <translation>Von Hand korrigierte Labels samt den Korrekturen ersetzen. Ohne diese beiden wird nur gesagt, was sich ändern würde.</translation>
    </message>
    <message>
        <source>Registers again every so many seconds of the video, with what has been seen of the organ since; taken where it is better by tissue that neither registration has used.</source>
        <translation>Registriert alle so viele Sekunden des Videos erneut, mit dem, was seither vom Organ gesehen wurde; übernommen, wo es nach Gewebe besser ist, das keine der beiden Registrierungen benutzt hat.</translation>
    </message>
    <message>
        <source>The cloud (PLY) that the start was registered to: --register-again goes on from it, with what is marked in it (margin, notch).</source>
        <translation>Die Punktwolke (PLY), auf die der Anfang registriert wurde: --register-again geht von ihr aus, mit dem, was in ihr markiert ist (Vorderrand, Nabelkerbe).</translation>
    </message>
    <message>
        <source>Puts the registration off by so many millimetres before it is followed: across, down and away from the camera.</source>
        <translation>Versetzt die Registrierung um so viele Millimeter, bevor sie verfolgt wird: quer, nach unten und von der Kamera weg.</translation>
    </message>
    <message>
        <source>Registers again every so many seconds of the film.</source>
        <translation>Registriert alle so viele Sekunden des Films erneut.</translation>
    </message>
    <message>
        <source>--%1, --%2: give one of them.</source>
        <translation>--%1, --%2: Geben Sie eines davon an.</translation>
    </message>
    <message>
        <source>--%1: needs labels. Give --%2 FILE.</source>
        <translation>--%1: braucht Labels. Geben Sie --%2 DATEI an.</translation>
    </message>
    <message>
        <source>Segments the liver, its vessels and lesions from seeds, or by your own network.</source>
        <translation>Segmentiert die Leber, ihre Gefäße und Läsionen von Saatpunkten aus oder mit Ihrem eigenen Netz.</translation>
    </message>
    <message>
        <source>Your own segmentation network (ONNX) instead of seeds; MODEL.json beside it says what it wants and what its channels mean (see the manual).</source>
        <translation>Ihr eigenes Segmentierungsnetz (ONNX) statt Saatpunkten; MODEL.json daneben sagt, was es braucht und was seine Kanäle bedeuten (siehe Handbuch).</translation>
    </message>
    <message>
        <source>The mask network has failed; the organ is followed without it. %1</source>
        <translation>Das Maskennetz ist ausgefallen; das Organ wird ohne es verfolgt. %1</translation>
    </message>
    <message>
        <source>Your own network (ONNX) that says what of the left picture is not liver; MODEL.json beside it says what it wants. It only keeps points from pulling.</source>
        <translation>Ihr eigenes Netz (ONNX), das sagt, was vom linken Bild nicht Leber ist; MODEL.json daneben sagt, was es will. Es hält nur Punkte davon ab zu ziehen.</translation>
    </message>
    <message>
        <source>Frames between two masks, each of which is waited for.</source>
        <translation>Bilder zwischen zwei Masken; auf jede wird gewartet.</translation>
    </message>
    <message>
        <source>--modality %1: write ct or mr.</source>
        <translation>--modality %1: Schreiben Sie ct oder mr.</translation>
    </message>
    <message>
        <source>Reads a CT or MRI (a folder of DICOM slices or its DICOMDIR, a .zip or .tar.gz of one, NIfTI, NRRD, MetaImage) into a case, which is made if there is none.</source>
        <translation>Liest ein CT oder eine MRT (einen Ordner mit DICOM-Schichten oder dessen DICOMDIR, ein .zip oder .tar.gz davon, NIfTI, NRRD, MetaImage) in einen Fall, der angelegt wird, wenn es keinen gibt.</translation>
    </message>
    <message>
        <source>ct or mr: what the volume is, where its file does not say.</source>
        <translation>ct oder mr: was das Volumen ist, wenn seine Datei es nicht sagt.</translation>
    </message>
    <message>
        <source>%1: only whether one more look helps, where it is said to help most and joined from an unknown place.</source>
        <translation>%1: nur, ob ein weiterer Blick hilft: dort, wo er am meisten helfen soll, und von unbekanntem Ort dazugenommen.</translation>
    </message>
    <message>
        <source>Earlier looks at the same organ, which has not moved since: clouds (PLY), commas between them, each in its own camera&apos;s frame. Where they were seen from is found; the result is in the frame of --cloud.</source>
        <translation>Frühere Blicke auf dasselbe Organ, das sich seither nicht bewegt hat: Punktwolken (PLY), durch Kommas getrennt, jede im eigenen Kamerasystem. Von wo sie gesehen wurden, wird gefunden; das Ergebnis steht im System von --cloud.</translation>
    </message>
    <message>
        <source>falciform ligament at the notch</source>
        <translation>Ligamentum falciforme an der Kerbe</translation>
    </message>
    <message>
        <source>vena cava</source>
        <translation>Hohlvene</translation>
    </message>
    <message>
        <source>both</source>
        <translation>beide</translation>
    </message>
    <message>
        <source>mean Hausdorff distance, mm</source>
        <translation>mittlerer Hausdorff-Abstand, mm</translation>
    </message>
    <message>
        <source>(a) place of the boundary conditions</source>
        <translation>(a) Ort der Randbedingungen</translation>
    </message>
    <message>
        <source>shift along the surface, mm</source>
        <translation>Verschiebung auf der Oberfläche, mm</translation>
    </message>
    <message>
        <source>(b) stiffness of the boundary conditions</source>
        <translation>(b) Steifigkeit der Randbedingungen</translation>
    </message>
    <message>
        <source>times the reference&apos;s stiffness</source>
        <translation>mal die Steifigkeit der Referenz</translation>
    </message>
    <message>
        <source>the atlas laid on livers</source>
        <translation>der Atlas auf Lebern gelegt</translation>
    </message>
    <message>
        <source>umbilical notch (in silico)</source>
        <translation>Nabelkerbe (in silico)</translation>
    </message>
    <message>
        <source>--flank: is %1. Give left or right.</source>
        <translation>--flank: ist %1. Geben Sie left oder right an.</translation>
    </message>
    <message>
        <source>Measures a figure of the paper again and sets it beside the paper&apos;s words: 5 (how well the atlas foretells surface, notch and vena cava), 6 (how much the shape on the flank depends on place and stiffness of the boundary conditions). Prints the table; writes page, table and plot.</source>
        <translation>Misst eine Abbildung des Artikels neu und stellt sie neben dessen Worte: 5 (wie gut der Atlas Oberfläche, Kerbe und Hohlvene vorhersagt), 6 (wie sehr die Form auf der Flanke von Ort und Steifigkeit der Randbedingungen abhängt). Gibt die Tabelle aus; schreibt Seite, Tabelle und Bild.</translation>
    </message>
    <message>
        <source>The figure&apos;s number in the paper: 5 or 6.</source>
        <translation>Die Nummer der Abbildung im Artikel: 5 oder 6.</translation>
    </message>
    <message>
        <source>5: folder of the real data; what is not there is left out.</source>
        <translation>5: Ordner der echten Daten; was fehlt, wird ausgelassen.</translation>
    </message>
    <message>
        <source>6: a case with model, notch and vena cava, instead of the built-in synthetic patient.</source>
        <translation>6: ein Fall mit Modell, Kerbe und Hohlvene statt des eingebauten synthetischen Patienten.</translation>
    </message>
    <message>
        <source>6: the side that is down: left or right.</source>
        <translation>6: die Seite, die unten liegt: left oder right.</translation>
    </message>
    <message>
        <source>Fewer trials: to see whether it runs.</source>
        <translation>Weniger Versuche: um zu sehen, ob es läuft.</translation>
    </message>
    <message>
        <source>The folder for page, table and plot.</source>
        <translation>Der Ordner für Seite, Tabelle und Bild.</translation>
    </message>
    <message>
        <source>NUMBER: is %1. Give 5 or 6: no other figure is measured.</source>
        <translation>NUMBER: ist %1. Geben Sie 5 oder 6 an: Andere Abbildungen werden nicht gemessen.</translation>
    </message>
    <message>
        <source>Measure a figure of the paper again</source>
        <translation>Eine Abbildung des Artikels neu messen</translation>
    </message>
    <message>
        <source>liver (s: synthetic; * not in the atlas)</source>
        <translation>Leber (s: synthetisch; * nicht im Atlas)</translation>
    </message>
    <message>
        <source>Also simulates operations on it, on which every registration of this case then rests: some seconds that no registration takes.</source>
        <translation>Simuliert auch Operationen darauf, auf denen dann jede Registrierung dieses Falls beruht: einige Sekunden, die keine Registrierung mehr braucht.</translation>
    </message>
    <message>
        <source>Also write the surfaces of the liver and each structure into this folder, LPS mm, without the patient&apos;s name.</source>
        <translation>Auch die Oberflächen der Leber und jeder Struktur in diesen Ordner schreiben, LPS mm, ohne den Namen des Patienten.</translation>
    </message>
    <message>
        <source>Of these surfaces: stl, ply, obj or vtp.</source>
        <translation>Format dieser Oberflächen: stl, ply, obj oder vtp.</translation>
    </message>
    <message>
        <source>--format %1: write stl, ply, obj or vtp.</source>
        <translation>--format %1: stl, ply, obj oder vtp schreiben.</translation>
    </message>
    <message>
        <source>The raw views that were recorded with --track&apos;s file: drawn into instead of the case&apos;s video, as of a live device.</source>
        <translation>Die rohen Ansichten, die mit der Datei von --track aufgenommen wurden: in sie wird gezeichnet statt in das Video des Falls, etwa bei einem laufenden Gerät.</translation>
    </message>
    <message>
        <source>The laparoscope stands. Otherwise a hand holds it: it turns about the trocar, comes nearer, goes away and rolls.</source>
        <translation>Das Laparoskop steht. Sonst hält es eine Hand: es dreht sich um den Trokar, kommt näher, geht weg und rollt.</translation>
    </message>
    <message>
        <source>Landmarks that the CT does not show. &apos;build CASE... --out A&apos; makes an atlas of reviewed cases, &apos;evaluate CASE...&apos; foretells each of them by the others, &apos;show&apos; tells what an atlas knows, &apos;show --case C&apos; where a case&apos;s landmarks come from, &apos;transfer --case C&apos; proposes landmarks on a patient&apos;s liver.</source>
        <translation>Landmarken, die das CT nicht zeigt. „build FALL... --out A“ macht einen Atlas aus geprüften Fällen, „evaluate FALL...“ sagt jeden aus den anderen vorher, „show“ sagt, was ein Atlas weiß, „show --case C“, woher die Landmarken eines Falls kommen, „transfer --case C“ schlägt Landmarken auf der Leber eines Patienten vor.</translation>
    </message>
    <message>
        <source>Cases with a model, or folders of cases, for build and evaluate: five at least.</source>
        <translation>Fälle mit einem Modell oder Ordner mit Fällen, für build und evaluate: mindestens fünf.</translation>
    </message>
    <message>
        <source>Take cases whose labels nobody has approved, too.</source>
        <translation>Auch Fälle nehmen, deren Label niemand freigegeben hat.</translation>
    </message>
    <message>
        <source>Proposed by the atlas &apos;%1&apos;.</source>
        <translation>Vom Atlas „%1“ vorgeschlagen.</translation>
    </message>
    <message>
        <source>placed by hand</source>
        <translation>von Hand gesetzt</translation>
    </message>
    <message>
        <source>from statistics</source>
        <translation>aus der Statistik</translation>
    </message>
    <message>
        <source>found in the CT</source>
        <translation>im CT gefunden</translation>
    </message>
    <message>
        <source>used by the registration</source>
        <translation>von der Registrierung verwendet</translation>
    </message>
    <message>
        <source>real livers by the others: vena cava&apos;s course, mean, mm</source>
        <translation>echte Lebern aus den anderen: Verlauf der Vena cava, Mittel, mm</translation>
    </message>
    <message>
        <source>real livers by the others: vena cava&apos;s course, worst liver, mm</source>
        <translation>echte Lebern aus den anderen: Verlauf der Vena cava, schlechteste Leber, mm</translation>
    </message>
    <message>
        <source>real livers by the built-in atlas: vena cava&apos;s course, mean, mm</source>
        <translation>echte Lebern mit dem eingebauten Atlas: Verlauf der Vena cava, Mittel, mm</translation>
    </message>
    <message>
        <source>--review %1: write STRUCTURE=STATE, such as portal_vein=approved; states are %2.</source>
        <translation>--review %1: STRUKTUR=ZUSTAND schreiben, etwa portal_vein=approved; Zustände sind %2.</translation>
    </message>
    <message>
        <source>--only %1: is no structure that is found. Use liver, portal_vein, hepatic_veins, vena_cava, gallbladder or lesions, with commas.</source>
        <translation>--only %1: keine Struktur, die gesucht wird. Möglich sind liver, portal_vein, hepatic_veins, vena_cava, gallbladder, lesions, mit Kommas.</translation>
    </message>
    <message>
        <source>--keep-edited, --replace-edited: give one of them.</source>
        <translation>--keep-edited, --replace-edited: geben Sie eines davon an.</translation>
    </message>
    <message>
        <source>--%1: means nothing with %2. Leave it out.</source>
        <translation>--%1: bedeutet bei %2 nichts. Lassen Sie es weg.</translation>
    </message>
    <message>
        <source>--%1: means nothing without --%2. Leave it out.</source>
        <translation>--%1: bedeutet ohne --%2 nichts. Lassen Sie es weg.</translation>
    </message>
    <message>
        <source>--lesion %1: is not in this model. Its lesions: %2.</source>
        <translation>--lesion %1: gibt es in diesem Modell nicht. Seine Läsionen: %2.</translation>
    </message>
    <message>
        <source>%1 holds what was finished (%2), marked as incomplete.</source>
        <translation>Was fertig war (%2), liegt in %1, als unvollständig gekennzeichnet.</translation>
    </message>
    <message>
        <source>Lists the moments of the live view that a case keeps: number, frame, time in the video, when it was kept, level, title. With --out it writes them: of each the picture with its overlay, both raw pictures, and what was known (JSON). No file names the patient, but a title may.</source>
        <translation>Listet die Momente der Live-Ansicht, die ein Fall aufhebt: Nummer, Bild, Zeit im Video, wann er aufgehoben wurde, Stufe, Titel. Mit --out werden sie geschrieben: von jedem das Bild mit seiner Einblendung, beide Rohbilder und was bekannt war (JSON). Keine Datei nennt den Patienten, ein Titel kann es.</translation>
    </message>
    <message>
        <source>A folder for the pictures; files of the same name are replaced.</source>
        <translation>Ein Ordner für die Bilder; Dateien desselben Namens werden ersetzt.</translation>
    </message>
    <message>
        <source>Without an overlay, because model or calibration were made anew since: %1.</source>
        <translation>Ohne Einblendung, weil Modell oder Kalibrierung seither neu gemacht wurden: %1.</translation>
    </message>
    <message>
        <source>List and write the moments of the live view that a case keeps</source>
        <translation>Die Momente der Live-Ansicht, die ein Fall aufhebt, listen und schreiben</translation>
    </message>
    <message>
        <source>all trials: ten clicks segmented, longest, s</source>
        <translation>alle Versuche: zehn Klicks segmentiert, längste Zeit, s</translation>
    </message>
    <message>
        <source>all trials: one more click, longest, s</source>
        <translation>alle Versuche: ein weiterer Klick, längste Zeit, s</translation>
    </message>
</context>
<context>
    <name>glisson::ui::AgainBox</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Register again</source>
        <translation>Erneut registrieren</translation>
    </message>
    <message>
        <source>The picture stays as it is (R)</source>
        <translation>Das Bild bleibt, wie es ist (R)</translation>
    </message>
    <message>
        <source>Registers with all that was seen of the organ since, while it is followed (R). Taken if it is better by tissue that neither has used.</source>
        <translation>Registriert mit allem, was seither vom Organ gesehen wurde, während es verfolgt wird (R). Übernommen, wenn es nach Gewebe besser ist, das keine von beiden benutzt hat.</translation>
    </message>
    <message>
        <source>Former one</source>
        <translation>Vorige</translation>
    </message>
    <message>
        <source>Take it</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Back to the registration that there was before</source>
        <translation>Zurück zur Registrierung, die vorher da war</translation>
    </message>
    <message>
        <source>Goes over to the new registration although it is no better by its evidence</source>
        <translation>Geht zur neuen Registrierung über, obwohl sie nach ihren Belegen nicht besser ist</translation>
    </message>
</context>
<context>
    <name>glisson::ui::AgainModel</name>
    <message>
        <source>Registering again; the picture stays until it is better.</source>
        <translation>Es wird erneut registriert; das Bild bleibt, bis es besser ist.</translation>
    </message>
    <message>
        <source>Cancelled: the former registration stays.</source>
        <translation>Abgebrochen: die vorige Registrierung bleibt.</translation>
    </message>
    <message>
        <source>Not taken: it lies %1 mm from tissue that neither has used, the former one %2 mm.</source>
        <translation>Nicht übernommen: sie liegt %1 mm von Gewebe, das keine benutzt hat, die vorige %2 mm.</translation>
    </message>
    <message>
        <source>The former registration is back.</source>
        <translation>Die vorige Registrierung ist wieder da.</translation>
    </message>
    <message>
        <source>Registered again: the organ has moved by %1 mm on average. From tissue that neither has used: %2 mm, before %3 mm.</source>
        <translation>Erneut registriert: das Organ hat sich im Mittel um %1 mm bewegt. Abstand von Gewebe, das keine benutzt hat: %2 mm, vorher %3 mm.</translation>
    </message>
    <message>
        <source>Better, but the organ is not followed just now: take it then.</source>
        <translation>Besser, aber das Organ wird gerade nicht verfolgt: dann übernehmen.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::AngleHistogram</name>
    <message>
        <source>Angles between the faces of each element. Flat elements, below 10°, make the computation inexact.</source>
        <translation>Winkel zwischen den Flächen jedes Elements. Flache Elemente, unter 10°, machen die Rechnung ungenau.</translation>
    </message>
    <message>
        <source>Dihedral angles, %1 below 10°</source>
        <translation>Flächenwinkel, %1 unter 10°</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
</context>
<context>
    <name>glisson::ui::AtlasPanel</name>
    <message>
        <source>Landmarks</source>
        <translation>Landmarken</translation>
    </message>
    <message>
        <source>Features that are found again in the laparoscope&apos;s pictures. Check them on the 3D surface and place what is missing.</source>
        <translation>Merkmale, die sich in den Bildern des Laparoskops wiederfinden. Auf der 3D-Oberfläche prüfen und Fehlendes setzen.</translation>
    </message>
    <message>
        <source>Anterior margin</source>
        <translation>Vorderrand</translation>
    </message>
    <message>
        <source>The sharp lower edge, found on the model (white line).</source>
        <translation>Die scharfe Unterkante, am Modell gefunden (weiße Linie).</translation>
    </message>
    <message>
        <source>Umbilical notch</source>
        <translation>Nabelkerbe</translation>
    </message>
    <message>
        <source>Where the round ligament enters (magenta).</source>
        <translation>Wo das runde Leberband eintritt (magenta).</translation>
    </message>
    <message>
        <source>Vena cava</source>
        <translation>Vena cava</translation>
    </message>
    <message>
        <source>Where the liver is attached to it, seen from behind (green).</source>
        <translation>Wo die Leber an ihr hängt, von hinten gesehen (grün).</translation>
    </message>
    <message>
        <source>Acceptance</source>
        <translation>Übernahme</translation>
    </message>
    <message>
        <source>What you see in the 3D view is what the registration will use.</source>
        <translation>Was die 3D-Ansicht zeigt, verwendet die Registrierung.</translation>
    </message>
    <message>
        <source>Accept landmarks</source>
        <translation>Landmarken übernehmen</translation>
    </message>
    <message>
        <source>Place by clicking</source>
        <translation>Klickend setzen</translation>
    </message>
    <message>
        <source>Undo last</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>%1 mm long</source>
        <translation>%1 mm lang</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>nicht gefunden</translation>
    </message>
    <message>
        <source>not placed</source>
        <translation>nicht gesetzt</translation>
    </message>
    <message>
        <source>points: %1</source>
        <translation>Punkte: %1</translation>
    </message>
    <message>
        <source>points of the model: %1, the next click replaces them</source>
        <translation>Punkte des Modells: %1, der nächste Klick ersetzt sie</translation>
    </message>
    <message>
        <source>Proposals</source>
        <translation>Vorschläge</translation>
    </message>
    <message>
        <source>Where they should lie: from the CT where it shows them, else from other livers. Nothing is used before you accept it.</source>
        <translation>Wo sie liegen sollten: aus der CT, wo sie es zeigt, sonst von anderen Lebern. Nichts wird verwendet, bevor Sie es annehmen.</translation>
    </message>
    <message>
        <source>Shapes of livers</source>
        <translation>Formen von Lebern</translation>
    </message>
    <message>
        <source>What the atlas knows of how livers differ. Nothing of the case changes.</source>
        <translation>Was der Atlas darüber weiß, wie sich Lebern unterscheiden. Am Fall ändert sich nichts.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::Autosaver</name>
    <message>
        <source>a case that had never been saved</source>
        <translation>ein Fall, der nie gespeichert worden war</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>Wiederherstellung</translation>
    </message>
    <message>
        <source>Glisson ended before this was saved: %1, as it was at %2.</source>
        <translation>Glisson endete, bevor dies gespeichert war: %1, Stand von %2.</translation>
    </message>
    <message>
        <source>It can be opened as it was then. Nothing is saved in its place until you save it.</source>
        <translation>Er kann so geöffnet werden, wie er damals war. An seiner Stelle wird nichts gespeichert, bis Sie ihn speichern.</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Throw it away</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Ask later</source>
        <translation>Später fragen</translation>
    </message>
</context>
<context>
    <name>glisson::ui::BridgeList</name>
    <message>
        <source>Looking for places where the trees touch…</source>
        <translation>Stellen suchen, an denen sich die Bäume berühren…</translation>
    </message>
    <message>
        <source>The trees touch: %1 mm²</source>
        <translation>Die Bäume berühren sich: %1 mm²</translation>
    </message>
    <message>
        <source>A neck of %1 mm², %2 ml beyond it</source>
        <translation>Ein Hals von %1 mm², %2 ml dahinter</translation>
    </message>
    <message>
        <source>The trees touch nowhere, and no part hangs by a neck.</source>
        <translation>Die Bäume berühren sich nirgends, und nichts hängt an einem Hals.</translation>
    </message>
    <message>
        <source>Suspicious places. Click one to go there; cut where the branch is wrong.</source>
        <translation>Verdächtige Stellen. Anklicken führt hin; abschneiden, wo der Ast falsch ist.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::CalibrationDialog</name>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>Calibrate from boards</source>
        <translation>Mit Tafeln kalibrieren</translation>
    </message>
    <message>
        <source>Ten pairs of pictures or more of a chessboard or a ChArUco board, near and far, slanted to all sides, up to the pictures&apos; borders.</source>
        <translation>Zehn oder mehr Bildpaare eines Schachbretts oder einer ChArUco-Tafel, nah und fern, nach allen Seiten geneigt, bis an die Ränder der Bilder.</translation>
    </message>
    <message>
        <source>folder of left and right pictures</source>
        <translation>Ordner mit linken und rechten Bildern</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Auswählen …</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Chessboard</source>
        <translation>Schachbrett</translation>
    </message>
    <message>
        <source>ChArUco, %1</source>
        <translation>ChArUco, %1</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Tafel</translation>
    </message>
    <message>
        <source>Inner corners</source>
        <translation>Innere Ecken</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Side of a square</source>
        <translation>Seite eines Feldes</translation>
    </message>
    <message>
        <source>Side of a marker</source>
        <translation>Seite einer Marke</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>Folder of left and right pictures</source>
        <translation>Ordner mit linken und rechten Bildern</translation>
    </message>
    <message>
        <source>Choose the folder of pictures first.</source>
        <translation>Wählen Sie zuerst den Ordner mit den Bildern.</translation>
    </message>
    <message>
        <source>Views used</source>
        <translation>Verwendete Ansichten</translation>
    </message>
    <message>
        <source>%1 of %2 pairs</source>
        <translation>%1 von %2 Paaren</translation>
    </message>
    <message>
        <source>Error, both cameras</source>
        <translation>Fehler, beide Kameras</translation>
    </message>
    <message>
        <source>Rows off, view left out</source>
        <translation>Zeilenversatz, Ansicht weggelassen</translation>
    </message>
    <message>
        <source>Picture covered</source>
        <translation>Abgedecktes Bild</translation>
    </message>
    <message>
        <source>%1 % left, %2 % right</source>
        <translation>%1 % links, %2 % rechts</translation>
    </message>
    <message>
        <source>Baseline</source>
        <translation>Basislänge</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Calibrate with the views ticked</source>
        <translation>Mit den angekreuzten Ansichten kalibrieren</translation>
    </message>
    <message>
        <source>This is the calibration with the views ticked.</source>
        <translation>Dies ist die Kalibrierung mit den angekreuzten Ansichten.</translation>
    </message>
    <message>
        <source>Views of the board that were not needed, because the others differ more: %1.</source>
        <translation>Ansichten der Tafel, die nicht gebraucht wurden, weil die anderen sich mehr unterscheiden: %1.</translation>
    </message>
    <message>
        <source>The board was not found in both pictures of: %1.</source>
        <translation>Die Tafel wurde nicht in beiden Bildern gefunden von: %1.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::CalibrationResults</name>
    <message>
        <source>Views of the board</source>
        <translation>Ansichten der Tafel</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Left, px</source>
        <translation>Links, px</translation>
    </message>
    <message>
        <source>Right, px</source>
        <translation>Rechts, px</translation>
    </message>
    <message>
        <source>Rows off, px</source>
        <translation>Zeilen, px</translation>
    </message>
    <message>
        <source>Distance, mm</source>
        <translation>Abstand, mm</translation>
    </message>
    <message>
        <source>Tilt, °</source>
        <translation>Neigung, °</translation>
    </message>
    <message>
        <source>Error of the corners in the left picture, rms</source>
        <translation>Fehler der Ecken im linken Bild, RMS</translation>
    </message>
    <message>
        <source>Error of the corners in the right picture, rms</source>
        <translation>Fehler der Ecken im rechten Bild, RMS</translation>
    </message>
    <message>
        <source>How far the view&apos;s rows disagree by a calibration that has not seen it, rms</source>
        <translation>Wie weit die Zeilen der Ansicht nach einer Kalibrierung auseinanderliegen, die sie nicht gesehen hat, RMS</translation>
    </message>
    <message>
        <source>Views that fit far worse than the others come without a tick. Untick what is blurred or was moved.</source>
        <translation>Ansichten, die viel schlechter passen als die anderen, sind nicht angekreuzt. Nehmen Sie das Kreuz weg, wo etwas unscharf ist oder bewegt wurde.</translation>
    </message>
    <message>
        <source>Fits far worse than the others: proposed for removal</source>
        <translation>Passt viel schlechter als die anderen: zum Weglassen vorgeschlagen</translation>
    </message>
</context>
<context>
    <name>glisson::ui::CorrectionBox</name>
    <message>
        <source>Correct by hand</source>
        <translation>Von Hand korrigieren</translation>
    </message>
    <message>
        <source>Drag a place of the drawn organ (margin, notch, vessel, surface) to where the picture shows it (C, or drag with Shift).</source>
        <translation>Ziehen Sie eine Stelle des gezeichneten Organs (Rand, Kerbe, Gefäß, Oberfläche) dorthin, wo das Bild sie zeigt (C, oder mit Umschalt ziehen).</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Take the last correction back (Ctrl+Z in the picture)</source>
        <translation>Die letzte Korrektur zurücknehmen (Strg+Z im Bild)</translation>
    </message>
</context>
<context>
    <name>glisson::ui::CorrectionModel</name>
    <message>
        <source>There is no overlay that could be corrected.</source>
        <translation>Es gibt kein Overlay, das korrigiert werden könnte.</translation>
    </message>
    <message>
        <source>There is nothing of the drawn organ. Take hold of its margin, its notch, a vessel or its surface.</source>
        <translation>Dort ist nichts vom gezeichneten Organ. Fassen Sie den Rand, die Kerbe, ein Gefäß oder die Oberfläche an.</translation>
    </message>
    <message>
        <source>a place of the surface</source>
        <translation>eine Stelle der Oberfläche</translation>
    </message>
    <message>
        <source>the anterior margin</source>
        <translation>der vordere Rand</translation>
    </message>
    <message>
        <source>the notch</source>
        <translation>die Kerbe</translation>
    </message>
    <message>
        <source>a vessel</source>
        <translation>ein Gefäß</translation>
    </message>
    <message>
        <source>In the hand: %1. Drag it to where the picture shows it.</source>
        <translation>In der Hand: %1. Ziehen Sie dorthin, wo das Bild es zeigt.</translation>
    </message>
    <message>
        <source>Corrected by hand: %1. The last one moved the organ by %2 mm on average.</source>
        <translation>Von Hand korrigiert: %1. Die letzte Korrektur hat das Organ im Mittel um %2 mm bewegt.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::CoverageView</name>
    <message>
        <source>Covered by boards, left and right</source>
        <translation>Von Tafeln bedeckt, links und rechts</translation>
    </message>
    <message>
        <source>Shaded: where a board lay. What no board has covered is extrapolated. Blue: views used, orange: proposed for removal or left out. The chosen view is brought out.</source>
        <translation>Schattiert: wo eine Tafel lag. Was keine Tafel bedeckt hat, ist extrapoliert. Blau: verwendete Ansichten, orange: zum Weglassen vorgeschlagen oder weggelassen. Die gewählte Ansicht ist hervorgehoben.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::EditBox</name>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Eingabetaste</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Hatched in the slices: what would change</source>
        <translation>Schraffiert in den Schichten: was sich ändern würde</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Where tools may change anything</source>
        <translation>Wo Werkzeuge etwas ändern dürfen</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Only these intensities</source>
        <translation>Nur diese Intensitäten</translation>
    </message>
    <message>
        <source> HU</source>
        <translation> HE</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Überall</translation>
    </message>
    <message>
        <source>Nothing is overwritten</source>
        <translation>Nichts wird überschrieben</translation>
    </message>
    <message>
        <source>Inside any label</source>
        <translation>In jedem Label</translation>
    </message>
    <message>
        <source>Inside the liver</source>
        <translation>In der Leber</translation>
    </message>
    <message>
        <source>Inside: %1</source>
        <translation>In: %1</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Wiederholen: %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Nothing would change.</source>
        <translation>Nichts würde sich ändern.</translation>
    </message>
    <message>
        <source>%1 ml would change.</source>
        <translation>%1 ml würden sich ändern.</translation>
    </message>
    <message>
        <source>Click the other end. Ctrl adds a point between, Esc drops the way.</source>
        <translation>Klicken Sie das andere Ende an. Strg fügt einen Punkt dazwischen hinzu, Esc verwirft den Weg.</translation>
    </message>
    <message>
        <source>%1: %2 → %3 ml</source>
        <translation>%1: %2 → %3 ml</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
</context>
<context>
    <name>glisson::ui::GuidancePanel</name>
    <message>
        <source>Guidance</source>
        <translation>Navigation</translation>
    </message>
    <message>
        <source>The model brought to what the laparoscope sees, and kept there.</source>
        <translation>Das Modell wird dorthin gebracht, wo das Laparoskop die Leber sieht, und dort gehalten.</translation>
    </message>
    <message>
        <source>1. Initial registration</source>
        <translation>1. Erste Registrierung</translation>
    </message>
    <message>
        <source>Rigid start from the labelled features; then the shape that simulated operations on this liver make most probable, drawn to the points.</source>
        <translation>Starrer Start aus den markierten Merkmalen; dann die Form, die simulierte Operationen an dieser Leber am wahrscheinlichsten machen, zu den Punkten gezogen.</translation>
    </message>
    <message>
        <source>2. Live tracking</source>
        <translation>2. Live-Verfolgung</translation>
    </message>
    <message>
        <source>Plays the case&apos;s stereo video as a live laparoscope.</source>
        <translation>Spielt das Stereovideo des Falls wie ein Laparoskop ab.</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Einblendung</translation>
    </message>
    <message>
        <source>Placed by hand: not registered. Refine, or put it back.</source>
        <translation>Von Hand angelegt: nicht registriert. Verfeinern oder zurücklegen.</translation>
    </message>
    <message>
        <source>Other place %1, to be compared: not the registration.</source>
        <translation>Anderer Ort %1, zum Vergleich: nicht die Registrierung.</translation>
    </message>
    <message>
        <source>Other programs</source>
        <translation>Andere Programme</translation>
    </message>
    <message>
        <source>3D Slicer, CustusX or PLUS may follow what is tracked here.</source>
        <translation>3D Slicer, CustusX oder PLUS können dem folgen, was hier verfolgt wird.</translation>
    </message>
    <message>
        <source>The recording is being brought to its end. If all went well, the window closes then.</source>
        <translation>Die Aufnahme wird zu Ende gebracht. Ging alles gut, schließt sich danach das Fenster.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::GuidanceView</name>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Organ in 3D, expected error</source>
        <translation>Organ in 3D, erwarteter Fehler</translation>
    </message>
    <message>
        <source>The organ as it was registered, in the colours of the error that is expected at each place, with each lesion&apos;s region.</source>
        <translation>Das Organ, wie es registriert wurde, in den Farben des Fehlers, der an jedem Ort erwartet wird, mit dem Bereich jeder Läsion.</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Beide</translation>
    </message>
    <message>
        <source>Picture and organ. While a video is followed the organ goes with the picture.</source>
        <translation>Bild und Organ. Während ein Video verfolgt wird, geht das Organ mit dem Bild.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::ImageImport</name>
    <message>
        <source>CT or MRI?</source>
        <translation>CT oder MRT?</translation>
    </message>
    <message>
        <source>%1 does not say whether it is a CT or an MRI.</source>
        <translation>%1 sagt nicht, ob es ein CT oder eine MRT ist.</translation>
    </message>
    <message>
        <source>MRI</source>
        <translation>MRT</translation>
    </message>
    <message>
        <source>CT</source>
        <translation>CT</translation>
    </message>
    <message>
        <source>Neither</source>
        <translation>Keines von beiden</translation>
    </message>
</context>
<context>
    <name>glisson::ui::LabelMeanings</name>
    <message>
        <source>%1 does not say what each label is. Say it here; what you leave out becomes background.</source>
        <translation>%1 sagt nicht, was jedes Label ist. Sagen Sie es hier; was Sie auslassen, wird Hintergrund.</translation>
    </message>
    <message>
        <source>Import labels</source>
        <translation>Labels importieren</translation>
    </message>
    <message>
        <source>Label in the file</source>
        <translation>Label in der Datei</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Is</source>
        <translation>Ist</translation>
    </message>
    <message>
        <source>Say which one is the liver.</source>
        <translation>Sagen Sie, welches die Leber ist.</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>As Glisson numbers them</source>
        <translation>Wie Glisson sie nummeriert</translation>
    </message>
    <message>
        <source>For files that Glisson has written without names: 1 is the liver, 2 the portal vein, from 16 on lesions. Other programs number otherwise.</source>
        <translation>Für Dateien, die Glisson ohne Namen geschrieben hat: 1 ist die Leber, 2 die Pfortader, ab 16 Läsionen. Andere Programme nummerieren anders.</translation>
    </message>
    <message>
        <source>%1 ml</source>
        <translation>%1 ml</translation>
    </message>
    <message>
        <source>Not imported</source>
        <translation>Nicht importiert</translation>
    </message>
    <message>
        <source>Lesion</source>
        <translation>Läsion</translation>
    </message>
</context>
<context>
    <name>glisson::ui::LabelTable</name>
    <message>
        <source>Label</source>
        <translation>Label</translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>HU</source>
        <translation>HE</translation>
    </message>
    <message>
        <source>⌀ mm</source>
        <translation>⌀ mm</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Mean intensity</source>
        <translation>Mittlere Intensität</translation>
    </message>
    <message>
        <source>Longest diameter of a lesion</source>
        <translation>Längster Durchmesser einer Läsion</translation>
    </message>
    <message>
        <source>%1: click to change</source>
        <translation>%1: zum Ändern klicken</translation>
    </message>
    <message>
        <source>%1 ± %2 HU</source>
        <translation>%1 ± %2 HE</translation>
    </message>
    <message>
        <source>Hidden: click to show</source>
        <translation>Verborgen: zum Zeigen klicken</translation>
    </message>
    <message>
        <source>Shown: click to hide</source>
        <translation>Sichtbar: zum Verbergen klicken</translation>
    </message>
    <message>
        <source>Locked: neither loses nor gains voxels. Click to unlock</source>
        <translation>Gesperrt: verliert und bekommt keine Voxel. Zum Entsperren klicken</translation>
    </message>
    <message>
        <source>Click to lock: it neither loses nor gains voxels</source>
        <translation>Zum Sperren klicken: verliert und bekommt dann keine Voxel</translation>
    </message>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grau</translation>
    </message>
</context>
<context>
    <name>glisson::ui::LesionBox</name>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>How far from the place shown it may be in 95 of 100 cases, as the registration expects.</source>
        <translation>Wie weit sie in 95 von 100 Fällen vom gezeigten Ort entfernt sein kann, wie es die Registrierung erwartet.</translation>
    </message>
    <message>
        <source>Click a lesion, here or in the picture. Click with the right button where a tool touches the organ: the distance from there is told, too. Esc lets go.</source>
        <translation>Klicken Sie eine Läsion an, hier oder im Bild. Klicken Sie mit der rechten Taste, wo ein Instrument das Organ berührt: auch der Abstand von dort wird genannt. Esc lässt los.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Lesion, fork</source>
        <translation>Läsion, Gabel</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>Lesions, and the largest forks of portal vein and hepatic veins (1: the widest).</source>
        <translation>Läsionen und die größten Gabeln von Pfortader und Lebervenen (1: die weiteste).</translation>
    </message>
    <message>
        <source>Mean error that the registration expects there.</source>
        <translation>Mittlerer Fehler, den die Registrierung dort erwartet.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::LinkedViews</name>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>Look from the front (anterior)</source>
        <translation>Von vorn (anterior)</translation>
    </message>
    <message>
        <source>P</source>
        <translation>P</translation>
    </message>
    <message>
        <source>Look from behind (posterior)</source>
        <translation>Von hinten (posterior)</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>Look from the patient&apos;s right</source>
        <translation>Von der rechten Seite des Patienten</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>Look from the patient&apos;s left</source>
        <translation>Von der linken Seite des Patienten</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>Look from above (superior)</source>
        <translation>Von oben (superior)</translation>
    </message>
    <message>
        <source>I</source>
        <translation>I</translation>
    </message>
    <message>
        <source>Look from below (inferior)</source>
        <translation>Von unten (inferior)</translation>
    </message>
    <message>
        <source>Look from</source>
        <translation>Blick von</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>Show the three slices in the 3D view</source>
        <translation>Die drei Schichten in der 3D-Ansicht zeigen</translation>
    </message>
    <message>
        <source>No volume</source>
        <translation>Kein Volumen</translation>
    </message>
    <message>
        <source>Preparing the model for drawing…</source>
        <translation>Das Modell wird zum Zeichnen vorbereitet…</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>außerhalb</translation>
    </message>
    <message>
        <source>%1 HU</source>
        <translation>%1 HE</translation>
    </message>
    <message>
        <source>Preparing the surfaces…</source>
        <translation>Oberflächen werden vorbereitet…</translation>
    </message>
</context>
<context>
    <name>glisson::ui::LiveView</name>
    <message>
        <source>Register the model to a frame of the laparoscope; the augmented picture appears here.</source>
        <translation>Das Modell zu einem Bild des Laparoskops registrieren; hier erscheint dann das Bild mit der Einblendung.</translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation>Bild…</translation>
    </message>
    <message>
        <source>Save the picture as it is drawn (P)</source>
        <translation>Das Bild so speichern, wie es gezeichnet ist (P)</translation>
    </message>
    <message>
        <source>Whole screen (F11)</source>
        <translation>Ganzer Bildschirm (F11)</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Das Bild speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg)</source>
        <translation>Bilder (*.png *.jpg)</translation>
    </message>
    <message>
        <source>Raw</source>
        <translation>Roh</translation>
    </message>
    <message>
        <source>The raw picture beside the overlay (B)</source>
        <translation>Das rohe Bild neben der Einblendung (B)</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>The right picture with its overlay: a wrong depth shows in one of the two (V)</source>
        <translation>Das rechte Bild mit seiner Einblendung: eine falsche Tiefe zeigt sich in einem der beiden (V)</translation>
    </message>
    <message>
        <source>There is no right picture of this frame.</source>
        <translation>Von diesem Bild gibt es kein rechtes.</translation>
    </message>
    <message>
        <source>Back to live (Esc)</source>
        <translation>Zurück zu live (Esc)</translation>
    </message>
</context>
<context>
    <name>glisson::ui::LiveViewModel</name>
    <message>
        <source>Not live</source>
        <translation>Nicht live</translation>
    </message>
    <message>
        <source>Registered frame %1, not live</source>
        <translation>Registriertes Bild %1, nicht live</translation>
    </message>
    <message>
        <source>Frame %1, not live</source>
        <translation>Bild %1, nicht live</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Tracked points, left / right</source>
        <translation>Verfolgte Punkte, links / rechts</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Paare</translation>
    </message>
    <message>
        <source>Residual (not an accuracy)</source>
        <translation>Restabstand (keine Genauigkeit)</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Tracking and mechanics</source>
        <translation>Verfolgung und Mechanik</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Frames late / dropped</source>
        <translation>Bilder zu spät / ausgelassen</translation>
    </message>
    <message>
        <source>LIVE   frame %1   age %2 ms   %3 frames/s</source>
        <translation>LIVE   Bild %1   Alter %2 ms   %3 Bilder/s</translation>
    </message>
    <message>
        <source>   NO OVERLAY: %1</source>
        <translation>   KEINE EINBLENDUNG: %1</translation>
    </message>
    <message>
        <source>The picture is %1 s old: the overlay does not show where things are now.</source>
        <translation>Das Bild ist %1 s alt: Die Einblendung zeigt nicht, wo die Dinge jetzt sind.</translation>
    </message>
    <message>
        <source>The overlay is being prepared: the picture shows none yet.</source>
        <translation>Die Einblendung wird vorbereitet: Das Bild zeigt noch keine.</translation>
    </message>
    <message>
        <source>   OUTLINE ONLY: %1</source>
        <translation>   NUR UMRISS: %1</translation>
    </message>
    <message>
        <source>Looked at again: frame %1 as it was followed, not live.</source>
        <translation>Nochmals betrachtet: Bild %1, wie es verfolgt wurde, nicht live.</translation>
    </message>
    <message>
        <source>Frame %1, recorded, not live</source>
        <translation>Bild %1, aufgezeichnet, nicht live</translation>
    </message>
    <message>
        <source>There is no picture to save.</source>
        <translation>Es gibt kein Bild zu speichern.</translation>
    </message>
    <message>
        <source>Paused. The picture is not live.</source>
        <translation>Angehalten. Das Bild ist nicht live.</translation>
    </message>
    <message>
        <source>Paused at frame %1, not live</source>
        <translation>Angehalten bei Bild %1, nicht live</translation>
    </message>
    <message>
        <source>Camera to screen, median / 99 %</source>
        <translation>Kamera bis Schirm, Median / 99 %</translation>
    </message>
    <message>
        <source>%1 / %2 ms</source>
        <translation>%1 / %2 ms</translation>
    </message>
    <message>
        <source>On the screen</source>
        <translation>Auf dem Schirm</translation>
    </message>
    <message>
        <source>%1 frames/s</source>
        <translation>%1 Bilder/s</translation>
    </message>
    <message>
        <source>A former picture, not live.</source>
        <translation>Ein früheres Bild, nicht live.</translation>
    </message>
    <message>
        <source>KEPT MOMENT %1 – NOT LIVE</source>
        <translation>AUFGEHOBENER MOMENT %1 – NICHT LIVE</translation>
    </message>
    <message>
        <source>Kept moment %1, not live: %2</source>
        <translation>Aufgehobener Moment %1, nicht live: %2</translation>
    </message>
    <message>
        <source>Model or calibration were made anew since: its overlay cannot be drawn as it was. The picture is shown without.</source>
        <translation>Modell oder Kalibrierung wurden seither neu gemacht: Seine Einblendung kann nicht gezeichnet werden, wie sie war. Das Bild wird ohne sie gezeigt.</translation>
    </message>
    <message>
        <source>Kept moment %1, frame %2, not live</source>
        <translation>Aufgehobener Moment %1, Bild %2, nicht live</translation>
    </message>
</context>
<context>
    <name>glisson::ui::LoadTrialBox</name>
    <message>
        <source>Try a load</source>
        <translation>Belastung ausprobieren</translation>
    </message>
    <message>
        <source>Preparing…</source>
        <translation>Wird vorbereitet …</translation>
    </message>
    <message>
        <source>Press on the liver in the 3D view and drag.</source>
        <translation>Auf die Leber in der 3D-Ansicht drücken und ziehen.</translation>
    </message>
    <message>
        <source>The model has changed: the trial has ended.</source>
        <translation>Das Modell hat sich geändert: Der Versuch ist beendet.</translation>
    </message>
    <message>
        <source>Stopped: the computation did not converge under this pull. The rest shape is drawn.</source>
        <translation>Angehalten: Die Rechnung konvergierte bei diesem Zug nicht. Gezeigt wird die Ruheform.</translation>
    </message>
    <message>
        <source>Stopped: this pull turns elements of the mesh inside out. The rest shape is drawn. Pull less, or elsewhere.</source>
        <translation>Angehalten: Dieser Zug stülpt Elemente des Netzes um. Gezeigt wird die Ruheform. Weniger oder an anderer Stelle ziehen.</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>%1 Hz   %2 ms a step   %3 elements</source>
        <translation>%1 Hz   %2 ms je Schritt   %3 Elemente</translation>
    </message>
    <message>
        <source>%1 ms a step   %2 elements</source>
        <translation>%1 ms je Schritt   %2 Elemente</translation>
    </message>
    <message>
        <source>Pull %1 N, organ moved by up to %2 mm</source>
        <translation>Zug %1 N, Organ bis zu %2 mm bewegt</translation>
    </message>
</context>
<context>
    <name>glisson::ui::LookBox</name>
    <message>
        <source>Portal vein</source>
        <translation>Pfortader</translation>
    </message>
    <message>
        <source>Hepatic veins</source>
        <translation>Lebervenen</translation>
    </message>
    <message>
        <source>Lesions</source>
        <translation>Läsionen</translation>
    </message>
    <message>
        <source>Liver outline</source>
        <translation>Leberumriss</translation>
    </message>
    <message>
        <source>Anterior margin</source>
        <translation>Vorderrand</translation>
    </message>
    <message>
        <source>Vessel opacity</source>
        <translation>Deckkraft der Gefäße</translation>
    </message>
    <message>
        <source>Tubes</source>
        <translation>Röhren</translation>
    </message>
    <message>
        <source>Shaded, and fainter with depth</source>
        <translation>Schattiert und mit der Tiefe blasser</translation>
    </message>
    <message>
        <source>Focus window</source>
        <translation>Fokusfenster</translation>
    </message>
    <message>
        <source>Around the pointer, or else the chosen lesion: opaque and in depth order; outlines elsewhere</source>
        <translation>Um den Zeiger, sonst um die gewählte Läsion: deckend und in der Reihenfolge der Tiefe; anderswo Umrisse</translation>
    </message>
    <message>
        <source>Depth contours</source>
        <translation>Tiefenlinien</translation>
    </message>
    <message>
        <source>A line at every 10 mm of depth below the surface</source>
        <translation>Eine Linie alle 10 mm Tiefe unter der Oberfläche</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Umrisse</translation>
    </message>
    <message>
        <source>They hide least of the tissue</source>
        <translation>Sie verdecken am wenigsten Gewebe</translation>
    </message>
    <message>
        <source>Depth as</source>
        <translation>Tiefe als</translation>
    </message>
    <message>
        <source>Thin branches</source>
        <translation>Dünne Äste</translation>
    </message>
    <message>
        <source>Ruler</source>
        <translation>Lineal</translation>
    </message>
</context>
<context>
    <name>glisson::ui::LooksRow</name>
    <message>
        <source>Keep this look</source>
        <translation>Blick merken</translation>
    </message>
    <message>
        <source>Keeps these points. Then move the laparoscope, not the organ, and reconstruct again: registration joins all looks and finds out itself where each was seen from.</source>
        <translation>Merkt sich diese Punkte. Bewegen Sie dann das Laparoskop, nicht das Organ, und rekonstruieren Sie erneut: Die Registrierung nimmt alle Blicke zusammen und findet selbst heraus, von wo jeder gesehen wurde.</translation>
    </message>
    <message>
        <source>Forget looks</source>
        <translation>Blicke verwerfen</translation>
    </message>
    <message>
        <source>The organ has moved since: registration goes by the present points alone</source>
        <translation>Das Organ hat sich seither bewegt: Die Registrierung richtet sich nur nach den jetzigen Punkten</translation>
    </message>
    <message>
        <source>No earlier look is kept.</source>
        <translation>Kein früherer Blick ist gemerkt.</translation>
    </message>
    <message>
        <source>Earlier looks that registration joins: %1</source>
        <translation>Frühere Blicke, die die Registrierung dazunimmt: %1</translation>
    </message>
    <message>
        <source>Kept. Now look from elsewhere and reconstruct again.</source>
        <translation>Gemerkt. Nun von anderswo blicken und erneut rekonstruieren.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::MainWindow</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;DICOM folder…</source>
        <translation>&amp;DICOM-Ordner…</translation>
    </message>
    <message>
        <source>&amp;Volume…</source>
        <translation>&amp;Volumen…</translation>
    </message>
    <message>
        <source>&amp;Case…</source>
        <translation>&amp;Fall…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>S&amp;chritt</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;About Glisson</source>
        <translation>&amp;Über Glisson</translation>
    </message>
    <message>
        <source>About Glisson</source>
        <translation>Über Glisson</translation>
    </message>
    <message>
        <source>&lt;b&gt;Glisson&lt;/b&gt;&lt;br&gt;Planning and guidance of minimally invasive liver surgery, after Plantefève, Peterlik, Haouchine and Cotin (2015).&lt;br&gt;&lt;br&gt;Research software: not for clinical use.&lt;br&gt;Licence: GPL-3.0-or-later.</source>
        <translation>&lt;b&gt;Glisson&lt;/b&gt;&lt;br&gt;Planung und Navigation minimalinvasiver Leberchirurgie nach Plantefève, Peterlik, Haouchine und Cotin (2015).&lt;br&gt;&lt;br&gt;Forschungssoftware: nicht für den klinischen Gebrauch.&lt;br&gt;Lizenz: GPL-3.0-or-later.</translation>
    </message>
    <message>
        <source>%1 is nothing that Glisson opens. Give a folder of DICOM slices, a volume (NIfTI, NRRD, MetaImage) or a case (NAME.glisson).</source>
        <translation>%1 kann Glisson nicht öffnen. Möglich sind ein Ordner mit DICOM-Schichten, ein Volumen (NIfTI, NRRD, MetaImage) oder ein Fall (NAME.glisson).</translation>
    </message>
    <message>
        <source>Glisson</source>
        <translation>Glisson</translation>
    </message>
    <message>
        <source>Open a case (a folder NAME.glisson)</source>
        <translation>Fall öffnen (ein Ordner NAME.glisson)</translation>
    </message>
    <message>
        <source>Open a folder of DICOM slices</source>
        <translation>Ordner mit DICOM-Schichten öffnen</translation>
    </message>
    <message>
        <source>Open a volume</source>
        <translation>Volumen öffnen</translation>
    </message>
    <message>
        <source>Save the case as a folder</source>
        <translation>Fall als Ordner speichern</translation>
    </message>
    <message>
        <source>Cases (*.glisson)</source>
        <translation>Fälle (*.glisson)</translation>
    </message>
    <message>
        <source>unsaved case</source>
        <translation>ungespeicherter Fall</translation>
    </message>
    <message>
        <source>%1[*] – Glisson</source>
        <translation>%1[*] – Glisson</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>The case has changes that are not saved.</source>
        <translation>Der Fall hat Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>The case has changes that are not saved. Opening another loses them.</source>
        <translation>Der Fall hat Änderungen, die nicht gespeichert sind. Beim Öffnen eines anderen gehen sie verloren.</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>Export &amp;labels…</source>
        <translation>&amp;Labels exportieren …</translation>
    </message>
    <message>
        <source>Export labels</source>
        <translation>Labels exportieren</translation>
    </message>
    <message>
        <source>Open a CT</source>
        <translation>CT öffnen</translation>
    </message>
    <message>
        <source>Is this CT of another patient, or another one of the patient who is open?</source>
        <translation>Ist dieses CT von einem anderen Patienten oder ein weiteres des geöffneten?</translation>
    </message>
    <message>
        <source>A new case loses the changes of this one, which are not saved. The same patient&apos;s case keeps everything, marked out of date.</source>
        <translation>Ein neuer Fall verwirft die nicht gespeicherten Änderungen an diesem. Beim selben Patienten bleibt alles, als veraltet markiert.</translation>
    </message>
    <message>
        <source>The same patient&apos;s case keeps everything, marked out of date.</source>
        <translation>Beim selben Patienten bleibt alles, als veraltet markiert.</translation>
    </message>
    <message>
        <source>New case</source>
        <translation>Neuer Fall</translation>
    </message>
    <message>
        <source>Same patient</source>
        <translation>Derselbe Patient</translation>
    </message>
    <message>
        <source>%1 (for reading)[*] – Glisson</source>
        <translation>%1 (zum Lesen)[*] – Glisson</translation>
    </message>
    <message>
        <source>%1 is not there any more. It was taken from the list.</source>
        <translation>%1 ist nicht mehr da. Der Eintrag wurde aus der Liste genommen.</translation>
    </message>
    <message>
        <source>Labels (*.seg.nrrd *.dcm *.nii.gz *.nrrd *.mha)</source>
        <translation>Labels (*.seg.nrrd *.dcm *.nii.gz *.nrrd *.mha)</translation>
    </message>
    <message>
        <source>A new segmentation waits for your decision (Segmentation). Closing lets it go; your labels are kept as they are.</source>
        <translation>Eine neue Segmentierung wartet auf Ihre Entscheidung (Segmentierung). Beim Schließen geht sie verloren; Ihre Labels bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>Volumes (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.vti *.zip *.tar.gz *.tgz *.tar DICOMDIR dicomdir)</source>
        <translation>Volumen (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.vti *.zip *.tar.gz *.tgz *.tar DICOMDIR dicomdir)</translation>
    </message>
    <message>
        <source>A new segmentation waits for your decision (Segmentation). Opening this lets it go.</source>
        <translation>Eine neue Segmentierung wartet auf Ihre Entscheidung (Segmentierung). Dies zu öffnen verwirft sie.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Export s&amp;urfaces…</source>
        <translation>O&amp;berflächen exportieren …</translation>
    </message>
    <message>
        <source>Export surfaces into a folder</source>
        <translation>Oberflächen in einen Ordner exportieren</translation>
    </message>
</context>
<context>
    <name>glisson::ui::MaskBox</name>
    <message>
        <source>Your own network that says what of the picture is not liver: an ONNX file with its sheet, MODEL.json, beside it. It only keeps points from pulling the model.</source>
        <translation>Ihr eigenes Netz, das sagt, was vom Bild nicht Leber ist: eine ONNX-Datei mit ihrem Blatt MODEL.json daneben. Es hält nur Punkte davon ab, am Modell zu ziehen.</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>The organ is followed without the network, at once</source>
        <translation>Das Organ wird sofort ohne das Netz verfolgt</translation>
    </message>
    <message>
        <source>Mask network</source>
        <translation>Maskennetz</translation>
    </message>
    <message>
        <source>Networks (*.onnx)</source>
        <translation>Netze (*.onnx)</translation>
    </message>
    <message>
        <source>Mask network…</source>
        <translation>Maskennetz…</translation>
    </message>
    <message>
        <source>Mask: %1</source>
        <translation>Maske: %1</translation>
    </message>
</context>
<context>
    <name>glisson::ui::MaskModel</name>
    <message>
        <source>The mask network has failed; the organ is followed without it. %1</source>
        <translation>Das Maskennetz ist ausgefallen; das Organ wird ohne es verfolgt. %1</translation>
    </message>
    <message>
        <source>The mask network has no mask yet; the organ is followed without it.</source>
        <translation>Das Maskennetz hat noch keine Maske; das Organ wird ohne es verfolgt.</translation>
    </message>
    <message>
        <source>The mask network is too slow: its last mask is %1 s old and is not used.</source>
        <translation>Das Maskennetz ist zu langsam: Seine letzte Maske ist %1 s alt und wird nicht benutzt.</translation>
    </message>
    <message>
        <source>Masked of the organ in sight: %1 %. The mask is %2 ms old.</source>
        <translation>Vom sichtbaren Organ maskiert: %1 %. Die Maske ist %2 ms alt.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::ModelPanel</name>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>A mesh of the liver with its vessels, ready for mechanics.</source>
        <translation>Ein Netz der Leber mit ihren Gefäßen, bereit für die Mechanik.</translation>
    </message>
    <message>
        <source>Build from the labels</source>
        <translation>Aus den Labels bauen</translation>
    </message>
    <message>
        <source>Portal and hepatic vessels stiffen the model</source>
        <translation>Gefäße versteifen das Modell</translation>
    </message>
    <message>
        <source>Build model</source>
        <translation>Modell bauen</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Güte</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Liver opacity</source>
        <translation>Deckkraft der Leber</translation>
    </message>
    <message>
        <source>Folder of surfaces, named by structure</source>
        <translation>Ordner mit Oberflächen, nach Struktur benannt</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Mechanics</source>
        <translation>Mechanik</translation>
    </message>
    <message>
        <source>Drag a point of the liver and see it follow with its vessels and lesions. It is held at the vena cava and where vessels enter; its neighbours are not modelled. A trial: the case stays as it is. Esc ends it.</source>
        <translation>Einen Punkt der Leber ziehen: Gefäße und Läsionen folgen. Gehalten wird sie an der Vena cava und an den Gefäßeintritten; ihre Nachbarn sind nicht modelliert. Ein Versuch: Der Fall bleibt, wie er ist. Esc beendet ihn.</translation>
    </message>
    <message>
        <source>Edge length</source>
        <translation>Kantenlänge</translation>
    </message>
    <message>
        <source>More vertices, or shorter edges, follow the organ more closely and compute more slowly.</source>
        <translation>Mehr Ecken oder kürzere Kanten folgen dem Organ genauer und rechnen langsamer.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Mesh size</source>
        <translation>Netzgröße</translation>
    </message>
    <message>
        <source>Finer at lesions</source>
        <translation>Feiner an Läsionen</translation>
    </message>
    <message>
        <source>Finer at vessels</source>
        <translation>Feiner an Gefäßen</translation>
    </message>
    <message>
        <source>Edges half as long there; with a number of vertices, longer ones elsewhere.</source>
        <translation>Dort halb so lange Kanten; bei einer Zahl von Ecken anderswo längere.</translation>
    </message>
    <message>
        <source>From surfaces…</source>
        <translation>Aus Oberflächen…</translation>
    </message>
    <message>
        <source>A folder, files named by structure…</source>
        <translation>Ein Ordner, Dateien nach Strukturen benannt…</translation>
    </message>
    <message>
        <source>A list of files (JSON)…</source>
        <translation>Eine Liste von Dateien (JSON)…</translation>
    </message>
    <message>
        <source>List of surfaces</source>
        <translation>Liste von Oberflächen</translation>
    </message>
    <message>
        <source>List of surfaces (*.json)</source>
        <translation>Liste von Oberflächen (*.json)</translation>
    </message>
    <message>
        <source>One surface of the liver…</source>
        <translation>Eine Oberfläche der Leber…</translation>
    </message>
    <message>
        <source>Surface of the liver</source>
        <translation>Oberfläche der Leber</translation>
    </message>
    <message>
        <source>Surfaces (*.stl *.obj *.ply *.vtk *.vtp)</source>
        <translation>Oberflächen (*.stl *.obj *.ply *.vtk *.vtp)</translation>
    </message>
    <message>
        <source>Vessel trees</source>
        <translation>Gefäßbäume</translation>
    </message>
    <message>
        <source>The centrelines that stiffen the model. Each tree is held where it enters.</source>
        <translation>Die Mittellinien, die das Modell versteifen. Jeder Baum ist gehalten, wo er eintritt.</translation>
    </message>
    <message>
        <source>Where the vessels have more, the thinnest and shortest side branches are left out; entrances and vessels of 4 mm across and more stay. More beams compute more slowly.</source>
        <translation>Haben die Gefäße mehr, werden die dünnsten und kürzesten Seitenäste weggelassen; Eintritte und Gefäße ab 4 mm Durchmesser bleiben. Mehr Balken rechnen langsamer.</translation>
    </message>
    <message>
        <source>Beams</source>
        <translation>Balken</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>Young&apos;s modulus. Trial, registration and what is simulated for it go by it; a registration made before is out of date then.</source>
        <translation>Elastizitätsmodul. Versuch, Registrierung und was dafür simuliert wird richten sich danach; eine frühere Registrierung ist dann veraltet.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::NetworkBox</name>
    <message>
        <source>Own network…</source>
        <translation>Eigenes Netz…</translation>
    </message>
    <message>
        <source>Your own segmentation network: an ONNX file with its sheet, MODEL.json, beside it.</source>
        <translation>Ihr eigenes Segmentierungsnetz: eine ONNX-Datei mit ihrem Blatt MODEL.json daneben.</translation>
    </message>
    <message>
        <source>Segment by this network</source>
        <translation>Mit diesem Netz segmentieren</translation>
    </message>
    <message>
        <source>Own network</source>
        <translation>Eigenes Netz</translation>
    </message>
    <message>
        <source>Networks (*.onnx)</source>
        <translation>Netze (*.onnx)</translation>
    </message>
    <message>
        <source>Network: %1</source>
        <translation>Netz: %1</translation>
    </message>
</context>
<context>
    <name>glisson::ui::NotesBox</name>
    <message>
        <source>Show it</source>
        <translation>Zeigen</translation>
    </message>
</context>
<context>
    <name>glisson::ui::OfferBox</name>
    <message>
        <source>+%1 ml  −%2 ml</source>
        <translation>+%1 ml  −%2 ml</translation>
    </message>
    <message>
        <source>A new segmentation waits</source>
        <translation>Eine neue Segmentierung wartet</translation>
    </message>
    <message>
        <source>Go to the largest change</source>
        <translation>Zur größten Änderung</translation>
    </message>
    <message>
        <source>Keep mine where I corrected</source>
        <translation>Meine behalten, wo ich korrigiert habe</translation>
    </message>
    <message>
        <source>The voxels that you corrected by hand stay, all else is taken from the new one.</source>
        <translation>Die Voxel, die Sie von Hand korrigiert haben, bleiben; alles andere kommt von der neuen.</translation>
    </message>
    <message>
        <source>Take the new one</source>
        <translation>Die neue nehmen</translation>
    </message>
    <message>
        <source>Your corrections go; Undo brings them back.</source>
        <translation>Ihre Korrekturen gehen verloren; Rückgängig bringt sie zurück.</translation>
    </message>
    <message>
        <source>Keep all mine</source>
        <translation>Meine ganz behalten</translation>
    </message>
    <message>
        <source>The new segmentation goes, nothing changes.</source>
        <translation>Die neue Segmentierung wird verworfen, nichts ändert sich.</translation>
    </message>
    <message>
        <source>Would be added</source>
        <translation>Käme hinzu</translation>
    </message>
    <message>
        <source>Would be removed</source>
        <translation>Fiele weg</translation>
    </message>
    <message>
        <source>Would be another structure</source>
        <translation>Würde eine andere Struktur</translation>
    </message>
    <message>
        <source>White rim: you corrected it by hand</source>
        <translation>Weißer Rand: von Ihnen von Hand korrigiert</translation>
    </message>
    <message>
        <source>It would change what you corrected by hand: %1. Your labels stay as they are until you decide.</source>
        <translation>Sie würde ändern, was Sie von Hand korrigiert haben: %1. Ihre Labels bleiben, wie sie sind, bis Sie entscheiden.</translation>
    </message>
    <message>
        <source>Of %1 voxels that you corrected, %2 would change (%3 of %4 ml).</source>
        <translation>Von %1 Voxeln, die Sie korrigiert haben, würden sich %2 ändern (%3 von %4 ml).</translation>
    </message>
</context>
<context>
    <name>glisson::ui::OpenIgtLinkBox</name>
    <message>
        <source>Tell them by OpenIGTLink</source>
        <translation>Ihnen über OpenIGTLink mitteilen</translation>
    </message>
    <message>
        <source>Programs that connect are told of each frame: level, pose of the camera, surfaces.</source>
        <translation>Programme, die sich verbinden, erfahren von jedem Bild: Stufe, Lage der Kamera, Oberflächen.</translation>
    </message>
    <message>
        <source>127.0.0.1: only programs of this computer can connect. Another address of this computer lets in whoever reaches it.</source>
        <translation>127.0.0.1: nur Programme dieses Rechners können sich verbinden. Eine andere Adresse dieses Rechners lässt jeden ein, der sie erreicht.</translation>
    </message>
    <message>
        <source>Address and port</source>
        <translation>Adresse und Port</translation>
    </message>
</context>
<context>
    <name>glisson::ui::OpenIgtLinkModel</name>
    <message>
        <source>Listening at %1; no program is connected.</source>
        <translation>Wartet an %1; kein Programm ist verbunden.</translation>
    </message>
    <message>
        <source>Listening at %1; programs connected: %2</source>
        <translation>Wartet an %1; verbundene Programme: %2</translation>
    </message>
    <message>
        <source>Given up, too slow: %1</source>
        <translation>Aufgegeben, zu langsam: %1</translation>
    </message>
    <message>
        <source>Other computers can connect and read where the organ is: nothing is encrypted.</source>
        <translation>Andere Rechner können sich verbinden und lesen, wo das Organ ist: nichts ist verschlüsselt.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::OrganView</name>
    <message>
        <source>Register the model: the organ appears here, as it was found.</source>
        <translation>Registrieren Sie das Modell: Das Organ erscheint hier, wie es gefunden wurde.</translation>
    </message>
    <message>
        <source>%1+ mm</source>
        <translation>%1+ mm</translation>
    </message>
    <message>
        <source>Expected error of each place; or of a lesion, once the surface around a place has been seen as well. The ball marks the best place.</source>
        <translation>Erwarteter Fehler jeder Stelle; oder der einer Läsion, wenn auch die Oberfläche um eine Stelle gesehen wurde. Die Kugel zeigt die beste Stelle.</translation>
    </message>
    <message>
        <source>Error here</source>
        <translation>Fehler hier</translation>
    </message>
    <message>
        <source>%1 after a look here</source>
        <translation>%1 nach einem Blick hierher</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>No overlay: where the organ is in this picture is not known.</source>
        <translation>Keine Einblendung: Wo das Organ in diesem Bild ist, ist nicht bekannt.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::Panel</name>
    <message>
        <source>Running</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Abgelehnt</translation>
    </message>
    <message>
        <source>To be reviewed</source>
        <translation>Zu prüfen</translation>
    </message>
</context>
<context>
    <name>glisson::ui::PatientIdentity</name>
    <message>
        <source>ID %1</source>
        <translation>ID %1</translation>
    </message>
    <message>
        <source>born %1</source>
        <translation>geboren %1</translation>
    </message>
    <message>
        <source>Anonymous</source>
        <translation>Anonym</translation>
    </message>
</context>
<context>
    <name>glisson::ui::PlaybackBox</name>
    <message>
        <source>Start tracking</source>
        <translation>Verfolgung starten</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Repeat the video</source>
        <translation>Video wiederholen</translation>
    </message>
    <message>
        <source>At its end, track again from the registered frame.</source>
        <translation>Am Ende wieder ab dem registrierten Bild verfolgen.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::PlaybackModel</name>
    <message>
        <source>Tracking is running.</source>
        <translation>Die Verfolgung läuft.</translation>
    </message>
    <message>
        <source>The video has ended. Last picture, not live.</source>
        <translation>Das Video ist zu Ende. Letztes Bild, nicht live.</translation>
    </message>
    <message>
        <source>Tracking was stopped. Last picture, not live.</source>
        <translation>Die Verfolgung wurde beendet. Letztes Bild, nicht live.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::ProposalReview</name>
    <message>
        <source>Propose landmarks</source>
        <translation>Landmarken vorschlagen</translation>
    </message>
    <message>
        <source>Proposed landmarks</source>
        <translation>Vorgeschlagene Landmarken</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Annehmen</translation>
    </message>
    <message>
        <source>It lies there</source>
        <translation>Sie liegt dort</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Not visible</source>
        <translation>Nicht sichtbar</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Take the last step of the review back</source>
        <translation>Den letzten Schritt der Durchsicht zurücknehmen</translation>
    </message>
    <message>
        <source>The proposal is not used; what the CT itself shows stays</source>
        <translation>Der Vorschlag wird nicht verwendet; was das CT selbst zeigt, bleibt</translation>
    </message>
    <message>
        <source>Drag it over the liver in 3D, or click where it lies in a slice</source>
        <translation>In 3D über die Leber ziehen oder in einem Schnitt dorthin klicken, wo es liegt</translation>
    </message>
    <message>
        <source>Paint faces</source>
        <translation>Flächen bemalen</translation>
    </message>
    <message>
        <source>Paint where it touches the liver, in 3D</source>
        <translation>In 3D bemalen, wo es die Leber berührt</translation>
    </message>
    <message>
        <source>A smaller brush</source>
        <translation>Ein kleinerer Pinsel</translation>
    </message>
    <message>
        <source>A larger brush</source>
        <translation>Ein größerer Pinsel</translation>
    </message>
    <message>
        <source>Drag it over the liver, or click in a slice. Enter: at the crosshair. Esc: done.</source>
        <translation>Über die Leber ziehen oder in einen Schnitt klicken. Eingabe: ans Fadenkreuz. Esc: fertig.</translation>
    </message>
    <message>
        <source>Drag over the liver to paint, with Ctrl to wipe. Brush %1 mm (+, −). Esc: done.</source>
        <translation>Über die Leber ziehen malt, mit Strg wischt es weg. Pinsel %1 mm (+, −). Esc: fertig.</translation>
    </message>
    <message>
        <source>Choose an atlas first.</source>
        <translation>Wählen Sie zuerst einen Atlas.</translation>
    </message>
    <message>
        <source>Paint where it touches the liver, in 3D or in a slice</source>
        <translation>In 3D oder in einem Schnitt bemalen, wo es die Leber berührt</translation>
    </message>
    <message>
        <source>Drag over the liver, in 3D or in a slice, to paint, with Ctrl to wipe. Brush %1 mm (+, −, Shift + wheel in a slice). Esc: done.</source>
        <translation>In 3D oder in einem Schnitt über die Leber ziehen malt, mit Strg wischt es weg. Pinsel %1 mm (+, −, Umschalt + Rad im Schnitt). Esc: fertig.</translation>
    </message>
    <message>
        <source>Of a former model: propose the landmarks again.</source>
        <translation>Von einem früheren Modell: Landmarken neu vorschlagen lassen.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::QualitySheet</name>
    <message>
        <source>Show the %1 flattest elements in 3D</source>
        <translation>Die %1 flachsten Elemente in 3D</translation>
    </message>
    <message>
        <source>I have checked this model</source>
        <translation>Ich habe dieses Modell geprüft</translation>
    </message>
    <message>
        <source>Kept with the case. Another model, or an edit of its vessels, asks again.</source>
        <translation>Wird mit dem Fall gesichert. Ein anderes Modell oder eine Bearbeitung der Gefäße fragt wieder.</translation>
    </message>
    <message>
        <source>No model yet.</source>
        <translation>Noch kein Modell.</translation>
    </message>
    <message>
        <source>Nothing stands out. Look at the liver, its vessels and lesions in 3D.</source>
        <translation>Nichts fällt auf. Leber, Gefäße und Läsionen in 3D ansehen.</translation>
    </message>
    <message>
        <source>Worth a look:</source>
        <translation>Einen Blick wert:</translation>
    </message>
    <message>
        <source>Flat elements: the smallest angle is %1°. Build anew with another number of vertices.</source>
        <translation>Flache Elemente: der kleinste Winkel ist %1°. Mit einer anderen Zahl von Ecken neu bauen.</translation>
    </message>
    <message>
        <source>How closely the mesh follows the organ is not known: it was imported as it is, and there is no organ to compare it with.</source>
        <translation>Wie genau das Netz dem Organ folgt, ist nicht bekannt: Es wurde so importiert, wie es ist, und es gibt kein Organ zum Vergleich.</translation>
    </message>
    <message>
        <source>The mesh holds %1 % less volume than the organ. More vertices follow it more closely.</source>
        <translation>Das Netz hat %1 % weniger Volumen als das Organ. Mehr Ecken folgen ihm genauer.</translation>
    </message>
    <message>
        <source>The mesh holds %1 % more volume than the organ. More vertices follow it more closely.</source>
        <translation>Das Netz hat %1 % mehr Volumen als das Organ. Mehr Ecken folgen ihm genauer.</translation>
    </message>
    <message>
        <source>The mesh&apos;s vertices lie %1 mm beside the organ&apos;s surface on average.</source>
        <translation>Die Ecken des Netzes liegen im Mittel %1 mm neben der Oberfläche des Organs.</translation>
    </message>
    <message>
        <source>A thin edge of the liver stands out of the mesh by %1 mm.</source>
        <translation>Ein dünner Rand der Leber ragt %1 mm aus dem Netz.</translation>
    </message>
    <message>
        <source>%1: %2 separate trees. Join those that belong together.</source>
        <translation>%1: %2 getrennte Bäume. Verbinden, was zusammengehört.</translation>
    </message>
    <message>
        <source>Lesions without elements of their own: %1. They follow the tissue around them.</source>
        <translation>Läsionen ohne eigene Elemente: %1. Sie folgen dem Gewebe um sie.</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Tetrahedra</source>
        <translation>Tetraeder</translation>
    </message>
    <message>
        <source>Edge length, mean</source>
        <translation>Kantenlänge, Mittel</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>%1 ml</source>
        <translation>%1 ml</translation>
    </message>
    <message>
        <source>Volume error</source>
        <translation>Volumenfehler</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Vertices to fine surface, mean</source>
        <translation>Ecken zur feinen Oberfläche, Mittel</translation>
    </message>
    <message>
        <source>Mesh to fine surface, mean</source>
        <translation>Netz zur feinen Oberfläche, Mittel</translation>
    </message>
    <message>
        <source>Fine surface to mesh, mean</source>
        <translation>Feine Oberfläche zum Netz, Mittel</translation>
    </message>
    <message>
        <source>Fine surface to mesh, largest</source>
        <translation>Feine Oberfläche zum Netz, Maximum</translation>
    </message>
    <message>
        <source>Dihedral angles</source>
        <translation>Flächenwinkel</translation>
    </message>
    <message>
        <source>%1° to %2°</source>
        <translation>%1° bis %2°</translation>
    </message>
    <message>
        <source>%1, mesh %2 %</source>
        <translation>%1, Netz %2 %</translation>
    </message>
    <message>
        <source>%1 mm, tips: %2, beams: %3</source>
        <translation>%1 mm, Spitzen: %2, Balken: %3</translation>
    </message>
</context>
<context>
    <name>glisson::ui::RecentCases</name>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Clear the list</source>
        <translation>Liste &amp;leeren</translation>
    </message>
</context>
<context>
    <name>glisson::ui::RecordingBox</name>
    <message>
        <source>Stop recording</source>
        <translation>Aufnahme beenden</translation>
    </message>
    <message>
        <source>Record…</source>
        <translation>Aufnehmen…</translation>
    </message>
    <message>
        <source>Record the live view</source>
        <translation>Live-Ansicht aufnehmen</translation>
    </message>
    <message>
        <source>Video (*.mkv)</source>
        <translation>Video (*.mkv)</translation>
    </message>
    <message>
        <source>Record the overlay</source>
        <translation>Die Einblendung aufnehmen</translation>
    </message>
    <message>
        <source>Record the raw views</source>
        <translation>Die rohen Ansichten aufnehmen</translation>
    </message>
    <message>
        <source>Record both</source>
        <translation>Beides aufnehmen</translation>
    </message>
    <message>
        <source>Raw views, side by side, can be followed again. What was known of each picture is written beside.</source>
        <translation>Rohe Ansichten, nebeneinander, können noch einmal verfolgt werden. Was von jedem Bild bekannt war, wird daneben geschrieben.</translation>
    </message>
    <message>
        <source>The video has ended meanwhile: nothing is recorded.</source>
        <translation>Das Video ist inzwischen zu Ende: Es wird nichts aufgezeichnet.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::RecordingModel</name>
    <message>
        <source>Frames recorded: %1, in %2</source>
        <translation>Aufgenommene Bilder: %1, in %2</translation>
    </message>
    <message>
        <source>Recording to %1</source>
        <translation>Aufnahme in %1</translation>
    </message>
    <message>
        <source>Corrections and registrations made meanwhile: %1</source>
        <translation>Korrekturen und Registrierungen von unterwegs: %1</translation>
    </message>
    <message>
        <source>Pictures left out because the computer or its disk is too slow: %1</source>
        <translation>Bilder ausgelassen, weil der Rechner oder seine Platte zu langsam ist: %1</translation>
    </message>
    <message>
        <source>%1: lies there already. Choose another name.</source>
        <translation>%1: liegt dort schon. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>The recording is being brought to its end.</source>
        <translation>Die Aufnahme wird abgeschlossen.</translation>
    </message>
    <message>
        <source>Frames in which the picture before stays, as none came in time: %1</source>
        <translation>Bilder, in denen das vorige stehen bleibt, weil keines rechtzeitig kam: %1</translation>
    </message>
</context>
<context>
    <name>glisson::ui::RegionBox</name>
    <message>
        <source>Region</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Draw box</source>
        <translation>Kasten ziehen</translation>
    </message>
    <message>
        <source>Drag a rectangle in a slice, then its edges in the others. Only what lies in the box is looked at and found anew; the labels outside stay.</source>
        <translation>Ziehen Sie ein Rechteck in einer Schicht, dann seine Kanten in den anderen. Nur was im Kasten liegt, wird betrachtet und neu gefunden; die Labels außerhalb bleiben.</translation>
    </message>
    <message>
        <source>Whole CT</source>
        <translation>Ganzes CT</translation>
    </message>
    <message>
        <source>No box: everywhere</source>
        <translation>Kein Kasten: überall</translation>
    </message>
    <message>
        <source>R to L</source>
        <translation>R nach L</translation>
    </message>
    <message>
        <source>A to P</source>
        <translation>A nach P</translation>
    </message>
    <message>
        <source>I to S</source>
        <translation>I nach S</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>LPS: to the patient&apos;s left, to posterior and upwards is positive</source>
        <translation>LPS: nach links vom Patienten, nach hinten und nach oben ist positiv</translation>
    </message>
    <message>
        <source>Resolution at which the liver&apos;s surface evolves. Finer is slower.</source>
        <translation>Auflösung, in der die Leberoberfläche wächst. Feiner ist langsamer.</translation>
    </message>
    <message>
        <source>The CT&apos;s own</source>
        <translation>Wie das CT</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 mm</source>
        <translation>%1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>%1: too fine for so large a box if the liver fills it. At most 50 million voxels.</source>
        <translation>%1: zu fein für einen so großen Kasten, wenn ihn die Leber füllt. Höchstens 50 Millionen Voxel.</translation>
    </message>
    <message>
        <source>%1: up to %2 GB of memory</source>
        <translation>%1: bis zu %2 GB Speicher</translation>
    </message>
</context>
<context>
    <name>glisson::ui::RegistrationBox</name>
    <message>
        <source>Nobody has checked this model (Model, Quality). The picture says so.</source>
        <translation>Niemand hat dieses Modell geprüft (Modell, Qualität). Das Bild sagt es.</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>Registrieren</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Few forces of tools where they are worth it, else springs; both from the most probable shape</source>
        <translation>Wenige Kräfte von Instrumenten, wo sie sich lohnen, sonst Federn; beide von der wahrscheinlichsten Form aus</translation>
    </message>
    <message>
        <source>Contact forces</source>
        <translation>Kontaktkräfte</translation>
    </message>
    <message>
        <source>Few forces on the surface, under the elastic law that is most probable</source>
        <translation>Wenige Kräfte auf der Oberfläche, unter dem wahrscheinlichsten elastischen Gesetz</translation>
    </message>
    <message>
        <source>Springs</source>
        <translation>Federn</translation>
    </message>
    <message>
        <source>Springs from the most probable shape to the points</source>
        <translation>Federn von der wahrscheinlichsten Form zu den Punkten</translation>
    </message>
    <message>
        <source>As published</source>
        <translation>Wie veröffentlicht</translation>
    </message>
    <message>
        <source>Springs alone, without simulated operations: to compare with</source>
        <translation>Nur Federn, ohne simulierte Operationen: zum Vergleich</translation>
    </message>
    <message>
        <source>Shape by</source>
        <translation>Form durch</translation>
    </message>
    <message>
        <source>Former registration</source>
        <translation>Frühere Registrierung</translation>
    </message>
    <message>
        <source>Back to the registration before this one, and forth again (Ctrl+Z before anything is tracked). It is kept with the case.</source>
        <translation>Zurück zur Registrierung vor dieser und wieder vor (Strg+Z, bevor etwas verfolgt wird). Sie bleibt beim Fall.</translation>
    </message>
    <message>
        <source>Use it nevertheless</source>
        <translation>Dennoch verwenden</translation>
    </message>
    <message>
        <source>The registration was refused: what is known contradicts it. Its doubts stay in the picture.</source>
        <translation>Die Registrierung wurde verworfen: Was bekannt ist, widerspricht ihr. Ihre Zweifel bleiben im Bild.</translation>
    </message>
    <message>
        <source>The organ may be elsewhere. Look at the other places over the picture and in 3D before going on.</source>
        <translation>Das Organ kann anderswo liegen. Sehen Sie sich die anderen Orte über dem Bild und in 3D an, bevor Sie weitergehen.</translation>
    </message>
    <message>
        <source>Use this place</source>
        <translation>Diesen Ort verwenden</translation>
    </message>
    <message>
        <source>As registered</source>
        <translation>Wie registriert</translation>
    </message>
    <message>
        <source>Choose another place above to compare.</source>
        <translation>Wählen Sie oben einen anderen Ort zum Vergleich.</translation>
    </message>
    <message>
        <source>Drag the organ over the picture; with Shift it turns, with Ctrl it rolls, the wheel brings it nearer. Refine when its outline lies about right.</source>
        <translation>Ziehen Sie das Organ über das Bild; mit Umschalt dreht es sich, mit Strg rollt es, das Rad holt es näher. Verfeinern, wenn sein Umriss etwa stimmt.</translation>
    </message>
    <message>
        <source>Refine from here</source>
        <translation>Von hier verfeinern</translation>
    </message>
    <message>
        <source>Put it back</source>
        <translation>Zurücklegen</translation>
    </message>
    <message>
        <source>Place by hand</source>
        <translation>Von Hand anlegen</translation>
    </message>
    <message>
        <source>Where the rigid start goes wrong: hold the organ before the picture.</source>
        <translation>Wo der starre Start fehlgeht: Halten Sie das Organ vor das Bild.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::RegistrationModel</name>
    <message>
        <source>A new registration is being computed: look at it first.</source>
        <translation>Eine neue Registrierung wird berechnet: Sehen Sie sie zuerst an.</translation>
    </message>
    <message>
        <source>Residual (not an accuracy)</source>
        <translation>Restabstand (keine Genauigkeit)</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>Expected error, mean</source>
        <translation>Erwarteter Fehler, Mittel</translation>
    </message>
    <message>
        <source>Places where forces act</source>
        <translation>Orte, an denen Kräfte wirken</translation>
    </message>
    <message>
        <source>under 1 %</source>
        <translation>unter 1 %</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Other place %1: %2, %3 mm away</source>
        <translation>Anderer Ort %1: %2, %3 mm entfernt</translation>
    </message>
    <message>
        <source>How far off the organ may be is not known: register again.</source>
        <translation>Wie weit das Organ daneben liegen kann, ist nicht bekannt: erneut registrieren.</translation>
    </message>
    <message>
        <source>Expected error: mean %1 mm, at most %2 mm. Ellipsoids hold a lesion in 95 of 100 cases.</source>
        <translation>Erwarteter Fehler: im Mittel %1 mm, höchstens %2 mm. Die Ellipsoide enthalten eine Läsion in 95 von 100 Fällen.</translation>
    </message>
    <message>
        <source>Arrows: forces, relative to one another.</source>
        <translation>Pfeile: Kräfte, im Verhältnis zueinander.</translation>
    </message>
    <message>
        <source>Out of date: an earlier step has changed since the registration.</source>
        <translation>Veraltet: Ein früherer Schritt hat sich seit der Registrierung geändert.</translation>
    </message>
    <message>
        <source>Refused: what is known contradicts that the organ lies here.</source>
        <translation>Abgelehnt: Was bekannt ist, widerspricht dem, dass das Organ hier liegt.</translation>
    </message>
    <message>
        <source>%1: no single look helps much.</source>
        <translation>%1: Kein einzelner Blick hilft viel.</translation>
    </message>
    <message>
        <source>Computation</source>
        <translation>Rechnung</translation>
    </message>
    <message>
        <source>came to rest</source>
        <translation>kam zur Ruhe</translation>
    </message>
    <message>
        <source>stalled</source>
        <translation>kam nicht weiter</translation>
    </message>
    <message>
        <source>stopped at its limit</source>
        <translation>an der Grenze beendet</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>gescheitert</translation>
    </message>
    <message>
        <source>%1: %2, %3 mm</source>
        <comment>other place</comment>
        <translation>%1: %2, %3 mm</translation>
    </message>
    <message>
        <source>±%1 mm</source>
        <translation>±%1 mm</translation>
    </message>
    <message>
        <source>fork %1</source>
        <translation>Gabel %1</translation>
    </message>
</context>
<context>
    <name>glisson::ui::RenderView</name>
    <message>
        <source>No picture in three dimensions: this computer offers no OpenGL 3.2. glisson doctor tells more.</source>
        <translation>Kein Bild in drei Dimensionen: Dieser Computer bietet kein OpenGL 3.2. Mehr sagt glisson doctor.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::RivalPictures</name>
    <message>
        <source>The organ lies here: take this place</source>
        <translation>Das Organ liegt hier: diesen Ort nehmen</translation>
    </message>
    <message>
        <source>A place is being taken.</source>
        <translation>Ein Ort wird gerade übernommen.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::ClickBox</name>
    <message>
        <source>Clicks correct at once</source>
        <translation>Klicks korrigieren sofort</translation>
    </message>
    <message>
        <source>Where there are labels, a click on the liver that they leave out, on what is not liver, on a vein or on a lesion changes them around it and nowhere else. One step back: Ctrl+Z.</source>
        <translation>Wo es Labels gibt, ändert ein Klick auf Leber, die sie auslassen, auf das, was keine Leber ist, auf eine Vene oder auf eine Läsion sie um ihn herum und sonst nirgends. Ein Schritt zurück: Strg+Z.</translation>
    </message>
    <message>
        <source>With labels there: click what is missing, or too much.</source>
        <translation>Wo es Labels gibt: klicken Sie an, was fehlt oder zu viel ist.</translation>
    </message>
    <message>
        <source>New labels are on their way, or wait for your decision: this click changes none now. It counts when you segment again.</source>
        <translation>Neue Labels sind unterwegs oder warten auf Ihre Entscheidung: dieser Klick ändert jetzt keine. Er zählt, wenn Sie wieder segmentieren.</translation>
    </message>
    <message>
        <source>Correcting around the click…</source>
        <translation>Um den Klick wird korrigiert …</translation>
    </message>
    <message>
        <source>Corrected around the click: %1 ml, up to %2 mm from it.</source>
        <translation>Um den Klick korrigiert: %1 ml, bis %2 mm von ihm.</translation>
    </message>
    <message>
        <source>The labels say already what the click says.</source>
        <translation>Die Labels sagen schon, was der Klick sagt.</translation>
    </message>
    <message>
        <source>Not corrected.</source>
        <translation>Nicht korrigiert.</translation>
    </message>
    <message>
        <source>Locked: this click changes nothing.</source>
        <translation>Gesperrt: Dieser Klick ändert nichts.</translation>
    </message>
    <message>
        <source>This click changes nothing now. It counts when you segment again.</source>
        <translation>Dieser Klick ändert jetzt nichts. Er zählt, wenn erneut segmentiert wird.</translation>
    </message>
    <message>
        <source>This click would replace what you have drawn: it waits for your decision.</source>
        <translation>Dieser Klick würde ersetzen, was Sie gezeichnet haben: Das wartet auf Ihre Entscheidung.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::SeedBox</name>
    <message>
        <source>Not liver</source>
        <translation>Nicht Leber</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Laden…</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Sichern…</translation>
    </message>
    <message>
        <source>Load seeds</source>
        <translation>Saatpunkte laden</translation>
    </message>
    <message>
        <source>Seeds (*.json)</source>
        <translation>Saatpunkte (*.json)</translation>
    </message>
    <message>
        <source>Save seeds</source>
        <translation>Saatpunkte sichern</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Portal and hepatic veins</source>
        <translation>Pfortader und Lebervenen</translation>
    </message>
    <message>
        <source>Lesions</source>
        <translation>Läsionen</translation>
    </message>
    <message>
        <source>All but the liver</source>
        <translation>Alles außer der Leber</translation>
    </message>
    <message>
        <source>What is found anew. All else stays as it is, with everything that you edited.</source>
        <translation>Was neu gesucht wird. Alles andere bleibt, wie es ist, mit allem, was Sie bearbeitet haben.</translation>
    </message>
    <message>
        <source>Find anew</source>
        <translation>Neu suchen</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Segmentieren</translation>
    </message>
    <message>
        <source>Place at least one seed in the liver.</source>
        <translation>Mindestens einen Saatpunkt in die Leber setzen.</translation>
    </message>
    <message>
        <source>There is no liver yet: find everything first.</source>
        <translation>Es gibt noch keine Leber: zuerst alles suchen.</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Leber</translation>
    </message>
    <message>
        <source>Portal vein</source>
        <translation>Pfortader</translation>
    </message>
    <message>
        <source>Hepatic veins</source>
        <translation>Lebervenen</translation>
    </message>
    <message>
        <source>Vena cava</source>
        <translation>Vena cava</translation>
    </message>
    <message>
        <source>Gallbladder</source>
        <translation>Gallenblase</translation>
    </message>
    <message>
        <source>The box is too small.</source>
        <translation>Der Kasten ist zu klein.</translation>
    </message>
    <message>
        <source>Place a seed in the liver inside the box.</source>
        <translation>Setzen Sie einen Saatpunkt in der Leber innerhalb des Kastens.</translation>
    </message>
    <message>
        <source>Choose a structure, then click it in a slice; across a lesion you can also drag, to tell its diameter. Esc ends placing.</source>
        <translation>Wählen Sie eine Struktur und klicken Sie sie in einer Schicht an; quer über eine Läsion können Sie auch ziehen, um ihren Durchmesser anzugeben. Esc beendet das Setzen.</translation>
    </message>
    <message>
        <source>⌀ %1 mm</source>
        <translation>⌀ %1 mm</translation>
    </message>
    <message>
        <source>Propose the liver</source>
        <translation>Leber vorschlagen</translation>
    </message>
    <message>
        <source>Looks for the liver without a click in it: seeds that you can delete or add to.</source>
        <translation>Sucht die Leber ohne einen Klick: Saatpunkte, die Sie löschen oder ergänzen können.</translation>
    </message>
    <message>
        <source>Put back</source>
        <translation>Zurückholen</translation>
    </message>
    <message>
        <source>Your corrections lie on the voxels of another CT: what would change cannot be shown. The new segmentation takes the place of all labels, and they are lost.</source>
        <translation>Ihre Korrekturen liegen auf den Voxeln eines anderen CTs: Was sich ändern würde, lässt sich nicht zeigen. Die neue Segmentierung tritt an die Stelle aller Labels, und sie sind verloren.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::SegmentationPanel</name>
    <message>
        <source>Shows what is told of this segmentation</source>
        <translation>Zeigt, was zu dieser Segmentierung zu sagen ist</translation>
    </message>
    <message>
        <source>Notes to read: %1</source>
        <translation>Hinweise zu lesen: %1</translation>
    </message>
    <message>
        <source>Segmentation</source>
        <translation>Segmentierung</translation>
    </message>
    <message>
        <source>Import labels</source>
        <translation>Labels importieren</translation>
    </message>
    <message>
        <source>%1 ml</source>
        <translation>%1 ml</translation>
    </message>
    <message>
        <source>Grow the structures from a few clicks, then correct them by hand.</source>
        <translation>Strukturen aus wenigen Klicks wachsen lassen, dann von Hand verbessern.</translation>
    </message>
    <message>
        <source>Seeds and growth</source>
        <translation>Saat und Wachstum</translation>
    </message>
    <message>
        <source>Review and edit</source>
        <translation>Prüfen, ändern</translation>
    </message>
    <message>
        <source>Approve</source>
        <translation>Freigeben</translation>
    </message>
    <message>
        <source>You have looked at the chosen label and it is right: the next one comes. An edit takes that back.</source>
        <translation>Sie haben das gewählte Label angesehen, und es stimmt: das nächste kommt. Eine Bearbeitung nimmt das zurück.</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importieren…</translation>
    </message>
    <message>
        <source>Opacity of the labels in the slices</source>
        <translation>Deckkraft der Labels in den Schichten</translation>
    </message>
    <message>
        <source>Approved</source>
        <translation>Freigegeben</translation>
    </message>
    <message>
        <source>%1: nothing yet</source>
        <translation>%1: noch nichts</translation>
    </message>
    <message>
        <source>longest diameter %1 mm</source>
        <translation>längster Durchmesser %1 mm</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>A new segmentation waits: decide about it first, imported labels would take its place.</source>
        <translation>Eine neue Segmentierung wartet: Entscheiden Sie zuerst über sie, importierte Labels träten an ihre Stelle.</translation>
    </message>
    <message>
        <source>Labels that were made elsewhere: DICOM segmentation, .seg.nrrd, NIfTI</source>
        <translation>Anderswo gemachte Labels: DICOM-Segmentierung, .seg.nrrd, NIfTI</translation>
    </message>
    <message>
        <source>Labels (*.nrrd *.dcm *.nii *.nii.gz *.mha *.mhd *.vti)</source>
        <translation>Labels (*.nrrd *.dcm *.nii *.nii.gz *.mha *.mhd *.vti)</translation>
    </message>
</context>
<context>
    <name>glisson::ui::SeriesDialog</name>
    <message>
        <source>Several series</source>
        <translation>Mehrere Serien</translation>
    </message>
    <message numerus="yes">
        <source>This folder holds %n series. Which one shows the liver in the portal venous phase? The likeliest is at the top.</source>
        <translation>
            <numerusform>In diesem Ordner ist %n Serie. Welche zeigt die Leber in der portalvenösen Phase? Die wahrscheinlichste steht oben.</numerusform>
            <numerusform>In diesem Ordner sind %n Serien. Welche zeigt die Leber in der portalvenösen Phase? Die wahrscheinlichste steht oben.</numerusform>
        </translation>
    </message>
    <message>
        <source>Patient: %1</source>
        <translation>Patient: %1</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>Pixels and spacing</source>
        <translation>Pixel und Abstände</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Bemerkungen</translation>
    </message>
    <message>
        <source>series %1</source>
        <translation>Serie %1</translation>
    </message>
    <message>
        <source>%1, series %2</source>
        <translation>%1, Serie %2</translation>
    </message>
    <message>
        <source>contrast agent</source>
        <translation>Kontrastmittel</translation>
    </message>
    <message>
        <source>likeliest</source>
        <translation>am wahrscheinlichsten</translation>
    </message>
</context>
<context>
    <name>glisson::ui::ShapeModes</name>
    <message>
        <source>Show how livers differ</source>
        <translation>Zeigen, wie sich Lebern unterscheiden</translation>
    </message>
    <message>
        <source>The atlas&apos; mean liver over the patient&apos;s, bent by its first modes</source>
        <translation>Die mittlere Leber des Atlas über der des Patienten, verformt durch seine ersten Moden</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Mode</translation>
    </message>
    <message>
        <source>Standard deviations from the mean liver</source>
        <translation>Standardabweichungen von der mittleren Leber</translation>
    </message>
    <message>
        <source>Keys: 1 to 5 choose the mode, the arrows bend, 0 is the mean liver, Esc leaves.</source>
        <translation>Tasten: 1 bis 5 wählen die Mode, die Pfeile verformen, 0 ist die mittlere Leber, Esc beendet.</translation>
    </message>
    <message>
        <source>Mode %1: %2 % of the variance</source>
        <translation>Mode %1: %2 % der Varianz</translation>
    </message>
    <message>
        <source>Mean liver of %1 (%2 livers)
Mode %3 at %4 deviations
%5 % of the variance</source>
        <translation>Mittlere Leber von %1 (%2 Lebern)
Mode %3 bei %4 Abweichungen
%5 % der Varianz</translation>
    </message>
</context>
<context>
    <name>glisson::ui::SliceView</name>
    <message>
        <source>No volume</source>
        <translation>Kein Volumen</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronar</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1  WL %2  WW %3</source>
        <translation>%1  WL %2  WW %3</translation>
    </message>
    <message>
        <source>MIP %1 mm</source>
        <translation>MIP %1 mm</translation>
    </message>
    <message>
        <source>Click: crosshair. Wheel: next slice. Right drag: contrast. Middle drag: move. Ctrl + wheel: zoom. Double click: this view alone. Right click: menu.</source>
        <translation>Klick: Fadenkreuz. Rad: nächste Schicht. Rechts ziehen: Kontrast. Mitte ziehen: verschieben. Strg + Rad: Zoom. Doppelklick: nur diese Ansicht. Rechtsklick: Menü.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::SourceDialog</name>
    <message>
        <source>Arrangement of a stereo source</source>
        <translation>Anordnung einer Stereoquelle</translation>
    </message>
    <message>
        <source>What is said here is written into a small file, by which this source can be opened again.</source>
        <translation>Diese Angaben werden in eine kleine Datei geschrieben, mit der sich die Quelle wieder öffnen lässt.</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Nebeneinander</translation>
    </message>
    <message>
        <source>One above the other</source>
        <translation>Übereinander</translation>
    </message>
    <message>
        <source>Row by row</source>
        <translation>Zeilenweise</translation>
    </message>
    <message>
        <source>Two sources</source>
        <translation>Zwei Quellen</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Ansichten</translation>
    </message>
    <message>
        <source>video, folder of pictures, or device:0</source>
        <translation>Video, Ordner mit Bildern oder device:0</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Auswählen …</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Right source</source>
        <translation>Rechte Quelle</translation>
    </message>
    <message>
        <source>The right view comes first</source>
        <translation>Die rechte Ansicht kommt zuerst</translation>
    </message>
    <message>
        <source>Interlaced: use the first field only</source>
        <translation>Zeilensprung: nur das erste Halbbild verwenden</translation>
    </message>
    <message>
        <source>x </source>
        <translation>x </translation>
    </message>
    <message>
        <source>y </source>
        <translation>y </translation>
    </message>
    <message>
        <source>width </source>
        <translation>Breite </translation>
    </message>
    <message>
        <source>height </source>
        <translation>Höhe </translation>
    </message>
    <message>
        <source>Pixels of each view that are kept; a width or height of 0: all</source>
        <translation>Pixel jeder Ansicht, die behalten werden; Breite oder Höhe 0: alle</translation>
    </message>
    <message>
        <source>Crop</source>
        <translation>Ausschnitt</translation>
    </message>
    <message>
        <source>Save and open…</source>
        <translation>Speichern und öffnen …</translation>
    </message>
    <message>
        <source>Stereo source</source>
        <translation>Stereoquelle</translation>
    </message>
    <message>
        <source>Videos (*.mkv *.mp4 *.avi *.mov);;All files (*)</source>
        <translation>Videos (*.mkv *.mp4 *.avi *.mov);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save the description</source>
        <translation>Beschreibung speichern</translation>
    </message>
    <message>
        <source>Stereo source (*.json)</source>
        <translation>Stereoquelle (*.json)</translation>
    </message>
</context>
<context>
    <name>glisson::ui::StepBar</name>
    <message>
        <source>Research software: not for clinical use</source>
        <translation>Forschungssoftware: nicht für den klinischen Gebrauch</translation>
    </message>
    <message>
        <source>Ctrl+%1</source>
        <translation>Strg+%1</translation>
    </message>
    <message>
        <source>not done</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>? to be reviewed</source>
        <translation>? zu prüfen</translation>
    </message>
    <message>
        <source>✓ up to date</source>
        <translation>✓ aktuell</translation>
    </message>
    <message>
        <source>! out of date</source>
        <translation>! veraltet</translation>
    </message>
    <message>
        <source>running…</source>
        <translation>läuft…</translation>
    </message>
    <message>
        <source>✕ refused</source>
        <translation>✕ abgelehnt</translation>
    </message>
</context>
<context>
    <name>glisson::ui::StereoPanel</name>
    <message>
        <source>Stereo</source>
        <translation>Stereo</translation>
    </message>
    <message>
        <source>What the stereo laparoscope sees of the liver, as points in space.</source>
        <translation>Was das Stereolaparoskop von der Leber sieht, als Punkte im Raum.</translation>
    </message>
    <message>
        <source>Reconstruct</source>
        <translation>Rekonstruieren</translation>
    </message>
    <message>
        <source>Reconstruct surface</source>
        <translation>Oberfläche rekonstruieren</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Frame </source>
        <translation>Bild </translation>
    </message>
    <message>
        <source>Take this frame</source>
        <translation>Bild nehmen</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Bereiche</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>%1 × %2, baseline %3 mm</source>
        <translation>%1 × %2, Basis %3 mm</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Video: %1</source>
        <translation>Video: %1</translation>
    </message>
    <message>
        <source>Stereo pair, %1 × %2</source>
        <translation>Stereobildpaar, %1 × %2</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>%1, line</source>
        <translation>%1, Linie</translation>
    </message>
    <message>
        <source>%1 (%2), corners: %3</source>
        <translation>%1 (%2), Ecken: %3</translation>
    </message>
    <message>
        <source>%1, crosses itself</source>
        <translation>%1, kreuzt sich selbst</translation>
    </message>
    <message>
        <source>Calibration file…</source>
        <translation>Kalibrierungsdatei…</translation>
    </message>
    <message>
        <source>Folder of text files…</source>
        <translation>Ordner mit Textdateien…</translation>
    </message>
    <message>
        <source>Calibrate from boards…</source>
        <translation>Aus Tafeln kalibrieren…</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Sichern als…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Choose a feature and click around it in either picture. Esc ends drawing; then corners can be dragged.</source>
        <translation>Ein Merkmal wählen und in einem der Bilder umklicken. Esc beendet das Zeichnen; dann lassen sich Ecken ziehen.</translation>
    </message>
    <message>
        <source>Margin as a line</source>
        <translation>Rand als Linie</translation>
    </message>
    <message>
        <source>Undo (Ctrl+Z)</source>
        <translation>Rückgängig (Strg+Z)</translation>
    </message>
    <message>
        <source>Redo (Ctrl+Shift+Z)</source>
        <translation>Wiederholen (Strg+Umschalt+Z)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Features are the paper&apos;s way. Dense covers what lies between them. Automatic becomes dense where features leave less than %1 points per cm².</source>
        <translation>Merkmale sind der Weg des Artikels. Dicht deckt ab, was dazwischen liegt. Automatisch wird dicht, wo Merkmale weniger als %1 Punkte je cm² lassen.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Features</source>
        <translation>Merkmale</translation>
    </message>
    <message>
        <source>Dense</source>
        <translation>Dicht</translation>
    </message>
    <message>
        <source>Kind of features that are looked for in both pictures</source>
        <translation>Art der Merkmale, die in beiden Bildern gesucht werden</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.bmp *.tif *.tiff)</source>
        <translation>Bilder (*.png *.jpg *.jpeg *.bmp *.tif *.tiff)</translation>
    </message>
    <message>
        <source>Videos (*.mkv *.mp4 *.avi *.mov)</source>
        <translation>Videos (*.mkv *.mp4 *.avi *.mov)</translation>
    </message>
    <message>
        <source>Stereo pair…</source>
        <translation>Stereopaar …</translation>
    </message>
    <message>
        <source>Video, side by side…</source>
        <translation>Video, nebeneinander …</translation>
    </message>
    <message>
        <source>Two videos…</source>
        <translation>Zwei Videos …</translation>
    </message>
    <message>
        <source>Folder of pairs…</source>
        <translation>Ordner mit Paaren …</translation>
    </message>
    <message>
        <source>Live device…</source>
        <translation>Live-Gerät …</translation>
    </message>
    <message>
        <source>Other arrangement…</source>
        <translation>Andere Anordnung …</translation>
    </message>
    <message>
        <source>OpenCV YAML (*.yml *.yaml)</source>
        <translation>OpenCV YAML (*.yml *.yaml)</translation>
    </message>
    <message>
        <source>Folder of 3 × 3 and 4 × 4 text files, millimetres</source>
        <translation>Ordner mit Textdateien 3 × 3 und 4 × 4, Millimeter</translation>
    </message>
    <message>
        <source>Save the calibration</source>
        <translation>Kalibrierung speichern</translation>
    </message>
    <message>
        <source>Glisson</source>
        <translation>Glisson</translation>
    </message>
    <message>
        <source>Left picture</source>
        <translation>Linkes Bild</translation>
    </message>
    <message>
        <source>Right picture</source>
        <translation>Rechtes Bild</translation>
    </message>
    <message>
        <source>Stereo video, both views side by side</source>
        <translation>Stereovideo, beide Ansichten nebeneinander</translation>
    </message>
    <message>
        <source>Video of the left camera</source>
        <translation>Video der linken Kamera</translation>
    </message>
    <message>
        <source>Video of the right camera</source>
        <translation>Video der rechten Kamera</translation>
    </message>
    <message>
        <source>Folder of left and right pictures</source>
        <translation>Ordner mit linken und rechten Bildern</translation>
    </message>
    <message>
        <source>Live device</source>
        <translation>Live-Gerät</translation>
    </message>
    <message>
        <source>Number of the video device</source>
        <translation>Nummer des Videogeräts</translation>
    </message>
    <message>
        <source>Frame of the video</source>
        <translation>Bild des Videos</translation>
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
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Kind of features</source>
        <translation>Art der Merkmale</translation>
    </message>
    <message>
        <source>The calibration is for pictures of %1 × %2, these are %3 × %4: load the one for them.</source>
        <translation>Die Kalibrierung gilt für Bilder von %1 × %2, diese haben %3 × %4: die passende laden.</translation>
    </message>
    <message>
        <source>OpenIGTLink server…</source>
        <translation>OpenIGTLink-Server …</translation>
    </message>
    <message>
        <source>OpenIGTLink server</source>
        <translation>OpenIGTLink-Server</translation>
    </message>
    <message>
        <source>Address and port of PLUS or another server, and its devices of the left and the right picture</source>
        <translation>Adresse und Port von PLUS oder einem anderen Server und seine Geräte des linken und des rechten Bildes</translation>
    </message>
    <message>
        <source>Still as drawn on another frame: %1. Move or clear them.</source>
        <translation>Noch wie auf einem anderen Bild gezeichnet: %1. Verschieben oder löschen Sie sie.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::StereoView</name>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Anterior margin</source>
        <translation>Vorderrand</translation>
    </message>
    <message>
        <source>Umbilical notch</source>
        <translation>Nabelkerbe</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Load a stereo pair or a video, and the laparoscope&apos;s calibration.</source>
        <translation>Laden Sie ein Stereopaar oder ein Video und die Kalibrierung des Laparoskops.</translation>
    </message>
    <message>
        <source>Reconstructed points</source>
        <translation>Rekonstruierte Punkte</translation>
    </message>
    <message>
        <source>No points yet</source>
        <translation>Noch keine Punkte</translation>
    </message>
    <message>
        <source>Epipolar lines</source>
        <translation>Epipolarlinien</translation>
    </message>
    <message>
        <source>Where the other picture can show what lies under the pointer. A click keeps the line; another click next to it lets it go.</source>
        <translation>Wo das andere Bild zeigen kann, was unter dem Zeiger liegt. Ein Klick hält die Linie fest; ein weiterer daneben lässt sie los.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>The reconstructed points in both pictures</source>
        <translation>Die rekonstruierten Punkte in beiden Bildern</translation>
    </message>
    <message>
        <source>Area used</source>
        <translation>Genutzter Bereich</translation>
    </message>
    <message>
        <source>Darkens what is not reconstructed: outside the mask, or outside the laparoscope&apos;s circle.</source>
        <translation>Verdunkelt, was nicht rekonstruiert wird: außerhalb der Maske oder des Bildkreises des Laparoskops.</translation>
    </message>
    <message>
        <source>Missing points</source>
        <translation>Fehlende Punkte</translation>
    </message>
    <message>
        <source>Orange where the left picture has fewer points per cm² than registration needs, blue where it has enough.</source>
        <translation>Orange, wo das linke Bild weniger Punkte je cm² hat, als die Registrierung braucht, blau, wo es genug sind.</translation>
    </message>
    <message>
        <source>Loupe</source>
        <translation>Lupe</translation>
    </message>
    <message>
        <source>Enlarges what is under the pointer while you draw.</source>
        <translation>Vergrößert beim Zeichnen, was unter dem Zeiger liegt.</translation>
    </message>
    <message>
        <source>Out of date: reconstruct again</source>
        <translation>Veraltet: neu rekonstruieren</translation>
    </message>
    <message>
        <source>Enter or a double click ends the line; Backspace takes a corner back.</source>
        <translation>Eingabe oder Doppelklick beendet die Linie; Rücktaste nimmt eine Ecke zurück.</translation>
    </message>
    <message>
        <source>Click around &quot;%1&quot; in either picture.</source>
        <translation>Klicken Sie in einem der Bilder um „%1“ herum.</translation>
    </message>
    <message>
        <source>Choose a feature on the right to label it.</source>
        <translation>Wählen Sie rechts ein Merkmal, um es zu markieren.</translation>
    </message>
    <message>
        <source>Click: the outline begins here. Esc: stop drawing.</source>
        <translation>Klick: der Umriss beginnt hier. Esc: Zeichnen beenden.</translation>
    </message>
    <message>
        <source>Click: the line begins here. Esc: stop drawing.</source>
        <translation>Klick: die Linie beginnt hier. Esc: Zeichnen beenden.</translation>
    </message>
    <message>
        <source>Click: next corner. Enter, double click: end. Backspace: one back. Esc: drop.</source>
        <translation>Klick: nächste Ecke. Eingabe, Doppelklick: Ende. Rücktaste: eine zurück. Esc: verwerfen.</translation>
    </message>
    <message>
        <source>Click: closes the outline.</source>
        <translation>Klick: schließt den Umriss.</translation>
    </message>
    <message>
        <source>Click: ends the line here.</source>
        <translation>Klick: beendet die Linie hier.</translation>
    </message>
    <message>
        <source>The line was begun in the other picture. Enter ends it, Esc drops it.</source>
        <translation>Die Linie wurde im anderen Bild begonnen. Eingabe beendet, Esc verwirft sie.</translation>
    </message>
    <message>
        <source>Drag: moves this corner.</source>
        <translation>Ziehen: verschiebt diese Ecke.</translation>
    </message>
    <message>
        <source>Click or drag: a new corner here. Delete: removes the region.</source>
        <translation>Klick oder Ziehen: neue Ecke hier. Entf: entfernt den Bereich.</translation>
    </message>
    <message>
        <source>Click: selects this region. Right click: removes it.</source>
        <translation>Klick: wählt diesen Bereich. Rechtsklick: entfernt ihn.</translation>
    </message>
    <message>
        <source>%1 points per cm²</source>
        <translation>%1 Punkte je cm²</translation>
    </message>
    <message>
        <source>Choose a feature on the right to label it. The wheel enlarges a picture, the middle button moves it.</source>
        <translation>Wählen Sie rechts ein Merkmal, um es zu beschriften. Das Rad vergrößert ein Bild, die mittlere Taste verschiebt es.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::TaskButton</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>Wird abgebrochen…</translation>
    </message>
    <message>
        <source>Waiting…</source>
        <translation>Wartet…</translation>
    </message>
    <message>
        <source>Done in %1 s</source>
        <translation>Fertig in %1 s</translation>
    </message>
    <message>
        <source>Cancelled; nothing was changed</source>
        <translation>Abgebrochen; nichts wurde geändert</translation>
    </message>
</context>
<context>
    <name>glisson::ui::TaskStatus</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: done in %2 s</source>
        <translation>%1: fertig in %2 s</translation>
    </message>
    <message>
        <source>%1: done in %2 s – notes to read, on the right: %3</source>
        <translation>%1: fertig in %2 s – rechts zu lesende Hinweise: %3</translation>
    </message>
    <message>
        <source>%1: done in %2 s – notes to read, under Segmentation: %3</source>
        <translation>%1: fertig in %2 s – unter „Segmentierung“ zu lesende Hinweise: %3</translation>
    </message>
    <message>
        <source>%1: cancelled</source>
        <translation>%1: abgebrochen</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
</context>
<context>
    <name>glisson::ui::TimelineBar</name>
    <message>
        <source>One frame back (left arrow)</source>
        <translation>Ein Bild zurück (Pfeil links)</translation>
    </message>
    <message>
        <source>Play or pause (space)</source>
        <translation>Abspielen oder anhalten (Leertaste)</translation>
    </message>
    <message>
        <source>One frame on (right arrow)</source>
        <translation>Ein Bild weiter (Pfeil rechts)</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
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
        <source>Live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>Back to the live video (End)</source>
        <translation>Zurück zum Live-Video (Ende)</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
</context>
<context>
    <name>glisson::ui::TimelineTrack</name>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>Blue: overlay shown. Yellow: outline and regions only. Red: no overlay.</source>
        <translation>Blau: Overlay gezeigt. Gelb: nur Umriss und Bereiche. Rot: kein Overlay.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::TissueBox</name>
    <message>
        <source>Healthy</source>
        <translation>Gesund</translation>
    </message>
    <message>
        <source>Cirrhotic</source>
        <translation>Zirrhotisch</translation>
    </message>
    <message>
        <source>By value</source>
        <translation>Nach Wert</translation>
    </message>
    <message>
        <source> kPa</source>
        <translation> kPa</translation>
    </message>
    <message>
        <source>As liver</source>
        <translation>Wie Leber</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>Weich</translation>
    </message>
    <message>
        <source>Stiff</source>
        <translation>Steif</translation>
    </message>
    <message>
        <source>A third of the liver&apos;s Young&apos;s modulus</source>
        <translation>Ein Drittel des Elastizitätsmoduls der Leber</translation>
    </message>
    <message>
        <source>Five times the liver&apos;s Young&apos;s modulus</source>
        <translation>Das Fünffache des Elastizitätsmoduls der Leber</translation>
    </message>
</context>
<context>
    <name>glisson::ui::ToolBox</name>
    <message>
        <source>Take a tool&apos;s tip from a server</source>
        <translation>Werkzeugspitze von einem Server</translation>
    </message>
    <message>
        <source>While the tip is within 5 mm of the organ&apos;s surface it marks the place there.</source>
        <translation>Solange die Spitze höchstens 5 mm von der Organoberfläche entfernt ist, markiert sie dort die Stelle.</translation>
    </message>
    <message>
        <source>Address and port, and the name of the transform from the tool&apos;s tip to the left camera.</source>
        <translation>Adresse und Port sowie der Name der Transformation von der Werkzeugspitze zur linken Kamera.</translation>
    </message>
    <message>
        <source>Server and tool</source>
        <translation>Server und Werkzeug</translation>
    </message>
</context>
<context>
    <name>glisson::ui::ToolModel</name>
    <message>
        <source>The server has closed the connection.</source>
        <translation>Der Server hat die Verbindung geschlossen.</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>Verbindung wird aufgebaut …</translation>
    </message>
    <message>
        <source>The tool&apos;s pose is %1 s old: it is not used.</source>
        <translation>Die Lage des Werkzeugs ist %1 s alt: sie wird nicht verwendet.</translation>
    </message>
    <message>
        <source>Connected; no pose of this tool has come.</source>
        <translation>Verbunden; es ist keine Lage dieses Werkzeugs gekommen.</translation>
    </message>
    <message>
        <source>The tool&apos;s pose comes in; the organ is not followed just now.</source>
        <translation>Die Lage des Werkzeugs kommt an; das Organ wird gerade nicht verfolgt.</translation>
    </message>
    <message>
        <source>The tool&apos;s pose comes in; a former moment is on the screen, and nothing is told of it.</source>
        <translation>Die Lage des Werkzeugs kommt an; auf dem Bildschirm steht ein früherer Augenblick, zu dem nichts gesagt wird.</translation>
    </message>
    <message>
        <source>The tool&apos;s pose comes in; the video is paused.</source>
        <translation>Die Lage des Werkzeugs kommt an; das Video ist angehalten.</translation>
    </message>
    <message>
        <source>The tool&apos;s pose comes in; the last picture is %1 s old: it is not used.</source>
        <translation>Die Lage des Werkzeugs kommt an; das letzte Bild ist %1 s alt: es wird nicht verwendet.</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Tip to the organ&apos;s surface: %1</source>
        <translation>Spitze zur Organoberfläche: %1</translation>
    </message>
    <message>
        <source>Tip inside the organ, %1 below its surface</source>
        <translation>Spitze im Organ, %1 unter seiner Oberfläche</translation>
    </message>
    <message>
        <source>%1 (±%2)</source>
        <translation>%1 (±%2)</translation>
    </message>
    <message>
        <source>Tip to %1: %2</source>
        <translation>Spitze zu %1: %2</translation>
    </message>
</context>
<context>
    <name>glisson::ui::ToolPages</name>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Size of the brush. In a slice: Shift + wheel.</source>
        <translation>Größe des Pinsels. In einer Schicht: Umschalt + Rad.</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Disc, this slice</source>
        <translation>Scheibe, diese Schicht</translation>
    </message>
    <message>
        <source>Ball, all slices</source>
        <translation>Kugel, alle Schichten</translation>
    </message>
    <message>
        <source>Erase any label</source>
        <translation>Jedes Label radieren</translation>
    </message>
    <message>
        <source>Does</source>
        <translation>Wirkung</translation>
    </message>
    <message>
        <source>Fill inside</source>
        <translation>Innen füllen</translation>
    </message>
    <message>
        <source>Erase inside</source>
        <translation>Innen radieren</translation>
    </message>
    <message>
        <source>Erase outside</source>
        <translation>Außen radieren</translation>
    </message>
    <message>
        <source>In slices</source>
        <translation>In Schichten</translation>
    </message>
    <message>
        <source>This slice only</source>
        <translation>Nur diese Schicht</translation>
    </message>
    <message>
        <source>A slab around it</source>
        <translation>Eine Scheibe darum</translation>
    </message>
    <message>
        <source>Through the whole volume</source>
        <translation>Durch das ganze Volumen</translation>
    </message>
    <message>
        <source>Slab</source>
        <translation>Scheibe</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source> HU</source>
        <translation> HE</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Forget what the label had before</source>
        <translation>Früheres des Labels vergessen</translation>
    </message>
    <message>
        <source>Use the range for painting</source>
        <translation>Bereich zum Malen verwenden</translation>
    </message>
    <message>
        <source>Tools then change only voxels of these intensities; paint comes next.</source>
        <translation>Werkzeuge ändern dann nur Voxel dieser Intensitäten; als Nächstes kommt das Malen.</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>Closing: fills gaps</source>
        <translation>Schließen: füllt Lücken</translation>
    </message>
    <message>
        <source>Opening: takes spikes</source>
        <translation>Öffnen: nimmt Spitzen</translation>
    </message>
    <message>
        <source>Joint: all labels</source>
        <translation>Gemeinsam: alle Labels</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>Wachsen</translation>
    </message>
    <message>
        <source>Shrink</source>
        <translation>Schrumpfen</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Um</translation>
    </message>
    <message>
        <source>Holes of one slice, too</source>
        <translation>Auch Löcher einer Schicht</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronar</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>Keep the largest</source>
        <translation>Die größte behalten</translation>
    </message>
    <message>
        <source>Remove small ones</source>
        <translation>Kleine entfernen</translation>
    </message>
    <message>
        <source>Keep the one that is clicked</source>
        <translation>Die angeklickte behalten</translation>
    </message>
    <message>
        <source>Remove the one that is clicked</source>
        <translation>Die angeklickte entfernen</translation>
    </message>
    <message>
        <source>Split: a label for each</source>
        <translation>Trennen: jeder ein Label</translation>
    </message>
    <message>
        <source>Smaller than</source>
        <translation>Kleiner als</translation>
    </message>
    <message>
        <source> ml</source>
        <translation> ml</translation>
    </message>
    <message>
        <source>Copy from</source>
        <translation>Kopieren aus</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Subtract</source>
        <translation>Abziehen</translation>
    </message>
    <message>
        <source>Keep what is also in</source>
        <translation>Behalten, was auch darin ist</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Fill everything</source>
        <translation>Alles füllen</translation>
    </message>
    <message>
        <source>Other label</source>
        <translation>Anderes Label</translation>
    </message>
    <message>
        <source>No farther than</source>
        <translation>Nicht weiter als</translation>
    </message>
    <message>
        <source>The branch</source>
        <translation>Der Ast</translation>
    </message>
    <message>
        <source>goes to the other tree</source>
        <translation>kommt zum anderen Baum</translation>
    </message>
    <message>
        <source>is cut off</source>
        <translation>wird abgeschnitten</translation>
    </message>
    <message>
        <source>Radius at most</source>
        <translation>Radius höchstens</translation>
    </message>
</context>
<context>
    <name>glisson::ui::TreeEditor</name>
    <message>
        <source>Entrance</source>
        <translation>Eintritt</translation>
    </message>
    <message>
        <source>Where blood enters or leaves the tree; it is held there.</source>
        <translation>Wo Blut in den Baum tritt oder ihn verlässt; dort ist er gehalten.</translation>
    </message>
    <message>
        <source>Prune</source>
        <translation>Kappen</translation>
    </message>
    <message>
        <source>Cuts off a branch with all that hangs on it.</source>
        <translation>Schneidet einen Ast ab mit allem, was daran hängt.</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Hangs one tree on another of its kind.</source>
        <translation>Hängt einen Baum an einen anderen seiner Art.</translation>
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
        <source>Click the place on a centreline where its tree is to enter. White balls are the entrances now. Esc ends.</source>
        <translation>Die Stelle einer Mittellinie anklicken, an der ihr Baum eintreten soll. Weiße Kugeln sind die jetzigen Eintritte. Esc beendet.</translation>
    </message>
    <message>
        <source>Now click the other tree, where it is to hang on.</source>
        <translation>Nun den anderen Baum anklicken, wo er hängen soll.</translation>
    </message>
    <message>
        <source>Click the tree that stays, then the one that is to hang on it. Esc ends.</source>
        <translation>Den Baum anklicken, der bleibt, dann den, der an ihm hängen soll. Esc beendet.</translation>
    </message>
    <message>
        <source>Point at the branch that is to go: what a click cuts off is marked. Esc ends.</source>
        <translation>Zeigen Sie auf den Ast, der weg soll: was ein Klick abschneidet, ist markiert. Esc beendet.</translation>
    </message>
    <message>
        <source>%1, %2 mm, tips: %3.</source>
        <translation>%1, %2 mm, Enden: %3.</translation>
    </message>
    <message>
        <source>A click here takes the whole tree: %1</source>
        <translation>Ein Klick hier nimmt den ganzen Baum: %1</translation>
    </message>
    <message>
        <source>A click here cuts off: %1</source>
        <translation>Ein Klick hier schneidet ab: %1</translation>
    </message>
    <message>
        <source>A click here lets this tree stay: %1</source>
        <translation>Ein Klick hier lässt diesen Baum bestehen: %1</translation>
    </message>
    <message>
        <source>A click here hangs this on the tree that stays, %1 mm away: %2</source>
        <translation>Ein Klick hier hängt dies an den Baum, der bleibt, %1 mm entfernt: %2</translation>
    </message>
    <message>
        <source>This is the tree that stays. Point at another one.</source>
        <translation>Das ist der Baum, der bleibt. Zeigen Sie auf einen anderen.</translation>
    </message>
    <message>
        <source>Trees of one kind are joined: the one that stays is %1, this is %2.</source>
        <translation>Nur Bäume einer Art werden verbunden: Der, der bleibt, ist %1, dies ist %2.</translation>
    </message>
    <message>
        <source>%1 mm from the place that was clicked: too far to join.</source>
        <translation>%1 mm von der angeklickten Stelle: zu weit, um zu verbinden.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::WelcomePage</name>
    <message>
        <source>Glisson</source>
        <translation>Glisson</translation>
    </message>
    <message>
        <source>Open a patient&apos;s CT or a case, or drop it here.</source>
        <translation>Das CT eines Patienten oder einen Fall öffnen oder hierher ziehen.</translation>
    </message>
    <message>
        <source>DICOM folder…</source>
        <translation>DICOM-Ordner…</translation>
    </message>
    <message>
        <source>Volume file…</source>
        <translation>Volumendatei…</translation>
    </message>
    <message>
        <source>Case…</source>
        <translation>Fall…</translation>
    </message>
</context>
<context>
    <name>glisson::ui::AtlasBox</name>
    <message>
        <source>Atlas…</source>
        <translation>Atlas…</translation>
    </message>
    <message>
        <source>The livers that the landmarks are proposed from</source>
        <translation>Die Lebern, aus denen die Landmarken vorgeschlagen werden</translation>
    </message>
    <message>
        <source>Built-in atlas</source>
        <translation>Eingebauter Atlas</translation>
    </message>
    <message>
        <source>Own atlas…</source>
        <translation>Eigener Atlas…</translation>
    </message>
    <message>
        <source>Build from cases…</source>
        <translation>Aus Fällen bauen…</translation>
    </message>
    <message>
        <source>Folder of an atlas</source>
        <translation>Ordner eines Atlas</translation>
    </message>
    <message>
        <source>Atlas in %1</source>
        <translation>Atlas in %1</translation>
    </message>
    <message>
        <source>Built-in atlas &apos;%1&apos;, %2 livers</source>
        <translation>Eingebauter Atlas „%1“, %2 Lebern</translation>
    </message>
    <message>
        <source>Own atlas &apos;%1&apos;, %2 livers</source>
        <translation>Eigener Atlas „%1“, %2 Lebern</translation>
    </message>
    <message>
        <source>The chosen atlas cannot be used: choose it anew, another one, or the built-in atlas.</source>
        <translation>Der gewählte Atlas ist nicht verwendbar: Wählen Sie ihn neu, einen anderen oder den eingebauten.</translation>
    </message>
    <message>
        <source>The proposals below are from the atlas &apos;%1&apos;.</source>
        <translation>Die Vorschläge unten sind vom Atlas „%1“.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::BuildAtlasDialog</name>
    <message>
        <source>%1: off by %2 mm on average where the others foretell it</source>
        <translation>%1: im Mittel %2 mm daneben, wo die anderen es vorhersagen</translation>
    </message>
    <message>
        <source>Build an atlas</source>
        <translation>Einen Atlas bauen</translation>
    </message>
    <message>
        <source>Of your own cases, five at least, with a model and reviewed landmarks. What a case only took over from an atlas is no evidence and stays out. It takes some seconds a liver.</source>
        <translation>Aus eigenen Fällen, mindestens fünf, mit einem Modell und geprüften Landmarken. Was ein Fall nur von einem Atlas übernommen hat, ist kein Beleg und bleibt weg. Es dauert einige Sekunden je Leber.</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>Bauen</translation>
    </message>
    <message>
        <source>Cases</source>
        <translation>Fälle</translation>
    </message>
    <message>
        <source>Add case or folder…</source>
        <translation>Fall oder Ordner hinzufügen…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Cases whose labels nobody has approved, too</source>
        <translation>Auch Fälle, deren Label niemand freigegeben hat</translation>
    </message>
    <message>
        <source>Keep the mean liver, and learn places alone</source>
        <translation>Die mittlere Leber behalten und nur Orte lernen</translation>
    </message>
    <message>
        <source>Where structures lie on the mean liver of the chosen atlas: suits few cases</source>
        <translation>Wo Strukturen auf der mittleren Leber des gewählten Atlas liegen: gut bei wenigen Fällen</translation>
    </message>
    <message>
        <source>Keep nothing of single cases</source>
        <translation>Von einzelnen Fällen nichts behalten</translation>
    </message>
    <message>
        <source>Of structures means and mean squares alone, without the cases&apos; names</source>
        <translation>Von Strukturen nur Mittel und mittlere Quadrate, ohne die Namen der Fälle</translation>
    </message>
    <message>
        <source>A case, or a folder of cases</source>
        <translation>Ein Fall oder ein Ordner mit Fällen</translation>
    </message>
    <message>
        <source>own</source>
        <translation>eigener</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>a new folder</source>
        <translation>ein neuer Ordner</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Kept in</source>
        <translation>Abgelegt in</translation>
    </message>
    <message>
        <source>Folder for the atlas</source>
        <translation>Ordner für den Atlas</translation>
    </message>
    <message>
        <source>Choose an atlas to build on first.</source>
        <translation>Wählen Sie zuerst einen Atlas, auf dem gebaut wird.</translation>
    </message>
    <message>
        <source>Add your cases first.</source>
        <translation>Fügen Sie zuerst Ihre Fälle hinzu.</translation>
    </message>
    <message>
        <source>Give the atlas a name.</source>
        <translation>Geben Sie dem Atlas einen Namen.</translation>
    </message>
    <message>
        <source>Name a folder to keep it in.</source>
        <translation>Nennen Sie einen Ordner, in dem er abgelegt wird.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::RunningWork</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Closing now stops it: what it would have made is lost, and the case stays as it is.</source>
        <translation>Jetzt zu schließen bricht es ab: Was dabei entstünde, geht verloren, und der Fall bleibt, wie er ist.</translation>
    </message>
    <message>
        <source>Wait, then close</source>
        <translation>Warten, dann schließen</translation>
    </message>
    <message>
        <source>Stop it and close</source>
        <translation>Abbrechen und schließen</translation>
    </message>
    <message>
        <source>Do not close</source>
        <translation>Nicht schließen</translation>
    </message>
    <message>
        <source>then the window closes</source>
        <translation>danach schließt das Fenster</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Waiting saves the case with what it makes; a segmentation that would change what you corrected by hand waits for your decision then, and the labels are saved as they are. Stopping it saves the case as it is now.</source>
        <translation>Warten speichert den Fall mit dem, was dabei entsteht; eine Segmentierung, die von Hand Korrigiertes ändern würde, wartet dann auf Ihre Entscheidung, und die Labels werden gespeichert, wie sie sind. Abbrechen speichert den Fall, wie er jetzt ist.</translation>
    </message>
    <message>
        <source>Wait, then save</source>
        <translation>Warten, dann speichern</translation>
    </message>
    <message>
        <source>Stop it and save</source>
        <translation>Abbrechen und speichern</translation>
    </message>
    <message>
        <source>Do not save</source>
        <translation>Nicht speichern</translation>
    </message>
    <message>
        <source>then the case is saved</source>
        <translation>danach wird der Fall gespeichert</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Stopping it loses what it would have made.</source>
        <translation>Beim Abbrechen geht verloren, was dabei entstünde.</translation>
    </message>
    <message>
        <source>Wait, then open</source>
        <translation>Warten, dann öffnen</translation>
    </message>
    <message>
        <source>Stop it and open</source>
        <translation>Abbrechen und öffnen</translation>
    </message>
    <message>
        <source>Do not open</source>
        <translation>Nicht öffnen</translation>
    </message>
    <message>
        <source>then it is opened</source>
        <translation>danach wird geöffnet</translation>
    </message>
    <message>
        <source>Still at work: %1.</source>
        <translation>Noch bei der Arbeit: %1.</translation>
    </message>
    <message>
        <source>The work has ended meanwhile.</source>
        <translation>Die Arbeit ist inzwischen zu Ende.</translation>
    </message>
</context>
<context>
    <name>GreyWindows</name>
    <message>
        <source>Abdomen</source>
        <translation>Abdomen</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Leber</translation>
    </message>
    <message>
        <source>Vessels</source>
        <translation>Gefäße</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Lunge</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Own</source>
        <translation>Eigenes</translation>
    </message>
    <message>
        <source>Whole range</source>
        <translation>Ganzer Bereich</translation>
    </message>
</context>
<context>
    <name>MomentTexts</name>
    <message>
        <source>at an unknown time</source>
        <translation>zu unbekannter Zeit</translation>
    </message>
    <message>
        <source>frame %1, %2 s, kept %3</source>
        <translation>Bild %1, %2 s, aufgehoben %3</translation>
    </message>
    <message>
        <source>valid</source>
        <translation>gültig</translation>
    </message>
    <message>
        <source>outline only: %1</source>
        <translation>nur Umriss: %1</translation>
    </message>
    <message>
        <source>no overlay: %1</source>
        <translation>keine Einblendung: %1</translation>
    </message>
    <message>
        <source>frame %1, %2</source>
        <translation>Bild %1, %2</translation>
    </message>
</context>
<context>
    <name>glisson::ui::MeasureBook</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
</context>
<context>
    <name>glisson::ui::MomentsBox</name>
    <message>
        <source>Keep this moment</source>
        <translation>Diesen Moment aufheben</translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation>Zurück zu live</translation>
    </message>
    <message>
        <source>Back to live (Esc in the picture)</source>
        <translation>Zurück zu live (Esc im Bild)</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete the chosen moment</source>
        <translation>Den gewählten Moment löschen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Take the last deletion or title back</source>
        <translation>Das letzte Löschen oder den letzten Titel zurücknehmen</translation>
    </message>
    <message>
        <source>A click shows the moment as it was. The live video goes on meanwhile.</source>
        <translation>Ein Klick zeigt den Moment, wie er war. Das Live-Video läuft währenddessen weiter.</translation>
    </message>
    <message>
        <source>Title of the chosen moment</source>
        <translation>Titel des gewählten Moments</translation>
    </message>
    <message>
        <source>Keep both pictures, the overlay and its numbers in the case (K in the picture)</source>
        <translation>Beide Bilder, die Einblendung und ihre Zahlen im Fall aufheben (K im Bild)</translation>
    </message>
    <message>
        <source>Moment %1</source>
        <translation>Moment %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>glisson::ui::MomentsModel</name>
    <message>
        <source>A kept moment is on the screen. Go back to live (Esc), then keep another one.</source>
        <translation>Ein aufgehobener Moment ist auf dem Bildschirm. Gehen Sie zurück zu live (Esc), dann heben Sie einen anderen auf.</translation>
    </message>
    <message>
        <source>A former frame is on the screen, of which the raw pictures are not there any more. Go back to live (End).</source>
        <translation>Ein früheres Bild ist auf dem Bildschirm, dessen Rohbilder nicht mehr da sind. Gehen Sie zurück zu live (Ende).</translation>
    </message>
    <message>
        <source>Nothing is followed: start tracking, then keep a moment.</source>
        <translation>Nichts wird verfolgt: Beginnen Sie die Verfolgung, dann heben Sie einen Moment auf.</translation>
    </message>
    <message>
        <source>The overlay is being prepared: there is nothing to keep yet.</source>
        <translation>Die Einblendung wird vorbereitet: Es gibt noch nichts aufzuheben.</translation>
    </message>
    <message>
        <source>Frame %1 is being kept.</source>
        <translation>Bild %1 wird aufgehoben.</translation>
    </message>
    <message>
        <source>Too many moments are being kept at once. Wait, then keep this one again.</source>
        <translation>Zu viele Momente werden zugleich aufgehoben. Warten Sie, dann heben Sie diesen nochmals auf.</translation>
    </message>
    <message>
        <source>Moment %1 is kept.</source>
        <translation>Moment %1 ist aufgehoben.</translation>
    </message>
    <message>
        <source>This case is open for reading: save it under another name, or the moment is lost with the window.</source>
        <translation>Dieser Fall ist nur zum Lesen geöffnet: Speichern Sie ihn unter einem anderen Namen, sonst geht der Moment mit dem Fenster verloren.</translation>
    </message>
    <message>
        <source>Moment %1 is deleted. Undo brings it back.</source>
        <translation>Moment %1 ist gelöscht. Rückgängig holt ihn zurück.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::ViewBar</name>
    <message>
        <source>Which greys the slices show. Right drag in a slice changes them.</source>
        <translation>Welche Grauwerte die Schichten zeigen. Rechts ziehen in einer Schicht ändert sie.</translation>
    </message>
    <message>
        <source>Hounsfield windows need a CT: an MRI&apos;s greys have no unit</source>
        <translation>Hounsfield-Fenster brauchen ein CT: Grauwerte einer MRT haben keine Einheit</translation>
    </message>
    <message>
        <source>Window: %1</source>
        <translation>Fenster: %1</translation>
    </message>
    <message>
        <source>MIP</source>
        <translation>MIP</translation>
    </message>
    <message>
        <source>The brightest of a slab about the slice, for vessels. Labels, values and tools stay those of the slice.</source>
        <translation>Das Hellste einer Scheibe um die Schicht herum, für Gefäße. Labels, Werte und Werkzeuge bleiben die der Schicht.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>How thick the slab is; also Shift + wheel in a slice</source>
        <translation>Dicke der Scheibe; auch Umschalt + Rad in einer Schicht</translation>
    </message>
    <message>
        <source>Measure a distance</source>
        <translation>Abstand messen</translation>
    </message>
    <message>
        <source>Drag from place to place in a slice. Esc ends.</source>
        <translation>In einer Schicht von Stelle zu Stelle ziehen. Esc beendet.</translation>
    </message>
    <message>
        <source>Measure two diameters</source>
        <translation>Zwei Durchmesser messen</translation>
    </message>
    <message>
        <source>Drag along the longest diameter in a slice, then along another one that crosses it. Esc ends.</source>
        <translation>In einer Schicht den längsten Durchmesser entlang ziehen, dann einen, der ihn kreuzt. Esc beendet.</translation>
    </message>
    <message>
        <source>Take the last measure back</source>
        <translation>Letztes Maß zurücknehmen</translation>
    </message>
    <message>
        <source>Wipe all measures</source>
        <translation>Alle Maße löschen</translation>
    </message>
    <message>
        <source>Whole picture</source>
        <translation>Ganzes Bild</translation>
    </message>
    <message>
        <source>Takes zoom and shift of the slices away</source>
        <translation>Nimmt Zoom und Verschiebung der Schichten weg</translation>
    </message>
    <message>
        <source>One view alone</source>
        <translation>Eine Ansicht allein</translation>
    </message>
    <message>
        <source>The view under the pointer fills the place of all, as after a double click; Esc goes back</source>
        <translation>Die Ansicht unter dem Zeiger füllt den Platz aller, wie nach einem Doppelklick; Esc geht zurück</translation>
    </message>
</context>
<context>
    <name>HandWorkQuestion</name>
    <message>
        <source>Labels corrected by hand</source>
        <translation>Von Hand korrigierte Labels</translation>
    </message>
    <message>
        <source>You corrected by hand: %1.</source>
        <translation>Von Hand haben Sie korrigiert: %1.</translation>
    </message>
    <message>
        <source>Replace them</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Keep mine</source>
        <translation>Meine behalten</translation>
    </message>
</context>
<context>
    <name>glisson::ui::LabelImport</name>
    <message>
        <source>What is imported takes the place of all labels, with these corrections.</source>
        <translation>Was importiert wird, tritt an die Stelle aller Labels samt diesen Korrekturen.</translation>
    </message>
</context>
</TS>
