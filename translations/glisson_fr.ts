<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>AtlasTexts</name>
    <message>
        <source>Umbilical notch</source>
        <translation>Échancrure ombilicale</translation>
    </message>
    <message>
        <source>Falciform ligament</source>
        <translation>Ligament falciforme</translation>
    </message>
    <message>
        <source>Anterior margin</source>
        <translation>Bord antérieur</translation>
    </message>
    <message>
        <source>Vena cava</source>
        <translation>Veine cave</translation>
    </message>
    <message>
        <source>Portal vein&apos;s entrance</source>
        <translation>Entrée de la veine porte</translation>
    </message>
    <message>
        <source>Gallbladder&apos;s bed</source>
        <translation>Lit de la vésicule</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>proposé</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>accepté</translation>
    </message>
    <message>
        <source>moved</source>
        <translation>déplacé</translation>
    </message>
    <message>
        <source>not visible</source>
        <translation>non visible</translation>
    </message>
    <message>
        <source>from %1 livers (%2), %3 mm</source>
        <translation>d&apos;après %1 foies (%2), %3 mm</translation>
    </message>
    <message>
        <source>found in the CT</source>
        <translation>trouvé sur le scanner</translation>
    </message>
    <message>
        <source>placed by hand</source>
        <translation>placé à la main</translation>
    </message>
    <message>
        <source>follows the notch as the portal vein shows it</source>
        <translation>suit l&apos;échancrure telle que la veine porte la montre</translation>
    </message>
    <message>
        <source>follows what the CT shows (%1)</source>
        <translation>suit ce que montre le scanner (%1)</translation>
    </message>
    <message>
        <source>follows the notch that you placed</source>
        <translation>suit l&apos;échancrure que vous avez placée</translation>
    </message>
    <message>
        <source>follows what you placed (%1)</source>
        <translation>suit ce que vous avez placé (%1)</translation>
    </message>
    <message>
        <source>%1 on %2 % of its course</source>
        <translation>%1, sur %2 % de son trajet</translation>
    </message>
    <message>
        <source>%1; drawn to where the portal vein&apos;s umbilical part shows it</source>
        <translation>%1 ; ramené là où la partie ombilicale de la veine porte la montre</translation>
    </message>
    <message>
        <source>%1; drawn to the plane of the portal vein&apos;s umbilical part on %2 % of its course</source>
        <translation>%1 ; ramené au plan de la partie ombilicale de la veine porte sur %2 % de son trajet</translation>
    </message>
    <message>
        <source>%1; drawn to the ridge found in the CT on %2 % of its course</source>
        <translation>%1 ; ramené à la crête trouvée sur le scanner sur %2 % de son trajet</translation>
    </message>
    <message>
        <source>%1; placed by hand on %2 % of its course</source>
        <translation>%1 ; placé à la main sur %2 % de son trajet</translation>
    </message>
</context>
<context>
    <name>BeingMade</name>
    <message>
        <source>A new model is being made: look at it first.</source>
        <translation>Un nouveau modèle est en préparation : regardez-le d&apos;abord.</translation>
    </message>
</context>
<context>
    <name>CloudFigures</name>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Distance from the camera</source>
        <translation>Distance à la caméra</translation>
    </message>
    <message>
        <source>%1 to %2 mm</source>
        <translation>%1 à %2 mm</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>dense</source>
        <translation>dense</translation>
    </message>
    <message>
        <source>features</source>
        <translation>points d’intérêt</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>%1 cm²</source>
        <translation>%1 cm²</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Densité</translation>
    </message>
    <message>
        <source>%1 per cm² (needs %2)</source>
        <translation>%1 par cm² (il en faut %2)</translation>
    </message>
    <message>
        <source>Dense enough</source>
        <translation>Assez dense</translation>
    </message>
    <message>
        <source>%1 % of the surface</source>
        <translation>%1 % de la surface</translation>
    </message>
    <message>
        <source>Depth&apos;s deviation</source>
        <translation>Écart-type de la profondeur</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Rows off by</source>
        <translation>Lignes décalées de</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>Epipolar error</source>
        <translation>Erreur épipolaire</translation>
    </message>
    <message>
        <source>Of the organ seen</source>
        <translation>Part de l’organe vue</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>The regions were drawn on another frame: move them to where they belong now, or clear them.</source>
        <translation>Les régions ont été tracées sur une autre image : déplacez-les là où elles sont maintenant, ou effacez-les.</translation>
    </message>
    <message>
        <source>Fewer points per cm² than registration needs: choose another method, or look closer.</source>
        <translation>Moins de points par cm² que le recalage n’en demande : choisissez une autre méthode ou approchez-vous.</translation>
    </message>
    <message>
        <source>The pictures&apos; rows do not agree with the calibration: calibrate the laparoscope again.</source>
        <translation>Les lignes des images ne correspondent pas à l’étalonnage : étalonnez de nouveau le laparoscope.</translation>
    </message>
</context>
<context>
    <name>EditTexts</name>
    <message>
        <source>A click here cuts %1 ml off: %2.</source>
        <translation>Un clic ici retranche %1 ml : %2.</translation>
    </message>
    <message>
        <source>A click here moves %1 ml: %2 → %3.</source>
        <translation>Un clic ici déplace %1 ml : %2 → %3.</translation>
    </message>
    <message>
        <source>A click here makes a vessel of %1 ml.</source>
        <translation>Un clic ici crée un vaisseau de %1 ml.</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Peindre</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Effacer</translation>
    </message>
    <message>
        <source>Scissors</source>
        <translation>Ciseaux</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Seuil</translation>
    </message>
    <message>
        <source>Grow from seeds</source>
        <translation>Croître depuis les graines</translation>
    </message>
    <message>
        <source>Level tracing</source>
        <translation>Isoligne</translation>
    </message>
    <message>
        <source>Islands</source>
        <translation>Îlots</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>Combler les trous</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Lisser</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Marge</translation>
    </message>
    <message>
        <source>Interpolate between slices</source>
        <translation>Interpoler entre les coupes</translation>
    </message>
    <message>
        <source>Logical</source>
        <translation>Logique</translation>
    </message>
    <message>
        <source>Move branch</source>
        <translation>Déplacer une branche</translation>
    </message>
    <message>
        <source>No tool</source>
        <translation>Aucun outil</translation>
    </message>
    <message>
        <source>Choose a label and a tool.</source>
        <translation>Choisissez une étiquette et un outil.</translation>
    </message>
    <message>
        <source>Drag in a slice. Ctrl erases. Shift + wheel: size.</source>
        <translation>Glissez dans une coupe. Ctrl efface. Maj + molette : taille.</translation>
    </message>
    <message>
        <source>Drag in a slice. Ctrl paints. Shift + wheel: size.</source>
        <translation>Glissez dans une coupe. Ctrl peint. Maj + molette : taille.</translation>
    </message>
    <message>
        <source>Draw around it, in a slice or in 3D. Ctrl fills instead of erasing, and the other way.</source>
        <translation>Entourez, dans une coupe ou en 3D. Ctrl remplit au lieu d&apos;effacer, et inversement.</translation>
    </message>
    <message>
        <source>Everything between two intensities becomes the label.</source>
        <translation>Tout ce qui est entre deux intensités reçoit l&apos;étiquette.</translation>
    </message>
    <message>
        <source>What is labelled grows into what is not, along like intensities. Paint a few strokes of each label first.</source>
        <translation>Ce qui est étiqueté croît dans ce qui ne l&apos;est pas, le long d&apos;intensités semblables. Peignez d&apos;abord quelques traits de chaque étiquette.</translation>
    </message>
    <message>
        <source>Click where the region of like intensity ends. Ctrl erases.</source>
        <translation>Cliquez là où la région d&apos;intensité semblable se termine. Ctrl efface.</translation>
    </message>
    <message>
        <source>Click an island of the label. Ctrl does the opposite.</source>
        <translation>Cliquez un îlot de l&apos;étiquette. Ctrl fait le contraire.</translation>
    </message>
    <message>
        <source>Separate pieces of the label.</source>
        <translation>Morceaux séparés de l&apos;étiquette.</translation>
    </message>
    <message>
        <source>Closes what the label encloses.</source>
        <translation>Comble ce que l&apos;étiquette entoure.</translation>
    </message>
    <message>
        <source>All labels at once, without gaps between them.</source>
        <translation>Toutes les étiquettes à la fois, sans vides entre elles.</translation>
    </message>
    <message>
        <source>All labels at once, without gaps between them; each keeps its volume.</source>
        <translation>Toutes les étiquettes à la fois, sans vides entre elles ; chacune garde son volume.</translation>
    </message>
    <message>
        <source>Evens the label&apos;s surface.</source>
        <translation>Aplanit la surface de l&apos;étiquette.</translation>
    </message>
    <message>
        <source>Grows or shrinks the label by a distance.</source>
        <translation>Agrandit ou rétrécit l&apos;étiquette d&apos;une distance.</translation>
    </message>
    <message>
        <source>Paint the label in some slices; those between are filled.</source>
        <translation>Peignez l&apos;étiquette dans quelques coupes ; celles d&apos;entre elles sont remplies.</translation>
    </message>
    <message>
        <source>Combines two labels.</source>
        <translation>Combine deux étiquettes.</translation>
    </message>
    <message>
        <source>Click a vessel: what hangs on it beyond its thinnest place goes to the other tree. Ctrl does the other of the two.</source>
        <translation>Cliquez un vaisseau : ce qui y pend au-delà de son point le plus mince passe à l&apos;autre arbre. Ctrl fait l&apos;autre des deux.</translation>
    </message>
    <message>
        <source>New labels are on their way: wait for them, or cancel that.</source>
        <translation>De nouvelles étiquettes arrivent : attendez-les, ou annulez.</translation>
    </message>
    <message>
        <source>A new segmentation waits for your decision.</source>
        <translation>Une nouvelle segmentation attend votre décision.</translation>
    </message>
    <message>
        <source>The label is locked.</source>
        <translation>L&apos;étiquette est verrouillée.</translation>
    </message>
    <message>
        <source>The label is empty.</source>
        <translation>L&apos;étiquette est vide.</translation>
    </message>
    <message>
        <source>The other label is empty.</source>
        <translation>L&apos;autre étiquette est vide.</translation>
    </message>
    <message>
        <source>Choose another second label.</source>
        <translation>Choisissez une autre seconde étiquette.</translation>
    </message>
    <message>
        <source>Two labels or more must grow.</source>
        <translation>Il faut au moins deux étiquettes qui croissent.</translation>
    </message>
    <message>
        <source>Not started</source>
        <translation>Pas commencé</translation>
    </message>
    <message>
        <source>In progress</source>
        <translation>En cours</translation>
    </message>
    <message>
        <source>To review</source>
        <translation>À vérifier</translation>
    </message>
    <message>
        <source>Approved</source>
        <translation>Approuvé</translation>
    </message>
    <message>
        <source>Scissors: fill inside</source>
        <translation>Ciseaux : remplir l&apos;intérieur</translation>
    </message>
    <message>
        <source>Scissors: erase inside</source>
        <translation>Ciseaux : effacer l&apos;intérieur</translation>
    </message>
    <message>
        <source>Scissors: erase outside</source>
        <translation>Ciseaux : effacer l&apos;extérieur</translation>
    </message>
    <message>
        <source>Level tracing: erase</source>
        <translation>Isoligne : effacer</translation>
    </message>
    <message>
        <source>Islands: keep largest</source>
        <translation>Îlots : garder le plus grand</translation>
    </message>
    <message>
        <source>Islands: remove small</source>
        <translation>Îlots : retirer les petits</translation>
    </message>
    <message>
        <source>Islands: keep clicked</source>
        <translation>Îlots : garder celui cliqué</translation>
    </message>
    <message>
        <source>Islands: remove clicked</source>
        <translation>Îlots : retirer celui cliqué</translation>
    </message>
    <message>
        <source>Islands: split</source>
        <translation>Îlots : séparer</translation>
    </message>
    <message>
        <source>Smooth: median</source>
        <translation>Lisser : médiane</translation>
    </message>
    <message>
        <source>Smooth: closing</source>
        <translation>Lisser : fermeture</translation>
    </message>
    <message>
        <source>Smooth: opening</source>
        <translation>Lisser : ouverture</translation>
    </message>
    <message>
        <source>Smooth: joint</source>
        <translation>Lisser : ensemble</translation>
    </message>
    <message>
        <source>Margin: grow</source>
        <translation>Marge : agrandir</translation>
    </message>
    <message>
        <source>Margin: shrink</source>
        <translation>Marge : rétrécir</translation>
    </message>
    <message>
        <source>Logical: copy</source>
        <translation>Logique : copier</translation>
    </message>
    <message>
        <source>Logical: add</source>
        <translation>Logique : ajouter</translation>
    </message>
    <message>
        <source>Logical: subtract</source>
        <translation>Logique : soustraire</translation>
    </message>
    <message>
        <source>Logical: intersect</source>
        <translation>Logique : intersection</translation>
    </message>
    <message>
        <source>Logical: invert</source>
        <translation>Logique : inverser</translation>
    </message>
    <message>
        <source>Logical: clear</source>
        <translation>Logique : vider</translation>
    </message>
    <message>
        <source>Logical: fill</source>
        <translation>Logique : tout remplir</translation>
    </message>
    <message>
        <source>Cut branch off</source>
        <translation>Couper la branche</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Segmenter</translation>
    </message>
    <message>
        <source>Import labels</source>
        <translation>Importer des étiquettes</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Vessel path</source>
        <translation>Chemin du vaisseau</translation>
    </message>
    <message>
        <source>Click the two ends of a missing piece of vessel. Ctrl adds a point between.</source>
        <translation>Cliquez les deux extrémités du morceau de vaisseau manquant. Ctrl ajoute un point entre elles.</translation>
    </message>
    <message>
        <source>First choose a vessel in the list of labels: portal vein, hepatic veins, vena cava or artery.</source>
        <translation>Choisissez d’abord un vaisseau dans la liste des étiquettes : veine porte, veines hépatiques, veine cave ou artère.</translation>
    </message>
    <message>
        <source>Segment, corrections kept</source>
        <translation>Segmenter, corrections gardées</translation>
    </message>
    <message>
        <source>Correct around a click</source>
        <translation>Corriger autour d’un clic</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>Croissance</translation>
    </message>
    <message>
        <source>Interpolate</source>
        <translation>Interpoler</translation>
    </message>
</context>
<context>
    <name>ErrorPhrases</name>
    <message>
        <source>is not of a recording</source>
        <translation>ne vient pas d’un enregistrement</translation>
    </message>
    <message>
        <source>Give a folder that &apos;glisson track&apos; filled, or what was written beside a recording</source>
        <translation>Donnez un dossier rempli par &apos;glisson track&apos;, ou ce qui a été écrit à côté d’un enregistrement</translation>
    </message>
    <message>
        <source>Give the file NAME.frames.jsonl that was written beside it</source>
        <translation>Donnez le fichier NAME.frames.jsonl écrit à côté</translation>
    </message>
    <message>
        <source>does not exist</source>
        <translation>n’existe pas</translation>
    </message>
    <message>
        <source>is neither a file nor a folder</source>
        <translation>n’est ni un fichier ni un dossier</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>ne peut pas être ouvert</translation>
    </message>
    <message>
        <source>cannot be opened (%1)</source>
        <translation>ne peut pas être ouvert (%1)</translation>
    </message>
    <message>
        <source>cannot be read (%1)</source>
        <translation>ne peut pas être lu (%1)</translation>
    </message>
    <message>
        <source>cannot be started (%1)</source>
        <translation>ne peut pas être démarré (%1)</translation>
    </message>
    <message>
        <source>the program that reads foreign files is missing</source>
        <translation>le programme qui lit les fichiers étrangers manque</translation>
    </message>
    <message>
        <source>a library of Glisson is missing or cannot be loaded</source>
        <translation>une bibliothèque de Glisson manque ou ne peut pas être chargée</translation>
    </message>
    <message>
        <source>cannot run</source>
        <translation>ne peut pas s’exécuter</translation>
    </message>
    <message>
        <source>could not be written</source>
        <translation>n’a pas pu être écrit</translation>
    </message>
    <message>
        <source>is shorter than expected</source>
        <translation>est plus court que prévu</translation>
    </message>
    <message>
        <source>has no room for a volume of %1 MB</source>
        <translation>n’a pas de place pour un volume de %1 Mo</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>manque</translation>
    </message>
    <message>
        <source>are missing</source>
        <translation>manquent</translation>
    </message>
    <message>
        <source>is damaged</source>
        <translation>est endommagé</translation>
    </message>
    <message>
        <source>ends early: the slice was cut</source>
        <translation>se termine trop tôt : la coupe a été tronquée</translation>
    </message>
    <message>
        <source>is followed by no element: bytes were put in among them</source>
        <translation>ne sont suivis d&apos;aucun élément : des octets y ont été insérés</translation>
    </message>
    <message>
        <source>say fewer pixels than the slice holds</source>
        <translation>annoncent moins de pixels que la coupe n&apos;en contient</translation>
    </message>
    <message>
        <source>stands in some slices and is missing in others</source>
        <translation>figure dans certaines coupes et manque dans d&apos;autres</translation>
    </message>
    <message>
        <source>is another than in %1</source>
        <translation>est autre que dans %1</translation>
    </message>
    <message>
        <source>is &quot;%1&quot; where %2 says &quot;%3&quot;</source>
        <translation>est « %1 » alors que %2 dit « %3 »</translation>
    </message>
    <message>
        <source>is %1 where the file holds %2 bytes of voxels</source>
        <translation>est %1 alors que le fichier contient %2 octets de voxels</translation>
    </message>
    <message>
        <source>holds &quot;%1&quot;, which its number type does not hold</source>
        <translation>contient « %1 », que son type de nombre ne peut contenir</translation>
    </message>
    <message>
        <source>holds more than 5000 folders, which no series has</source>
        <translation>contient plus de 5000 dossiers, ce qu&apos;aucune série n&apos;a</translation>
    </message>
    <message>
        <source>holds folders in folders more than 32 deep, which no series has</source>
        <translation>contient des dossiers imbriqués sur plus de 32 niveaux, ce qu&apos;aucune série n&apos;a</translation>
    </message>
    <message>
        <source>holds more than %1 points or cells, more than the mesh of an organ needs</source>
        <translation>contient plus de %1 points ou cellules, plus que n&apos;en demande le maillage d&apos;un organe</translation>
    </message>
    <message>
        <source>Correct the type, or export the volume again</source>
        <translation>Corrigez le type ou exportez à nouveau le volume</translation>
    </message>
    <message>
        <source>Ask where it comes from; unpack it yourself and name the file if it is good</source>
        <translation>Demandez d&apos;où cela vient ; décompressez-le vous-même et indiquez le fichier s&apos;il est bon</translation>
    </message>
    <message>
        <source>Make the mesh coarser</source>
        <translation>Rendez le maillage plus grossier</translation>
    </message>
    <message>
        <source>is damaged or ends early</source>
        <translation>est endommagé ou finit trop tôt</translation>
    </message>
    <message>
        <source>is damaged or not of the format that its name claims</source>
        <translation>est endommagé ou n’a pas le format que son nom annonce</translation>
    </message>
    <message>
        <source>is damaged: the program that reads it broke down</source>
        <translation>est endommagé : le programme qui le lit s’est effondré</translation>
    </message>
    <message>
        <source>is an empty folder</source>
        <translation>est un dossier vide</translation>
    </message>
    <message>
        <source>holds no file: %1 is a pipe, a socket, a device or a link to no file</source>
        <translation>ne contient aucun fichier : %1 est un tube, un socket, un périphérique ou un lien vers aucun fichier</translation>
    </message>
    <message>
        <source>stands twice</source>
        <translation>figure deux fois</translation>
    </message>
    <message>
        <source>ends early</source>
        <translation>finit trop tôt</translation>
    </message>
    <message>
        <source>cannot be unpacked: it is damaged</source>
        <translation>ne peut pas être décompressé : il est endommagé</translation>
    </message>
    <message>
        <source>holds more than 100000 files, which no series has</source>
        <translation>contient plus de 100000 fichiers, ce qu’aucune série n’a</translation>
    </message>
    <message>
        <source>unpacks to more than a hundred times its size, which no images do</source>
        <translation>devient plus de cent fois plus grand, ce que ne fait aucune image</translation>
    </message>
    <message>
        <source>needs more space for temporary files than is free in %1</source>
        <translation>demande plus de place pour les fichiers temporaires qu’il n’en reste dans %1</translation>
    </message>
    <message>
        <source>is a single DICOM slice</source>
        <translation>est une seule coupe DICOM</translation>
    </message>
    <message>
        <source>holds a single slice, not a volume</source>
        <translation>contient une seule coupe, pas un volume</translation>
    </message>
    <message>
        <source>holds no DICOM image</source>
        <translation>ne contient aucune image DICOM</translation>
    </message>
    <message>
        <source>is an archive, not a file of labels</source>
        <translation>est une archive, pas un fichier d’étiquettes</translation>
    </message>
    <message>
        <source>is no folder of DICOM slices</source>
        <translation>n’est pas un dossier de coupes DICOM</translation>
    </message>
    <message>
        <source>holds %1 series: %2</source>
        <translation>contient %1 séries : %2</translation>
    </message>
    <message>
        <source>cannot be chosen in a file that holds one volume</source>
        <translation>ne peut pas être choisi dans un fichier d’un seul volume</translation>
    </message>
    <message>
        <source>is a DICOM file that cannot be read</source>
        <translation>est un fichier DICOM illisible</translation>
    </message>
    <message>
        <source>is a DICOM image that cannot be read</source>
        <translation>est une image DICOM illisible</translation>
    </message>
    <message>
        <source>has no tag (%1), so that its place in the patient is unknown</source>
        <translation>n’a pas l’attribut (%1) : sa place dans le patient est inconnue</translation>
    </message>
    <message>
        <source>holds a direction whose length is not 1</source>
        <translation>contient une direction dont la longueur n’est pas 1</translation>
    </message>
    <message>
        <source>is %1 mm, which is no pixel&apos;s</source>
        <translation>vaut %1 mm, ce qui n’est la taille d’aucun pixel</translation>
    </message>
    <message>
        <source>is %1 mm, which is no voxel&apos;s</source>
        <translation>vaut %1 mm, ce qui n’est la taille d’aucun voxel</translation>
    </message>
    <message>
        <source>is %1, which makes no intensities of the pixels</source>
        <translation>vaut %1, ce qui ne fait pas d’intensités des pixels</translation>
    </message>
    <message>
        <source>is a colour picture, not a slice of a volume</source>
        <translation>est une image en couleurs, pas une coupe d’un volume</translation>
    </message>
    <message>
        <source>holds several frames in one file</source>
        <translation>contient plusieurs images dans un fichier</translation>
    </message>
    <message>
        <source>has another size than the other slices</source>
        <translation>n’a pas la taille des autres coupes</translation>
    </message>
    <message>
        <source>has another orientation or pixel spacing than the other slices</source>
        <translation>n’a pas l’orientation ou la taille de pixel des autres coupes</translation>
    </message>
    <message>
        <source>lie at the same place: %1</source>
        <translation>sont au même endroit : %1</translation>
    </message>
    <message>
        <source>has pixels that cannot be decoded</source>
        <translation>a des pixels indécodables</translation>
    </message>
    <message>
        <source>hold fewer pixels than they claim</source>
        <translation>contiennent moins de pixels qu’annoncé</translation>
    </message>
    <message>
        <source>gives its intensities by a table (Modality LUT), which is not read</source>
        <translation>donne ses intensités par une table (Modality LUT), qui n’est pas lue</translation>
    </message>
    <message>
        <source>has pixels in a number format that is not known</source>
        <translation>a des pixels dans un format de nombres inconnu</translation>
    </message>
    <message>
        <source>is a number format that is not known</source>
        <translation>est un format de nombres inconnu</translation>
    </message>
    <message>
        <source>has an extension that is not known</source>
        <translation>a une extension inconnue</translation>
    </message>
    <message>
        <source>is a flat picture, not a volume</source>
        <translation>est une image plane, pas un volume</translation>
    </message>
    <message>
        <source>is that of a flat picture, not of a volume</source>
        <translation>est celui d’une image plane, pas d’un volume</translation>
    </message>
    <message>
        <source>is that of a colour picture</source>
        <translation>est celui d’une image en couleurs</translation>
    </message>
    <message>
        <source>is a series of %1 volumes, not one volume</source>
        <translation>est une série de %1 volumes, pas un volume</translation>
    </message>
    <message>
        <source>claims %1 voxels of %2 value(s)</source>
        <translation>annonce %1 voxels de %2 valeur(s)</translation>
    </message>
    <message>
        <source>is %1 mm, which is no patient&apos;s</source>
        <translation>vaut %1 mm, ce qui n’est d’aucun patient</translation>
    </message>
    <message>
        <source>is (%1) mm, which is nowhere near a scanner</source>
        <translation>vaut (%1) mm, loin de tout scanner</translation>
    </message>
    <message>
        <source>has axes that are not at right angles (a sheared volume)</source>
        <translation>a des axes qui ne sont pas à angle droit (un volume cisaillé)</translation>
    </message>
    <message>
        <source>has an axis of %1 mm from voxel to voxel, which is no patient&apos;s</source>
        <translation>a un axe de %1 mm d’un voxel à l’autre, ce qui n’est d’aucun patient</translation>
    </message>
    <message>
        <source>is read differently by two readers</source>
        <translation>est lu différemment par deux lecteurs</translation>
    </message>
    <message>
        <source>are read differently by two readers, by up to %1 mm</source>
        <translation>sont lus différemment par deux lecteurs, jusqu’à %1 mm</translation>
    </message>
    <message>
        <source>are counted differently by two readers</source>
        <translation>sont comptés différemment par deux lecteurs</translation>
    </message>
    <message>
        <source>end early: the file is damaged</source>
        <translation>finissent trop tôt : le fichier est endommagé</translation>
    </message>
    <message>
        <source>says that the voxels are compressed, but they are not, or are damaged</source>
        <translation>dit que les voxels sont comprimés, mais ils ne le sont pas ou sont endommagés</translation>
    </message>
    <message>
        <source>says fewer voxels than the file holds (%1 of %2 bytes or more)</source>
        <translation>annonce moins de voxels que le fichier n’en contient (%1 octets sur %2 ou plus)</translation>
    </message>
    <message>
        <source>needs more memory than there is</source>
        <translation>demande plus de mémoire qu’il n’y en a</translation>
    </message>
    <message>
        <source>hold a value that is not a number</source>
        <translation>contiennent une valeur qui n’est pas un nombre</translation>
    </message>
    <message>
        <source>hold %1, which is no %2</source>
        <translation>contiennent %1, qui n’est pas une valeur de ce genre (%2)</translation>
    </message>
    <message>
        <source>run from %1 to %2 only: too few grey levels when rounded</source>
        <translation>ne vont que de %1 à %2 : trop peu de niveaux de gris une fois arrondis</translation>
    </message>
    <message>
        <source>run from %1 to %2, beyond 16-bit integers</source>
        <translation>vont de %1 à %2, au-delà des entiers de 16 bits</translation>
    </message>
    <message>
        <source>hold %1 values each (a colour or vector image)</source>
        <translation>contiennent %1 valeurs chacun (une image de couleurs ou de vecteurs)</translation>
    </message>
    <message>
        <source>are both 0: the file does not say which way the patient lies</source>
        <translation>valent 0 tous deux : le fichier ne dit pas dans quel sens est le patient</translation>
    </message>
    <message>
        <source>place the volume differently, by up to %1 mm</source>
        <translation>placent le volume différemment, jusqu’à %1 mm</translation>
    </message>
    <message>
        <source>is not a NRRD file</source>
        <translation>n’est pas un fichier NRRD</translation>
    </message>
    <message>
        <source>is not that of a NIfTI-1 file</source>
        <translation>n’est pas celui d’un fichier NIfTI-1</translation>
    </message>
    <message>
        <source>is not a VTK image file (.vti)</source>
        <translation>n’est pas un fichier d’image VTK (.vti)</translation>
    </message>
    <message>
        <source>is %1 voxels where %2 are expected</source>
        <translation>fait %1 voxels au lieu de %2</translation>
    </message>
    <message>
        <source>has the right size but lies elsewhere in the patient</source>
        <translation>a la bonne taille mais se trouve ailleurs dans le patient</translation>
    </message>
    <message>
        <source>has an extension that volumes are not written to</source>
        <translation>a une extension sous laquelle aucun volume n’est écrit</translation>
    </message>
    <message>
        <source>stands for %1, which is no structure</source>
        <translation>désigne %1, qui n’est pas une structure</translation>
    </message>
    <message>
        <source>nothing of the liver is left after the codes were applied</source>
        <translation>il ne reste rien du foie après l’application des codes</translation>
    </message>
    <message>
        <source>the liver lies to the left of the vena cava: the volume is mirrored, or the liver&apos;s right part was removed</source>
        <translation>le foie est à gauche de la veine cave : le volume est inversé, ou la partie droite du foie a été retirée</translation>
    </message>
    <message>
        <source>none of them is the liver&apos;s parenchyma</source>
        <translation>aucun d’eux n’est le parenchyme du foie</translation>
    </message>
    <message>
        <source>lies in tissue of %1 HU, which no liver has in the portal venous phase</source>
        <translation>se trouve dans un tissu de %1 UH, ce qu’aucun foie n’a en phase portale</translation>
    </message>
    <message>
        <source>is not there, and was not to be segmented</source>
        <translation>n’est pas là et ne devait pas être segmenté</translation>
    </message>
    <message>
        <source>would need %1 million voxels</source>
        <translation>demanderait %1 millions de voxels</translation>
    </message>
    <message>
        <source>is not a list of points</source>
        <translation>n’est pas une liste de points</translation>
    </message>
    <message>
        <source>is not a point</source>
        <translation>n’est pas un point</translation>
    </message>
    <message>
        <source>is nowhere near a patient</source>
        <translation>est loin de tout patient</translation>
    </message>
    <message>
        <source>is not a JSON object of seeds</source>
        <translation>n’est pas un objet JSON de clics</translation>
    </message>
    <message>
        <source>is not a list of lesions</source>
        <translation>n’est pas une liste de lésions</translation>
    </message>
    <message>
        <source>is no structure that seeds are read for</source>
        <translation>n’est pas une structure pour laquelle on lit des clics</translation>
    </message>
    <message>
        <source>lies outside the image</source>
        <translation>est hors de l’image</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>est vide</translation>
    </message>
    <message>
        <source>are more than there are labels for</source>
        <translation>sont plus nombreux que les étiquettes</translation>
    </message>
    <message>
        <source>holds too little of the image</source>
        <translation>contient trop peu de l’image</translation>
    </message>
    <message>
        <source>has no point in the region</source>
        <translation>n’a pas de point dans la région</translation>
    </message>
    <message>
        <source>is locked</source>
        <translation>est verrouillé</translation>
    </message>
    <message>
        <source>has no click on the liver, beside it, on its veins or on a lesion that the case does not have</source>
        <translation>n’a aucun clic sur le foie, à côté de lui, sur ses veines ou sur une lésion que le cas n’ait déjà</translation>
    </message>
    <message>
        <source>has no point</source>
        <translation>n’a pas de point</translation>
    </message>
    <message>
        <source>grow to nothing: the clicks do not lie in liver tissue</source>
        <translation>ne croissent pas : les clics ne sont pas dans le tissu du foie</translation>
    </message>
    <message>
        <source>exists and is not a case</source>
        <translation>existe et n’est pas un cas</translation>
    </message>
    <message>
        <source>is not a Glisson case</source>
        <translation>n’est pas un cas de Glisson</translation>
    </message>
    <message>
        <source>is malformed (%1)</source>
        <translation>est malformé (%1)</translation>
    </message>
    <message>
        <source>is not valid JSON</source>
        <translation>n’est pas du JSON valide</translation>
    </message>
    <message>
        <source>holds a number that is larger than any</source>
        <translation>contient un nombre plus grand que tout autre</translation>
    </message>
    <message>
        <source>is a link that leads out of the case, or to nothing</source>
        <translation>est un lien qui mène hors du cas, ou à rien</translation>
    </message>
    <message>
        <source>names &quot;%1&quot;, which lies outside the case</source>
        <translation>nomme &quot;%1&quot;, qui est hors du cas</translation>
    </message>
    <message>
        <source>the case has never been saved</source>
        <translation>le cas n’a jamais été enregistré</translation>
    </message>
    <message>
        <source>there is no step to undo</source>
        <translation>il n’y a pas d’étape à annuler</translation>
    </message>
    <message>
        <source>there is no step to redo</source>
        <translation>il n’y a pas d’étape à refaire</translation>
    </message>
    <message>
        <source>the video has only %1 frames</source>
        <translation>la vidéo n’a que %1 images</translation>
    </message>
    <message>
        <source>was refused: what is known contradicts it</source>
        <translation>a été refusé : ce que l’on sait le contredit</translation>
    </message>
    <message>
        <source>has no tetrahedra</source>
        <translation>n’a pas de tétraèdres</translation>
    </message>
    <message>
        <source>is not this model&apos;s (%1 nodes, the model has %2)</source>
        <translation>n’est pas celui de ce modèle (%1 nœuds, le modèle en a %2)</translation>
    </message>
    <message>
        <source>the cloud has no points</source>
        <translation>le nuage n’a pas de points</translation>
    </message>
    <message>
        <source>has a coordinate that is not a number</source>
        <translation>a une coordonnée qui n’est pas un nombre</translation>
    </message>
    <message>
        <source>is of no known mesh format (&quot;%1&quot;)</source>
        <translation>n’a aucun format de maillage connu (&quot;%1&quot;)</translation>
    </message>
    <message>
        <source>is no surface format (&quot;%1&quot;)</source>
        <translation>n’est pas un format de surface (&quot;%1&quot;)</translation>
    </message>
    <message>
        <source>is no tetrahedral mesh format (&quot;%1&quot;)</source>
        <translation>n’est pas un format de maillage tétraédrique (&quot;%1&quot;)</translation>
    </message>
    <message>
        <source>is larger than 300 MB, more than the mesh of an organ needs</source>
        <translation>dépasse 300 Mo, plus que le maillage d’un organe ne demande</translation>
    </message>
    <message>
        <source>names a vertex that is not there</source>
        <translation>nomme un sommet qui n’existe pas</translation>
    </message>
    <message>
        <source>names a point that is not there</source>
        <translation>nomme un point qui n’existe pas</translation>
    </message>
    <message>
        <source>is inverted (volume %1 mm3)</source>
        <translation>est retourné (volume %1 mm3)</translation>
    </message>
    <message>
        <source>is flat</source>
        <translation>est plat</translation>
    </message>
    <message>
        <source>the file ends here</source>
        <translation>le fichier finit ici</translation>
    </message>
    <message>
        <source>is not a PLY file (its first line is not &quot;ply&quot;)</source>
        <translation>n’est pas un fichier PLY (sa première ligne n’est pas &quot;ply&quot;)</translation>
    </message>
    <message>
        <source>claims %1 x %2 pixels, more than any camera has</source>
        <translation>annonce %1 x %2 pixels, plus qu’aucune caméra</translation>
    </message>
    <message>
        <source>is not a whole picture that can be read</source>
        <translation>n’est pas une image entière et lisible</translation>
    </message>
    <message>
        <source>has no extension of a picture</source>
        <translation>n’a pas l’extension d’une image</translation>
    </message>
    <message>
        <source>is not a video that can be read</source>
        <translation>n’est pas une vidéo lisible</translation>
    </message>
    <message>
        <source>does not say its size or frame rate</source>
        <translation>ne dit pas sa taille ou sa cadence</translation>
    </message>
    <message>
        <source>is damaged after %1 frames: the program that reads it broke down</source>
        <translation>est endommagé après %1 images : le programme qui la lit s’est effondré</translation>
    </message>
    <message>
        <source>breaks off after %1 frames of %2</source>
        <translation>s’interrompt après %1 images sur %2</translation>
    </message>
    <message>
        <source>is %1, the left video %2</source>
        <translation>fait %1, la vidéo gauche %2</translation>
    </message>
    <message>
        <source>is %1, the left picture %2</source>
        <translation>fait %1, l’image gauche %2</translation>
    </message>
    <message>
        <source>is %1, the pictures before %2</source>
        <translation>fait %1, les images d’avant %2</translation>
    </message>
    <message>
        <source>is for pictures of %1, the pictures are %2</source>
        <translation>est pour des images de %1, les images font %2</translation>
    </message>
    <message>
        <source>left and right pictures differ in size</source>
        <translation>les images gauche et droite n’ont pas la même taille</translation>
    </message>
    <message>
        <source>has another frame rate than the left video</source>
        <translation>n’a pas la cadence de la vidéo gauche</translation>
    </message>
    <message>
        <source>have no frames within %1 ms of each other (%2 s and %3 s)</source>
        <translation>n’ont pas d’images à moins de %1 ms l’une de l’autre (%2 s et %3 s)</translation>
    </message>
    <message>
        <source>leaves %1 from (%2, %3) of views of %4</source>
        <translation>ne laisse que %1 depuis (%2, %3) de vues de %4</translation>
    </message>
    <message>
        <source>is no device</source>
        <translation>n’est pas un périphérique</translation>
    </message>
    <message>
        <source>is an address of a kind that is not opened</source>
        <translation>est une adresse d’un genre qui n’est pas ouvert</translation>
    </message>
    <message>
        <source>names a source outside this computer (%1)</source>
        <translation>désigne une source hors de cet ordinateur (%1)</translation>
    </message>
    <message>
        <source>names pictures that nobody here has chosen (%1)</source>
        <translation>désigne des images que personne n’a choisies ici (%1)</translation>
    </message>
    <message>
        <source>Choose the source again</source>
        <translation>Choisir de nouveau la source</translation>
    </message>
    <message>
        <source>Open them yourself if you trust the case</source>
        <translation>Les ouvrir soi-même si le cas est de confiance</translation>
    </message>
    <message>
        <source>Give them by --video, if you trust the case</source>
        <translation>Les donner par --video si le cas est de confiance</translation>
    </message>
    <message>
        <source>Enter that source yourself where pictures are opened, if you trust it</source>
        <translation>Saisir soi-même cette source là où l&apos;on ouvre les images, si elle est de confiance</translation>
    </message>
    <message>
        <source>is not a name for a recording</source>
        <translation>n’est pas un nom d’enregistrement</translation>
    </message>
    <message>
        <source>cannot be opened for recording</source>
        <translation>ne peut pas être ouvert pour enregistrer</translation>
    </message>
    <message>
        <source>the disk is full after %1 frames</source>
        <translation>le disque est plein après %1 images</translation>
    </message>
    <message>
        <source>not one frame was recorded</source>
        <translation>aucune image n&apos;a été enregistrée</translation>
    </message>
    <message>
        <source>holds no pictures</source>
        <translation>ne contient pas d’images</translation>
    </message>
    <message>
        <source>holds no pair (%1 left pictures, %2 right ones)</source>
        <translation>ne contient pas de paire (%1 images gauches, %2 droites)</translation>
    </message>
    <message>
        <source>hold %1 and %2 pictures with no name in common</source>
        <translation>contiennent %1 et %2 images sans nom commun</translation>
    </message>
    <message>
        <source>is no folder</source>
        <translation>n’est pas un dossier</translation>
    </message>
    <message>
        <source>is black in both views</source>
        <translation>est noire dans les deux vues</translation>
    </message>
    <message>
        <source>shows nothing in the left view</source>
        <translation>ne montre rien dans la vue gauche</translation>
    </message>
    <message>
        <source>shows nothing in the right view</source>
        <translation>ne montre rien dans la vue droite</translation>
    </message>
    <message>
        <source>is the same picture in both views</source>
        <translation>est la même image dans les deux vues</translation>
    </message>
    <message>
        <source>fits the calibration better when left and right are swapped</source>
        <translation>correspond mieux au calibrage si gauche et droite sont échangées</translation>
    </message>
    <message>
        <source>shows nothing in common in its two views</source>
        <translation>ne montre rien de commun dans ses deux vues</translation>
    </message>
    <message>
        <source>are the same picture</source>
        <translation>sont la même image</translation>
    </message>
    <message>
        <source>gives %1 points (%2 and %3 features, %4 matches), too few for a surface</source>
        <translation>donne %1 points (%2 et %3 repères, %4 paires), trop peu pour une surface</translation>
    </message>
    <message>
        <source>hold none of the pair&apos;s %1 points</source>
        <translation>ne contiennent aucun des %1 points de la paire</translation>
    </message>
    <message>
        <source>belong to frame %1 (%2), not to this pair (%3)</source>
        <translation>appartiennent à l’image %1 (%2), pas à cette paire (%3)</translation>
    </message>
    <message>
        <source>is not a calibration (too large, or not text)</source>
        <translation>n’est pas un calibrage (trop grand, ou pas du texte)</translation>
    </message>
    <message>
        <source>is not an OpenCV YAML file</source>
        <translation>n’est pas un fichier YAML d’OpenCV</translation>
    </message>
    <message>
        <source>is XML, which is not read</source>
        <translation>est du XML, qui n’est pas lu</translation>
    </message>
    <message>
        <source>is not a rotation (determinant %1)</source>
        <translation>n’est pas une rotation (déterminant %1)</translation>
    </message>
    <message>
        <source>is zero: the cameras have no baseline</source>
        <translation>est nul : les caméras n’ont pas d’écart</translation>
    </message>
    <message>
        <source>gives a baseline of %1 mm, where a stereo laparoscope has 1 to 30 mm</source>
        <translation>donne un écart de %1 mm, un laparoscope stéréo a 1 à 30 mm</translation>
    </message>
    <message>
        <source>puts the right camera %1 mm to the left of the left one</source>
        <translation>place la caméra droite %1 mm à gauche de la gauche</translation>
    </message>
    <message>
        <source>are swapped: the right camera would lie %1 mm to the left of the left one</source>
        <translation>sont échangées : la caméra droite serait à %1 mm à gauche de la gauche</translation>
    </message>
    <message>
        <source>is not a matrix</source>
        <translation>n’est pas une matrice</translation>
    </message>
    <message>
        <source>Check the path</source>
        <translation>Vérifiez le chemin</translation>
    </message>
    <message>
        <source>Check its permissions</source>
        <translation>Vérifiez ses droits</translation>
    </message>
    <message>
        <source>Check permissions and space</source>
        <translation>Vérifiez les droits et l’espace libre</translation>
    </message>
    <message>
        <source>Install Glisson again</source>
        <translation>Réinstallez Glisson</translation>
    </message>
    <message>
        <source>Free space for temporary files</source>
        <translation>Libérez de la place pour les fichiers temporaires</translation>
    </message>
    <message>
        <source>Free space for temporary files, or set TMPDIR to a larger disk</source>
        <translation>Libérez de la place pour les fichiers temporaires, ou mettez TMPDIR sur un disque plus grand</translation>
    </message>
    <message>
        <source>Free some space, set TMPDIR to a larger disk, or unpack it yourself and name the folder</source>
        <translation>Libérez de la place, mettez TMPDIR sur un disque plus grand, ou décompressez-le vous-même et nommez le dossier</translation>
    </message>
    <message>
        <source>Choose another name</source>
        <translation>Choisissez un autre nom</translation>
    </message>
    <message>
        <source>Choose another file</source>
        <translation>Choisissez un autre fichier</translation>
    </message>
    <message>
        <source>Choose such a name</source>
        <translation>Choisissez un tel nom</translation>
    </message>
    <message>
        <source>Choose a folder NAME.glisson</source>
        <translation>Choisissez un dossier NOM.glisson</translation>
    </message>
    <message>
        <source>Choose a folder NAME.glisson to save it to</source>
        <translation>Choisissez un dossier NOM.glisson où l’enregistrer</translation>
    </message>
    <message>
        <source>Correct it there or write the file anew</source>
        <translation>Corrigez-le à cet endroit ou réécrivez le fichier</translation>
    </message>
    <message>
        <source>Write the file anew</source>
        <translation>Réécrivez le fichier</translation>
    </message>
    <message>
        <source>Restore the case from a copy</source>
        <translation>Restaurez le cas depuis une copie</translation>
    </message>
    <message>
        <source>Restore the case from a copy; nothing outside its folder is opened</source>
        <translation>Restaurez le cas depuis une copie ; rien n’est ouvert hors de son dossier</translation>
    </message>
    <message>
        <source>Put a copy of what it means in its place, or remove it</source>
        <translation>Mettez à sa place une copie de ce qu’il désigne, ou supprimez-le</translation>
    </message>
    <message>
        <source>Fetch the archive again, or unpack it yourself and name the folder</source>
        <translation>Récupérez l’archive de nouveau, ou décompressez-la vous-même et nommez le dossier</translation>
    </message>
    <message>
        <source>Unpack it yourself and name the folder of the series</source>
        <translation>Décompressez-la vous-même et nommez le dossier de la série</translation>
    </message>
    <message>
        <source>Ask where it comes from; unpack it yourself and name the folder if it is good</source>
        <translation>Demandez d’où elle vient ; si elle est bonne, décompressez-la vous-même et nommez le dossier</translation>
    </message>
    <message>
        <source>The header is damaged, or crop the volume</source>
        <translation>L’en-tête est endommagé, ou recadrez le volume</translation>
    </message>
    <message>
        <source>The header is damaged: export the volume again</source>
        <translation>L’en-tête est endommagé : exportez le volume de nouveau</translation>
    </message>
    <message>
        <source>Correct the header, or export the volume again</source>
        <translation>Corrigez l’en-tête, ou exportez le volume de nouveau</translation>
    </message>
    <message>
        <source>Check that the file&apos;s unit is the millimetre and correct its header</source>
        <translation>Vérifiez que l’unité du fichier est le millimètre et corrigez son en-tête</translation>
    </message>
    <message>
        <source>Correct the file&apos;s header</source>
        <translation>Corrigez l’en-tête du fichier</translation>
    </message>
    <message>
        <source>Correct the header</source>
        <translation>Corrigez l’en-tête</translation>
    </message>
    <message>
        <source>Resample the volume to a rectangular grid</source>
        <translation>Rééchantillonnez le volume sur une grille rectangulaire</translation>
    </message>
    <message>
        <source>Resample the series to a rectangular grid</source>
        <translation>Rééchantillonnez la série sur une grille rectangulaire</translation>
    </message>
    <message>
        <source>Export it again</source>
        <translation>Exportez-le de nouveau</translation>
    </message>
    <message>
        <source>Export the volume again</source>
        <translation>Exportez le volume de nouveau</translation>
    </message>
    <message>
        <source>Export the series again</source>
        <translation>Exportez la série de nouveau</translation>
    </message>
    <message>
        <source>Export the series again, uncompressed</source>
        <translation>Exportez la série de nouveau, non comprimée</translation>
    </message>
    <message>
        <source>Export the series again as 16-bit integers</source>
        <translation>Exportez la série de nouveau en entiers de 16 bits</translation>
    </message>
    <message>
        <source>Export the series with RescaleSlope and RescaleIntercept</source>
        <translation>Exportez la série avec RescaleSlope et RescaleIntercept</translation>
    </message>
    <message>
        <source>Export the series from the scanner again, not from a viewer</source>
        <translation>Exportez la série depuis le scanner, pas depuis une visionneuse</translation>
    </message>
    <message>
        <source>Export the whole series again, or resample it</source>
        <translation>Exportez de nouveau toute la série, ou rééchantillonnez-la</translation>
    </message>
    <message>
        <source>Export it as 16-bit integers</source>
        <translation>Exportez-le en entiers de 16 bits</translation>
    </message>
    <message>
        <source>Export a single time point</source>
        <translation>Exportez un seul instant</translation>
    </message>
    <message>
        <source>Export a single volume</source>
        <translation>Exportez un seul volume</translation>
    </message>
    <message>
        <source>Export a volume with one value a voxel</source>
        <translation>Exportez un volume à une valeur par voxel</translation>
    </message>
    <message>
        <source>Export the file anew</source>
        <translation>Exportez le fichier de nouveau</translation>
    </message>
    <message>
        <source>The file is damaged: export it again</source>
        <translation>Le fichier est endommagé : exportez-le de nouveau</translation>
    </message>
    <message>
        <source>The file is damaged, or its exporter is: export it anew</source>
        <translation>Le fichier ou son exporteur est défectueux : exportez-le de nouveau</translation>
    </message>
    <message>
        <source>Remove it from the folder</source>
        <translation>Retirez-le du dossier</translation>
    </message>
    <message>
        <source>Remove it from the folder (is it a scout view?)</source>
        <translation>Retirez-le du dossier (est-ce une vue de repérage ?)</translation>
    </message>
    <message>
        <source>Keep one phase or one copy only</source>
        <translation>Ne gardez qu’une phase ou une copie</translation>
    </message>
    <message>
        <source>Convert it to NIfTI or to single slices</source>
        <translation>Convertissez-le en NIfTI ou en coupes séparées</translation>
    </message>
    <message>
        <source>Convert the volume to millimetres</source>
        <translation>Convertissez le volume en millimètres</translation>
    </message>
    <message>
        <source>Name a volume</source>
        <translation>Nommez un volume</translation>
    </message>
    <message>
        <source>Name the folder that holds the DICOM slices</source>
        <translation>Nommez le dossier qui contient les coupes DICOM</translation>
    </message>
    <message>
        <source>Name the folder that holds the series</source>
        <translation>Nommez le dossier qui contient la série</translation>
    </message>
    <message>
        <source>Name a folder with the whole series</source>
        <translation>Nommez un dossier avec toute la série</translation>
    </message>
    <message>
        <source>Choose one by its number or UID, or put each into a folder of its own</source>
        <translation>Choisissez-en une par son numéro ou son UID, ou mettez chacune dans son dossier</translation>
    </message>
    <message>
        <source>Choose one of these by its UID</source>
        <translation>Choisissez l’une d’elles par son UID</translation>
    </message>
    <message>
        <source>Leave the series out, or name the folder that holds the DICOM slices</source>
        <translation>Omettez la série, ou nommez le dossier des coupes DICOM</translation>
    </message>
    <message>
        <source>Check that this is the right file</source>
        <translation>Vérifiez que c’est le bon fichier</translation>
    </message>
    <message>
        <source>Scale the intensities so that they span several hundred (a CT&apos;s unit is HU)</source>
        <translation>Mettez les intensités à l’échelle de plusieurs centaines (l’unité d’un scanner est UH)</translation>
    </message>
    <message>
        <source>Scale the intensities to -32768 ... 32767</source>
        <translation>Mettez les intensités entre -32768 et 32767</translation>
    </message>
    <message>
        <source>Set one of them, or convert the original DICOM series</source>
        <translation>Fixez l’un d’eux, ou convertissez la série DICOM d’origine</translation>
    </message>
    <message>
        <source>Find out which is right and write the file anew with that one</source>
        <translation>Trouvez lequel est juste et réécrivez le fichier avec lui</translation>
    </message>
    <message>
        <source>Resample one of the two volumes to the other&apos;s grid</source>
        <translation>Rééchantillonnez l’un des deux volumes sur la grille de l’autre</translation>
    </message>
    <message>
        <source>Check origin, spacing and direction of the two volumes</source>
        <translation>Vérifiez origine, espacement et direction des deux volumes</translation>
    </message>
    <message>
        <source>Use .nrrd, .nii.gz, .nii or .mha</source>
        <translation>Utilisez .nrrd, .nii.gz, .nii ou .mha</translation>
    </message>
    <message>
        <source>Put it beside the header</source>
        <translation>Mettez-le à côté de l’en-tête</translation>
    </message>
    <message>
        <source>Save the segmentation from Slicer again</source>
        <translation>Enregistrez de nouveau la segmentation depuis Slicer</translation>
    </message>
    <message>
        <source>Give the codes of this file: which number is parenchyma, portal_vein and so on</source>
        <translation>Donnez les codes de ce fichier : quel nombre est parenchyma, portal_vein, etc.</translation>
    </message>
    <message>
        <source>Correct the direction in the file&apos;s header if left and right are swapped; after a right hepatectomy import it with &apos;glisson model --left-liver&apos;</source>
        <translation>Corrigez la direction dans l’en-tête si gauche et droite sont échangées ; après une hépatectomie droite, importez avec &apos;glisson model --left-liver&apos;</translation>
    </message>
    <message>
        <source>Say which code means what with --codes FILE (see &apos;glisson model --help&apos;)</source>
        <translation>Dites quel code signifie quoi avec --codes FICHIER (voir &apos;glisson model --help&apos;)</translation>
    </message>
    <message>
        <source>Click inside the parenchyma of a CT in Hounsfield units</source>
        <translation>Cliquez dans le parenchyme d’un scanner en unités Hounsfield</translation>
    </message>
    <message>
        <source>Click inside the parenchyma, away from vessels and lesions</source>
        <translation>Cliquez dans le parenchyme, loin des vaisseaux et des lésions</translation>
    </message>
    <message>
        <source>Unlock it, or click another structure</source>
        <translation>Déverrouillez-le, ou cliquez sur une autre structure</translation>
    </message>
    <message>
        <source>Add one, or leave --correct out</source>
        <translation>Ajoutez-en un, ou omettez --correct</translation>
    </message>
    <message>
        <source>Click at least one point inside the liver</source>
        <translation>Cliquez au moins un point dans le foie</translation>
    </message>
    <message>
        <source>Click the largest ones</source>
        <translation>Cliquez les plus grandes</translation>
    </message>
    <message>
        <source>Segment the liver too, or paint it first</source>
        <translation>Segmentez aussi le foie, ou peignez-le d’abord</translation>
    </message>
    <message>
        <source>Choose a smaller region or a coarser spacing</source>
        <translation>Choisissez une région plus petite ou un pas plus grossier</translation>
    </message>
    <message>
        <source>Draw the region around the liver</source>
        <translation>Tracez la région autour du foie</translation>
    </message>
    <message>
        <source>Import a CT first</source>
        <translation>Importez d’abord un scanner</translation>
    </message>
    <message>
        <source>Check that the seeds belong to this image and are in mm (LPS)</source>
        <translation>Vérifiez que les clics sont de cette image et en mm (LPS)</translation>
    </message>
    <message>
        <source>Write lists of [x, y, z] in mm, patient coordinates (LPS)</source>
        <translation>Écrivez des listes de [x, y, z] en mm, coordonnées du patient (LPS)</translation>
    </message>
    <message>
        <source>Use liver, portal_vein, hepatic_veins, vena_cava, gallbladder, lesions, lesion_diameters_mm or background</source>
        <translation>Utilisez liver, portal_vein, hepatic_veins, vena_cava, gallbladder, lesions, lesion_diameters_mm ou background</translation>
    </message>
    <message>
        <source>Edit the labels first</source>
        <translation>Modifiez d’abord les étiquettes</translation>
    </message>
    <message>
        <source>Only what was undone last can be redone</source>
        <translation>Seul ce qui vient d’être annulé peut être refait</translation>
    </message>
    <message>
        <source>Choose an earlier frame</source>
        <translation>Choisissez une image antérieure</translation>
    </message>
    <message>
        <source>Build the model again</source>
        <translation>Construisez le modèle de nouveau</translation>
    </message>
    <message>
        <source>Build the model anew</source>
        <translation>Construisez le modèle de nouveau</translation>
    </message>
    <message>
        <source>Reconstruct the surface again</source>
        <translation>Reconstruisez la surface de nouveau</translation>
    </message>
    <message>
        <source>Reconstruct or export it again</source>
        <translation>Reconstruisez-le ou exportez-le de nouveau</translation>
    </message>
    <message>
        <source>Register again with a better cloud, or accept it knowing its doubts</source>
        <translation>Recalez de nouveau avec un meilleur nuage, ou acceptez-le en connaissant ses doutes</translation>
    </message>
    <message>
        <source>Remove the point or export the cloud again</source>
        <translation>Retirez le point ou exportez le nuage de nouveau</translation>
    </message>
    <message>
        <source>The file is damaged: copy it again</source>
        <translation>Le fichier est endommagé : copiez-le de nouveau</translation>
    </message>
    <message>
        <source>Use PNG, JPEG, BMP or TIFF, and copy it again if it was cut off</source>
        <translation>Utilisez PNG, JPEG, BMP ou TIFF, et recopiez-le s’il a été tronqué</translation>
    </message>
    <message>
        <source>Use .png, .jpg or .bmp</source>
        <translation>Utilisez .png, .jpg ou .bmp</translation>
    </message>
    <message>
        <source>Use a video in .mkv, .mp4 or .avi, and copy it again if it was cut off</source>
        <translation>Utilisez une vidéo .mkv, .mp4 ou .avi, et recopiez-la si elle a été tronquée</translation>
    </message>
    <message>
        <source>Convert it to .mkv</source>
        <translation>Convertissez-la en .mkv</translation>
    </message>
    <message>
        <source>Copy the video again, or record it anew</source>
        <translation>Copiez la vidéo de nouveau, ou réenregistrez-la</translation>
    </message>
    <message>
        <source>Check that the camera is connected, that no other program uses it, and its number</source>
        <translation>Vérifiez que la caméra est branchée, qu’aucun autre programme ne l’utilise, et son numéro</translation>
    </message>
    <message>
        <source>Write device: and its number, as device:0</source>
        <translation>Écrivez device: et son numéro, comme device:0</translation>
    </message>
    <message>
        <source>Both views are of one size; give two files otherwise</source>
        <translation>Les deux vues ont la même taille ; sinon donnez deux fichiers</translation>
    </message>
    <message>
        <source>Both views of a stereo video have one size</source>
        <translation>Les deux vues d’une vidéo stéréo ont la même taille</translation>
    </message>
    <message>
        <source>Record both views at one rate</source>
        <translation>Enregistrez les deux vues à la même cadence</translation>
    </message>
    <message>
        <source>Record both views at once, from one trigger</source>
        <translation>Enregistrez les deux vues ensemble, d’un même déclencheur</translation>
    </message>
    <message>
        <source>Give pictures of one size</source>
        <translation>Donnez des images d’une même taille</translation>
    </message>
    <message>
        <source>Crop within the picture</source>
        <translation>Recadrez à l’intérieur de l’image</translation>
    </message>
    <message>
        <source>Use rtsp, rtsps, rtp, srt, udp, http or https</source>
        <translation>Utilisez rtsp, rtsps, rtp, srt, udp, http ou https</translation>
    </message>
    <message>
        <source>Use .mkv: a recording that is cut off can still be read there</source>
        <translation>Utilisez .mkv : un enregistrement interrompu y reste lisible</translation>
    </message>
    <message>
        <source>Name them so that only the side differs, as left-001.png and right-001.png, or put them into folders left and right</source>
        <translation>Nommez-les pour que seul le côté diffère, comme left-001.png et right-001.png, ou mettez-les dans des dossiers left et right</translation>
    </message>
    <message>
        <source>Give the picture of each camera</source>
        <translation>Donnez l’image de chaque caméra</translation>
    </message>
    <message>
        <source>Give the picture of each camera; one of them may be lost</source>
        <translation>Donnez l’image de chaque caméra ; l’une est peut-être perdue</translation>
    </message>
    <message>
        <source>Give two pictures of one moment of one scope</source>
        <translation>Donnez deux images d’un même instant d’un même laparoscope</translation>
    </message>
    <message>
        <source>Give both views of one moment</source>
        <translation>Donnez les deux vues d’un même instant</translation>
    </message>
    <message>
        <source>Give the mask of this left picture</source>
        <translation>Donnez le masque de cette image gauche</translation>
    </message>
    <message>
        <source>Draw the mask on the left image</source>
        <translation>Dessinez le masque sur l’image gauche</translation>
    </message>
    <message>
        <source>Swap the two images, or the calibration&apos;s cameras</source>
        <translation>Échangez les deux images, ou les caméras du calibrage</translation>
    </message>
    <message>
        <source>Check the light and the connection, or take another frame</source>
        <translation>Vérifiez la lumière et la liaison, ou prenez une autre image</translation>
    </message>
    <message>
        <source>Check the left camera&apos;s connection, or take another frame</source>
        <translation>Vérifiez la liaison de la caméra gauche, ou prenez une autre image</translation>
    </message>
    <message>
        <source>Check the right camera&apos;s connection, or take another frame</source>
        <translation>Vérifiez la liaison de la caméra droite, ou prenez une autre image</translation>
    </message>
    <message>
        <source>Check that both images show the same tissue sharply and lit, that a mask lies on it, and that the calibration is of this laparoscope</source>
        <translation>Vérifiez que les deux images montrent le même tissu net et éclairé, que le masque est dessus, et que le calibrage est de ce laparoscope</translation>
    </message>
    <message>
        <source>Draw them where the liver is reconstructed, or reconstruct densely</source>
        <translation>Tracez-les là où le foie est reconstruit, ou reconstruisez densément</translation>
    </message>
    <message>
        <source>Load the pair that they were clicked on, or click them again on this one</source>
        <translation>Chargez la paire où elles ont été cliquées, ou cliquez-les sur celle-ci</translation>
    </message>
    <message>
        <source>Use the calibration of this laparoscope at this image size</source>
        <translation>Utilisez le calibrage de ce laparoscope à cette taille d’image</translation>
    </message>
    <message>
        <source>Use the calibration of this scope at this resolution</source>
        <translation>Utilisez le calibrage de ce laparoscope à cette résolution</translation>
    </message>
    <message>
        <source>Load this laparoscope&apos;s calibration, or calibrate it again</source>
        <translation>Chargez le calibrage de ce laparoscope, ou calibrez-le de nouveau</translation>
    </message>
    <message>
        <source>Write the calibration anew or calibrate again</source>
        <translation>Réécrivez le calibrage ou calibrez de nouveau</translation>
    </message>
    <message>
        <source>Save the calibration as YAML (.yml)</source>
        <translation>Enregistrez le calibrage en YAML (.yml)</translation>
    </message>
    <message>
        <source>Left and right are swapped, or R and T map right to left: x_right = R x_left + T</source>
        <translation>Gauche et droite sont échangées, ou R et T vont de droite à gauche : x_right = R x_left + T</translation>
    </message>
    <message>
        <source>Check the unit</source>
        <translation>Vérifiez l’unité</translation>
    </message>
    <message>
        <source>Give .vtp, legacy .vtk, .stl, .obj or .ply</source>
        <translation>Donnez .vtp, .vtk ancien, .stl, .obj ou .ply</translation>
    </message>
    <message>
        <source>was corrected by hand and would be replaced</source>
        <translation>a été corrigé à la main et serait remplacé</translation>
    </message>
    <message>
        <source>is no lesion&apos;s</source>
        <translation>n’est celui d’aucune lésion</translation>
    </message>
    <message>
        <source>belongs to a lesion without a point</source>
        <translation>appartient à une lésion sans point</translation>
    </message>
    <message>
        <source>Write one number for each lesion, in mm; 0 where it is not known</source>
        <translation>Écrivez un nombre pour chaque lésion, en mm ; 0 s’il n’est pas connu</translation>
    </message>
    <message>
        <source>Write 3 to 250 mm, or 0 where it is not known</source>
        <translation>Écrivez 3 à 250 mm, ou 0 s’il n’est pas connu</translation>
    </message>
    <message>
        <source>Write the point of this lesion, too, or 0</source>
        <translation>Écrivez aussi le point de cette lésion, ou 0</translation>
    </message>
    <message>
        <source>is named as DICOM, but is none</source>
        <translation>porte un nom de fichier DICOM, mais n’en est pas un</translation>
    </message>
    <message>
        <source>is %1, not between %2 and %3</source>
        <translation>est %1, pas entre %2 et %3</translation>
    </message>
    <message>
        <source>is not followed in the last frame</source>
        <translation>n’est pas suivi dans la dernière image</translation>
    </message>
    <message>
        <source>is not followed in pictures</source>
        <translation>n’est pas suivi dans des images</translation>
    </message>
    <message>
        <source>would be outside of the picture</source>
        <translation>serait hors de l’image</translation>
    </message>
    <message>
        <source>is behind the camera</source>
        <translation>est derrière la caméra</translation>
    </message>
    <message>
        <source>is more than 40 mm from where it is drawn</source>
        <translation>est à plus de 40 mm de l’endroit où il est dessiné</translation>
    </message>
    <message>
        <source>takes no shape that would meet it</source>
        <translation>ne prend aucune forme qui y réponde</translation>
    </message>
    <message>
        <source>Wait until it is followed again</source>
        <translation>Attendez qu’il soit suivi de nouveau</translation>
    </message>
    <message>
        <source>Track a stereo video</source>
        <translation>Suivez une vidéo stéréo</translation>
    </message>
    <message>
        <source>Drag to where the picture shows it</source>
        <translation>Tirez-le là où l’image le montre</translation>
    </message>
    <message>
        <source>Correct what the picture shows</source>
        <translation>Corrigez ce que l’image montre</translation>
    </message>
    <message>
        <source>Drag less far, or register again</source>
        <translation>Tirez moins loin, ou recalez de nouveau</translation>
    </message>
    <message>
        <source>has seeds already</source>
        <translation>a déjà des germes</translation>
    </message>
    <message>
        <source>shows nothing as large, compact and even as a liver</source>
        <translation>ne montre rien d’aussi grand, compact et homogène qu’un foie</translation>
    </message>
    <message>
        <source>Click the liver yourself</source>
        <translation>Cliquez vous-même le foie</translation>
    </message>
    <message>
        <source>Delete them first, or add more by hand</source>
        <translation>Supprimez-les d’abord, ou ajoutez-en à la main</translation>
    </message>
    <message>
        <source>is used by another program</source>
        <translation>est utilisé par un autre programme</translation>
    </message>
    <message>
        <source>cannot be listened at (%1)</source>
        <translation>ne peut pas être ouvert (%1)</translation>
    </message>
    <message>
        <source>is no numeric address</source>
        <translation>n&apos;est pas une adresse numérique</translation>
    </message>
    <message>
        <source>is no number from 0 to 65535</source>
        <translation>n&apos;est pas un nombre de 0 à 65535</translation>
    </message>
    <message>
        <source>Close that program, or give another port</source>
        <translation>Fermez ce programme ou indiquez un autre port</translation>
    </message>
    <message>
        <source>Give an address of this computer, and a port above 1023</source>
        <translation>Indiquez une adresse de cet ordinateur et un port supérieur à 1023</translation>
    </message>
    <message>
        <source>Give ADDRESS:PORT with a numeric address, as 127.0.0.1:18944</source>
        <translation>Indiquez ADRESSE:PORT avec une adresse numérique, comme 127.0.0.1:18944</translation>
    </message>
    <message>
        <source>was corrected by hand on the voxels of another CT</source>
        <translation>a été corrigé à la main sur les voxels d&apos;un autre scanner</translation>
    </message>
    <message>
        <source>was made of another CT, other seeds or other labels</source>
        <translation>vient d&apos;un autre scanner, d&apos;autres germes ou d&apos;autres étiquettes</translation>
    </message>
    <message>
        <source>Lock it (--lock), keep what was corrected (--keep-edited), or allow it (--replace-edited)</source>
        <translation>Verrouillez-la (--lock), gardez ce qui a été corrigé (--keep-edited) ou permettez-le (--replace-edited)</translation>
    </message>
    <message>
        <source>Open this CT as a new case, or allow it (--replace-edited)</source>
        <translation>Ouvrez ce scanner comme un nouveau cas, ou permettez-le (--replace-edited)</translation>
    </message>
    <message>
        <source>Segment again</source>
        <translation>Segmentez à nouveau</translation>
    </message>
    <message>
        <source>no server of OpenIGTLink answers</source>
        <translation>aucun serveur OpenIGTLink ne répond</translation>
    </message>
    <message>
        <source>sends what is no message of OpenIGTLink</source>
        <translation>envoie ce qui n&apos;est pas un message OpenIGTLink</translation>
    </message>
    <message>
        <source>send no pictures of 8 bits that can be used</source>
        <translation>n&apos;envoient pas d&apos;images de 8 bits utilisables</translation>
    </message>
    <message>
        <source>send no pairs within %1 ms of each other</source>
        <translation>n&apos;envoient pas de paires à moins de %1 ms l&apos;une de l&apos;autre</translation>
    </message>
    <message>
        <source>has closed before a picture came</source>
        <translation>s&apos;est fermé avant l&apos;arrivée d&apos;une image</translation>
    </message>
    <message>
        <source>is empty or longer than 20 letters</source>
        <translation>est vide ou dépasse 20 lettres</translation>
    </message>
    <message>
        <source>is the same for both views</source>
        <translation>est le même pour les deux vues</translation>
    </message>
    <message>
        <source>Start it, and check its address and port</source>
        <translation>Démarrez-le et vérifiez son adresse et son port</translation>
    </message>
    <message>
        <source>Start the server again</source>
        <translation>Redémarrez le serveur</translation>
    </message>
    <message>
        <source>Check that this is the port of PLUS, or of another server of OpenIGTLink</source>
        <translation>Vérifiez que c&apos;est le port de PLUS ou d&apos;un autre serveur OpenIGTLink</translation>
    </message>
    <message>
        <source>Check the names of the two devices, and that they are on</source>
        <translation>Vérifiez les noms des deux appareils et qu&apos;ils sont allumés</translation>
    </message>
    <message>
        <source>Give HOST:PORT/LEFT,RIGHT with the names of the two devices</source>
        <translation>Indiquez ADRESSE:PORT/GAUCHE,DROITE avec les noms des deux appareils</translation>
    </message>
    <message>
        <source>Give HOST:PORT/NAME with the name of the tool&apos;s transform</source>
        <translation>Indiquez ADRESSE:PORT/NOM avec le nom de la transformation de l&apos;outil</translation>
    </message>
    <message>
        <source>is encrypted</source>
        <translation>est chiffré</translation>
    </message>
    <message>
        <source>is one of several parts of an archive</source>
        <translation>est une de plusieurs parties d&apos;une archive</translation>
    </message>
    <message>
        <source>is packed in a way that is not read here</source>
        <translation>est compressé d&apos;une manière qui n&apos;est pas lue ici</translation>
    </message>
    <message>
        <source>is named as a DICOM directory, but is none or is damaged</source>
        <translation>porte le nom d&apos;un répertoire DICOM, mais n&apos;en est pas un ou est endommagé</translation>
    </message>
    <message>
        <source>names files that are all missing, %1 first</source>
        <translation>nomme des fichiers qui manquent tous, d&apos;abord %1</translation>
    </message>
    <message>
        <source>Unpack it with its password and name the folder</source>
        <translation>Décompressez-la avec son mot de passe et nommez le dossier</translation>
    </message>
    <message>
        <source>Unpack it yourself and name the folder</source>
        <translation>Décompressez-la vous-même et nommez le dossier</translation>
    </message>
    <message>
        <source>Unpack it yourself and name the file of labels in it</source>
        <translation>Décompressez-la vous-même et nommez le fichier d’étiquettes qu’elle contient</translation>
    </message>
    <message>
        <source>Give labels as .seg.nrrd, .nii, .nii.gz, .nrrd, .nhdr, .mha, .mhd, .vti or a DICOM segmentation</source>
        <translation>Donnez les étiquettes en .seg.nrrd, .nii, .nii.gz, .nrrd, .nhdr, .mha, .mhd, .vti ou en segmentation DICOM</translation>
    </message>
    <message>
        <source>Unpack them yourself and name the folder</source>
        <translation>Décompressez-les vous-même et nommez le dossier</translation>
    </message>
    <message>
        <source>Copy the whole medium, not its DICOMDIR alone</source>
        <translation>Copiez tout le support, pas seulement son DICOMDIR</translation>
    </message>
    <message>
        <source>Give a folder of DICOM slices, .zip, .tar.gz, .nii, .nii.gz, .nrrd, .nhdr, .mha, .mhd or .vti</source>
        <translation>Donnez un dossier de coupes DICOM, .zip, .tar.gz, .nii, .nii.gz, .nrrd, .nhdr, .mha, .mhd ou .vti</translation>
    </message>
    <message>
        <source>is no ONNX network that can be run here (%1)</source>
        <translation>n&apos;est pas un réseau ONNX qui puisse tourner ici (%1)</translation>
    </message>
    <message>
        <source>broke the program that runs networks: it is damaged or needs too much memory</source>
        <translation>a fait échouer le programme qui calcule les réseaux : il est endommagé ou demande trop de mémoire</translation>
    </message>
    <message>
        <source>took the network more than 120 s for one answer</source>
        <translation>le réseau a mis plus de 120 s pour une réponse</translation>
    </message>
    <message>
        <source>cannot be computed for an input of %1 (%2)</source>
        <translation>ne se calculent pas pour une entrée de %1 (%2)</translation>
    </message>
    <message>
        <source>holds what is no number</source>
        <translation>contient ce qui n&apos;est pas un nombre</translation>
    </message>
    <message>
        <source>is %1, neither slices nor a block</source>
        <translation>est %1, ni des coupes ni un bloc</translation>
    </message>
    <message>
        <source>is %1, not one CT at a time</source>
        <translation>est %1, pas un seul scanner à la fois</translation>
    </message>
    <message>
        <source>is %1 where the network&apos;s input is %2</source>
        <translation>est %1 alors que l&apos;entrée du réseau est %2</translation>
    </message>
    <message>
        <source>is missing where the network leaves its input&apos;s size open</source>
        <translation>manque alors que le réseau laisse ouverte la taille de son entrée</translation>
    </message>
    <message>
        <source>is no field of a network&apos;s sheet</source>
        <translation>n&apos;est pas un champ de la fiche d&apos;un réseau</translation>
    </message>
    <message>
        <source>names no label</source>
        <translation>ne nomme aucune étiquette</translation>
    </message>
    <message>
        <source>is missing where no channel is the background</source>
        <translation>manque alors qu&apos;aucun canal n&apos;est le fond</translation>
    </message>
    <message>
        <source>is not two numbers, the lower first</source>
        <translation>n&apos;est pas deux nombres, le plus petit d&apos;abord</translation>
    </message>
    <message>
        <source>Export it again as ONNX (opset 11), with its weights inside the file</source>
        <translation>Exportez-le à nouveau en ONNX (opset 11), avec ses poids dans le fichier</translation>
    </message>
    <message>
        <source>Copy it again, or use smaller tiles (&quot;tile&quot;)</source>
        <translation>Copiez-le à nouveau, ou prenez des tuiles plus petites (&quot;tile&quot;)</translation>
    </message>
    <message>
        <source>Use smaller tiles (&quot;tile&quot;), or a smaller network</source>
        <translation>Prenez des tuiles plus petites (&quot;tile&quot;) ou un réseau plus petit</translation>
    </message>
    <message>
        <source>Write the size of the network&apos;s input</source>
        <translation>Écrivez la taille de l&apos;entrée du réseau</translation>
    </message>
    <message>
        <source>Write the network&apos;s sheet beside it (see the manual)</source>
        <translation>Écrivez la fiche du réseau à côté (voir le manuel)</translation>
    </message>
    <message>
        <source>Name one label a channel in &quot;channels&quot;, and export a network whose output has the size of its input</source>
        <translation>Nommez dans &quot;channels&quot; une étiquette par canal, et exportez un réseau dont la sortie a la taille de son entrée</translation>
    </message>
    <message>
        <source>Check the window (&quot;window_hu&quot;) and the network&apos;s weights</source>
        <translation>Vérifiez la fenêtre (&quot;window_hu&quot;) et les poids du réseau</translation>
    </message>
    <message>
        <source>Give the size of the network&apos;s input as &quot;tile&quot;, or export a network of other layers</source>
        <translation>Donnez la taille de l&apos;entrée du réseau comme &quot;tile&quot;, ou exportez un réseau fait d&apos;autres couches</translation>
    </message>
    <message>
        <source>holds a fraction of a voxel</source>
        <translation>contient une fraction de voxel</translation>
    </message>
    <message>
        <source>Write whole numbers</source>
        <translation>Écrivez des nombres entiers</translation>
    </message>
    <message>
        <source>names no channel</source>
        <translation>ne nomme aucun canal</translation>
    </message>
    <message>
        <source>is not two numbers</source>
        <translation>n’est pas deux nombres</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;</source>
        <translation>vaut « %1 »</translation>
    </message>
    <message>
        <source>names &quot;%1&quot;, which is no channel</source>
        <translation>nomme « %1 », qui n’est pas un canal</translation>
    </message>
    <message>
        <source>is missing where all channels are liver, or none is</source>
        <translation>manque alors que tous les canaux sont du foie, ou aucun</translation>
    </message>
    <message>
        <source>is not one number for each colour</source>
        <translation>n’est pas un nombre par couleur</translation>
    </message>
    <message>
        <source>holds a fraction of a pixel</source>
        <translation>contient une fraction de pixel</translation>
    </message>
    <message>
        <source>is %1, not 1 x %2 x rows x columns</source>
        <translation>est %1, et non 1 x %2 x lignes x colonnes</translation>
    </message>
    <message>
        <source>Write one name for each output channel, as [&quot;liver&quot;, &quot;tool&quot;]</source>
        <translation>Écrivez un nom par canal de sortie, comme [&quot;liver&quot;, &quot;tool&quot;]</translation>
    </message>
    <message>
        <source>List the channels that may be liver, as [&quot;liver&quot;]</source>
        <translation>Donnez les canaux qui peuvent être du foie, comme [&quot;liver&quot;]</translation>
    </message>
    <message>
        <source>Write names that stand in &quot;channels&quot;</source>
        <translation>Écrivez des noms qui figurent dans &quot;channels&quot;</translation>
    </message>
    <message>
        <source>Say what a score must exceed, as 0.5</source>
        <translation>Dites ce qu’un score doit dépasser, comme 0.5</translation>
    </message>
    <message>
        <source>Write &quot;rgb&quot;, &quot;bgr&quot; or &quot;grey&quot;</source>
        <translation>Écrivez &quot;rgb&quot;, &quot;bgr&quot; ou &quot;grey&quot;</translation>
    </message>
    <message>
        <source>Write mean and sd of colours from 0 to 1, or neither</source>
        <translation>Écrivez mean et sd de couleurs de 0 à 1, ou aucun des deux</translation>
    </message>
    <message>
        <source>Write [rows, columns]</source>
        <translation>Écrivez [lignes, colonnes]</translation>
    </message>
    <message>
        <source>Export a network of one picture, and say its colours (&quot;colours&quot;)</source>
        <translation>Exportez un réseau pour une image et dites ses couleurs (&quot;colours&quot;)</translation>
    </message>
    <message>
        <source>is not CT, and only a CT says what grey a liver has before it is clicked</source>
        <translation>n&apos;est pas un scanner, et seul un scanner dit quel gris a un foie avant qu&apos;on ait cliqué dedans</translation>
    </message>
    <message>
        <source>is not known: nothing tells what its grey values mean</source>
        <translation>n&apos;est pas connue : rien ne dit ce que signifient ses niveaux de gris</translation>
    </message>
    <message>
        <source>is not brighter than the liver in this MRI</source>
        <translation>n&apos;est pas plus clair que le foie dans cette IRM</translation>
    </message>
    <message>
        <source>hardly stands out from fat and air in this MRI</source>
        <translation>se distingue à peine de la graisse et de l&apos;air dans cette IRM</translation>
    </message>
    <message>
        <source>shows much that is far brighter than the liver</source>
        <translation>montre beaucoup de choses bien plus claires que le foie</translation>
    </message>
    <message>
        <source>shows no body</source>
        <translation>ne montre pas de corps</translation>
    </message>
    <message>
        <source>is told by its DICOM files, and is another one</source>
        <translation>est donnée par ses fichiers DICOM, et c&apos;en est une autre</translation>
    </message>
    <message>
        <source>Open a T1 series with fat suppression in the venous phase, or import labels instead</source>
        <translation>Ouvrez une série T1 avec suppression de graisse en phase veineuse, ou importez plutôt des étiquettes</translation>
    </message>
    <message>
        <source>Import it again and say whether it is CT or MRI, or import labels instead</source>
        <translation>Importez-la de nouveau en disant si c&apos;est un scanner ou une IRM, ou importez plutôt des étiquettes</translation>
    </message>
    <message>
        <source>Import a CT or MRI first</source>
        <translation>Importez d&apos;abord un scanner ou une IRM</translation>
    </message>
    <message>
        <source>Leave the choice out</source>
        <translation>Ne donnez pas ce choix</translation>
    </message>
    <message>
        <source>lies there already and is none of the surfaces that are written</source>
        <translation>s’y trouve déjà et n’est aucune des surfaces à écrire</translation>
    </message>
    <message>
        <source>Name a folder; it is made if there is none</source>
        <translation>Indiquez un dossier ; il est créé s’il n’existe pas</translation>
    </message>
    <message>
        <source>Choose an empty folder</source>
        <translation>Choisissez un dossier vide</translation>
    </message>
    <message>
        <source>Use stl, ply, obj or vtp</source>
        <translation>Utilisez stl, ply, obj ou vtp</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is none that surfaces are written in</source>
        <translation>« %1 » n’est pas un format dans lequel on écrit des surfaces</translation>
    </message>
    <message>
        <source>is missing, or no vector a vertex</source>
        <translation>manque, ou n’a pas un vecteur par sommet</translation>
    </message>
    <message>
        <source>is no share from 0 to 1 of each vertex</source>
        <translation>n’a pas une part de 0 à 1 par sommet</translation>
    </message>
    <message>
        <source>do not belong to this atlas.json</source>
        <translation>n’appartiennent pas à cet atlas.json</translation>
    </message>
    <message>
        <source>holds something else than an atlas</source>
        <translation>contient autre chose qu&apos;un atlas</translation>
    </message>
    <message>
        <source>are none in this folder</source>
        <translation>manquent dans ce dossier</translation>
    </message>
    <message>
        <source>has two of the name %1</source>
        <translation>en a deux du nom %1</translation>
    </message>
    <message>
        <source>has no surface</source>
        <translation>n’a pas de surface</translation>
    </message>
    <message>
        <source>has no fine surface</source>
        <translation>n’a pas de surface fine</translation>
    </message>
    <message>
        <source>holds %1 ml</source>
        <translation>contient %1 ml</translation>
    </message>
    <message>
        <source>is mirrored: its mirror image looks like a liver and it does not</source>
        <translation>est en miroir : son image miroir ressemble à un foie, lui non</translation>
    </message>
    <message>
        <source>is missing, or has several columns</source>
        <translation>manque, ou a plusieurs colonnes</translation>
    </message>
    <message>
        <source>are not as many as the trees</source>
        <translation>ne sont pas aussi nombreuses que les arbres</translation>
    </message>
    <message>
        <source>hold a number that is not finite</source>
        <translation>contiennent un nombre qui n’est pas fini</translation>
    </message>
    <message>
        <source>hold what is no label or no node</source>
        <translation>contiennent ce qui n’est pas une étiquette ou pas un nœud</translation>
    </message>
    <message>
        <source>names a tree that is not there</source>
        <translation>nomme un arbre qui n’existe pas</translation>
    </message>
    <message>
        <source>hold a node that is not there</source>
        <translation>contiennent un nœud qui n’existe pas</translation>
    </message>
    <message>
        <source>a beam does not join two nodes of one tree</source>
        <translation>une poutre ne relie pas deux nœuds d’un même arbre</translation>
    </message>
    <message>
        <source>landmarks are read in LPS millimetres only</source>
        <translation>les repères ne sont lus qu’en millimètres LPS</translation>
    </message>
    <message>
        <source>holds no landmark</source>
        <translation>ne contient aucun repère</translation>
    </message>
    <message>
        <source>is no covariance</source>
        <translation>n’est pas une covariance</translation>
    </message>
    <message>
        <source>is not %1 finite numbers a node</source>
        <translation>n’a pas %1 nombres finis par nœud</translation>
    </message>
    <message>
        <source>is not 3 lengths, or those of the nodes are none</source>
        <translation>n’est pas 3 longueurs, ou celles des nœuds n’en sont pas</translation>
    </message>
    <message>
        <source>is negative</source>
        <translation>est négatif</translation>
    </message>
    <message>
        <source>is no probability</source>
        <translation>n’est pas une probabilité</translation>
    </message>
    <message>
        <source>there is no model that they belong to</source>
        <translation>il n’y a pas de modèle auquel elles appartiennent</translation>
    </message>
    <message>
        <source>there is no model that it belongs to</source>
        <translation>il n’y a pas de modèle auquel il appartient</translation>
    </message>
    <message>
        <source>does not belong to this case&apos;s model</source>
        <translation>n’appartient pas au modèle de ce cas</translation>
    </message>
    <message>
        <source>names node %1 of %2</source>
        <translation>nomme le nœud %1 sur %2</translation>
    </message>
    <message>
        <source>names node %1</source>
        <translation>nomme le nœud %1</translation>
    </message>
    <message>
        <source>names triangle %1</source>
        <translation>nomme le triangle %1</translation>
    </message>
    <message>
        <source>names vertex %1 of %2</source>
        <translation>nomme le sommet %1 sur %2</translation>
    </message>
    <message>
        <source>holds nothing of the mesh</source>
        <translation>ne contient rien du maillage</translation>
    </message>
    <message>
        <source>holds node %1, which is held already</source>
        <translation>contient le nœud %1, déjà tenu</translation>
    </message>
    <message>
        <source>is not a node of the mesh or its position not finite</source>
        <translation>n’est pas un nœud du maillage, ou sa position n’est pas finie</translation>
    </message>
    <message>
        <source>is not a node of the mesh</source>
        <translation>n’est pas un nœud du maillage</translation>
    </message>
    <message>
        <source>fix every node of the mesh</source>
        <translation>fixent tous les nœuds du maillage</translation>
    </message>
    <message>
        <source>is %1, out of range</source>
        <translation>vaut %1, hors des limites</translation>
    </message>
    <message>
        <source>belongs to no tetrahedron</source>
        <translation>n’appartient à aucun tétraèdre</translation>
    </message>
    <message>
        <source>are in %1 pieces that share no node</source>
        <translation>sont en %1 morceaux qui ne partagent aucun nœud</translation>
    </message>
    <message>
        <source>holds none</source>
        <translation>n’en contient pas</translation>
    </message>
    <message>
        <source>has %1 values for %2 tetrahedra</source>
        <translation>a %1 valeurs pour %2 tétraèdres</translation>
    </message>
    <message>
        <source>has %1 values for %2 nodes</source>
        <translation>a %1 valeurs pour %2 nœuds</translation>
    </message>
    <message>
        <source>must be one positive number a tetrahedron</source>
        <translation>doit être un nombre positif par tétraèdre</translation>
    </message>
    <message>
        <source>is not finite</source>
        <translation>n’est pas fini</translation>
    </message>
    <message>
        <source>is not one of the %1 of the boundary surface</source>
        <translation>n’est pas l’un des %1 de la surface</translation>
    </message>
    <message>
        <source>is free to move</source>
        <translation>est libre de bouger</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, which is not a posture</source>
        <translation>vaut « %1 », qui n’est pas une position</translation>
    </message>
    <message>
        <source>is not known</source>
        <translation>n’est pas connu</translation>
    </message>
    <message>
        <source>is not positive</source>
        <translation>n’est pas positif</translation>
    </message>
    <message>
        <source>is missing: nothing holds the model in a static solve</source>
        <translation>manque : rien ne tient le modèle en équilibre statique</translation>
    </message>
    <message>
        <source>hold coordinates that are not finite</source>
        <translation>contiennent des coordonnées qui ne sont pas finies</translation>
    </message>
    <message>
        <source>there are none</source>
        <translation>il n’y en a pas</translation>
    </message>
    <message>
        <source>a coordinate is not a finite number</source>
        <translation>une coordonnée n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>a tetrahedral mesh is not written as &quot;%1&quot;</source>
        <translation>un maillage de tétraèdres ne s’écrit pas en « %1 »</translation>
    </message>
    <message>
        <source>a surface is not written as &quot;%1&quot;</source>
        <translation>une surface ne s’écrit pas en « %1 »</translation>
    </message>
    <message>
        <source>does not hold three finite numbers</source>
        <translation>ne contient pas trois nombres finis</translation>
    </message>
    <message>
        <source>holds more than three numbers</source>
        <translation>contient plus de trois nombres</translation>
    </message>
    <message>
        <source>holds no nodes</source>
        <translation>ne contient pas de nœuds</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no node of a mesh of %2</source>
        <translation>« %1 » n’est pas un nœud d’un maillage de %2</translation>
    </message>
    <message>
        <source>is a tetrahedron without four points</source>
        <translation>est un tétraèdre sans quatre points</translation>
    </message>
    <message>
        <source>is of VTK type %1, neither a linear tetrahedron nor a polygon</source>
        <translation>est du type VTK %1, ni un tétraèdre linéaire ni un polygone</translation>
    </message>
    <message>
        <source>is not a legacy VTK file (no &quot;# vtk DataFile Version&quot;)</source>
        <translation>n’est pas un ancien fichier VTK (sans « # vtk DataFile Version »)</translation>
    </message>
    <message>
        <source>is not a gmsh mesh (no $MeshFormat)</source>
        <translation>n’est pas un maillage gmsh (sans $MeshFormat)</translation>
    </message>
    <message>
        <source>is neither a whole binary STL nor an ascii one</source>
        <translation>n’est ni un STL binaire entier ni un STL en texte</translation>
    </message>
    <message>
        <source>has no property &quot;%1&quot;</source>
        <translation>n’a pas la propriété « %1 »</translation>
    </message>
    <message>
        <source>holds &quot;%1&quot;, which is no number</source>
        <translation>contient « %1 », qui n’est pas un nombre</translation>
    </message>
    <message>
        <source>has rows but no properties</source>
        <translation>a des lignes, mais pas de propriétés</translation>
    </message>
    <message>
        <source>the file ends before it, and the header announces %1</source>
        <translation>le fichier finit avant, et l’en-tête en annonce %1</translation>
    </message>
    <message>
        <source>has a list longer than the file</source>
        <translation>a une liste plus longue que le fichier</translation>
    </message>
    <message>
        <source>holds more than a mesh does, with the rows before it</source>
        <translation>contient, avec les lignes précédentes, plus qu’un maillage</translation>
    </message>
    <message>
        <source>has the same nodes as tetrahedron %1</source>
        <translation>a les mêmes nœuds que le tétraèdre %1</translation>
    </message>
    <message>
        <source>there is no liver in them</source>
        <translation>il n’y a pas de foie dedans</translation>
    </message>
    <message>
        <source>is in several large pieces (%1 ml and %2 ml)</source>
        <translation>est en plusieurs grands morceaux (%1 ml et %2 ml)</translation>
    </message>
    <message>
        <source>has several large pieces (%1 and %2)</source>
        <translation>a plusieurs grands morceaux (%1 et %2)</translation>
    </message>
    <message>
        <source>are empty, and a DICOM segmentation holds at least one</source>
        <translation>sont vides, et une segmentation DICOM en contient au moins une</translation>
    </message>
    <message>
        <source>are empty</source>
        <translation>sont vides</translation>
    </message>
    <message>
        <source>is not a finite point</source>
        <translation>n’est pas un point fini</translation>
    </message>
    <message>
        <source>%1 would give more than 200000 vertices</source>
        <translation>%1 donnerait plus de 200000 sommets</translation>
    </message>
    <message>
        <source>there are more than 240</source>
        <translation>il y en a plus de 240</translation>
    </message>
    <message>
        <source>all are degenerate</source>
        <translation>tous sont dégénérés</translation>
    </message>
    <message>
        <source>has holes or edges with more than two triangles</source>
        <translation>a des trous ou des arêtes de plus de deux triangles</translation>
    </message>
    <message>
        <source>encloses no volume</source>
        <translation>n’enferme aucun volume</translation>
    </message>
    <message>
        <source>there is no such list</source>
        <translation>il n’y a pas de telle liste</translation>
    </message>
    <message>
        <source>edits are read in LPS millimetres only</source>
        <translation>les modifications ne sont lues qu’en millimètres LPS</translation>
    </message>
    <message>
        <source>lies %1 mm from the vessel</source>
        <translation>est à %1 mm du vaisseau</translation>
    </message>
    <message>
        <source>could not be put into this format</source>
        <translation>n’a pas pu être mis dans ce format</translation>
    </message>
    <message>
        <source>measures %1 m across when read in %2, and a liver measures 0.08 to 0.6 m</source>
        <translation>mesure %1 m, lu en %2, et un foie mesure 0,08 à 0,6 m</translation>
    </message>
    <message>
        <source>Build the atlas again, or take another one</source>
        <translation>Construisez l’atlas de nouveau, ou prenez-en un autre</translation>
    </message>
    <message>
        <source>Build the atlas again with this program</source>
        <translation>Construisez l’atlas de nouveau avec ce programme</translation>
    </message>
    <message>
        <source>Copy both files of one atlas</source>
        <translation>Copiez les deux fichiers d’un même atlas</translation>
    </message>
    <message>
        <source>Name a new folder</source>
        <translation>Indiquez un nouveau dossier</translation>
    </message>
    <message>
        <source>Name a case or a folder of cases</source>
        <translation>Indiquez un cas ou un dossier de cas</translation>
    </message>
    <message>
        <source>Give %1 livers at least</source>
        <translation>Donnez au moins %1 foies</translation>
    </message>
    <message>
        <source>Give each liver once</source>
        <translation>Donnez chaque foie une fois</translation>
    </message>
    <message>
        <source>Build the model of the liver first</source>
        <translation>Construisez d’abord le modèle du foie</translation>
    </message>
    <message>
        <source>Build the model from labels or surfaces</source>
        <translation>Construisez le modèle à partir d’étiquettes ou de surfaces</translation>
    </message>
    <message>
        <source>Give the closed surface of the liver</source>
        <translation>Donnez la surface fermée du foie</translation>
    </message>
    <message>
        <source>Give the whole liver&apos;s surface</source>
        <translation>Donnez la surface du foie entier</translation>
    </message>
    <message>
        <source>Mend left and right in the file&apos;s header, or leave this liver out</source>
        <translation>Corrigez gauche et droite dans l’en-tête du fichier, ou laissez ce foie de côté</translation>
    </message>
    <message>
        <source>Write it as a list of [x, y, z] in millimetres (LPS)</source>
        <translation>Écrivez-le comme liste de [x, y, z] en millimètres (LPS)</translation>
    </message>
    <message>
        <source>Give anterior_margin, umbilical_notch or vena_cava</source>
        <translation>Donnez anterior_margin, umbilical_notch ou vena_cava</translation>
    </message>
    <message>
        <source>Convert them, or correct the two fields</source>
        <translation>Convertissez-les, ou corrigez les deux champs</translation>
    </message>
    <message>
        <source>Give 3 x 3 numbers, symmetric and without negative variances, or leave it out</source>
        <translation>Donnez 3 x 3 nombres, symétriques et sans variance négative, ou laissez-le de côté</translation>
    </message>
    <message>
        <source>Write it as &apos;glisson register&apos; does, or leave it out</source>
        <translation>Écrivez-le comme « glisson register », ou laissez-le de côté</translation>
    </message>
    <message>
        <source>Write it as &apos;glisson register&apos; does, or leave both out</source>
        <translation>Écrivez-le comme « glisson register », ou laissez les deux de côté</translation>
    </message>
    <message>
        <source>Give lengths, or leave it out</source>
        <translation>Donnez des longueurs, ou laissez-le de côté</translation>
    </message>
    <message>
        <source>Give a number from 0 to 1, or leave the rival out</source>
        <translation>Donnez un nombre de 0 à 1, ou laissez l’autre position de côté</translation>
    </message>
    <message>
        <source>Give the file that &apos;glisson register&apos; wrote for this model</source>
        <translation>Donnez le fichier que « glisson register » a écrit pour ce modèle</translation>
    </message>
    <message>
        <source>Remove the file: operations are simulated anew</source>
        <translation>Retirez le fichier : les opérations sont simulées de nouveau</translation>
    </message>
    <message>
        <source>The mesh has nodes 0 to %1</source>
        <translation>Le maillage a les nœuds 0 à %1</translation>
    </message>
    <message>
        <source>The surface has triangles 0 to %1</source>
        <translation>La surface a les triangles 0 à %1</translation>
    </message>
    <message>
        <source>Move or widen the region (millimetres, in the mesh&apos;s frame)</source>
        <translation>Déplacez ou élargissez la région (millimètres, dans le repère du maillage)</translation>
    </message>
    <message>
        <source>Keep fixed and moved nodes apart</source>
        <translation>Séparez les nœuds fixes des nœuds déplacés</translation>
    </message>
    <message>
        <source>Give 0-based indices below %1</source>
        <translation>Donnez des numéros de 0 à moins de %1</translation>
    </message>
    <message>
        <source>Leave some free to move</source>
        <translation>Laissez-en quelques-uns libres</translation>
    </message>
    <message>
        <source>Give Young&apos;s modulus in pascals, between 1 and 1e12 (3.5 kPa is 3500)</source>
        <translation>Donnez le module de Young en pascals, entre 1 et 1e12 (3,5 kPa font 3500)</translation>
    </message>
    <message>
        <source>Give a Poisson ratio from 0 to below 0.5</source>
        <translation>Donnez un coefficient de Poisson de 0 à moins de 0,5</translation>
    </message>
    <message>
        <source>Give a value between %1 and %2 %3</source>
        <translation>Donnez une valeur entre %1 et %2 %3</translation>
    </message>
    <message>
        <source>Drop unused vertices from the mesh</source>
        <translation>Retirez du maillage les sommets inutilisés</translation>
    </message>
    <message>
        <source>Give a tetrahedral mesh of the liver</source>
        <translation>Donnez un maillage de tétraèdres du foie</translation>
    </message>
    <message>
        <source>Give one label a tetrahedron, or none</source>
        <translation>Donnez une étiquette par tétraèdre, ou aucune</translation>
    </message>
    <message>
        <source>Give relative moduli</source>
        <translation>Donnez des modules relatifs</translation>
    </message>
    <message>
        <source>Mend the mesh</source>
        <translation>Réparez le maillage</translation>
    </message>
    <message>
        <source>Correct the load</source>
        <translation>Corrigez la charge</translation>
    </message>
    <message>
        <source>Give a step between 1e-6 and 10 s</source>
        <translation>Donnez un pas entre 1e-6 et 10 s</translation>
    </message>
    <message>
        <source>Give a relative residual between 1e-12 and 0.1</source>
        <translation>Donnez un résidu relatif entre 1e-12 et 0,1</translation>
    </message>
    <message>
        <source>Give 1 or more</source>
        <translation>Donnez 1 ou plus</translation>
    </message>
    <message>
        <source>Give 1 or 2</source>
        <translation>Donnez 1 ou 2</translation>
    </message>
    <message>
        <source>Name it among the fixed nodes of the integrator</source>
        <translation>Nommez-le parmi les nœuds fixes de l’intégrateur</translation>
    </message>
    <message>
        <source>Take supine, prone, left_flank, right_flank, standing, none or three numbers in m/s2</source>
        <translation>Prenez supine, prone, left_flank, right_flank, standing, none ou trois nombres en m/s2</translation>
    </message>
    <message>
        <source>Correct it</source>
        <translation>Corrigez-le</translation>
    </message>
    <message>
        <source>Take one of %1</source>
        <translation>Prenez l’un de %1</translation>
    </message>
    <message>
        <source>Fix nodes or attach springs to it</source>
        <translation>Fixez des nœuds ou attachez-y des ressorts</translation>
    </message>
    <message>
        <source>Give 1 to 1000000</source>
        <translation>Donnez 1 à 1000000</translation>
    </message>
    <message>
        <source>Give 1e-8 or so</source>
        <translation>Donnez 1e-8 environ</translation>
    </message>
    <message>
        <source>Build the vessel tree anew</source>
        <translation>Construisez l’arbre de vaisseaux de nouveau</translation>
    </message>
    <message>
        <source>Give one outer radius a node</source>
        <translation>Donnez un rayon extérieur par nœud</translation>
    </message>
    <message>
        <source>Give outer radii between 0 and 100 mm, in metres</source>
        <translation>Donnez des rayons extérieurs entre 0 et 100 mm, en mètres</translation>
    </message>
    <message>
        <source>Make the mesh coarser, or save it in binary</source>
        <translation>Rendez le maillage plus grossier, ou enregistrez-le en binaire</translation>
    </message>
    <message>
        <source>Make the mesh coarser, or leave out what is no point and no face</source>
        <translation>Rendez le maillage plus grossier, ou laissez de côté ce qui n’est ni point ni face</translation>
    </message>
    <message>
        <source>Export the mesh anew</source>
        <translation>Exportez le maillage de nouveau</translation>
    </message>
    <message>
        <source>Export the surface anew</source>
        <translation>Exportez la surface de nouveau</translation>
    </message>
    <message>
        <source>Remove the vertices that the volume does not use</source>
        <translation>Retirez les sommets que le volume n’utilise pas</translation>
    </message>
    <message>
        <source>Merge the vertices that lie in the same place, or leave the loose pieces out</source>
        <translation>Fusionnez les sommets situés au même endroit, ou laissez de côté les morceaux isolés</translation>
    </message>
    <message>
        <source>Give .vtu, .vtk, .msh, .vtp, .stl, .obj or .ply</source>
        <translation>Donnez .vtu, .vtk, .msh, .vtp, .stl, .obj ou .ply</translation>
    </message>
    <message>
        <source>Give .vtu, legacy .vtk or .msh</source>
        <translation>Donnez .vtu, .vtk ancien ou .msh</translation>
    </message>
    <message>
        <source>Name the file .vtu or .vtk</source>
        <translation>Nommez le fichier .vtu ou .vtk</translation>
    </message>
    <message>
        <source>Name the file .vtp, .vtk, .stl, .obj or .ply</source>
        <translation>Nommez le fichier .vtp, .vtk, .stl, .obj ou .ply</translation>
    </message>
    <message>
        <source>Give a closed surface</source>
        <translation>Donnez une surface fermée</translation>
    </message>
    <message>
        <source>Give one node as &quot;x y z&quot; a line</source>
        <translation>Donnez un nœud « x y z » par ligne</translation>
    </message>
    <message>
        <source>Give 0-based node numbers of this mesh</source>
        <translation>Donnez des numéros de nœuds de ce maillage, à partir de 0</translation>
    </message>
    <message>
        <source>Convert the mesh to linear tetrahedra</source>
        <translation>Convertissez le maillage en tétraèdres linéaires</translation>
    </message>
    <message>
        <source>Give a tetrahedral mesh, or a closed surface to be meshed</source>
        <translation>Donnez un maillage de tétraèdres, ou une surface fermée à mailler</translation>
    </message>
    <message>
        <source>Remove one of them</source>
        <translation>Retirez l’un d’eux</translation>
    </message>
    <message>
        <source>Swap two of its vertices, or mesh anew</source>
        <translation>Échangez deux de ses sommets, ou maillez de nouveau</translation>
    </message>
    <message>
        <source>Remove it by mesh optimisation (perturb and exude), or mesh anew</source>
        <translation>Retirez-le par optimisation du maillage (perturb et exude), ou maillez de nouveau</translation>
    </message>
    <message>
        <source>Segment the liver first</source>
        <translation>Segmentez d’abord le foie</translation>
    </message>
    <message>
        <source>Join them or erase those that are not liver</source>
        <translation>Joignez-les, ou effacez ceux qui ne sont pas du foie</translation>
    </message>
    <message>
        <source>Ask for 1 to 100000 beams</source>
        <translation>Demandez 1 à 100000 poutres</translation>
    </message>
    <message>
        <source>Ask for 20 to 200000 vertices</source>
        <translation>Demandez 20 à 200000 sommets</translation>
    </message>
    <message>
        <source>Ask for longer edges</source>
        <translation>Demandez des arêtes plus longues</translation>
    </message>
    <message>
        <source>Place it on the vessel&apos;s entrance</source>
        <translation>Placez-le à l’entrée du vaisseau</translation>
    </message>
    <message>
        <source>Give an edge length of 1 to 100 mm</source>
        <translation>Donnez une longueur d’arête de 1 à 100 mm</translation>
    </message>
    <message>
        <source>Give a ratio of 0.2 to 1</source>
        <translation>Donnez un rapport de 0,2 à 1</translation>
    </message>
    <message>
        <source>Give a ratio of 0.1 to 10</source>
        <translation>Donnez un rapport de 0,1 à 10</translation>
    </message>
    <message>
        <source>Keep those that matter</source>
        <translation>Gardez celles qui comptent</translation>
    </message>
    <message>
        <source>Close it (fill its holes) before it is meshed</source>
        <translation>Fermez-la (bouchez ses trous) avant de la mailler</translation>
    </message>
    <message>
        <source>Keep the one that is the liver, or join them</source>
        <translation>Gardez celui qui est le foie, ou joignez-les</translation>
    </message>
    <message>
        <source>Write {&quot;edits&quot;: [...]}</source>
        <translation>Écrivez {&quot;edits&quot;: [...]}</translation>
    </message>
    <message>
        <source>Write {&quot;edit&quot;: &quot;prune&quot;, &quot;at&quot;: [x, y, z]} in millimetres (LPS)</source>
        <translation>Écrivez {&quot;edit&quot;: &quot;prune&quot;, &quot;at&quot;: [x, y, z]} en millimètres (LPS)</translation>
    </message>
    <message>
        <source>Choose another one</source>
        <translation>Choisissez-en un autre</translation>
    </message>
    <message>
        <source>Check what the file holds; no usual unit makes a liver of it</source>
        <translation>Vérifiez ce que contient le fichier ; aucune unité usuelle n’en fait un foie</translation>
    </message>
    <message>
        <source>Read it in %1</source>
        <translation>Lisez-le en %1</translation>
    </message>
    <message>
        <source>If it is in inches, enlarge it 25.4 times where it was made, and read it in mm</source>
        <translation>S&apos;il est en pouces, agrandissez-le 25,4 fois dans le programme qui l&apos;a fait, et lisez-le en mm</translation>
    </message>
    <message>
        <source>Read it in %1; if it is in inches, enlarge it 25.4 times where it was made, and read it in mm</source>
        <translation>Lisez-le en %1 ; s&apos;il est en pouces, agrandissez-le 25,4 fois dans le programme qui l&apos;a fait, et lisez-le en mm</translation>
    </message>
    <message>
        <source>cannot be followed: %1</source>
        <translation>ne peut pas être suivi : %1</translation>
    </message>
    <message>
        <source>is %1 x %2, the calibration&apos;s is %3 x %4</source>
        <translation>fait %1 x %2, celle du calibrage %3 x %4</translation>
    </message>
    <message>
        <source>is %1, the calibration&apos;s %2</source>
        <translation>fait %1, celle du calibrage %2</translation>
    </message>
    <message>
        <source>there are %1, the model has %2</source>
        <translation>il y en a %1, le modèle en a %2</translation>
    </message>
    <message>
        <source>the mesh has nodes 0 to %1</source>
        <translation>le maillage a les nœuds 0 à %1</translation>
    </message>
    <message>
        <source>is not CT, and the network&apos;s window is of Hounsfield units</source>
        <translation>n’est pas un scanner, et la fenêtre du réseau est en unités Hounsfield</translation>
    </message>
    <message>
        <source>is more than 1 GB</source>
        <translation>dépasse 1 Go</translation>
    </message>
    <message>
        <source>are %1, not one</source>
        <translation>sont %1, pas un</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>ne peut pas être lu</translation>
    </message>
    <message>
        <source>is not a finite number</source>
        <translation>n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>names no label code</source>
        <translation>ne nomme aucun code d’étiquette</translation>
    </message>
    <message>
        <source>is not a label code</source>
        <translation>n’est pas un code d’étiquette</translation>
    </message>
    <message>
        <source>has a normal without a direction</source>
        <translation>a une normale sans direction</translation>
    </message>
    <message>
        <source>has the label %1, which is none</source>
        <translation>a l’étiquette %1, qui n’en est pas une</translation>
    </message>
    <message>
        <source>has two columns for &quot;%1&quot;: %2 and %3</source>
        <translation>a deux colonnes pour « %1 » : %2 et %3</translation>
    </message>
    <message>
        <source>has a sigma that is no standard deviation</source>
        <translation>a un sigma qui n’est pas un écart type</translation>
    </message>
    <message>
        <source>is missing: the file holds no points</source>
        <translation>manque : le fichier ne contient pas de points</translation>
    </message>
    <message>
        <source>half of its points lie within %1 m of its middle when read in %2, which is no liver</source>
        <translation>la moitié de ses points est, lue en %2, à moins de %1 m de son milieu, ce qui n’est pas un foie</translation>
    </message>
    <message>
        <source>is of another moment than the video&apos;s</source>
        <translation>est d’un autre moment que celui de la vidéo</translation>
    </message>
    <message>
        <source>has no mesh of tetrahedra</source>
        <translation>n’a pas de maillage de tétraèdres</translation>
    </message>
    <message>
        <source>is %1, and the mesh&apos;s is %2</source>
        <translation>est %1, et celle du maillage %2</translation>
    </message>
    <message>
        <source>there are %1, at least 10 are needed</source>
        <translation>il y en a %1, il en faut au moins 10</translation>
    </message>
    <message>
        <source>its place is not known</source>
        <translation>sa place n’est pas connue</translation>
    </message>
    <message>
        <source>there are not as many as points</source>
        <translation>il n’y en a pas autant que de points</translation>
    </message>
    <message>
        <source>is not of this model</source>
        <translation>n’est pas de ce modèle</translation>
    </message>
    <message>
        <source>has been seen at %1 places only, where %2 are needed</source>
        <translation>n’a été vu qu’en %1 endroits, il en faut %2</translation>
    </message>
    <message>
        <source>is not 16 numbers</source>
        <translation>n’est pas 16 nombres</translation>
    </message>
    <message>
        <source>its upper left 3 x 3 block is not a rotation</source>
        <translation>son bloc 3 x 3 en haut à gauche n’est pas une rotation</translation>
    </message>
    <message>
        <source>its last row is not 0 0 0 1</source>
        <translation>sa dernière ligne n’est pas 0 0 0 1</translation>
    </message>
    <message>
        <source>there are %1 other places, not %2</source>
        <translation>il y a %1 autres positions, pas %2</translation>
    </message>
    <message>
        <source>is not a list of numbers</source>
        <translation>n’est pas une liste de nombres</translation>
    </message>
    <message>
        <source>is not a number</source>
        <translation>n’est pas un nombre</translation>
    </message>
    <message>
        <source>has an empty picture</source>
        <translation>a une image vide</translation>
    </message>
    <message>
        <source>is %1 pixels, the others %2</source>
        <translation>fait %1 pixels, les autres %2</translation>
    </message>
    <message>
        <source>is %1 pixels, its calibration is for %2</source>
        <translation>fait %1 pixels, son calibrage est pour %2</translation>
    </message>
    <message>
        <source>is %1 pixels, the left image %2</source>
        <translation>fait %1 pixels, l’image gauche %2</translation>
    </message>
    <message>
        <source>is %1 pixels wide, so it has no two halves</source>
        <translation>fait %1 pixels de large, donc n’a pas deux moitiés</translation>
    </message>
    <message>
        <source>is %1 pixels high, so it has no two halves</source>
        <translation>fait %1 pixels de haut, donc n’a pas deux moitiés</translation>
    </message>
    <message>
        <source>holds one picture twice</source>
        <translation>contient deux fois une même image</translation>
    </message>
    <message>
        <source>is seen as a board of %1, where %2 inner corners are told</source>
        <translation>est vue comme une mire de %1, alors que %2 coins intérieurs sont indiqués</translation>
    </message>
    <message>
        <source>%1 of %2 pairs show a board of %3 inner corners in both pictures, %4 are needed</source>
        <translation>%1 paires sur %2 montrent une mire de %3 coins intérieurs dans les deux images, il en faut %4</translation>
    </message>
    <message>
        <source>leave the focal length open (%1 px, give or take %2): all %3 show the board at nearly one slant</source>
        <translation>laissent la distance focale ouverte (%1 px, à %2 près) : toutes les %3 montrent la mire presque sous la même inclinaison</translation>
    </message>
    <message>
        <source>of %1 mm gives a baseline of %2 mm, where a stereo laparoscope has 1 to 30 mm</source>
        <translation>de %1 mm donne une base de %2 mm, alors qu’un laparoscope stéréo a 1 à 30 mm</translation>
    </message>
    <message>
        <source>holds a view without a name</source>
        <translation>contient une vue sans nom</translation>
    </message>
    <message>
        <source>are %1 without those left out</source>
        <translation>sont %1 sans celles laissées de côté</translation>
    </message>
    <message>
        <source>is %1x%2, not 3x3</source>
        <translation>est %1x%2, pas 3x3</translation>
    </message>
    <message>
        <source>is %1x%2, not a vector of %3 or more numbers</source>
        <translation>est %1x%2, pas un vecteur de %3 nombres ou plus</translation>
    </message>
    <message>
        <source>is %1x%2, not a vector of %3 numbers</source>
        <translation>est %1x%2, pas un vecteur de %3 nombres</translation>
    </message>
    <message>
        <source>is not a number of pixels from 16 to 16384</source>
        <translation>n’est pas un nombre de pixels de 16 à 16384</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, which is no unit of length here</source>
        <translation>vaut « %1 », qui n’est pas ici une unité de longueur</translation>
    </message>
    <message>
        <source>uses more than the five terms k1 k2 p1 p2 k3</source>
        <translation>utilise plus que les cinq termes k1 k2 p1 p2 k3</translation>
    </message>
    <message>
        <source>has no calibration in it that is whole (of cameras, distortions and the transform between them, one file is missing)</source>
        <translation>ne contient pas de calibrage entier (des caméras, des distorsions et de la transformation entre elles, un fichier manque)</translation>
    </message>
    <message>
        <source>is a second file of its kind beside %1</source>
        <translation>est un second fichier de ce genre à côté de %1</translation>
    </message>
    <message>
        <source>holds %1 numbers, not 3x3</source>
        <translation>contient %1 nombres, pas 3x3</translation>
    </message>
    <message>
        <source>holds %1 numbers, not 4 or 5</source>
        <translation>contient %1 nombres, pas 4 ou 5</translation>
    </message>
    <message>
        <source>holds %1 numbers, not 3x4 or 4x4</source>
        <translation>contient %1 nombres, pas 3x4 ou 4x4</translation>
    </message>
    <message>
        <source>is not 0 0 0 1</source>
        <translation>n’est pas 0 0 0 1</translation>
    </message>
    <message>
        <source>is not valid OpenCV YAML (at %1)</source>
        <translation>n’est pas du YAML OpenCV valide (à %1)</translation>
    </message>
    <message>
        <source>is not valid OpenCV YAML</source>
        <translation>n’est pas du YAML OpenCV valide</translation>
    </message>
    <message>
        <source>fit the calibration better when swapped (%1 matches in front of the cameras, %2 as given)</source>
        <translation>vont mieux avec le calibrage si on les échange (%1 correspondances devant les caméras, %2 telles quelles)</translation>
    </message>
    <message>
        <source>is not the left one</source>
        <translation>n’est pas la gauche</translation>
    </message>
    <message>
        <source>is not the number of a frame</source>
        <translation>n’est pas le numéro d’une image</translation>
    </message>
    <message>
        <source>is not a camera matrix (fx 0 cx; 0 fy cy; 0 0 1)</source>
        <translation>n’est pas une matrice de caméra (fx 0 cx; 0 fy cy; 0 0 1)</translation>
    </message>
    <message>
        <source>has its principal point (%1, %2) outside the image of %3x%4</source>
        <translation>a son point principal (%1, %2) hors de l’image de %3x%4</translation>
    </message>
    <message>
        <source>is transposed: it has cx and cy in its last row</source>
        <translation>est transposée : cx et cy se trouvent dans sa dernière ligne</translation>
    </message>
    <message>
        <source>has a skew of %1 (row 1, column 2), which moves pixels by up to %2 px and is not computed with</source>
        <translation>a un cisaillement de %1 (ligne 1, colonne 2), qui déplace des pixels de jusqu&apos;à %2 px et dont le calcul ne tient pas compte</translation>
    </message>
    <message>
        <source>moves pixels by up to %1 px by its tangential terms p1 p2, and by %2 px by its radial ones, which no lens does</source>
        <translation>déplace des pixels de jusqu&apos;à %1 px par ses termes tangentiels p1 p2 et de %2 px par ses termes radiaux, ce que ne fait aucune lentille</translation>
    </message>
    <message>
        <source>gives too few points: what both views show lies %1 pixels from its epipolar lines, and is looked for within %2</source>
        <translation>donne trop peu de points : ce que montrent les deux vues est à %1 pixels de ses lignes épipolaires et n’est cherché que jusqu’à %2</translation>
    </message>
    <message>
        <source>Write rows as columns, in R too; MATLAB counts pixels from 1: take 1 off cx and cy</source>
        <translation>Écrivez les lignes en colonnes, dans R aussi ; MATLAB compte les pixels à partir de 1 : ôtez 1 à cx et cy</translation>
    </message>
    <message>
        <source>Calibrate without skew, which no chip has (fx 0 cx; 0 fy cy; 0 0 1)</source>
        <translation>Étalonnez sans cisaillement, qu&apos;aucun capteur n&apos;a (fx 0 cx; 0 fy cy; 0 0 1)</translation>
    </message>
    <message>
        <source>Write k1 k2 p1 p2 k3 in this order (MATLAB has k1 k2 k3 apart), or calibrate again</source>
        <translation>Écrivez k1 k2 p1 p2 k3 dans cet ordre (MATLAB tient k1 k2 k3 à part) ou étalonnez à nouveau</translation>
    </message>
    <message>
        <source>is a case already</source>
        <translation>est déjà un cas</translation>
    </message>
    <message>
        <source>Choose another one for another patient; for another image of the same patient give --replace: all else stays, marked out of date</source>
        <translation>Pour un autre patient, choisissez-en un autre ; pour une autre image du même patient, donnez --replace : tout le reste demeure, marqué comme périmé</translation>
    </message>
    <message>
        <source>leaves nothing of the picture</source>
        <translation>ne laisse rien de l’image</translation>
    </message>
    <message>
        <source>the picture could not be encoded</source>
        <translation>l’image n’a pas pu être encodée</translation>
    </message>
    <message>
        <source>no picture has such a name</source>
        <translation>aucune image n’a un tel nom</translation>
    </message>
    <message>
        <source>%1 of %2 frames can be read back</source>
        <translation>%1 images sur %2 peuvent être relues</translation>
    </message>
    <message>
        <source>holds %1 numbers where %2 are expected</source>
        <translation>contient %1 nombres, %2 sont attendus</translation>
    </message>
    <message>
        <source>holds %1, which is no number of voxels</source>
        <translation>contient %1, qui n’est pas un nombre de voxels</translation>
    </message>
    <message>
        <source>names &quot;%1&quot;, which lies in another folder</source>
        <translation>nomme « %1 », qui est dans un autre dossier</translation>
    </message>
    <message>
        <source>names %1, which is missing</source>
        <translation>nomme %1, qui manque</translation>
    </message>
    <message>
        <source>is not that of a NIfTI-1 file that holds its voxels itself</source>
        <translation>n’est pas celui d’un fichier NIfTI-1 qui contient lui-même ses voxels</translation>
    </message>
    <message>
        <source>marks no array as the scalars</source>
        <translation>ne marque aucun tableau comme scalaires</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, which is no number format that is known</source>
        <translation>vaut « %1 », qui n’est pas un format de nombres connu</translation>
    </message>
    <message>
        <source>holds fewer values than there are voxels</source>
        <translation>contient moins de valeurs qu’il n’y a de voxels</translation>
    </message>
    <message>
        <source>is a DICOM directory that was cut or is damaged</source>
        <translation>est un répertoire DICOM coupé ou endommagé</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, not a whole number from %2 to %3</source>
        <translation>vaut « %1 », pas un nombre entier de %2 à %3</translation>
    </message>
    <message>
        <source>cannot be written as a DICOM segmentation (%1)</source>
        <translation>ne peuvent pas être écrites comme segmentation DICOM (%1)</translation>
    </message>
    <message>
        <source>is more than the 65535 pixels a side that DICOM counts</source>
        <translation>dépasse les 65535 pixels par côté que compte DICOM</translation>
    </message>
    <message>
        <source>is more than NIfTI can hold</source>
        <translation>dépasse ce que NIfTI peut contenir</translation>
    </message>
    <message>
        <source>cannot be searched (%1)</source>
        <translation>ne peut pas être parcouru (%1)</translation>
    </message>
    <message>
        <source>could not be made (%1)</source>
        <translation>n’a pas pu être créé (%1)</translation>
    </message>
    <message>
        <source>is %1, not %2</source>
        <translation>est %1, pas %2</translation>
    </message>
    <message>
        <source>left what is no result of it</source>
        <translation>a laissé ce qui n’est pas un résultat de lui</translation>
    </message>
    <message>
        <source>Register again, from more of the surface</source>
        <translation>Recalez de nouveau, avec plus de surface</translation>
    </message>
    <message>
        <source>Register again</source>
        <translation>Recalez de nouveau</translation>
    </message>
    <message>
        <source>Register from the start</source>
        <translation>Recalez depuis le début</translation>
    </message>
    <message>
        <source>Give both views of every frame</source>
        <translation>Donnez les deux vues de chaque image</translation>
    </message>
    <message>
        <source>Use the calibration of this video</source>
        <translation>Utilisez le calibrage de cette vidéo</translation>
    </message>
    <message>
        <source>Give a registration of this model</source>
        <translation>Donnez un recalage de ce modèle</translation>
    </message>
    <message>
        <source>Export a network whose input is [1, 1, rows, columns] or [1, 1, slices, rows, columns]</source>
        <translation>Exportez un réseau dont l’entrée est [1, 1, lignes, colonnes] ou [1, 1, coupes, lignes, colonnes]</translation>
    </message>
    <message>
        <source>Export a network whose input has a batch and a channel of 1</source>
        <translation>Exportez un réseau dont l’entrée a un lot et un canal de 1</translation>
    </message>
    <message>
        <source>Open a CT</source>
        <translation>Ouvrez un scanner</translation>
    </message>
    <message>
        <source>Use a coarser spacing, or tiles of fewer slices</source>
        <translation>Utilisez un pas plus grossier, ou des tuiles de moins de coupes</translation>
    </message>
    <message>
        <source>Use a smaller network</source>
        <translation>Utilisez un réseau plus petit</translation>
    </message>
    <message>
        <source>Export a network with one input and one output</source>
        <translation>Exportez un réseau avec une entrée et une sortie</translation>
    </message>
    <message>
        <source>Connect again</source>
        <translation>Connectez de nouveau</translation>
    </message>
    <message>
        <source>Give pixels of the picture</source>
        <translation>Donnez des pixels de l’image</translation>
    </message>
    <message>
        <source>Give lines as &apos;glisson track --correct&apos; writes them into frames.jsonl</source>
        <translation>Donnez des lignes comme « glisson track --correct » les écrit dans frames.jsonl</translation>
    </message>
    <message>
        <source>Write a JSON object such as {&quot;6&quot;: &quot;parenchyma&quot;, &quot;10&quot;: &quot;portal_vein&quot;}</source>
        <translation>Écrivez un objet JSON comme {&quot;6&quot;: &quot;parenchyma&quot;, &quot;10&quot;: &quot;portal_vein&quot;}</translation>
    </message>
    <message>
        <source>Codes are whole numbers from 0 to 65535, in quotes</source>
        <translation>Les codes sont des nombres entiers de 0 à 65535, entre guillemets</translation>
    </message>
    <message>
        <source>Use background, parenchyma, portal_vein, hepatic_veins, vena_cava, artery, gallbladder or lesion_1 to lesion_240 (or other_1 to other_9)</source>
        <translation>Utilisez background, parenchyma, portal_vein, hepatic_veins, vena_cava, artery, gallbladder ou lesion_1 à lesion_240 (ou other_1 à other_9)</translation>
    </message>
    <message>
        <source>Export the cloud again as PLY</source>
        <translation>Exportez le nuage de nouveau en PLY</translation>
    </message>
    <message>
        <source>Compute the normals again or leave nx ny nz out</source>
        <translation>Calculez les normales de nouveau, ou laissez nx ny nz de côté</translation>
    </message>
    <message>
        <source>Labels are 1 (surface), 2 (anterior margin) and 3 (umbilical notch)</source>
        <translation>Les étiquettes sont 1 (surface), 2 (bord antérieur) et 3 (échancrure ombilicale)</translation>
    </message>
    <message>
        <source>It must be a number of 0 or more</source>
        <translation>Ce doit être un nombre de 0 ou plus</translation>
    </message>
    <message>
        <source>Check what the file holds</source>
        <translation>Vérifiez ce que contient le fichier</translation>
    </message>
    <message>
        <source>Give what &apos;glisson track&apos; wrote</source>
        <translation>Donnez ce que « glisson track » a écrit</translation>
    </message>
    <message>
        <source>Give a folder that &apos;glisson track&apos; filled</source>
        <translation>Donnez un dossier que « glisson track » a rempli</translation>
    </message>
    <message>
        <source>Give the track of this video</source>
        <translation>Donnez le suivi de cette vidéo</translation>
    </message>
    <message>
        <source>Track the case itself: --model CASE</source>
        <translation>Suivez le cas lui-même : --model CAS</translation>
    </message>
    <message>
        <source>Give the case whose model was tracked</source>
        <translation>Donnez le cas dont le modèle a été suivi</translation>
    </message>
    <message>
        <source>Reconstruct with more features or larger regions</source>
        <translation>Reconstruisez avec plus de points ou des régions plus grandes</translation>
    </message>
    <message>
        <source>Place it among the landmarks</source>
        <translation>Placez-la parmi les repères</translation>
    </message>
    <message>
        <source>Remove the point</source>
        <translation>Retirez le point</translation>
    </message>
    <message>
        <source>Give one a point, or none</source>
        <translation>Donnez-en une par point, ou aucune</translation>
    </message>
    <message>
        <source>Follow the organ for a second and show more of it</source>
        <translation>Suivez l’organe une seconde et montrez-en davantage</translation>
    </message>
    <message>
        <source>Write a 4 x 4 matrix, cloud_from_model, row by row</source>
        <translation>Écrivez une matrice 4 x 4, cloud_from_model, ligne par ligne</translation>
    </message>
    <message>
        <source>Take out scale and mirroring</source>
        <translation>Retirez l’échelle et le miroir</translation>
    </message>
    <message>
        <source>Choose one of those that it tells</source>
        <translation>Choisissez l’une de celles qu’il indique</translation>
    </message>
    <message>
        <source>Choose up to 100 mm</source>
        <translation>Choisissez jusqu’à 100 mm</translation>
    </message>
    <message>
        <source>Choose up to 20 mm</source>
        <translation>Choisissez jusqu’à 20 mm</translation>
    </message>
    <message>
        <source>Choose up to 1</source>
        <translation>Choisissez jusqu’à 1</translation>
    </message>
    <message>
        <source>Choose 0.3 to 5 mm</source>
        <translation>Choisissez 0,3 à 5 mm</translation>
    </message>
    <message>
        <source>Write {&quot;liver&quot;: [[x, y, z], ...], ...}</source>
        <translation>Écrivez {&quot;liver&quot;: [[x, y, z], ...], ...}</translation>
    </message>
    <message>
        <source>Give the pictures of both cameras</source>
        <translation>Donnez les images des deux caméras</translation>
    </message>
    <message>
        <source>Give a picture of each camera</source>
        <translation>Donnez une image de chaque caméra</translation>
    </message>
    <message>
        <source>Calibrate with pictures of one size, that of the operation</source>
        <translation>Calibrez avec des images d’une seule taille, celle de l’opération</translation>
    </message>
    <message>
        <source>Count the corners where four squares meet, along each side</source>
        <translation>Comptez le long de chaque côté les coins où quatre cases se touchent</translation>
    </message>
    <message>
        <source>Check the board&apos;s size and dictionary, and take sharp pictures of it</source>
        <translation>Vérifiez la taille et le dictionnaire de la mire, et prenez-en des images nettes</translation>
    </message>
    <message>
        <source>Take sharp pictures of the whole board, with a white border around it</source>
        <translation>Prenez des images nettes de toute la mire, avec un bord blanc autour</translation>
    </message>
    <message>
        <source>Tilt the board by 20 to 40 degrees, each time another way</source>
        <translation>Inclinez la mire de 20 à 40 degrés, chaque fois autrement</translation>
    </message>
    <message>
        <source>Take more views, with the board at the edges of the picture, too</source>
        <translation>Prenez plus de vues, aussi avec la mire aux bords de l’image</translation>
    </message>
    <message>
        <source>Give the left camera&apos;s pictures as the left ones</source>
        <translation>Donnez les images de la caméra gauche comme images gauches</translation>
    </message>
    <message>
        <source>Measure the side of a square</source>
        <translation>Mesurez le côté d’une case</translation>
    </message>
    <message>
        <source>Name views as the report does</source>
        <translation>Nommez les vues comme le rapport</translation>
    </message>
    <message>
        <source>Keep %1 or more</source>
        <translation>Gardez-en %1 ou plus</translation>
    </message>
    <message>
        <source>Leave that pair out: it does not fit the others</source>
        <translation>Laissez cette paire de côté : elle ne va pas avec les autres</translation>
    </message>
    <message>
        <source>Write mm, cm or m: the unit of T</source>
        <translation>Écrivez mm, cm ou m : l’unité de T</translation>
    </message>
    <message>
        <source>Calibrate without the rational, thin-prism and tilted models</source>
        <translation>Calibrez sans les modèles rational, thin-prism et tilted</translation>
    </message>
    <message>
        <source>Leave one of them in the folder</source>
        <translation>Laissez l’un d’eux dans le dossier</translation>
    </message>
    <message>
        <source>Expected calib.left.intrinsic.txt (3x3), calib.left.distortion.txt (4 or 5 numbers), the same for right, and calib.l2r.txt (4x4)</source>
        <translation>Attendus : calib.left.intrinsic.txt (3x3), calib.left.distortion.txt (4 ou 5 nombres), de même pour right, et calib.l2r.txt (4x4)</translation>
    </message>
    <message>
        <source>Write &quot;left&quot; here, and &quot;right&quot; as the image of each region of the right one</source>
        <translation>Écrivez ici « left », et « right » comme image de chaque région de la droite</translation>
    </message>
    <message>
        <source>Check image_width and image_height: the calibration is of another image size</source>
        <translation>Vérifiez image_width et image_height : le calibrage est d’une autre taille d’image</translation>
    </message>
    <message>
        <source>Check the pattern</source>
        <translation>Vérifiez le motif</translation>
    </message>
    <message>
        <source>Free some space on the disk and record again</source>
        <translation>Libérez de l’espace sur le disque et enregistrez de nouveau</translation>
    </message>
    <message>
        <source>Put it beside the header and name it there without a folder</source>
        <translation>Placez-le à côté de l’en-tête et nommez-le là sans dossier</translation>
    </message>
    <message>
        <source>Export it as NIfTI-1</source>
        <translation>Exportez-le en NIfTI-1</translation>
    </message>
    <message>
        <source>Export it as one .nii or .nii.gz file</source>
        <translation>Exportez-le en un seul fichier .nii ou .nii.gz</translation>
    </message>
    <message>
        <source>Write one scalar array on the points</source>
        <translation>Écrivez un tableau de scalaires sur les points</translation>
    </message>
    <message>
        <source>Export the labels as .seg.nrrd instead</source>
        <translation>Exportez plutôt les étiquettes en .seg.nrrd</translation>
    </message>
    <message>
        <source>Segment the CT first</source>
        <translation>Segmentez d’abord le scanner</translation>
    </message>
    <message>
        <source>Write .nrrd instead</source>
        <translation>Écrivez plutôt .nrrd</translation>
    </message>
    <message>
        <source>Check its permissions, or copy it to a disk of this computer</source>
        <translation>Vérifiez ses droits, ou copiez-le sur un disque de cet ordinateur</translation>
    </message>
    <message>
        <source>Do not trust the file; export it again</source>
        <translation>Ne vous fiez pas au fichier ; exportez-le de nouveau</translation>
    </message>
    <message>
        <source>is larger than 100 MB, more than any list needs</source>
        <translation>dépasse 100 Mo, plus qu’il n’en faut à une liste</translation>
    </message>
    <message>
        <source>is larger than 4 GB</source>
        <translation>dépasse 4 Go</translation>
    </message>
    <message>
        <source>is larger than such a file can be</source>
        <translation>est plus gros qu’un tel fichier ne peut l’être</translation>
    </message>
    <message>
        <source>nests lists deeper than any that is read here</source>
        <translation>imbrique des listes plus profondément que toutes celles lues ici</translation>
    </message>
    <message>
        <source>has no voxel of %1 within 5 mm</source>
        <translation>n’a pas de voxel de %1 à moins de 5 mm</translation>
    </message>
    <message>
        <source>lies at the tree&apos;s root</source>
        <translation>est à la racine de l’arbre</translation>
    </message>
    <message>
        <source>lies outside the volume</source>
        <translation>est hors du volume</translation>
    </message>
    <message>
        <source>are not the one list of the file</source>
        <translation>ne sont pas l’unique liste du fichier</translation>
    </message>
    <message>
        <source>brick %1 is missing</source>
        <translation>le bloc %1 manque</translation>
    </message>
    <message>
        <source>belongs to labels of another size</source>
        <translation>appartient à des étiquettes d’une autre taille</translation>
    </message>
    <message>
        <source>counts more steps than there are</source>
        <translation>compte plus d’étapes qu’il n’y en a</translation>
    </message>
    <message>
        <source>do not lead to the case&apos;s labels</source>
        <translation>ne mènent pas aux étiquettes du cas</translation>
    </message>
    <message>
        <source>is not a JSON object</source>
        <translation>n’est pas un objet JSON</translation>
    </message>
    <message>
        <source>lies on %1, not on %2</source>
        <translation>est sur %1, pas sur %2</translation>
    </message>
    <message>
        <source>runs through several slices</source>
        <translation>traverse plusieurs coupes</translation>
    </message>
    <message>
        <source>%1 lies in air, fat or bone</source>
        <translation>%1 est dans l’air, la graisse ou l’os</translation>
    </message>
    <message>
        <source>%1 lies in %2, which may not become the vessel there</source>
        <translation>%1 est dans %2, qui ne peut pas y devenir le vaisseau</translation>
    </message>
    <message>
        <source>has no way from %1 to %2 through soft tissue that may become the vessel</source>
        <translation>n’a pas de chemin de %1 à %2 par des tissus mous qui peuvent devenir le vaisseau</translation>
    </message>
    <message>
        <source>is %1, which is no vessel</source>
        <translation>est %1, qui n’est pas un vaisseau</translation>
    </message>
    <message>
        <source>%1 lies outside the volume</source>
        <translation>%1 est hors du volume</translation>
    </message>
    <message>
        <source>%1 and %2 are one voxel</source>
        <translation>%1 et %2 sont un même voxel</translation>
    </message>
    <message>
        <source>is not followed</source>
        <translation>n’est pas suivi</translation>
    </message>
    <message>
        <source>lies on other voxels than the CT (origin, spacing, direction or size)</source>
        <translation>est sur d’autres voxels que le scanner (origine, pas, direction ou taille)</translation>
    </message>
    <message>
        <source>names nothing of the liver in any segment</source>
        <translation>ne nomme rien du foie dans aucun segment</translation>
    </message>
    <message>
        <source>is kept already</source>
        <translation>est déjà gardé</translation>
    </message>
    <message>
        <source>is one more than the %1 that can be kept</source>
        <translation>est un de plus que les %1 qui peuvent être gardés</translation>
    </message>
    <message>
        <source>has not been seen often enough yet</source>
        <translation>n’a pas encore été vu assez souvent</translation>
    </message>
    <message>
        <source>has fewer than 3 points</source>
        <translation>a moins de 3 points</translation>
    </message>
    <message>
        <source>has %1 points</source>
        <translation>a %1 points</translation>
    </message>
    <message>
        <source>is not proposed</source>
        <translation>n’est pas proposé</translation>
    </message>
    <message>
        <source>is none</source>
        <translation>n’en est pas un</translation>
    </message>
    <message>
        <source>is not known, nor where a vessel enters: nothing holds the organ</source>
        <translation>n’est pas connue, ni où un vaisseau entre : rien ne tient l’organe</translation>
    </message>
    <message>
        <source>and the places where vessels enter lie on one line, about which the organ would turn freely</source>
        <translation>et les endroits où entrent les vaisseaux sont sur une ligne, autour de laquelle l’organe tournerait librement</translation>
    </message>
    <message>
        <source>is no number</source>
        <translation>n’est pas un nombre</translation>
    </message>
    <message>
        <source>no pipe to a helper process can be made (%1)</source>
        <translation>aucun tube vers un processus auxiliaire ne peut être créé (%1)</translation>
    </message>
    <message>
        <source>no socket to a helper process can be made (%1)</source>
        <translation>aucune connexion vers un processus auxiliaire ne peut être créée (%1)</translation>
    </message>
    <message>
        <source>no socket can be made (%1)</source>
        <translation>aucune connexion ne peut être créée (%1)</translation>
    </message>
    <message>
        <source>no event can be made</source>
        <translation>aucun événement ne peut être créé</translation>
    </message>
    <message>
        <source>cannot be opened to flush (%1)</source>
        <translation>ne peut pas être ouvert pour être écrit sur le disque (%1)</translation>
    </message>
    <message>
        <source>was replaced while it was written</source>
        <translation>a été remplacé pendant son écriture</translation>
    </message>
    <message>
        <source>its permissions could not be kept (%1)</source>
        <translation>ses droits n’ont pas pu être gardés (%1)</translation>
    </message>
    <message>
        <source>could not be replaced (%1)</source>
        <translation>n’a pas pu être remplacé (%1)</translation>
    </message>
    <message>
        <source>no folder for recovery can be made here (%1)</source>
        <translation>aucun dossier de récupération ne peut être créé ici (%1)</translation>
    </message>
    <message>
        <source>its folder does not exist</source>
        <translation>son dossier n’existe pas</translation>
    </message>
    <message>
        <source>its folder cannot be written to</source>
        <translation>on ne peut pas écrire dans son dossier</translation>
    </message>
    <message>
        <source>is a file, a folder is needed here</source>
        <translation>est un fichier, il faut ici un dossier</translation>
    </message>
    <message>
        <source>leads to another disk</source>
        <translation>mène à un autre disque</translation>
    </message>
    <message>
        <source>Remove the link, or name a folder on that disk</source>
        <translation>Supprimez le lien, ou indiquez un dossier sur cet autre disque</translation>
    </message>
    <message>
        <source>could not be completed (%1)</source>
        <translation>n’a pas pu être achevé (%1)</translation>
    </message>
    <message>
        <source>could not be written (%1)</source>
        <translation>n’a pas pu être écrit (%1)</translation>
    </message>
    <message>
        <source>others have saved it meanwhile, so that it stays as they left it; this run&apos;s is %1</source>
        <translation>d’autres l’ont enregistré entre-temps, il reste comme ils l’ont laissé ; celui de cette exécution est %1</translation>
    </message>
    <message>
        <source>a volume reads back differently from what was written</source>
        <translation>un volume se relit autrement qu’il n’a été écrit</translation>
    </message>
    <message>
        <source>this file system has no locks, so that two programs may write one case</source>
        <translation>ce système de fichiers n’a pas de verrous : deux programmes pourraient écrire un même cas</translation>
    </message>
    <message>
        <source>is no option of &apos;glisson %1&apos;</source>
        <translation>n’est pas une option de « glisson %1 »</translation>
    </message>
    <message>
        <source>unknown option</source>
        <translation>option inconnue</translation>
    </message>
    <message>
        <source>is needed</source>
        <translation>est nécessaire</translation>
    </message>
    <message>
        <source>one of them is needed</source>
        <translation>l’un d’eux est nécessaire</translation>
    </message>
    <message>
        <source>one of --pairs, --left with --right, and --video is needed</source>
        <translation>il faut l’un de --pairs, --left avec --right et --video</translation>
    </message>
    <message>
        <source>must end in %1</source>
        <translation>doit se terminer par %1</translation>
    </message>
    <message>
        <source>must be a number from %1 to %2</source>
        <translation>doit être un nombre de %1 à %2</translation>
    </message>
    <message>
        <source>must be %1 numbers between commas, each from %2 to %3</source>
        <translation>doit être %1 nombres séparés par des virgules, chacun de %2 à %3</translation>
    </message>
    <message>
        <source>must be a whole number from 0</source>
        <translation>doit être un nombre entier à partir de 0</translation>
    </message>
    <message>
        <source>must be a whole number</source>
        <translation>doit être un nombre entier</translation>
    </message>
    <message>
        <source>must be two whole numbers, as in 14x10</source>
        <translation>doit être deux nombres entiers, comme 14x10</translation>
    </message>
    <message>
        <source>must be mm, cm or m</source>
        <translation>doit être mm, cm ou m</translation>
    </message>
    <message>
        <source>must be direct, fast or reference</source>
        <translation>doit être direct, fast ou reference</translation>
    </message>
    <message>
        <source>must be sparse, dense or auto</source>
        <translation>doit être sparse, dense ou auto</translation>
    </message>
    <message>
        <source>must be surf, sift or akaze</source>
        <translation>doit être surf, sift ou akaze</translation>
    </message>
    <message>
        <source>must be automatic, forces, springs or paper</source>
        <translation>doit être automatic, forces, springs ou paper</translation>
    </message>
    <message>
        <source>must be operations or none</source>
        <translation>doit être operations ou none</translation>
    </message>
    <message>
        <source>must hold a number such as %02d, as in &apos;cloud_%02d.ply&apos;</source>
        <translation>doit contenir un nombre comme %02d, comme dans &apos;cloud_%02d.ply&apos;</translation>
    </message>
    <message>
        <source>%1 arguments were given besides the options, %2 is needed</source>
        <translation>%1 arguments en dehors des options, il en faut %2</translation>
    </message>
    <message>
        <source>no file of this name exists</source>
        <translation>il n’y a pas de fichier de ce nom</translation>
    </message>
    <message>
        <source>needs a matrix</source>
        <translation>demande une matrice</translation>
    </message>
    <message>
        <source>needs pictures</source>
        <translation>demande des images</translation>
    </message>
    <message>
        <source>needs --igtl-send</source>
        <translation>demande --igtl-send</translation>
    </message>
    <message>
        <source>is no lesion</source>
        <translation>n’est pas une lésion</translation>
    </message>
    <message>
        <source>is no pixel</source>
        <translation>n’est pas un pixel</translation>
    </message>
    <message>
        <source>is none of the looks</source>
        <translation>n’est aucun des rendus</translation>
    </message>
    <message>
        <source>does not exist, and is no command</source>
        <translation>n’existe pas, et n’est pas une commande</translation>
    </message>
    <message>
        <source>the window opens one case</source>
        <translation>la fenêtre ouvre un seul cas</translation>
    </message>
    <message>
        <source>there is no display for the window, but commands work without one</source>
        <translation>il n’y a pas d’écran pour la fenêtre, mais les commandes s’en passent</translation>
    </message>
    <message>
        <source>is not in the video</source>
        <translation>n’est pas dans la vidéo</translation>
    </message>
    <message>
        <source>is not in the video, or was not tracked</source>
        <translation>n’est pas dans la vidéo, ou n’a pas été suivie</translation>
    </message>
    <message>
        <source>is not in the video, or lies before the registered frame</source>
        <translation>n’est pas dans la vidéo, ou est avant l’image recalée</translation>
    </message>
    <message>
        <source>is beside the organ</source>
        <translation>est à côté de l’organe</translation>
    </message>
    <message>
        <source>has no frame to be drawn</source>
        <translation>n’a pas d’image à dessiner</translation>
    </message>
    <message>
        <source>Click on the branch that is to change</source>
        <translation>Cliquez sur la branche à changer</translation>
    </message>
    <message>
        <source>Click farther out on the branch</source>
        <translation>Cliquez plus loin sur la branche</translation>
    </message>
    <message>
        <source>Click inside the picture</source>
        <translation>Cliquez dans l’image</translation>
    </message>
    <message>
        <source>Click inside the vessel</source>
        <translation>Cliquez dans le vaisseau</translation>
    </message>
    <message>
        <source>Click a part of %1</source>
        <translation>Cliquez sur une partie de %1</translation>
    </message>
    <message>
        <source>Click beside it, or change what may be edited</source>
        <translation>Cliquez à côté, ou changez ce qui peut être modifié</translation>
    </message>
    <message>
        <source>Click points between them, or change what may be edited</source>
        <translation>Cliquez des points entre eux, ou changez ce qui peut être modifié</translation>
    </message>
    <message>
        <source>Click two different places</source>
        <translation>Cliquez deux endroits différents</translation>
    </message>
    <message>
        <source>Choose the portal vein, the hepatic veins, the vena cava or the artery</source>
        <translation>Choisissez la veine porte, les veines hépatiques, la veine cave ou l’artère</translation>
    </message>
    <message>
        <source>Draw a disc in one slice, or use a ball</source>
        <translation>Dessinez un disque dans une coupe, ou utilisez une boule</translation>
    </message>
    <message>
        <source>Write {&quot;edits&quot;: [{&quot;tool&quot;: ...}, ...]}</source>
        <translation>Écrivez {&quot;edits&quot;: [{&quot;tool&quot;: ...}, ...]}</translation>
    </message>
    <message>
        <source>Write {&quot;tool&quot;: ..., ...}</source>
        <translation>Écrivez {&quot;tool&quot;: ..., ...}</translation>
    </message>
    <message>
        <source>Delete the folder &apos;history&apos; of the case: only the undo steps are lost</source>
        <translation>Supprimez le dossier « history » du cas : seules les étapes à annuler sont perdues</translation>
    </message>
    <message>
        <source>Remove it from the case</source>
        <translation>Retirez-le du cas</translation>
    </message>
    <message>
        <source>Start tracking first</source>
        <translation>Lancez d’abord le suivi</translation>
    </message>
    <message>
        <source>Resample the segmentation to the CT&apos;s grid, or open the CT that it was drawn on</source>
        <translation>Rééchantillonnez la segmentation sur la grille du scanner, ou ouvrez le scanner sur lequel elle a été dessinée</translation>
    </message>
    <message>
        <source>Say which segment means what with --codes FILE (see &apos;glisson model --help&apos;)</source>
        <translation>Dites avec --codes FICHIER quel segment signifie quoi (voir « glisson model --help »)</translation>
    </message>
    <message>
        <source>Look from elsewhere and reconstruct again</source>
        <translation>Regardez d’ailleurs et reconstruisez de nouveau</translation>
    </message>
    <message>
        <source>Forget the earlier looks, or register with these</source>
        <translation>Oubliez les vues précédentes, ou recalez avec celles-ci</translation>
    </message>
    <message>
        <source>Follow the organ in a stereo video for a second</source>
        <translation>Suivez l’organe dans une vidéo stéréo pendant une seconde</translation>
    </message>
    <message>
        <source>Give the points of the contact</source>
        <translation>Donnez les points du contact</translation>
    </message>
    <message>
        <source>Give as many as are proposed: %1</source>
        <translation>Donnez-en autant que proposé : %1</translation>
    </message>
    <message>
        <source>Let an atlas that knows it propose it first</source>
        <translation>Faites-le d’abord proposer par un atlas qui le connaît</translation>
    </message>
    <message>
        <source>Place notch, margin or vena cava in five cases at least, or build on another atlas</source>
        <translation>Placez l’échancrure, le bord ou la veine cave dans au moins cinq cas, ou construisez sur un autre atlas</translation>
    </message>
    <message>
        <source>Correct first</source>
        <translation>Corrigez d’abord</translation>
    </message>
    <message>
        <source>Place the vena cava among the landmarks</source>
        <translation>Placez la veine cave parmi les repères</translation>
    </message>
    <message>
        <source>Place three points or more of the vena cava among the landmarks, where it touches the liver</source>
        <translation>Placez trois points ou plus de la veine cave parmi les repères, là où elle touche le foie</translation>
    </message>
    <message>
        <source>Remove the file&apos;s entry from case.json and transfer the atlas again</source>
        <translation>Retirez l’entrée du fichier de case.json et transférez l’atlas de nouveau</translation>
    </message>
    <message>
        <source>Write it again</source>
        <translation>Écrivez-le de nouveau</translation>
    </message>
    <message>
        <source>Close other programs</source>
        <translation>Fermez d’autres programmes</translation>
    </message>
    <message>
        <source>Check permissions and free space</source>
        <translation>Vérifiez les droits et l’espace libre</translation>
    </message>
    <message>
        <source>Check the disk</source>
        <translation>Vérifiez le disque</translation>
    </message>
    <message>
        <source>Keep cases elsewhere</source>
        <translation>Gardez les cas ailleurs</translation>
    </message>
    <message>
        <source>Choose another folder</source>
        <translation>Choisissez un autre dossier</translation>
    </message>
    <message>
        <source>Compare the two</source>
        <translation>Comparez les deux</translation>
    </message>
    <message>
        <source>See &apos;glisson %1 --help&apos;</source>
        <translation>Voir « glisson %1 --help »</translation>
    </message>
    <message>
        <source>See &apos;glisson --help&apos;</source>
        <translation>Voir « glisson --help »</translation>
    </message>
    <message>
        <source>See --help</source>
        <translation>Voir --help</translation>
    </message>
    <message>
        <source>Check --%1</source>
        <translation>Vérifiez --%1</translation>
    </message>
    <message>
        <source>Check the pattern&apos;s folder and number</source>
        <translation>Vérifiez le dossier et le numéro du motif</translation>
    </message>
    <message>
        <source>Give its file by --rigid FILE</source>
        <translation>Donnez son fichier avec --rigid FICHIER</translation>
    </message>
    <message>
        <source>Give --video with --calibration</source>
        <translation>Donnez --video avec --calibration</translation>
    </message>
    <message>
        <source>Give lesion_1 and so on</source>
        <translation>Donnez lesion_1, etc.</translation>
    </message>
    <message>
        <source>Give two numbers, as 480,270</source>
        <translation>Donnez deux nombres, comme 480,270</translation>
    </message>
    <message>
        <source>Give frames from 0 to %1</source>
        <translation>Donnez des images de 0 à %1</translation>
    </message>
    <message>
        <source>Give a pixel of the drawn organ</source>
        <translation>Donnez un pixel de l’organe dessiné</translation>
    </message>
    <message>
        <source>Give one on it</source>
        <translation>Donnez-en un dessus</translation>
    </message>
    <message>
        <source>Choose a frame that was tracked</source>
        <translation>Choisissez une image qui a été suivie</translation>
    </message>
    <message>
        <source>Choose a frame between the registered one and the video&apos;s end</source>
        <translation>Choisissez une image entre celle recalée et la fin de la vidéo</translation>
    </message>
    <message>
        <source>Give a track of this video, or register a frame that is not its last</source>
        <translation>Donnez un suivi de cette vidéo, ou recalez une image qui n’est pas la dernière</translation>
    </message>
    <message>
        <source>Give Young&apos;s modulus in kPa, from %1 to %2, or %3</source>
        <translation>Donnez le module de Young en kPa, de %1 à %2, ou %3</translation>
    </message>
    <message>
        <source>Name lesion_1, lesion_2 and so on</source>
        <translation>Nommez lesion_1, lesion_2 et ainsi de suite</translation>
    </message>
    <message>
        <source>has no value</source>
        <translation>n&apos;a pas de valeur</translation>
    </message>
    <message>
        <source>Write NAME=KPA, as in lesion_1=20,lesions=12</source>
        <translation>Écrivez NOM=KPA, comme lesion_1=20,lesions=12</translation>
    </message>
    <message>
        <source>is given twice</source>
        <translation>est donné deux fois</translation>
    </message>
    <message>
        <source>Give it once</source>
        <translation>Donnez-le une fois</translation>
    </message>
    <message>
        <source>is no tissue of which stiffness can be said</source>
        <translation>n&apos;est pas un tissu dont on puisse dire la raideur</translation>
    </message>
    <message>
        <source>Name parenchyma, lesions, or lesion_1, lesion_2 and so on</source>
        <translation>Nommez parenchyma, lesions, ou lesion_1, lesion_2 et ainsi de suite</translation>
    </message>
    <message>
        <source>is no lesion of this model</source>
        <translation>n&apos;est pas une lésion de ce modèle</translation>
    </message>
    <message>
        <source>are none in this model</source>
        <translation>n&apos;existent pas dans ce modèle</translation>
    </message>
    <message>
        <source>is no deviation</source>
        <translation>n&apos;est pas un écart</translation>
    </message>
    <message>
        <source>Give millimetres from 0, or leave the field out</source>
        <translation>Donnez des millimètres à partir de 0, ou omettez le champ</translation>
    </message>
    <message>
        <source>are not as many as points</source>
        <translation>ne sont pas aussi nombreux que les points</translation>
    </message>
    <message>
        <source>Give one a point of the margin, or leave the field out</source>
        <translation>Donnez-en un par point du bord, ou omettez le champ</translation>
    </message>
    <message>
        <source>is not a place and a radius</source>
        <translation>n&apos;est pas un lieu et un rayon</translation>
    </message>
    <message>
        <source>holds a negative variance</source>
        <translation>contient une variance négative</translation>
    </message>
    <message>
        <source>is of another model, other landmarks, stiffness or points</source>
        <translation>est d&apos;un autre modèle, d&apos;autres repères, d&apos;une autre raideur ou d&apos;autres points</translation>
    </message>
    <message>
        <source>the parenchyma&apos;s is said twice</source>
        <translation>celle du parenchyme est dite deux fois</translation>
    </message>
    <message>
        <source>Leave it out, or --materials and --young</source>
        <translation>Omettez-la, ou --materials et --young</translation>
    </message>
    <message>
        <source>needs a folder</source>
        <translation>demande un dossier</translation>
    </message>
    <message>
        <source>Give --surfaces-out FOLDER</source>
        <translation>Donnez --surfaces-out DOSSIER</translation>
    </message>
    <message>
        <source>needs what was known</source>
        <translation>demande ce qui était connu</translation>
    </message>
    <message>
        <source>Give --track NAME.frames.jsonl</source>
        <translation>Donnez --track NAME.frames.jsonl</translation>
    </message>
    <message>
        <source>names what is no lesion</source>
        <translation>nomme ce qui n&apos;est pas une lésion</translation>
    </message>
    <message>
        <source>is not an object</source>
        <translation>n’est pas un objet</translation>
    </message>
    <message>
        <source>is not a list</source>
        <translation>n’est pas une liste</translation>
    </message>
    <message>
        <source>is no text</source>
        <translation>n’est pas un texte</translation>
    </message>
    <message>
        <source>is not of the right kind</source>
        <translation>n’est pas du bon genre</translation>
    </message>
    <message>
        <source>is unknown</source>
        <translation>est inconnu</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, which is unknown</source>
        <translation>est « %1 », qui est inconnu</translation>
    </message>
    <message>
        <source>is none that is known</source>
        <translation>n’est pas connu</translation>
    </message>
    <message>
        <source>is not that of an atlas</source>
        <translation>n’est pas celui d’un atlas</translation>
    </message>
    <message>
        <source>holds something else than texts</source>
        <translation>contient autre chose que des textes</translation>
    </message>
    <message>
        <source>holds something else than numbers</source>
        <translation>contient autre chose que des nombres</translation>
    </message>
    <message>
        <source>holds something else than numbers above 0</source>
        <translation>contient autre chose que des nombres supérieurs à 0</translation>
    </message>
    <message>
        <source>needs %1 rows</source>
        <translation>demande %1 lignes</translation>
    </message>
    <message>
        <source>needs %1 numbers a row</source>
        <translation>demande %1 nombres par ligne</translation>
    </message>
    <message>
        <source>needs six numbers a point</source>
        <translation>demande six nombres par point</translation>
    </message>
    <message>
        <source>needs one entry a member, three at least</source>
        <translation>demande une entrée par membre, trois au moins</translation>
    </message>
    <message>
        <source>is below 1</source>
        <translation>est inférieur à 1</translation>
    </message>
    <message>
        <source>are fewer than 3</source>
        <translation>sont moins de 3</translation>
    </message>
    <message>
        <source>holds no squares in its first three columns</source>
        <translation>ne contient pas de carrés dans ses trois premières colonnes</translation>
    </message>
    <message>
        <source>has no shape that could be kept</source>
        <translation>n&apos;a pas de forme à garder</translation>
    </message>
    <message>
        <source>Build on another atlas</source>
        <translation>Construire sur un autre atlas</translation>
    </message>
    <message>
        <source>are none</source>
        <translation>n’en sont pas</translation>
    </message>
    <message>
        <source>are not as many as covariances and sources</source>
        <translation>ne sont pas aussi nombreux que les covariances et les sources</translation>
    </message>
    <message>
        <source>are not as many as the structure has</source>
        <translation>ne sont pas aussi nombreux que ceux de la structure</translation>
    </message>
    <message>
        <source>holds a matrix that is no covariance</source>
        <translation>contient une matrice qui n’est pas une covariance</translation>
    </message>
    <message>
        <source>name a structure twice</source>
        <translation>nomment deux fois une structure</translation>
    </message>
    <message>
        <source>name a structure that is not there</source>
        <translation>nomment une structure qui n&apos;existe pas</translation>
    </message>
    <message>
        <source>is the structure itself</source>
        <translation>est la structure elle-même</translation>
    </message>
    <message>
        <source>is no point of that structure</source>
        <translation>n&apos;est pas un point de cette structure</translation>
    </message>
    <message>
        <source>needs nine numbers a point</source>
        <translation>exige neuf nombres par point</translation>
    </message>
    <message>
        <source>entry %1 holds something that is not a number</source>
        <translation>l’entrée %1 contient autre chose qu’un nombre</translation>
    </message>
    <message>
        <source>entry %1 is not a triple</source>
        <translation>l’entrée %1 n’a pas trois nombres</translation>
    </message>
    <message>
        <source>entry %1 is nowhere near a patient</source>
        <translation>l’entrée %1 est loin de tout patient</translation>
    </message>
    <message>
        <source>has an entry that is not of six numbers</source>
        <translation>a une entrée qui n’a pas six nombres</translation>
    </message>
    <message>
        <source>has an entry that is not a number</source>
        <translation>a une entrée qui n’est pas un nombre</translation>
    </message>
    <message>
        <source>holds %1 cells, not %2 x %3</source>
        <translation>contient %1 cellules, et non %2 x %3</translation>
    </message>
    <message>
        <source>is of %1 points, whole.ply holds %2</source>
        <translation>porte sur %1 points, whole.ply en contient %2</translation>
    </message>
    <message>
        <source>is %1, that of the case&apos;s pictures %2</source>
        <translation>est %1, celle des images du cas %2</translation>
    </message>
    <message>
        <source>says that they are of the case&apos;s pictures, there are none</source>
        <translation>dit qu’ils viennent des images du cas, mais il n’y en a pas</translation>
    </message>
    <message>
        <source>is not a key of a load file</source>
        <translation>n’est pas une clé d’un fichier de charges</translation>
    </message>
    <message>
        <source>is not three numbers</source>
        <translation>n’est pas trois nombres</translation>
    </message>
    <message>
        <source>is not three finite numbers</source>
        <translation>n’est pas trois nombres finis</translation>
    </message>
    <message>
        <source>is zero</source>
        <translation>est nul</translation>
    </message>
    <message>
        <source>is %1 Pa</source>
        <translation>vaut %1 Pa</translation>
    </message>
    <message>
        <source>holds %1, which is no index</source>
        <translation>contient %1, qui n’est pas un indice</translation>
    </message>
    <message>
        <source>holds no load</source>
        <translation>ne contient aucune charge</translation>
    </message>
    <message>
        <source>has no place</source>
        <translation>n’a pas de lieu</translation>
    </message>
    <message>
        <source>has several places</source>
        <translation>a plusieurs lieux</translation>
    </message>
    <message>
        <source>lies above high_mm</source>
        <translation>est au-dessus de high_mm</translation>
    </message>
    <message>
        <source>is above 180</source>
        <translation>dépasse 180</translation>
    </message>
    <message>
        <source>names no ball, box or direction</source>
        <translation>ne nomme ni boule, ni boîte, ni direction</translation>
    </message>
    <message>
        <source>names no nodes</source>
        <translation>ne nomme aucun nœud</translation>
    </message>
    <message>
        <source>stands beside a region</source>
        <translation>figure à côté d’une région</translation>
    </message>
    <message>
        <source>stands beside from or to</source>
        <translation>figure à côté de from ou de to</translation>
    </message>
    <message>
        <source>stands beside structure</source>
        <translation>figure à côté de structure</translation>
    </message>
    <message>
        <source>SCALARS have no LOOKUP_TABLE</source>
        <translation>SCALARS n’a pas de LOOKUP_TABLE</translation>
    </message>
    <message>
        <source>SCALARS have no number of components</source>
        <translation>SCALARS n’a pas de nombre de composantes</translation>
    </message>
    <message>
        <source>an array stands before POINT_DATA and CELL_DATA</source>
        <translation>un tableau précède POINT_DATA et CELL_DATA</translation>
    </message>
    <message>
        <source>announces %1 cells and holds %2</source>
        <translation>annonce %1 cellules et en contient %2</translation>
    </message>
    <message>
        <source>announces %1 items, more than the file holds</source>
        <translation>annonce %1 éléments, plus que le fichier n’en contient</translation>
    </message>
    <message>
        <source>announces more cells than the mesh of an organ needs</source>
        <translation>annonce plus de cellules que n’en demande le maillage d’un organe</translation>
    </message>
    <message>
        <source>announces more numbers than a mesh needs</source>
        <translation>annonce plus de nombres que n’en demande un maillage</translation>
    </message>
    <message>
        <source>announces more numbers than the file holds</source>
        <translation>annonce plus de nombres que le fichier n’en contient</translation>
    </message>
    <message>
        <source>announces more blocks than the file holds</source>
        <translation>annonce plus de blocs que le fichier n’en contient</translation>
    </message>
    <message>
        <source>announces a block larger than it can be</source>
        <translation>annonce un bloc plus grand que possible</translation>
    </message>
    <message>
        <source>has no points</source>
        <translation>n’a pas de points</translation>
    </message>
    <message>
        <source>cell %1 has no points</source>
        <translation>la cellule %1 n’a pas de points</translation>
    </message>
    <message>
        <source>cell %1 has a list longer than the section</source>
        <translation>la cellule %1 a une liste plus longue que la section</translation>
    </message>
    <message>
        <source>cell %1 has offsets out of range</source>
        <translation>la cellule %1 a des décalages hors limites</translation>
    </message>
    <message>
        <source>cells have no CONNECTIVITY</source>
        <translation>les cellules n’ont pas de CONNECTIVITY</translation>
    </message>
    <message>
        <source>cells have no OFFSETS</source>
        <translation>les cellules n’ont pas de OFFSETS</translation>
    </message>
    <message>
        <source>has %1 cells and %2 cell types</source>
        <translation>a %1 cellules et %2 types de cellules</translation>
    </message>
    <message>
        <source>has cells without CELL_TYPES</source>
        <translation>a des cellules sans CELL_TYPES</translation>
    </message>
    <message>
        <source>holds a %1, neither POLYDATA nor UNSTRUCTURED_GRID</source>
        <translation>contient %1, ni POLYDATA ni UNSTRUCTURED_GRID</translation>
    </message>
    <message>
        <source>holds an array of strings; remove it (&quot;%1&quot;)</source>
        <translation>contient un tableau de textes (« %1 ») ; retirez-le</translation>
    </message>
    <message>
        <source>is neither ASCII nor BINARY</source>
        <translation>n’est ni ASCII ni BINARY</translation>
    </message>
    <message>
        <source>the cells hold a number that is not whole or far too large</source>
        <translation>les cellules contiennent un nombre qui n’est pas entier ou est bien trop grand</translation>
    </message>
    <message>
        <source>unknown number type &quot;%1&quot;</source>
        <translation>type de nombre inconnu « %1 »</translation>
    </message>
    <message>
        <source>unknown section &quot;%1&quot;</source>
        <translation>section inconnue « %1 »</translation>
    </message>
    <message>
        <source>a tetrahedron names a node that is not there</source>
        <translation>un tétraèdre nomme un nœud qui n’existe pas</translation>
    </message>
    <message>
        <source>holds volume elements of gmsh type %1; save linear tetrahedra only</source>
        <translation>contient des éléments de volume de type gmsh %1 ; n’enregistrez que des tétraèdres linéaires</translation>
    </message>
    <message>
        <source>is a binary gmsh file; save it as ascii</source>
        <translation>est un fichier gmsh binaire ; enregistrez-le en texte (ascii)</translation>
    </message>
    <message>
        <source>is of gmsh format %1; save it in version 2 or 4</source>
        <translation>est au format gmsh %1 ; enregistrez-le en version 2 ou 4</translation>
    </message>
    <message>
        <source>a face has fewer than three vertices</source>
        <translation>une face a moins de trois sommets</translation>
    </message>
    <message>
        <source>a face names a vertex that is not there</source>
        <translation>une face nomme un sommet qui n’existe pas</translation>
    </message>
    <message>
        <source>a face names no vertex number</source>
        <translation>une face ne nomme pas de numéro de sommet</translation>
    </message>
    <message>
        <source>a vertex needs three numbers</source>
        <translation>un sommet demande trois nombres</translation>
    </message>
    <message>
        <source>the file ends inside a facet</source>
        <translation>le fichier finit dans une facette</translation>
    </message>
    <message>
        <source>the file ends inside binary data</source>
        <translation>le fichier finit dans des données binaires</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no entry of a PLY header</source>
        <translation>« %1 » n’est pas une entrée d’un en-tête PLY</translation>
    </message>
    <message>
        <source>a list&apos;s count has no integer type</source>
        <translation>le nombre d’une liste n’a pas de type entier</translation>
    </message>
    <message>
        <source>a property has no name</source>
        <translation>une propriété n’a pas de nom</translation>
    </message>
    <message>
        <source>a property stands before any element</source>
        <translation>une propriété précède tout élément</translation>
    </message>
    <message>
        <source>an element has no valid count</source>
        <translation>un élément n’a pas de nombre valable</translation>
    </message>
    <message>
        <source>element %1 comes a second time</source>
        <translation>l’élément %1 vient une deuxième fois</translation>
    </message>
    <message>
        <source>property %1 comes a second time</source>
        <translation>la propriété %1 vient une deuxième fois</translation>
    </message>
    <message>
        <source>no format was named</source>
        <translation>aucun format n’est nommé</translation>
    </message>
    <message>
        <source>the file ends before end_header</source>
        <translation>le fichier finit avant end_header</translation>
    </message>
    <message>
        <source>unknown format &quot;%1&quot;</source>
        <translation>format inconnu « %1 »</translation>
    </message>
    <message>
        <source>unknown property type &quot;%1&quot;</source>
        <translation>type de propriété inconnu « %1 »</translation>
    </message>
    <message>
        <source>expected a number, found %1</source>
        <translation>un nombre est attendu, trouvé : %1</translation>
    </message>
    <message>
        <source>expected a whole number, found %1</source>
        <translation>un nombre entier est attendu, trouvé : %1</translation>
    </message>
    <message>
        <source>an array is closed by another element</source>
        <translation>un tableau est fermé par un autre élément</translation>
    </message>
    <message>
        <source>closes %1, which is not open</source>
        <translation>ferme %1, qui n’est pas ouvert</translation>
    </message>
    <message>
        <source>elements lie in elements too deeply</source>
        <translation>des éléments sont imbriqués trop profondément</translation>
    </message>
    <message>
        <source>ends early, or is no base64</source>
        <translation>finit trop tôt, ou n’est pas du base64</translation>
    </message>
    <message>
        <source>ends inside a number</source>
        <translation>finit dans un nombre</translation>
    </message>
    <message>
        <source>ends inside an array</source>
        <translation>finit dans un tableau</translation>
    </message>
    <message>
        <source>ends inside %1</source>
        <translation>finit dans %1</translation>
    </message>
    <message>
        <source>has a type that is none</source>
        <translation>a un type qui n’existe pas</translation>
    </message>
    <message>
        <source>has an encoding that is none</source>
        <translation>a un codage qui n’existe pas</translation>
    </message>
    <message>
        <source>has no beginning or no end</source>
        <translation>n’a pas de début ou pas de fin</translation>
    </message>
    <message>
        <source>has no offset</source>
        <translation>n’a pas de décalage (offset)</translation>
    </message>
    <message>
        <source>has offsets out of range</source>
        <translation>a des décalages (offsets) hors limites</translation>
    </message>
    <message>
        <source>has the format &quot;%1&quot;, which is none</source>
        <translation>a le format « %1 », qui n’existe pas</translation>
    </message>
    <message>
        <source>has the type &quot;%1&quot;, which is no number&apos;s</source>
        <translation>a le type « %1 », qui n’est celui d’aucun nombre</translation>
    </message>
    <message>
        <source>have no connectivity, offsets or types</source>
        <translation>n’ont pas de connectivity, d’offsets ou de types</translation>
    </message>
    <message>
        <source>have not three coordinates each</source>
        <translation>n’ont pas trois coordonnées chacun</translation>
    </message>
    <message>
        <source>hold %1 offsets where %2 cells are announced</source>
        <translation>contiennent %1 décalages (offsets) alors que %2 cellules sont annoncées</translation>
    </message>
    <message>
        <source>holds %1 numbers or more where %2 are announced</source>
        <translation>contient %1 nombres ou plus alors que %2 sont annoncés</translation>
    </message>
    <message>
        <source>holds %1 numbers where %2 times %3 are announced</source>
        <translation>contient %1 nombres alors que %2 fois %3 sont annoncés</translation>
    </message>
    <message>
        <source>holds a number that is not whole, negative or far too large</source>
        <translation>contient un nombre qui n’est pas entier, est négatif ou bien trop grand</translation>
    </message>
    <message>
        <source>holds a packed block that is damaged</source>
        <translation>contient un bloc comprimé endommagé</translation>
    </message>
    <message>
        <source>holds more than a mesh does, with the arrays before it</source>
        <translation>contient, avec les tableaux précédents, plus qu’un maillage</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, neither UnstructuredGrid nor PolyData</source>
        <translation>est « %1 », ni UnstructuredGrid ni PolyData</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, which is no count</source>
        <translation>est « %1 », qui n’est pas un nombre d’éléments</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, which is not read</source>
        <translation>est « %1 », qui n’est pas lu</translation>
    </message>
    <message>
        <source>is missing: this is no VTK file</source>
        <translation>manque : ce n’est pas un fichier VTK</translation>
    </message>
    <message>
        <source>lies beyond the file&apos;s end</source>
        <translation>est au-delà de la fin du fichier</translation>
    </message>
    <message>
        <source>an instruction does not end</source>
        <translation>une instruction ne finit pas</translation>
    </message>
    <message>
        <source>a comment does not end</source>
        <translation>un commentaire ne finit pas</translation>
    </message>
    <message>
        <source>a tag does not end</source>
        <translation>une balise ne finit pas</translation>
    </message>
    <message>
        <source>a tag or an attribute has no name</source>
        <translation>une balise ou un attribut n’a pas de nom</translation>
    </message>
    <message>
        <source>an attribute has no value in quotation marks</source>
        <translation>un attribut n’a pas de valeur entre guillemets</translation>
    </message>
    <message>
        <source>an attribute holds an entity that is not known</source>
        <translation>un attribut contient une entité inconnue (&amp;...;)</translation>
    </message>
    <message>
        <source>an attribute&apos;s value does not end</source>
        <translation>la valeur d’un attribut ne finit pas</translation>
    </message>
    <message>
        <source>an attribute&apos;s value holds a tag</source>
        <translation>la valeur d’un attribut contient une balise</translation>
    </message>
    <message>
        <source>holds a document type or a section that is not read</source>
        <translation>contient un type de document ou une section qui n’est pas lue</translation>
    </message>
    <message>
        <source>the attribute %1 has no value</source>
        <translation>l’attribut %1 n’a pas de valeur</translation>
    </message>
    <message>
        <source>the attribute %1 stands twice</source>
        <translation>l’attribut %1 figure deux fois</translation>
    </message>
    <message>
        <source>holds more volume (%1 ml) than the liver in %2 (%3 ml)</source>
        <translation>a plus de volume (%1 ml) que le foie dans %2 (%3 ml)</translation>
    </message>
    <message>
        <source>holds no closed surface of 15 mm3 or more</source>
        <translation>ne contient aucune surface fermée de 15 mm3 ou plus</translation>
    </message>
    <message>
        <source>is %1 mm large, the liver %2 mm</source>
        <translation>mesure %1 mm, le foie %2 mm</translation>
    </message>
    <message>
        <source>is named twice</source>
        <translation>est nommé deux fois</translation>
    </message>
    <message>
        <source>is named twice: %1 and %2</source>
        <translation>est nommé deux fois : %1 et %2</translation>
    </message>
    <message>
        <source>is no structure that is known</source>
        <translation>n’est pas une structure connue</translation>
    </message>
    <message>
        <source>is none of mm, cm, m</source>
        <translation>n’est ni mm, ni cm, ni m</translation>
    </message>
    <message>
        <source>is RAS: x and y run the other way than in LPS</source>
        <translation>est RAS : x et y vont dans l’autre sens qu’en LPS</translation>
    </message>
    <message>
        <source>the liver lies to the left of the vena cava: mirrored, in RAS, or the liver&apos;s right part was removed</source>
        <translation>le foie est à gauche de la veine cave : inversé, en RAS, ou la partie droite du foie a été retirée</translation>
    </message>
    <message>
        <source>Export all surfaces of one patient in one frame (LPS); after a right hepatectomy import them with &apos;glisson model --left-liver&apos;</source>
        <translation>Exportez toutes les surfaces d’un patient dans un même repère (LPS) ; après une hépatectomie droite, importez avec &apos;glisson model --left-liver&apos;</translation>
    </message>
    <message>
        <source>lies elsewhere than the liver in %1</source>
        <translation>est ailleurs que le foie dans %1</translation>
    </message>
    <message>
        <source>names no file</source>
        <translation>ne nomme aucun fichier</translation>
    </message>
    <message>
        <source>the surface is open: it has holes, or edges with more than two triangles</source>
        <translation>la surface est ouverte : elle a des trous, ou des arêtes de plus de deux triangles</translation>
    </message>
    <message>
        <source>there is no surface of that name</source>
        <translation>il n’y a pas de surface de ce nom</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not three numbers</source>
        <translation>« %1 » n’est pas trois nombres</translation>
    </message>
    <message>
        <source>&quot;edit&quot; is none of set_root, prune, join</source>
        <translation>« edit » n’est ni set_root, ni prune, ni join</translation>
    </message>
    <message>
        <source>has no &quot;%1&quot;</source>
        <translation>n’a pas de « %1 »</translation>
    </message>
    <message>
        <source>is more than %1 million voxels and channels</source>
        <translation>fait plus de %1 millions de voxels et de canaux</translation>
    </message>
    <message>
        <source>is not two or three numbers</source>
        <translation>n’est pas deux ou trois nombres</translation>
    </message>
    <message>
        <source>names &quot;%1&quot;, which is no label</source>
        <translation>nomme « %1 », qui n’est pas une étiquette</translation>
    </message>
    <message>
        <source>holds what is no number from %1</source>
        <translation>contient ce qui n’est pas un nombre de %1</translation>
    </message>
    <message>
        <source>holds what is no text</source>
        <translation>contient ce qui n’est pas un texte</translation>
    </message>
    <message>
        <source>is no number from %1</source>
        <translation>n’est pas un nombre de %1</translation>
    </message>
    <message>
        <source>has not as many numbers as it has rows and columns</source>
        <translation>n’a pas autant de nombres que ses lignes et colonnes</translation>
    </message>
    <message>
        <source>is not a matrix of a calibration&apos;s size</source>
        <translation>n’est pas une matrice de la taille d’un calibrage</translation>
    </message>
    <message>
        <source>is not a matrix of numbers</source>
        <translation>n’est pas une matrice de nombres</translation>
    </message>
    <message>
        <source>has %1 vertices, which are no line</source>
        <translation>a %1 sommets, ce qui n’est pas une ligne</translation>
    </message>
    <message>
        <source>has %1 vertices, which enclose nothing</source>
        <translation>a %1 sommets, qui n’entourent rien</translation>
    </message>
    <message>
        <source>has a vertex that is not [x, y]</source>
        <translation>a un sommet qui n’est pas [x, y]</translation>
    </message>
    <message>
        <source>has a vertex that is not finite</source>
        <translation>a un sommet qui n’est pas fini</translation>
    </message>
    <message>
        <source>has a vertex that lies far outside any picture</source>
        <translation>a un sommet bien au-delà de toute image</translation>
    </message>
    <message>
        <source>has a width that is not a positive number of pixels</source>
        <translation>a une largeur qui n’est pas un nombre positif de pixels</translation>
    </message>
    <message>
        <source>has no label</source>
        <translation>n’a pas d’étiquette</translation>
    </message>
    <message>
        <source>has no polygon, and no curve that is a list</source>
        <translation>n’a ni polygone, ni courbe qui soit une liste</translation>
    </message>
    <message>
        <source>is not one that a frame has (16 hexadecimal digits)</source>
        <translation>n’est pas celle d’une image (16 chiffres hexadécimaux)</translation>
    </message>
    <message>
        <source>is on no picture of a stereo laparoscope</source>
        <translation>n’est sur aucune image d’un laparoscope stéréo</translation>
    </message>
    <message>
        <source>has a negative number</source>
        <translation>a un nombre négatif</translation>
    </message>
    <message>
        <source>holds what is no number of pixels</source>
        <translation>contient ce qui n’est pas un nombre de pixels</translation>
    </message>
    <message>
        <source>is neither true nor false</source>
        <translation>n’est ni true ni false</translation>
    </message>
    <message>
        <source>is neither True nor False</source>
        <translation>n’est ni True ni False</translation>
    </message>
    <message>
        <source>is no description of a source</source>
        <translation>n’est pas la description d’une source</translation>
    </message>
    <message>
        <source>is not [x, y, width, height]</source>
        <translation>n’est pas [x, y, largeur, hauteur]</translation>
    </message>
    <message>
        <source>is not that of a server, which sends both views</source>
        <translation>n’est pas celle d’un serveur, qui envoie les deux vues</translation>
    </message>
    <message>
        <source>is one file too many for this layout</source>
        <translation>est un fichier de trop pour cette disposition</translation>
    </message>
    <message>
        <source>Add it</source>
        <translation>Ajoutez-le</translation>
    </message>
    <message>
        <source>Write a number</source>
        <translation>Écrivez un nombre</translation>
    </message>
    <message>
        <source>Write a finite number</source>
        <translation>Écrivez un nombre fini</translation>
    </message>
    <message>
        <source>Write a list of numbers</source>
        <translation>Écrivez une liste de nombres</translation>
    </message>
    <message>
        <source>Write a list of texts in quotes</source>
        <translation>Écrivez une liste de textes entre guillemets</translation>
    </message>
    <message>
        <source>Write a text in quotes</source>
        <translation>Écrivez un texte entre guillemets</translation>
    </message>
    <message>
        <source>Write {&quot;channels&quot;: [...], ...}</source>
        <translation>Écrivez {&quot;channels&quot;: [...], ...}</translation>
    </message>
    <message>
        <source>Write [0, 1, ...]</source>
        <translation>Écrivez [0, 1, ...]</translation>
    </message>
    <message>
        <source>Write [x, y, z]</source>
        <translation>Écrivez [x, y, z]</translation>
    </message>
    <message>
        <source>Give millimetres, at most 10000</source>
        <translation>Donner des millimètres, 10000 au plus</translation>
    </message>
    <message>
        <source>is larger than a load can be</source>
        <translation>est plus grand qu&apos;une charge ne peut l&apos;être</translation>
    </message>
    <message>
        <source>Write [{...}, ...]</source>
        <translation>Écrivez [{...}, ...]</translation>
    </message>
    <message>
        <source>Write {...} there</source>
        <translation>Écrivez-y {...}</translation>
    </message>
    <message>
        <source>Give 0-based indices</source>
        <translation>Donnez des indices à partir de 0</translation>
    </message>
    <message>
        <source>Give 0-based node numbers</source>
        <translation>Donnez des numéros de nœuds à partir de 0</translation>
    </message>
    <message>
        <source>Give a direction</source>
        <translation>Donnez une direction</translation>
    </message>
    <message>
        <source>Give a node or a point, or leave the target out</source>
        <translation>Donnez un nœud ou un point, ou omettez la cible</translation>
    </message>
    <message>
        <source>Give a number above 0</source>
        <translation>Donnez un nombre supérieur à 0</translation>
    </message>
    <message>
        <source>Give at most 1e5 Pa (12 mmHg are 1600 Pa)</source>
        <translation>Donnez au plus 1e5 Pa (12 mmHg font 1600 Pa)</translation>
    </message>
    <message>
        <source>Give at most 10000 N</source>
        <translation>Donner au plus 10000 N</translation>
    </message>
    <message>
        <source>Give at most 100 m/s2</source>
        <translation>Donner au plus 100 m/s2</translation>
    </message>
    <message>
        <source>Give at most 1e9 N/m</source>
        <translation>Donner au plus 1e9 N/m</translation>
    </message>
    <message>
        <source>Give centre_mm and radius_mm, or low_mm and high_mm</source>
        <translation>Donnez centre_mm et radius_mm, ou low_mm et high_mm</translation>
    </message>
    <message>
        <source>Give change, or to (and from)</source>
        <translation>Donnez change, ou to (et from)</translation>
    </message>
    <message>
        <source>Give gravity, pressure, forces, springs or moved</source>
        <translation>Donnez gravity, pressure, forces, springs ou moved</translation>
    </message>
    <message>
        <source>Give newton_per_metre or structure</source>
        <translation>Donnez newton_per_metre ou structure</translation>
    </message>
    <message>
        <source>Give nodes or a region</source>
        <translation>Donnez des nœuds ou une région</translation>
    </message>
    <message>
        <source>Give one of node, point_mm, region</source>
        <translation>Donnez l’un de node, point_mm, region</translation>
    </message>
    <message>
        <source>Give one or the other</source>
        <translation>Donnez l’un ou l’autre</translation>
    </message>
    <message>
        <source>Give seconds, 0 or more</source>
        <translation>Donnez des secondes, 0 ou plus</translation>
    </message>
    <message>
        <source>Give seconds, at most 3600</source>
        <translation>Donner des secondes, 3600 au plus</translation>
    </message>
    <message>
        <source>Leave it out to press everywhere</source>
        <translation>Omettez-le pour appuyer partout</translation>
    </message>
    <message>
        <source>Swap the coordinates</source>
        <translation>Échangez les coordonnées</translation>
    </message>
    <message>
        <source>Give at most 180 degrees: every direction</source>
        <translation>Donnez au plus 180 degrés : toutes les directions</translation>
    </message>
    <message>
        <source>Save it packed by ZLib, or plain</source>
        <translation>Enregistrez-le comprimé par ZLib, ou non comprimé</translation>
    </message>
    <message>
        <source>Close it (fill its holes) in the program that made it</source>
        <translation>Fermez-la (bouchez ses trous) dans le programme qui l’a faite</translation>
    </message>
    <message>
        <source>Close the surfaces (fill their holes) in the program that made them</source>
        <translation>Fermez les surfaces (bouchez leurs trous) dans le programme qui les a faites</translation>
    </message>
    <message>
        <source>Export all surfaces of one patient in one frame (LPS)</source>
        <translation>Exportez toutes les surfaces d’un patient dans un même repère (LPS)</translation>
    </message>
    <message>
        <source>Give this file&apos;s own unit in the list of surfaces, or export it in the liver&apos;s</source>
        <translation>Donnez l’unité de ce fichier dans la liste des surfaces, ou exportez-le dans celle du foie</translation>
    </message>
    <message>
        <source>Keep one of them</source>
        <translation>Gardez l’un d’eux</translation>
    </message>
    <message>
        <source>Name the liver&apos;s surface liver.vtk, .vtp, .stl, .obj or .ply</source>
        <translation>Nommez la surface du foie liver.vtk, .vtp, .stl, .obj ou .ply</translation>
    </message>
    <message>
        <source>The two are probably swapped: name each file by what it shows</source>
        <translation>Les deux sont sans doute échangés : nommez chaque fichier d’après ce qu’il montre</translation>
    </message>
    <message>
        <source>Write [rows, columns] or [slices, rows, columns]</source>
        <translation>Écrivez [lignes, colonnes] ou [coupes, lignes, colonnes]</translation>
    </message>
    <message>
        <source>Write [rows, columns] or [slices, rows, columns], in millimetres</source>
        <translation>Écrivez [lignes, colonnes] ou [coupes, lignes, colonnes], en millimètres</translation>
    </message>
    <message>
        <source>Use smaller tiles</source>
        <translation>Prenez des tuiles plus petites</translation>
    </message>
    <message>
        <source>Give mean_hu and sd_hu, or neither</source>
        <translation>Donnez mean_hu et sd_hu, ou aucun des deux</translation>
    </message>
    <message>
        <source>Say where slices, rows and columns run to, one each of R or L, A or P, I or S, as &quot;SPL&quot;</source>
        <translation>Dites vers où vont les coupes, les lignes et les colonnes, chacune R ou L, A ou P, I ou S, comme &quot;SPL&quot;</translation>
    </message>
    <message>
        <source>Use background, parenchyma, portal_vein, hepatic_veins, vena_cava, artery, gallbladder or lesions</source>
        <translation>Utilisez background, parenchyma, portal_vein, hepatic_veins, vena_cava, artery, gallbladder ou lesions</translation>
    </message>
    <message>
        <source>Write one name for each output channel, as [&quot;background&quot;, &quot;parenchyma&quot;]</source>
        <translation>Écrivez un nom par canal de sortie, comme [&quot;background&quot;, &quot;parenchyma&quot;]</translation>
    </message>
    <message>
        <source>Write the Hounsfield units that the network was trained on, as [-160, 240]</source>
        <translation>Écrivez les unités Hounsfield avec lesquelles le réseau a été entraîné, comme [-160, 240]</translation>
    </message>
    <message>
        <source>Click three or more</source>
        <translation>Cliquez-en trois ou plus</translation>
    </message>
    <message>
        <source>Click two or more</source>
        <translation>Cliquez-en deux ou plus</translation>
    </message>
    <message>
        <source>Expected {&quot;image&quot;: &quot;left&quot;, &quot;frame&quot;: 0, &quot;regions&quot;: [{&quot;label&quot;: &quot;surface&quot;, &quot;polygon&quot;: [[x, y], ...]}]}</source>
        <translation>Attendu : {&quot;image&quot;: &quot;left&quot;, &quot;frame&quot;: 0, &quot;regions&quot;: [{&quot;label&quot;: &quot;surface&quot;, &quot;polygon&quot;: [[x, y], ...]}]}</translation>
    </message>
    <message>
        <source>Labels are surface, anterior_margin and umbilical_notch</source>
        <translation>Les étiquettes sont surface, anterior_margin et umbilical_notch</translation>
    </message>
    <message>
        <source>Take it out, or click the regions again</source>
        <translation>Retirez-le, ou cliquez de nouveau les régions</translation>
    </message>
    <message>
        <source>Write &quot;left&quot; or &quot;right&quot; as its image</source>
        <translation>Écrivez &quot;left&quot; ou &quot;right&quot; comme son image</translation>
    </message>
    <message>
        <source>Expected {&quot;left&quot;: &quot;scope.mkv&quot;, &quot;layout&quot;: &quot;side_by_side&quot; or &quot;top_bottom&quot; or &quot;row_interleaved&quot; or &quot;separate&quot;, ...}</source>
        <translation>Attendu : {&quot;left&quot;: &quot;scope.mkv&quot;, &quot;layout&quot;: &quot;side_by_side&quot; ou &quot;top_bottom&quot; ou &quot;row_interleaved&quot; ou &quot;separate&quot;, ...}</translation>
    </message>
    <message>
        <source>Name a video, a folder of pictures or a device</source>
        <translation>Nommez une vidéo, un dossier d’images ou un appareil</translation>
    </message>
    <message>
        <source>Name both devices in one source, as igtl:127.0.0.1:18944/LEFT,RIGHT, without a layout</source>
        <translation>Nommez les deux appareils dans une source, comme igtl:127.0.0.1:18944/LEFT,RIGHT, sans disposition</translation>
    </message>
    <message>
        <source>Separate views have a left and a right source, others one</source>
        <translation>Des vues séparées ont une source gauche et une droite, les autres une seule</translation>
    </message>
    <message>
        <source>holds no slice</source>
        <translation>ne contient aucune coupe</translation>
    </message>
    <message>
        <source>are shifted against each other across their normal</source>
        <translation>sont décalées l’une par rapport à l’autre en travers de leur normale</translation>
    </message>
    <message>
        <source>of one segment lie twice in one slice</source>
        <translation>d’un segment se trouvent deux fois dans une coupe</translation>
    </message>
    <message>
        <source>claims more pixels than a segmentation can mean</source>
        <translation>annonce plus de pixels que n’en peut avoir une segmentation</translation>
    </message>
    <message>
        <source>differ in orientation or pixel spacing</source>
        <translation>diffèrent par l’orientation ou la taille de pixel</translation>
    </message>
    <message>
        <source>do not lie at equal steps along their normal</source>
        <translation>ne sont pas à pas égal le long de leur normale</translation>
    </message>
    <message>
        <source>does not hold one item a frame</source>
        <translation>ne contient pas un élément par image</translation>
    </message>
    <message>
        <source>ends early: the file was cut</source>
        <translation>finit trop tôt : le fichier a été tronqué</translation>
    </message>
    <message>
        <source>holds %1 bytes where %2 are expected: the file is damaged</source>
        <translation>contient %1 octets au lieu de %2 : le fichier est endommagé</translation>
    </message>
    <message>
        <source>holds more segments than it can</source>
        <translation>contient plus de segments que possible</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, of which the border is not known</source>
        <translation>est « %1 », dont le bord n’est pas connu</translation>
    </message>
    <message>
        <source>is %1 twice</source>
        <translation>vaut deux fois %1</translation>
    </message>
    <message>
        <source>is %1, which is no segment of the file</source>
        <translation>est %1, qui n’est pas un segment du fichier</translation>
    </message>
    <message>
        <source>is %1, which no segmentation of bits has</source>
        <translation>est %1, ce qu’aucune segmentation en bits n’a</translation>
    </message>
    <message>
        <source>is missing in a file of one slice</source>
        <translation>manque dans un fichier d’une seule coupe</translation>
    </message>
    <message>
        <source>is missing in a frame</source>
        <translation>manque dans une image</translation>
    </message>
    <message>
        <source>is missing in a frame, so that its place in the patient is unknown</source>
        <translation>manque dans une image : sa place dans le patient est inconnue</translation>
    </message>
    <message>
        <source>is missing or no number</source>
        <translation>manque ou n’est pas un nombre</translation>
    </message>
    <message>
        <source>says that it is a label map segmentation, which is not read</source>
        <translation>dit que c’est une segmentation en carte d’étiquettes, qui n’est pas lue</translation>
    </message>
    <message>
        <source>says that it is no segmentation but another DICOM object</source>
        <translation>dit que ce n’est pas une segmentation mais un autre objet DICOM</translation>
    </message>
    <message>
        <source>says that the bits are compressed or swapped</source>
        <translation>dit que les bits sont comprimés ou inversés</translation>
    </message>
    <message>
        <source>claims more than 8192 pixels a side, which no scanner&apos;s slices have</source>
        <translation>annonce plus de 8192 pixels par côté, ce qu’aucune coupe de scanner n’a</translation>
    </message>
    <message>
        <source>holds no series %1, but %2</source>
        <translation>ne contient pas de série %1, mais %2</translation>
    </message>
    <message>
        <source>holds several series %1, but %2</source>
        <translation>contient plusieurs séries %1, à savoir %2</translation>
    </message>
    <message>
        <source>names another patient (0010|0010, 0010|0020, 0010|0030) than %1</source>
        <translation>nomme un autre patient (0010|0010, 0010|0020, 0010|0030) que %1</translation>
    </message>
    <message>
        <source>has rows that are not of length 1</source>
        <translation>a des lignes dont la longueur n’est pas 1</translation>
    </message>
    <message>
        <source>is %1, beyond what the file holds</source>
        <translation>vaut %1, au-delà de ce que contient le fichier</translation>
    </message>
    <message>
        <source>is False: voxels as text are not read</source>
        <translation>vaut False : les voxels en texte ne sont pas lus</translation>
    </message>
    <message>
        <source>is not 0</source>
        <translation>n’est pas 0</translation>
    </message>
    <message>
        <source>is not 1</source>
        <translation>n’est pas 1</translation>
    </message>
    <message>
        <source>names no single file of voxels</source>
        <translation>ne nomme pas un seul fichier de voxels</translation>
    </message>
    <message>
        <source>are no scale of intensities</source>
        <translation>ne sont pas une échelle d’intensités</translation>
    </message>
    <message>
        <source>has an origin that is not finite</source>
        <translation>a une origine qui n’est pas finie</translation>
    </message>
    <message>
        <source>is %1 where the datatype says %2</source>
        <translation>est %1 alors que datatype dit %2</translation>
    </message>
    <message>
        <source>is %1, which is no number of voxels</source>
        <translation>est %1, qui n’est pas un nombre de voxels</translation>
    </message>
    <message>
        <source>is neither 1 nor -1</source>
        <translation>n’est ni 1 ni -1</translation>
    </message>
    <message>
        <source>is no place in the file behind its header</source>
        <translation>n’est pas une place du fichier après son en-tête</translation>
    </message>
    <message>
        <source>is no rotation: b, c and d are longer than 1 together</source>
        <translation>n’est pas une rotation : b, c et d font ensemble plus de 1</translation>
    </message>
    <message>
        <source>is no unit of length</source>
        <translation>n’est pas une unité de longueur</translation>
    </message>
    <message>
        <source>says %1 mm from voxel to voxel, and the sform %2</source>
        <translation>dit %1 mm d’un voxel à l’autre, et la sform %2</translation>
    </message>
    <message>
        <source>says metres</source>
        <translation>dit mètres</translation>
    </message>
    <message>
        <source>says micrometres</source>
        <translation>dit micromètres</translation>
    </message>
    <message>
        <source>are &quot;%1&quot;</source>
        <translation>sont « %1 »</translation>
    </message>
    <message>
        <source>are fewer than there are axes</source>
        <translation>sont moins nombreux que les axes</translation>
    </message>
    <message>
        <source>are of fewer than three axes in space</source>
        <translation>ont moins de trois axes dans l’espace</translation>
    </message>
    <message>
        <source>are of more than three axes in space</source>
        <translation>ont plus de trois axes dans l’espace</translation>
    </message>
    <message>
        <source>hold a bracket that is not closed</source>
        <translation>contiennent une parenthèse qui n’est pas fermée</translation>
    </message>
    <message>
        <source>holds &quot;%1&quot;, which is no vector</source>
        <translation>contient « %1 », qui n’est pas un vecteur</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, which is no patient&apos;s</source>
        <translation>est « %1 », qui n’est d’aucun patient</translation>
    </message>
    <message>
        <source>is missing: the file does not say which way the patient lies</source>
        <translation>manque : le fichier ne dit pas dans quel sens est le patient</translation>
    </message>
    <message>
        <source>is more than 16</source>
        <translation>est supérieur à 16</translation>
    </message>
    <message>
        <source>is not read here</source>
        <translation>n’est pas lu ici</translation>
    </message>
    <message>
        <source>are %1 mm apart between %2 and %3 and %4 mm elsewhere: a slice is missing or the spacing changes</source>
        <translation>sont distantes de %1 mm entre %2 et %3, et de %4 mm ailleurs : une coupe manque ou le pas change</translation>
    </message>
    <message>
        <source>are shifted against each other by %1 mm from the first to the last (gantry tilt of %2 degrees)</source>
        <translation>sont décalées de %1 mm de la première à la dernière (inclinaison du statif : %2 degrés)</translation>
    </message>
    <message>
        <source>Choose another series</source>
        <translation>Choisissez une autre série</translation>
    </message>
    <message>
        <source>Export it as a binary DICOM segmentation</source>
        <translation>Exportez-le comme segmentation DICOM binaire</translation>
    </message>
    <message>
        <source>Export it without compression (Explicit VR Little Endian)</source>
        <translation>Exportez-le sans compression (Explicit VR Little Endian)</translation>
    </message>
    <message>
        <source>Export the segmentation again</source>
        <translation>Exportez la segmentation de nouveau</translation>
    </message>
    <message>
        <source>Name a DICOM segmentation</source>
        <translation>Nommez une segmentation DICOM</translation>
    </message>
    <message>
        <source>Name a DICOM segmentation (modality SEG); of a CT open the folder of its slices</source>
        <translation>Nommez une segmentation DICOM (modalité SEG) ; pour un scanner, ouvrez le dossier de ses coupes</translation>
    </message>
    <message>
        <source>Resample the segmentation to the CT&apos;s grid</source>
        <translation>Rééchantillonnez la segmentation sur la grille du scanner</translation>
    </message>
    <message>
        <source>Export the series again, of one patient</source>
        <translation>Exportez la série de nouveau, d’un seul patient</translation>
    </message>
    <message>
        <source>Export the volume again, as one .mha file</source>
        <translation>Exportez le volume de nouveau, en un seul fichier .mha</translation>
    </message>
    <message>
        <source>Apply it to the voxels</source>
        <translation>Appliquez-le aux voxels</translation>
    </message>
    <message>
        <source>Correct it to 0</source>
        <translation>Corrigez-le à 0</translation>
    </message>
    <message>
        <source>Write it with BinaryData = True</source>
        <translation>Écrivez-le avec BinaryData = True</translation>
    </message>
    <message>
        <source>Set them to 1 and 0</source>
        <translation>Mettez-les à 1 et 0</translation>
    </message>
    <message>
        <source>Write it as left-posterior-superior with space directions in mm</source>
        <translation>Écrivez-le en left-posterior-superior avec des space directions en mm</translation>
    </message>
    <message>
        <source>Write it with the encoding gzip or raw</source>
        <translation>Écrivez-le avec le codage gzip ou raw</translation>
    </message>
    <message>
        <source>Write the data without bytes before them</source>
        <translation>Écrivez les données sans octets avant elles</translation>
    </message>
    <message>
        <source>Write the data without lines before them</source>
        <translation>Écrivez les données sans lignes avant elles</translation>
    </message>
    <message>
        <source>is not %1 x %2</source>
        <translation>n’est pas %1 x %2</translation>
    </message>
    <message>
        <source>is %1, which is no number</source>
        <translation>est %1, qui n’est pas un nombre</translation>
    </message>
    <message>
        <source>is %1, which is no small whole number</source>
        <translation>est %1, qui n’est pas un petit nombre entier</translation>
    </message>
    <message>
        <source>is %1, which is no structure</source>
        <translation>est %1, qui n’est pas une structure</translation>
    </message>
    <message>
        <source>is %1, which is no text</source>
        <translation>est %1, qui n’est pas un texte</translation>
    </message>
    <message>
        <source>is no field that is known here</source>
        <translation>n’est pas un champ connu ici</translation>
    </message>
    <message>
        <source>is not made of %1 numbers each</source>
        <translation>n’est pas fait de %1 nombres chacun</translation>
    </message>
    <message>
        <source>has a point that is nowhere near a patient</source>
        <translation>a un point loin de tout patient</translation>
    </message>
    <message>
        <source>is %1, which is locked</source>
        <translation>est %1, qui est verrouillé</translation>
    </message>
    <message>
        <source>is the background</source>
        <translation>est le fond</translation>
    </message>
    <message>
        <source>runs from %1 to %2</source>
        <translation>va de %1 à %2</translation>
    </message>
    <message>
        <source>are fewer than two with the rivals</source>
        <translation>sont moins de deux avec les rivaux</translation>
    </message>
    <message>
        <source>are none that may keep what they win</source>
        <translation>n’ont pas le droit de garder ce qu’elles gagnent</translation>
    </message>
    <message>
        <source>name %1, which is no structure</source>
        <translation>nomment %1, qui n’est pas une structure</translation>
    </message>
    <message>
        <source>is the label that the branch has</source>
        <translation>est l’étiquette qu’a déjà la branche</translation>
    </message>
    <message>
        <source>has fewer than three points</source>
        <translation>a moins de trois points</translation>
    </message>
    <message>
        <source>has fewer than two points</source>
        <translation>a moins de deux points</translation>
    </message>
    <message>
        <source>has a normal that is not of length 1</source>
        <translation>a une normale dont la longueur n’est pas 1</translation>
    </message>
    <message>
        <source>has a place that is not finite</source>
        <translation>a une place qui n’est pas finie</translation>
    </message>
    <message>
        <source>has an offset that is not finite</source>
        <translation>a un décalage qui n’est pas fini</translation>
    </message>
    <message>
        <source>is %1 thick</source>
        <translation>a une épaisseur de %1</translation>
    </message>
    <message>
        <source>shows no view of space</source>
        <translation>ne montre pas une vue de l’espace</translation>
    </message>
    <message>
        <source>is %1 with a high of %2</source>
        <translation>vaut %1 pour une limite haute de %2</translation>
    </message>
    <message>
        <source>has the same place twice (%1 and %2)</source>
        <translation>a deux fois le même endroit (%1 et %2)</translation>
    </message>
    <message>
        <source>is below 0.5 mm</source>
        <translation>est inférieur à 0,5 mm</translation>
    </message>
    <message>
        <source>leaves %1 between %2 and %3, more than 100 mm</source>
        <translation>laisse %1 entre %2 et %3, plus de 100 mm</translation>
    </message>
    <message>
        <source>both places lie on one tree: a join would close a loop</source>
        <translation>les deux endroits sont sur un même arbre : une jonction fermerait une boucle</translation>
    </message>
    <message>
        <source>lies %1 mm from the nearest vessel</source>
        <translation>est à %1 mm du vaisseau le plus proche</translation>
    </message>
    <message>
        <source>one place lies on the %1, the other on the %2</source>
        <translation>un endroit est sur %1, l’autre sur %2</translation>
    </message>
    <message>
        <source>the places lie %1 mm apart</source>
        <translation>les endroits sont à %1 mm l’un de l’autre</translation>
    </message>
    <message>
        <source>there is no vessel tree</source>
        <translation>il n’y a pas d’arbre vasculaire</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not known</source>
        <translation>« %1 » n’est pas connu</translation>
    </message>
    <message>
        <source>%1 has %2 markers, too few for this board</source>
        <translation>%1 a %2 marqueurs, trop peu pour cette mire</translation>
    </message>
    <message>
        <source>is %1 mm</source>
        <translation>vaut %1 mm</translation>
    </message>
    <message>
        <source>matches itself but not the calibration (its points lie %1 pixels from their epipolar lines, %2 % of them before the cameras): the calibration is of another laparoscope, or of another zoom or focus</source>
        <translation>correspond à elle-même mais pas au calibrage (ses points sont à %1 pixels de leurs lignes épipolaires, %2 % d’entre eux devant les caméras) : le calibrage est d’un autre laparoscope, ou d’un autre zoom ou d’une autre mise au point</translation>
    </message>
    <message>
        <source>Give at least one</source>
        <translation>Donnez-en au moins un</translation>
    </message>
    <message>
        <source>Write three lists of four numbers</source>
        <translation>Écrivez trois listes de quatre nombres</translation>
    </message>
    <message>
        <source>Remove it, or correct its name</source>
        <translation>Retirez-le, ou corrigez son nom</translation>
    </message>
    <message>
        <source>Use background, parenchyma, portal_vein, hepatic_veins, vena_cava, artery, gallbladder, lesion_1, other_1 and so on</source>
        <translation>Utilisez background, parenchyma, portal_vein, hepatic_veins, vena_cava, artery, gallbladder, lesion_1, other_1, etc.</translation>
    </message>
    <message>
        <source>Write a name in quotes</source>
        <translation>Écrivez un nom entre guillemets</translation>
    </message>
    <message>
        <source>Write a whole number</source>
        <translation>Écrivez un nombre entier</translation>
    </message>
    <message>
        <source>Write it in square brackets</source>
        <translation>Écrivez-le entre crochets</translation>
    </message>
    <message>
        <source>Write lists of numbers</source>
        <translation>Écrivez des listes de nombres</translation>
    </message>
    <message>
        <source>Write true or false</source>
        <translation>Écrivez true ou false</translation>
    </message>
    <message>
        <source>Choose 0, 1 or 2: the voxel axis across the slice</source>
        <translation>Choisissez 0, 1 ou 2 : l’axe des voxels en travers de la coupe</translation>
    </message>
    <message>
        <source>Choose 1 to %1</source>
        <translation>Choisissez 1 à %1</translation>
    </message>
    <message>
        <source>Choose 1 and more: over what is usual</source>
        <translation>Choisissez 1 ou plus : au-delà de l’usuel</translation>
    </message>
    <message>
        <source>Choose a low that is not above the high</source>
        <translation>Choisissez une limite basse qui ne dépasse pas la haute</translation>
    </message>
    <message>
        <source>Choose a structure</source>
        <translation>Choisissez une structure</translation>
    </message>
    <message>
        <source>Choose more than 0 and at most %1</source>
        <translation>Choisissez plus de 0 et au plus %1</translation>
    </message>
    <message>
        <source>Give points of the CT&apos;s frame</source>
        <translation>Donnez des points du repère du scanner</translation>
    </message>
    <message>
        <source>Unlock it, or choose another one</source>
        <translation>Déverrouillez-le, ou choisissez-en un autre</translation>
    </message>
    <message>
        <source>Choose labels that compete</source>
        <translation>Choisissez des étiquettes qui rivalisent</translation>
    </message>
    <message>
        <source>Choose one or more to grow</source>
        <translation>Choisissez-en une ou plus à faire croître</translation>
    </message>
    <message>
        <source>Choose structures that have voxels</source>
        <translation>Choisissez des structures qui ont des voxels</translation>
    </message>
    <message>
        <source>Choose at least a slice&apos;s thickness</source>
        <translation>Choisissez au moins l’épaisseur d’une coupe</translation>
    </message>
    <message>
        <source>Draw around an area</source>
        <translation>Tracez autour d’une zone</translation>
    </message>
    <message>
        <source>Draw it in the view</source>
        <translation>Dessinez-le dans la vue</translation>
    </message>
    <message>
        <source>Give metres</source>
        <translation>Donnez des mètres</translation>
    </message>
    <message>
        <source>Give the 3 x 4 matrix of the view</source>
        <translation>Donnez la matrice 3 x 4 de la vue</translation>
    </message>
    <message>
        <source>Normalise it</source>
        <translation>Normalisez-la</translation>
    </message>
    <message>
        <source>Choose 0.5 to 8 mm</source>
        <translation>Choisissez 0,5 à 8 mm</translation>
    </message>
    <message>
        <source>Click points between them</source>
        <translation>Cliquez des points entre eux</translation>
    </message>
    <message>
        <source>Give the two ends of the gap</source>
        <translation>Donnez les deux bouts de la lacune</translation>
    </message>
    <message>
        <source>Join trees of one kind</source>
        <translation>Joignez des arbres d’un même genre</translation>
    </message>
    <message>
        <source>Point at a vessel of the model</source>
        <translation>Désignez un vaisseau du modèle</translation>
    </message>
    <message>
        <source>Point at places within 60 mm</source>
        <translation>Désignez des endroits distants de 60 mm au plus</translation>
    </message>
    <message>
        <source>Point at two different trees</source>
        <translation>Désignez deux arbres différents</translation>
    </message>
    <message>
        <source>A marker is smaller than its square</source>
        <translation>Un marqueur est plus petit que sa case</translation>
    </message>
    <message>
        <source>Check the board&apos;s size and dictionary</source>
        <translation>Vérifiez la taille et le dictionnaire de la mire</translation>
    </message>
    <message>
        <source>Count the inner corners: from 3 to 50 a side</source>
        <translation>Comptez les coins intérieurs : de 3 à 50 par côté</translation>
    </message>
    <message>
        <source>Give OpenCV&apos;s name, such as DICT_4X4_50</source>
        <translation>Donnez le nom d’OpenCV, comme DICT_4X4_50</translation>
    </message>
    <message>
        <source>Measure the side of a square: up to 200 mm</source>
        <translation>Mesurez le côté d’une case : jusqu’à 200 mm</translation>
    </message>
    <message>
        <source>Give a number between -1 and 0.5</source>
        <translation>Donnez un nombre entre -1 et 0,5</translation>
    </message>
    <message>
        <source>Give numbers between -1 and 0.5</source>
        <translation>Donnez des nombres entre -1 et 0,5</translation>
    </message>
    <message>
        <source>Give a relative residual between 0 and 1</source>
        <translation>Donnez un résidu relatif entre 0 et 1</translation>
    </message>
    <message>
        <source>Give positive lengths in metres</source>
        <translation>Donnez des longueurs positives en mètres</translation>
    </message>
    <message>
        <source>Give positive numbers</source>
        <translation>Donnez des nombres positifs</translation>
    </message>
    <message>
        <source>Give a positive length in metres</source>
        <translation>Donnez une longueur positive en mètres</translation>
    </message>
    <message>
        <source>Give a positive number</source>
        <translation>Donnez un nombre positif</translation>
    </message>
    <message>
        <source>Give a positive number of pixels</source>
        <translation>Donnez un nombre positif de pixels</translation>
    </message>
    <message>
        <source>Give a positive number of seconds</source>
        <translation>Donnez un nombre positif de secondes</translation>
    </message>
    <message>
        <source>Give a positive number up to %1</source>
        <translation>Donnez un nombre positif jusqu’à %1</translation>
    </message>
    <message>
        <source>Give a number from zero</source>
        <translation>Donnez un nombre à partir de zéro</translation>
    </message>
    <message>
        <source>Give a number from %1 to %2</source>
        <translation>Donnez un nombre de %1 à %2</translation>
    </message>
    <message>
        <source>Give a length from zero, in metres</source>
        <translation>Donnez une longueur à partir de zéro, en mètres</translation>
    </message>
    <message>
        <source>Give a share above 0, at most 1</source>
        <translation>Donnez une part supérieure à 0, au plus 1</translation>
    </message>
    <message>
        <source>Give a share from 0 to 1</source>
        <translation>Donnez une part de 0 à 1</translation>
    </message>
    <message>
        <source>Give a share up to that of `fresh`</source>
        <translation>Donnez une part jusqu’à celle de « fresh »</translation>
    </message>
    <message>
        <source>Give an odd number from 5</source>
        <translation>Donnez un nombre impair à partir de 5</translation>
    </message>
    <message>
        <source>Give less than lies between two checks</source>
        <translation>Donnez moins que ce qui sépare deux contrôles</translation>
    </message>
    <message>
        <source>Give more than one</source>
        <translation>Donnez plus de un</translation>
    </message>
    <message>
        <source>Give the margin at least</source>
        <translation>Donnez au moins la marge (margin)</translation>
    </message>
    <message>
        <source>Give %1 or more</source>
        <translation>Donnez %1 ou plus</translation>
    </message>
    <message>
        <source>Give the server&apos;s port, as 18944</source>
        <translation>Donnez le port du serveur, comme 18944</translation>
    </message>
    <message>
        <source>Give up to 100</source>
        <translation>Donnez jusqu’à 100</translation>
    </message>
    <message>
        <source>Give up to 60 seconds</source>
        <translation>Donnez jusqu’à 60 secondes</translation>
    </message>
    <message>
        <source>Give up to a second</source>
        <translation>Donnez jusqu’à une seconde</translation>
    </message>
    <message>
        <source>Give up to a second; 0 is half a frame</source>
        <translation>Donnez jusqu’à une seconde ; 0 est une demi-image</translation>
    </message>
    <message>
        <source>has changed since it was looked at</source>
        <translation>a changé depuis qu&apos;on l&apos;a regardé</translation>
    </message>
    <message>
        <source>Look at it as it is now, and say it again</source>
        <translation>Regardez-le tel qu&apos;il est maintenant et dites-le encore</translation>
    </message>
    <message>
        <source>is another case</source>
        <translation>est un autre cas</translation>
    </message>
    <message>
        <source>Choose another name, or say that it is replaced</source>
        <translation>Choisissez un autre nom, ou dites qu&apos;il est remplacé</translation>
    </message>
    <message>
        <source>show %1 points of the liver&apos;s surface, at least %2 are needed</source>
        <translation>montrent %1 points de la surface du foie, il en faut au moins %2</translation>
    </message>
    <message>
        <source>Draw a region on its surface, too</source>
        <translation>Dessinez aussi une région sur sa surface</translation>
    </message>
    <message>
        <source>meet nothing of the model: they lie elsewhere, or their normals point away</source>
        <translation>ne rencontrent rien du modèle : ils sont ailleurs, ou leurs normales pointent à l&apos;opposé</translation>
    </message>
    <message>
        <source>Give a start that is nearer, or the cloud without normals</source>
        <translation>Donnez un départ plus proche, ou le nuage sans normales</translation>
    </message>
    <message>
        <source>are no regular stack: %1 lies %2 mm from its place</source>
        <translation>ne forment pas une pile régulière : %1 est à %2 mm de sa place</translation>
    </message>
    <message>
        <source>is no field of a header</source>
        <translation>n&apos;est pas un champ d&apos;en-tête</translation>
    </message>
    <message>
        <source>contradicts BinaryDataByteOrderMSB</source>
        <translation>contredit BinaryDataByteOrderMSB</translation>
    </message>
    <message>
        <source>is not kept</source>
        <translation>n&apos;est pas conservé</translation>
    </message>
    <message>
        <source>finds no room: the pictures of all moments may take 1 GiB</source>
        <translation>ne trouve pas de place : les images de tous les instants peuvent occuper 1 Gio</translation>
    </message>
    <message>
        <source>is longer than a title can be</source>
        <translation>est plus long qu&apos;un titre ne peut l&apos;être</translation>
    </message>
    <message>
        <source>is no time</source>
        <translation>n&apos;est pas un moment valable</translation>
    </message>
    <message>
        <source>is that of another moment</source>
        <translation>est celui d&apos;un autre instant</translation>
    </message>
    <message>
        <source>does not hold one frame</source>
        <translation>ne contient pas exactement une image</translation>
    </message>
    <message>
        <source>is not the picture that was kept</source>
        <translation>n&apos;est pas l&apos;image qui a été conservée</translation>
    </message>
    <message>
        <source>names a moment twice</source>
        <translation>nomme un instant deux fois</translation>
    </message>
    <message>
        <source>holds a number that is not finite</source>
        <translation>contient un nombre qui n&apos;est pas fini</translation>
    </message>
    <message>
        <source>Keep a moment of the live view first</source>
        <translation>Conservez d&apos;abord un instant de la vue en direct</translation>
    </message>
    <message>
        <source>Delete moments that are not needed any more</source>
        <translation>Supprimez les instants dont vous n&apos;avez plus besoin</translation>
    </message>
    <message>
        <source>Choose it in the list</source>
        <translation>Choisissez-le dans la liste</translation>
    </message>
    <message>
        <source>Choose one of the list</source>
        <translation>Choisissez-en un dans la liste</translation>
    </message>
    <message>
        <source>Shorten it to 200 letters</source>
        <translation>Raccourcissez-le à 200 lettres</translation>
    </message>
    <message>
        <source>Keep another frame</source>
        <translation>Conservez une autre image</translation>
    </message>
    <message>
        <source>Free some memory</source>
        <translation>Libérez de la mémoire</translation>
    </message>
    <message>
        <source>is what the organ is followed from just now</source>
        <translation>est celui depuis lequel l&apos;organe est suivi en ce moment</translation>
    </message>
    <message>
        <source>Stop tracking first</source>
        <translation>Arrêtez d&apos;abord le suivi</translation>
    </message>
    <message>
        <source>Click it first, or find something else anew</source>
        <translation>Cliquez-la d&apos;abord, ou recherchez autre chose</translation>
    </message>
    <message>
        <source>Unlock it, or find something else anew</source>
        <translation>Déverrouillez-la, ou recherchez autre chose</translation>
    </message>
    <message>
        <source>waits for a decision</source>
        <translation>attend une décision</translation>
    </message>
    <message>
        <source>Decide about it first</source>
        <translation>Décidez d’abord à son sujet</translation>
    </message>
    <message>
        <source>is locked and would be changed</source>
        <translation>est verrouillé et serait changé</translation>
    </message>
    <message>
        <source>Unlock it first</source>
        <translation>Déverrouillez-le d’abord</translation>
    </message>
</context>
<context>
    <name>Errors</name>
    <message>
        <source>%1: does not exist. Check the path.</source>
        <translation>%1 : n’existe pas. Vérifiez le chemin.</translation>
    </message>
    <message>
        <source>%1: cannot be opened (%2). Check the path.</source>
        <translation>%1 : ne peut pas être ouvert (%2). Vérifiez le chemin.</translation>
    </message>
    <message>
        <source>%1: could not be read to its end. Check the disk.</source>
        <translation>%1 : n’a pas pu être lu jusqu’à la fin. Vérifiez le disque.</translation>
    </message>
    <message>
        <source>%1: is a folder. Name a file in it.</source>
        <translation>%1 : est un dossier. Nommez un fichier qui s’y trouve.</translation>
    </message>
    <message>
        <source>%1: is a folder, a file is to be written here. Choose another name.</source>
        <translation>%1 : est un dossier, un fichier doit être écrit ici. Choisissez un autre nom.</translation>
    </message>
    <message>
        <source>%1: is a device or a pipe, not a file. Choose another name.</source>
        <translation>%1 : est un périphérique ou un tube, pas un fichier. Choisissez un autre nom.</translation>
    </message>
    <message>
        <source>%1: its folder does not exist. Create it or choose another.</source>
        <translation>%1 : son dossier n’existe pas. Créez-le ou choisissez-en un autre.</translation>
    </message>
    <message>
        <source>%1: could not be written (%2). Check permissions and free space.</source>
        <translation>%1 : n’a pas pu être écrit (%2). Vérifiez les droits et l’espace libre.</translation>
    </message>
    <message>
        <source>%1: what was written reads back differently. Check the disk.</source>
        <translation>%1 : ce qui a été écrit se relit différemment. Vérifiez le disque.</translation>
    </message>
    <message>
        <source>%1: is a link that leads back to itself. Choose another name.</source>
        <translation>%1 : est un lien qui mène à lui-même. Choisissez un autre nom.</translation>
    </message>
    <message>
        <source>%1: is a link that another user has put there. Choose another name or folder.</source>
        <translation>%1 : est un lien qu’un autre utilisateur a placé là. Choisissez un autre nom ou dossier.</translation>
    </message>
    <message>
        <source>%1: no folder can be made here (%2). Check permissions.</source>
        <translation>%1 : aucun dossier ne peut être créé ici (%2). Vérifiez les droits.</translation>
    </message>
    <message>
        <source>%1: could not be replaced (%2). Choose another name.</source>
        <translation>%1 : n’a pas pu être remplacé (%2). Choisissez un autre nom.</translation>
    </message>
    <message>
        <source>%1: could not be flushed to disk (%2). Free some space.</source>
        <translation>%1 : n’a pas pu être écrit sur le disque (%2). Libérez de l’espace.</translation>
    </message>
    <message>
        <source>%1: is open for writing by %2. Close it there, or save under another name. If that program runs no longer, remove %3.</source>
        <translation>%1 : est ouvert en écriture par %2. Fermez-le là-bas, ou enregistrez sous un autre nom. Si ce programme ne tourne plus, supprimez %3.</translation>
    </message>
    <message>
        <source>%1: cannot be opened for writing: %2 cannot be written. Check the permissions of its folder, or open it for reading.</source>
        <translation>%1 : ne peut pas être ouvert en écriture : %2 ne peut pas être écrit. Vérifiez les droits de son dossier, ou ouvrez-le en lecture.</translation>
    </message>
    <message>
        <source>%1: exists and is not a case. Choose another name.</source>
        <translation>%1 : existe et n’est pas un cas. Choisissez un autre nom.</translation>
    </message>
    <message>
        <source>%1: a case is a folder whose name ends in .glisson. Choose such a name.</source>
        <translation>%1 : un cas est un dossier dont le nom finit par .glisson. Choisissez un tel nom.</translation>
    </message>
    <message>
        <source>%1: case.json: is missing: this folder is not a case. Choose a folder NAME.glisson.</source>
        <translation>%1 : case.json : manque : ce dossier n’est pas un cas. Choisissez un dossier NOM.glisson.</translation>
    </message>
    <message>
        <source>%1: version: is %2, this program reads up to %3. Open it with a newer Glisson.</source>
        <translation>%1 : version : vaut %2, ce programme lit jusqu’à %3. Ouvrez-le avec un Glisson plus récent.</translation>
    </message>
    <message>
        <source>%1: %2: is not valid JSON. Correct it there or write the file anew.</source>
        <translation>%1 : %2 : n’est pas du JSON valide. Corrigez-le à cet endroit ou réécrivez le fichier.</translation>
    </message>
    <message>
        <source>%1: is malformed (%2). Restore the case from a copy.</source>
        <translation>%1 : est malformé (%2). Restaurez le cas depuis une copie.</translation>
    </message>
    <message>
        <source>%1: the case reads back differently from what was written. Check the disk&apos;s free space; the old case stands.</source>
        <translation>%1 : le cas se relit différemment de ce qui a été écrit. Vérifiez l’espace libre ; l’ancien cas reste.</translation>
    </message>
    <message>
        <source>%1: is no file of the case and could not be kept (%2). Move it elsewhere and save again; the old case stands.</source>
        <translation>%1 : n’est pas un fichier du cas et n’a pas pu être conservé (%2). Déplacez-le et enregistrez de nouveau ; l’ancien cas reste.</translation>
    </message>
    <message>
        <source>%1: cannot be used (%2). Check the path.</source>
        <translation>%1 : ne peut pas être utilisé (%2). Vérifiez le chemin.</translation>
    </message>
    <message>
        <source>%1: cannot be used (%2). Check the permissions of the file and of its folders.</source>
        <translation>%1 : ne peut pas être utilisé (%2). Vérifiez les droits du fichier et de ses dossiers.</translation>
    </message>
    <message>
        <source>%1: cannot be used (%2). Free some space on the disk.</source>
        <translation>%1 : ne peut pas être utilisé (%2). Libérez de l’espace sur le disque.</translation>
    </message>
    <message>
        <source>%1: stopped unexpectedly (%2). The case is as it was.</source>
        <translation>%1 : s’est arrêté de façon inattendue (%2). Le cas est comme il était.</translation>
    </message>
    <message>
        <source>%1: memory ran out. Close other programs, or take a smaller volume or a coarser mesh.</source>
        <translation>%1 : la mémoire n’a pas suffi. Fermez d’autres programmes, ou prenez un volume plus petit ou un maillage plus grossier.</translation>
    </message>
    <message>
        <source>case: path: the case has never been saved. Choose a folder NAME.glisson to save it to.</source>
        <translation>cas : chemin : le cas n’a jamais été enregistré. Choisissez un dossier NOM.glisson où l’enregistrer.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
</context>
<context>
    <name>LeftLiverQuestion</name>
    <message>
        <source>Liver left of the vena cava</source>
        <translation>Foie à gauche de la veine cave</translation>
    </message>
    <message>
        <source>In %1 the liver lies left of the vena cava: has it been operated on (right liver removed), or is the image mirrored?</source>
        <translation>Dans %1, le foie est à gauche de la veine cave : a-t-il été opéré (foie droit enlevé), ou l’image est-elle en miroir ?</translation>
    </message>
    <message>
        <source>In a mirrored image left and right are exchanged in all that follows. Where you are not sure, import nothing: look at the image, and correct the direction in the file&apos;s header if it is mirrored.</source>
        <translation>Dans une image en miroir, gauche et droite sont échangées dans tout ce qui suit. En cas de doute, n’importez rien : regardez l’image et corrigez la direction dans l’en-tête du fichier si elle est en miroir.</translation>
    </message>
    <message>
        <source>Operated on: import</source>
        <translation>Opéré : importer</translation>
    </message>
    <message>
        <source>Mirrored or not sure: do not import</source>
        <translation>En miroir ou pas sûr : ne pas importer</translation>
    </message>
</context>
<context>
    <name>NamedVideoQuestion</name>
    <message>
        <source>Pictures named by the case</source>
        <translation>Images désignées par le cas</translation>
    </message>
    <message>
        <source>The case names these pictures. It chose them, nobody on this computer has:</source>
        <translation>Le cas désigne ces images. C’est lui qui les a choisies, personne sur cet ordinateur :</translation>
    </message>
    <message>
        <source>Open them only if you trust the case. Left out, they stay named in the case, and you can open pictures at any time (Stereo &gt; Open).</source>
        <translation>Ne les ouvrez que si vous faites confiance au cas. Laissées de côté, elles restent désignées dans le cas, et vous pouvez ouvrir des images à tout moment (Stéréo &gt; Ouvrir).</translation>
    </message>
    <message>
        <source>Open the pictures</source>
        <translation>Ouvrir les images</translation>
    </message>
    <message>
        <source>Leave them out</source>
        <translation>Les laisser de côté</translation>
    </message>
</context>
<context>
    <name>LesionTexts</name>
    <message>
        <source>shown</source>
        <translation>montrée</translation>
    </message>
    <message>
        <source>region only</source>
        <translation>zone seule</translation>
    </message>
    <message>
        <source>not shown</source>
        <translation>non montrée</translation>
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
        <translation>Points suivis les plus proches</translation>
    </message>
    <message>
        <source>Nothing near it tracked for</source>
        <translation>Rien de suivi à proximité depuis</translation>
    </message>
</context>
<context>
    <name>Notes</name>
    <message>
        <source>The liver is smaller than 400 ml: check it in the slices.</source>
        <translation>Le foie fait moins de 400 ml : vérifiez-le dans les coupes.</translation>
    </message>
    <message>
        <source>%1 ml of tissue that looks like the liver and hangs on it were left out, as another organ. If they are liver, as a lobe behind a tumour is, click in them.</source>
        <translation>%1 ml de tissu qui ressemble au foie et qui y tient ont été laissés de côté, comme un autre organe. S’il s’agit du foie, comme un lobe derrière une tumeur, cliquez dedans.</translation>
    </message>
    <message>
        <source>%1 ml of tissue in the liver are darker than it, and nobody clicked there. A tumour or cyst: click it as a lesion. Gallbladder, stomach or bowel: click it as that, or as &quot;not liver&quot;.</source>
        <translation>%1 ml de tissu dans le foie sont plus sombres que lui, et personne n’y a cliqué. Tumeur ou kyste : cliquez-le comme lésion. Vésicule, estomac ou intestin : cliquez-le comme tel, ou comme « Pas le foie ».</translation>
    </message>
    <message>
        <source>The liver ends on the border of the region that was segmented: %1 cm² there are a cut and no surface. Segment a larger region.</source>
        <translation>Le foie se termine au bord de la région segmentée : %1 cm² y sont une coupe et non une surface. Segmentez une région plus grande.</translation>
    </message>
    <message>
        <source>The liver is larger than 4000 ml: check it in the slices.</source>
        <translation>Le foie fait plus de 4000 ml : vérifiez-le dans les coupes.</translation>
    </message>
    <message>
        <source>A separate piece of the liver&apos;s surface was left out (%2 ml).</source>
        <translation>Un morceau séparé de la surface du foie a été écarté (%2 ml).</translation>
    </message>
    <message>
        <source>Separate specks of liver were left out: %1 (%3 ml).</source>
        <translation>Îlots de foie séparés écartés : %1 (%3 ml).</translation>
    </message>
    <message>
        <source>No portal vein was found at its seeds: what there was stays.</source>
        <translation>Aucune veine porte n&apos;a été trouvée à ses germes : ce qui existait reste.</translation>
    </message>
    <message>
        <source>No hepatic vein was found at its seeds: what there was stays.</source>
        <translation>Aucune veine hépatique n&apos;a été trouvée à ses germes : ce qui existait reste.</translation>
    </message>
    <message>
        <source>%1: loose specks left out of the vessel model: %2 (%4 ml). In 3D they are drawn, over the picture with thin branches only.</source>
        <translation>%1 : îlots écartés du modèle des vaisseaux : %2 (%4 ml). Ils sont dessinés en 3D, sur l&apos;image seulement avec les branches fines.</translation>
    </message>
    <message>
        <source>%1: separate trees in the model: %2.</source>
        <translation>%1 : arbres séparés dans le modèle : %2.</translation>
    </message>
    <message>
        <source>Beams along the vessels: %1.</source>
        <translation>Poutres le long des vaisseaux : %1.</translation>
    </message>
    <message>
        <source>Vessel nodes just outside the mesh, tied to its surface: %1.</source>
        <translation>Nœuds de vaisseaux juste hors du maillage, liés à sa surface : %1.</translation>
    </message>
    <message>
        <source>%1 of the %2 beams along the vessels lie outside the mesh and stiffen nothing: check whether vessels and liver belong together.</source>
        <translation>%1 des %2 poutres le long des vaisseaux sont hors du maillage et ne rigidifient rien : vérifiez si les vaisseaux et le foie vont ensemble.</translation>
    </message>
    <message>
        <source>%1 lies outside the liver and was left out.</source>
        <translation>%1 se trouve hors du foie et a été écarté.</translation>
    </message>
    <message>
        <source>%1: %2 % of its volume lie outside the liver or in another lesion; its elements leave that out.</source>
        <translation>%1 : %2 % du volume se trouvent hors du foie ou dans une autre lésion ; ses éléments laissent cela de côté.</translation>
    </message>
    <message>
        <source>%1: its surface has holes, or triangles that face the wrong way. For the vessel model each hole was closed straight across: check the vessel&apos;s ends and branches, or mend the surface in the program that made it.</source>
        <translation>%1 : la surface a des trous, ou des triangles orientés à l’envers. Pour le modèle vasculaire, chaque trou a été fermé tout droit : vérifiez les extrémités et les branches du vaisseau, ou réparez la surface dans le programme qui l’a faite.</translation>
    </message>
    <message>
        <source>%1 was left out: only %3 mm³.</source>
        <translation>%1 a été écarté : seulement %3 mm³.</translation>
    </message>
    <message>
        <source>Crumbs of lesion surfaces left out: %1.</source>
        <translation>Miettes de surfaces de lésions écartées : %1.</translation>
    </message>
    <message>
        <source>%1 (%3 mm across) is too small for elements of its own; it follows the tissue around it.</source>
        <translation>%1 (%3 mm) est trop petite pour avoir ses propres éléments ; elle suit le tissu autour d&apos;elle.</translation>
    </message>
    <message>
        <source>%1 got no elements of its own; it follows the tissue around it.</source>
        <translation>%1 n&apos;a pas d&apos;éléments propres ; elle suit le tissu autour d&apos;elle.</translation>
    </message>
    <message>
        <source>The mesh&apos;s surface is not a clean closed one.</source>
        <translation>La surface du maillage n&apos;est pas proprement fermée.</translation>
    </message>
    <message>
        <source>The flattest element has an angle of %1°.</source>
        <translation>L&apos;élément le plus plat a un angle de %1°.</translation>
    </message>
    <message>
        <source>The mesh has %1 vertices, not as many as asked for.</source>
        <translation>Le maillage a %1 sommets, pas le nombre demandé.</translation>
    </message>
    <message>
        <source>The file %1 was not used: %2 shows the same structure.</source>
        <translation>Le fichier %1 n&apos;a pas été utilisé : %2 montre la même structure.</translation>
    </message>
    <message>
        <source>The file %1 was not used: its name tells no structure.</source>
        <translation>Le fichier %1 n&apos;a pas été utilisé : son nom ne désigne aucune structure.</translation>
    </message>
    <message>
        <source>No anterior margin was found: the registration has one feature less.</source>
        <translation>Aucun bord antérieur n&apos;a été trouvé : il manque un repère au recalage.</translation>
    </message>
    <message>
        <source>The image ends inside the liver: %1 mm of what looks like its anterior margin are the edge of that cut and were left out. Check the margin there.</source>
        <translation>L’image s’arrête dans le foie : %1 mm de ce qui ressemble à son bord antérieur sont l’arête de cette coupe et ont été écartés. Vérifiez le bord à cet endroit.</translation>
    </message>
    <message>
        <source>Few points show the anterior margin: the position along it is uncertain.</source>
        <translation>Peu de points montrent le bord antérieur : la position le long du bord est incertaine.</translation>
    </message>
    <message>
        <source>The umbilical notch is not marked in both model and picture: the position along the margin is uncertain.</source>
        <translation>L&apos;échancrure ombilicale n&apos;est pas marquée dans le modèle et l&apos;image : la position le long du bord est incertaine.</translation>
    </message>
    <message>
        <source>The rigid start fits the points badly (more than 10 mm).</source>
        <translation>Le départ rigide s&apos;ajuste mal aux points (plus de 10 mm).</translation>
    </message>
    <message>
        <source>Two rigid positions fit almost equally well; the better one was taken.</source>
        <translation>Deux positions rigides conviennent presque aussi bien ; la meilleure a été prise.</translation>
    </message>
    <message>
        <source>Two elastic laws explain the points almost equally well, but place the organ differently; the better one was taken.</source>
        <translation>Deux lois élastiques expliquent les points presque aussi bien, mais placent l&apos;organe différemment ; la meilleure a été retenue.</translation>
    </message>
    <message>
        <source>The search for contact forces ended before it had come to rest.</source>
        <translation>La recherche des forces de contact s&apos;est arrêtée avant d&apos;arriver au repos.</translation>
    </message>
    <message>
        <source>Many points do not fit the model and were left aside.</source>
        <translation>Beaucoup de points ne correspondent pas au modèle et ont été laissés de côté.</translation>
    </message>
    <message>
        <source>The model stays more than 5 mm from the points on average.</source>
        <translation>Le modèle reste à plus de 5 mm des points en moyenne.</translation>
    </message>
    <message>
        <source>Some elements of the mesh turned inside out.</source>
        <translation>Des éléments du maillage se sont retournés.</translation>
    </message>
    <message>
        <source>The organ was still moving towards the points after the last step.</source>
        <translation>L’organe se déplaçait encore vers les points après le dernier pas.</translation>
    </message>
    <message>
        <source>The mechanical computation did not come to an end.</source>
        <translation>Le calcul mécanique n&apos;a pas abouti.</translation>
    </message>
    <message>
        <source>The simulation had not come to rest at its last step.</source>
        <translation>La simulation n&apos;était pas au repos à son dernier pas.</translation>
    </message>
    <message>
        <source>Less than a fifth of the organ&apos;s surface was seen: far from it vessels and tumours may be centimetres off.</source>
        <translation>Moins d&apos;un cinquième de la surface de l&apos;organe a été vu&#xa0;: loin de là, vaisseaux et tumeurs peuvent être décalés de plusieurs centimètres.</translation>
    </message>
    <message>
        <source>Two different shapes of the organ explain the points almost equally well; the better one was taken.</source>
        <translation>Deux formes différentes de l&apos;organe expliquent presque aussi bien les points&#xa0;; la meilleure a été prise.</translation>
    </message>
    <message>
        <source>The organ would be bent as in hardly any simulated operation.</source>
        <translation>L&apos;organe serait déformé comme dans presque aucune opération simulée.</translation>
    </message>
    <message>
        <source>Nothing changed.</source>
        <translation>Rien n&apos;a changé.</translation>
    </message>
    <message>
        <source>There is no empty slice between two that are drawn.</source>
        <translation>Il n&apos;y a pas de coupe vide entre deux coupes dessinées.</translation>
    </message>
    <message>
        <source>The region reaches the slice&apos;s edge: click where it is enclosed.</source>
        <translation>La région atteint le bord de la coupe : cliquez là où elle est fermée.</translation>
    </message>
    <message>
        <source>No label was free for the smallest islands: %1 stayed as they were.</source>
        <translation>Aucune étiquette n&apos;était libre pour les plus petits îlots : %1 sont restés tels quels.</translation>
    </message>
    <message>
        <source>Both pictures are dark.</source>
        <translation>Les deux images sont sombres.</translation>
    </message>
    <message>
        <source>The left camera shows nothing.</source>
        <translation>La caméra gauche ne montre rien.</translation>
    </message>
    <message>
        <source>The right camera shows nothing.</source>
        <translation>La caméra droite ne montre rien.</translation>
    </message>
    <message>
        <source>Both pictures are the same: one camera is lost.</source>
        <translation>Les deux images sont identiques : une caméra est perdue.</translation>
    </message>
    <message>
        <source>Left and right are swapped.</source>
        <translation>Gauche et droite sont échangées.</translation>
    </message>
    <message>
        <source>The two pictures show nothing in common.</source>
        <translation>Les deux images n&apos;ont rien en commun.</translation>
    </message>
    <message>
        <source>The calibration is of another laparoscope: the pictures&apos; points do not lie on its epipolar lines.</source>
        <translation>L&apos;étalonnage est celui d&apos;un autre laparoscope : les points des images ne sont pas sur ses lignes épipolaires.</translation>
    </message>
    <message>
        <source>The frame before comes once more.</source>
        <translation>L&apos;image précédente revient.</translation>
    </message>
    <message>
        <source>The picture is frozen.</source>
        <translation>L&apos;image est figée.</translation>
    </message>
    <message>
        <source>The left picture is frozen.</source>
        <translation>L&apos;image gauche est figée.</translation>
    </message>
    <message>
        <source>The right picture is frozen.</source>
        <translation>L&apos;image droite est figée.</translation>
    </message>
    <message>
        <source>Two frames have changed places.</source>
        <translation>Deux images ont échangé leur place.</translation>
    </message>
    <message>
        <source>The film is interlaced: the even and the odd rows of a picture show two moments, so that points on what moves are off by its motion in half of a frame&apos;s time. Set the device to progressive, or give --video a description of the source (.json) with &quot;deinterlace&quot;: true.</source>
        <translation>Le film est entrelacé : les lignes paires et impaires d&apos;une image montrent deux instants, de sorte que les points sur ce qui bouge sont décalés de son mouvement pendant la moitié du temps d&apos;une image. Réglez l&apos;appareil sur progressif, ou donnez à --video une description de la source (.json) avec &quot;deinterlace&quot;: true.</translation>
    </message>
    <message>
        <source>The view %1 fits far worse than the others and was left out.</source>
        <translation>La vue %1 s&apos;ajuste bien moins que les autres et a été laissée de côté.</translation>
    </message>
    <message>
        <source>Thin side branches left out of the vessel model: %1 (%3 mm together).</source>
        <translation>Fines branches latérales laissées hors du modèle vasculaire : %1 (%3 mm en tout).</translation>
    </message>
    <message>
        <source>The thickest of them has a radius of %1 mm.</source>
        <translation>La plus épaisse a un rayon de %1 mm.</translation>
    </message>
    <message>
        <source>%1: cut off by hand: %3 mm, tips: %5.</source>
        <translation>%1 : coupé à la main : %3 mm, extrémités : %5.</translation>
    </message>
    <message>
        <source>%1: the label has not been reviewed.</source>
        <translation>%1 : le label n’a pas été vérifié.</translation>
    </message>
    <message>
        <source>%1: the label&apos;s review is in progress.</source>
        <translation>%1 : la vérification du label est en cours.</translation>
    </message>
    <message>
        <source>%1: the label is still to be reviewed.</source>
        <translation>%1 : le label reste à vérifier.</translation>
    </message>
    <message>
        <source>The view %1 fits far worse than the others: calibrate again without it.</source>
        <translation>La vue %1 s’ajuste bien moins que les autres : recommencez l’étalonnage sans elle.</translation>
    </message>
    <message>
        <source>The case was opened without its laparoscope&apos;s calibration: load a right one and reconstruct the surface again; points and registration are out of date. Saved now, the case loses this one. (%*)</source>
        <translation>Le cas a été ouvert sans l&apos;étalonnage de son laparoscope : chargez-en un correct et reconstruisez la surface ; points et recalage sont périmés. Enregistré maintenant, le cas perd celui-ci. (%*)</translation>
    </message>
    <message>
        <source>The case was opened without its cloud of points: reconstruct the surface or import the cloud again. Saved now, the case loses what is left of it. (%*)</source>
        <translation>Le cas a été ouvert sans son nuage de points : reconstruisez la surface ou importez de nouveau le nuage. Enregistré maintenant, le cas perd ce qu’il en reste. (%*)</translation>
    </message>
    <message>
        <source>The case was opened without the points of the whole stereo pair: reconstruct the surface again before regions are changed. Saved now, the case loses what is left of them. (%*)</source>
        <translation>Le cas a été ouvert sans les points de la paire stéréo entière : reconstruisez la surface avant de modifier des régions. Enregistré maintenant, le cas perd ce qu’il en reste. (%*)</translation>
    </message>
    <message>
        <source>The volume measures only %1 mm along its shortest side: a liver is larger.</source>
        <translation>Le volume ne mesure que %1 mm sur son côté le plus court : un foie est plus grand.</translation>
    </message>
    <message>
        <source>The volume is %1 mm wide: no scanner is. Check its unit.</source>
        <translation>Le volume est large de %1 mm, plus que tout scanner. Vérifiez son unité.</translation>
    </message>
    <message>
        <source>%1 of %2 slices hold nothing but one value: they may have been lost on the way.</source>
        <translation>%1 coupes sur %2 ne contiennent qu&apos;une seule valeur : elles ont peut-être été perdues en route.</translation>
    </message>
    <message>
        <source>%1 of %2 slices are the one before over again: some may have been lost on the way.</source>
        <translation>%1 coupes sur %2 répètent la précédente : certaines ont peut-être été perdues en route.</translation>
    </message>
    <message>
        <source>%1 % of the voxels are exactly 0: the volume may be cut off or masked.</source>
        <translation>%1 % des voxels valent exactement 0 : le volume est peut-être tronqué ou masqué.</translation>
    </message>
    <message>
        <source>Only %1 % of the voxels have the Hounsfield units of soft tissue. Either this is no CT in Hounsfield units, or the scanner&apos;s rescale slope and intercept were lost on the way. Look at water and muscle in the slices (0 and 50 HU); if they are not so, export the CT again from its DICOM series.</source>
        <translation>Seulement %1 % des voxels ont les unités Hounsfield des tissus mous. Soit ce n&apos;est pas un scanner en unités Hounsfield, soit la pente et l&apos;ordonnée à l&apos;origine (rescale slope et intercept) du scanner ont été perdues en route. Regardez l&apos;eau et le muscle dans les coupes (0 et 50 HU) ; s&apos;ils n&apos;y sont pas, exportez de nouveau le scanner depuis sa série DICOM.</translation>
    </message>
    <message>
        <source>Hardly a voxel has the Hounsfield units of air (%1 %). Either the CT was cropped to tissue, or the scanner&apos;s rescale intercept was lost on the way. Look at water and muscle in the slices (0 and 50 HU); if they are not so, export the CT again from its DICOM series.</source>
        <translation>Presque aucun voxel n&apos;a les unités Hounsfield de l&apos;air (%1 %). Soit le scanner a été recadré sur des tissus, soit l&apos;ordonnée à l&apos;origine (rescale intercept) du scanner a été perdue en route. Regardez l&apos;eau et le muscle dans les coupes (0 et 50 HU) ; s&apos;ils n&apos;y sont pas, exportez de nouveau le scanner depuis sa série DICOM.</translation>
    </message>
    <message>
        <source>Shifted by %1 HU the volume would hold air and soft tissue, as a CT does: the scanner&apos;s intercept was probably lost or added twice. Do not trust what is segmented from such values.</source>
        <translation>Décalé de %1 HU, le volume contiendrait de l&apos;air et des tissus mous, comme un scanner : l&apos;ordonnée à l&apos;origine (intercept) a sans doute été perdue ou ajoutée deux fois. Ne vous fiez pas à ce qui est segmenté de telles valeurs.</translation>
    </message>
    <message>
        <source>The case was opened without its video, which the case has chosen and nobody here. If you trust it, open it yourself (Stereo &gt; Open; on the command line --video of render and overlay). (%*)</source>
        <translation>Le cas a été ouvert sans sa vidéo, que le cas a choisie et personne ici. Si vous lui faites confiance, ouvrez-la vous-même (Stéréo &gt; Ouvrir ; en ligne de commande --video de render et overlay). (%*)</translation>
    </message>
    <message>
        <source>The case is open for writing by %*. It was opened for reading here: saved now, it needs another name.</source>
        <translation>Le cas est ouvert en écriture par %*. Il a été ouvert ici en lecture : pour l’enregistrer, il faut un autre nom.</translation>
    </message>
    <message>
        <source>The folder around the case cannot be written to. It was opened for reading: save it elsewhere.</source>
        <translation>Le dossier qui contient le cas n’est pas accessible en écriture. Il a été ouvert en lecture : enregistrez-le ailleurs.</translation>
    </message>
    <message>
        <source>Others have saved this case since it was opened here. Theirs stays as it is; yours was saved as %*. Compare the two.</source>
        <translation>D’autres ont enregistré ce cas depuis qu’il a été ouvert ici. Le leur reste tel quel ; le vôtre a été enregistré sous %*. Comparez les deux.</translation>
    </message>
    <message>
        <source>A file of the case was changed by another program since it was saved. What it held is kept as %*.</source>
        <translation>Un fichier du cas a été modifié par un autre programme depuis son enregistrement. Son contenu est conservé sous %*.</translation>
    </message>
    <message>
        <source>The shape that fits the points would turn the organ inside out.</source>
        <translation>La forme qui convient aux points retournerait l&apos;organe.</translation>
    </message>
    <message>
        <source>Liver seed %1 had no effect: nothing joins its surroundings to the rest of the liver. Click between the two, or take it away.</source>
        <translation>Le germe de foie %1 n’a eu aucun effet : rien ne relie ses environs au reste du foie. Placez un germe entre les deux, ou retirez-le.</translation>
    </message>
    <message>
        <source>Liver seed %1 had no effect: %2 lies there. Take one of the two away.</source>
        <translation>Le germe de foie %1 n’a eu aucun effet : %2 s’y trouve. Retirez l’un des deux.</translation>
    </message>
    <message>
        <source>&quot;Not liver&quot; seed %1 had no effect: %2 lies there. Take one of the two away.</source>
        <translation>Le germe %1 « Pas le foie » n’a eu aucun effet : %2 s’y trouve. Retirez l’un des deux.</translation>
    </message>
    <message>
        <source>The cloud&apos;s points scatter by %1 mm about a smooth surface (limit %2 mm).</source>
        <translation>Les points du nuage se dispersent de %1 mm autour d&apos;une surface lisse (limite %2 mm).</translation>
    </message>
    <message>
        <source>The cloud&apos;s mirror image fits as well or nearly so (log odds %1, limit %2): it has not been recognised as this liver.</source>
        <translation>L&apos;image miroir du nuage convient aussi bien ou presque (logarithme des chances %1, limite %2) : il n&apos;a pas été reconnu comme ce foie.</translation>
    </message>
    <message>
        <source>The registration was refused: what is known contradicts it.</source>
        <translation>Le recalage a été refusé : ce que l&apos;on sait le contredit.</translation>
    </message>
    <message>
        <source>The registration was refused, and somebody uses it nevertheless.</source>
        <translation>Le recalage a été refusé, et quelqu&apos;un l&apos;utilise malgré tout.</translation>
    </message>
    <message>
        <source>The model has no vena cava: nothing says where the organ is held. Let the atlas propose it.</source>
        <translation>Le modèle n&apos;a pas de veine cave : rien ne dit où l&apos;organe est tenu. Laissez l&apos;atlas la proposer.</translation>
    </message>
    <message>
        <source>Where the organ is held (vena cava) comes from statistics alone, with a deviation of %1 mm.</source>
        <translation>L&apos;endroit où l&apos;organe est tenu (veine cave) vient de la seule statistique, avec un écart-type de %1 mm.</translation>
    </message>
    <message>
        <source>The umbilical notch comes from statistics alone, with a deviation of %1 mm.</source>
        <translation>L&apos;incisure ombilicale ne vient que de la statistique, avec un écart de %1 mm.</translation>
    </message>
    <message>
        <source>%1 % of the anterior margin that the registration uses come from statistics alone.</source>
        <translation>%1 % du bord antérieur que le recalage utilise proviennent de la seule statistique.</translation>
    </message>
    <message>
        <source>%1 % of the proposed anterior margin come from statistics alone: the registration does not use them.</source>
        <translation>%1 % du bord antérieur proposé ne viennent que de la statistique : le recalage ne les utilise pas.</translation>
    </message>
    <message>
        <source>This liver&apos;s shape is %1 times as unusual as the atlas knows: the proposals are uncertain.</source>
        <translation>La forme de ce foie est %1 fois plus inhabituelle que ce que l&apos;atlas connaît : les propositions sont incertaines.</translation>
    </message>
    <message>
        <source>This liver&apos;s size lies %1 deviations from the atlas&apos; mean: the proposals are uncertain.</source>
        <translation>La taille de ce foie est à %1 écarts-types de la moyenne de l&apos;atlas : les propositions sont incertaines.</translation>
    </message>
    <message>
        <source>The atlas does not fit this liver: %1 mm apart on average.</source>
        <translation>L&apos;atlas ne s&apos;ajuste pas à ce foie : %1 mm d&apos;écart en moyenne.</translation>
    </message>
    <message>
        <source>The atlas is folded on this liver (%1 % of its surface).</source>
        <translation>L&apos;atlas est replié sur ce foie (%1 % de sa surface).</translation>
    </message>
    <message>
        <source>This liver is turned by %1° against the atlas: check how the patient lies.</source>
        <translation>Ce foie est tourné de %1° par rapport à l&apos;atlas : vérifiez la position du patient.</translation>
    </message>
    <message>
        <source>This is not the shape of a whole liver: a part is missing, it is much changed, or left and right are mixed up.</source>
        <translation>Ce n&apos;est pas la forme d&apos;un foie entier : une partie manque, il est très modifié, ou la gauche et la droite sont interverties.</translation>
    </message>
    <message>
        <source>The mirror image of this liver fits the atlas nearly as well: check left and right.</source>
        <translation>L&apos;image en miroir de ce foie s&apos;ajuste presque aussi bien à l&apos;atlas : vérifiez la gauche et la droite.</translation>
    </message>
    <message>
        <source>The liver&apos;s surface is open: the proposals are uncertain.</source>
        <translation>La surface du foie est ouverte : les propositions sont incertaines.</translation>
    </message>
    <message>
        <source>The liver&apos;s surface has %1 pieces; the largest was taken.</source>
        <translation>La surface du foie a %1 morceaux ; le plus grand a été pris.</translation>
    </message>
    <message>
        <source>%1: the image shows it %2 mm from where the atlas expects it. Check the segmentation.</source>
        <translation>%1 : l&apos;image le montre à %2 mm de là où l&apos;atlas l&apos;attend. Vérifiez la segmentation.</translation>
    </message>
    <message>
        <source>%1: by the portal vein it lies %2 mm from where it was placed by hand. Check both.</source>
        <translation>%1 : d&apos;après la veine porte, elle se trouve à %2 mm de l&apos;endroit où elle a été placée à la main. Vérifiez les deux.</translation>
    </message>
    <message>
        <source>This atlas does not know how one landmark depends on another: none follows what was placed by hand.</source>
        <translation>Cet atlas ne sait pas comment les repères dépendent les uns des autres : aucun ne suit ce qui a été placé à la main.</translation>
    </message>
    <message>
        <source>The segmented portal vein does not show the umbilical part of its left branch: notch and falciform ligament come from statistics. Is the left branch there?</source>
        <translation>La veine porte segmentée ne montre pas la partie ombilicale de sa branche gauche : lbranche gauche : l&apos;incisure etapos;échancrure et le ligament falciforme viennent de la statistique. La branche gauche est-elle là ?</translation>
    </message>
    <message>
        <source>What looks like the portal vein&apos;s umbilical part does not lie where it should, and was not used for the notch: check that portal and hepatic veins are not swapped, and whether the round ligament lies on the right.</source>
        <translation>Ce qui ressemble à la partie ombilicale de la veine porte n&apos;est pas là où elle devrait être et n&apos;a pas servi pour lpas servi pour l&apos;incisure :apos;échancrure : vérifiez que veine porte et veines hépatiques ne sont pas interverties, et si le ligament rond est à droite.</translation>
    </message>
    <message>
        <source>The liver %1 differs from the others and counts less.</source>
        <translation>Le foie %1 diffère des autres et compte moins.</translation>
    </message>
    <message>
        <source>%1: too few livers show it, so that the atlas does not know it.</source>
        <translation>%1 : trop peu de foies le montrent, l&apos;atlas ne le connaît donc pas.</translation>
    </message>
    <message>
        <source>%1: too few livers show it; taken over from the atlas &apos;%2&apos;.</source>
        <translation>%1 : trop peu de foies le montrent ; repris de l&apos;atlas « %2 ».</translation>
    </message>
    <message>
        <source>The image ends inside the liver: %1 cm² of its surface are a cut and no surface. Take a whole CT, or register nothing of what lies there.</source>
        <translation>L&apos;image s&apos;arrête dans le foie : %1 cm² de sa surface sont une coupe et non une surface. Prenez un scanner entier, ou ne recalez rien de ce qui s&apos;y trouve.</translation>
    </message>
    <message>
        <source>Something denser than any bone, as metal is, lies in %1 slices of the liver or next to them: its streaks may have taken liver away or added to it. Check these slices.</source>
        <translation>Quelque chose de plus dense que tout os, comme du métal, est dans %1 coupes du foie ou à côté : ses stries ont peut-être enlevé ou ajouté du foie. Vérifiez ces coupes.</translation>
    </message>
    <message>
        <source>Points of the cloud that were there twice were left out: %1.</source>
        <translation>Des points en double du nuage ont été écartés : %1.</translation>
    </message>
    <message>
        <source>Normals of the cloud that faced away from the camera were turned: %1. It saw the side that faces it.</source>
        <translation>Des normales du nuage de points qui se détournaient de la caméra ont été retournées : %1. Elle a vu le côté qui lui fait face.</translation>
    </message>
    <message>
        <source>Points of the cloud at the lens itself were left out: %1. Such a point has no depth.</source>
        <translation>Des points du nuage situés à l&apos;objectif même ont été écartés : %1. Un tel point n&apos;a pas de profondeur.</translation>
    </message>
    <message>
        <source>Points of the cloud that lie behind the camera: %1. The organ is registered to them, but no picture shows it there. If they are from OpenGL or VTK, turn them by 180° about x.</source>
        <translation>Points du nuage situés derrière la caméra : %1. L&apos;organe est recalé sur eux, mais aucune image ne l&apos;y montre. S&apos;ils viennent d&apos;OpenGL ou de VTK, tournez-les de 180° autour de x.</translation>
    </message>
    <message>
        <source>The organ would have to be larger or smaller by %1 % (limit %2 %) to fit the points: check the calibration (distance of the cameras, zoom) and the unit of the cloud.</source>
        <translation>L&apos;organe devrait être plus grand ou plus petit de %1 % (limite : %2 %) pour correspondre aux points : vérifiez l&apos;étalonnage (distance des caméras, zoom) et l&apos;unité du nuage.</translation>
    </message>
    <message>
        <source>The CT ends inside the liver (%1 cm² are a cut): there the model has a surface that the organ has not.</source>
        <translation>Le scanner s&apos;arrête dans le foie (%1 cm² sont une coupe) : le modèle y a une surface que l&apos;organe n&apos;a pas.</translation>
    </message>
    <message>
        <source>The organ is expected to be off by %1 mm on average (limit %2 mm).</source>
        <translation>L&apos;organe est sans doute décalé de %1 mm en moyenne (limite : %2 mm).</translation>
    </message>
    <message>
        <source>%1 is expected to be off by %2 mm on average (limit %3 mm).</source>
        <translation>%1 : décalage attendu de %2 mm en moyenne (limite : %3 mm).</translation>
    </message>
    <message>
        <source>%1 % of the points face another way than the model there (limit %2 %).</source>
        <translation>%1 % des points sont tournés autrement que le modèle à cet endroit (limite : %2 %).</translation>
    </message>
    <message>
        <source>The marked margin lies %1 mm from the model&apos;s (limit %2 mm).</source>
        <translation>Le bord marqué est à %1 mm de celui du modèle (limite : %2 mm).</translation>
    </message>
    <message>
        <source>The organ would be bent %1 times as much as operations and tools explain (limit %2).</source>
        <translation>L&apos;organe serait déformé %1 fois plus que les opérations et les instruments ne l&apos;expliquent (limite : %2).</translation>
    </message>
    <message>
        <source>%1 was not found: nothing at its seeds differs from the liver. What there was of it stays. Drag across it in a slice to tell its diameter, or paint it.</source>
        <translation>%1 n’a pas été trouvée : rien à ses graines ne diffère du foie. Ce qui en existait reste. Faites glisser à travers elle dans une coupe pour indiquer son diamètre, ou peignez-la.</translation>
    </message>
    <message>
        <source>%1: of its seeds, %2 had no effect. Nothing there differs from the liver, and what the others found does not reach there. Paint what is missing.</source>
        <translation>%1 : de ses graines, %2 sont restées sans effet. Rien n’y diffère du foie, et ce que les autres ont trouvé n’atteint pas ces endroits. Peignez ce qui manque.</translation>
    </message>
    <message>
        <source>The points are explained by %1 forces of tools (limit %2): by so many nearly anything is.</source>
        <translation>Les points sont expliqués par %1 forces d’outils (limite %2) : avec autant, presque tout s’explique.</translation>
    </message>
    <message>
        <source>A person has chosen this place among several; the points alone gave it %1 %.</source>
        <translation>Une personne a choisi cette position parmi plusieurs ; les points seuls lui donnaient %1 %.</translation>
    </message>
    <message>
        <source>%1 is brighter than the liver: a vein, or a lesion that takes up contrast. Check it in the slices.</source>
        <translation>%1 est plus clair que le foie : une veine, ou une lésion qui prend le contraste. À vérifier dans les coupes.</translation>
    </message>
    <message>
        <source>%1 is brighter than the liver, and a vein goes on at %2 % of its surface: it may be a piece of that vein. Check it in the slices.</source>
        <translation>%1 est plus clair que le foie, et une veine continue à %2 % de sa surface : ce peut être un morceau de cette veine. À vérifier dans les coupes.</translation>
    </message>
    <message>
        <source>%1: no border was found where its diameter was drawn. It is a ball of that diameter: check it in the slices.</source>
        <translation>%1 : aucun bord n’a été trouvé là où le diamètre a été tracé. C’est une boule de ce diamètre : à vérifier dans les coupes.</translation>
    </message>
    <message>
        <source>The image shows no vessel on the way: it was made as thin as can be. Check it in the slices.</source>
        <translation>L&apos;image ne montre aucun vaisseau sur le chemin : il a été fait aussi fin que possible. Vérifiez-le dans les coupes.</translation>
    </message>
    <message>
        <source>On %1 % of the way the image shows no radius: it was taken from the rest. Check it there.</source>
        <translation>Sur %1 % du chemin, l&apos;image ne montre pas de rayon : il a été repris du reste. Vérifiez-le à cet endroit.</translation>
    </message>
    <message>
        <source>A file of the case was changed outside of Glisson since it was saved: %*. Check what it holds.</source>
        <translation>Un fichier du cas a été modifié hors de Glisson depuis l’enregistrement : %*. Vérifiez ce qu’il contient.</translation>
    </message>
    <message>
        <source>The seeds in the liver are a proposal: look at what is segmented from them, slice by slice.</source>
        <translation>Les germes dans le foie sont une proposition : regardez coupe par coupe ce qui en est segmenté.</translation>
    </message>
    <message>
        <source>By this calibration %1 % of the left picture, from its edges on, has no ray: nothing is drawn there, and points there are wrong. Calibrate with boards in the corners, too, and without k3.</source>
        <translation>D&apos;après cet étalonnage, %1 % de l&apos;image gauche, à partir de ses bords, n&apos;ont pas de rayon : rien n&apos;y est dessiné, et les points y sont faux. Étalonnez aussi avec des mires dans les coins, et sans k3.</translation>
    </message>
    <message>
        <source>By this calibration %1 % of the right picture, from its edges on, has no ray: points there are wrong. Calibrate with boards in the corners, too, and without k3.</source>
        <translation>D&apos;après cet étalonnage, %1 % de l&apos;image droite, à partir de ses bords, n&apos;ont pas de rayon : les points y sont faux. Étalonnez aussi avec des mires dans les coins, et sans k3.</translation>
    </message>
    <message>
        <source>The DICOMDIR names files that are not there: slices may be missing. Copy the whole medium. (%*)</source>
        <translation>Le DICOMDIR nomme des fichiers absents : des coupes peuvent manquer. Copiez tout le support. (%*)</translation>
    </message>
    <message>
        <source>%1: one more look helps most at %2. Expected error then %4 mm instead of %3 mm.</source>
        <translation>%1 : un regard de plus sur %2 aide le plus. Erreur attendue ensuite %4 mm au lieu de %3 mm.</translation>
    </message>
    <message>
        <source>%1: mark the anterior margin where it is seen. Expected error then %3 mm instead of %2 mm.</source>
        <translation>%1 : marquez le bord antérieur là où il est visible. Erreur attendue ensuite %3 mm au lieu de %2 mm.</translation>
    </message>
    <message>
        <source>%1: mark the umbilical notch, which is seen. Expected error then %3 mm instead of %2 mm.</source>
        <translation>%1 : marquez l’échancrure ombilicale, qui est visible. Erreur attendue ensuite %3 mm au lieu de %2 mm.</translation>
    </message>
    <message>
        <source>the left lobe&apos;s dome</source>
        <translation>le dôme du lobe gauche</translation>
    </message>
    <message>
        <source>the left lobe&apos;s underside</source>
        <translation>la face inférieure du lobe gauche</translation>
    </message>
    <message>
        <source>the left lobe&apos;s front</source>
        <translation>l’avant du lobe gauche</translation>
    </message>
    <message>
        <source>the left lobe&apos;s side</source>
        <translation>le côté du lobe gauche</translation>
    </message>
    <message>
        <source>the left lobe&apos;s back</source>
        <translation>l’arrière du lobe gauche</translation>
    </message>
    <message>
        <source>the right lobe&apos;s dome</source>
        <translation>le dôme du lobe droit</translation>
    </message>
    <message>
        <source>the right lobe&apos;s underside</source>
        <translation>la face inférieure du lobe droit</translation>
    </message>
    <message>
        <source>the right lobe&apos;s front</source>
        <translation>l’avant du lobe droit</translation>
    </message>
    <message>
        <source>the right lobe&apos;s side</source>
        <translation>le côté du lobe droit</translation>
    </message>
    <message>
        <source>the right lobe&apos;s back</source>
        <translation>l’arrière du lobe droit</translation>
    </message>
    <message>
        <source>the liver&apos;s dome</source>
        <translation>le dôme du foie</translation>
    </message>
    <message>
        <source>the liver&apos;s underside</source>
        <translation>la face inférieure du foie</translation>
    </message>
    <message>
        <source>the liver&apos;s front</source>
        <translation>l’avant du foie</translation>
    </message>
    <message>
        <source>the liver&apos;s side</source>
        <translation>le côté du foie</translation>
    </message>
    <message>
        <source>the liver&apos;s back</source>
        <translation>l’arrière du foie</translation>
    </message>
    <message>
        <source>Pieces too small for a lesion became parenchyma: %1.</source>
        <translation>Des morceaux trop petits pour une lésion sont devenus parenchyme : %1.</translation>
    </message>
    <message>
        <source>The segmentation names another DICOM frame of reference than the CT, as one of another scan does: check in the slices that it lies on this liver.</source>
        <translation>La segmentation nomme un autre repère de référence DICOM que le scanner, comme celle d’un autre examen : vérifiez dans les coupes qu’elle recouvre bien ce foie.</translation>
    </message>
    <message>
        <source>Segments that the file does not say to be anything of the liver were left out: %*.</source>
        <translation>Des segments dont le fichier ne dit pas qu’ils relèvent du foie ont été laissés de côté : %*.</translation>
    </message>
    <message>
        <source>Labels of which the codes say nothing were left out: %*.</source>
        <translation>Des étiquettes dont les codes ne disent rien ont été laissées de côté : %*.</translation>
    </message>
    <message>
        <source>No label was free for the smallest pieces of %1: %2 stayed with it.</source>
        <translation>Aucune étiquette n’était libre pour les plus petits morceaux de %1 : %2 y sont restés.</translation>
    </message>
    <message>
        <source>%1 lay in %2 pieces more than 5 mm apart: each is a lesion of its own now.</source>
        <translation>%1 était en %2 morceaux distants de plus de 5 mm : chacun est désormais une lésion à part.</translation>
    </message>
    <message>
        <source>%1 lies in %2 pieces more than 5 mm apart, and is judged as one, at the middle of all. Split it into islands and build the model again.</source>
        <translation>%1 est en %2 morceaux distants de plus de 5 mm, et jugée comme une seule, au milieu de tous. Divisez-la en îlots et reconstruisez le modèle.</translation>
    </message>
    <message>
        <source>The mesh does not say what its labels mean. They were taken as Glisson&apos;s own: %*. If they mean something else, write Glisson&apos;s into it: 1 is the parenchyma, 16 the first lesion.</source>
        <translation>Le maillage ne dit pas ce que signifient ses labels. Ils ont été pris pour ceux de Glisson : %*. S’ils signifient autre chose, écrivez-y ceux de Glisson : 1 est le parenchyme, 16 la première lésion.</translation>
    </message>
    <message>
        <source>The file does not say what its numbers mean. They were taken as Glisson&apos;s own: %*. If they mean something else, import it again by &apos;glisson model --labels FILE --codes FILE&apos;.</source>
        <translation>Le fichier ne dit pas ce que signifient ses nombres. Ils ont été pris pour ceux de Glisson : %*. S’ils signifient autre chose, réimportez-le par « glisson model --labels FICHIER --codes FICHIER ».</translation>
    </message>
    <message>
        <source>With a probability of %1 % (limit %2 %) the organ lies more than 2 cm from here: other places explain the points as well. Mark the notch, show more of the organ, keep this look and add another one, or place it by hand.</source>
        <translation>Avec une probabilité de %1 % (limite %2 %), l’organe se trouve à plus de 2 cm d’ici : d’autres positions expliquent aussi les points. Marquez l’échancrure, montrez davantage de l’organe, gardez cette vue et ajoutez-en une autre, ou placez-le à la main.</translation>
    </message>
    <message>
        <source>%1: nobody has reviewed what is proposed.</source>
        <translation>%1 : personne n&apos;a vérifié ce qui est proposé.</translation>
    </message>
    <message>
        <source>%1: what was placed by hand is used instead of the proposal. Clear it to use the proposal.</source>
        <translation>%1 : ce qui a été placé à la main est utilisé au lieu de la proposition. Effacez-le pour utiliser la proposition.</translation>
    </message>
    <message>
        <source>With a probability of %1 % (limit %2 %) the organ has moved or been bent between the looks: no one shape explains them. Forget the earlier looks and register with the present points alone.</source>
        <translation>Avec une probabilité de %1 % (limite %2 %), l’organe a bougé ou s’est déformé entre les vues : aucune forme unique ne les explique. Oubliez les vues antérieures et recalez avec les seuls points présents.</translation>
    </message>
    <message>
        <source>The case was opened without the operations that were simulated on its model: the next registration simulates them anew. (%*)</source>
        <translation>Le cas a été ouvert sans les opérations simulées sur son modèle : le prochain recalage les simulera à nouveau. (%*)</translation>
    </message>
    <message>
        <source>The case %1 was left out: nobody has approved its liver, vena cava, gallbladder or portal vein.</source>
        <translation>Le cas %1 a été laissé de côté : personne n&apos;a approuvé son foie, sa veine cave, sa vésicule ou sa veine porte.</translation>
    </message>
    <message>
        <source>%1 has no elements of its own: its stiffness changes nothing. Build the model finer at lesions.</source>
        <translation>%1 n&apos;a pas d&apos;éléments propres : sa raideur ne change rien. Construisez le modèle plus fin aux lésions.</translation>
    </message>
    <message>
        <source>The former registration could not be read and was left out (%*).</source>
        <translation>Le recalage précédent n&apos;a pas pu être lu et a été laissé de côté (%*).</translation>
    </message>
    <message>
        <source>%1 is no lesion of this model: what is said of its stiffness is left out.</source>
        <translation>%1 n&apos;est pas une lésion de ce modèle : ce qui est dit de sa raideur est omis.</translation>
    </message>
    <message>
        <source>%1 ml of the hepatic veins lie outside of the liver: they have grown on into the vena cava. Click the vena cava, too, and segment again.</source>
        <translation>%1 ml des veines hépatiques sont hors du foie : elles se sont étendues dans la veine cave. Cliquez aussi la veine cave et segmentez de nouveau.</translation>
    </message>
    <message>
        <source>No vena cava was found at its seeds: what there was stays.</source>
        <translation>Aucune veine cave n&apos;a été trouvée à ses points : ce qui existait reste.</translation>
    </message>
    <message>
        <source>The gallbladder has %1 ml, more than a full one mostly has: it may have run on into a cyst, fluid or bowel beside it. Check it in the slices.</source>
        <translation>La vésicule a %1 ml, plus que n’en a d’ordinaire une vésicule pleine : elle a peut-être débordé dans un kyste, du liquide ou de l’intestin voisin. Vérifiez-la dans les coupes.</translation>
    </message>
    <message>
        <source>Only %1 ml of the vena cava were found: its seeds may lie in a clot or tumour. Click it elsewhere, too, and segment again.</source>
        <translation>Seuls %1 ml de la veine cave ont été trouvés : ses germes sont peut-être dans un caillot ou une tumeur. Cliquez-la ailleurs aussi et segmentez à nouveau.</translation>
    </message>
    <message>
        <source>%1 ml of the hepatic veins lie outside of the liver: perhaps in a part of the vena cava that its seeds did not find. Click the vena cava there, too, and segment again.</source>
        <translation>%1 ml des veines hépatiques sont en dehors du foie : peut-être dans une partie de la veine cave que ses germes n’ont pas trouvée. Cliquez la veine cave là aussi et segmentez à nouveau.</translation>
    </message>
    <message>
        <source>No gallbladder was found at its seeds: what there was stays.</source>
        <translation>Aucune vésicule biliaire n&apos;a été trouvée à ses points : ce qui existait reste.</translation>
    </message>
    <message>
        <source>The liver lies to the left of the vena cava: left and right may be swapped in the image.</source>
        <translation>Le foie est à gauche de la veine cave : gauche et droite sont peut-être inversées dans l&apos;image.</translation>
    </message>
    <message>
        <source>By its shape this liver fits the atlas clearly better with %1 exchanged. Check in the slices, or where the file comes from, that it lies on the patient&apos;s right and its dome towards the head. If not, correct the orientation in the file&apos;s header (surfaces: export them in LPS) and import it again.</source>
        <translation>D&apos;après sa forme, ce foie correspond nettement mieux à l&apos;atlas avec une inversion : %1. Vérifiez dans les coupes, ou à l&apos;origine du fichier, qu&apos;il est à droite du patient et son dôme vers la tête. Sinon, corrigez l&apos;orientation dans l&apos;en-tête du fichier (surfaces : exportez-les en LPS) et importez-le de nouveau.</translation>
    </message>
    <message>
        <source>left and right</source>
        <translation>gauche et droite</translation>
    </message>
    <message>
        <source>front and back</source>
        <translation>avant et arrière</translation>
    </message>
    <message>
        <source>head and feet</source>
        <translation>tête et pieds</translation>
    </message>
    <message>
        <source>left and right, front and back (as between RAS and LPS)</source>
        <translation>gauche et droite, avant et arrière (comme entre RAS et LPS)</translation>
    </message>
    <message>
        <source>left and right, head and feet</source>
        <translation>gauche et droite, tête et pieds</translation>
    </message>
    <message>
        <source>front and back, head and feet</source>
        <translation>avant et arrière, tête et pieds</translation>
    </message>
    <message>
        <source>left and right, front and back, head and feet</source>
        <translation>gauche et droite, avant et arrière, tête et pieds</translation>
    </message>
    <message>
        <source>%1 goes on as far as a click looks for its border, and perhaps farther: draw its diameter.</source>
        <translation>%1 va aussi loin qu&apos;un clic cherche son bord, et peut-être plus loin : dessinez son diamètre.</translation>
    </message>
    <message>
        <source>%1 comes within %2 mm of the liver&apos;s surface, where the CT does not show its border: whether liver covers it is not known. Check it in the slices.</source>
        <translation>%1 arrive à moins de %2 mm de la surface du foie, là où le scanner ne montre pas son bord : on ne sait pas si du foie la recouvre. Vérifiez-la dans les coupes.</translation>
    </message>
    <message>
        <source>The portal vein is hardly brighter than the liver where it was clicked: in this phase it cannot be told from it, and most or all of it is missing. Take the portal venous phase.</source>
        <translation>La veine porte est à peine plus claire que le foie là où elle a été cliquée : à cette phase, on ne peut l’en distinguer, et elle manque en grande partie ou entièrement. Prenez la phase portale.</translation>
    </message>
    <message>
        <source>The hepatic veins are hardly brighter than the liver where they were clicked: in this phase they cannot be told from it, and most or all of them are missing. Take the portal venous phase.</source>
        <translation>Les veines hépatiques sont à peine plus claires que le foie là où elles ont été cliquées : à cette phase, on ne peut les en distinguer, et elles manquent en grande partie ou entièrement. Prenez la phase portale.</translation>
    </message>
    <message>
        <source>Portal vein seed %1 had no effect: no branch of it was found within 5 mm. Click in the middle of the vein, or take the seed away.</source>
        <translation>Le germe %1 de la veine porte n’a eu aucun effet : aucune de ses branches n’a été trouvée à moins de 5 mm. Cliquez au milieu de la veine, ou retirez le germe.</translation>
    </message>
    <message>
        <source>Hepatic vein seed %1 had no effect: no branch of them was found within 5 mm. Click in the middle of a vein, or take the seed away.</source>
        <translation>Le germe %1 des veines hépatiques n’a eu aucun effet : aucune de leurs branches n’a été trouvée à moins de 5 mm. Cliquez au milieu d’une veine, ou retirez le germe.</translation>
    </message>
    <message>
        <source>The case was opened without a kept moment, which cannot be read. The others are there. Saved now, the case loses what is left of it. (%*)</source>
        <translation>Le cas a été ouvert sans un instant conservé, qui ne peut pas être lu. Les autres sont là. Enregistré maintenant, le cas perd ce qu&apos;il en reste. (%*)</translation>
    </message>
    <message>
        <source>The written file&apos;s format holds places only, none of these doubts: name it .vtp or .vtk and they go along.</source>
        <translation>Le format du fichier écrit ne contient que des positions, aucun de ces doutes : nommé .vtp ou .vtk, il les emporte.</translation>
    </message>
</context>
<context>
    <name>Obstacles</name>
    <message>
        <source>Open a CT first.</source>
        <translation>Ouvrez d&apos;abord un scanner.</translation>
    </message>
    <message>
        <source>Place at least one seed in the liver.</source>
        <translation>Placez au moins un germe dans le foie.</translation>
    </message>
    <message>
        <source>Segment the CT or import labels first.</source>
        <translation>Segmentez d&apos;abord le scanner ou importez des étiquettes.</translation>
    </message>
    <message>
        <source>Build a model first.</source>
        <translation>Construisez d&apos;abord un modèle.</translation>
    </message>
    <message>
        <source>Place or accept the landmarks first.</source>
        <translation>Placez ou acceptez d’abord les repères.</translation>
    </message>
    <message>
        <source>Load the laparoscope&apos;s calibration first.</source>
        <translation>Chargez d&apos;abord l&apos;étalonnage du laparoscope.</translation>
    </message>
    <message>
        <source>The case has no stereo video (Stereo, Video…).</source>
        <translation>Le cas n&apos;a pas de vidéo stéréo (Stéréo, Vidéo…).</translation>
    </message>
    <message>
        <source>The case names no pictures that nobody here has chosen.</source>
        <translation>Le cas ne désigne aucune image que personne n’a choisie ici.</translation>
    </message>
    <message>
        <source>Load a stereo pair or a video frame first.</source>
        <translation>Chargez d&apos;abord une paire stéréo ou une image de vidéo.</translation>
    </message>
    <message>
        <source>Reconstruct the surface first (Stereo).</source>
        <translation>Reconstruisez d&apos;abord la surface (Stéréo).</translation>
    </message>
    <message>
        <source>Register first.</source>
        <translation>Recalez d&apos;abord.</translation>
    </message>
    <message>
        <source>The labels are out of date: segment or import them again (Segmentation).</source>
        <translation>Les étiquettes sont périmées : segmentez ou importez-les de nouveau (Segmentation).</translation>
    </message>
    <message>
        <source>The model is out of date: build it again (Model).</source>
        <translation>Le modèle est périmé : reconstruisez-le (Modèle).</translation>
    </message>
    <message>
        <source>The model is another one than was checked: look at it again (Model).</source>
        <translation>Le modèle n’est plus celui qui a été vérifié : regardez-le de nouveau (Modèle).</translation>
    </message>
    <message>
        <source>The landmarks are those of another model: look at them and accept them (Landmarks).</source>
        <translation>Les repères sont ceux d’un autre modèle : vérifiez-les et acceptez-les (Repères).</translation>
    </message>
    <message>
        <source>The frame is of a former video: take one of the present video (Stereo).</source>
        <translation>L’image vient d’une vidéo précédente : prenez-en une de la vidéo actuelle (Stéréo).</translation>
    </message>
    <message>
        <source>The regions are those of another frame: draw them again or clear them (Stereo).</source>
        <translation>Les régions sont celles d’une autre image : redessinez-les ou effacez-les (Stéréo).</translation>
    </message>
    <message>
        <source>The points are out of date: reconstruct the surface again (Stereo).</source>
        <translation>Les points sont périmés : reconstruisez la surface (Stéréo).</translation>
    </message>
    <message>
        <source>The registration is out of date: register again.</source>
        <translation>Le recalage est périmé : recalez de nouveau.</translation>
    </message>
    <message>
        <source>There is no %1 yet.</source>
        <translation>Pas encore là : %1.</translation>
    </message>
    <message>
        <source>%1 is out of date: make it anew.</source>
        <translation>Périmé : %1. À refaire.</translation>
    </message>
    <message>
        <source>Let the atlas propose the landmarks first.</source>
        <translation>Laissez d&apos;abord l&apos;atlas proposer les repères.</translation>
    </message>
    <message>
        <source>The proposed landmarks are those of another model: let the atlas propose them again.</source>
        <translation>Les repères proposés sont ceux d&apos;un autre modèle : laissez l&apos;atlas les proposer à nouveau.</translation>
    </message>
    <message>
        <source>Draw regions on the frame first (Stereo).</source>
        <translation>Tracez d’abord des régions sur l’image (Stéréo).</translation>
    </message>
    <message>
        <source>Look at the model and say whether it is right first (Model).</source>
        <translation>Examinez d’abord le modèle et dites s’il est juste (Modèle).</translation>
    </message>
    <message>
        <source>Review the labels first (Segmentation).</source>
        <translation>Vérifiez d’abord les étiquettes (Segmentation).</translation>
    </message>
    <message>
        <source>The registration was refused: register again, or use it nevertheless (see its doubts).</source>
        <translation>Le recalage a été refusé : recalez de nouveau, ou utilisez-le malgré tout (voir ses doutes).</translation>
    </message>
    <message>
        <source>%1 was refused: make it anew, or accept it.</source>
        <translation>%1 a été refusé : refaites-le ou acceptez-le.</translation>
    </message>
    <message>
        <source>The seeds are those of another CT: place them again (Segmentation).</source>
        <translation>Les germes sont ceux d’un autre scanner : placez-les de nouveau (Segmentation).</translation>
    </message>
    <message>
        <source>The CT was not opened from its DICOM folder, so whose it is is not known.</source>
        <translation>Le scanner n’a pas été ouvert depuis son dossier DICOM : on ne sait pas de qui il est.</translation>
    </message>
    <message>
        <source>No new segmentation waits for a decision.</source>
        <translation>Aucune nouvelle segmentation n&apos;attend de décision.</translation>
    </message>
    <message>
        <source>No earlier look is kept (Stereo).</source>
        <translation>Aucune vue antérieure n’est gardée (Stéréo).</translation>
    </message>
    <message>
        <source>There is no former registration to go back to.</source>
        <translation>Il n&apos;y a pas de recalage précédent auquel revenir.</translation>
    </message>
    <message>
        <source>Nobody has said how stiff the liver is (Model).</source>
        <translation>Personne n&apos;a dit quelle est la raideur du foie (Modèle).</translation>
    </message>
    <message>
        <source>No operations have been simulated on this model: register it.</source>
        <translation>Aucune opération n’a été simulée sur ce modèle : recalez-le.</translation>
    </message>
    <message>
        <source>No moment of the live view is kept (Guidance).</source>
        <translation>Aucun instant de la vue en direct n&apos;est conservé (Guidage).</translation>
    </message>
    <message>
        <source>The organ is followed from the place it has now: stop tracking first.</source>
        <translation>L&apos;organe est suivi depuis sa position actuelle : arrêtez d&apos;abord le suivi.</translation>
    </message>
    <message>
        <source>Nothing is locked (Segmentation).</source>
        <translation>Rien n’est verrouillé (Segmentation).</translation>
    </message>
</context>
<context>
    <name>Overlay</name>
    <message>
        <source>registered</source>
        <translation>recalé</translation>
    </message>
    <message>
        <source>not registered yet</source>
        <translation>pas encore recalé</translation>
    </message>
    <message>
        <source>too few points are tracked</source>
        <translation>trop peu de points sont suivis</translation>
    </message>
    <message>
        <source>the tracked points contradict one another</source>
        <translation>les points suivis se contredisent</translation>
    </message>
    <message>
        <source>the model does not fit what the camera sees</source>
        <translation>le modèle ne correspond pas à ce que voit la caméra</translation>
    </message>
    <message>
        <source>the mechanical computation failed</source>
        <translation>le calcul mécanique a échoué</translation>
    </message>
    <message>
        <source>an earlier step has changed since the registration</source>
        <translation>une étape antérieure a changé depuis le recalage</translation>
    </message>
    <message>
        <source>No overlay: %1</source>
        <translation>Pas de superposition : %1</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>image %1</translation>
    </message>
    <message>
        <source>age %1 ms</source>
        <translation>âge %1 ms</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation>%1 images/s</translation>
    </message>
    <message>
        <source>residual %1 mm</source>
        <translation>résidu %1 mm</translation>
    </message>
    <message>
        <source>Registration in doubt</source>
        <translation>Recalage douteux</translation>
    </message>
    <message>
        <source>Research software: not for clinical use</source>
        <translation>Logiciel de recherche : pas d&apos;usage clinique</translation>
    </message>
    <message>
        <source>Portal vein</source>
        <translation>Veine porte</translation>
    </message>
    <message>
        <source>Hepatic veins</source>
        <translation>Veines hépatiques</translation>
    </message>
    <message>
        <source>Hepatic artery</source>
        <translation>Artère hépatique</translation>
    </message>
    <message>
        <source>Lesion</source>
        <translation>Lésion</translation>
    </message>
    <message>
        <source>Model not checked</source>
        <translation>Modèle non vérifié</translation>
    </message>
    <message>
        <source>the camera sees the organ elsewhere; register again</source>
        <translation>la caméra voit l’organe ailleurs ; recaler à nouveau</translation>
    </message>
    <message>
        <source>the picture stands still; check the camera</source>
        <translation>l’image est figée ; vérifier la caméra</translation>
    </message>
    <message>
        <source>the two views do not show the same moment; check the cameras</source>
        <translation>les deux vues ne montrent pas le même instant ; vérifier les caméras</translation>
    </message>
    <message>
        <source>the camera sees the organ elsewhere</source>
        <translation>la caméra voit l&apos;organe ailleurs</translation>
    </message>
    <message>
        <source>the picture stands still</source>
        <translation>l&apos;image est figée</translation>
    </message>
    <message>
        <source>the two views do not fit together</source>
        <translation>les deux vues ne concordent pas</translation>
    </message>
    <message>
        <source>part of the organ is covered</source>
        <translation>une partie de l’organe est masquée</translation>
    </message>
    <message>
        <source>the picture has lost light or contrast</source>
        <translation>l’image a perdu de la lumière ou du contraste</translation>
    </message>
    <message>
        <source>nothing in the picture moves</source>
        <translation>rien ne bouge dans l’image</translation>
    </message>
    <message>
        <source>Outline and lesions&apos; regions only: %1</source>
        <translation>Contour et zones des lésions seulement : %1</translation>
    </message>
    <message>
        <source>known well enough</source>
        <translation>assez bien connue</translation>
    </message>
    <message>
        <source>as the whole overlay</source>
        <translation>comme toute la superposition</translation>
    </message>
    <message>
        <source>how far off it may be is not known; register again</source>
        <translation>on ignore de combien elle peut être décalée ; recalez de nouveau</translation>
    </message>
    <message>
        <source>the registration was refused</source>
        <translation>le recalage a été refusé</translation>
    </message>
    <message>
        <source>the registration does not know it better</source>
        <translation>le recalage ne le sait pas mieux</translation>
    </message>
    <message>
        <source>the organ has changed its shape, and what is tracked lies far away</source>
        <translation>l&apos;organe a changé de forme, et ce qui est suivi est loin</translation>
    </message>
    <message>
        <source>nothing near it has been tracked for a while</source>
        <translation>rien n&apos;a été suivi près d&apos;elle depuis un moment</translation>
    </message>
    <message>
        <source>Lesion %1</source>
        <translation>Lésion %1</translation>
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
        <translation>Profondeur selon la vue</translation>
    </message>
    <message>
        <source>Depth, shortest way</source>
        <translation>Profondeur, plus court chemin</translation>
    </message>
    <message>
        <source>Expected error</source>
        <translation>Erreur attendue</translation>
    </message>
    <message>
        <source>95 % within</source>
        <translation>95 % à moins de</translation>
    </message>
    <message>
        <source>From the mark</source>
        <translation>Depuis la marque</translation>
    </message>
    <message>
        <source>valid</source>
        <translation>valide</translation>
    </message>
    <message>
        <source>known roughly</source>
        <translation>connue approximativement</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnue</translation>
    </message>
    <message>
        <source>%1 not shown: %2</source>
        <translation>%1 non montrée : %2</translation>
    </message>
    <message>
        <source>%1 as its region only: %2</source>
        <translation>%1 seulement en zone : %2</translation>
    </message>
    <message>
        <source>VALID</source>
        <translation>VALIDE</translation>
    </message>
    <message>
        <source>DEGRADED</source>
        <translation>DÉGRADÉ</translation>
    </message>
    <message>
        <source>WITHDRAWN</source>
        <translation>RETIRÉ</translation>
    </message>
    <message>
        <source>Other lesions not known well enough: %1</source>
        <translation>Autres lésions pas assez bien connues : %1</translation>
    </message>
    <message>
        <source>Lines: every 10 mm below the surface</source>
        <translation>Lignes : tous les 10 mm sous la surface</translation>
    </message>
    <message>
        <source>only proposed, not registered</source>
        <translation>seulement proposé, non recalé</translation>
    </message>
    <message>
        <source>Outline and margin: %1</source>
        <translation>Contour et bord : %1</translation>
    </message>
    <message>
        <source>PROPOSED</source>
        <translation>PROPOSÉ</translation>
    </message>
    <message>
        <source>NOT LIVE</source>
        <translation>PAS EN DIRECT</translation>
    </message>
    <message>
        <source>the mask network takes most of the organ for something else</source>
        <translation>le réseau de masque prend la plus grande partie de l’organe pour autre chose</translation>
    </message>
    <message>
        <source>one of the two views shows nothing, or too little</source>
        <translation>l’une des deux vues ne montre rien, ou trop peu</translation>
    </message>
    <message>
        <source>left and right view seem to be swapped</source>
        <translation>les vues gauche et droite semblent inversées</translation>
    </message>
    <message>
        <source>too little can be made out in the picture</source>
        <translation>on distingue trop peu de choses dans l’image</translation>
    </message>
    <message>
        <source>Wipe the lens of that view; check its camera and cable.</source>
        <translation>Essuyez l’objectif de cette vue ; vérifiez sa caméra et son câble.</translation>
    </message>
    <message>
        <source>Check that the two cameras, or their videos, are in the right order.</source>
        <translation>Vérifiez que les deux caméras, ou leurs vidéos, sont dans le bon ordre.</translation>
    </message>
    <message>
        <source>Clear the smoke, wipe the lens, check lamp and focus.</source>
        <translation>Évacuez la fumée, essuyez l’objectif, vérifiez la lampe et la mise au point.</translation>
    </message>
    <message>
        <source>the mask network leaves too little of the organ</source>
        <translation>le réseau de masque laisse trop peu de l’organe</translation>
    </message>
    <message>
        <source>Landmarks not reviewed</source>
        <translation>Repères non vérifiés</translation>
    </message>
    <message>
        <source>Landmarks from statistics</source>
        <translation>Repères tirés de la statistique</translation>
    </message>
    <message>
        <source>Register the model to what the camera sees.</source>
        <translation>Recalez le modèle sur ce que voit la caméra.</translation>
    </message>
    <message>
        <source>Show the part of the organ that was seen when it was registered, free of smoke and tools.</source>
        <translation>Montrez la partie de l&apos;organe qui était vue lors du recalage, sans fumée ni instruments.</translation>
    </message>
    <message>
        <source>Show the part of the organ that was seen when it was registered, and hold still for a moment.</source>
        <translation>Montrez la partie de l&apos;organe qui était vue lors du recalage, sans bouger un instant.</translation>
    </message>
    <message>
        <source>Register again (R), or choose a new frame and register that.</source>
        <translation>Recalez de nouveau (R), ou choisissez une nouvelle image et recalez-la.</translation>
    </message>
    <message>
        <source>Start tracking again.</source>
        <translation>Relancez le suivi.</translation>
    </message>
    <message>
        <source>Run the steps again that are out of date, then register.</source>
        <translation>Refaites les étapes périmées, puis recalez.</translation>
    </message>
    <message>
        <source>Register again (R), or correct by hand (C).</source>
        <translation>Recalez de nouveau (R), ou corrigez à la main (C).</translation>
    </message>
    <message>
        <source>Check the camera and its cable.</source>
        <translation>Vérifiez la caméra et son câble.</translation>
    </message>
    <message>
        <source>Move the laparoscope a little, or wait for a breath.</source>
        <translation>Bougez un peu le laparoscope, ou attendez une respiration.</translation>
    </message>
    <message>
        <source>Check that both cameras run, in the right order, at the same time, and as they were calibrated.</source>
        <translation>Vérifiez que les deux caméras fonctionnent, dans le bon ordre, en même temps et telles qu’elles ont été calibrées.</translation>
    </message>
    <message>
        <source>Take away what covers it, or show another part of the organ.</source>
        <translation>Écartez ce qui le couvre, ou montrez une autre partie de l&apos;organe.</translation>
    </message>
    <message>
        <source>Clear the smoke, wipe the lens, check the lamp.</source>
        <translation>Évacuez la fumée, essuyez l&apos;optique, vérifiez la lampe.</translation>
    </message>
    <message>
        <source>Read its doubts, on the right; then register again, or use it nevertheless.</source>
        <translation>Lisez ses doutes, à droite ; puis recalez de nouveau, ou utilisez-le malgré tout.</translation>
    </message>
    <message>
        <source>Use this place, refine it, or put it back.</source>
        <translation>Prenez cette position, affinez-la, ou remettez l&apos;ancienne.</translation>
    </message>
    <message>
        <source>Show more of the organ; if the network is wrong, remove it.</source>
        <translation>Montrez davantage de l&apos;organe ; si le réseau se trompe, retirez-le.</translation>
    </message>
</context>
<context>
    <name>Review</name>
    <message>
        <source>Labels that nobody has reviewed: %1.</source>
        <translation>Labels que personne n’a vérifiés : %1.</translation>
    </message>
    <message>
        <source>Labels under review: %1.</source>
        <translation>Labels en cours de vérification : %1.</translation>
    </message>
    <message>
        <source>Labels still to be reviewed: %1.</source>
        <translation>Labels restant à vérifier : %1.</translation>
    </message>
</context>
<context>
    <name>SaveName</name>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>%1 is there already.</source>
        <translation>%1 existe déjà.</translation>
    </message>
    <message>
        <source>Replacing it deletes what it holds.</source>
        <translation>Le remplacer efface ce qu&apos;il contient.</translation>
    </message>
    <message>
        <source>In %1 there are already: %2.</source>
        <translation>%1 contient déjà : %2.</translation>
    </message>
    <message>
        <source>Replacing them deletes what they hold.</source>
        <translation>Les remplacer efface ce qu&apos;ils contiennent.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Remplacer</translation>
    </message>
</context>
<context>
    <name>SeriesTexts</name>
    <message>
        <source>derived from other images</source>
        <translation>dérivée d&apos;autres images</translation>
    </message>
    <message>
        <source>neither CT nor MR</source>
        <translation>ni CT ni IRM</translation>
    </message>
    <message>
        <source>few slices</source>
        <translation>peu de coupes</translation>
    </message>
    <message>
        <source>not axial</source>
        <translation>non axiale</translation>
    </message>
    <message>
        <source>reformatted</source>
        <translation>reformatée</translation>
    </message>
    <message>
        <source>screenshot or sheet</source>
        <translation>capture d&apos;écran ou feuille</translation>
    </message>
    <message>
        <source>scout (localizer)</source>
        <translation>image de repérage (localizer)</translation>
    </message>
    <message>
        <source>several frames in a file: cannot be read</source>
        <translation>plusieurs images dans un fichier : illisible</translation>
    </message>
    <message>
        <source>mask: two grey values only</source>
        <translation>masque : deux niveaux de gris seulement</translation>
    </message>
    <message>
        <source>no images (report, contours or segmentation)</source>
        <translation>pas d&apos;images (compte rendu, contours ou segmentation)</translation>
    </message>
    <message>
        <source>native</source>
        <translation>sans injection</translation>
    </message>
    <message>
        <source>arterial</source>
        <translation>artérielle</translation>
    </message>
    <message>
        <source>portal venous</source>
        <translation>portale</translation>
    </message>
    <message>
        <source>delayed</source>
        <translation>tardive</translation>
    </message>
    <message>
        <source>slices %1 mm thick</source>
        <translation>coupes de %1 mm d&apos;épaisseur</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1, slices %2 mm thick</source>
        <translation>%1, coupes de %2 mm d&apos;épaisseur</translation>
    </message>
    <message>
        <source>no description</source>
        <translation>sans description</translation>
    </message>
</context>
<context>
    <name>Texts</name>
    <message>
        <source>Reading the volume</source>
        <translation>Lecture du volume</translation>
    </message>
    <message>
        <source>Reading the labels</source>
        <translation>Lecture des étiquettes</translation>
    </message>
    <message>
        <source>Storing what the volume is</source>
        <translation>Enregistrement de la nature du volume</translation>
    </message>
    <message>
        <source>Storing the seeds</source>
        <translation>Enregistrement des germes</translation>
    </message>
    <message>
        <source>Segmenting</source>
        <translation>Segmentation</translation>
    </message>
    <message>
        <source>Building the model</source>
        <translation>Construction du modèle</translation>
    </message>
    <message>
        <source>Building the model from surfaces</source>
        <translation>Construction du modèle à partir de surfaces</translation>
    </message>
    <message>
        <source>Reading the mesh</source>
        <translation>Lecture du maillage</translation>
    </message>
    <message>
        <source>Storing the landmarks</source>
        <translation>Enregistrement des repères</translation>
    </message>
    <message>
        <source>Storing the stiffness</source>
        <translation>Enregistrement de la raideur</translation>
    </message>
    <message>
        <source>Going back to the former registration</source>
        <translation>Retour au recalage précédent</translation>
    </message>
    <message>
        <source>Reading the calibration</source>
        <translation>Lecture de l&apos;étalonnage</translation>
    </message>
    <message>
        <source>Reading the stereo pair</source>
        <translation>Lecture de la paire stéréo</translation>
    </message>
    <message>
        <source>Opening the video</source>
        <translation>Ouverture de la vidéo</translation>
    </message>
    <message>
        <source>Reading the video&apos;s frame</source>
        <translation>Lecture de l&apos;image de la vidéo</translation>
    </message>
    <message>
        <source>Storing the regions</source>
        <translation>Enregistrement des régions</translation>
    </message>
    <message>
        <source>Reconstructing the surface</source>
        <translation>Reconstruction de la surface</translation>
    </message>
    <message>
        <source>Reading the cloud</source>
        <translation>Lecture du nuage</translation>
    </message>
    <message>
        <source>Registering</source>
        <translation>Recalage</translation>
    </message>
    <message>
        <source>Reading the registration</source>
        <translation>Lecture du recalage</translation>
    </message>
    <message>
        <source>Starting the tracking</source>
        <translation>Démarrage du suivi</translation>
    </message>
    <message>
        <source>Stopping the tracking</source>
        <translation>Arrêt du suivi</translation>
    </message>
    <message>
        <source>Opening the case</source>
        <translation>Ouverture du cas</translation>
    </message>
    <message>
        <source>Saving the case</source>
        <translation>Enregistrement du cas</translation>
    </message>
    <message>
        <source>looking for the frame</source>
        <translation>recherche de l&apos;image</translation>
    </message>
    <message>
        <source>looking through the video</source>
        <translation>parcours de la vidéo</translation>
    </message>
    <message>
        <source>reading slices</source>
        <translation>lecture des coupes</translation>
    </message>
    <message>
        <source>unpacking</source>
        <translation>décompression</translation>
    </message>
    <message>
        <source>reading labels</source>
        <translation>lecture des étiquettes</translation>
    </message>
    <message>
        <source>reading the mesh</source>
        <translation>lecture du maillage</translation>
    </message>
    <message>
        <source>reading files</source>
        <translation>lecture des fichiers</translation>
    </message>
    <message>
        <source>writing files</source>
        <translation>écriture des fichiers</translation>
    </message>
    <message>
        <source>checking what was written</source>
        <translation>vérification de l&apos;écriture</translation>
    </message>
    <message>
        <source>saved</source>
        <translation>enregistré</translation>
    </message>
    <message>
        <source>preparing</source>
        <translation>préparation</translation>
    </message>
    <message>
        <source>growing from the seeds</source>
        <translation>croissance depuis les germes</translation>
    </message>
    <message>
        <source>fitting the liver&apos;s surface</source>
        <translation>ajustement de la surface du foie</translation>
    </message>
    <message>
        <source>growing the vessels</source>
        <translation>croissance des vaisseaux</translation>
    </message>
    <message>
        <source>cleaning up</source>
        <translation>nettoyage</translation>
    </message>
    <message>
        <source>looking around the click</source>
        <translation>examen autour du clic</translation>
    </message>
    <message>
        <source>making surfaces</source>
        <translation>création des surfaces</translation>
    </message>
    <message>
        <source>reading surfaces</source>
        <translation>lecture des surfaces</translation>
    </message>
    <message>
        <source>choosing the element size</source>
        <translation>choix de la taille des éléments</translation>
    </message>
    <message>
        <source>preparing the mesh</source>
        <translation>préparation du maillage</translation>
    </message>
    <message>
        <source>filling with elements</source>
        <translation>remplissage d&apos;éléments</translation>
    </message>
    <message>
        <source>improving the elements</source>
        <translation>amélioration des éléments</translation>
    </message>
    <message>
        <source>removing flat elements</source>
        <translation>élimination des éléments plats</translation>
    </message>
    <message>
        <source>finding vessel centrelines</source>
        <translation>recherche des lignes centrales</translation>
    </message>
    <message>
        <source>finding the anterior margin</source>
        <translation>recherche du bord antérieur</translation>
    </message>
    <message>
        <source>measuring the mesh</source>
        <translation>mesure du maillage</translation>
    </message>
    <message>
        <source>finding points</source>
        <translation>recherche de points</translation>
    </message>
    <message>
        <source>matching points</source>
        <translation>appariement des points</translation>
    </message>
    <message>
        <source>refining matches</source>
        <translation>affinage des appariements</translation>
    </message>
    <message>
        <source>fitting the surface</source>
        <translation>ajustement de la surface</translation>
    </message>
    <message>
        <source>finishing</source>
        <translation>finition</translation>
    </message>
    <message>
        <source>rigid start</source>
        <translation>départ rigide</translation>
    </message>
    <message>
        <source>elastic deformation</source>
        <translation>déformation élastique</translation>
    </message>
    <message>
        <source>contact forces</source>
        <translation>forces de contact</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Fond</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Foie</translation>
    </message>
    <message>
        <source>Portal vein</source>
        <translation>Veine porte</translation>
    </message>
    <message>
        <source>Hepatic veins</source>
        <translation>Veines hépatiques</translation>
    </message>
    <message>
        <source>Vena cava</source>
        <translation>Veine cave</translation>
    </message>
    <message>
        <source>Hepatic artery</source>
        <translation>Artère hépatique</translation>
    </message>
    <message>
        <source>Gallbladder</source>
        <translation>Vésicule biliaire</translation>
    </message>
    <message>
        <source>Lesion %1</source>
        <translation>Lésion %1</translation>
    </message>
    <message>
        <source>Not done</source>
        <translation>À faire</translation>
    </message>
    <message>
        <source>Up to date</source>
        <translation>À jour</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Périmé</translation>
    </message>
    <message>
        <source>simulated operations</source>
        <translation>opérations simulées</translation>
    </message>
    <message>
        <source>most probable shape</source>
        <translation>forme la plus probable</translation>
    </message>
    <message>
        <source>Simulating</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>looking for tubes</source>
        <translation>recherche de structures tubulaires</translation>
    </message>
    <message>
        <source>steps in time</source>
        <translation>pas de temps</translation>
    </message>
    <message>
        <source>looking for the equilibrium</source>
        <translation>recherche de l&apos;équilibre</translation>
    </message>
    <message>
        <source>shaping a synthetic liver</source>
        <translation>création d&apos;un foie synthétique</translation>
    </message>
    <message>
        <source>growing its vessels</source>
        <translation>croissance de ses vaisseaux</translation>
    </message>
    <message>
        <source>making its CT</source>
        <translation>création de son scanner</translation>
    </message>
    <message>
        <source>measuring the true surfaces</source>
        <translation>mesure des surfaces vraies</translation>
    </message>
    <message>
        <source>inflating the abdomen</source>
        <translation>insufflation de l&apos;abdomen</translation>
    </message>
    <message>
        <source>letting the patient breathe</source>
        <translation>respiration du patient</translation>
    </message>
    <message>
        <source>letting the heart beat</source>
        <translation>battements du cœur</translation>
    </message>
    <message>
        <source>placing the laparoscope</source>
        <translation>mise en place du laparoscope</translation>
    </message>
    <message>
        <source>filming the liver</source>
        <translation>film du foie</translation>
    </message>
    <message>
        <source>following the film</source>
        <translation>suivi du film</translation>
    </message>
    <message>
        <source>Preparing the trial of a load</source>
        <translation>Préparation de l’essai de charge</translation>
    </message>
    <message>
        <source>Ending the trial of a load</source>
        <translation>Fin de l’essai de charge</translation>
    </message>
    <message>
        <source>preparing the elements</source>
        <translation>préparation des éléments</translation>
    </message>
    <message>
        <source>preparing the solver</source>
        <translation>préparation du solveur</translation>
    </message>
    <message>
        <source>Editing the labels</source>
        <translation>Modification des étiquettes</translation>
    </message>
    <message>
        <source>Preparing a preview</source>
        <translation>Préparation d&apos;un aperçu</translation>
    </message>
    <message>
        <source>Undoing</source>
        <translation>Annulation</translation>
    </message>
    <message>
        <source>Redoing</source>
        <translation>Rétablissement</translation>
    </message>
    <message>
        <source>Storing the review</source>
        <translation>Enregistrement de l&apos;état de vérification</translation>
    </message>
    <message>
        <source>looking at voxels</source>
        <translation>examen des voxels</translation>
    </message>
    <message>
        <source>Editing the vessel trees</source>
        <translation>Modification des arbres vasculaires</translation>
    </message>
    <message>
        <source>Noting the check of the model</source>
        <translation>Enregistrement de la vérification du modèle</translation>
    </message>
    <message>
        <source>looking for the board</source>
        <translation>recherche de la mire</translation>
    </message>
    <message>
        <source>calibrating each camera</source>
        <translation>étalonnage de chaque caméra</translation>
    </message>
    <message>
        <source>calibrating both together</source>
        <translation>étalonnage des deux ensemble</translation>
    </message>
    <message>
        <source>holding each view against the others</source>
        <translation>comparaison de chaque vue aux autres</translation>
    </message>
    <message>
        <source>Calibrating the laparoscope</source>
        <translation>Étalonnage du laparoscope</translation>
    </message>
    <message>
        <source>Writing the labels</source>
        <translation>Écriture des étiquettes</translation>
    </message>
    <message>
        <source>pulling and pressing the organ</source>
        <translation>tirer et appuyer sur l’organe</translation>
    </message>
    <message>
        <source>registering livers</source>
        <translation>recalage de foies</translation>
    </message>
    <message>
        <source>pulling, registering and following organs</source>
        <translation>traction, recalage et suivi d&apos;organes</translation>
    </message>
    <message>
        <source>handling the liver</source>
        <translation>manipulation du foie</translation>
    </message>
    <message>
        <source>Keeping a copy for recovery</source>
        <translation>Conservation d’une copie de secours</translation>
    </message>
    <message>
        <source>Opening the copy</source>
        <translation>Ouverture de la copie</translation>
    </message>
    <message>
        <source>Accepting the registration</source>
        <translation>Acceptation du recalage</translation>
    </message>
    <message>
        <source>Proposing the landmarks</source>
        <translation>Proposition des repères</translation>
    </message>
    <message>
        <source>Storing the review of a landmark</source>
        <translation>Enregistrement de la révision d&apos;un repère</translation>
    </message>
    <message>
        <source>laying the atlas on the liver</source>
        <translation>pose de l&apos;atlas sur le foie</translation>
    </message>
    <message>
        <source>bending the atlas</source>
        <translation>courbure de l&apos;atlas</translation>
    </message>
    <message>
        <source>fitting the atlas to the surface</source>
        <translation>ajustement de l&apos;atlas à la surface</translation>
    </message>
    <message>
        <source>bringing the template onto each liver</source>
        <translation>pose du gabarit sur chaque foie</translation>
    </message>
    <message>
        <source>foretelling each liver by the others</source>
        <translation>prédiction de chaque foie par les autres</translation>
    </message>
    <message>
        <source>reading livers</source>
        <translation>lecture des foies</translation>
    </message>
    <message>
        <source>Taking a step of the review back</source>
        <translation>Annulation d&apos;une étape de la relecture</translation>
    </message>
    <message>
        <source>Taking the other place</source>
        <translation>Adoption de l’autre position</translation>
    </message>
    <message>
        <source>killing the program at work</source>
        <translation>interruption brutale du programme au travail</translation>
    </message>
    <message>
        <source>Looking for series</source>
        <translation>Recherche des séries</translation>
    </message>
    <message>
        <source>Correcting by hand</source>
        <translation>Correction à la main</translation>
    </message>
    <message>
        <source>Taking a correction back</source>
        <translation>Annulation d’une correction</translation>
    </message>
    <message>
        <source>Looking for the liver</source>
        <translation>Recherche du foie</translation>
    </message>
    <message>
        <source>comparing tissues</source>
        <translation>comparaison des tissus</translation>
    </message>
    <message>
        <source>Storing the decision about the new segmentation</source>
        <translation>Enregistrement de la décision sur la nouvelle segmentation</translation>
    </message>
    <message>
        <source>Registering again</source>
        <translation>Nouveau recalage</translation>
    </message>
    <message>
        <source>Taking the other registration</source>
        <translation>Passage à l’autre recalage</translation>
    </message>
    <message>
        <source>Segmenting by your network</source>
        <translation>Segmentation par votre réseau</translation>
    </message>
    <message>
        <source>Correcting around a click</source>
        <translation>Correction autour d’un clic</translation>
    </message>
    <message>
        <source>reading the network</source>
        <translation>lecture du réseau</translation>
    </message>
    <message>
        <source>running the network</source>
        <translation>calcul du réseau</translation>
    </message>
    <message>
        <source>Choosing the mask network</source>
        <translation>Choix du réseau de masque</translation>
    </message>
    <message>
        <source>taking off the coils&apos; brightness</source>
        <translation>retire la luminosité des antennes</translation>
    </message>
    <message>
        <source>Keeping the look</source>
        <translation>La vue est gardée</translation>
    </message>
    <message>
        <source>Forgetting the looks</source>
        <translation>Les vues sont oubliées</translation>
    </message>
    <message>
        <source>shapes with altered supports</source>
        <translation>formes aux appuis modifiés</translation>
    </message>
    <message>
        <source>Simulating operations</source>
        <translation>Simulation d’opérations</translation>
    </message>
    <message>
        <source>Writing the surfaces</source>
        <translation>Écriture des surfaces</translation>
    </message>
    <message>
        <source>Building an atlas</source>
        <translation>Construction d&apos;un atlas</translation>
    </message>
    <message>
        <source>Keeping the moment</source>
        <translation>Conservation de l&apos;instant</translation>
    </message>
    <message>
        <source>Storing a moment&apos;s title</source>
        <translation>Enregistrement du titre d&apos;un instant</translation>
    </message>
    <message>
        <source>Deleting a moment</source>
        <translation>Suppression d&apos;un instant</translation>
    </message>
    <message>
        <source>Storing what is locked</source>
        <translation>Enregistrement de ce qui est verrouillé</translation>
    </message>
</context>
<context>
    <name>UnitQuestion</name>
    <message>
        <source>Unit of length</source>
        <translation>Unité de longueur</translation>
    </message>
    <message>
        <source>In which unit are the lengths in %1?</source>
        <translation>Dans quelle unité sont les longueurs de %1 ?</translation>
    </message>
    <message>
        <source>The file does not say. Glisson itself writes millimetres.</source>
        <translation>Le fichier ne le dit pas. Glisson lui-même écrit en millimètres.</translation>
    </message>
</context>
<context>
    <name>cli</name>
    <message>
        <source>Show this help.</source>
        <translation>Affiche cette aide.</translation>
    </message>
    <message>
        <source>Seed of everything random.</source>
        <translation>Graine de tout ce qui est aléatoire.</translation>
    </message>
    <message>
        <source>Write the figures to this file, as one flat JSON object.</source>
        <translation>Écrit les chiffres dans ce fichier, en un seul objet JSON plat.</translation>
    </message>
    <message>
        <source> Default: %1.</source>
        <translation> Par défaut&#xa0;: %1.</translation>
    </message>
    <message>
        <source>note: </source>
        <translation>remarque&#xa0;: </translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>The main job from end to end: a patient becomes a model, an in-silico theatre deforms and films the liver, the model is registered to the pictures and follows the video; ends with an overlay video and a report with the true errors.</source>
        <translation>Tout le parcours&#xa0;: un patient devient un modèle, un bloc opératoire virtuel déforme et filme le foie, le modèle est recalé sur les images et suit la vidéo&#xa0;; à la fin, une vidéo avec superposition et un rapport avec les erreurs vraies.</translation>
    </message>
    <message>
        <source>The folder for the results.</source>
        <translation>Dossier des résultats.</translation>
    </message>
    <message>
        <source>Another patient than the synthetic one: a case, a label map, or surfaces (a folder by structure, or one file).</source>
        <translation>Un autre patient que le synthétique&#xa0;: un cas, une carte d&apos;étiquettes ou des surfaces (un dossier par structure, ou un fichier).</translation>
    </message>
    <message>
        <source>What a label map&apos;s codes mean (JSON).</source>
        <translation>Ce que signifient les codes d&apos;une carte d&apos;étiquettes (JSON).</translation>
    </message>
    <message>
        <source>Unit of surfaces: mm, cm or m.</source>
        <translation>Unité des surfaces&#xa0;: mm, cm ou m.</translation>
    </message>
    <message>
        <source>Vertices of the model.</source>
        <translation>Sommets du modèle.</translation>
    </message>
    <message>
        <source>Length of the film, at 30 frames a second.</source>
        <translation>Longueur du film en images, 30 par seconde.</translation>
    </message>
    <message>
        <source>Distance of the laparoscope, mm (80 to 160).</source>
        <translation>Distance du laparoscope, mm (80 à 160).</translation>
    </message>
    <message>
        <source>Share of the surface in the patch of the paper&apos;s protocol.</source>
        <translation>Part de la surface dans la zone du protocole de l&apos;article.</translation>
    </message>
    <message>
        <source>Which member of the synthetic population.</source>
        <translation>Quel membre de la population synthétique.</translation>
    </message>
    <message>
        <source>Do not open the window at the end.</source>
        <translation>Ne pas ouvrir la fenêtre à la fin.</translation>
    </message>
    <message>
        <source>Glisson: planning and guidance of minimally invasive liver surgery. Research software: not for clinical use.</source>
        <translation>Glisson&#xa0;: planification et guidage de la chirurgie hépatique mini-invasive. Logiciel de recherche&#xa0;: pas d&apos;usage clinique.</translation>
    </message>
    <message>
        <source>Usage: glisson [CASE]              open the window</source>
        <translation>Usage&#xa0;: glisson [CASE]             ouvre la fenêtre</translation>
    </message>
    <message>
        <source>       glisson COMMAND [OPTIONS]   work without a display; &apos;glisson COMMAND --help&apos; tells more</source>
        <translation>        glisson COMMAND [OPTIONS]  travaille sans écran&#xa0;; &apos;glisson COMMAND --help&apos; en dit plus</translation>
    </message>
    <message>
        <source>The model: a case (NAME.glisson), a tetrahedral mesh (.vtu, legacy .vtk, .msh), a closed surface (.vtk .vtp .stl .obj .ply) or a folder of surfaces.</source>
        <translation>Le modèle&#xa0;: un cas (NAME.glisson), un maillage de tétraèdres (.vtu, ancien .vtk, .msh), une surface fermée (.vtk .vtp .stl .obj .ply) ou un dossier de surfaces.</translation>
    </message>
    <message>
        <source>Unit of the model&apos;s files and of what is written: mm, cm or m.</source>
        <translation>Unité des fichiers du modèle et des résultats&#xa0;: mm, cm ou m.</translation>
    </message>
    <message>
        <source>Vertices wanted when a surface is meshed.</source>
        <translation>Sommets voulus quand une surface est maillée.</translation>
    </message>
    <message>
        <source>Landmarks of the model (JSON, LPS mm).</source>
        <translation>Repères du modèle (JSON, LPS mm).</translation>
    </message>
    <message>
        <source>What the liver is made of: %1.</source>
        <translation>De quoi le foie est fait&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Parenchyma only: no vessels, no capsule.</source>
        <translation>Parenchyme seul&#xa0;: ni vaisseaux ni capsule.</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of the parenchyma, Pa.</source>
        <translation>Module de Young du parenchyme, Pa.</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio of the parenchyma.</source>
        <translation>Coefficient de Poisson du parenchyme.</translation>
    </message>
    <message>
        <source>Young&apos;s moduli, kPa, as lesion_1=20,lesions=12: of parenchyma (or healthy, cirrhotic), lesion_1, lesion_2, ... and lesions (all others) (or soft, as_liver, stiff). What is not named is as the case says, or as the liver.</source>
        <translation>Modules d&apos;Young, kPa, comme lesion_1=20,lesions=12 : de parenchyma (ou healthy, cirrhotic), lesion_1, lesion_2, ... et lesions (toutes les autres) (ou soft, as_liver, stiff). Ce qui n&apos;est pas nommé est comme le dit le cas, ou comme le foie.</translation>
    </message>
    <message>
        <source>The case&apos;s folder, NAME.glisson.</source>
        <translation>Dossier du cas, NAME.glisson.</translation>
    </message>
    <message>
        <source>The volume.</source>
        <translation>Le volume.</translation>
    </message>
    <message>
        <source>What was clicked (JSON, LPS mm).</source>
        <translation>Ce qui a été cliqué (JSON, LPS mm).</translation>
    </message>
    <message>
        <source>What the expert&apos;s codes mean (JSON).</source>
        <translation>Ce que signifient les codes de l&apos;expert (JSON).</translation>
    </message>
    <message>
        <source>Builds the biomechanical model: tetrahedra, vessels, anterior margin.</source>
        <translation>Construit le modèle biomécanique&#xa0;: tétraèdres, vaisseaux, bord antérieur.</translation>
    </message>
    <message>
        <source>Labels to take instead of the case&apos;s.</source>
        <translation>Étiquettes à prendre au lieu de celles du cas.</translation>
    </message>
    <message>
        <source>What their codes mean: JSON, {&quot;6&quot;: &quot;parenchyma&quot;, &quot;10&quot;: &quot;portal_vein&quot;, ...}.</source>
        <translation>Ce que signifient leurs codes&#xa0;: JSON, {&quot;6&quot;: &quot;parenchyma&quot;, &quot;10&quot;: &quot;portal_vein&quot;, ...}.</translation>
    </message>
    <message>
        <source>Takes labels or surfaces of a liver that lies left of the vena cava, as after a right hepatectomy: they are refused as mirrored otherwise.</source>
        <translation>Accepte les étiquettes ou surfaces d’un foie situé à gauche de la veine cave, comme après une hépatectomie droite : sinon ils sont refusés comme inversés.</translation>
    </message>
    <message>
        <source>Unit of the surfaces: mm, cm or m.</source>
        <translation>Unité des surfaces&#xa0;: mm, cm ou m.</translation>
    </message>
    <message>
        <source>Vertices wanted.</source>
        <translation>Sommets voulus.</translation>
    </message>
    <message>
        <source>A fine surface of the liver: adds the distances. Read after everything else.</source>
        <translation>Une surface fine du foie&#xa0;: ajoute les distances. Lue après tout le reste.</translation>
    </message>
    <message>
        <source>Also write the mesh here (.vtu, .vtk).</source>
        <translation>Écrire aussi le maillage ici (.vtu, .vtk).</translation>
    </message>
    <message>
        <source>Plain mechanics: a load on the model. Writes deformed meshes with displacement and von Mises stress, and steps.csv with energies, residuals and time per step.</source>
        <translation>Mécanique seule&#xa0;: une charge sur le modèle. Écrit des maillages déformés avec déplacement et contrainte de von Mises, et steps.csv avec énergies, résidus et temps par pas.</translation>
    </message>
    <message>
        <source>Steps of the dynamics.</source>
        <translation>Pas de la dynamique.</translation>
    </message>
    <message>
        <source>Time step, s.</source>
        <translation>Pas de temps, s.</translation>
    </message>
    <message>
        <source>The equilibrium instead of the dynamics.</source>
        <translation>L&apos;équilibre au lieu de la dynamique.</translation>
    </message>
    <message>
        <source>Linear solver: direct (a fresh factor every step), fast (two-level conjugate gradients, for %1 tetrahedra and more) or reference (CHOLMOD).</source>
        <translation>Solveur linéaire&#xa0;: direct (factorisé à chaque pas), fast (gradient conjugué à deux niveaux, à partir de %1 tétraèdres) ou reference (CHOLMOD).</translation>
    </message>
    <message>
        <source>Relative residual of the fast solver.</source>
        <translation>Résidu relatif du solveur fast.</translation>
    </message>
    <message>
        <source>Write a mesh every so many steps (the last is always written).</source>
        <translation>Écrire un maillage tous les N pas (le dernier toujours).</translation>
    </message>
    <message>
        <source>The non-linear law instead of the co-rotational one.</source>
        <translation>La loi non linéaire au lieu de la corotationnelle.</translation>
    </message>
    <message>
        <source>From CT to overlay video on the built-in synthetic patient, or another</source>
        <translation>Du scanner à la vidéo avec superposition, sur le patient synthétique intégré ou un autre</translation>
    </message>
    <message>
        <source>Read a CT into a case</source>
        <translation>Lire un scanner dans un cas</translation>
    </message>
    <message>
        <source>Segment liver, vessels and lesions from seeds</source>
        <translation>Segmenter foie, vaisseaux et lésions à partir de germes</translation>
    </message>
    <message>
        <source>Build the biomechanical model</source>
        <translation>Construire le modèle biomécanique</translation>
    </message>
    <message>
        <source>Stereo pair to labelled cloud</source>
        <translation>De la paire stéréo au nuage étiqueté</translation>
    </message>
    <message>
        <source>Register the model to a cloud</source>
        <translation>Recaler le modèle sur un nuage</translation>
    </message>
    <message>
        <source>Follow a stereo video or a series of clouds</source>
        <translation>Suivre une vidéo stéréo ou une série de nuages</translation>
    </message>
    <message>
        <source>Draw one frame with its overlay</source>
        <translation>Dessiner une image avec sa superposition</translation>
    </message>
    <message>
        <source>Record the overlay video</source>
        <translation>Enregistrer la vidéo avec superposition</translation>
    </message>
    <message>
        <source>Plain mechanics: gravity, pressure, springs, fixed nodes</source>
        <translation>Mécanique seule&#xa0;: pesanteur, pression, ressorts, nœuds fixes</translation>
    </message>
    <message>
        <source>Turns a stereo pair into a labelled cloud in the left camera&apos;s frame.</source>
        <translation>Transforme une paire stéréo en nuage étiqueté dans le repère de la caméra gauche.</translation>
    </message>
    <message>
        <source>The left picture.</source>
        <translation>L&apos;image gauche.</translation>
    </message>
    <message>
        <source>The right picture.</source>
        <translation>L&apos;image droite.</translation>
    </message>
    <message>
        <source>What of the left picture is tissue (non-zero).</source>
        <translation>Ce qui est du tissu dans l&apos;image gauche (non nul).</translation>
    </message>
    <message>
        <source>Clicked regions (JSON): only what lies in one is kept, with its label.</source>
        <translation>Zones cliquées (JSON)&#xa0;: seul ce qui s&apos;y trouve est gardé, avec son étiquette.</translation>
    </message>
    <message>
        <source>The cloud (PLY).</source>
        <translation>Le nuage (PLY).</translation>
    </message>
    <message>
        <source>Unit of the cloud and of --truth: mm, cm or m.</source>
        <translation>Unité du nuage et de --truth&#xa0;: mm, cm ou m.</translation>
    </message>
    <message>
        <source>A surface in the left camera&apos;s frame, or its depth map (.pfm, mm): adds the distances. Read after everything else.</source>
        <translation>Une surface dans le repère de la caméra gauche, ou sa carte de profondeur (.pfm, mm)&#xa0;: ajoute les distances. Lue après tout le reste.</translation>
    </message>
    <message>
        <source>Registers a model to a cloud: rigid start, then elastically. What is written keeps the model&apos;s node order and unit and is in the cloud&apos;s frame; its field data cloud_from_model is the rigid part.</source>
        <translation>Recale un modèle sur un nuage&#xa0;: départ rigide, puis élastique. Le résultat garde l&apos;ordre des nœuds et l&apos;unité du modèle, dans le repère du nuage&#xa0;; son champ cloud_from_model est la partie rigide.</translation>
    </message>
    <message>
        <source>The cloud (PLY); an integer property label is optional: 1 surface, 2 anterior margin, 3 umbilical notch.</source>
        <translation>Le nuage (PLY)&#xa0;; la propriété entière label est facultative&#xa0;: 1 surface, 2 bord antérieur, 3 échancrure ombilicale.</translation>
    </message>
    <message>
        <source>Unit of the cloud: mm, cm or m. Without it, the model&apos;s.</source>
        <translation>Unité du nuage&#xa0;: mm, cm ou m. Sinon, celle du modèle.</translation>
    </message>
    <message>
        <source>Rigid start: auto, none (the cloud is in the model&apos;s frame; what is judged by where the camera stood is not), or a file with a 4 x 4 matrix cloud_from_model.</source>
        <translation>Départ rigide&#xa0;: auto, none (le nuage est dans le repère du modèle&#xa0;; rien n&apos;est jugé d&apos;après la place de la caméra), ou un fichier avec une matrice 4 x 4 cloud_from_model.</translation>
    </message>
    <message>
        <source>Nodes that stay where the rigid start puts them (0-based numbers).</source>
        <translation>Nœuds qui restent où le départ rigide les met (numéros à partir de 0).</translation>
    </message>
    <message>
        <source>What is known of the deformation before the cloud is seen: operations (simulated on this model; needs the vena cava&apos;s landmark) or none (elasticity alone, the paper&apos;s method).</source>
        <translation>Ce que l&apos;on sait de la déformation avant de voir le nuage&#xa0;: operations (simulées sur ce modèle&#xa0;; il faut le repère de la veine cave) ou none (l&apos;élasticité seule, la méthode de l&apos;article).</translation>
    </message>
    <message>
        <source>True node positions (.xyz or a mesh): adds the errors. Read after everything else.</source>
        <translation>Positions vraies des nœuds (.xyz ou un maillage)&#xa0;: ajoute les erreurs. Lues après tout le reste.</translation>
    </message>
    <message>
        <source>The registered mesh (.vtu), or surface (.vtp) when a surface was given.</source>
        <translation>Le maillage recalé (.vtu), ou la surface (.vtp) si une surface a été donnée.</translation>
    </message>
    <message>
        <source>What &apos;glisson register&apos; wrote for this model and the first frame.</source>
        <translation>Ce que &apos;glisson register&apos; a écrit pour ce modèle et la première image.</translation>
    </message>
    <message>
        <source>Stereo video, views side by side.</source>
        <translation>Vidéo stéréo, vues côte à côte.</translation>
    </message>
    <message>
        <source>The right view, when it is a file of its own.</source>
        <translation>La vue droite, si elle est un fichier à part.</translation>
    </message>
    <message>
        <source>OpenCV YAML of the laparoscope.</source>
        <translation>YAML OpenCV du laparoscope.</translation>
    </message>
    <message>
        <source>Series of clouds instead of a video, e.g. &apos;cloud_%02d.ply&apos;.</source>
        <translation>Série de nuages au lieu d&apos;une vidéo, p. ex. &apos;cloud_%02d.ply&apos;.</translation>
    </message>
    <message>
        <source>Unit of the clouds: mm, cm or m. Without it, the model&apos;s.</source>
        <translation>Unité des nuages&#xa0;: mm, cm ou m. Sinon, celle du modèle.</translation>
    </message>
    <message>
        <source>Nodes that do not move (0-based numbers).</source>
        <translation>Nœuds qui ne bougent pas (numéros à partir de 0).</translation>
    </message>
    <message>
        <source>Series of true node positions, e.g. &apos;truth_%02d.xyz&apos;; may lack frames. Read after everything else.</source>
        <translation>Série de positions vraies des nœuds, p. ex. &apos;truth_%02d.xyz&apos;&#xa0;; des images peuvent manquer. Lue après tout le reste.</translation>
    </message>
    <message>
        <source>The folder for the meshes.</source>
        <translation>Dossier des maillages.</translation>
    </message>
    <message>
        <source>Draws one frame of the case&apos;s video with vessels and tumours, followed from the registered frame. Where the position is not known, the picture says so and shows no overlay.</source>
        <translation>Dessine une image de la vidéo du cas avec vaisseaux et tumeurs, suivis depuis l&apos;image recalée. Si la position n&apos;est pas connue, l&apos;image le dit et ne montre pas de superposition.</translation>
    </message>
    <message>
        <source>The case&apos;s folder, NAME.glisson, with a registration and a video.</source>
        <translation>Dossier du cas, NAME.glisson, avec un recalage et une vidéo.</translation>
    </message>
    <message>
        <source>Number of the frame, from 0.</source>
        <translation>Numéro de l&apos;image, à partir de 0.</translation>
    </message>
    <message>
        <source>The picture (.png, .jpg).</source>
        <translation>L&apos;image (.png, .jpg).</translation>
    </message>
    <message>
        <source>Follows the case&apos;s video and records it with vessels and tumours drawn in.</source>
        <translation>Suit la vidéo du cas et l&apos;enregistre avec vaisseaux et tumeurs dessinés.</translation>
    </message>
    <message>
        <source>The case&apos;s video, where it is opened without it: it lies outside of the case, and nobody here has chosen it yet.</source>
        <translation>La vidéo du cas, là où il est ouvert sans elle : elle se trouve hors du cas et personne ne l’a encore choisie ici.</translation>
    </message>
    <message>
        <source>Record only so many frames.</source>
        <translation>N&apos;enregistrer que ce nombre d&apos;images.</translation>
    </message>
    <message>
        <source>The video (.mkv).</source>
        <translation>La vidéo (.mkv).</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>image %1</translation>
    </message>
    <message>
        <source>The load (JSON): gravity, pressure, forces, springs, fixed; see the manual.</source>
        <translation>La charge (JSON)&#xa0;: pesanteur, pression, forces, ressorts, nœuds fixes&#xa0;; voir le manuel.</translation>
    </message>
    <message>
        <source>Edits the labels by a script of the window&apos;s tools. Each edit is a step that can be undone in the window.</source>
        <translation>Modifie les étiquettes par un script des outils de la fenêtre. Chaque modification est une étape que l&apos;on peut annuler dans la fenêtre.</translation>
    </message>
    <message>
        <source>The edits (JSON, LPS mm).</source>
        <translation>Les modifications (JSON, LPS mm).</translation>
    </message>
    <message>
        <source>Undo so many steps first.</source>
        <translation>Annuler d&apos;abord autant d&apos;étapes.</translation>
    </message>
    <message>
        <source>Redo so many steps first, after those that are undone.</source>
        <translation>Rétablir d&apos;abord autant d&apos;étapes, après celles qui sont annulées.</translation>
    </message>
    <message>
        <source>How far a label has come: STRUCTURE=STATE, several with commas.</source>
        <translation>Où en est une étiquette : STRUCTURE=ÉTAT, plusieurs avec des virgules.</translation>
    </message>
    <message>
        <source>Nothing to do: give --script, --undo, --redo or --review.</source>
        <translation>Rien à faire : donnez --script, --undo, --redo ou --review.</translation>
    </message>
    <message>
        <source>Labels of an expert: adds Dice coefficients. Read after everything else.</source>
        <translation>Étiquettes d&apos;un expert : ajoute les coefficients de Dice. Lues après tout le reste.</translation>
    </message>
    <message>
        <source>Mean edge length wanted, mm, instead of a number of vertices.</source>
        <translation>Longueur d&apos;arête moyenne voulue, mm, au lieu d&apos;un nombre de sommets.</translation>
    </message>
    <message>
        <source>Edge length in lesions over that elsewhere, 0.1 to 1.</source>
        <translation>Longueur d&apos;arête dans les lésions rapportée à celle d&apos;ailleurs, 0.1 à 1.</translation>
    </message>
    <message>
        <source>Edge length in and next to vessels over that elsewhere, 0.2 to 1.</source>
        <translation>Longueur d&apos;arête dans et près des vaisseaux rapportée à celle d&apos;ailleurs, 0.2 à 1.</translation>
    </message>
    <message>
        <source>--region %1: write two opposite corners, X0,Y0,Z0,X1,Y1,Z1 in LPS millimetres.</source>
        <translation>--region %1 : écrivez deux coins opposés, X0,Y0,Z0,X1,Y1,Z1 en millimètres LPS.</translation>
    </message>
    <message>
        <source>Which DICOM series, where there are several: its UID or number.</source>
        <translation>Quelle série DICOM, s&apos;il y en a plusieurs : son UID ou son numéro.</translation>
    </message>
    <message>
        <source>Of the liver&apos;s contour, mm.</source>
        <translation>Du contour du foie, mm.</translation>
    </message>
    <message>
        <source>Find these anew and keep the other labels: liver, portal_vein, hepatic_veins, vena_cava, gallbladder, lesions, with commas.</source>
        <translation>Rechercher celles-ci à nouveau et garder les autres étiquettes : liver, portal_vein, hepatic_veins, vena_cava, gallbladder, lesions, avec des virgules.</translation>
    </message>
    <message>
        <source>Only inside this box, and keep the labels outside: X0,Y0,Z0,X1,Y1,Z1, LPS mm.</source>
        <translation>Seulement dans cette boîte, en gardant les étiquettes au-dehors : X0,Y0,Z0,X1,Y1,Z1, LPS mm.</translation>
    </message>
    <message>
        <source>real CT: Dice of the liver</source>
        <translation>scanner réel : Dice du foie</translation>
    </message>
    <message>
        <source>real CT: Dice of the portal vein in the liver</source>
        <translation>scanner réel : Dice de la veine porte dans le foie</translation>
    </message>
    <message>
        <source>real CT: Dice of the hepatic veins in the liver</source>
        <translation>scanner réel : Dice des veines hépatiques dans le foie</translation>
    </message>
    <message>
        <source>real CT: ways from the root to a tip of the portal vein found</source>
        <translation>scanner réel : chemins trouvés de la racine aux extrémités de la veine porte</translation>
    </message>
    <message>
        <source>real CT: ways from the root to a tip of the hepatic veins found</source>
        <translation>scanner réel : chemins trouvés de la racine aux extrémités des veines hépatiques</translation>
    </message>
    <message>
        <source>real CT: portal vein after the strokes</source>
        <translation>scanner réel : veine porte après les traits</translation>
    </message>
    <message>
        <source>real CT: hepatic veins after the strokes</source>
        <translation>scanner réel : veines hépatiques après les traits</translation>
    </message>
    <message>
        <source>real CT: vertices to the fine surface, mean, mm</source>
        <translation>scanner réel : sommets à la surface fine, moyenne, mm</translation>
    </message>
    <message>
        <source>real CT: least dihedral angle, degrees</source>
        <translation>scanner réel : plus petit angle dièdre, degrés</translation>
    </message>
    <message>
        <source>real CT: tetrahedra of the fine model</source>
        <translation>scanner réel : tétraèdres du modèle fin</translation>
    </message>
    <message>
        <source>real CT: volume error of the fine model</source>
        <translation>scanner réel : erreur de volume du modèle fin</translation>
    </message>
    <message>
        <source>in silico: Dice of the liver</source>
        <translation>in silico : Dice du foie</translation>
    </message>
    <message>
        <source>in silico: centrelines to the true trees, mean, voxels</source>
        <translation>in silico : lignes centrales aux vrais arbres, moyenne, voxels</translation>
    </message>
    <message>
        <source>in silico: branches above 2 mm radius found</source>
        <translation>in silico : branches de plus de 2 mm de rayon trouvées</translation>
    </message>
    <message>
        <source>in silico: false loops</source>
        <translation>in silico : fausses boucles</translation>
    </message>
    <message>
        <source>in silico, segmented by clicks: centrelines to the true trees, mean, voxels</source>
        <translation>in silico, segmenté par clics : lignes centrales aux vrais arbres, moyenne, voxels</translation>
    </message>
    <message>
        <source>in silico: vertices to the fine surface, mean, mm</source>
        <translation>in silico : sommets à la surface fine, moyenne, mm</translation>
    </message>
    <message>
        <source>in silico: least dihedral angle, degrees</source>
        <translation>in silico : plus petit angle dièdre, degrés</translation>
    </message>
    <message>
        <source>in silico: volume error of the fine model</source>
        <translation>in silico : erreur de volume du modèle fin</translation>
    </message>
    <message>
        <source>met</source>
        <translation>atteint</translation>
    </message>
    <message>
        <source>NOT MET</source>
        <translation>NON ATTEINT</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>non mesuré</translation>
    </message>
    <message>
        <source>%1: leave out what is measured in silico.</source>
        <translation>%1 : omettre ce qui est mesuré in silico.</translation>
    </message>
    <message>
        <source>Folder for the page with the figures. In a checkout they go to packaging/figures, unless some could not be measured.</source>
        <translation>Dossier de la page des chiffres. Dans un dépôt de sources, ils vont dans packaging/figures, sauf si certains n’ont pas pu être mesurés.</translation>
    </message>
    <message>
        <source>The figures were written to %1.</source>
        <translation>Les chiffres ont été écrits dans %1.</translation>
    </message>
    <message>
        <source>Folder of the real data; what is not there is left out.</source>
        <translation>Dossier des données réelles ; ce qui manque est laissé de côté.</translation>
    </message>
    <message>
        <source>Folder of the clicks on it.</source>
        <translation>Dossier des clics correspondants.</translation>
    </message>
    <message>
        <source>Folder for cases, scripts and pictures.</source>
        <translation>Dossier pour les cas, scripts et images.</translation>
    </message>
    <message>
        <source>%1: is no proof. See &apos;glisson prove --help&apos;.</source>
        <translation>%1 : ce n&apos;est pas une preuve. Voir &apos;glisson prove --help&apos;.</translation>
    </message>
    <message>
        <source>%1: the board is found in the left picture only</source>
        <translation>%1 : la mire n&apos;est trouvée que dans l&apos;image gauche</translation>
    </message>
    <message>
        <source>%1: the board is found in the right picture only</source>
        <translation>%1 : la mire n&apos;est trouvée que dans l&apos;image droite</translation>
    </message>
    <message>
        <source>%1: no board is found</source>
        <translation>%1 : aucune mire trouvée</translation>
    </message>
    <message>
        <source>%1: has no partner</source>
        <translation>%1 : n&apos;a pas de partenaire</translation>
    </message>
    <message>
        <source>view, left px, right px, distance mm, tilt degrees, rows px by a calibration without it, rows px by the reference</source>
        <translation>vue, gauche px, droite px, distance mm, inclinaison degrés, lignes px par un étalonnage sans elle, lignes px par la référence</translation>
    </message>
    <message>
        <source>  left out</source>
        <translation>  laissée de côté</translation>
    </message>
    <message>
        <source>  fits far worse than the others: leave it out (--drop-outliers)</source>
        <translation>  s&apos;ajuste bien moins que les autres : à laisser de côté (--drop-outliers)</translation>
    </message>
    <message>
        <source>A folder of picture pairs whose names differ in left and right only, or with folders left and right in it.</source>
        <translation>Un dossier de paires d&apos;images dont les noms ne diffèrent que par left et right, ou contenant des dossiers left et right.</translation>
    </message>
    <message>
        <source>The left pictures: a folder, or a pattern such as &apos;shots/left-*.png&apos;.</source>
        <translation>Les images gauches : un dossier, ou un motif tel que &apos;shots/left-*.png&apos;.</translation>
    </message>
    <message>
        <source>The right pictures, likewise.</source>
        <translation>Les images droites, de même.</translation>
    </message>
    <message>
        <source>Stereo video of the board, views side by side.</source>
        <translation>Vidéo stéréo de la mire, vues côte à côte.</translation>
    </message>
    <message>
        <source>Inner corners of the board, columns and rows.</source>
        <translation>Coins intérieurs de la mire, colonnes et lignes.</translation>
    </message>
    <message>
        <source>Side of a square, millimetres.</source>
        <translation>Côté d&apos;un carré, millimètres.</translation>
    </message>
    <message>
        <source>A ChArUco board: the dictionary of its markers, as DICT_4X4_50.</source>
        <translation>Une mire ChArUco : le dictionnaire de ses marqueurs, par exemple DICT_4X4_50.</translation>
    </message>
    <message>
        <source>Side of a ChArUco marker, millimetres.</source>
        <translation>Côté d&apos;un marqueur ChArUco, millimètres.</translation>
    </message>
    <message>
        <source>Views to use at most; those that differ most are kept.</source>
        <translation>Nombre maximal de vues ; les plus différentes sont gardées.</translation>
    </message>
    <message>
        <source>Another calibration to compare with: YAML, or a folder of plain text.</source>
        <translation>Un autre étalonnage pour comparaison : YAML, ou un dossier de texte simple.</translation>
    </message>
    <message>
        <source>Leave out the views that fit far worse than the others.</source>
        <translation>Laisser de côté les vues qui s&apos;ajustent bien moins que les autres.</translation>
    </message>
    <message>
        <source>Estimate the third radial distortion term too.</source>
        <translation>Estimer aussi le troisième terme de distorsion radiale.</translation>
    </message>
    <message>
        <source>Picture of where the boards were, both cameras.</source>
        <translation>Image des positions de la mire, pour les deux caméras.</translation>
    </message>
    <message>
        <source>Instead of pictures: a calibration in plain text files (3x3, 4x4), to be written as YAML; needs --size.</source>
        <translation>Au lieu d&apos;images : un étalonnage en fichiers de texte simple (3x3, 4x4), à écrire en YAML ; exige --size.</translation>
    </message>
    <message>
        <source>Width and height of the pictures, for --text.</source>
        <translation>Largeur et hauteur des images, pour --text.</translation>
    </message>
    <message>
        <source>Unit of the translation in --text: mm, cm or m.</source>
        <translation>Unité de la translation dans --text : mm, cm ou m.</translation>
    </message>
    <message>
        <source>The calibration (OpenCV YAML, mm).</source>
        <translation>L&apos;étalonnage (YAML d&apos;OpenCV, mm).</translation>
    </message>
    <message>
        <source>Calibrates a stereo laparoscope from pictures of a chessboard or ChArUco board, and tells how far to trust it.</source>
        <translation>Étalonne un laparoscope stéréo à partir d&apos;images d&apos;un échiquier ou d&apos;une mire ChArUco, et dit jusqu&apos;où s&apos;y fier.</translation>
    </message>
    <message>
        <source>OpenCV YAML: M1 D1 M2 D2 R T image_width image_height unit; or a folder of plain text files (3x3, 4x4).</source>
        <translation>YAML d&apos;OpenCV : M1 D1 M2 D2 R T image_width image_height unit ; ou un dossier de fichiers de texte simple (3x3, 4x4).</translation>
    </message>
    <message>
        <source>Features (sparse, the paper&apos;s), semi-global matching (dense), or auto: dense where features leave fewer than 0.7 points per cm2.</source>
        <translation>Points caractéristiques (sparse, ceux de l&apos;article), appariement semi-global (dense), ou auto : dense là où ils laissent moins de 0,7 point par cm2.</translation>
    </message>
    <message>
        <source>The same as --method dense.</source>
        <translation>La même chose que --method dense.</translation>
    </message>
    <message>
        <source>Kind of features.</source>
        <translation>Type de points caractéristiques.</translation>
    </message>
    <message>
        <source>Edit the labels by a script of the window&apos;s tools</source>
        <translation>Modifier les étiquettes par un script des outils de la fenêtre</translation>
    </message>
    <message>
        <source>Calibrate a stereo laparoscope from pictures of a board</source>
        <translation>Étalonner un laparoscope stéréo à partir d&apos;images d&apos;une mire</translation>
    </message>
    <message>
        <source>Measure the proofs&apos; figures again</source>
        <translation>Mesurer à nouveau les chiffres des preuves</translation>
    </message>
    <message>
        <source>real liver, features: points</source>
        <translation>foie réel, points caractéristiques : points</translation>
    </message>
    <message>
        <source>real liver, features: median to the CT surface, mm</source>
        <translation>foie réel, points caractéristiques : médiane à la surface du scanner, mm</translation>
    </message>
    <message>
        <source>real liver, features: share within 3 mm</source>
        <translation>foie réel, points caractéristiques : part à moins de 3 mm</translation>
    </message>
    <message>
        <source>real liver, features: median without the common offset, mm</source>
        <translation>foie réel, points caractéristiques : médiane sans le décalage commun, mm</translation>
    </message>
    <message>
        <source>real liver, dense: median to the CT surface, mm</source>
        <translation>foie réel, dense : médiane à la surface du scanner, mm</translation>
    </message>
    <message>
        <source>real liver, dense: share of the region covered</source>
        <translation>foie réel, dense : part de la région couverte</translation>
    </message>
    <message>
        <source>real liver, dense: median without the common offset, mm</source>
        <translation>foie réel, dense : médiane sans le décalage commun, mm</translation>
    </message>
    <message>
        <source>real chessboards: joint stereo rms, pixels</source>
        <translation>échiquiers réels : rms stéréo commun, pixels</translation>
    </message>
    <message>
        <source>real chessboards: views that fit better left out than by the reference</source>
        <translation>échiquiers réels : vues qui s&apos;ajustent mieux laissées de côté que par la référence</translation>
    </message>
    <message>
        <source>silicone heart: rows, rms, pixels</source>
        <translation>cœur en silicone : lignes, RMS, pixels</translation>
    </message>
    <message>
        <source>in silico: largest bias of any trial, mm</source>
        <translation>in silico : plus grand biais d&apos;un essai, mm</translation>
    </message>
    <message>
        <source>in silico: normalised error, median of the trials (1: sigma is right)</source>
        <translation>in silico : erreur normalisée, médiane des essais (1 : sigma est juste)</translation>
    </message>
    <message>
        <source>%1 is not there and is left out.</source>
        <translation>%1 est absent et laissé de côté.</translation>
    </message>
    <message>
        <source>Picture of where there are enough points, and where they are missing.</source>
        <translation>Image des endroits où il y a assez de points, et où il en manque.</translation>
    </message>
    <message>
        <source>The case is there already, and this is another image of its patient: it takes the former one&apos;s place; all else stays, marked out of date.</source>
        <translation>Le cas existe déjà, et c&apos;est une autre image de son patient : elle prend la place de l&apos;ancienne ; tout le reste demeure, marqué comme périmé.</translation>
    </message>
    <message>
        <source>--%1 %2: %3 is the same file. Choose another name.</source>
        <translation>--%1 %2 : %3 est le même fichier. Choisissez un autre nom.</translation>
    </message>
    <message>
        <source>%1: is the video that is drawn into. Choose another name.</source>
        <translation>%1 : c&apos;est la vidéo dans laquelle on dessine. Choisissez un autre nom.</translation>
    </message>
    <message>
        <source>--%1: is given twice. Leave one of them out.</source>
        <translation>--%1 : est donné deux fois. Supprimez l&apos;un des deux.</translation>
    </message>
    <message>
        <source>--%1: has no value. See &apos;glisson %2 --help&apos;.</source>
        <translation>--%1 : n&apos;a pas de valeur. Voir &apos;glisson %2 --help&apos;.</translation>
    </message>
    <message>
        <source>glisson %1: an argument is empty. See &apos;glisson %1 --help&apos;.</source>
        <translation>glisson %1 : un argument est vide. Voir &apos;glisson %1 --help&apos;.</translation>
    </message>
    <message>
        <source>Looks through a stereo video for faults: black, frozen, duplicated, swapped or exchanged frames, a lost camera, interlaced rows, a calibration of another scope.</source>
        <translation>Cherche les défauts d&apos;une vidéo stéréo : images noires, figées, doublées, échangées ou déplacées, une caméra perdue, des lignes entrelacées, l&apos;étalonnage d&apos;un autre laparoscope.</translation>
    </message>
    <message>
        <source>Stereo video, folder of picture pairs, or description of a source (.json).</source>
        <translation>Vidéo stéréo, dossier de paires d&apos;images, ou description d&apos;une source (.json).</translation>
    </message>
    <message>
        <source>OpenCV YAML of the laparoscope, or a folder of plain text.</source>
        <translation>YAML d&apos;OpenCV du laparoscope, ou un dossier de texte simple.</translation>
    </message>
    <message>
        <source>Hold each N-th frame against the calibration.</source>
        <translation>Comparer chaque N-ième image à l&apos;étalonnage.</translation>
    </message>
    <message>
        <source>frame %1: %2</source>
        <translation>image %1 : %2</translation>
    </message>
    <message>
        <source>Look through a stereo video for faults</source>
        <translation>Chercher les défauts d&apos;une vidéo stéréo</translation>
    </message>
    <message>
        <source>Closed surfaces to take instead of labels: a folder by structure, a list (JSON) of structures and files, or one file.</source>
        <translation>Surfaces fermées à prendre au lieu d&apos;étiquettes : un dossier par structure, une liste (JSON) de structures et de fichiers, ou un fichier.</translation>
    </message>
    <message>
        <source>What is changed in the vessel trees (JSON, LPS mm).</source>
        <translation>Ce qui est changé dans les arbres vasculaires (JSON, LPS mm).</translation>
    </message>
    <message>
        <source>Beams of all vessels together, about: where they have more, the thinnest and shortest side branches are left out, vessels of 4 mm across and more stay.</source>
        <translation>Poutres de tous les vaisseaux ensemble, environ : au-delà, les branches latérales les plus fines et les plus courtes sont omises, les vaisseaux de 4 mm de diamètre et plus restent.</translation>
    </message>
    <message>
        <source>real CT: least dihedral angle of the fine model, degrees</source>
        <translation>scanner réel : plus petit angle dièdre du modèle fin, degrés</translation>
    </message>
    <message>
        <source>real CT: volume error of lesions above 1 ml, largest</source>
        <translation>scanner réel : plus grande erreur de volume des lésions de plus de 1 ml</translation>
    </message>
    <message>
        <source>live: frames over 10 mm that are not valid, share</source>
        <translation>en direct : part des images à plus de 10 mm qui ne sont pas valides</translation>
    </message>
    <message>
        <source>live: frames under 3 mm without a fault that are valid, share</source>
        <translation>en direct : part des images à moins de 3 mm et sans défaut qui sont valides</translation>
    </message>
    <message>
        <source>live: longest time until an overlay goes, s</source>
        <translation>en direct : temps le plus long jusqu’au retrait, s</translation>
    </message>
    <message>
        <source>cancelled; nothing was written.</source>
        <translation>annulé ; rien n’a été écrit.</translation>
    </message>
    <message>
        <source>cancelled; %1 holds what was finished (%2), marked as incomplete.</source>
        <translation>annulé ; %1 contient ce qui était terminé (%2), marqué comme incomplet.</translation>
    </message>
    <message>
        <source>cancelled; %1 holds what was done before.</source>
        <translation>annulé ; %1 contient ce qui a été fait avant.</translation>
    </message>
    <message>
        <source>This was cut short: what is here is not all.</source>
        <translation>Ceci a été interrompu : ce qui se trouve ici n’est pas tout.</translation>
    </message>
    <message>
        <source>Follows a stereo video, or a series of clouds, from a registered start. Every frame is processed; one mesh a frame is written, numbered like its input, and a line of frames.jsonl with the level, the reason and the pose. What Ctrl-C or an error cuts short is kept and marked INCOMPLETE.</source>
        <translation>Suit une vidéo stéréo, ou une série de nuages, depuis un départ recalé. Chaque image est traitée ; un maillage par image est écrit, numéroté comme son entrée, et une ligne de frames.jsonl avec le niveau, la raison et la pose. Ce que Ctrl-C ou une erreur interrompt est conservé et marqué INCOMPLETE.</translation>
    </message>
    <message>
        <source>How clouds are followed: forces, springs, or automatic, each as in &apos;glisson register&apos;.</source>
        <translation>Comment les nuages sont suivis : forces, springs (ressorts) ou automatic, comme dans &apos;glisson register&apos;.</translation>
    </message>
    <message>
        <source>Steps of the springs towards each cloud.</source>
        <translation>Pas des ressorts vers chaque nuage.</translation>
    </message>
    <message>
        <source>live: longest time until a right overlay is back after a jump, s</source>
        <translation>live : temps le plus long jusqu&apos;au retour d&apos;une superposition juste après un saut, s</translation>
    </message>
    <message>
        <source>live: error over that of a model that stays, in the worst scenario</source>
        <translation>live : erreur rapportée à celle d&apos;un modèle immobile, dans le pire cas</translation>
    </message>
    <message>
        <source>live: single lesions over 10 mm off that are not drawn as such, share</source>
        <translation>live : lésions isolées à plus de 10 mm, non dessinées comme telles, part</translation>
    </message>
    <message>
        <source>live: single lesions under 3 mm off without a fault that are, share</source>
        <translation>live : lésions isolées à moins de 3 mm sans défaut, dessinées, part</translation>
    </message>
    <message>
        <source>live, long: mean error since the start where the organ has moved, mm</source>
        <translation>direct, long : erreur moyenne depuis le début, là où l&apos;organe a bougé, mm</translation>
    </message>
    <message>
        <source>live, long: how far it has moved there, mean, mm</source>
        <translation>direct, long : de combien il y a bougé, en moyenne, mm</translation>
    </message>
    <message>
        <source>live, long: error over the organ&apos;s own motion, in the worst film (hands, tools)</source>
        <translation>direct, long : erreur rapportée au mouvement propre de l&apos;organe, dans le pire film (mains, instruments)</translation>
    </message>
    <message>
        <source>live, long: frames over 10 mm at a lesion that are shown</source>
        <translation>direct, long : images montrées qui sont fausses de plus de 10 mm à une lésion</translation>
    </message>
    <message>
        <source>registrations over 10 mm at a lesion, refused or doubted, share</source>
        <translation>recalages à plus de 10 mm à une lésion, refusés ou mis en doute, part</translation>
    </message>
    <message>
        <source>registrations under 3 mm at all lesions, doubted, share</source>
        <translation>recalages à moins de 3 mm à toutes les lésions, mis en doute, part</translation>
    </message>
    <message>
        <source>lesions within their 95 % ellipsoid, share, at least</source>
        <translation>lésions dans leur ellipsoïde à 95 %, part, au moins</translation>
    </message>
    <message>
        <source>lesions outside of their 95 % ellipsoid, share</source>
        <translation>lésions hors de leur ellipsoïde à 95 %, part</translation>
    </message>
    <message>
        <source>expected against true error of a lesion, correlation</source>
        <translation>erreur attendue contre erreur vraie d&apos;une lésion, corrélation</translation>
    </message>
    <message>
        <source>mean error, 30 % of the surface seen, mm</source>
        <translation>erreur moyenne, 30 % de la surface vue, mm</translation>
    </message>
    <message>
        <source>mean error, 20 % of the surface seen, mm</source>
        <translation>erreur moyenne, 20 % de la surface vue, mm</translation>
    </message>
    <message>
        <source>registrations over 2.5 mm on average, 30 % seen, not doubted, share</source>
        <translation>recalages à plus de 2,5 mm en moyenne, 30 % de la surface vue, non mis en doute, part</translation>
    </message>
    <message>
        <source>registrations over 4 mm on average, 20 % seen, not doubted, share</source>
        <translation>recalages à plus de 4 mm en moyenne, 20 % de la surface vue, non mis en doute, part</translation>
    </message>
    <message>
        <source>registrations over 6 mm on average, 10 % seen, not doubted, share</source>
        <translation>recalages à plus de 6 mm en moyenne, 10 % de la surface vue, non mis en doute, part</translation>
    </message>
    <message>
        <source>cases in which the best rigid alignment is beaten, share</source>
        <translation>cas où le meilleur recalage rigide est battu, part</translation>
    </message>
    <message>
        <source>elastic_sequence: mean error of the first of its frames, mm</source>
        <translation>elastic_sequence&#xa0;: erreur moyenne de la première image, mm</translation>
    </message>
    <message>
        <source>elastic_sequence: mean error over its 50 frames, followed, mm</source>
        <translation>elastic_sequence&#xa0;: erreur moyenne sur les 50 images, suivies, mm</translation>
    </message>
    <message>
        <source>held organs: mean error of the worst of them, clouds without noise, mm</source>
        <translation>organes tenus&#xa0;: erreur moyenne du pire d&apos;entre eux, nuages sans bruit, mm</translation>
    </message>
    <message>
        <source>held organs: mean error of the worst frame of any, followed, clouds without noise, mm</source>
        <translation>organes tenus&#xa0;: erreur moyenne de la pire image, suivie, nuages sans bruit, mm</translation>
    </message>
    <message>
        <source>loose organs, place unknown: mean error, clouds without noise, mm</source>
        <translation>organes libres, place inconnue&#xa0;: erreur moyenne, nuages sans bruit, mm</translation>
    </message>
    <message>
        <source>live: largest error at a lesion with a scope in a hand, mean over frames, mm</source>
        <translation>live : plus grande erreur sur une lésion, endoscope tenu à la main, moyenne sur les images, mm</translation>
    </message>
    <message>
        <source>There is one processor core: the live view needs two.</source>
        <translation>Il y a un seul cœur de processeur : la vue en direct en demande deux.</translation>
    </message>
    <message>
        <source>There are %1 GB of memory: large CTs need 8.</source>
        <translation>Il y a %1 Go de mémoire : les grands scanners en demandent 8.</translation>
    </message>
    <message>
        <source>%1 has %2 GB left: archives are unpacked there.</source>
        <translation>Il reste %2 Go dans %1 : les archives y sont décompressées.</translation>
    </message>
    <message>
        <source>There is no display: the window cannot open, all else works.</source>
        <translation>Il n’y a pas d’écran : la fenêtre ne peut pas s’ouvrir, tout le reste fonctionne.</translation>
    </message>
    <message>
        <source>Tells what the program finds on this machine, tries out what it needs and says what is missing. Reads no patient&apos;s data.</source>
        <translation>Dit ce que le programme trouve sur cette machine, essaie ce dont il a besoin et dit ce qui manque. Ne lit aucune donnée de patient.</translation>
    </message>
    <message>
        <source>missing: </source>
        <translation>manque : </translation>
    </message>
    <message>
        <source>Does the same over and over, frames, opening and saving, edits with undo, and looks whether memory, file descriptors and threads stay what they are.</source>
        <translation>Fait la même chose encore et encore, images, ouvertures et enregistrements, modifications avec annulation, et regarde si la mémoire, les descripteurs de fichiers et les fils d’exécution restent ce qu’ils sont.</translation>
    </message>
    <message>
        <source>A case with a video and a registration; else one is made.</source>
        <translation>Un cas avec une vidéo et un recalage ; sinon il en est fait un.</translation>
    </message>
    <message>
        <source>Frames to follow and draw.</source>
        <translation>Images à suivre et à dessiner.</translation>
    </message>
    <message>
        <source>Times to open and save the case.</source>
        <translation>Nombre d’ouvertures et d’enregistrements du cas.</translation>
    </message>
    <message>
        <source>Edits with their undo.</source>
        <translation>Modifications, chacune avec son annulation.</translation>
    </message>
    <message>
        <source>Times to kill the program at work (import, save, record) and look what is left.</source>
        <translation>Nombre de fois où le programme est tué au travail (import, enregistrement, vidéo) et où l’on regarde ce qui reste.</translation>
    </message>
    <message>
        <source>Also write the figures here, as a page.</source>
        <translation>Écrire aussi les chiffres ici, en une page.</translation>
    </message>
    <message>
        <source>Tell what this machine has and lacks for the program</source>
        <translation>Dire ce que cette machine a et ce qui lui manque pour le programme</translation>
    </message>
    <message>
        <source>Work for long and look whether memory, files and threads stay what they are</source>
        <translation>Travailler longtemps et regarder si la mémoire, les fichiers et les fils d’exécution restent ce qu’ils sont</translation>
    </message>
    <message>
        <source>real CTs, ten clicks of a layperson: Dice of the liver, median</source>
        <translation>CT réels, dix clics d’un profane : Dice du foie, médiane</translation>
    </message>
    <message>
        <source>real CTs, ten clicks of a layperson: Dice of the liver, worst</source>
        <translation>CT réels, dix clics d’un profane : Dice du foie, le pire</translation>
    </message>
    <message>
        <source>real CT, altered, ten clicks of a layperson: Dice of the liver, median</source>
        <translation>CT réel modifié, dix clics d’un profane : Dice du foie, médiane</translation>
    </message>
    <message>
        <source>real CT, altered, ten clicks of a layperson: Dice of the liver, worst</source>
        <translation>CT réel modifié, dix clics d’un profane : Dice du foie, le pire</translation>
    </message>
    <message>
        <source>in silico, ill livers, ten clicks of a layperson: Dice of the liver, median</source>
        <translation>in silico, foies malades, dix clics d’un profane : Dice du foie, médiane</translation>
    </message>
    <message>
        <source>in silico, ill livers, ten clicks of a layperson: Dice of the liver, worst</source>
        <translation>in silico, foies malades, dix clics d’un profane : Dice du foie, le pire</translation>
    </message>
    <message>
        <source>in silico, ill livers, ten clicks and three corrections: Dice of the liver, worst</source>
        <translation>in silico, foies malades, dix clics et trois corrections : Dice du foie, le pire</translation>
    </message>
    <message>
        <source>real CT, altered, ten clicks and three corrections: Dice of the liver, worst</source>
        <translation>scanner réel, modifié, dix clics et trois corrections : Dice du foie, le pire</translation>
    </message>
    <message>
        <source>real CTs, ten clicks and three corrections: Dice of the liver, worst</source>
        <translation>scanners réels, dix clics et trois corrections : Dice du foie, le pire</translation>
    </message>
    <message>
        <source>real CT, lesions above 1 ml, one click: Dice, median</source>
        <translation>CT réel, lésions de plus de 1 ml, un clic : Dice, médiane</translation>
    </message>
    <message>
        <source>in silico, lesions above 1 ml, one click: Dice, median</source>
        <translation>in silico, lésions de plus de 1 ml, un clic : Dice, médiane</translation>
    </message>
    <message>
        <source>How the shape is found: forces (few contact forces on the surface, elastic law by evidence), springs, paper (springs with --prior none, as published) or automatic (forces where operations are known and for a bare mesh with --fixed; springs where no force is worth its price, and otherwise).</source>
        <translation>Comment la forme est trouvée : forces (peu de forces de contact sur la surface, loi élastique selon l&apos;évidence), springs (ressorts), paper (ressorts avec --prior none, comme publié) ou automatic (forces là où des opérations sont connues et pour un maillage nu avec --fixed ; ressorts là où aucune force ne vaut son prix, et sinon).</translation>
    </message>
    <message>
        <source>Write the result even if it is refused; its doubts stay with it. Without this a refused registration writes no file, and the exit code is 3.</source>
        <translation>Écrire le résultat même s&apos;il est refusé ; ses doutes restent avec lui. Sinon un recalage refusé n&apos;écrit aucun fichier et le code de sortie est 3.</translation>
    </message>
    <message>
        <source>The registration was refused: what is known contradicts it (see the notes above). No mesh was written. Give a cloud that shows more of this patient&apos;s liver with less noise, mark margin and notch, or start from --rigid FILE; --accept-doubts writes it nevertheless.</source>
        <translation>Le recalage a été refusé : ce que l&apos;on sait le contredit (voir les notes ci-dessus). Aucun maillage n&apos;a été écrit. Donnez un nuage qui montre davantage du foie de ce patient avec moins de bruit, marquez le bord et l&apos;encoche, ou partez de --rigid FILE ; --accept-doubts l&apos;écrit malgré tout.</translation>
    </message>
    <message>
        <source>--lock %1: is no label. Use parenchyma, portal_vein, hepatic_veins, vena_cava, gallbladder or lesion_1, lesion_2, ..., with commas.</source>
        <translation>--lock %1 : n&apos;est pas une étiquette. Utilisez parenchyma, portal_vein, hepatic_veins, vena_cava, gallbladder ou lesion_1, lesion_2, ..., séparés par des virgules.</translation>
    </message>
    <message>
        <source>These labels neither lose nor gain a voxel: parenchyma, portal_vein, hepatic_veins, vena_cava, gallbladder, lesion_1, ..., with commas.</source>
        <translation>Ces étiquettes ne perdent ni ne gagnent de voxel : parenchyma, portal_vein, hepatic_veins, vena_cava, gallbladder, lesion_1, ..., séparés par des virgules.</translation>
    </message>
    <message>
        <source>live, heart: frames over 10 mm that are not valid, share</source>
        <translation>en direct, cœur : images à plus de 10 mm qui ne sont pas valides, part</translation>
    </message>
    <message>
        <source>live, heart: frames under 3 mm without a fault that are valid, share</source>
        <translation>en direct, cœur : images à moins de 3 mm sans défaut qui sont valides, part</translation>
    </message>
    <message>
        <source>live, tissue: frames over 10 mm that are not valid, share</source>
        <translation>en direct, tissu : images à plus de 10 mm qui ne sont pas valides, part</translation>
    </message>
    <message>
        <source>live, tissue: frames under 3 mm without a fault that are valid, share</source>
        <translation>en direct, tissu : images à moins de 3 mm sans défaut qui sont valides, part</translation>
    </message>
    <message>
        <source>live, tissue: longest time until an overlay goes, s</source>
        <translation>en direct, tissu : temps le plus long avant que la superposition disparaisse, s</translation>
    </message>
    <message>
        <source>live, tissue: largest error at a place below the surface with a scope in a hand, mean over frames, mm</source>
        <translation>en direct, tissu : plus grande erreur en un point sous la surface avec un laparoscope tenu à la main, moyenne sur les images, mm</translation>
    </message>
    <message>
        <source>live, tissue: longest time until a right overlay is back after a jump, s</source>
        <translation>en direct, tissu : temps le plus long jusqu’au retour d’une superposition juste après un saut, s</translation>
    </message>
    <message>
        <source>live, tissue: error over that of a model that stays, in the worst scenario</source>
        <translation>en direct, tissu : erreur rapportée à celle d’un modèle immobile, dans le pire cas</translation>
    </message>
    <message>
        <source>live, heart: longest time until an overlay goes, s</source>
        <translation>en direct, cœur : temps le plus long avant que la superposition disparaisse, s</translation>
    </message>
    <message>
        <source>live, heart: largest error at a place below the surface with a scope in a hand, mean over frames, mm</source>
        <translation>en direct, cœur : plus grande erreur en un point sous la surface avec un laparoscope tenu à la main, moyenne sur les images, mm</translation>
    </message>
    <message>
        <source>live, heart: longest time until a right overlay is back after a jump, s</source>
        <translation>en direct, cœur : temps le plus long jusqu’au retour d’une superposition juste après un saut, s</translation>
    </message>
    <message>
        <source>live, heart: error over that of a model that stays, in the worst scenario</source>
        <translation>en direct, cœur : erreur rapportée à celle d’un modèle immobile, dans le pire cas</translation>
    </message>
    <message>
        <source>Each liver foretold by the others (mm, in silico where the livers are synthetic):</source>
        <translation>Chaque foie prédit par les autres (mm, in silico là où les foies sont synthétiques) :</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>surface</translation>
    </message>
    <message>
        <source>%1: %2 livers, %3 vertices, %4 modes</source>
        <translation>%1 : %2 foies, %3 sommets, %4 modes</translation>
    </message>
    <message>
        <source>%1: from %2 livers (%3), %4 mm</source>
        <translation>%1 : d&apos;après %2 foies (%3), %4 mm</translation>
    </message>
    <message>
        <source>; with its notch known: %1</source>
        <translation>; échancrure connue : %1</translation>
    </message>
    <message>
        <source>; follows: %1</source>
        <translation>; suit : %1</translation>
    </message>
    <message>
        <source>No landmark follows another: this atlas does not know how they depend.</source>
        <translation>Aucun repère n&apos;en suit un autre : cet atlas ne sait pas comment ils dépendent les uns des autres.</translation>
    </message>
    <message>
        <source>%1 differs from the others: weight %2</source>
        <translation>%1 diffère des autres : poids %2</translation>
    </message>
    <message>
        <source>--accept: %1 is no structure.</source>
        <translation>--accept : %1 n&apos;est pas une structure.</translation>
    </message>
    <message>
        <source>Landmarks that the CT does not show. &apos;build CASE... --out A&apos; makes an atlas of reviewed cases, &apos;evaluate CASE...&apos; foretells each of them by the others, &apos;show&apos; tells what an atlas knows, &apos;transfer --case C&apos; proposes landmarks on a patient&apos;s liver.</source>
        <translation>Repères que le scanner ne montre pas. « build CAS... --out A » fait un atlas de cas révisés, « evaluate CAS... » prédit chacun par les autres, « show » dit ce qu&apos;un atlas sait, « transfer --case C » propose des repères sur le foie d&apos;un patient.</translation>
    </message>
    <message>
        <source>build, evaluate, show or transfer.</source>
        <translation>build, evaluate, show ou transfer.</translation>
    </message>
    <message>
        <source>Cases with a model, for build and evaluate: five at least.</source>
        <translation>Cas avec un modèle, pour build et evaluate : cinq au moins.</translation>
    </message>
    <message>
        <source>An atlas&apos; folder instead of the built-in atlas.</source>
        <translation>Dossier d&apos;un atlas à la place de l&apos;atlas intégré.</translation>
    </message>
    <message>
        <source>Folder for the atlas that is built.</source>
        <translation>Dossier de l&apos;atlas à construire.</translation>
    </message>
    <message>
        <source>Name of the atlas that is built.</source>
        <translation>Nom de l&apos;atlas à construire.</translation>
    </message>
    <message>
        <source>Proposals to accept unseen, with commas: umbilical_notch, vena_cava, ...</source>
        <translation>Propositions à accepter sans les voir, avec des virgules : umbilical_notch, vena_cava, ...</translation>
    </message>
    <message>
        <source>Add this many livers of the synthetic population, from --seed on.</source>
        <translation>Ajouter autant de foies de la population synthétique, à partir de --seed.</translation>
    </message>
    <message>
        <source>What the livers do not show of how patients differ, mm, added to every landmark.</source>
        <translation>Ce que les foies ne montrent pas des différences entre patients, mm, ajouté à chaque repère.</translation>
    </message>
    <message>
        <source>Begin with the synthetic template instead of an atlas.</source>
        <translation>Commencer par le gabarit synthétique au lieu d&apos;un atlas.</translation>
    </message>
    <message>
        <source>Keep the atlas&apos; mean liver and its modes, and learn from the cases where structures lie on it.</source>
        <translation>Garder le foie moyen de l&apos;atlas et ses modes, et apprendre des cas où les structures s&apos;y trouvent.</translation>
    </message>
    <message>
        <source>Keep of the cases means and mean squares alone: no names, no single liver.</source>
        <translation>Ne garder des cas que les moyennes et les carrés moyens : ni noms, ni foie isolé.</translation>
    </message>
    <message>
        <source>Add the label maps of --data that served development, as this file says where notch, falciform ligament and margin lie on them.</source>
        <translation>Ajouter les cartes d&apos;étiquettes de --data qui ont servi au développement ; ce fichier dit où s&apos;y trouvent l&apos;échancrure, le ligament falciforme et le bord.</translation>
    </message>
    <message>
        <source>Folder of the real data.</source>
        <translation>Dossier des données réelles.</translation>
    </message>
    <message>
        <source>%1: is no action. See &apos;glisson atlas --help&apos;.</source>
        <translation>%1 : n&apos;est pas une action. Voir « glisson atlas --help ».</translation>
    </message>
    <message>
        <source>Measures the proofs&apos; figures again, against experts&apos; labels and known truths. %1.</source>
        <translation>Mesure à nouveau les chiffres des preuves, par rapport aux étiquettes d&apos;experts et à des vérités connues. %1.</translation>
    </message>
    <message>
        <source>Which: %1.</source>
        <translation>Laquelle&#xa0;: %1.</translation>
    </message>
    <message>
        <source>From the CT to the model</source>
        <translation>Du scanner au modèle</translation>
    </message>
    <message>
        <source>From the laparoscope&apos;s pictures to clouds</source>
        <translation>Des images du laparoscope aux nuages</translation>
    </message>
    <message>
        <source>How far off a registration is, and whether it says so</source>
        <translation>L&apos;erreur d&apos;un recalage, et s&apos;il l&apos;annonce</translation>
    </message>
    <message>
        <source>What the live overlay says of itself when something is wrong</source>
        <translation>Ce que la superposition en direct dit d&apos;elle-même quand quelque chose ne va pas</translation>
    </message>
    <message>
        <source>Bare organs that are pulled at a few places</source>
        <translation>Organes sans anatomie, tirés en quelques endroits</translation>
    </message>
    <message>
        <source>Landmarks that the CT does not show</source>
        <translation>Repères que le scanner ne montre pas</translation>
    </message>
    <message>
        <source>%1: leave the validation patients alone, as when limits are set.</source>
        <translation>%1 : ne pas toucher aux patients de validation, comme lors du choix des limites.</translation>
    </message>
    <message>
        <source>Landmarks that the CT does not show: build, show and transfer an atlas</source>
        <translation>Repères que le scanner ne montre pas : construire, montrer et transférer un atlas</translation>
    </message>
    <message>
        <source>real livers by the others: surface, mean, mm</source>
        <translation>foies réels par les autres : surface, moyenne, mm</translation>
    </message>
    <message>
        <source>real livers by the others: surface, worst liver, mm</source>
        <translation>foies réels par les autres : surface, pire foie, mm</translation>
    </message>
    <message>
        <source>real livers by the others: correspondence, worst liver, mm</source>
        <translation>foies réels par les autres : correspondance, pire foie, mm</translation>
    </message>
    <message>
        <source>real livers by the others: vena cava&apos;s contact, mean, mm</source>
        <translation>foies réels par les autres : contact de la veine cave, moyenne, mm</translation>
    </message>
    <message>
        <source>real livers by the others: vena cava&apos;s contact, worst liver, mm</source>
        <translation>foies réels par les autres : contact de la veine cave, pire foie, mm</translation>
    </message>
    <message>
        <source>real livers by the others: portal vein&apos;s entrance, mean, mm</source>
        <translation>foies réels par les autres : entrée de la veine porte, moyenne, mm</translation>
    </message>
    <message>
        <source>real livers by the others: portal vein&apos;s entrance, worst liver, mm</source>
        <translation>foies réels par les autres : entrée de la veine porte, pire foie, mm</translation>
    </message>
    <message>
        <source>real livers by the others: truth within the 95 % ellipsoids, at least</source>
        <translation>foies réels par les autres : vérité dans les ellipsoïdes à 95 %, au moins</translation>
    </message>
    <message>
        <source>real livers by the others: truth within the 95 % ellipsoids, at most</source>
        <translation>foies réels par les autres : vérité dans les ellipsoïdes à 95 %, au plus</translation>
    </message>
    <message>
        <source>validation livers by the others: truth within the 95 % ellipsoids</source>
        <translation>foies de validation par les autres : vérité dans les ellipsoïdes à 95 %</translation>
    </message>
    <message>
        <source>real livers by the built-in atlas: vena cava&apos;s contact, mean, mm</source>
        <translation>foies réels par l&apos;atlas intégré : contact de la veine cave, moyenne, mm</translation>
    </message>
    <message>
        <source>real livers by the built-in atlas: truth within the 95 % ellipsoids</source>
        <translation>foies réels par l&apos;atlas intégré : vérité dans les ellipsoïdes à 95 %</translation>
    </message>
    <message>
        <source>validation livers by the built-in atlas: truth within the 95 % ellipsoids</source>
        <translation>foies de validation par l&apos;atlas intégré : vérité dans les ellipsoïdes à 95 %</translation>
    </message>
    <message>
        <source>real livers mirrored: share that is refused</source>
        <translation>foies réels en miroir : part qui est refusée</translation>
    </message>
    <message>
        <source>transfer to a real liver, slowest, s</source>
        <translation>transfert sur un foie réel, le plus lent, s</translation>
    </message>
    <message>
        <source>building from the real livers, s</source>
        <translation>construction à partir des foies réels, s</translation>
    </message>
    <message>
        <source>in silico: surface, mean, mm</source>
        <translation>in silico : surface, moyenne, mm</translation>
    </message>
    <message>
        <source>real livers by the others: umbilical notch, mean, mm</source>
        <translation>foies réels par les autres : échancrure ombilicale, moyenne, mm</translation>
    </message>
    <message>
        <source>real livers by the others: umbilical notch, worst liver, mm</source>
        <translation>foies réels par les autres : échancrure ombilicale, pire foie, mm</translation>
    </message>
    <message>
        <source>real livers by the built-in atlas and the portal vein: umbilical notch, mean, mm</source>
        <translation>foies réels par l&apos;atlas intégré et la veine porte : échancrure ombilicale, moyenne, mm</translation>
    </message>
    <message>
        <source>in silico: umbilical notch, mean, mm</source>
        <translation>in silico : échancrure ombilicale, moyenne, mm</translation>
    </message>
    <message>
        <source>in silico: umbilical notch, worst liver, mm</source>
        <translation>in silico : échancrure ombilicale, pire foie, mm</translation>
    </message>
    <message>
        <source>in silico: anterior margin, mean, mm</source>
        <translation>in silico : bord antérieur, moyenne, mm</translation>
    </message>
    <message>
        <source>in silico: truth within the 95 % ellipsoids, at least</source>
        <translation>in silico : vérité dans les ellipsoïdes à 95 %, au moins</translation>
    </message>
    <message>
        <source>in silico: truth within the 95 % ellipsoids, at most</source>
        <translation>in silico : vérité dans les ellipsoïdes à 95 %, au plus</translation>
    </message>
    <message>
        <source>registration with the atlas&apos;s landmarks: error over that with none</source>
        <translation>recalage avec les repères de l&apos;atlas : erreur sur celle sans repères</translation>
    </message>
    <message>
        <source>registration: two patients of either set and one share that is seen; pulled: two organs of a kind.</source>
        <translation>registration : deux patients de chaque ensemble et une seule part visible ; pulled : deux organes de chaque sorte.</translation>
    </message>
    <message>
        <source>%1: follow a scope in a fast hand, tools that lift and press, and 3,000 frames, too.</source>
        <translation>%1 : suit aussi un laparoscope tenu d’une main rapide, des outils qui soulèvent et appuient, et 3 000 images.</translation>
    </message>
    <message>
        <source>%1: keep what DIR/registration_SEED.csv holds of a run that was cut short.</source>
        <translation>%1 : garde ce que DIR/registration_SEED.csv contient d’une exécution interrompue.</translation>
    </message>
    <message>
        <source>This computer&apos;s kernel does not shut in the programs that read foreign files: read only files that you trust.</source>
        <translation>Le noyau de cet ordinateur n&apos;enferme pas les programmes qui lisent des fichiers étrangers : ne lisez que des fichiers auxquels vous vous fiez.</translation>
    </message>
    <message>
        <source>A pixel of the left picture where a tool touches the organ: the lesion&apos;s distance from there is told, too.</source>
        <translation>Un pixel de l&apos;image gauche où un instrument touche l&apos;organe : la distance de la lésion à ce point est aussi donnée.</translation>
    </message>
    <message>
        <source>How depth is told: %1.</source>
        <translation>Comment la profondeur est montrée : %1.</translation>
    </message>
    <message>
        <source>Draw thin distal branches of vessels, too.</source>
        <translation>Dessiner aussi les branches distales fines des vaisseaux.</translation>
    </message>
    <message>
        <source>A folder that &apos;glisson track&apos; filled for this case and video: what was known then is drawn again, and nothing is followed.</source>
        <translation>Un dossier que &apos;glisson track&apos; a rempli pour ce cas et cette vidéo : ce qui était connu alors est dessiné de nouveau, et rien n&apos;est suivi.</translation>
    </message>
    <message>
        <source>A folder that &apos;glisson track&apos; filled for this case and video, or NAME.frames.jsonl that the window wrote beside a recording: what was known then is drawn again, and nothing is followed.</source>
        <translation>Un dossier que &apos;glisson track&apos; a rempli pour ce cas et cette vidéo, ou NAME.frames.jsonl que la fenêtre a écrit à côté d&apos;un enregistrement : ce que l&apos;on savait alors est dessiné de nouveau, et rien n&apos;est suivi.</translation>
    </message>
    <message>
        <source>Look at this lesion and tell its numbers, as lesion_1.</source>
        <translation>Regarder cette lésion et donner ses chiffres, par exemple lesion_1.</translation>
    </message>
    <message>
        <source>The file of --rigid is near the right place only: refined rigidly first, as a model that was placed by hand.</source>
        <translation>Le fichier de --rigid n’est que proche de la bonne position : d’abord affiné rigidement, comme un modèle placé à la main.</translation>
    </message>
    <message>
        <source>Takes the N-th of the other places where the organ may be (rival_N_probability, rival_N_away_mm) instead of the most probable one.</source>
        <translation>Prend la N-ième des autres positions possibles de l’organe (rival_N_probability, rival_N_away_mm) au lieu de la plus probable.</translation>
    </message>
    <message>
        <source>Also write a page on the registration: how it ended, how far off organ and lesions may be, where else the organ may be, its doubts.</source>
        <translation>Écrit aussi une page sur le recalage : comment il s&apos;est terminé, de combien l&apos;organe et les lésions peuvent être décalés, où l&apos;organe peut se trouver ailleurs, ses doutes.</translation>
    </message>
    <message>
        <source>How unusual the livers were that --added-deviation was set on, over what is usual: it grows only beyond that.</source>
        <translation>À quel point les foies sur lesquels --added-deviation a été fixé étaient inhabituels, par rapport à l’usuel : il ne croît qu’au-delà.</translation>
    </message>
    <message>
        <source>number %1</source>
        <translation>numéro %1</translation>
    </message>
    <message>
        <source>%1 slices</source>
        <translation>%1 coupes</translation>
    </message>
    <message>
        <source>Only tell which DICOM series there are, the likeliest first.</source>
        <translation>Dire seulement quelles séries DICOM il y a, la plus probable d&apos;abord.</translation>
    </message>
    <message>
        <source>real CT, lesions above 1 ml, a line drawn across: Dice, median</source>
        <translation>CT réel, lésions de plus de 1 ml, un trait en travers : Dice, médiane</translation>
    </message>
    <message>
        <source>in silico, lesions above 1 ml, a line drawn across: Dice, median</source>
        <translation>in silico, lésions de plus de 1 ml, un trait en travers : Dice, médiane</translation>
    </message>
    <message>
        <source>real CT, altered: Dice of the portal vein in the liver, median</source>
        <translation>CT réel, modifié : Dice de la veine porte dans le foie, médiane</translation>
    </message>
    <message>
        <source>real CT, altered: Dice of the hepatic veins in the liver, median</source>
        <translation>CT réel, modifié : Dice des veines hépatiques dans le foie, médiane</translation>
    </message>
    <message>
        <source>in silico, ill livers: Dice of the portal vein in the liver, median</source>
        <translation>in silico, foies malades : Dice de la veine porte dans le foie, médiane</translation>
    </message>
    <message>
        <source>in silico, ill livers: Dice of the hepatic veins in the liver, median</source>
        <translation>in silico, foies malades : Dice des veines hépatiques dans le foie, médiane</translation>
    </message>
    <message>
        <source>A video in %1 could not be written and read back here: OpenCV&apos;s FFmpeg lacks it.</source>
        <translation>Une vidéo en %1 n’a pas pu être écrite puis relue ici : le FFmpeg d’OpenCV ne le sait pas.</translation>
    </message>
    <message>
        <source>Corrections by hand, a line of JSON each: {&quot;frame&quot;: 12, &quot;correct&quot;: {&quot;view&quot;: &quot;left&quot;, &quot;from&quot;: [480, 270], &quot;to&quot;: [492, 274]}}: what is drawn at the one pixel is seen at the other; &quot;correct&quot;: &quot;undo&quot; takes the last one back. What frames.jsonl says of corrections can be given.</source>
        <translation>Corrections à la main, une ligne JSON chacune : {&quot;frame&quot;: 12, &quot;correct&quot;: {&quot;view&quot;: &quot;left&quot;, &quot;from&quot;: [480, 270], &quot;to&quot;: [492, 274]}} : ce qui est dessiné au premier pixel se voit au second ; &quot;correct&quot;: &quot;undo&quot; annule la dernière. Ce que frames.jsonl dit de corrections peut être donné.</translation>
    </message>
    <message>
        <source>Also write the labels here (.seg.nrrd, .nii.gz; .dcm: DICOM segmentation).</source>
        <translation>Écrire aussi les étiquettes ici (.seg.nrrd, .nii.gz ; .dcm : segmentation DICOM).</translation>
    </message>
    <message>
        <source>Look for the liver without a click in it. Look at what comes of it.</source>
        <translation>Chercher le foie sans un clic. Regardez ce qui en résulte.</translation>
    </message>
    <message>
        <source>Correct the case&apos;s labels around the clicks on the liver, beside it, on its veins and on lesions that the case does not have yet; the labels elsewhere stay.</source>
        <translation>Corriger les étiquettes du cas autour des clics sur le foie, à côté de lui, sur ses veines et sur des lésions que le cas n’a pas encore ; ailleurs les étiquettes restent.</translation>
    </message>
    <message>
        <source>Listens at this address and tells programs that connect by OpenIGTLink (3D Slicer, CustusX, PLUS) of each frame: level, pose, surfaces. Without an address 127.0.0.1:18944, which other computers do not reach; port 0: a free one.</source>
        <translation>Attend à cette adresse et communique chaque image aux programmes qui se connectent par OpenIGTLink (3D Slicer, CustusX, PLUS) : niveau, pose, surfaces. Sans adresse 127.0.0.1:18944, que d&apos;autres ordinateurs n&apos;atteignent pas ; port 0 : un port libre.</translation>
    </message>
    <message>
        <source>With --igtl-send: begins when a program has connected.</source>
        <translation>Avec --igtl-send : commence lorsqu&apos;un programme s&apos;est connecté.</translation>
    </message>
    <message>
        <source>OpenIGTLink: listening at %1.</source>
        <translation>OpenIGTLink : à l&apos;écoute à %1.</translation>
    </message>
    <message>
        <source>OpenIGTLink: listening at %1, where other computers may reach it.</source>
        <translation>OpenIGTLink : à l&apos;écoute à %1, où d&apos;autres ordinateurs peuvent l&apos;atteindre.</translation>
    </message>
    <message>
        <source>Of labels that were corrected by hand keep each voxel that was, and replace the rest.</source>
        <translation>Des étiquettes corrigées à la main, garder chaque voxel corrigé et remplacer le reste.</translation>
    </message>
    <message>
        <source>Replace labels that were corrected by hand, corrections and all. Without these two it is only told what would change.</source>
        <translation>Remplacer les étiquettes corrigées à la main, corrections comprises. Sans ces deux options, il est seulement dit ce qui changerait.</translation>
    </message>
    <message>
        <source>Registers again every so many seconds of the video, with what has been seen of the organ since; taken where it is better by tissue that neither registration has used.</source>
        <translation>Recale à nouveau toutes les tant de secondes de la vidéo, avec ce qui a été vu de l’organe depuis ; adopté s’il est meilleur d’après du tissu qu’aucun des deux recalages n’a utilisé.</translation>
    </message>
    <message>
        <source>The cloud (PLY) that the start was registered to: --register-again goes on from it, with what is marked in it (margin, notch).</source>
        <translation>Le nuage (PLY) sur lequel le départ a été recalé : --register-again part de lui, avec ce qui y est marqué (bord antérieur, échancrure).</translation>
    </message>
    <message>
        <source>Puts the registration off by so many millimetres before it is followed: across, down and away from the camera.</source>
        <translation>Décale le recalage d’autant de millimètres avant qu’il soit suivi : en travers, vers le bas et en s’éloignant de la caméra.</translation>
    </message>
    <message>
        <source>Registers again every so many seconds of the film.</source>
        <translation>Recale à nouveau toutes les tant de secondes du film.</translation>
    </message>
    <message>
        <source>--%1, --%2: give one of them.</source>
        <translation>--%1, --%2 : donnez l&apos;un des deux.</translation>
    </message>
    <message>
        <source>--%1: needs labels. Give --%2 FILE.</source>
        <translation>--%1 : il faut des étiquettes. Donnez --%2 FICHIER.</translation>
    </message>
    <message>
        <source>Segments the liver, its vessels and lesions from seeds, or by your own network.</source>
        <translation>Segmente le foie, ses vaisseaux et ses lésions à partir de germes, ou par votre propre réseau.</translation>
    </message>
    <message>
        <source>Your own segmentation network (ONNX) instead of seeds; MODEL.json beside it says what it wants and what its channels mean (see the manual).</source>
        <translation>Votre propre réseau de segmentation (ONNX) au lieu de germes ; MODEL.json à côté dit ce qu&apos;il lui faut et ce que ses canaux signifient (voir le manuel).</translation>
    </message>
    <message>
        <source>The mask network has failed; the organ is followed without it. %1</source>
        <translation>Le réseau de masque est en panne ; l’organe est suivi sans lui. %1</translation>
    </message>
    <message>
        <source>Your own network (ONNX) that says what of the left picture is not liver; MODEL.json beside it says what it wants. It only keeps points from pulling.</source>
        <translation>Votre propre réseau (ONNX) qui dit ce qui, dans l’image gauche, n’est pas du foie ; MODEL.json à côté dit ce qu’il veut. Il ne fait qu’empêcher des points de tirer.</translation>
    </message>
    <message>
        <source>Frames between two masks, each of which is waited for.</source>
        <translation>Images entre deux masques ; chacun est attendu.</translation>
    </message>
    <message>
        <source>--modality %1: write ct or mr.</source>
        <translation>--modality %1 : écrivez ct ou mr.</translation>
    </message>
    <message>
        <source>Reads a CT or MRI (a folder of DICOM slices or its DICOMDIR, a .zip or .tar.gz of one, NIfTI, NRRD, MetaImage) into a case, which is made if there is none.</source>
        <translation>Lit un scanner ou une IRM (un dossier de coupes DICOM ou son DICOMDIR, un .zip ou .tar.gz de l&apos;un d&apos;eux, NIfTI, NRRD, MetaImage) dans un cas, qui est créé s&apos;il n&apos;y en a pas.</translation>
    </message>
    <message>
        <source>ct or mr: what the volume is, where its file does not say.</source>
        <translation>ct ou mr : ce qu&apos;est le volume, si son fichier ne le dit pas.</translation>
    </message>
    <message>
        <source>%1: only whether one more look helps, where it is said to help most and joined from an unknown place.</source>
        <translation>%1 : seulement si un regard de plus aide, là où il est censé aider le plus et joint depuis un endroit inconnu.</translation>
    </message>
    <message>
        <source>Earlier looks at the same organ, which has not moved since: clouds (PLY), commas between them, each in its own camera&apos;s frame. Where they were seen from is found; the result is in the frame of --cloud.</source>
        <translation>Vues antérieures du même organe, qui n’a pas bougé depuis : nuages (PLY), séparés par des virgules, chacun dans le repère de sa caméra. D’où ils ont été vus est trouvé ; le résultat est dans le repère de --cloud.</translation>
    </message>
    <message>
        <source>falciform ligament at the notch</source>
        <translation>ligament falciforme à l’échancrure</translation>
    </message>
    <message>
        <source>vena cava</source>
        <translation>veine cave</translation>
    </message>
    <message>
        <source>both</source>
        <translation>les deux</translation>
    </message>
    <message>
        <source>mean Hausdorff distance, mm</source>
        <translation>distance de Hausdorff moyenne, mm</translation>
    </message>
    <message>
        <source>(a) place of the boundary conditions</source>
        <translation>(a) lieu des conditions aux limites</translation>
    </message>
    <message>
        <source>shift along the surface, mm</source>
        <translation>déplacement sur la surface, mm</translation>
    </message>
    <message>
        <source>(b) stiffness of the boundary conditions</source>
        <translation>(b) raideur des conditions aux limites</translation>
    </message>
    <message>
        <source>times the reference&apos;s stiffness</source>
        <translation>fois la raideur de référence</translation>
    </message>
    <message>
        <source>the atlas laid on livers</source>
        <translation>l’atlas posé sur des foies</translation>
    </message>
    <message>
        <source>umbilical notch (in silico)</source>
        <translation>échancrure ombilicale (in silico)</translation>
    </message>
    <message>
        <source>--flank: is %1. Give left or right.</source>
        <translation>--flank : vaut %1. Donnez left ou right.</translation>
    </message>
    <message>
        <source>Measures a figure of the paper again and sets it beside the paper&apos;s words: 5 (how well the atlas foretells surface, notch and vena cava), 6 (how much the shape on the flank depends on place and stiffness of the boundary conditions). Prints the table; writes page, table and plot.</source>
        <translation>Mesure à nouveau une figure de l’article et la place à côté de ses mots : 5 (avec quelle précision l’atlas prédit surface, échancrure et veine cave), 6 (combien la forme sur le flanc dépend du lieu et de la raideur des conditions aux limites). Affiche le tableau ; écrit la page, le tableau et le graphique.</translation>
    </message>
    <message>
        <source>The figure&apos;s number in the paper: 5 or 6.</source>
        <translation>Le numéro de la figure dans l’article : 5 ou 6.</translation>
    </message>
    <message>
        <source>5: folder of the real data; what is not there is left out.</source>
        <translation>5 : dossier des données réelles ; ce qui manque est omis.</translation>
    </message>
    <message>
        <source>6: a case with model, notch and vena cava, instead of the built-in synthetic patient.</source>
        <translation>6 : un cas avec modèle, échancrure et veine cave, au lieu du patient synthétique intégré.</translation>
    </message>
    <message>
        <source>6: the side that is down: left or right.</source>
        <translation>6 : le côté qui est en bas : left ou right.</translation>
    </message>
    <message>
        <source>Fewer trials: to see whether it runs.</source>
        <translation>Moins d’essais : pour voir si cela fonctionne.</translation>
    </message>
    <message>
        <source>The folder for page, table and plot.</source>
        <translation>Le dossier pour la page, le tableau et le graphique.</translation>
    </message>
    <message>
        <source>NUMBER: is %1. Give 5 or 6: no other figure is measured.</source>
        <translation>NUMBER : vaut %1. Donnez 5 ou 6 : aucune autre figure n’est mesurée.</translation>
    </message>
    <message>
        <source>Measure a figure of the paper again</source>
        <translation>Mesurer à nouveau une figure de l’article</translation>
    </message>
    <message>
        <source>liver (s: synthetic; * not in the atlas)</source>
        <translation>foie (s : synthétique ; * hors de l’atlas)</translation>
    </message>
    <message>
        <source>Also simulates operations on it, on which every registration of this case then rests: some seconds that no registration takes.</source>
        <translation>Simule aussi des opérations dessus, sur lesquelles repose ensuite chaque recalage de ce cas : quelques secondes qu’aucun recalage ne prendra plus.</translation>
    </message>
    <message>
        <source>Also write the surfaces of the liver and each structure into this folder, LPS mm, without the patient&apos;s name.</source>
        <translation>Écrire aussi les surfaces du foie et de chaque structure dans ce dossier, LPS mm, sans le nom du patient.</translation>
    </message>
    <message>
        <source>Of these surfaces: stl, ply, obj or vtp.</source>
        <translation>Format de ces surfaces : stl, ply, obj ou vtp.</translation>
    </message>
    <message>
        <source>--format %1: write stl, ply, obj or vtp.</source>
        <translation>--format %1 : écrivez stl, ply, obj ou vtp.</translation>
    </message>
    <message>
        <source>The raw views that were recorded with --track&apos;s file: drawn into instead of the case&apos;s video, as of a live device.</source>
        <translation>Les vues brutes enregistrées avec le fichier de --track : on y dessine au lieu de la vidéo du cas, comme pour un appareil en direct.</translation>
    </message>
    <message>
        <source>The laparoscope stands. Otherwise a hand holds it: it turns about the trocar, comes nearer, goes away and rolls.</source>
        <translation>Le laparoscope ne bouge pas. Sinon une main le tient : il tourne autour du trocart, s&apos;approche, s&apos;éloigne et roule.</translation>
    </message>
    <message>
        <source>Landmarks that the CT does not show. &apos;build CASE... --out A&apos; makes an atlas of reviewed cases, &apos;evaluate CASE...&apos; foretells each of them by the others, &apos;show&apos; tells what an atlas knows, &apos;show --case C&apos; where a case&apos;s landmarks come from, &apos;transfer --case C&apos; proposes landmarks on a patient&apos;s liver.</source>
        <translation>Repères que le scanner ne montre pas. « build CAS... --out A » fait un atlas de cas révisés, « evaluate CAS... » prédit chacun par les autres, « show » dit ce qu&apos;un atlas sait, « show --case C » d&apos;où viennent les repères d&apos;un cas, « transfer --case C » propose des repères sur le foie d&apos;un patient.</translation>
    </message>
    <message>
        <source>Cases with a model, or folders of cases, for build and evaluate: five at least.</source>
        <translation>Cas avec un modèle, ou dossiers de cas, pour build et evaluate : cinq au moins.</translation>
    </message>
    <message>
        <source>Take cases whose labels nobody has approved, too.</source>
        <translation>Prendre aussi les cas dont personne n&apos;a approuvé les étiquettes.</translation>
    </message>
    <message>
        <source>Proposed by the atlas &apos;%1&apos;.</source>
        <translation>Proposé par l&apos;atlas « %1 ».</translation>
    </message>
    <message>
        <source>placed by hand</source>
        <translation>placé à la main</translation>
    </message>
    <message>
        <source>from statistics</source>
        <translation>de la statistique</translation>
    </message>
    <message>
        <source>found in the CT</source>
        <translation>trouvé dans le scanner</translation>
    </message>
    <message>
        <source>used by the registration</source>
        <translation>utilisé par le recalage</translation>
    </message>
    <message>
        <source>real livers by the others: vena cava&apos;s course, mean, mm</source>
        <translation>foies réels par les autres : trajet de la veine cave, moyenne, mm</translation>
    </message>
    <message>
        <source>real livers by the others: vena cava&apos;s course, worst liver, mm</source>
        <translation>foies réels par les autres : trajet de la veine cave, pire foie, mm</translation>
    </message>
    <message>
        <source>real livers by the built-in atlas: vena cava&apos;s course, mean, mm</source>
        <translation>foies réels par l&apos;atlas intégré : trajet de la veine cave, moyenne, mm</translation>
    </message>
    <message>
        <source>--review %1: write STRUCTURE=STATE, such as portal_vein=approved; states are %2.</source>
        <translation>--review %1 : écrivez STRUCTURE=ÉTAT, par exemple portal_vein=approved ; les états sont %2.</translation>
    </message>
    <message>
        <source>--only %1: is no structure that is found. Use liver, portal_vein, hepatic_veins, vena_cava, gallbladder or lesions, with commas.</source>
        <translation>--only %1 : ce n&apos;est pas une structure recherchée. Utilisez liver, portal_vein, hepatic_veins, vena_cava, gallbladder ou lesions, avec des virgules.</translation>
    </message>
    <message>
        <source>--keep-edited, --replace-edited: give one of them.</source>
        <translation>--keep-edited, --replace-edited : donnez l&apos;une des deux.</translation>
    </message>
    <message>
        <source>--%1: means nothing with %2. Leave it out.</source>
        <translation>--%1 : ne signifie rien avec %2. Omettez-la.</translation>
    </message>
    <message>
        <source>--%1: means nothing without --%2. Leave it out.</source>
        <translation>--%1 : ne signifie rien sans --%2. Omettez-la.</translation>
    </message>
    <message>
        <source>--lesion %1: is not in this model. Its lesions: %2.</source>
        <translation>--lesion %1 : n&apos;existe pas dans ce modèle. Ses lésions : %2.</translation>
    </message>
    <message>
        <source>%1 holds what was finished (%2), marked as incomplete.</source>
        <translation>%1 contient ce qui était terminé (%2), marqué comme incomplet.</translation>
    </message>
    <message>
        <source>Lists the moments of the live view that a case keeps: number, frame, time in the video, when it was kept, level, title. With --out it writes them: of each the picture with its overlay, both raw pictures, and what was known (JSON). No file names the patient, but a title may.</source>
        <translation>Liste les instants de la vue en direct qu&apos;un cas conserve : numéro, image, temps dans la vidéo, date de conservation, niveau, titre. Avec --out, les écrit : de chacun l&apos;image avec sa superposition, les deux images brutes et ce qui était connu (JSON). Aucun fichier ne nomme le patient, mais un titre peut le faire.</translation>
    </message>
    <message>
        <source>A folder for the pictures; files of the same name are replaced.</source>
        <translation>Un dossier pour les images ; les fichiers du même nom sont remplacés.</translation>
    </message>
    <message>
        <source>Without an overlay, because model or calibration were made anew since: %1.</source>
        <translation>Sans superposition, parce que le modèle ou l&apos;étalonnage ont été refaits depuis : %1.</translation>
    </message>
    <message>
        <source>List and write the moments of the live view that a case keeps</source>
        <translation>Lister et écrire les instants de la vue en direct qu&apos;un cas conserve</translation>
    </message>
    <message>
        <source>all trials: ten clicks segmented, longest, s</source>
        <translation>tous les essais : dix clics segmentés, le plus long, s</translation>
    </message>
    <message>
        <source>all trials: one more click, longest, s</source>
        <translation>tous les essais : un clic de plus, le plus long, s</translation>
    </message>
</context>
<context>
    <name>glisson::ui::AgainBox</name>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Register again</source>
        <translation>Recaler à nouveau</translation>
    </message>
    <message>
        <source>The picture stays as it is (R)</source>
        <translation>L’image reste telle quelle (R)</translation>
    </message>
    <message>
        <source>Registers with all that was seen of the organ since, while it is followed (R). Taken if it is better by tissue that neither has used.</source>
        <translation>Recale avec tout ce qui a été vu de l’organe depuis, pendant qu’il est suivi (R). Adopté s’il est meilleur d’après du tissu qu’aucun des deux n’a utilisé.</translation>
    </message>
    <message>
        <source>Former one</source>
        <translation>Précédent</translation>
    </message>
    <message>
        <source>Take it</source>
        <translation>Adopter</translation>
    </message>
    <message>
        <source>Back to the registration that there was before</source>
        <translation>Retour au recalage d’avant</translation>
    </message>
    <message>
        <source>Goes over to the new registration although it is no better by its evidence</source>
        <translation>Passe au nouveau recalage bien qu’il ne soit pas meilleur d’après ses indices</translation>
    </message>
</context>
<context>
    <name>glisson::ui::AgainModel</name>
    <message>
        <source>Registering again; the picture stays until it is better.</source>
        <translation>Nouveau recalage en cours ; l’image reste jusqu’à ce qu’il soit meilleur.</translation>
    </message>
    <message>
        <source>Cancelled: the former registration stays.</source>
        <translation>Annulé : le recalage précédent reste.</translation>
    </message>
    <message>
        <source>Not taken: it lies %1 mm from tissue that neither has used, the former one %2 mm.</source>
        <translation>Non adopté : il est à %1 mm du tissu qu’aucun n’a utilisé, le précédent à %2 mm.</translation>
    </message>
    <message>
        <source>The former registration is back.</source>
        <translation>Le recalage précédent est revenu.</translation>
    </message>
    <message>
        <source>Registered again: the organ has moved by %1 mm on average. From tissue that neither has used: %2 mm, before %3 mm.</source>
        <translation>Recalé à nouveau : l’organe s’est déplacé de %1 mm en moyenne. Distance au tissu qu’aucun n’a utilisé : %2 mm, avant %3 mm.</translation>
    </message>
    <message>
        <source>Better, but the organ is not followed just now: take it then.</source>
        <translation>Meilleur, mais l’organe n’est pas suivi en ce moment : adoptez-le alors.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::AngleHistogram</name>
    <message>
        <source>Angles between the faces of each element. Flat elements, below 10°, make the computation inexact.</source>
        <translation>Angles entre les faces de chaque élément. Les éléments plats, sous 10°, rendent le calcul inexact.</translation>
    </message>
    <message>
        <source>Dihedral angles, %1 below 10°</source>
        <translation>Angles dièdres, %1 sous 10°</translation>
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
        <translation>Repères</translation>
    </message>
    <message>
        <source>Features that are found again in the laparoscope&apos;s pictures. Check them on the 3D surface and place what is missing.</source>
        <translation>Des traits que l&apos;on retrouve dans les images du laparoscope. Vérifiez-les sur la surface 3D et placez ce qui manque.</translation>
    </message>
    <message>
        <source>Anterior margin</source>
        <translation>Bord antérieur</translation>
    </message>
    <message>
        <source>The sharp lower edge, found on the model (white line).</source>
        <translation>Le bord inférieur tranchant, trouvé sur le modèle (ligne blanche).</translation>
    </message>
    <message>
        <source>Umbilical notch</source>
        <translation>Échancrure</translation>
    </message>
    <message>
        <source>Where the round ligament enters (magenta).</source>
        <translation>Là où entre le ligament rond (magenta).</translation>
    </message>
    <message>
        <source>Vena cava</source>
        <translation>Veine cave</translation>
    </message>
    <message>
        <source>Where the liver is attached to it, seen from behind (green).</source>
        <translation>Là où le foie y est attaché, vu de derrière (vert).</translation>
    </message>
    <message>
        <source>Acceptance</source>
        <translation>Validation</translation>
    </message>
    <message>
        <source>What you see in the 3D view is what the registration will use.</source>
        <translation>Le recalage utilisera ce que montre la vue 3D.</translation>
    </message>
    <message>
        <source>Accept landmarks</source>
        <translation>Valider les repères</translation>
    </message>
    <message>
        <source>Place by clicking</source>
        <translation>Placer au clic</translation>
    </message>
    <message>
        <source>Undo last</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Vider</translation>
    </message>
    <message>
        <source>%1 mm long</source>
        <translation>%1 mm de long</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>non trouvé</translation>
    </message>
    <message>
        <source>not placed</source>
        <translation>non placé</translation>
    </message>
    <message>
        <source>points: %1</source>
        <translation>points : %1</translation>
    </message>
    <message>
        <source>points of the model: %1, the next click replaces them</source>
        <translation>points du modèle : %1, le prochain clic les remplace</translation>
    </message>
    <message>
        <source>Proposals</source>
        <translation>Propositions</translation>
    </message>
    <message>
        <source>Where they should lie: from the CT where it shows them, else from other livers. Nothing is used before you accept it.</source>
        <translation>Où ils devraient se trouver : d&apos;après le scanner là où il les montre, sinon d&apos;après d&apos;autres foies. Rien n&apos;est utilisé avant que vous ne l&apos;acceptiez.</translation>
    </message>
    <message>
        <source>Shapes of livers</source>
        <translation>Formes de foies</translation>
    </message>
    <message>
        <source>What the atlas knows of how livers differ. Nothing of the case changes.</source>
        <translation>Ce que l&apos;atlas sait des différences entre les foies. Rien ne change dans le cas.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::Autosaver</name>
    <message>
        <source>a case that had never been saved</source>
        <translation>un cas qui n’avait jamais été enregistré</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>Récupération</translation>
    </message>
    <message>
        <source>Glisson ended before this was saved: %1, as it was at %2.</source>
        <translation>Glisson s’est terminé avant que ceci soit enregistré : %1, état du %2.</translation>
    </message>
    <message>
        <source>It can be opened as it was then. Nothing is saved in its place until you save it.</source>
        <translation>Il peut être ouvert tel qu’il était alors. Rien n’est enregistré à sa place tant que vous ne l’enregistrez pas.</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>L’ouvrir</translation>
    </message>
    <message>
        <source>Throw it away</source>
        <translation>Le jeter</translation>
    </message>
    <message>
        <source>Ask later</source>
        <translation>Demander plus tard</translation>
    </message>
</context>
<context>
    <name>glisson::ui::BridgeList</name>
    <message>
        <source>Looking for places where the trees touch…</source>
        <translation>Recherche des endroits où les arbres se touchent…</translation>
    </message>
    <message>
        <source>The trees touch: %1 mm²</source>
        <translation>Les arbres se touchent : %1 mm²</translation>
    </message>
    <message>
        <source>A neck of %1 mm², %2 ml beyond it</source>
        <translation>Un col de %1 mm², %2 ml au-delà</translation>
    </message>
    <message>
        <source>The trees touch nowhere, and no part hangs by a neck.</source>
        <translation>Les arbres ne se touchent nulle part, et rien ne pend à un col.</translation>
    </message>
    <message>
        <source>Suspicious places. Click one to go there; cut where the branch is wrong.</source>
        <translation>Endroits suspects. Cliquez pour y aller ; coupez là où la branche est fausse.</translation>
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
        <translation>Étalonner avec des mires</translation>
    </message>
    <message>
        <source>Ten pairs of pictures or more of a chessboard or a ChArUco board, near and far, slanted to all sides, up to the pictures&apos; borders.</source>
        <translation>Dix paires d’images ou plus d’un échiquier ou d’une mire ChArUco, de près et de loin, inclinée de tous côtés, jusqu’aux bords des images.</translation>
    </message>
    <message>
        <source>folder of left and right pictures</source>
        <translation>dossier d’images gauches et droites</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Chessboard</source>
        <translation>Échiquier</translation>
    </message>
    <message>
        <source>ChArUco, %1</source>
        <translation>ChArUco, %1</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Mire</translation>
    </message>
    <message>
        <source>Inner corners</source>
        <translation>Coins intérieurs</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Side of a square</source>
        <translation>Côté d’une case</translation>
    </message>
    <message>
        <source>Side of a marker</source>
        <translation>Côté d’un marqueur</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Étalonner</translation>
    </message>
    <message>
        <source>Folder of left and right pictures</source>
        <translation>Dossier d’images gauches et droites</translation>
    </message>
    <message>
        <source>Choose the folder of pictures first.</source>
        <translation>Choisissez d’abord le dossier d’images.</translation>
    </message>
    <message>
        <source>Views used</source>
        <translation>Vues utilisées</translation>
    </message>
    <message>
        <source>%1 of %2 pairs</source>
        <translation>%1 sur %2 paires</translation>
    </message>
    <message>
        <source>Error, both cameras</source>
        <translation>Erreur, deux caméras</translation>
    </message>
    <message>
        <source>Rows off, view left out</source>
        <translation>Décalage des lignes, vue écartée</translation>
    </message>
    <message>
        <source>Picture covered</source>
        <translation>Image couverte</translation>
    </message>
    <message>
        <source>%1 % left, %2 % right</source>
        <translation>%1 % à gauche, %2 % à droite</translation>
    </message>
    <message>
        <source>Baseline</source>
        <translation>Ligne de base</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Calibrate with the views ticked</source>
        <translation>Étalonner avec les vues cochées</translation>
    </message>
    <message>
        <source>This is the calibration with the views ticked.</source>
        <translation>Ceci est l’étalonnage avec les vues cochées.</translation>
    </message>
    <message>
        <source>Views of the board that were not needed, because the others differ more: %1.</source>
        <translation>Vues de la mire dont il n’a pas été besoin, car les autres diffèrent davantage : %1.</translation>
    </message>
    <message>
        <source>The board was not found in both pictures of: %1.</source>
        <translation>La mire n’a pas été trouvée dans les deux images de : %1.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::CalibrationResults</name>
    <message>
        <source>Views of the board</source>
        <translation>Vues de la mire</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Left, px</source>
        <translation>Gauche, px</translation>
    </message>
    <message>
        <source>Right, px</source>
        <translation>Droite, px</translation>
    </message>
    <message>
        <source>Rows off, px</source>
        <translation>Lignes, px</translation>
    </message>
    <message>
        <source>Distance, mm</source>
        <translation>Distance, mm</translation>
    </message>
    <message>
        <source>Tilt, °</source>
        <translation>Inclinaison, °</translation>
    </message>
    <message>
        <source>Error of the corners in the left picture, rms</source>
        <translation>Erreur des coins dans l’image gauche, RMS</translation>
    </message>
    <message>
        <source>Error of the corners in the right picture, rms</source>
        <translation>Erreur des coins dans l’image droite, RMS</translation>
    </message>
    <message>
        <source>How far the view&apos;s rows disagree by a calibration that has not seen it, rms</source>
        <translation>Écart des lignes de la vue selon un étalonnage qui ne l’a pas vue, RMS</translation>
    </message>
    <message>
        <source>Views that fit far worse than the others come without a tick. Untick what is blurred or was moved.</source>
        <translation>Les vues qui s’ajustent bien moins que les autres ne sont pas cochées. Décochez ce qui est flou ou a bougé.</translation>
    </message>
    <message>
        <source>Fits far worse than the others: proposed for removal</source>
        <translation>S’ajuste bien moins que les autres : retrait proposé</translation>
    </message>
</context>
<context>
    <name>glisson::ui::CorrectionBox</name>
    <message>
        <source>Correct by hand</source>
        <translation>Corriger à la main</translation>
    </message>
    <message>
        <source>Drag a place of the drawn organ (margin, notch, vessel, surface) to where the picture shows it (C, or drag with Shift).</source>
        <translation>Tirez un point de l’organe dessiné (bord, échancrure, vaisseau, surface) là où l’image le montre (C, ou tirer avec Maj).</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Take the last correction back (Ctrl+Z in the picture)</source>
        <translation>Annuler la dernière correction (Ctrl+Z dans l’image)</translation>
    </message>
</context>
<context>
    <name>glisson::ui::CorrectionModel</name>
    <message>
        <source>There is no overlay that could be corrected.</source>
        <translation>Il n’y a pas de superposition à corriger.</translation>
    </message>
    <message>
        <source>There is nothing of the drawn organ. Take hold of its margin, its notch, a vessel or its surface.</source>
        <translation>Il n’y a rien de l’organe dessiné à cet endroit. Saisissez son bord, son échancrure, un vaisseau ou sa surface.</translation>
    </message>
    <message>
        <source>a place of the surface</source>
        <translation>un point de la surface</translation>
    </message>
    <message>
        <source>the anterior margin</source>
        <translation>le bord antérieur</translation>
    </message>
    <message>
        <source>the notch</source>
        <translation>l’échancrure</translation>
    </message>
    <message>
        <source>a vessel</source>
        <translation>un vaisseau</translation>
    </message>
    <message>
        <source>In the hand: %1. Drag it to where the picture shows it.</source>
        <translation>Saisi : %1. Tirez-le là où l’image le montre.</translation>
    </message>
    <message>
        <source>Corrected by hand: %1. The last one moved the organ by %2 mm on average.</source>
        <translation>Corrections à la main : %1. La dernière a déplacé l’organe de %2 mm en moyenne.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::CoverageView</name>
    <message>
        <source>Covered by boards, left and right</source>
        <translation>Couvert par des mires, à gauche et à droite</translation>
    </message>
    <message>
        <source>Shaded: where a board lay. What no board has covered is extrapolated. Blue: views used, orange: proposed for removal or left out. The chosen view is brought out.</source>
        <translation>Ombré : là où se trouvait une mire. Ce qu’aucune mire n’a couvert est extrapolé. Bleu : vues utilisées, orange : retrait proposé ou vues omises. La vue choisie est mise en évidence.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::EditBox</name>
    <message>
        <source>Apply</source>
        <translation>Appliquer</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>Hatched in the slices: what would change</source>
        <translation>Hachuré dans les coupes : ce qui changerait</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Échap</translation>
    </message>
    <message>
        <source>Where tools may change anything</source>
        <translation>Où les outils peuvent agir</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Zone</translation>
    </message>
    <message>
        <source>Only these intensities</source>
        <translation>Seulement ces intensités</translation>
    </message>
    <message>
        <source> HU</source>
        <translation> UH</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Partout</translation>
    </message>
    <message>
        <source>Nothing is overwritten</source>
        <translation>Rien n&apos;est écrasé</translation>
    </message>
    <message>
        <source>Inside any label</source>
        <translation>Dans toute étiquette</translation>
    </message>
    <message>
        <source>Inside the liver</source>
        <translation>Dans le foie</translation>
    </message>
    <message>
        <source>Inside: %1</source>
        <translation>Dans : %1</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Annuler : %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Rétablir : %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Nothing would change.</source>
        <translation>Rien ne changerait.</translation>
    </message>
    <message>
        <source>%1 ml would change.</source>
        <translation>%1 ml changeraient.</translation>
    </message>
    <message>
        <source>Click the other end. Ctrl adds a point between, Esc drops the way.</source>
        <translation>Cliquez l&apos;autre extrémité. Ctrl ajoute un point intermédiaire, Échap abandonne le chemin.</translation>
    </message>
    <message>
        <source>%1: %2 → %3 ml</source>
        <translation>%1 : %2 → %3 ml</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>et %1 de plus</translation>
    </message>
</context>
<context>
    <name>glisson::ui::GuidancePanel</name>
    <message>
        <source>Guidance</source>
        <translation>Guidage</translation>
    </message>
    <message>
        <source>The model brought to what the laparoscope sees, and kept there.</source>
        <translation>Le modèle amené à ce que voit le laparoscope, et maintenu là.</translation>
    </message>
    <message>
        <source>1. Initial registration</source>
        <translation>1. Recalage initial</translation>
    </message>
    <message>
        <source>Rigid start from the labelled features; then the shape that simulated operations on this liver make most probable, drawn to the points.</source>
        <translation>Départ rigide à partir des traits marqués ; puis la forme que des opérations simulées sur ce foie rendent la plus probable, tirée vers les points.</translation>
    </message>
    <message>
        <source>2. Live tracking</source>
        <translation>2. Suivi en direct</translation>
    </message>
    <message>
        <source>Plays the case&apos;s stereo video as a live laparoscope.</source>
        <translation>Joue la vidéo stéréo du cas comme un laparoscope.</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Superposition</translation>
    </message>
    <message>
        <source>Placed by hand: not registered. Refine, or put it back.</source>
        <translation>Placé à la main : non recalé. Affinez ou remettez en place.</translation>
    </message>
    <message>
        <source>Other place %1, to be compared: not the registration.</source>
        <translation>Autre position %1, pour comparaison : ce n’est pas le recalage.</translation>
    </message>
    <message>
        <source>Other programs</source>
        <translation>Autres programmes</translation>
    </message>
    <message>
        <source>3D Slicer, CustusX or PLUS may follow what is tracked here.</source>
        <translation>3D Slicer, CustusX ou PLUS peuvent suivre ce qui est suivi ici.</translation>
    </message>
    <message>
        <source>The recording is being brought to its end. If all went well, the window closes then.</source>
        <translation>L&apos;enregistrement est en cours d&apos;achèvement. Si tout va bien, la fenêtre se fermera ensuite.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::GuidanceView</name>
    <message>
        <source>Picture</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Organ in 3D, expected error</source>
        <translation>Organe en 3D, erreur attendue</translation>
    </message>
    <message>
        <source>The organ as it was registered, in the colours of the error that is expected at each place, with each lesion&apos;s region.</source>
        <translation>L’organe tel qu’il a été recalé, dans les couleurs de l’erreur attendue à chaque endroit, avec la région de chaque lésion.</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Les deux</translation>
    </message>
    <message>
        <source>Picture and organ. While a video is followed the organ goes with the picture.</source>
        <translation>Image et organe. Pendant le suivi d’une vidéo, l’organe accompagne l’image.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::ImageImport</name>
    <message>
        <source>CT or MRI?</source>
        <translation>Scanner ou IRM ?</translation>
    </message>
    <message>
        <source>%1 does not say whether it is a CT or an MRI.</source>
        <translation>%1 ne dit pas si c&apos;est un scanner ou une IRM.</translation>
    </message>
    <message>
        <source>MRI</source>
        <translation>IRM</translation>
    </message>
    <message>
        <source>CT</source>
        <translation>Scanner</translation>
    </message>
    <message>
        <source>Neither</source>
        <translation>Ni l&apos;un ni l&apos;autre</translation>
    </message>
</context>
<context>
    <name>glisson::ui::LabelMeanings</name>
    <message>
        <source>%1 does not say what each label is. Say it here; what you leave out becomes background.</source>
        <translation>%1 ne dit pas ce qu&apos;est chaque étiquette. Dites-le ici ; ce que vous omettez devient le fond.</translation>
    </message>
    <message>
        <source>Import labels</source>
        <translation>Importer des étiquettes</translation>
    </message>
    <message>
        <source>Label in the file</source>
        <translation>Étiquette du fichier</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Is</source>
        <translation>Est</translation>
    </message>
    <message>
        <source>Say which one is the liver.</source>
        <translation>Dites laquelle est le foie.</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importer</translation>
    </message>
    <message>
        <source>As Glisson numbers them</source>
        <translation>Comme Glisson les numérote</translation>
    </message>
    <message>
        <source>For files that Glisson has written without names: 1 is the liver, 2 the portal vein, from 16 on lesions. Other programs number otherwise.</source>
        <translation>Pour les fichiers que Glisson a écrits sans noms : 1 est le foie, 2 la veine porte, à partir de 16 les lésions. D&apos;autres programmes numérotent autrement.</translation>
    </message>
    <message>
        <source>%1 ml</source>
        <translation>%1 ml</translation>
    </message>
    <message>
        <source>Not imported</source>
        <translation>Non importée</translation>
    </message>
    <message>
        <source>Lesion</source>
        <translation>Lésion</translation>
    </message>
</context>
<context>
    <name>glisson::ui::LabelTable</name>
    <message>
        <source>Label</source>
        <translation>Étiquette</translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>HU</source>
        <translation>UH</translation>
    </message>
    <message>
        <source>⌀ mm</source>
        <translation>⌀ mm</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Mean intensity</source>
        <translation>Intensité moyenne</translation>
    </message>
    <message>
        <source>Longest diameter of a lesion</source>
        <translation>Plus long diamètre d&apos;une lésion</translation>
    </message>
    <message>
        <source>%1: click to change</source>
        <translation>%1 : cliquez pour changer</translation>
    </message>
    <message>
        <source>%1 ± %2 HU</source>
        <translation>%1 ± %2 UH</translation>
    </message>
    <message>
        <source>Hidden: click to show</source>
        <translation>Masquée : cliquez pour afficher</translation>
    </message>
    <message>
        <source>Shown: click to hide</source>
        <translation>Affichée : cliquez pour masquer</translation>
    </message>
    <message>
        <source>Locked: neither loses nor gains voxels. Click to unlock</source>
        <translation>Verrouillée : ne perd ni ne gagne de voxels. Cliquez pour déverrouiller</translation>
    </message>
    <message>
        <source>Click to lock: it neither loses nor gains voxels</source>
        <translation>Cliquez pour verrouiller : elle ne perd ni ne gagne plus de voxels</translation>
    </message>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Gris</translation>
    </message>
</context>
<context>
    <name>glisson::ui::LesionBox</name>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>How far from the place shown it may be in 95 of 100 cases, as the registration expects.</source>
        <translation>À quelle distance du lieu montré elle peut être dans 95 cas sur 100, selon ce que le recalage attend.</translation>
    </message>
    <message>
        <source>Click a lesion, here or in the picture. Click with the right button where a tool touches the organ: the distance from there is told, too. Esc lets go.</source>
        <translation>Cliquez une lésion, ici ou dans l&apos;image. Cliquez avec le bouton droit là où un instrument touche l&apos;organe : la distance à ce point est aussi donnée. Échap relâche.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>Lesion, fork</source>
        <translation>Lésion, bifurcation</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>Lesions, and the largest forks of portal vein and hepatic veins (1: the widest).</source>
        <translation>Lésions, et les plus grandes bifurcations de la veine porte et des veines hépatiques (1 : la plus large).</translation>
    </message>
    <message>
        <source>Mean error that the registration expects there.</source>
        <translation>Erreur moyenne que le recalage y attend.</translation>
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
        <translation>Vue de face (antérieure)</translation>
    </message>
    <message>
        <source>P</source>
        <translation>P</translation>
    </message>
    <message>
        <source>Look from behind (posterior)</source>
        <translation>Vue de dos (postérieure)</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>Look from the patient&apos;s right</source>
        <translation>Vue de la droite du patient</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>Look from the patient&apos;s left</source>
        <translation>Vue de la gauche du patient</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>Look from above (superior)</source>
        <translation>Vue de dessus (supérieure)</translation>
    </message>
    <message>
        <source>I</source>
        <translation>I</translation>
    </message>
    <message>
        <source>Look from below (inferior)</source>
        <translation>Vue de dessous (inférieure)</translation>
    </message>
    <message>
        <source>Look from</source>
        <translation>Vue de</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Coupes</translation>
    </message>
    <message>
        <source>Show the three slices in the 3D view</source>
        <translation>Montrer les trois coupes dans la vue 3D</translation>
    </message>
    <message>
        <source>No volume</source>
        <translation>Pas de volume</translation>
    </message>
    <message>
        <source>Preparing the model for drawing…</source>
        <translation>Préparation du modèle pour le dessin…</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>dehors</translation>
    </message>
    <message>
        <source>%1 HU</source>
        <translation>%1 UH</translation>
    </message>
    <message>
        <source>Preparing the surfaces…</source>
        <translation>Préparation des surfaces…</translation>
    </message>
</context>
<context>
    <name>glisson::ui::LiveView</name>
    <message>
        <source>Register the model to a frame of the laparoscope; the augmented picture appears here.</source>
        <translation>Recalez le modèle sur une image du laparoscope ; l&apos;image augmentée apparaît ici.</translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation>Image…</translation>
    </message>
    <message>
        <source>Save the picture as it is drawn (P)</source>
        <translation>Enregistrer l&apos;image telle qu&apos;elle est dessinée (P)</translation>
    </message>
    <message>
        <source>Whole screen (F11)</source>
        <translation>Plein écran (F11)</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Enregistrer l&apos;image</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg)</source>
        <translation>Images (*.png *.jpg)</translation>
    </message>
    <message>
        <source>Raw</source>
        <translation>Brut</translation>
    </message>
    <message>
        <source>The raw picture beside the overlay (B)</source>
        <translation>L&apos;image brute à côté de la superposition (B)</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>The right picture with its overlay: a wrong depth shows in one of the two (V)</source>
        <translation>L’image droite avec sa superposition : une profondeur fausse se voit dans l’une des deux (V)</translation>
    </message>
    <message>
        <source>There is no right picture of this frame.</source>
        <translation>Il n’y a pas d’image droite de ce moment.</translation>
    </message>
    <message>
        <source>Back to live (Esc)</source>
        <translation>Retour au direct (Échap)</translation>
    </message>
</context>
<context>
    <name>glisson::ui::LiveViewModel</name>
    <message>
        <source>Not live</source>
        <translation>Pas en direct</translation>
    </message>
    <message>
        <source>Registered frame %1, not live</source>
        <translation>Image recalée %1, pas en direct</translation>
    </message>
    <message>
        <source>Frame %1, not live</source>
        <translation>Image %1, pas en direct</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Tracked points, left / right</source>
        <translation>Points suivis, gauche / droite</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Paires</translation>
    </message>
    <message>
        <source>Residual (not an accuracy)</source>
        <translation>Résidu (pas une précision)</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Tracking and mechanics</source>
        <translation>Suivi et mécanique</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Dessin</translation>
    </message>
    <message>
        <source>Frames late / dropped</source>
        <translation>Images en retard / perdues</translation>
    </message>
    <message>
        <source>LIVE   frame %1   age %2 ms   %3 frames/s</source>
        <translation>DIRECT   image %1   âge %2 ms   %3 images/s</translation>
    </message>
    <message>
        <source>   NO OVERLAY: %1</source>
        <translation>   PAS DE SUPERPOSITION : %1</translation>
    </message>
    <message>
        <source>The picture is %1 s old: the overlay does not show where things are now.</source>
        <translation>L&apos;image a %1 s : la superposition ne montre pas où sont les choses maintenant.</translation>
    </message>
    <message>
        <source>The overlay is being prepared: the picture shows none yet.</source>
        <translation>La superposition est en préparation : l&apos;image n&apos;en montre pas encore.</translation>
    </message>
    <message>
        <source>   OUTLINE ONLY: %1</source>
        <translation>   CONTOUR SEUL : %1</translation>
    </message>
    <message>
        <source>Looked at again: frame %1 as it was followed, not live.</source>
        <translation>Revue : image %1 telle qu&apos;elle a été suivie, pas en direct.</translation>
    </message>
    <message>
        <source>Frame %1, recorded, not live</source>
        <translation>Image %1, enregistrée, pas en direct</translation>
    </message>
    <message>
        <source>There is no picture to save.</source>
        <translation>Il n&apos;y a pas d&apos;image à enregistrer.</translation>
    </message>
    <message>
        <source>Paused. The picture is not live.</source>
        <translation>En pause. L&apos;image n&apos;est pas en direct.</translation>
    </message>
    <message>
        <source>Paused at frame %1, not live</source>
        <translation>En pause à l&apos;image %1, pas en direct</translation>
    </message>
    <message>
        <source>Camera to screen, median / 99 %</source>
        <translation>De la caméra à l&apos;écran, médiane / 99 %</translation>
    </message>
    <message>
        <source>%1 / %2 ms</source>
        <translation>%1 / %2 ms</translation>
    </message>
    <message>
        <source>On the screen</source>
        <translation>À l&apos;écran</translation>
    </message>
    <message>
        <source>%1 frames/s</source>
        <translation>%1 images/s</translation>
    </message>
    <message>
        <source>A former picture, not live.</source>
        <translation>Une image antérieure, pas en direct.</translation>
    </message>
    <message>
        <source>KEPT MOMENT %1 – NOT LIVE</source>
        <translation>INSTANT CONSERVÉ %1 – PAS EN DIRECT</translation>
    </message>
    <message>
        <source>Kept moment %1, not live: %2</source>
        <translation>Instant conservé %1, pas en direct : %2</translation>
    </message>
    <message>
        <source>Model or calibration were made anew since: its overlay cannot be drawn as it was. The picture is shown without.</source>
        <translation>Le modèle ou l&apos;étalonnage ont été refaits depuis : sa superposition ne peut pas être dessinée telle qu&apos;elle était. L&apos;image est montrée sans elle.</translation>
    </message>
    <message>
        <source>Kept moment %1, frame %2, not live</source>
        <translation>Instant conservé %1, image %2, pas en direct</translation>
    </message>
</context>
<context>
    <name>glisson::ui::LoadTrialBox</name>
    <message>
        <source>Try a load</source>
        <translation>Essayer une charge</translation>
    </message>
    <message>
        <source>Preparing…</source>
        <translation>Préparation…</translation>
    </message>
    <message>
        <source>Press on the liver in the 3D view and drag.</source>
        <translation>Appuyez sur le foie dans la vue 3D et tirez.</translation>
    </message>
    <message>
        <source>The model has changed: the trial has ended.</source>
        <translation>Le modèle a changé : l’essai est terminé.</translation>
    </message>
    <message>
        <source>Stopped: the computation did not converge under this pull. The rest shape is drawn.</source>
        <translation>Arrêté : le calcul n’a pas convergé sous cette traction. La forme au repos est affichée.</translation>
    </message>
    <message>
        <source>Stopped: this pull turns elements of the mesh inside out. The rest shape is drawn. Pull less, or elsewhere.</source>
        <translation>Arrêté : cette traction retourne des éléments du maillage. La forme au repos est affichée. Tirez moins, ou ailleurs.</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>%1 Hz   %2 ms a step   %3 elements</source>
        <translation>%1 Hz   %2 ms par pas   %3 éléments</translation>
    </message>
    <message>
        <source>%1 ms a step   %2 elements</source>
        <translation>%1 ms par pas   %2 éléments</translation>
    </message>
    <message>
        <source>Pull %1 N, organ moved by up to %2 mm</source>
        <translation>Traction %1 N, organe déplacé de %2 mm au plus</translation>
    </message>
</context>
<context>
    <name>glisson::ui::LookBox</name>
    <message>
        <source>Portal vein</source>
        <translation>Veine porte</translation>
    </message>
    <message>
        <source>Hepatic veins</source>
        <translation>Veines hépatiques</translation>
    </message>
    <message>
        <source>Lesions</source>
        <translation>Lésions</translation>
    </message>
    <message>
        <source>Liver outline</source>
        <translation>Contour du foie</translation>
    </message>
    <message>
        <source>Anterior margin</source>
        <translation>Bord antérieur</translation>
    </message>
    <message>
        <source>Vessel opacity</source>
        <translation>Opacité des vaisseaux</translation>
    </message>
    <message>
        <source>Tubes</source>
        <translation>Tubes</translation>
    </message>
    <message>
        <source>Shaded, and fainter with depth</source>
        <translation>Ombrés, et plus pâles en profondeur</translation>
    </message>
    <message>
        <source>Focus window</source>
        <translation>Fenêtre de focus</translation>
    </message>
    <message>
        <source>Around the pointer, or else the chosen lesion: opaque and in depth order; outlines elsewhere</source>
        <translation>Autour du pointeur, sinon de la lésion choisie : opaque et dans l&apos;ordre des profondeurs ; des contours ailleurs</translation>
    </message>
    <message>
        <source>Depth contours</source>
        <translation>Lignes de profondeur</translation>
    </message>
    <message>
        <source>A line at every 10 mm of depth below the surface</source>
        <translation>Une ligne tous les 10 mm de profondeur sous la surface</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Contours</translation>
    </message>
    <message>
        <source>They hide least of the tissue</source>
        <translation>Ils cachent le moins de tissu</translation>
    </message>
    <message>
        <source>Depth as</source>
        <translation>Profondeur en</translation>
    </message>
    <message>
        <source>Thin branches</source>
        <translation>Branches fines</translation>
    </message>
    <message>
        <source>Ruler</source>
        <translation>Règle</translation>
    </message>
</context>
<context>
    <name>glisson::ui::LooksRow</name>
    <message>
        <source>Keep this look</source>
        <translation>Garder cette vue</translation>
    </message>
    <message>
        <source>Keeps these points. Then move the laparoscope, not the organ, and reconstruct again: registration joins all looks and finds out itself where each was seen from.</source>
        <translation>Garde ces points. Déplacez ensuite le laparoscope, pas l’organe, et reconstruisez : le recalage réunit toutes les vues et trouve lui-même d’où chacune a été prise.</translation>
    </message>
    <message>
        <source>Forget looks</source>
        <translation>Oublier les vues</translation>
    </message>
    <message>
        <source>The organ has moved since: registration goes by the present points alone</source>
        <translation>L’organe a bougé depuis : le recalage ne suit que les points présents</translation>
    </message>
    <message>
        <source>No earlier look is kept.</source>
        <translation>Aucune vue antérieure n’est gardée.</translation>
    </message>
    <message>
        <source>Earlier looks that registration joins: %1</source>
        <translation>Vues antérieures que le recalage réunit : %1</translation>
    </message>
    <message>
        <source>Kept. Now look from elsewhere and reconstruct again.</source>
        <translation>Gardée. Regardez maintenant d’ailleurs et reconstruisez.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::MainWindow</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Ouvrir</translation>
    </message>
    <message>
        <source>&amp;DICOM folder…</source>
        <translation>Dossier &amp;DICOM…</translation>
    </message>
    <message>
        <source>&amp;Volume…</source>
        <translation>&amp;Volume…</translation>
    </message>
    <message>
        <source>&amp;Case…</source>
        <translation>&amp;Cas…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Enregistrer &amp;sous…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>É&amp;tape</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Aide</translation>
    </message>
    <message>
        <source>&amp;About Glisson</source>
        <translation>À &amp;propos de Glisson</translation>
    </message>
    <message>
        <source>About Glisson</source>
        <translation>À propos de Glisson</translation>
    </message>
    <message>
        <source>&lt;b&gt;Glisson&lt;/b&gt;&lt;br&gt;Planning and guidance of minimally invasive liver surgery, after Plantefève, Peterlik, Haouchine and Cotin (2015).&lt;br&gt;&lt;br&gt;Research software: not for clinical use.&lt;br&gt;Licence: GPL-3.0-or-later.</source>
        <translation>&lt;b&gt;Glisson&lt;/b&gt;&lt;br&gt;Planification et guidage de la chirurgie hépatique mini-invasive, d&apos;après Plantefève, Peterlik, Haouchine et Cotin (2015).&lt;br&gt;&lt;br&gt;Logiciel de recherche : pas d&apos;usage clinique.&lt;br&gt;Licence : GPL-3.0-or-later.</translation>
    </message>
    <message>
        <source>%1 is nothing that Glisson opens. Give a folder of DICOM slices, a volume (NIfTI, NRRD, MetaImage) or a case (NAME.glisson).</source>
        <translation>Glisson n&apos;ouvre pas %1. Donnez un dossier de coupes DICOM, un volume (NIfTI, NRRD, MetaImage) ou un cas (NOM.glisson).</translation>
    </message>
    <message>
        <source>Glisson</source>
        <translation>Glisson</translation>
    </message>
    <message>
        <source>Open a case (a folder NAME.glisson)</source>
        <translation>Ouvrir un cas (un dossier NOM.glisson)</translation>
    </message>
    <message>
        <source>Open a folder of DICOM slices</source>
        <translation>Ouvrir un dossier de coupes DICOM</translation>
    </message>
    <message>
        <source>Open a volume</source>
        <translation>Ouvrir un volume</translation>
    </message>
    <message>
        <source>Save the case as a folder</source>
        <translation>Enregistrer le cas dans un dossier</translation>
    </message>
    <message>
        <source>Cases (*.glisson)</source>
        <translation>Cas (*.glisson)</translation>
    </message>
    <message>
        <source>unsaved case</source>
        <translation>cas non enregistré</translation>
    </message>
    <message>
        <source>%1[*] – Glisson</source>
        <translation>%1[*] – Glisson</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>The case has changes that are not saved.</source>
        <translation>Le cas a des modifications non enregistrées.</translation>
    </message>
    <message>
        <source>The case has changes that are not saved. Opening another loses them.</source>
        <translation>Le cas a des modifications non enregistrées. En ouvrir un autre les perd.</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Édition</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>Export &amp;labels…</source>
        <translation>Exporter les &amp;étiquettes…</translation>
    </message>
    <message>
        <source>Export labels</source>
        <translation>Exporter les étiquettes</translation>
    </message>
    <message>
        <source>Open a CT</source>
        <translation>Ouvrir un scanner</translation>
    </message>
    <message>
        <source>Is this CT of another patient, or another one of the patient who is open?</source>
        <translation>Ce scanner est-il d’un autre patient, ou un autre du patient ouvert ?</translation>
    </message>
    <message>
        <source>A new case loses the changes of this one, which are not saved. The same patient&apos;s case keeps everything, marked out of date.</source>
        <translation>Un nouveau cas perd les modifications non enregistrées de celui-ci. Pour le même patient, tout reste, marqué périmé.</translation>
    </message>
    <message>
        <source>The same patient&apos;s case keeps everything, marked out of date.</source>
        <translation>Pour le même patient, tout reste, marqué périmé.</translation>
    </message>
    <message>
        <source>New case</source>
        <translation>Nouveau cas</translation>
    </message>
    <message>
        <source>Same patient</source>
        <translation>Même patient</translation>
    </message>
    <message>
        <source>%1 (for reading)[*] – Glisson</source>
        <translation>%1 (en lecture)[*] – Glisson</translation>
    </message>
    <message>
        <source>%1 is not there any more. It was taken from the list.</source>
        <translation>%1 n’existe plus. L’entrée a été retirée de la liste.</translation>
    </message>
    <message>
        <source>Labels (*.seg.nrrd *.dcm *.nii.gz *.nrrd *.mha)</source>
        <translation>Étiquettes (*.seg.nrrd *.dcm *.nii.gz *.nrrd *.mha)</translation>
    </message>
    <message>
        <source>A new segmentation waits for your decision (Segmentation). Closing lets it go; your labels are kept as they are.</source>
        <translation>Une nouvelle segmentation attend votre décision (Segmentation). Fermer l&apos;abandonne ; vos étiquettes restent telles quelles.</translation>
    </message>
    <message>
        <source>Volumes (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.vti *.zip *.tar.gz *.tgz *.tar DICOMDIR dicomdir)</source>
        <translation>Volumes (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.vti *.zip *.tar.gz *.tgz *.tar DICOMDIR dicomdir)</translation>
    </message>
    <message>
        <source>A new segmentation waits for your decision (Segmentation). Opening this lets it go.</source>
        <translation>Une nouvelle segmentation attend votre décision (Segmentation). Ouvrir ceci l’abandonne.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Export s&amp;urfaces…</source>
        <translation>Exporter les s&amp;urfaces…</translation>
    </message>
    <message>
        <source>Export surfaces into a folder</source>
        <translation>Exporter les surfaces dans un dossier</translation>
    </message>
</context>
<context>
    <name>glisson::ui::MaskBox</name>
    <message>
        <source>Your own network that says what of the picture is not liver: an ONNX file with its sheet, MODEL.json, beside it. It only keeps points from pulling the model.</source>
        <translation>Votre propre réseau qui dit ce qui, dans l’image, n’est pas du foie : un fichier ONNX avec sa fiche, MODEL.json, à côté. Il ne fait qu’empêcher des points de tirer le modèle.</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>The organ is followed without the network, at once</source>
        <translation>L’organe est suivi sans le réseau, aussitôt</translation>
    </message>
    <message>
        <source>Mask network</source>
        <translation>Réseau de masque</translation>
    </message>
    <message>
        <source>Networks (*.onnx)</source>
        <translation>Réseaux (*.onnx)</translation>
    </message>
    <message>
        <source>Mask network…</source>
        <translation>Réseau de masque…</translation>
    </message>
    <message>
        <source>Mask: %1</source>
        <translation>Masque : %1</translation>
    </message>
</context>
<context>
    <name>glisson::ui::MaskModel</name>
    <message>
        <source>The mask network has failed; the organ is followed without it. %1</source>
        <translation>Le réseau de masque est en panne ; l’organe est suivi sans lui. %1</translation>
    </message>
    <message>
        <source>The mask network has no mask yet; the organ is followed without it.</source>
        <translation>Le réseau de masque n’a pas encore de masque ; l’organe est suivi sans lui.</translation>
    </message>
    <message>
        <source>The mask network is too slow: its last mask is %1 s old and is not used.</source>
        <translation>Le réseau de masque est trop lent : son dernier masque a %1 s et n’est pas utilisé.</translation>
    </message>
    <message>
        <source>Masked of the organ in sight: %1 %. The mask is %2 ms old.</source>
        <translation>Masqué de l’organe visible : %1 %. Le masque a %2 ms.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::ModelPanel</name>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>A mesh of the liver with its vessels, ready for mechanics.</source>
        <translation>Un maillage du foie avec ses vaisseaux, prêt pour la mécanique.</translation>
    </message>
    <message>
        <source>Build from the labels</source>
        <translation>Construire à partir des étiquettes</translation>
    </message>
    <message>
        <source>Portal and hepatic vessels stiffen the model</source>
        <translation>Les vaisseaux raidissent le modèle</translation>
    </message>
    <message>
        <source>Build model</source>
        <translation>Construire le modèle</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualité</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>Vue 3D</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Maillage</translation>
    </message>
    <message>
        <source>Liver opacity</source>
        <translation>Opacité du foie</translation>
    </message>
    <message>
        <source>Folder of surfaces, named by structure</source>
        <translation>Dossier de surfaces, nommées par structure</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Sommets</translation>
    </message>
    <message>
        <source>Mechanics</source>
        <translation>Mécanique</translation>
    </message>
    <message>
        <source>Drag a point of the liver and see it follow with its vessels and lesions. It is held at the vena cava and where vessels enter; its neighbours are not modelled. A trial: the case stays as it is. Esc ends it.</source>
        <translation>Tirez un point du foie : vaisseaux et lésions suivent. Il est tenu à la veine cave et là où entrent les vaisseaux ; ses voisins ne sont pas modélisés. Un essai : le cas reste tel quel. Échap y met fin.</translation>
    </message>
    <message>
        <source>Edge length</source>
        <translation>Arête</translation>
    </message>
    <message>
        <source>More vertices, or shorter edges, follow the organ more closely and compute more slowly.</source>
        <translation>Plus de sommets, ou des arêtes plus courtes, suivent l&apos;organe de plus près et calculent plus lentement.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Mesh size</source>
        <translation>Maillage</translation>
    </message>
    <message>
        <source>Finer at lesions</source>
        <translation>Fin aux lésions</translation>
    </message>
    <message>
        <source>Finer at vessels</source>
        <translation>Fin aux vaisseaux</translation>
    </message>
    <message>
        <source>Edges half as long there; with a number of vertices, longer ones elsewhere.</source>
        <translation>Arêtes deux fois plus courtes là ; avec un nombre de sommets, plus longues ailleurs.</translation>
    </message>
    <message>
        <source>From surfaces…</source>
        <translation>Depuis des surfaces…</translation>
    </message>
    <message>
        <source>A folder, files named by structure…</source>
        <translation>Un dossier, fichiers nommés par structure…</translation>
    </message>
    <message>
        <source>A list of files (JSON)…</source>
        <translation>Une liste de fichiers (JSON)…</translation>
    </message>
    <message>
        <source>List of surfaces</source>
        <translation>Liste de surfaces</translation>
    </message>
    <message>
        <source>List of surfaces (*.json)</source>
        <translation>Liste de surfaces (*.json)</translation>
    </message>
    <message>
        <source>One surface of the liver…</source>
        <translation>Une surface du foie…</translation>
    </message>
    <message>
        <source>Surface of the liver</source>
        <translation>Surface du foie</translation>
    </message>
    <message>
        <source>Surfaces (*.stl *.obj *.ply *.vtk *.vtp)</source>
        <translation>Surfaces (*.stl *.obj *.ply *.vtk *.vtp)</translation>
    </message>
    <message>
        <source>Vessel trees</source>
        <translation>Arbres vasculaires</translation>
    </message>
    <message>
        <source>The centrelines that stiffen the model. Each tree is held where it enters.</source>
        <translation>Les lignes centrales qui raidissent le modèle. Chaque arbre est tenu là où il entre.</translation>
    </message>
    <message>
        <source>Where the vessels have more, the thinnest and shortest side branches are left out; entrances and vessels of 4 mm across and more stay. More beams compute more slowly.</source>
        <translation>Au-delà, les branches latérales les plus fines et les plus courtes sont omises ; les entrées et les vaisseaux de 4 mm de diamètre et plus restent. Plus il y a de poutres, plus le calcul est lent.</translation>
    </message>
    <message>
        <source>Beams</source>
        <translation>Poutres</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Raideur</translation>
    </message>
    <message>
        <source>Young&apos;s modulus. Trial, registration and what is simulated for it go by it; a registration made before is out of date then.</source>
        <translation>Module d&apos;Young. L&apos;essai, le recalage et ce qui est simulé pour lui le suivent ; un recalage fait avant est alors périmé.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::NetworkBox</name>
    <message>
        <source>Own network…</source>
        <translation>Réseau à vous…</translation>
    </message>
    <message>
        <source>Your own segmentation network: an ONNX file with its sheet, MODEL.json, beside it.</source>
        <translation>Votre propre réseau de segmentation : un fichier ONNX avec sa fiche MODEL.json à côté.</translation>
    </message>
    <message>
        <source>Segment by this network</source>
        <translation>Segmenter par ce réseau</translation>
    </message>
    <message>
        <source>Own network</source>
        <translation>Réseau à vous</translation>
    </message>
    <message>
        <source>Networks (*.onnx)</source>
        <translation>Réseaux (*.onnx)</translation>
    </message>
    <message>
        <source>Network: %1</source>
        <translation>Réseau : %1</translation>
    </message>
</context>
<context>
    <name>glisson::ui::NotesBox</name>
    <message>
        <source>Show it</source>
        <translation>Montrer</translation>
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
        <translation>Une nouvelle segmentation attend</translation>
    </message>
    <message>
        <source>Go to the largest change</source>
        <translation>Aller au plus grand changement</translation>
    </message>
    <message>
        <source>Keep mine where I corrected</source>
        <translation>Garder la mienne là où j&apos;ai corrigé</translation>
    </message>
    <message>
        <source>The voxels that you corrected by hand stay, all else is taken from the new one.</source>
        <translation>Les voxels que vous avez corrigés à la main restent, tout le reste vient de la nouvelle.</translation>
    </message>
    <message>
        <source>Take the new one</source>
        <translation>Prendre la nouvelle</translation>
    </message>
    <message>
        <source>Your corrections go; Undo brings them back.</source>
        <translation>Vos corrections partent ; Annuler les ramène.</translation>
    </message>
    <message>
        <source>Keep all mine</source>
        <translation>Garder toute la mienne</translation>
    </message>
    <message>
        <source>The new segmentation goes, nothing changes.</source>
        <translation>La nouvelle segmentation est abandonnée, rien ne change.</translation>
    </message>
    <message>
        <source>Would be added</source>
        <translation>Serait ajouté</translation>
    </message>
    <message>
        <source>Would be removed</source>
        <translation>Serait enlevé</translation>
    </message>
    <message>
        <source>Would be another structure</source>
        <translation>Serait une autre structure</translation>
    </message>
    <message>
        <source>White rim: you corrected it by hand</source>
        <translation>Bord blanc : corrigé par vous à la main</translation>
    </message>
    <message>
        <source>It would change what you corrected by hand: %1. Your labels stay as they are until you decide.</source>
        <translation>Elle changerait ce que vous avez corrigé à la main : %1. Vos étiquettes restent telles quelles jusqu&apos;à votre décision.</translation>
    </message>
    <message>
        <source>Of %1 voxels that you corrected, %2 would change (%3 of %4 ml).</source>
        <translation>Sur %1 voxels que vous avez corrigés, %2 changeraient (%3 sur %4 ml).</translation>
    </message>
</context>
<context>
    <name>glisson::ui::OpenIgtLinkBox</name>
    <message>
        <source>Tell them by OpenIGTLink</source>
        <translation>Les informer par OpenIGTLink</translation>
    </message>
    <message>
        <source>Programs that connect are told of each frame: level, pose of the camera, surfaces.</source>
        <translation>Les programmes qui se connectent sont informés de chaque image : niveau, pose de la caméra, surfaces.</translation>
    </message>
    <message>
        <source>127.0.0.1: only programs of this computer can connect. Another address of this computer lets in whoever reaches it.</source>
        <translation>127.0.0.1 : seuls les programmes de cet ordinateur peuvent se connecter. Une autre adresse de cet ordinateur laisse entrer quiconque l&apos;atteint.</translation>
    </message>
    <message>
        <source>Address and port</source>
        <translation>Adresse et port</translation>
    </message>
</context>
<context>
    <name>glisson::ui::OpenIgtLinkModel</name>
    <message>
        <source>Listening at %1; no program is connected.</source>
        <translation>À l&apos;écoute à %1 ; aucun programme n&apos;est connecté.</translation>
    </message>
    <message>
        <source>Listening at %1; programs connected: %2</source>
        <translation>À l&apos;écoute à %1 ; programmes connectés : %2</translation>
    </message>
    <message>
        <source>Given up, too slow: %1</source>
        <translation>Abandonnés, trop lents : %1</translation>
    </message>
    <message>
        <source>Other computers can connect and read where the organ is: nothing is encrypted.</source>
        <translation>D&apos;autres ordinateurs peuvent se connecter et lire où se trouve l&apos;organe : rien n&apos;est chiffré.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::OrganView</name>
    <message>
        <source>Register the model: the organ appears here, as it was found.</source>
        <translation>Recalez le modèle : l’organe apparaît ici, tel qu’il a été trouvé.</translation>
    </message>
    <message>
        <source>%1+ mm</source>
        <translation>%1+ mm</translation>
    </message>
    <message>
        <source>Expected error of each place; or of a lesion, once the surface around a place has been seen as well. The ball marks the best place.</source>
        <translation>Erreur attendue à chaque endroit ; ou celle d’une lésion, une fois la surface autour d’un endroit vue aussi. La boule marque le meilleur endroit.</translation>
    </message>
    <message>
        <source>Error here</source>
        <translation>Erreur ici</translation>
    </message>
    <message>
        <source>%1 after a look here</source>
        <translation>%1 après un regard ici</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>No overlay: where the organ is in this picture is not known.</source>
        <translation>Pas de superposition : on ne sait pas où est l’organe dans cette image.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::Panel</name>
    <message>
        <source>Running</source>
        <translation>En cours</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Refusé</translation>
    </message>
    <message>
        <source>To be reviewed</source>
        <translation>À vérifier</translation>
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
        <translation>naissance %1</translation>
    </message>
    <message>
        <source>Anonymous</source>
        <translation>Anonyme</translation>
    </message>
</context>
<context>
    <name>glisson::ui::PlaybackBox</name>
    <message>
        <source>Start tracking</source>
        <translation>Démarrer le suivi</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Repeat the video</source>
        <translation>Répéter la vidéo</translation>
    </message>
    <message>
        <source>At its end, track again from the registered frame.</source>
        <translation>À la fin, suivre de nouveau depuis l&apos;image recalée.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::PlaybackModel</name>
    <message>
        <source>Tracking is running.</source>
        <translation>Le suivi est en cours.</translation>
    </message>
    <message>
        <source>The video has ended. Last picture, not live.</source>
        <translation>La vidéo est finie. Dernière image, pas en direct.</translation>
    </message>
    <message>
        <source>Tracking was stopped. Last picture, not live.</source>
        <translation>Le suivi a été arrêté. Dernière image, pas en direct.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::ProposalReview</name>
    <message>
        <source>Propose landmarks</source>
        <translation>Proposer des repères</translation>
    </message>
    <message>
        <source>Proposed landmarks</source>
        <translation>Repères proposés</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Accepter</translation>
    </message>
    <message>
        <source>It lies there</source>
        <translation>Il se trouve là</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Déplacer</translation>
    </message>
    <message>
        <source>Not visible</source>
        <translation>Non visible</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Take the last step of the review back</source>
        <translation>Annuler la dernière étape de la revue</translation>
    </message>
    <message>
        <source>The proposal is not used; what the CT itself shows stays</source>
        <translation>La proposition n&apos;est pas utilisée ; ce que le scanner montre lui-même reste</translation>
    </message>
    <message>
        <source>Drag it over the liver in 3D, or click where it lies in a slice</source>
        <translation>Le faire glisser sur le foie en 3D, ou cliquer dans une coupe là où il se trouve</translation>
    </message>
    <message>
        <source>Paint faces</source>
        <translation>Peindre les faces</translation>
    </message>
    <message>
        <source>Paint where it touches the liver, in 3D</source>
        <translation>Peindre en 3D là où il touche le foie</translation>
    </message>
    <message>
        <source>A smaller brush</source>
        <translation>Un pinceau plus petit</translation>
    </message>
    <message>
        <source>A larger brush</source>
        <translation>Un pinceau plus grand</translation>
    </message>
    <message>
        <source>Drag it over the liver, or click in a slice. Enter: at the crosshair. Esc: done.</source>
        <translation>Faire glisser sur le foie, ou cliquer dans une coupe. Entrée : au réticule. Échap : terminé.</translation>
    </message>
    <message>
        <source>Drag over the liver to paint, with Ctrl to wipe. Brush %1 mm (+, −). Esc: done.</source>
        <translation>Glisser sur le foie peint, avec Ctrl efface. Pinceau de %1 mm (+, −). Échap : terminé.</translation>
    </message>
    <message>
        <source>Choose an atlas first.</source>
        <translation>Choisissez d&apos;abord un atlas.</translation>
    </message>
    <message>
        <source>Paint where it touches the liver, in 3D or in a slice</source>
        <translation>Peindre où il touche le foie, en 3D ou dans une coupe</translation>
    </message>
    <message>
        <source>Drag over the liver, in 3D or in a slice, to paint, with Ctrl to wipe. Brush %1 mm (+, −, Shift + wheel in a slice). Esc: done.</source>
        <translation>Glisser sur le foie, en 3D ou dans une coupe, peint ; avec Ctrl, efface. Pinceau %1 mm (+, −, Maj + molette dans une coupe). Échap : terminé.</translation>
    </message>
    <message>
        <source>Of a former model: propose the landmarks again.</source>
        <translation>D&apos;un modèle antérieur : faites proposer à nouveau les repères.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::QualitySheet</name>
    <message>
        <source>Show the %1 flattest elements in 3D</source>
        <translation>Les %1 éléments les plus plats en 3D</translation>
    </message>
    <message>
        <source>I have checked this model</source>
        <translation>J&apos;ai vérifié ce modèle</translation>
    </message>
    <message>
        <source>Kept with the case. Another model, or an edit of its vessels, asks again.</source>
        <translation>Conservé avec le cas. Un autre modèle, ou une modification de ses vaisseaux, redemande.</translation>
    </message>
    <message>
        <source>No model yet.</source>
        <translation>Pas encore de modèle.</translation>
    </message>
    <message>
        <source>Nothing stands out. Look at the liver, its vessels and lesions in 3D.</source>
        <translation>Rien ne ressort. Regardez le foie, ses vaisseaux et lésions en 3D.</translation>
    </message>
    <message>
        <source>Worth a look:</source>
        <translation>À regarder :</translation>
    </message>
    <message>
        <source>Flat elements: the smallest angle is %1°. Build anew with another number of vertices.</source>
        <translation>Éléments plats : le plus petit angle est de %1°. Reconstruisez avec un autre nombre de sommets.</translation>
    </message>
    <message>
        <source>How closely the mesh follows the organ is not known: it was imported as it is, and there is no organ to compare it with.</source>
        <translation>On ne sait pas à quel point le maillage suit l&apos;organe : il a été importé tel quel et il n&apos;y a pas d&apos;organe auquel le comparer.</translation>
    </message>
    <message>
        <source>The mesh holds %1 % less volume than the organ. More vertices follow it more closely.</source>
        <translation>Le maillage a %1 % de volume de moins que l&apos;organe. Plus de sommets le suivent de plus près.</translation>
    </message>
    <message>
        <source>The mesh holds %1 % more volume than the organ. More vertices follow it more closely.</source>
        <translation>Le maillage a %1 % de volume de plus que l&apos;organe. Plus de sommets le suivent de plus près.</translation>
    </message>
    <message>
        <source>The mesh&apos;s vertices lie %1 mm beside the organ&apos;s surface on average.</source>
        <translation>Les sommets du maillage sont en moyenne à %1 mm de la surface de l&apos;organe.</translation>
    </message>
    <message>
        <source>A thin edge of the liver stands out of the mesh by %1 mm.</source>
        <translation>Un bord mince du foie dépasse du maillage de %1 mm.</translation>
    </message>
    <message>
        <source>%1: %2 separate trees. Join those that belong together.</source>
        <translation>%1 : %2 arbres séparés. Joignez ceux qui vont ensemble.</translation>
    </message>
    <message>
        <source>Lesions without elements of their own: %1. They follow the tissue around them.</source>
        <translation>Lésions sans éléments propres : %1. Elles suivent le tissu autour d&apos;elles.</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Sommets</translation>
    </message>
    <message>
        <source>Tetrahedra</source>
        <translation>Tétraèdres</translation>
    </message>
    <message>
        <source>Edge length, mean</source>
        <translation>Arête, moyenne</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>%1 ml</source>
        <translation>%1 ml</translation>
    </message>
    <message>
        <source>Volume error</source>
        <translation>Erreur de volume</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Vertices to fine surface, mean</source>
        <translation>Sommets à la surface fine, moyenne</translation>
    </message>
    <message>
        <source>Mesh to fine surface, mean</source>
        <translation>Maillage à la surface fine, moyenne</translation>
    </message>
    <message>
        <source>Fine surface to mesh, mean</source>
        <translation>Surface fine au maillage, moyenne</translation>
    </message>
    <message>
        <source>Fine surface to mesh, largest</source>
        <translation>Surface fine au maillage, maximum</translation>
    </message>
    <message>
        <source>Dihedral angles</source>
        <translation>Angles dièdres</translation>
    </message>
    <message>
        <source>%1° to %2°</source>
        <translation>%1° à %2°</translation>
    </message>
    <message>
        <source>%1, mesh %2 %</source>
        <translation>%1, maillage %2 %</translation>
    </message>
    <message>
        <source>%1 mm, tips: %2, beams: %3</source>
        <translation>%1 mm, bouts : %2, poutres : %3</translation>
    </message>
</context>
<context>
    <name>glisson::ui::RecentCases</name>
    <message>
        <source>Open &amp;recent</source>
        <translation>Ouvrir &amp;récent</translation>
    </message>
    <message>
        <source>&amp;Clear the list</source>
        <translation>&amp;Vider la liste</translation>
    </message>
</context>
<context>
    <name>glisson::ui::RecordingBox</name>
    <message>
        <source>Stop recording</source>
        <translation>Arrêter l&apos;enregistrement</translation>
    </message>
    <message>
        <source>Record…</source>
        <translation>Enregistrer…</translation>
    </message>
    <message>
        <source>Record the live view</source>
        <translation>Enregistrer la vue en direct</translation>
    </message>
    <message>
        <source>Video (*.mkv)</source>
        <translation>Vidéo (*.mkv)</translation>
    </message>
    <message>
        <source>Record the overlay</source>
        <translation>Enregistrer la superposition</translation>
    </message>
    <message>
        <source>Record the raw views</source>
        <translation>Enregistrer les vues brutes</translation>
    </message>
    <message>
        <source>Record both</source>
        <translation>Enregistrer les deux</translation>
    </message>
    <message>
        <source>Raw views, side by side, can be followed again. What was known of each picture is written beside.</source>
        <translation>Les vues brutes, côte à côte, peuvent être suivies de nouveau. Ce que l&apos;on savait de chaque image est écrit à côté.</translation>
    </message>
    <message>
        <source>The video has ended meanwhile: nothing is recorded.</source>
        <translation>La vidéo s&apos;est terminée entre-temps : rien n&apos;est enregistré.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::RecordingModel</name>
    <message>
        <source>Frames recorded: %1, in %2</source>
        <translation>Images enregistrées : %1, dans %2</translation>
    </message>
    <message>
        <source>Recording to %1</source>
        <translation>Enregistrement dans %1</translation>
    </message>
    <message>
        <source>Corrections and registrations made meanwhile: %1</source>
        <translation>Corrections et recalages faits entre-temps : %1</translation>
    </message>
    <message>
        <source>Pictures left out because the computer or its disk is too slow: %1</source>
        <translation>Images omises parce que l&apos;ordinateur ou son disque est trop lent : %1</translation>
    </message>
    <message>
        <source>%1: lies there already. Choose another name.</source>
        <translation>%1 : existe déjà à cet endroit. Choisissez un autre nom.</translation>
    </message>
    <message>
        <source>The recording is being brought to its end.</source>
        <translation>L&apos;enregistrement est en cours de finalisation.</translation>
    </message>
    <message>
        <source>Frames in which the picture before stays, as none came in time: %1</source>
        <translation>Images où la précédente reste, aucune n&apos;étant arrivée à temps : %1</translation>
    </message>
</context>
<context>
    <name>glisson::ui::RegionBox</name>
    <message>
        <source>Region</source>
        <translation>Région</translation>
    </message>
    <message>
        <source>Draw box</source>
        <translation>Tracer la boîte</translation>
    </message>
    <message>
        <source>Drag a rectangle in a slice, then its edges in the others. Only what lies in the box is looked at and found anew; the labels outside stay.</source>
        <translation>Tracez un rectangle dans une coupe, puis ses bords dans les autres. Seul ce qui est dans la boîte est examiné et retrouvé ; les labels à l’extérieur restent.</translation>
    </message>
    <message>
        <source>Whole CT</source>
        <translation>Tout le CT</translation>
    </message>
    <message>
        <source>No box: everywhere</source>
        <translation>Pas de boîte : partout</translation>
    </message>
    <message>
        <source>R to L</source>
        <translation>R à L</translation>
    </message>
    <message>
        <source>A to P</source>
        <translation>A à P</translation>
    </message>
    <message>
        <source>I to S</source>
        <translation>I à S</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>LPS: to the patient&apos;s left, to posterior and upwards is positive</source>
        <translation>LPS : vers la gauche du patient, l’arrière et le haut, c’est positif</translation>
    </message>
    <message>
        <source>Resolution at which the liver&apos;s surface evolves. Finer is slower.</source>
        <translation>Résolution à laquelle évolue la surface du foie. Plus fine, plus lente.</translation>
    </message>
    <message>
        <source>The CT&apos;s own</source>
        <translation>Celle du CT</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Résolution</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 mm</source>
        <translation>%1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>%1: too fine for so large a box if the liver fills it. At most 50 million voxels.</source>
        <translation>%1 : trop fin pour une si grande boîte si le foie la remplit. 50 millions de voxels au plus.</translation>
    </message>
    <message>
        <source>%1: up to %2 GB of memory</source>
        <translation>%1 : jusqu’à %2 Go de mémoire</translation>
    </message>
</context>
<context>
    <name>glisson::ui::RegistrationBox</name>
    <message>
        <source>Nobody has checked this model (Model, Quality). The picture says so.</source>
        <translation>Personne n’a vérifié ce modèle (Modèle, Qualité). L’image le dit.</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>Recaler</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Few forces of tools where they are worth it, else springs; both from the most probable shape</source>
        <translation>Peu de forces d&apos;instruments là où elles en valent la peine, sinon des ressorts ; les deux à partir de la forme la plus probable</translation>
    </message>
    <message>
        <source>Contact forces</source>
        <translation>Forces de contact</translation>
    </message>
    <message>
        <source>Few forces on the surface, under the elastic law that is most probable</source>
        <translation>Peu de forces sur la surface, sous la loi élastique la plus probable</translation>
    </message>
    <message>
        <source>Springs</source>
        <translation>Ressorts</translation>
    </message>
    <message>
        <source>Springs from the most probable shape to the points</source>
        <translation>Des ressorts de la forme la plus probable vers les points</translation>
    </message>
    <message>
        <source>As published</source>
        <translation>Comme publié</translation>
    </message>
    <message>
        <source>Springs alone, without simulated operations: to compare with</source>
        <translation>Des ressorts seuls, sans opérations simulées : pour comparer</translation>
    </message>
    <message>
        <source>Shape by</source>
        <translation>Forme par</translation>
    </message>
    <message>
        <source>Former registration</source>
        <translation>Recalage précédent</translation>
    </message>
    <message>
        <source>Back to the registration before this one, and forth again (Ctrl+Z before anything is tracked). It is kept with the case.</source>
        <translation>Retour au recalage avant celui-ci, et de nouveau en avant (Ctrl+Z avant tout suivi). Il reste avec le cas.</translation>
    </message>
    <message>
        <source>Use it nevertheless</source>
        <translation>L&apos;utiliser malgré tout</translation>
    </message>
    <message>
        <source>The registration was refused: what is known contradicts it. Its doubts stay in the picture.</source>
        <translation>Le recalage a été refusé : ce que l&apos;on sait le contredit. Ses doutes restent dans l&apos;image.</translation>
    </message>
    <message>
        <source>The organ may be elsewhere. Look at the other places over the picture and in 3D before going on.</source>
        <translation>L’organe peut se trouver ailleurs. Regardez les autres positions sur l’image et en 3D avant de poursuivre.</translation>
    </message>
    <message>
        <source>Use this place</source>
        <translation>Utiliser cette position</translation>
    </message>
    <message>
        <source>As registered</source>
        <translation>Tel que recalé</translation>
    </message>
    <message>
        <source>Choose another place above to compare.</source>
        <translation>Choisissez ci-dessus une autre position à comparer.</translation>
    </message>
    <message>
        <source>Drag the organ over the picture; with Shift it turns, with Ctrl it rolls, the wheel brings it nearer. Refine when its outline lies about right.</source>
        <translation>Glissez l’organe sur l’image ; avec Maj il tourne, avec Ctrl il roule, la molette le rapproche. Affinez quand son contour est à peu près en place.</translation>
    </message>
    <message>
        <source>Refine from here</source>
        <translation>Affiner à partir d’ici</translation>
    </message>
    <message>
        <source>Put it back</source>
        <translation>Remettre en place</translation>
    </message>
    <message>
        <source>Place by hand</source>
        <translation>Placer à la main</translation>
    </message>
    <message>
        <source>Where the rigid start goes wrong: hold the organ before the picture.</source>
        <translation>Quand le départ rigide se trompe : tenez l’organe devant l’image.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::RegistrationModel</name>
    <message>
        <source>A new registration is being computed: look at it first.</source>
        <translation>Un nouveau recalage est en cours de calcul : regardez-le d&apos;abord.</translation>
    </message>
    <message>
        <source>Residual (not an accuracy)</source>
        <translation>Résidu (pas une précision)</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>refusé</translation>
    </message>
    <message>
        <source>Expected error, mean</source>
        <translation>Erreur attendue, moyenne</translation>
    </message>
    <message>
        <source>Places where forces act</source>
        <translation>Endroits où agissent des forces</translation>
    </message>
    <message>
        <source>under 1 %</source>
        <translation>moins de 1 %</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Other place %1: %2, %3 mm away</source>
        <translation>Autre position %1 : %2, à %3 mm</translation>
    </message>
    <message>
        <source>How far off the organ may be is not known: register again.</source>
        <translation>On ne sait pas de combien l’organe peut être décalé : recalez de nouveau.</translation>
    </message>
    <message>
        <source>Expected error: mean %1 mm, at most %2 mm. Ellipsoids hold a lesion in 95 of 100 cases.</source>
        <translation>Erreur attendue : %1 mm en moyenne, %2 mm au plus. Les ellipsoïdes contiennent une lésion dans 95 cas sur 100.</translation>
    </message>
    <message>
        <source>Arrows: forces, relative to one another.</source>
        <translation>Flèches : forces, relatives les unes aux autres.</translation>
    </message>
    <message>
        <source>Out of date: an earlier step has changed since the registration.</source>
        <translation>Périmé : une étape antérieure a changé depuis le recalage.</translation>
    </message>
    <message>
        <source>Refused: what is known contradicts that the organ lies here.</source>
        <translation>Refusé : ce que l’on sait contredit que l’organe se trouve ici.</translation>
    </message>
    <message>
        <source>%1: no single look helps much.</source>
        <translation>%1 : aucun regard seul n’aide beaucoup.</translation>
    </message>
    <message>
        <source>Computation</source>
        <translation>Calcul</translation>
    </message>
    <message>
        <source>came to rest</source>
        <translation>arrivé au repos</translation>
    </message>
    <message>
        <source>stalled</source>
        <translation>n&apos;avance plus</translation>
    </message>
    <message>
        <source>stopped at its limit</source>
        <translation>arrêté à sa limite</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>échoué</translation>
    </message>
    <message>
        <source>%1: %2, %3 mm</source>
        <comment>other place</comment>
        <translation>%1 : %2, %3 mm</translation>
    </message>
    <message>
        <source>±%1 mm</source>
        <translation>±%1 mm</translation>
    </message>
    <message>
        <source>fork %1</source>
        <translation>bifurcation %1</translation>
    </message>
</context>
<context>
    <name>glisson::ui::RenderView</name>
    <message>
        <source>No picture in three dimensions: this computer offers no OpenGL 3.2. glisson doctor tells more.</source>
        <translation>Pas d’image en trois dimensions : cet ordinateur n’offre pas OpenGL 3.2. glisson doctor en dit plus.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::RivalPictures</name>
    <message>
        <source>The organ lies here: take this place</source>
        <translation>L&apos;organe est ici : prendre cette position</translation>
    </message>
    <message>
        <source>A place is being taken.</source>
        <translation>Une position est en train d&apos;être prise.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::ClickBox</name>
    <message>
        <source>Clicks correct at once</source>
        <translation>Les clics corrigent aussitôt</translation>
    </message>
    <message>
        <source>Where there are labels, a click on the liver that they leave out, on what is not liver, on a vein or on a lesion changes them around it and nowhere else. One step back: Ctrl+Z.</source>
        <translation>Là où il y a des étiquettes, un clic sur du foie qu’elles omettent, sur ce qui n’est pas du foie, sur une veine ou sur une lésion les change autour de lui et nulle part ailleurs. Un pas en arrière : Ctrl+Z.</translation>
    </message>
    <message>
        <source>With labels there: click what is missing, or too much.</source>
        <translation>Là où il y a des étiquettes : cliquez ce qui manque ou est en trop.</translation>
    </message>
    <message>
        <source>New labels are on their way, or wait for your decision: this click changes none now. It counts when you segment again.</source>
        <translation>De nouvelles étiquettes arrivent ou attendent votre décision : ce clic n&apos;en change aucune maintenant. Il comptera quand vous segmenterez à nouveau.</translation>
    </message>
    <message>
        <source>Correcting around the click…</source>
        <translation>Correction autour du clic…</translation>
    </message>
    <message>
        <source>Corrected around the click: %1 ml, up to %2 mm from it.</source>
        <translation>Corrigé autour du clic : %1 ml, jusqu’à %2 mm de lui.</translation>
    </message>
    <message>
        <source>The labels say already what the click says.</source>
        <translation>Les étiquettes disent déjà ce que dit le clic.</translation>
    </message>
    <message>
        <source>Not corrected.</source>
        <translation>Non corrigé.</translation>
    </message>
    <message>
        <source>Locked: this click changes nothing.</source>
        <translation>Verrouillé : ce clic ne change rien.</translation>
    </message>
    <message>
        <source>This click changes nothing now. It counts when you segment again.</source>
        <translation>Ce clic ne change rien maintenant. Il compte à la prochaine segmentation.</translation>
    </message>
    <message>
        <source>This click would replace what you have drawn: it waits for your decision.</source>
        <translation>Ce clic remplacerait ce que vous avez dessiné : cela attend votre décision.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::SeedBox</name>
    <message>
        <source>Not liver</source>
        <translation>Pas le foie</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Effacer</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Vider</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Charger…</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Garder…</translation>
    </message>
    <message>
        <source>Load seeds</source>
        <translation>Charger des germes</translation>
    </message>
    <message>
        <source>Seeds (*.json)</source>
        <translation>Germes (*.json)</translation>
    </message>
    <message>
        <source>Save seeds</source>
        <translation>Enregistrer les germes</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Tout</translation>
    </message>
    <message>
        <source>Portal and hepatic veins</source>
        <translation>Veines porte et hépatiques</translation>
    </message>
    <message>
        <source>Lesions</source>
        <translation>Lésions</translation>
    </message>
    <message>
        <source>All but the liver</source>
        <translation>Tout sauf le foie</translation>
    </message>
    <message>
        <source>What is found anew. All else stays as it is, with everything that you edited.</source>
        <translation>Ce qui est recherché à nouveau. Tout le reste reste tel quel, avec tout ce que vous avez modifié.</translation>
    </message>
    <message>
        <source>Find anew</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Segmenter</translation>
    </message>
    <message>
        <source>Place at least one seed in the liver.</source>
        <translation>Placez au moins un germe dans le foie.</translation>
    </message>
    <message>
        <source>There is no liver yet: find everything first.</source>
        <translation>Il n&apos;y a pas encore de foie : recherchez d&apos;abord tout.</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Foie</translation>
    </message>
    <message>
        <source>Portal vein</source>
        <translation>Veine porte</translation>
    </message>
    <message>
        <source>Hepatic veins</source>
        <translation>Veines hépatiques</translation>
    </message>
    <message>
        <source>Vena cava</source>
        <translation>Veine cave</translation>
    </message>
    <message>
        <source>Gallbladder</source>
        <translation>Vésicule biliaire</translation>
    </message>
    <message>
        <source>The box is too small.</source>
        <translation>La boîte est trop petite.</translation>
    </message>
    <message>
        <source>Place a seed in the liver inside the box.</source>
        <translation>Placez un germe dans le foie, dans la boîte.</translation>
    </message>
    <message>
        <source>Choose a structure, then click it in a slice; across a lesion you can also drag, to tell its diameter. Esc ends placing.</source>
        <translation>Choisissez une structure, puis cliquez-la dans une coupe ; à travers une lésion, vous pouvez aussi faire glisser pour indiquer son diamètre. Échap termine.</translation>
    </message>
    <message>
        <source>⌀ %1 mm</source>
        <translation>⌀ %1 mm</translation>
    </message>
    <message>
        <source>Propose the liver</source>
        <translation>Proposer le foie</translation>
    </message>
    <message>
        <source>Looks for the liver without a click in it: seeds that you can delete or add to.</source>
        <translation>Cherche le foie sans un clic : des germes que vous pouvez supprimer ou compléter.</translation>
    </message>
    <message>
        <source>Put back</source>
        <translation>Remettre</translation>
    </message>
    <message>
        <source>Your corrections lie on the voxels of another CT: what would change cannot be shown. The new segmentation takes the place of all labels, and they are lost.</source>
        <translation>Vos corrections se trouvent sur les voxels d’un autre scanner : ce qui changerait ne peut pas être montré. La nouvelle segmentation prend la place de toutes les étiquettes, et elles sont perdues.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::SegmentationPanel</name>
    <message>
        <source>Shows what is told of this segmentation</source>
        <translation>Montre ce qui est dit de cette segmentation</translation>
    </message>
    <message>
        <source>Notes to read: %1</source>
        <translation>Remarques à lire : %1</translation>
    </message>
    <message>
        <source>Segmentation</source>
        <translation>Segmentation</translation>
    </message>
    <message>
        <source>Import labels</source>
        <translation>Importer des étiquettes</translation>
    </message>
    <message>
        <source>%1 ml</source>
        <translation>%1 ml</translation>
    </message>
    <message>
        <source>Grow the structures from a few clicks, then correct them by hand.</source>
        <translation>Faites croître les structures à partir de quelques clics, puis corrigez-les à la main.</translation>
    </message>
    <message>
        <source>Seeds and growth</source>
        <translation>Graines et croissance</translation>
    </message>
    <message>
        <source>Review and edit</source>
        <translation>Revoir, modifier</translation>
    </message>
    <message>
        <source>Approve</source>
        <translation>Approuver</translation>
    </message>
    <message>
        <source>You have looked at the chosen label and it is right: the next one comes. An edit takes that back.</source>
        <translation>Vous avez regardé l&apos;étiquette choisie et elle est juste : la suivante vient. Une modification retire cela.</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importer…</translation>
    </message>
    <message>
        <source>Opacity of the labels in the slices</source>
        <translation>Opacité des étiquettes dans les coupes</translation>
    </message>
    <message>
        <source>Approved</source>
        <translation>Approuvé</translation>
    </message>
    <message>
        <source>%1: nothing yet</source>
        <translation>%1 : rien encore</translation>
    </message>
    <message>
        <source>longest diameter %1 mm</source>
        <translation>plus long diamètre %1 mm</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>A new segmentation waits: decide about it first, imported labels would take its place.</source>
        <translation>Une nouvelle segmentation attend : décidez d&apos;abord à son sujet, des étiquettes importées prendraient sa place.</translation>
    </message>
    <message>
        <source>Labels that were made elsewhere: DICOM segmentation, .seg.nrrd, NIfTI</source>
        <translation>Étiquettes faites ailleurs : segmentation DICOM, .seg.nrrd, NIfTI</translation>
    </message>
    <message>
        <source>Labels (*.nrrd *.dcm *.nii *.nii.gz *.mha *.mhd *.vti)</source>
        <translation>Étiquettes (*.nrrd *.dcm *.nii *.nii.gz *.mha *.mhd *.vti)</translation>
    </message>
</context>
<context>
    <name>glisson::ui::SeriesDialog</name>
    <message>
        <source>Several series</source>
        <translation>Plusieurs séries</translation>
    </message>
    <message numerus="yes">
        <source>This folder holds %n series. Which one shows the liver in the portal venous phase? The likeliest is at the top.</source>
        <translation>
            <numerusform>Ce dossier contient %n série. Laquelle montre le foie à la phase portale ? La plus probable est en haut.</numerusform>
            <numerusform>Ce dossier contient %n séries. Laquelle montre le foie à la phase portale ? La plus probable est en haut.</numerusform>
        </translation>
    </message>
    <message>
        <source>Patient: %1</source>
        <translation>Patient : %1</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Série</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Coupes</translation>
    </message>
    <message>
        <source>Pixels and spacing</source>
        <translation>Pixels et espacement</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Remarques</translation>
    </message>
    <message>
        <source>series %1</source>
        <translation>série %1</translation>
    </message>
    <message>
        <source>%1, series %2</source>
        <translation>%1, série %2</translation>
    </message>
    <message>
        <source>contrast agent</source>
        <translation>produit de contraste</translation>
    </message>
    <message>
        <source>likeliest</source>
        <translation>la plus probable</translation>
    </message>
</context>
<context>
    <name>glisson::ui::ShapeModes</name>
    <message>
        <source>Show how livers differ</source>
        <translation>Montrer comment les foies diffèrent</translation>
    </message>
    <message>
        <source>The atlas&apos; mean liver over the patient&apos;s, bent by its first modes</source>
        <translation>Le foie moyen de l&apos;atlas sur celui du patient, déformé par ses premiers modes</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Mode</translation>
    </message>
    <message>
        <source>Standard deviations from the mean liver</source>
        <translation>Écarts types par rapport au foie moyen</translation>
    </message>
    <message>
        <source>Keys: 1 to 5 choose the mode, the arrows bend, 0 is the mean liver, Esc leaves.</source>
        <translation>Touches : 1 à 5 choisissent le mode, les flèches déforment, 0 est le foie moyen, Échap quitte.</translation>
    </message>
    <message>
        <source>Mode %1: %2 % of the variance</source>
        <translation>Mode %1 : %2 % de la variance</translation>
    </message>
    <message>
        <source>Mean liver of %1 (%2 livers)
Mode %3 at %4 deviations
%5 % of the variance</source>
        <translation>Foie moyen de %1 (%2 foies)
Mode %3 à %4 écarts types
%5 % de la variance</translation>
    </message>
</context>
<context>
    <name>glisson::ui::SliceView</name>
    <message>
        <source>No volume</source>
        <translation>Pas de volume</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axiale</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Coronale</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittale</translation>
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
        <translation>Clic : réticule. Molette : coupe suivante. Glisser droit : contraste. Glisser milieu : déplacer. Ctrl + molette : zoom. Double-clic : cette vue seule. Clic droit : menu.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::SourceDialog</name>
    <message>
        <source>Arrangement of a stereo source</source>
        <translation>Disposition d’une source stéréo</translation>
    </message>
    <message>
        <source>What is said here is written into a small file, by which this source can be opened again.</source>
        <translation>Ces indications sont écrites dans un petit fichier, qui permet de rouvrir cette source.</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Côte à côte</translation>
    </message>
    <message>
        <source>One above the other</source>
        <translation>L’une au-dessus de l’autre</translation>
    </message>
    <message>
        <source>Row by row</source>
        <translation>Ligne par ligne</translation>
    </message>
    <message>
        <source>Two sources</source>
        <translation>Deux sources</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Vues</translation>
    </message>
    <message>
        <source>video, folder of pictures, or device:0</source>
        <translation>vidéo, dossier d’images ou device:0</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>Right source</source>
        <translation>Source droite</translation>
    </message>
    <message>
        <source>The right view comes first</source>
        <translation>La vue droite vient en premier</translation>
    </message>
    <message>
        <source>Interlaced: use the first field only</source>
        <translation>Entrelacé : n’utiliser que la première trame</translation>
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
        <translation>largeur </translation>
    </message>
    <message>
        <source>height </source>
        <translation>hauteur </translation>
    </message>
    <message>
        <source>Pixels of each view that are kept; a width or height of 0: all</source>
        <translation>Pixels gardés de chaque vue ; largeur ou hauteur 0 : tous</translation>
    </message>
    <message>
        <source>Crop</source>
        <translation>Cadrage</translation>
    </message>
    <message>
        <source>Save and open…</source>
        <translation>Enregistrer et ouvrir…</translation>
    </message>
    <message>
        <source>Stereo source</source>
        <translation>Source stéréo</translation>
    </message>
    <message>
        <source>Videos (*.mkv *.mp4 *.avi *.mov);;All files (*)</source>
        <translation>Vidéos (*.mkv *.mp4 *.avi *.mov);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Save the description</source>
        <translation>Enregistrer la description</translation>
    </message>
    <message>
        <source>Stereo source (*.json)</source>
        <translation>Source stéréo (*.json)</translation>
    </message>
</context>
<context>
    <name>glisson::ui::StepBar</name>
    <message>
        <source>Research software: not for clinical use</source>
        <translation>Logiciel de recherche : pas d&apos;usage clinique</translation>
    </message>
    <message>
        <source>Ctrl+%1</source>
        <translation>Ctrl+%1</translation>
    </message>
    <message>
        <source>not done</source>
        <translation>à faire</translation>
    </message>
    <message>
        <source>? to be reviewed</source>
        <translation>? à vérifier</translation>
    </message>
    <message>
        <source>✓ up to date</source>
        <translation>✓ à jour</translation>
    </message>
    <message>
        <source>! out of date</source>
        <translation>! périmé</translation>
    </message>
    <message>
        <source>running…</source>
        <translation>en cours…</translation>
    </message>
    <message>
        <source>✕ refused</source>
        <translation>✕ refusé</translation>
    </message>
</context>
<context>
    <name>glisson::ui::StereoPanel</name>
    <message>
        <source>Stereo</source>
        <translation>Stéréo</translation>
    </message>
    <message>
        <source>What the stereo laparoscope sees of the liver, as points in space.</source>
        <translation>Ce que le laparoscope stéréo voit du foie, en points dans l&apos;espace.</translation>
    </message>
    <message>
        <source>Reconstruct</source>
        <translation>Reconstruire</translation>
    </message>
    <message>
        <source>Reconstruct surface</source>
        <translation>Reconstruire la surface</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Frame </source>
        <translation>Image </translation>
    </message>
    <message>
        <source>Take this frame</source>
        <translation>Prendre</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Régions</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Étalonnage</translation>
    </message>
    <message>
        <source>%1 × %2, baseline %3 mm</source>
        <translation>%1 × %2, base %3 mm</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>Video: %1</source>
        <translation>Vidéo : %1</translation>
    </message>
    <message>
        <source>Stereo pair, %1 × %2</source>
        <translation>Paire stéréo, %1 × %2</translation>
    </message>
    <message>
        <source>left</source>
        <translation>gauche</translation>
    </message>
    <message>
        <source>right</source>
        <translation>droite</translation>
    </message>
    <message>
        <source>%1, line</source>
        <translation>%1, ligne</translation>
    </message>
    <message>
        <source>%1 (%2), corners: %3</source>
        <translation>%1 (%2), coins : %3</translation>
    </message>
    <message>
        <source>%1, crosses itself</source>
        <translation>%1, se croise</translation>
    </message>
    <message>
        <source>Calibration file…</source>
        <translation>Fichier d&apos;étalonnage…</translation>
    </message>
    <message>
        <source>Folder of text files…</source>
        <translation>Dossier de fichiers texte…</translation>
    </message>
    <message>
        <source>Calibrate from boards…</source>
        <translation>Étalonner avec des mires…</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Enregistrer sous…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Choose a feature and click around it in either picture. Esc ends drawing; then corners can be dragged.</source>
        <translation>Choisissez un repère et cliquez autour dans l&apos;une des images. Échap termine le tracé ; les coins peuvent alors être glissés.</translation>
    </message>
    <message>
        <source>Margin as a line</source>
        <translation>Bord en ligne</translation>
    </message>
    <message>
        <source>Undo (Ctrl+Z)</source>
        <translation>Annuler (Ctrl+Z)</translation>
    </message>
    <message>
        <source>Redo (Ctrl+Shift+Z)</source>
        <translation>Rétablir (Ctrl+Maj+Z)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Vider</translation>
    </message>
    <message>
        <source>Features are the paper&apos;s way. Dense covers what lies between them. Automatic becomes dense where features leave less than %1 points per cm².</source>
        <translation>Les points caractéristiques sont la voie de l&apos;article. Dense couvre ce qui est entre eux. Automatique devient dense là où ils laissent moins de %1 points par cm².</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Features</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Dense</source>
        <translation>Dense</translation>
    </message>
    <message>
        <source>Kind of features that are looked for in both pictures</source>
        <translation>Type de points cherchés dans les deux images</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.bmp *.tif *.tiff)</source>
        <translation>Images (*.png *.jpg *.jpeg *.bmp *.tif *.tiff)</translation>
    </message>
    <message>
        <source>Videos (*.mkv *.mp4 *.avi *.mov)</source>
        <translation>Vidéos (*.mkv *.mp4 *.avi *.mov)</translation>
    </message>
    <message>
        <source>Stereo pair…</source>
        <translation>Paire stéréo…</translation>
    </message>
    <message>
        <source>Video, side by side…</source>
        <translation>Vidéo, côte à côte…</translation>
    </message>
    <message>
        <source>Two videos…</source>
        <translation>Deux vidéos…</translation>
    </message>
    <message>
        <source>Folder of pairs…</source>
        <translation>Dossier de paires…</translation>
    </message>
    <message>
        <source>Live device…</source>
        <translation>Appareil en direct…</translation>
    </message>
    <message>
        <source>Other arrangement…</source>
        <translation>Autre disposition…</translation>
    </message>
    <message>
        <source>OpenCV YAML (*.yml *.yaml)</source>
        <translation>OpenCV YAML (*.yml *.yaml)</translation>
    </message>
    <message>
        <source>Folder of 3 × 3 and 4 × 4 text files, millimetres</source>
        <translation>Dossier de fichiers texte 3 × 3 et 4 × 4, millimètres</translation>
    </message>
    <message>
        <source>Save the calibration</source>
        <translation>Enregistrer l’étalonnage</translation>
    </message>
    <message>
        <source>Glisson</source>
        <translation>Glisson</translation>
    </message>
    <message>
        <source>Left picture</source>
        <translation>Image gauche</translation>
    </message>
    <message>
        <source>Right picture</source>
        <translation>Image droite</translation>
    </message>
    <message>
        <source>Stereo video, both views side by side</source>
        <translation>Vidéo stéréo, deux vues côte à côte</translation>
    </message>
    <message>
        <source>Video of the left camera</source>
        <translation>Vidéo de la caméra gauche</translation>
    </message>
    <message>
        <source>Video of the right camera</source>
        <translation>Vidéo de la caméra droite</translation>
    </message>
    <message>
        <source>Folder of left and right pictures</source>
        <translation>Dossier d’images gauches et droites</translation>
    </message>
    <message>
        <source>Live device</source>
        <translation>Appareil en direct</translation>
    </message>
    <message>
        <source>Number of the video device</source>
        <translation>Numéro de l’appareil vidéo</translation>
    </message>
    <message>
        <source>Frame of the video</source>
        <translation>Image de la vidéo</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Kind of features</source>
        <translation>Type de points d’intérêt</translation>
    </message>
    <message>
        <source>The calibration is for pictures of %1 × %2, these are %3 × %4: load the one for them.</source>
        <translation>L’étalonnage vaut pour des images de %1 × %2, celles-ci ont %3 × %4 : chargez celui qui convient.</translation>
    </message>
    <message>
        <source>OpenIGTLink server…</source>
        <translation>Serveur OpenIGTLink…</translation>
    </message>
    <message>
        <source>OpenIGTLink server</source>
        <translation>Serveur OpenIGTLink</translation>
    </message>
    <message>
        <source>Address and port of PLUS or another server, and its devices of the left and the right picture</source>
        <translation>Adresse et port de PLUS ou d&apos;un autre serveur, et ses appareils de l&apos;image gauche et de l&apos;image droite</translation>
    </message>
    <message>
        <source>Still as drawn on another frame: %1. Move or clear them.</source>
        <translation>Encore comme dessinées sur une autre image : %1. Déplacez-les ou effacez-les.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::StereoView</name>
    <message>
        <source>Surface</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>Anterior margin</source>
        <translation>Bord antérieur</translation>
    </message>
    <message>
        <source>Umbilical notch</source>
        <translation>Échancrure</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Load a stereo pair or a video, and the laparoscope&apos;s calibration.</source>
        <translation>Chargez une paire stéréo ou une vidéo, et l’étalonnage du laparoscope.</translation>
    </message>
    <message>
        <source>Reconstructed points</source>
        <translation>Points reconstruits</translation>
    </message>
    <message>
        <source>No points yet</source>
        <translation>Pas encore de points</translation>
    </message>
    <message>
        <source>Epipolar lines</source>
        <translation>Lignes épipolaires</translation>
    </message>
    <message>
        <source>Where the other picture can show what lies under the pointer. A click keeps the line; another click next to it lets it go.</source>
        <translation>Où l’autre image peut montrer ce qui est sous le pointeur. Un clic fixe la ligne ; un autre clic à côté la libère.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>The reconstructed points in both pictures</source>
        <translation>Les points reconstruits dans les deux images</translation>
    </message>
    <message>
        <source>Area used</source>
        <translation>Zone utilisée</translation>
    </message>
    <message>
        <source>Darkens what is not reconstructed: outside the mask, or outside the laparoscope&apos;s circle.</source>
        <translation>Assombrit ce qui n’est pas reconstruit : hors du masque ou du cercle du laparoscope.</translation>
    </message>
    <message>
        <source>Missing points</source>
        <translation>Points manquants</translation>
    </message>
    <message>
        <source>Orange where the left picture has fewer points per cm² than registration needs, blue where it has enough.</source>
        <translation>Orange où l’image gauche a moins de points par cm² que le recalage n’en demande, bleu où il y en a assez.</translation>
    </message>
    <message>
        <source>Loupe</source>
        <translation>Loupe</translation>
    </message>
    <message>
        <source>Enlarges what is under the pointer while you draw.</source>
        <translation>Agrandit ce qui est sous le pointeur pendant le tracé.</translation>
    </message>
    <message>
        <source>Out of date: reconstruct again</source>
        <translation>Périmé : reconstruire à nouveau</translation>
    </message>
    <message>
        <source>Enter or a double click ends the line; Backspace takes a corner back.</source>
        <translation>Entrée ou un double clic termine la ligne ; Retour arrière reprend un sommet.</translation>
    </message>
    <message>
        <source>Click around &quot;%1&quot; in either picture.</source>
        <translation>Cliquez autour de « %1 » dans l’une des images.</translation>
    </message>
    <message>
        <source>Choose a feature on the right to label it.</source>
        <translation>Choisissez à droite une structure à marquer.</translation>
    </message>
    <message>
        <source>Click: the outline begins here. Esc: stop drawing.</source>
        <translation>Clic : le contour commence ici. Échap : arrêter le tracé.</translation>
    </message>
    <message>
        <source>Click: the line begins here. Esc: stop drawing.</source>
        <translation>Clic : la ligne commence ici. Échap : arrêter le tracé.</translation>
    </message>
    <message>
        <source>Click: next corner. Enter, double click: end. Backspace: one back. Esc: drop.</source>
        <translation>Clic : sommet suivant. Entrée, double clic : fin. Retour arrière : un de moins. Échap : abandonner.</translation>
    </message>
    <message>
        <source>Click: closes the outline.</source>
        <translation>Clic : ferme le contour.</translation>
    </message>
    <message>
        <source>Click: ends the line here.</source>
        <translation>Clic : termine la ligne ici.</translation>
    </message>
    <message>
        <source>The line was begun in the other picture. Enter ends it, Esc drops it.</source>
        <translation>La ligne a été commencée dans l’autre image. Entrée la termine, Échap l’abandonne.</translation>
    </message>
    <message>
        <source>Drag: moves this corner.</source>
        <translation>Glisser : déplace ce sommet.</translation>
    </message>
    <message>
        <source>Click or drag: a new corner here. Delete: removes the region.</source>
        <translation>Clic ou glisser : nouveau sommet ici. Suppr : supprime la région.</translation>
    </message>
    <message>
        <source>Click: selects this region. Right click: removes it.</source>
        <translation>Clic : sélectionne cette région. Clic droit : la supprime.</translation>
    </message>
    <message>
        <source>%1 points per cm²</source>
        <translation>%1 points par cm²</translation>
    </message>
    <message>
        <source>Choose a feature on the right to label it. The wheel enlarges a picture, the middle button moves it.</source>
        <translation>Choisissez à droite un élément à étiqueter. La molette agrandit une image, le bouton du milieu la déplace.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::TaskButton</name>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>Annulation…</translation>
    </message>
    <message>
        <source>Waiting…</source>
        <translation>En attente…</translation>
    </message>
    <message>
        <source>Done in %1 s</source>
        <translation>Fait en %1 s</translation>
    </message>
    <message>
        <source>Cancelled; nothing was changed</source>
        <translation>Annulé ; rien n&apos;a changé</translation>
    </message>
</context>
<context>
    <name>glisson::ui::TaskStatus</name>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>%1: done in %2 s</source>
        <translation>%1 : fait en %2 s</translation>
    </message>
    <message>
        <source>%1: done in %2 s – notes to read, on the right: %3</source>
        <translation>%1 : fait en %2 s – remarques à lire, à droite : %3</translation>
    </message>
    <message>
        <source>%1: done in %2 s – notes to read, under Segmentation: %3</source>
        <translation>%1 : fait en %2 s – remarques à lire, sous « Segmentation » : %3</translation>
    </message>
    <message>
        <source>%1: cancelled</source>
        <translation>%1 : annulé</translation>
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
        <translation>Une image en arrière (flèche gauche)</translation>
    </message>
    <message>
        <source>Play or pause (space)</source>
        <translation>Lecture ou pause (espace)</translation>
    </message>
    <message>
        <source>One frame on (right arrow)</source>
        <translation>Une image en avant (flèche droite)</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>Begin again at the end</source>
        <translation>Recommencer à la fin</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Direct</translation>
    </message>
    <message>
        <source>Back to the live video (End)</source>
        <translation>Retour à la vidéo en direct (Fin)</translation>
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
        <translation>Ligne du temps</translation>
    </message>
    <message>
        <source>Blue: overlay shown. Yellow: outline and regions only. Red: no overlay.</source>
        <translation>Bleu : superposition montrée. Jaune : contour et zones seulement. Rouge : aucune superposition.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::TissueBox</name>
    <message>
        <source>Healthy</source>
        <translation>Sain</translation>
    </message>
    <message>
        <source>Cirrhotic</source>
        <translation>Cirrhotique</translation>
    </message>
    <message>
        <source>By value</source>
        <translation>Par valeur</translation>
    </message>
    <message>
        <source> kPa</source>
        <translation> kPa</translation>
    </message>
    <message>
        <source>As liver</source>
        <translation>Comme le foie</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>Molle</translation>
    </message>
    <message>
        <source>Stiff</source>
        <translation>Raide</translation>
    </message>
    <message>
        <source>A third of the liver&apos;s Young&apos;s modulus</source>
        <translation>Un tiers du module d&apos;Young du foie</translation>
    </message>
    <message>
        <source>Five times the liver&apos;s Young&apos;s modulus</source>
        <translation>Cinq fois le module d&apos;Young du foie</translation>
    </message>
</context>
<context>
    <name>glisson::ui::ToolBox</name>
    <message>
        <source>Take a tool&apos;s tip from a server</source>
        <translation>Prendre la pointe d&apos;un outil d&apos;un serveur</translation>
    </message>
    <message>
        <source>While the tip is within 5 mm of the organ&apos;s surface it marks the place there.</source>
        <translation>Tant que la pointe est à moins de 5 mm de la surface de l&apos;organe, elle y marque l&apos;endroit.</translation>
    </message>
    <message>
        <source>Address and port, and the name of the transform from the tool&apos;s tip to the left camera.</source>
        <translation>Adresse et port, et nom de la transformation de la pointe de l&apos;outil vers la caméra gauche.</translation>
    </message>
    <message>
        <source>Server and tool</source>
        <translation>Serveur et outil</translation>
    </message>
</context>
<context>
    <name>glisson::ui::ToolModel</name>
    <message>
        <source>The server has closed the connection.</source>
        <translation>Le serveur a fermé la connexion.</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>Connexion…</translation>
    </message>
    <message>
        <source>The tool&apos;s pose is %1 s old: it is not used.</source>
        <translation>La pose de l&apos;outil date de %1 s : elle n&apos;est pas utilisée.</translation>
    </message>
    <message>
        <source>Connected; no pose of this tool has come.</source>
        <translation>Connecté ; aucune pose de cet outil n&apos;est arrivée.</translation>
    </message>
    <message>
        <source>The tool&apos;s pose comes in; the organ is not followed just now.</source>
        <translation>La pose de l&apos;outil arrive ; l&apos;organe n&apos;est pas suivi en ce moment.</translation>
    </message>
    <message>
        <source>The tool&apos;s pose comes in; a former moment is on the screen, and nothing is told of it.</source>
        <translation>La pose de l&apos;outil arrive ; un moment antérieur est à l&apos;écran, et rien n&apos;en est dit.</translation>
    </message>
    <message>
        <source>The tool&apos;s pose comes in; the video is paused.</source>
        <translation>La pose de l&apos;outil arrive ; la vidéo est en pause.</translation>
    </message>
    <message>
        <source>The tool&apos;s pose comes in; the last picture is %1 s old: it is not used.</source>
        <translation>La pose de l&apos;outil arrive ; la dernière image date de %1 s : elle n&apos;est pas utilisée.</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Tip to the organ&apos;s surface: %1</source>
        <translation>De la pointe à la surface de l&apos;organe : %1</translation>
    </message>
    <message>
        <source>Tip inside the organ, %1 below its surface</source>
        <translation>Pointe dans l&apos;organe, %1 sous sa surface</translation>
    </message>
    <message>
        <source>%1 (±%2)</source>
        <translation>%1 (±%2)</translation>
    </message>
    <message>
        <source>Tip to %1: %2</source>
        <translation>De la pointe à %1 : %2</translation>
    </message>
</context>
<context>
    <name>glisson::ui::ToolPages</name>
    <message>
        <source>Diameter</source>
        <translation>Diamètre</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Size of the brush. In a slice: Shift + wheel.</source>
        <translation>Taille du pinceau. Dans une coupe : Maj + molette.</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinceau</translation>
    </message>
    <message>
        <source>Disc, this slice</source>
        <translation>Disque, cette coupe</translation>
    </message>
    <message>
        <source>Ball, all slices</source>
        <translation>Boule, toutes les coupes</translation>
    </message>
    <message>
        <source>Erase any label</source>
        <translation>Effacer toute étiquette</translation>
    </message>
    <message>
        <source>Does</source>
        <translation>Action</translation>
    </message>
    <message>
        <source>Fill inside</source>
        <translation>Remplir l&apos;intérieur</translation>
    </message>
    <message>
        <source>Erase inside</source>
        <translation>Effacer l&apos;intérieur</translation>
    </message>
    <message>
        <source>Erase outside</source>
        <translation>Effacer l&apos;extérieur</translation>
    </message>
    <message>
        <source>In slices</source>
        <translation>Dans les coupes</translation>
    </message>
    <message>
        <source>This slice only</source>
        <translation>Cette coupe seulement</translation>
    </message>
    <message>
        <source>A slab around it</source>
        <translation>Une tranche autour</translation>
    </message>
    <message>
        <source>Through the whole volume</source>
        <translation>À travers tout le volume</translation>
    </message>
    <message>
        <source>Slab</source>
        <translation>Tranche</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source> HU</source>
        <translation> UH</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>Forget what the label had before</source>
        <translation>Oublier ce que l&apos;étiquette avait</translation>
    </message>
    <message>
        <source>Use the range for painting</source>
        <translation>Utiliser l&apos;intervalle pour peindre</translation>
    </message>
    <message>
        <source>Tools then change only voxels of these intensities; paint comes next.</source>
        <translation>Les outils ne changent alors que les voxels de ces intensités ; vient ensuite le pinceau.</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Médiane</translation>
    </message>
    <message>
        <source>Closing: fills gaps</source>
        <translation>Fermeture : comble les vides</translation>
    </message>
    <message>
        <source>Opening: takes spikes</source>
        <translation>Ouverture : retire les pointes</translation>
    </message>
    <message>
        <source>Joint: all labels</source>
        <translation>Ensemble : toutes</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>Agrandir</translation>
    </message>
    <message>
        <source>Shrink</source>
        <translation>Rétrécir</translation>
    </message>
    <message>
        <source>By</source>
        <translation>De</translation>
    </message>
    <message>
        <source>Holes of one slice, too</source>
        <translation>Aussi les trous d&apos;une coupe</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Coupes</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axiale</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Coronale</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittale</translation>
    </message>
    <message>
        <source>Keep the largest</source>
        <translation>Garder le plus grand</translation>
    </message>
    <message>
        <source>Remove small ones</source>
        <translation>Retirer les petits</translation>
    </message>
    <message>
        <source>Keep the one that is clicked</source>
        <translation>Garder celui qui est cliqué</translation>
    </message>
    <message>
        <source>Remove the one that is clicked</source>
        <translation>Retirer celui qui est cliqué</translation>
    </message>
    <message>
        <source>Split: a label for each</source>
        <translation>Séparer : une étiquette chacun</translation>
    </message>
    <message>
        <source>Smaller than</source>
        <translation>Plus petits que</translation>
    </message>
    <message>
        <source> ml</source>
        <translation> ml</translation>
    </message>
    <message>
        <source>Copy from</source>
        <translation>Copier depuis</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Subtract</source>
        <translation>Soustraire</translation>
    </message>
    <message>
        <source>Keep what is also in</source>
        <translation>Garder ce qui est aussi dans</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>Inverser</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Vider</translation>
    </message>
    <message>
        <source>Fill everything</source>
        <translation>Tout remplir</translation>
    </message>
    <message>
        <source>Other label</source>
        <translation>Autre étiquette</translation>
    </message>
    <message>
        <source>No farther than</source>
        <translation>Pas plus loin que</translation>
    </message>
    <message>
        <source>The branch</source>
        <translation>La branche</translation>
    </message>
    <message>
        <source>goes to the other tree</source>
        <translation>passe à l&apos;autre arbre</translation>
    </message>
    <message>
        <source>is cut off</source>
        <translation>est coupée</translation>
    </message>
    <message>
        <source>Radius at most</source>
        <translation>Rayon maximal</translation>
    </message>
</context>
<context>
    <name>glisson::ui::TreeEditor</name>
    <message>
        <source>Entrance</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>Where blood enters or leaves the tree; it is held there.</source>
        <translation>Là où le sang entre dans l&apos;arbre ou le quitte ; il y est tenu.</translation>
    </message>
    <message>
        <source>Prune</source>
        <translation>Élaguer</translation>
    </message>
    <message>
        <source>Cuts off a branch with all that hangs on it.</source>
        <translation>Coupe une branche avec tout ce qui y pend.</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Joindre</translation>
    </message>
    <message>
        <source>Hangs one tree on another of its kind.</source>
        <translation>Accroche un arbre à un autre de même espèce.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Click the place on a centreline where its tree is to enter. White balls are the entrances now. Esc ends.</source>
        <translation>Cliquez l&apos;endroit d&apos;une ligne centrale où son arbre doit entrer. Les boules blanches sont les entrées actuelles. Échap termine.</translation>
    </message>
    <message>
        <source>Now click the other tree, where it is to hang on.</source>
        <translation>Cliquez maintenant l&apos;autre arbre, là où il doit être accroché.</translation>
    </message>
    <message>
        <source>Click the tree that stays, then the one that is to hang on it. Esc ends.</source>
        <translation>Cliquez l&apos;arbre qui reste, puis celui qui doit y être accroché. Échap termine.</translation>
    </message>
    <message>
        <source>Point at the branch that is to go: what a click cuts off is marked. Esc ends.</source>
        <translation>Pointez la branche à retirer : ce qu’un clic coupe est marqué. Échap termine.</translation>
    </message>
    <message>
        <source>%1, %2 mm, tips: %3.</source>
        <translation>%1, %2 mm, extrémités : %3.</translation>
    </message>
    <message>
        <source>A click here takes the whole tree: %1</source>
        <translation>Un clic ici retire tout l’arbre : %1</translation>
    </message>
    <message>
        <source>A click here cuts off: %1</source>
        <translation>Un clic ici coupe : %1</translation>
    </message>
    <message>
        <source>A click here lets this tree stay: %1</source>
        <translation>Un clic ici garde cet arbre : %1</translation>
    </message>
    <message>
        <source>A click here hangs this on the tree that stays, %1 mm away: %2</source>
        <translation>Un clic ici rattache ceci à l’arbre gardé, à %1 mm : %2</translation>
    </message>
    <message>
        <source>This is the tree that stays. Point at another one.</source>
        <translation>C’est l’arbre gardé. Pointez-en un autre.</translation>
    </message>
    <message>
        <source>Trees of one kind are joined: the one that stays is %1, this is %2.</source>
        <translation>Seuls des arbres du même type se joignent : celui qui est gardé est %1, celui-ci %2.</translation>
    </message>
    <message>
        <source>%1 mm from the place that was clicked: too far to join.</source>
        <translation>À %1 mm de l’endroit cliqué : trop loin pour joindre.</translation>
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
        <translation>Ouvrez le scanner d&apos;un patient ou un cas, ou déposez-le ici.</translation>
    </message>
    <message>
        <source>DICOM folder…</source>
        <translation>Dossier DICOM…</translation>
    </message>
    <message>
        <source>Volume file…</source>
        <translation>Fichier de volume…</translation>
    </message>
    <message>
        <source>Case…</source>
        <translation>Cas…</translation>
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
        <translation>Les foies d&apos;après lesquels les repères sont proposés</translation>
    </message>
    <message>
        <source>Built-in atlas</source>
        <translation>Atlas intégré</translation>
    </message>
    <message>
        <source>Own atlas…</source>
        <translation>Atlas personnel…</translation>
    </message>
    <message>
        <source>Build from cases…</source>
        <translation>Construire à partir de cas…</translation>
    </message>
    <message>
        <source>Folder of an atlas</source>
        <translation>Dossier d&apos;un atlas</translation>
    </message>
    <message>
        <source>Atlas in %1</source>
        <translation>Atlas dans %1</translation>
    </message>
    <message>
        <source>Built-in atlas &apos;%1&apos;, %2 livers</source>
        <translation>Atlas intégré « %1 », %2 foies</translation>
    </message>
    <message>
        <source>Own atlas &apos;%1&apos;, %2 livers</source>
        <translation>Atlas personnel « %1 », %2 foies</translation>
    </message>
    <message>
        <source>The chosen atlas cannot be used: choose it anew, another one, or the built-in atlas.</source>
        <translation>L&apos;atlas choisi est inutilisable : choisissez-le de nouveau, un autre, ou l&apos;atlas intégré.</translation>
    </message>
    <message>
        <source>The proposals below are from the atlas &apos;%1&apos;.</source>
        <translation>Les propositions ci-dessous viennent de l&apos;atlas « %1 ».</translation>
    </message>
</context>
<context>
    <name>glisson::ui::BuildAtlasDialog</name>
    <message>
        <source>%1: off by %2 mm on average where the others foretell it</source>
        <translation>%1 : à %2 mm en moyenne, prédit par les autres</translation>
    </message>
    <message>
        <source>Build an atlas</source>
        <translation>Construire un atlas</translation>
    </message>
    <message>
        <source>Of your own cases, five at least, with a model and reviewed landmarks. What a case only took over from an atlas is no evidence and stays out. It takes some seconds a liver.</source>
        <translation>De vos propres cas, cinq au moins, avec un modèle et des repères révisés. Ce qu&apos;un cas a seulement repris d&apos;un atlas n&apos;est pas une preuve et reste dehors. Cela prend quelques secondes par foie.</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>Construire</translation>
    </message>
    <message>
        <source>Cases</source>
        <translation>Cas</translation>
    </message>
    <message>
        <source>Add case or folder…</source>
        <translation>Ajouter un cas ou un dossier…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Cases whose labels nobody has approved, too</source>
        <translation>Aussi les cas dont personne n&apos;a approuvé les étiquettes</translation>
    </message>
    <message>
        <source>Keep the mean liver, and learn places alone</source>
        <translation>Garder le foie moyen et n&apos;apprendre que les lieux</translation>
    </message>
    <message>
        <source>Where structures lie on the mean liver of the chosen atlas: suits few cases</source>
        <translation>Où les structures se trouvent sur le foie moyen de l&apos;atlas choisi : convient à peu de cas</translation>
    </message>
    <message>
        <source>Keep nothing of single cases</source>
        <translation>Ne rien garder des cas isolés</translation>
    </message>
    <message>
        <source>Of structures means and mean squares alone, without the cases&apos; names</source>
        <translation>Des structures, les moyennes et carrés moyens seuls, sans les noms des cas</translation>
    </message>
    <message>
        <source>A case, or a folder of cases</source>
        <translation>Un cas, ou un dossier de cas</translation>
    </message>
    <message>
        <source>own</source>
        <translation>personnel</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>a new folder</source>
        <translation>un nouveau dossier</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>Kept in</source>
        <translation>Conservé dans</translation>
    </message>
    <message>
        <source>Folder for the atlas</source>
        <translation>Dossier de l&apos;atlas</translation>
    </message>
    <message>
        <source>Choose an atlas to build on first.</source>
        <translation>Choisissez d&apos;abord un atlas de départ.</translation>
    </message>
    <message>
        <source>Add your cases first.</source>
        <translation>Ajoutez d&apos;abord vos cas.</translation>
    </message>
    <message>
        <source>Give the atlas a name.</source>
        <translation>Donnez un nom à l&apos;atlas.</translation>
    </message>
    <message>
        <source>Name a folder to keep it in.</source>
        <translation>Indiquez un dossier où le conserver.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::RunningWork</name>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Closing now stops it: what it would have made is lost, and the case stays as it is.</source>
        <translation>Fermer maintenant l’interrompt : ce qui en serait sorti est perdu, et le cas reste tel qu’il est.</translation>
    </message>
    <message>
        <source>Wait, then close</source>
        <translation>Attendre, puis fermer</translation>
    </message>
    <message>
        <source>Stop it and close</source>
        <translation>Interrompre et fermer</translation>
    </message>
    <message>
        <source>Do not close</source>
        <translation>Ne pas fermer</translation>
    </message>
    <message>
        <source>then the window closes</source>
        <translation>puis la fenêtre se ferme</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Waiting saves the case with what it makes; a segmentation that would change what you corrected by hand waits for your decision then, and the labels are saved as they are. Stopping it saves the case as it is now.</source>
        <translation>Attendre enregistre le cas avec ce qui en sort ; une segmentation qui changerait ce que vous avez corrigé à la main attend alors votre décision, et les étiquettes sont enregistrées telles quelles. L’interrompre enregistre le cas tel qu’il est maintenant.</translation>
    </message>
    <message>
        <source>Wait, then save</source>
        <translation>Attendre, puis enregistrer</translation>
    </message>
    <message>
        <source>Stop it and save</source>
        <translation>Interrompre et enregistrer</translation>
    </message>
    <message>
        <source>Do not save</source>
        <translation>Ne pas enregistrer</translation>
    </message>
    <message>
        <source>then the case is saved</source>
        <translation>puis le cas est enregistré</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Stopping it loses what it would have made.</source>
        <translation>L’interrompre perd ce qui en serait sorti.</translation>
    </message>
    <message>
        <source>Wait, then open</source>
        <translation>Attendre, puis ouvrir</translation>
    </message>
    <message>
        <source>Stop it and open</source>
        <translation>Interrompre et ouvrir</translation>
    </message>
    <message>
        <source>Do not open</source>
        <translation>Ne pas ouvrir</translation>
    </message>
    <message>
        <source>then it is opened</source>
        <translation>puis l’ouverture se fait</translation>
    </message>
    <message>
        <source>Still at work: %1.</source>
        <translation>Encore au travail : %1.</translation>
    </message>
    <message>
        <source>The work has ended meanwhile.</source>
        <translation>Le travail s’est terminé entre-temps.</translation>
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
        <translation>Foie</translation>
    </message>
    <message>
        <source>Vessels</source>
        <translation>Vaisseaux</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Poumon</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Os</translation>
    </message>
    <message>
        <source>Own</source>
        <translation>Personnelle</translation>
    </message>
    <message>
        <source>Whole range</source>
        <translation>Toute l’étendue</translation>
    </message>
</context>
<context>
    <name>MomentTexts</name>
    <message>
        <source>at an unknown time</source>
        <translation>à un moment inconnu</translation>
    </message>
    <message>
        <source>frame %1, %2 s, kept %3</source>
        <translation>image %1, %2 s, conservée %3</translation>
    </message>
    <message>
        <source>valid</source>
        <translation>valide</translation>
    </message>
    <message>
        <source>outline only: %1</source>
        <translation>contour seul : %1</translation>
    </message>
    <message>
        <source>no overlay: %1</source>
        <translation>pas de superposition : %1</translation>
    </message>
    <message>
        <source>frame %1, %2</source>
        <translation>image %1, %2</translation>
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
        <translation>Conserver cet instant</translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation>Retour au direct</translation>
    </message>
    <message>
        <source>Back to live (Esc in the picture)</source>
        <translation>Retour au direct (Échap dans l&apos;image)</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Delete the chosen moment</source>
        <translation>Supprimer l&apos;instant choisi</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Take the last deletion or title back</source>
        <translation>Reprendre la dernière suppression ou le dernier titre</translation>
    </message>
    <message>
        <source>A click shows the moment as it was. The live video goes on meanwhile.</source>
        <translation>Un clic montre l&apos;instant tel qu&apos;il était. La vidéo en direct continue pendant ce temps.</translation>
    </message>
    <message>
        <source>Title of the chosen moment</source>
        <translation>Titre de l&apos;instant choisi</translation>
    </message>
    <message>
        <source>Keep both pictures, the overlay and its numbers in the case (K in the picture)</source>
        <translation>Conserver les deux images, la superposition et ses chiffres dans le cas (K dans l&apos;image)</translation>
    </message>
    <message>
        <source>Moment %1</source>
        <translation>Instant %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
</context>
<context>
    <name>glisson::ui::MomentsModel</name>
    <message>
        <source>A kept moment is on the screen. Go back to live (Esc), then keep another one.</source>
        <translation>Un instant conservé est à l&apos;écran. Revenez au direct (Échap), puis conservez-en un autre.</translation>
    </message>
    <message>
        <source>A former frame is on the screen, of which the raw pictures are not there any more. Go back to live (End).</source>
        <translation>Une image antérieure est à l&apos;écran, dont les images brutes ne sont plus là. Revenez au direct (Fin).</translation>
    </message>
    <message>
        <source>Nothing is followed: start tracking, then keep a moment.</source>
        <translation>Rien n&apos;est suivi : commencez le suivi, puis conservez un instant.</translation>
    </message>
    <message>
        <source>The overlay is being prepared: there is nothing to keep yet.</source>
        <translation>La superposition est en préparation : il n&apos;y a encore rien à conserver.</translation>
    </message>
    <message>
        <source>Frame %1 is being kept.</source>
        <translation>L&apos;image %1 est en cours de conservation.</translation>
    </message>
    <message>
        <source>Too many moments are being kept at once. Wait, then keep this one again.</source>
        <translation>Trop d&apos;instants sont conservés à la fois. Attendez, puis conservez de nouveau celui-ci.</translation>
    </message>
    <message>
        <source>Moment %1 is kept.</source>
        <translation>L&apos;instant %1 est conservé.</translation>
    </message>
    <message>
        <source>This case is open for reading: save it under another name, or the moment is lost with the window.</source>
        <translation>Ce cas est ouvert en lecture : enregistrez-le sous un autre nom, sinon l&apos;instant est perdu avec la fenêtre.</translation>
    </message>
    <message>
        <source>Moment %1 is deleted. Undo brings it back.</source>
        <translation>L&apos;instant %1 est supprimé. Annuler le fait revenir.</translation>
    </message>
</context>
<context>
    <name>glisson::ui::ViewBar</name>
    <message>
        <source>Which greys the slices show. Right drag in a slice changes them.</source>
        <translation>Les gris que montrent les coupes. Un glisser droit dans une coupe les change.</translation>
    </message>
    <message>
        <source>Hounsfield windows need a CT: an MRI&apos;s greys have no unit</source>
        <translation>Les fenêtres Hounsfield demandent un scanner : les gris d’une IRM sont sans unité</translation>
    </message>
    <message>
        <source>Window: %1</source>
        <translation>Fenêtre : %1</translation>
    </message>
    <message>
        <source>MIP</source>
        <translation>MIP</translation>
    </message>
    <message>
        <source>The brightest of a slab about the slice, for vessels. Labels, values and tools stay those of the slice.</source>
        <translation>Le plus clair d’un bloc autour de la coupe, pour les vaisseaux. Labels, valeurs et outils restent ceux de la coupe.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>How thick the slab is; also Shift + wheel in a slice</source>
        <translation>Épaisseur du bloc ; aussi Maj + molette dans une coupe</translation>
    </message>
    <message>
        <source>Measure a distance</source>
        <translation>Mesurer une distance</translation>
    </message>
    <message>
        <source>Drag from place to place in a slice. Esc ends.</source>
        <translation>Glissez d’un endroit à l’autre dans une coupe. Échap termine.</translation>
    </message>
    <message>
        <source>Measure two diameters</source>
        <translation>Mesurer deux diamètres</translation>
    </message>
    <message>
        <source>Drag along the longest diameter in a slice, then along another one that crosses it. Esc ends.</source>
        <translation>Glissez le long du plus grand diamètre dans une coupe, puis d’un autre qui le croise. Échap termine.</translation>
    </message>
    <message>
        <source>Take the last measure back</source>
        <translation>Reprendre la dernière mesure</translation>
    </message>
    <message>
        <source>Wipe all measures</source>
        <translation>Effacer toutes les mesures</translation>
    </message>
    <message>
        <source>Whole picture</source>
        <translation>Image entière</translation>
    </message>
    <message>
        <source>Takes zoom and shift of the slices away</source>
        <translation>Annule zoom et déplacement des coupes</translation>
    </message>
    <message>
        <source>One view alone</source>
        <translation>Une seule vue</translation>
    </message>
    <message>
        <source>The view under the pointer fills the place of all, as after a double click; Esc goes back</source>
        <translation>La vue sous le pointeur occupe toute la place, comme après un double-clic ; Échap revient</translation>
    </message>
</context>
<context>
    <name>HandWorkQuestion</name>
    <message>
        <source>Labels corrected by hand</source>
        <translation>Étiquettes corrigées à la main</translation>
    </message>
    <message>
        <source>You corrected by hand: %1.</source>
        <translation>Vous avez corrigé à la main : %1.</translation>
    </message>
    <message>
        <source>Replace them</source>
        <translation>Les remplacer</translation>
    </message>
    <message>
        <source>Keep mine</source>
        <translation>Garder les miennes</translation>
    </message>
</context>
<context>
    <name>glisson::ui::LabelImport</name>
    <message>
        <source>What is imported takes the place of all labels, with these corrections.</source>
        <translation>Ce qui est importé prend la place de toutes les étiquettes, avec ces corrections.</translation>
    </message>
</context>
</TS>
