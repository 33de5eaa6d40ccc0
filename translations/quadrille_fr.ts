<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr_FR" sourcelanguage="en">
<context>
    <name>LegendBar</name>
    <message>
        <source>%1 (%2)</source>
        <extracomment>title of a legend, then its unit</extracomment>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>Length</name>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>quadrille</name>
    <message>
        <source>Cancelled.</source>
        <translation>Annulé.</translation>
    </message>
    <message>
        <source>There is no such file or folder.</source>
        <translation>Ce fichier ou ce dossier n’existe pas.</translation>
    </message>
    <message>
        <source>You do not have permission to use this file.</source>
        <translation>Vous n’avez pas le droit d’utiliser ce fichier.</translation>
    </message>
    <message>
        <source>Change its permissions or choose another place.</source>
        <translation>Modifiez ses droits d’accès ou choisissez un autre emplacement.</translation>
    </message>
    <message>
        <source>Reading failed: {reason}.</source>
        <translation>Échec de la lecture&#xa0;: {reason}.</translation>
    </message>
    <message>
        <source>Check the disk and try again.</source>
        <translation>Vérifiez le disque et réessayez.</translation>
    </message>
    <message>
        <source>Writing failed: {reason}.</source>
        <translation>Échec de l’écriture&#xa0;: {reason}.</translation>
    </message>
    <message>
        <source>Check free space and permissions, then try again.</source>
        <translation>Vérifiez l’espace libre et les droits d’accès, puis réessayez.</translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation>Le fichier est vide.</translation>
    </message>
    <message>
        <source>Export it again.</source>
        <translation>Exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>The file ends too early: {expected} expected, {found} found.</source>
        <translation>Le fichier se termine trop tôt&#xa0;: {expected} attendus, {found} trouvés.</translation>
    </message>
    <message>
        <source>Export or copy it again.</source>
        <translation>Exportez-le ou copiez-le de nouveau.</translation>
    </message>
    <message>
        <source>The file is not text in UTF-8.</source>
        <translation>Le fichier n’est pas du texte en UTF-8.</translation>
    </message>
    <message>
        <source>Save it again as plain text in UTF-8.</source>
        <translation>Enregistrez-le de nouveau comme texte brut en UTF-8.</translation>
    </message>
    <message>
        <source>This is not what the format allows here: {reason}.</source>
        <translation>Le format ne permet pas cela à cet endroit&#xa0;: {reason}.</translation>
    </message>
    <message>
        <source>Export it again, or correct this place.</source>
        <translation>Exportez-le de nouveau, ou corrigez cet endroit.</translation>
    </message>
    <message>
        <source>The header promises {count} {what}, more than the file can hold.</source>
        <translation>L’en-tête annonce {count} {what}, plus que le fichier ne peut en contenir.</translation>
    </message>
    <message>
        <source>The file is damaged or of another format; export it again.</source>
        <translation>Le fichier est endommagé ou d’un autre format&#x202f;; exportez-le de nouveau.</translation>
    </message>
    <message>
        <source>The format of this file is not known.</source>
        <translation>Le format de ce fichier est inconnu.</translation>
    </message>
    <message>
        <source>Convert it to OBJ, PLY, PC2 or GLB.</source>
        <translation>Convertissez-le en OBJ, PLY, PC2 ou GLB.</translation>
    </message>
    <message>
        <source>{format} cannot be read here.</source>
        <translation>{format} : cela ne peut pas être lu ici.</translation>
    </message>
    <message>
        <source>{remedy}</source>
        <translation>{remedy}</translation>
    </message>
    <message>
        <source>This file holds positions only; a mesh with its faces is needed.</source>
        <translation>Ce fichier ne contient que des positions&#x202f;; il faut un maillage avec ses faces.</translation>
    </message>
    <message>
        <source>Give the mesh (OBJ or PLY) of the same vertex order with it.</source>
        <translation>Indiquez le maillage (OBJ ou PLY) qui a le même ordre de sommets.</translation>
    </message>
    <message>
        <source>{format} cannot hold {what}.</source>
        <translation>{format} ne peut pas contenir {what}.</translation>
    </message>
    <message>
        <source>Choose another format.</source>
        <translation>Choisissez un autre format.</translation>
    </message>
    <message>
        <source>No numbered mesh files were found here.</source>
        <translation>Aucun fichier de maillage numéroté n’a été trouvé ici.</translation>
    </message>
    <message>
        <source>Choose a folder or pattern that holds NAME_0001.obj, NAME_0002.obj, …</source>
        <translation>Choisissez un dossier ou un motif qui contient NOM_0001.obj, NOM_0002.obj, …</translation>
    </message>
    <message>
        <source>The mesh has no vertices.</source>
        <translation>Le maillage n’a aucun sommet.</translation>
    </message>
    <message>
        <source>Export it again with geometry.</source>
        <translation>Exportez-le de nouveau avec sa géométrie.</translation>
    </message>
    <message>
        <source>The mesh has no faces.</source>
        <translation>Le maillage n’a aucune face.</translation>
    </message>
    <message>
        <source>Export it with faces, or give a mesh beside it.</source>
        <translation>Exportez-le avec ses faces, ou indiquez un maillage en complément.</translation>
    </message>
    <message>
        <source>The scene holds no mesh.</source>
        <translation>La scène ne contient aucun maillage.</translation>
    </message>
    <message>
        <source>Export the character&apos;s geometry too: cameras, lights and bones alone cannot be shown.</source>
        <translation>Exportez aussi la géométrie du personnage&#xa0;: caméras, lumières et os seuls ne peuvent pas être montrés.</translation>
    </message>
    <message>
        <source>The {count} triangles share no vertices: this is a polygon soup.</source>
        <translation>Les {count} triangles ne partagent aucun sommet&#xa0;: c’est une soupe de polygones.</translation>
    </message>
    <message>
        <source>Merge vertices by distance in the tool it comes from, and export again.</source>
        <translation>Fusionnez les sommets par distance dans l’outil d’origine, puis exportez de nouveau.</translation>
    </message>
    <message>
        <source>A face names {what} {index}, but there are only {count}.</source>
        <translation>Une face désigne {what} {index}, mais il n’y en a que {count}.</translation>
    </message>
    <message>
        <source>Export it again, or correct this face.</source>
        <translation>Exportez-le de nouveau, ou corrigez cette face.</translation>
    </message>
    <message>
        <source>Vertex {vertex} has a coordinate that is not a finite number.</source>
        <translation>Le sommet {vertex} a une coordonnée qui n’est pas un nombre fini.</translation>
    </message>
    <message>
        <source>Leave this frame out by the range, or repair it.</source>
        <translation>Excluez cette image avec la plage, ou réparez-la.</translation>
    </message>
    <message>
        <source>{found} vertices where {expected} are expected.</source>
        <translation>{found} sommets au lieu des {expected} attendus.</translation>
    </message>
    <message>
        <source>All frames and the mesh of a sequence need the same vertices in the same order.</source>
        <translation>Toutes les images et le maillage d’une séquence doivent avoir les mêmes sommets dans le même ordre.</translation>
    </message>
    <message>
        <source>The topology differs from the first frame: {what}.</source>
        <translation>La topologie diffère de celle de la première image&#xa0;: {what}.</translation>
    </message>
    <message>
        <source>A sequence needs one topology; leave this frame out or track the capture first.</source>
        <translation>Une séquence exige une seule topologie&#x202f;; excluez cette image ou suivez d’abord la capture.</translation>
    </message>
    <message>
        <source>Frames {first} to {last} were asked for, but there are only {count}.</source>
        <translation>Les images {first} à {last} sont demandées, mais il n’y en a que {count}.</translation>
    </message>
    <message>
        <source>Choose a range inside 0 to the last frame.</source>
        <translation>Choisissez une plage entre 0 et la dernière image.</translation>
    </message>
    <message>
        <source>The mesh has no texture coordinates.</source>
        <translation>Le maillage n’a pas de coordonnées de texture.</translation>
    </message>
    <message>
        <source>Export it with UVs, or go on without a texture.</source>
        <translation>Exportez-le avec ses UV, ou continuez sans texture.</translation>
    </message>
    <message>
        <source>The picture cannot be read.</source>
        <translation>L’image ne peut pas être lue.</translation>
    </message>
    <message>
        <source>Save it as PNG, JPEG or TIFF.</source>
        <translation>Enregistrez-la en PNG, JPEG ou TIFF.</translation>
    </message>
    <message>
        <source>{found} textures for {expected} frames.</source>
        <translation>{found} textures pour {expected} images.</translation>
    </message>
    <message>
        <source>Give one texture, or one for each frame.</source>
        <translation>Indiquez une seule texture, ou une par image.</translation>
    </message>
    <message>
        <source>This is not valid JSON: {reason}.</source>
        <translation>Ce n’est pas du JSON valide&#xa0;: {reason}.</translation>
    </message>
    <message>
        <source>Correct this place.</source>
        <translation>Corrigez cet endroit.</translation>
    </message>
    <message>
        <source>{reason}.</source>
        <translation>{reason}.</translation>
    </message>
    <message>
        <source>The project has version {found}; this program knows versions up to {known}.</source>
        <translation>Le projet est de version {found}&#x202f;; ce programme connaît les versions jusqu’à {known}.</translation>
    </message>
    <message>
        <source>Open it with a newer Quadrille.</source>
        <translation>Ouvrez-le avec une version plus récente de Quadrille.</translation>
    </message>
    <message>
        <source>“{what}” uses a file that is not there: {path}.</source>
        <translation>«&#xa0;{what}&#xa0;» utilise un fichier absent&#xa0;: {path}.</translation>
    </message>
    <message>
        <source>The project has no target “{what}”.</source>
        <translation>Le projet n’a pas de cible «&#xa0;{what}&#xa0;».</translation>
    </message>
    <message>
        <source>It has: {known}.</source>
        <translation>Il contient&#xa0;: {known}.</translation>
    </message>
    <message>
        <source>The project has no data “{what}”.</source>
        <translation>Le projet n’a pas de données «&#xa0;{what}&#xa0;».</translation>
    </message>
    <message>
        <source>A stored result is damaged.</source>
        <translation>Un résultat enregistré est endommagé.</translation>
    </message>
    <message>
        <source>It will be computed again.</source>
        <translation>Il sera recalculé.</translation>
    </message>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>La mémoire ne suffit pas pour cela.</translation>
    </message>
    <message>
        <source>Choose a shorter range, or close other programs.</source>
        <translation>Choisissez une plage plus courte, ou fermez d’autres programmes.</translation>
    </message>
    <message>
        <source>Something unexpected happened: {reason}.</source>
        <translation>Un événement inattendu s’est produit&#xa0;: {reason}.</translation>
    </message>
    <message>
        <source>Save your work and try again; if it happens again, report it.</source>
        <translation>Enregistrez votre travail et réessayez&#x202f;; si cela se reproduit, signalez-le.</translation>
    </message>
    <message>
        <source>The numbering has gaps: {missing}.</source>
        <translation>La numérotation a des trous&#xa0;: {missing}.</translation>
    </message>
    <message>
        <source>The frames that exist are used, one after the other.</source>
        <translation>Les images présentes sont utilisées, l’une après l’autre.</translation>
    </message>
    <message>
        <source>{count} polygons with more than three corners were cut into triangles.</source>
        <translation>{count} polygones de plus de trois coins ont été découpés en triangles.</translation>
    </message>
    <message>
        <source>{count} edges have more than two triangles.</source>
        <translation>{count} arêtes ont plus de deux triangles.</translation>
    </message>
    <message>
        <source>{count} triangles have no area.</source>
        <translation>{count} triangles ont une aire nulle.</translation>
    </message>
    <message>
        <source>{count} vertices belong to no triangle.</source>
        <translation>{count} sommets n’appartiennent à aucun triangle.</translation>
    </message>
    <message>
        <source>{count} triangles name the same vertex twice and were left out.</source>
        <translation>{count} triangles désignent deux fois le même sommet et ont été écartés.</translation>
    </message>
    <message>
        <source>The texture {path} was not found.</source>
        <translation>La texture {path} est introuvable.</translation>
    </message>
    <message>
        <source>The mesh is shown without it.</source>
        <translation>Le maillage est affiché sans elle.</translation>
    </message>
    <message>
        <source>The source names no frame rate; {fps} fps is assumed.</source>
        <translation>La source n’indique aucune cadence&#x202f;; {fps} i/s est supposé.</translation>
    </message>
    <message>
        <source>Resampled from {from} to {to} fps.</source>
        <translation>Rééchantillonné de {from} à {to} i/s.</translation>
    </message>
    <message>
        <source>{from} vertices that the format had split were joined to {to}.</source>
        <translation>{from} sommets que le format avait dédoublés ont été réunis en {to}.</translation>
    </message>
    <message>
        <source>The file will take about {size}.</source>
        <translation>Le fichier occupera environ {size}.</translation>
    </message>
    <message>
        <source>It is not clear which files are meant: {found}.</source>
        <translation>On ne sait pas quels fichiers sont visés&#xa0;: {found}.</translation>
    </message>
    <message>
        <source>Name one file, or one series by a pattern such as NAME_####.obj.</source>
        <translation>Indiquez un seul fichier, ou une seule série par un motif tel que NOM_####.obj.</translation>
    </message>
    <message>
        <source>{found} textures in {path} for {expected} frames.</source>
        <translation>{found} textures dans {path} pour {expected} images.</translation>
    </message>
    <message>
        <source>They are not used.</source>
        <translation>Elles ne sont pas utilisées.</translation>
    </message>
    <message>
        <source>Faces and texture coordinates are those of {path}.</source>
        <translation>Les faces et les coordonnées de texture sont celles de {path}.</translation>
    </message>
    <message>
        <source>Check the path, or use “Find missing files” in the editor.</source>
        <translation>Vérifiez le chemin, ou utilisez « Trouver les fichiers manquants » dans l’éditeur.</translation>
    </message>
    <message>
        <source>Put it back, or use “Find missing files” in the editor.</source>
        <translation>Remettez-le en place, ou utilisez « Trouver les fichiers manquants » dans l’éditeur.</translation>
    </message>
    <message>
        <source>another program has the file open for writing</source>
        <translation>un autre programme a ouvert le fichier en écriture</translation>
    </message>
    <message>
        <source>A picture of floating-point numbers</source>
        <translation>Une image en nombres à virgule flottante</translation>
    </message>
    <message>
        <source>Save it with 8 or 16 bits a channel.</source>
        <translation>Enregistrez-la avec 8 ou 16 bits par canal.</translation>
    </message>
    <message>
        <source>Scale it down to 16,384 pixels a side or less.</source>
        <translation>Réduisez-la à 16 384 pixels de côté au plus.</translation>
    </message>
    <message>
        <source>the shape is not a list of numbers</source>
        <translation>la forme n’est pas une liste de nombres</translation>
    </message>
    <message>
        <source>it does not begin with \x93NUMPY</source>
        <translation>il ne commence pas par \x93NUMPY</translation>
    </message>
    <message>
        <source>The project has several characters</source>
        <translation>Le projet a plusieurs personnages</translation>
    </message>
    <message>
        <source>Name one of them.</source>
        <translation>Nommez-en un.</translation>
    </message>
    <message>
        <source>Give the character another name.</source>
        <translation>Donnez un autre nom au personnage.</translation>
    </message>
    <message>
        <source>Leave the mesh out, or name another character.</source>
        <translation>Omettez le maillage, ou nommez un autre personnage.</translation>
    </message>
    <message>
        <source>Name one texture for each material.</source>
        <translation>Nommez une texture pour chaque matériau.</translation>
    </message>
    <message>
        <source>Correct the name.</source>
        <translation>Corrigez le nom.</translation>
    </message>
    <message>
        <source>Data cannot be written in this format</source>
        <translation>Les données ne peuvent pas être écrites dans ce format</translation>
    </message>
    <message>
        <source>Choose .npy, .csv or .json.</source>
        <translation>Choisissez .npy, .csv ou .json.</translation>
    </message>
    <message>
        <source>the video file cannot be opened for encoding</source>
        <translation>le fichier vidéo ne peut pas être ouvert pour l’encodage</translation>
    </message>
    <message>
        <source>the video encoder refuses this size or frame rate</source>
        <translation>l’encodeur vidéo refuse cette taille ou cette cadence</translation>
    </message>
    <message>
        <source>the encoder has written nothing</source>
        <translation>l’encodeur n’a rien écrit</translation>
    </message>
    <message>
        <source>Choose at least one.</source>
        <translation>Choisissez-en au moins une.</translation>
    </message>
    <message>
        <source>The contact sheet would be too large</source>
        <translation>La planche-contact serait trop grande</translation>
    </message>
    <message>
        <source>Choose fewer sequences or smaller pictures.</source>
        <translation>Choisissez moins de séquences ou des images plus petites.</translation>
    </message>
    <message>
        <source>Limits of foot contacts must be positive, those for leaving not below those for landing</source>
        <translation>Les limites des contacts des pieds doivent être positives, celles du départ pas au-dessous de celles de l’arrivée</translation>
    </message>
    <message>
        <source>Correct the limits.</source>
        <translation>Corrigez les limites.</translation>
    </message>
    <message>
        <source>the header has counts below zero or no frame</source>
        <translation>l’en-tête a des nombres négatifs ou aucune image</translation>
    </message>
    <message>
        <source>a count expected</source>
        <translation>un nombre attendu</translation>
    </message>
    <message>
        <source>a joint has at most six channels</source>
        <translation>une articulation a au plus six canaux</translation>
    </message>
    <message>
        <source>the joints are nested too deep</source>
        <translation>les articulations sont imbriquées trop profondément</translation>
    </message>
    <message>
        <source>OFFSET, CHANNELS, JOINT, End Site or } expected</source>
        <translation>OFFSET, CHANNELS, JOINT, End Site ou } attendu</translation>
    </message>
    <message>
        <source>the frame time is not above zero</source>
        <translation>la durée d’une image n’est pas supérieure à zéro</translation>
    </message>
    <message>
        <source>there is no motion</source>
        <translation>il n’y a pas de mouvement</translation>
    </message>
    <message>
        <source>elements are nested too deeply</source>
        <translation>les éléments sont imbriqués trop profondément</translation>
    </message>
    <message>
        <source>a &lt;source&gt; has no &lt;accessor&gt;</source>
        <translation>une &lt;source&gt; n’a pas d’&lt;accessor&gt;</translation>
    </message>
    <message>
        <source>&lt;vertices&gt; has no positions</source>
        <translation>&lt;vertices&gt; n’a pas de positions</translation>
    </message>
    <message>
        <source>the offset of an &lt;input&gt; is too large</source>
        <translation>le décalage d’un &lt;input&gt; est trop grand</translation>
    </message>
    <message>
        <source>the count of &lt;vertex_weights&gt; is not that of its &lt;vcount&gt;</source>
        <translation>le nombre de &lt;vertex_weights&gt; n’est pas celui de son &lt;vcount&gt;</translation>
    </message>
    <message>
        <source>elements refer to each other in a circle</source>
        <translation>des éléments se renvoient l’un à l’autre en cercle</translation>
    </message>
    <message>
        <source>positions need three numbers</source>
        <translation>les positions demandent trois nombres</translation>
    </message>
    <message>
        <source>a list of polygons names no vertices</source>
        <translation>une liste de polygones ne nomme pas de sommets</translation>
    </message>
    <message>
        <source>a node has a child that is not there</source>
        <translation>un nœud a un enfant qui n’existe pas</translation>
    </message>
    <message>
        <source>a node has two parents</source>
        <translation>un nœud a deux parents</translation>
    </message>
    <message>
        <source>the nodes form a circle</source>
        <translation>les nœuds forment un cercle</translation>
    </message>
    <message>
        <source>the times of an animation do not increase</source>
        <translation>les instants d’une animation ne sont pas croissants</translation>
    </message>
    <message>
        <source>an animation has a value that is not a finite number</source>
        <translation>une animation a une valeur qui n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>an animation moves a node that is not there</source>
        <translation>une animation déplace un nœud qui n’existe pas</translation>
    </message>
    <message>
        <source>an animation channel has no sampler</source>
        <translation>un canal d’animation n’a pas d’échantillonneur</translation>
    </message>
    <message>
        <source>only glTF 2.0 is known</source>
        <translation>seul glTF 2.0 est connu</translation>
    </message>
    <message>
        <source>a chunk of the GLB file has the wrong type</source>
        <translation>un bloc du fichier GLB n’est pas du bon type</translation>
    </message>
    <message>
        <source>the JSON text breaks off or is wrong</source>
        <translation>le texte JSON est interrompu ou faux</translation>
    </message>
    <message>
        <source>it is not a glTF document</source>
        <translation>ce n’est pas un document glTF</translation>
    </message>
    <message>
        <source>Export it again without compression or extensions.</source>
        <translation>Exportez-le de nouveau sans compression ni extensions.</translation>
    </message>
    <message>
        <source>a data URI is not base64</source>
        <translation>une URI de données n’est pas en base64</translation>
    </message>
    <message>
        <source>an accessor has an unknown component type</source>
        <translation>un accesseur a un type de composante inconnu</translation>
    </message>
    <message>
        <source>a sparse accessor changes an element that is not there</source>
        <translation>un accesseur creux modifie un élément qui n’existe pas</translation>
    </message>
    <message>
        <source>an accessor of indices does not hold unsigned integers</source>
        <translation>un accesseur d’indices ne contient pas d’entiers non signés</translation>
    </message>
    <message>
        <source>there are more than 65,534 materials</source>
        <translation>il y a plus de 65 534 matériaux</translation>
    </message>
    <message>
        <source>a part of a mesh has no positions</source>
        <translation>une partie d’un maillage n’a pas de positions</translation>
    </message>
    <message>
        <source>a mesh has a material that is not there</source>
        <translation>un maillage a un matériau qui n’existe pas</translation>
    </message>
    <message>
        <source>a skin has fewer matrices than joints</source>
        <translation>une peau a moins de matrices que d’articulations</translation>
    </message>
    <message>
        <source>a skin has a joint that is not there</source>
        <translation>une peau a une articulation qui n’existe pas</translation>
    </message>
    <message>
        <source>there is no dataset of vertices × 3 × frames</source>
        <translation>il n’y a pas de jeu de données sommets × 3 × images</translation>
    </message>
    <message>
        <source>Clips are named after the datasets.</source>
        <translation>Les clips portent le nom des jeux de données.</translation>
    </message>
    <message>
        <source>No joint has rotation channels</source>
        <translation>Aucune articulation n’a de canaux de rotation</translation>
    </message>
    <message>
        <source>Choose a BVH with joint rotations.</source>
        <translation>Choisissez un BVH avec des rotations d’articulations.</translation>
    </message>
    <message>
        <source>Give a positive number of frames a second.</source>
        <translation>Donnez un nombre positif d’images par seconde.</translation>
    </message>
    <message>
        <source>Save it as numpy.ascontiguousarray(a, &apos;float32&apos;).</source>
        <translation>Enregistrez-le avec numpy.ascontiguousarray(a, &apos;float32&apos;).</translation>
    </message>
    <message>
        <source>Save it as frames × vertices × 3.</source>
        <translation>Enregistrez-le en images × sommets × 3.</translation>
    </message>
    <message>
        <source>a corner of a face is not VERTEX/UV/NORMAL</source>
        <translation>un coin d’une face n’est pas SOMMET/UV/NORMALE</translation>
    </message>
    <message>
        <source>a face needs three corners</source>
        <translation>une face demande trois coins</translation>
    </message>
    <message>
        <source>there are more than 65,536 materials</source>
        <translation>il y a plus de 65 536 matériaux</translation>
    </message>
    <message>
        <source>Save it as text OFF, PLY or OBJ.</source>
        <translation>Enregistrez-le en OFF texte, PLY ou OBJ.</translation>
    </message>
    <message>
        <source>the counts of vertices and faces are missing</source>
        <translation>les nombres de sommets et de faces manquent</translation>
    </message>
    <message>
        <source>the count of faces is missing</source>
        <translation>le nombre de faces manque</translation>
    </message>
    <message>
        <source>a count is negative</source>
        <translation>un nombre est négatif</translation>
    </message>
    <message>
        <source>a vertex needs three numbers</source>
        <translation>un sommet demande trois nombres</translation>
    </message>
    <message>
        <source>a vertex has too few numbers</source>
        <translation>un sommet a trop peu de nombres</translation>
    </message>
    <message>
        <source>a vertex has no texture coordinates</source>
        <translation>un sommet n’a pas de coordonnées de texture</translation>
    </message>
    <message>
        <source>a face does not begin with its count of corners</source>
        <translation>une face ne commence pas par son nombre de coins</translation>
    </message>
    <message>
        <source>a face has too few corners</source>
        <translation>une face a trop peu de coins</translation>
    </message>
    <message>
        <source>it does not begin with POINTCACHE2</source>
        <translation>il ne commence pas par POINTCACHE2</translation>
    </message>
    <message>
        <source>faces as triangle strips are not read</source>
        <translation>les faces en bandes de triangles ne sont pas lues</translation>
    </message>
    <message>
        <source>vertices have no x, y and z</source>
        <translation>les sommets n’ont pas x, y et z</translation>
    </message>
    <message>
        <source>faces have no vertex_indices</source>
        <translation>les faces n’ont pas de vertex_indices</translation>
    </message>
    <message>
        <source>it does not begin with “ply”</source>
        <translation>il ne commence pas par « ply »</translation>
    </message>
    <message>
        <source>the header has no end_header</source>
        <translation>l’en-tête n’a pas de end_header</translation>
    </message>
    <message>
        <source>the header names no format</source>
        <translation>l’en-tête ne nomme pas de format</translation>
    </message>
    <message>
        <source>the count of an element is not a number</source>
        <translation>le nombre d’un élément n’est pas un nombre</translation>
    </message>
    <message>
        <source>a property comes before any element</source>
        <translation>une propriété précède tout élément</translation>
    </message>
    <message>
        <source>the length of a list is not an integer</source>
        <translation>la longueur d’une liste n’est pas un entier</translation>
    </message>
    <message>
        <source>a property has no name</source>
        <translation>une propriété n’a pas de nom</translation>
    </message>
    <message>
        <source>Export it as OBJ plus PC2 or MDD, or as GLB.</source>
        <translation>Exportez-le en OBJ avec PC2 ou MDD, ou en GLB.</translation>
    </message>
    <message>
        <source>Open it in its program and export GLB, FBX, or OBJ plus PC2 or MDD.</source>
        <translation>Ouvrez-le dans son programme et exportez en GLB, en FBX, ou en OBJ avec PC2 ou MDD.</translation>
    </message>
    <message>
        <source>Pose a mesh with it and export that as GLB or FBX; a BVH may be named as the reference joint angles of a sequence.</source>
        <translation>Animez un maillage avec lui et exportez celui-ci en GLB ou FBX ; un BVH peut être nommé comme angles articulaires de référence d’une séquence.</translation>
    </message>
    <message>
        <source>Open it in Blender and export OBJ plus PC2 or MDD, or GLB.</source>
        <translation>Ouvrez-le dans Blender et exportez en OBJ avec PC2 ou MDD, ou en GLB.</translation>
    </message>
    <message>
        <source>Draco compressed meshes</source>
        <translation>Les maillages compressés par Draco</translation>
    </message>
    <message>
        <source>Decode them to OBJ or PLY with draco_decoder.</source>
        <translation>Décodez-les en OBJ ou PLY avec draco_decoder.</translation>
    </message>
    <message>
        <source>KTX2 texture streams</source>
        <translation>Les flux de textures KTX2</translation>
    </message>
    <message>
        <source>Decode them to PNG or JPEG with ktx extract.</source>
        <translation>Décodez-les en PNG ou JPEG avec ktx extract.</translation>
    </message>
    <message>
        <source>Blender files</source>
        <translation>Les fichiers Blender</translation>
    </message>
    <message>
        <source>Maya files</source>
        <translation>Les fichiers Maya</translation>
    </message>
    <message>
        <source>Cinema 4D files</source>
        <translation>Les fichiers Cinema 4D</translation>
    </message>
    <message>
        <source>Houdini files</source>
        <translation>Les fichiers Houdini</translation>
    </message>
    <message>
        <source>LightWave files</source>
        <translation>Les fichiers LightWave</translation>
    </message>
    <message>
        <source>ZBrush files</source>
        <translation>Les fichiers ZBrush</translation>
    </message>
    <message>
        <source>Export the mesh as OBJ.</source>
        <translation>Exportez le maillage en OBJ.</translation>
    </message>
    <message>
        <source>USD scenes</source>
        <translation>Les scènes USD</translation>
    </message>
    <message>
        <source>A skeleton without a mesh (BVH)</source>
        <translation>Un squelette sans maillage (BVH)</translation>
    </message>
    <message>
        <source>A skeleton without a mesh (Acclaim)</source>
        <translation>Un squelette sans maillage (Acclaim)</translation>
    </message>
    <message>
        <source>Marker data (C3D)</source>
        <translation>Des données de marqueurs (C3D)</translation>
    </message>
    <message>
        <source>Solve it to a mesh in the capture software and export GLB or FBX.</source>
        <translation>Résolvez-les en maillage dans le logiciel de capture et exportez en GLB ou FBX.</translation>
    </message>
    <message>
        <source>A point cloud</source>
        <translation>Un nuage de points</translation>
    </message>
    <message>
        <source>Mesh it and export OBJ or PLY with faces.</source>
        <translation>Maillez-le et exportez en OBJ ou PLY avec des faces.</translation>
    </message>
    <message>
        <source>A Maya point cache</source>
        <translation>Un cache de points Maya</translation>
    </message>
    <message>
        <source>Export it as PC2 or MDD.</source>
        <translation>Exportez-le en PC2 ou MDD.</translation>
    </message>
    <message>
        <source>A compressed archive</source>
        <translation>Une archive compressée</translation>
    </message>
    <message>
        <source>Unpack it and choose the folder.</source>
        <translation>Décompressez-la et choisissez le dossier.</translation>
    </message>
    <message>
        <source>a facet has more than three corners</source>
        <translation>une facette a plus de trois coins</translation>
    </message>
    <message>
        <source>a facet has fewer than three corners</source>
        <translation>une facette a moins de trois coins</translation>
    </message>
    <message>
        <source>the file ends within a facet</source>
        <translation>le fichier se termine au milieu d’une facette</translation>
    </message>
    <message>
        <source>“{sequence}” has another topology than “{first}”: {what}.</source>
        <translation>« {sequence} » a une autre topologie que « {first} » : {what}.</translation>
    </message>
    <message>
        <source>The sequences of a character share one topology; leave this one out.</source>
        <translation>Les séquences d’un personnage partagent une topologie ; excluez celle-ci.</translation>
    </message>
    <message>
        <source>Every triangle is without area in some frame.</source>
        <translation>Chaque triangle est sans aire dans une image.</translation>
    </message>
    <message>
        <source>Leave collapsed frames out by the range.</source>
        <translation>Excluez par la plage les images où le maillage s’effondre.</translation>
    </message>
    <message>
        <source>There is no transition from frame {source} to frame {destination}: it needs {needed} frames from the one on and up to the other; their sequences have {after} and {before}.</source>
        <translation>Il n’y a pas de transition de l’image {source} à l’image {destination} : il faut {needed} images à partir de l’une et jusqu’à l’autre ; leurs séquences en ont {after} et {before}.</translation>
    </message>
    <message>
        <source>Leave earlier, arrive later, or allow shorter windows.</source>
        <translation>Partez plus tôt, arrivez plus tard, ou permettez des fenêtres plus courtes.</translation>
    </message>
    <message>
        <source>The clip has {frames} frames; a loop needs at least {needed}.</source>
        <translation>Le clip a {frames} images ; une boucle en demande au moins {needed}.</translation>
    </message>
    <message>
        <source>Take a longer clip, or allow shorter transitions.</source>
        <translation>Prenez un clip plus long, ou permettez des transitions plus courtes.</translation>
    </message>
    <message>
        <source>A loop needs to cut at least {needed} frames from each end of the clip, to blend them; {given} are allowed.</source>
        <translation>Une boucle doit couper au moins {needed} images à chaque bout du clip pour les fondre ; {given} sont permises.</translation>
    </message>
    <message>
        <source>Allow more to be cut, or shorter transitions.</source>
        <translation>Permettez d’en couper davantage, ou des transitions plus courtes.</translation>
    </message>
    <message>
        <source>The curve of times goes back at its point {point}.</source>
        <translation>La courbe de temps recule à son point {point}.</translation>
    </message>
    <message>
        <source>Output times must rise, and clip times must not fall.</source>
        <translation>Les temps montrés doivent croître, et ceux du clip ne pas décroître.</translation>
    </message>
    <message>
        <source>No left–right symmetry of the mesh was found: {share} % of its vertices have a counterpart on the other side.</source>
        <translation>Aucune symétrie gauche-droite du maillage n’a été trouvée : {share} % de ses sommets ont un vis-à-vis de l’autre côté.</translation>
    </message>
    <message>
        <source>Give a symmetry map, or an upright pose to find it in.</source>
        <translation>Donnez une carte de symétrie, ou une pose debout où la trouver.</translation>
    </message>
    <message>
        <source>The symmetry map does not fit the mesh: {reason}.</source>
        <translation>La carte de symétrie ne convient pas au maillage : {reason}.</translation>
    </message>
    <message>
        <source>Give for each vertex the index of its counterpart, or its own.</source>
        <translation>Donnez pour chaque sommet l’indice de son vis-à-vis, ou le sien.</translation>
    </message>
    <message>
        <source>No feet were found to stand on.</source>
        <translation>Aucun pied d’appui n’a été trouvé.</translation>
    </message>
    <message>
        <source>Contacts can be corrected where legs hang apart from the body; leave this step out.</source>
        <translation>Les contacts se corrigent là où des jambes se détachent du corps ; omettez cette étape.</translation>
    </message>
    <message>
        <source>Key {key} is wanted at {time}, not after key {other}, which is wanted at {otherTime}.</source>
        <translation>La clé {key} est voulue à {time}, pas après la clé {other}, voulue à {otherTime}.</translation>
    </message>
    <message>
        <source>Give keys in the order of their times, no two at one time.</source>
        <translation>Donnez les clés dans l’ordre de leurs instants, jamais deux au même.</translation>
    </message>
    <message>
        <source>Key {key} cannot be reached: no walk leads to frame {frame}.</source>
        <translation>La clé {key} est hors d’atteinte : aucun parcours ne mène à l’image {frame}.</translation>
    </message>
    <message>
        <source>The nearest frame that can be reached is {nearest}; take it, or change what comes before.</source>
        <translation>L’image la plus proche qu’on peut atteindre est {nearest} ; prenez-la, ou changez ce qui précède.</translation>
    </message>
    <message>
        <source>Key {key} cannot be met within {tolerance} frames of {time}.</source>
        <translation>La clé {key} ne peut être tenue à {tolerance} images près de {time}.</translation>
    </message>
    <message>
        <source>The nearest time at which it can is {nearest}; allow a greater error, or change times.</source>
        <translation>L’instant le plus proche possible est {nearest} ; permettez un écart plus grand, ou changez les instants.</translation>
    </message>
    <message>
        <source>No frame of this character is “{name}”.</source>
        <translation>Aucune image de ce personnage n’est « {name} ».</translation>
    </message>
    <message>
        <source>Label some, or ask for something else.</source>
        <translation>Étiquetez-en, ou demandez autre chose.</translation>
    </message>
    <message>
        <source>“{name}” cannot be performed: {share} % of a span are asked for, and no walk plays more than {most} %.</source>
        <translation>« {name} » ne peut être exécuté : {share} % d’un passage sont demandés, et aucun parcours n’en joue plus de {most} %.</translation>
    </message>
    <message>
        <source>Ask for at most {most} %, or allow shorter transitions.</source>
        <translation>Demandez {most} % au plus, ou permettez des transitions plus courtes.</translation>
    </message>
    <message>
        <source>The path is {length} m long, too short for a walk.</source>
        <translation>Le trajet mesure {length} m, trop peu pour un parcours.</translation>
    </message>
    <message>
        <source>Draw at least {needed} m.</source>
        <translation>Tracez au moins {needed} m.</translation>
    </message>
    <message>
        <source>A span of the path goes from {from} m to {to} m, but the path has {length} m.</source>
        <translation>Un tronçon du trajet va de {from} m à {to} m, mais le trajet en mesure {length}.</translation>
    </message>
    <message>
        <source>Move the span, or draw a longer path.</source>
        <translation>Déplacez le tronçon, ou tracez un trajet plus long.</translation>
    </message>
    <message>
        <source>The path begins in “{name}”, or too close to it.</source>
        <translation>Le trajet commence dans « {name} », ou trop près.</translation>
    </message>
    <message>
        <source>Move one of them; the path is free from {free} m on.</source>
        <translation>Déplacez l’un des deux ; le trajet est libre à partir de {free} m.</translation>
    </message>
    <message>
        <source>No walk was found that gets past “{name}” at {reached} m of the path.</source>
        <translation>Aucun parcours trouvé ne passe « {name} » à {reached} m du trajet.</translation>
    </message>
    <message>
        <source>Lead the path around it, leave more room, or search with a greater budget.</source>
        <translation>Contournez-le, laissez plus de place, ou cherchez avec un budget plus grand.</translation>
    </message>
    <message>
        <source>No walk was found that shows “{name}” from {from} m to {to} m of the path; the best one fails at {reached} m.</source>
        <translation>Aucun parcours trouvé ne montre « {name} » de {from} m à {to} m du trajet ; le meilleur échoue à {reached} m.</translation>
    </message>
    <message>
        <source>End the span at {reached} m, or search with a greater budget.</source>
        <translation>Terminez le tronçon à {reached} m, ou cherchez avec un budget plus grand.</translation>
    </message>
    <message>
        <source>No walk was found with {budget} expansions.</source>
        <translation>Aucun parcours n’a été trouvé en {budget} développements.</translation>
    </message>
    <message>
        <source>Search with a greater budget, or ask for less.</source>
        <translation>Cherchez avec un budget plus grand, ou demandez moins.</translation>
    </message>
    <message>
        <source>The sequences&apos; joint angles have no joint in common</source>
        <translation>Les angles d’articulation des séquences n’ont aucune articulation en commun</translation>
    </message>
    <message>
        <source>Choose BVH files of one skeleton.</source>
        <translation>Choisissez des fichiers BVH d’un même squelette.</translation>
    </message>
    <message>
        <source>Rebuild the project.</source>
        <translation>Recalculez le projet.</translation>
    </message>
    <message>
        <source>Limits and times of contact corrections must not be negative, and the strength must be 0 to 1</source>
        <translation>Les limites et durées des corrections de contact ne doivent pas être négatives, et la force doit aller de 0 à 1</translation>
    </message>
    <message>
        <source>Correct the settings.</source>
        <translation>Corrigez les réglages.</translation>
    </message>
    <message>
        <source>A loop can only cut a time that is not negative</source>
        <translation>Une boucle ne peut couper qu’une durée qui n’est pas négative</translation>
    </message>
    <message>
        <source>Give a number of seconds, 0 or more.</source>
        <translation>Donnez un nombre de secondes, 0 ou plus.</translation>
    </message>
    <message>
        <source>A loop can be repeated 1 to 10,000 times</source>
        <translation>Une boucle se répète de 1 à 10 000 fois</translation>
    </message>
    <message>
        <source>Give a number of repeats in between.</source>
        <translation>Donnez un nombre entre les deux.</translation>
    </message>
    <message>
        <source>Only a loop can be repeated</source>
        <translation>Seule une boucle peut être répétée</translation>
    </message>
    <message>
        <source>Ask for a loop, too, or for one repeat.</source>
        <translation>Demandez aussi une boucle, ou une seule fois.</translation>
    </message>
    <message>
        <source>A clip can be retimed to a million frames at most</source>
        <translation>Un clip peut durer un million d’images au plus</translation>
    </message>
    <message>
        <source>Ask for a shorter result.</source>
        <translation>Demandez un résultat plus court.</translation>
    </message>
    <message>
        <source>The factor of a retiming is not above 0</source>
        <translation>Le facteur de durée n’est pas supérieur à 0</translation>
    </message>
    <message>
        <source>Give how many times as long the result lasts: 2 for half the speed.</source>
        <translation>Dites combien de fois plus long est le résultat : 2 pour la moitié de la vitesse.</translation>
    </message>
    <message>
        <source>The duration of a retiming is not above 0</source>
        <translation>La durée voulue n’est pas supérieure à 0</translation>
    </message>
    <message>
        <source>Give the seconds that the result lasts.</source>
        <translation>Donnez les secondes que dure le résultat.</translation>
    </message>
    <message>
        <source>A curve of times has fewer than two points</source>
        <translation>Une courbe de temps a moins de deux points</translation>
    </message>
    <message>
        <source>Give at least where the result begins and where it ends.</source>
        <translation>Donnez au moins où le résultat commence et où il finit.</translation>
    </message>
    <message>
        <source>A curve of times leaves the clip</source>
        <translation>Une courbe de temps sort du clip</translation>
    </message>
    <message>
        <source>Give clip times from 0 to the duration of the clip.</source>
        <translation>Donnez des temps du clip entre 0 et sa durée.</translation>
    </message>
    <message>
        <source>A curve of times does not go all round a loop</source>
        <translation>Une courbe de temps ne fait pas tout le tour d’une boucle</translation>
    </message>
    <message>
        <source>Begin at clip time 0 and end at the duration of the loop.</source>
        <translation>Commencez au temps 0 du clip et finissez à la durée de la boucle.</translation>
    </message>
</context>
<context>
    <name>quadrille::AboutDialog</name>
    <message>
        <source>About Quadrille</source>
        <translation>À propos de Quadrille</translation>
    </message>
    <message>
        <source>An editor for 4D performance capture: makes new performances from captured ones.</source>
        <translation>Un éditeur pour la capture de performances en 4D : il tire de nouvelles performances de celles qui ont été captées.</translation>
    </message>
    <message>
        <source>Free software under the MIT licence.</source>
        <translation>Logiciel libre sous licence MIT.</translation>
    </message>
    <message>
        <source>Built on %1.</source>
        <translation>Construit sur %1.</translation>
    </message>
    <message>
        <source>Copy versions</source>
        <translation>Copier les versions</translation>
    </message>
</context>
<context>
    <name>quadrille::Autosave</name>
    <message>
        <source>Untitled</source>
        <translation>Sans titre</translation>
    </message>
    <message>
        <source>Keeping a copy of “%1”</source>
        <translation>Copie de sauvegarde de «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>quadrille::AxesFields</name>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Axe vertical</translation>
    </message>
    <message>
        <source>The axis that points up</source>
        <translation>L’axe qui pointe vers le haut</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>The length of one unit</source>
        <translation>La longueur d’une unité</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Axes</translation>
    </message>
    <message>
        <source>As the project</source>
        <translation>Comme le projet</translation>
    </message>
    <message>
        <source>Others</source>
        <translation>Autres</translation>
    </message>
</context>
<context>
    <name>quadrille::CardsPanel</name>
    <message>
        <source>Name or label</source>
        <translation>Nom ou étiquette</translation>
    </message>
    <message>
        <source>Find sequences by name or label</source>
        <translation>Trouver des séquences par leur nom ou une étiquette</translation>
    </message>
    <message>
        <source>Sequences</source>
        <translation>Séquences</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliquer</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Try Again</source>
        <translation>Réessayer</translation>
    </message>
</context>
<context>
    <name>quadrille::CharacterPage</name>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Unique in the project</source>
        <translation>Unique dans le projet</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Maillage</translation>
    </message>
    <message>
        <source>Textures</source>
        <translation>Textures</translation>
    </message>
    <message>
        <source>What its sequences wear, unless they have their own</source>
        <translation>Ce que portent ses séquences, sauf si elles ont les leurs</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>Used by</source>
        <translation>Utilisé par</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>Whatever is worth remembering about the capture</source>
        <translation>Tout ce qui mérite d’être retenu de la captation</translation>
    </message>
    <message>
        <source>that of its first sequence</source>
        <translation>celui de sa première séquence</translation>
    </message>
    <message>
        <source>as found</source>
        <translation>comme trouvées</translation>
    </message>
    <message numerus="yes">
        <source>%n sequences</source>
        <translation>
            <numerusform>%n séquence</numerusform>
            <numerusform>%n séquences</numerusform>
        </translation>
    </message>
    <message>
        <source>not opened</source>
        <translation>pas ouvert</translation>
    </message>
    <message numerus="yes">
        <source>%n vertices</source>
        <translation>
            <numerusform>%n sommet</numerusform>
            <numerusform>%n sommets</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n triangles</source>
        <translation>
            <numerusform>%n triangle</numerusform>
            <numerusform>%n triangles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n components</source>
        <translation>
            <numerusform>%n composante</numerusform>
            <numerusform>%n composantes</numerusform>
        </translation>
    </message>
    <message>
        <source>closed</source>
        <translation>fermée</translation>
    </message>
    <message numerus="yes">
        <source>%n boundary loops</source>
        <translation>
            <numerusform>%n contour</numerusform>
            <numerusform>%n contours</numerusform>
        </translation>
    </message>
    <message>
        <source>with texture coordinates</source>
        <translation>avec coordonnées de texture</translation>
    </message>
    <message>
        <source>without texture coordinates</source>
        <translation>sans coordonnées de texture</translation>
    </message>
    <message numerus="yes">
        <source>%n non-manifold edges</source>
        <translation>
            <numerusform>%n arête non variété</numerusform>
            <numerusform>%n arêtes non variétés</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::ContactProposal</name>
    <message>
        <source>Edit</source>
        <translation>Édition</translation>
    </message>
    <message>
        <source>&amp;Propose foot contacts</source>
        <translation>&amp;Proposer les contacts des pieds</translation>
    </message>
    <message>
        <source>Finds the frames in which the feet stand on the ground</source>
        <translation>Trouve les images où les pieds sont posés au sol</translation>
    </message>
    <message>
        <source>&amp;Clear foot contacts</source>
        <translation>Effacer les c&amp;ontacts des pieds</translation>
    </message>
    <message>
        <source>Finding foot contacts of “%1”</source>
        <translation>Recherche des contacts des pieds de «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>quadrille::ErrorText</name>
    <message>
        <source>line %1, column %2</source>
        <translation>ligne %1, colonne %2</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>ligne %1</translation>
    </message>
    <message>
        <source>byte %1</source>
        <translation>octet %1</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>image %1</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between the parts of a place</comment>
        <translation>, </translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>sentence and remedy</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>sentences and place</comment>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>quadrille::ExportDialog</name>
    <message numerus="yes">
        <source>%1, and %n more</source>
        <translation>
            <numerusform>%1, et %n autre</numerusform>
            <numerusform>%1, et %n autres</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 · %n frame(s), %2 s</source>
        <comment>files · frames, seconds</comment>
        <translation>
            <numerusform>%1 · %n image, %2 s</numerusform>
            <numerusform>%1 · %n images, %2 s</numerusform>
        </translation>
    </message>
    <message>
        <source>Export to</source>
        <translation>Exporter vers</translation>
    </message>
    <message>
        <source>“%1” is there already.</source>
        <translation>«&#xa0;%1&#xa0;» existe déjà.</translation>
    </message>
    <message numerus="yes">
        <source>“%1” and %n more are there already.</source>
        <translation>
            <numerusform>«&#xa0;%1&#xa0;» et %n autre existent déjà.</numerusform>
            <numerusform>«&#xa0;%1&#xa0;» et %n autres existent déjà.</numerusform>
        </translation>
    </message>
    <message>
        <source>Write over files?</source>
        <translation>Remplacer les fichiers&#x202f;?</translation>
    </message>
    <message>
        <source>Exporting writes over them.</source>
        <translation>L’export les remplacera.</translation>
    </message>
    <message>
        <source>Write over</source>
        <translation>Remplacer</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>Export de %1</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Exporting…</source>
        <translation>Export en cours…</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Export “%1”</source>
        <translation>Exporter «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Cadence</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Axes</translation>
    </message>
    <message>
        <source>Textures</source>
        <translation>Textures</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Dernière image</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>Choisir le fichier</translation>
    </message>
    <message>
        <source> fps</source>
        <translation> i/s</translation>
    </message>
    <message>
        <source>Another rate than the project&apos;s is resampled</source>
        <translation>Une cadence autre que celle du projet entraîne un rééchantillonnage</translation>
    </message>
    <message>
        <source>Write the pictures beside</source>
        <translation>Écrire aussi les fichiers de texture</translation>
    </message>
    <message>
        <source>Keep in the project, so that a rebuild repeats it</source>
        <translation>Garder dans le projet, pour qu’une reconstruction le refasse</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>quadrille::ExportFlow</name>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>Ex&amp;porter…</translation>
    </message>
    <message>
        <source>Write the selected sequences in another format, or as pictures or video</source>
        <translation>Écrire les séquences sélectionnées dans un autre format, ou sous forme d’images ou de vidéo</translation>
    </message>
</context>
<context>
    <name>quadrille::ExportPage</name>
    <message>
        <source>Of</source>
        <translation>De</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>Écrit</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation>%1 i/s</translation>
    </message>
    <message>
        <source>%1 to %2, %3</source>
        <translation>%1 à %2, %3</translation>
    </message>
    <message>
        <source>all, %1</source>
        <translation>toutes, %1</translation>
    </message>
    <message>
        <source>not as one file</source>
        <translation>pas en un seul fichier</translation>
    </message>
    <message>
        <source>Change or write again…</source>
        <translation>Modifier ou réécrire…</translation>
    </message>
</context>
<context>
    <name>quadrille::HelpViewer</name>
    <message>
        <source>Quadrille help</source>
        <translation>Aide de Quadrille</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Sommaire</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>Help page</source>
        <translation>Page d’aide</translation>
    </message>
</context>
<context>
    <name>quadrille::ImportDialog</name>
    <message>
        <source>Looking at what is there…</source>
        <translation>Examen du contenu…</translation>
    </message>
    <message numerus="yes">
        <source>Looking at %n source(s)</source>
        <translation>
            <numerusform>Examen de %n source</numerusform>
            <numerusform>Examen de %n sources</numerusform>
        </translation>
    </message>
    <message>
        <source>The file names its axes and unit itself</source>
        <translation>Le fichier indique lui-même ses axes et son unité</translation>
    </message>
    <message>
        <source>The file names its rate itself</source>
        <translation>Le fichier indique lui-même sa cadence</translation>
    </message>
    <message>
        <source>Frames a second of the takes whose files name no rate</source>
        <translation>Images par seconde des prises dont les fichiers n’indiquent aucune cadence</translation>
    </message>
    <message>
        <source>%1 m high</source>
        <translation>%1 m de haut</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importer</translation>
    </message>
    <message numerus="yes">
        <source>Import %n take(s)</source>
        <translation>
            <numerusform>Importer %n prise</numerusform>
            <numerusform>Importer %n prises</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Choose the mesh…</source>
        <translation>Choisir le maillage…</translation>
    </message>
    <message>
        <source>The figure would be %1 m high.</source>
        <translation>Le personnage mesurerait %1 m de haut.</translation>
    </message>
    <message>
        <source>Choose the unit and the up axis of the file.</source>
        <translation>Choisissez l’unité et l’axe vertical du fichier.</translation>
    </message>
    <message>
        <source>Reference joint angles: %1</source>
        <translation>Angles articulaires de référence&#xa0;: %1</translation>
    </message>
    <message>
        <source>Mesh with the faces</source>
        <translation>Maillage avec les faces</translation>
    </message>
    <message>
        <source>Meshes (*.obj *.ply *.off *.stl)</source>
        <translation>Maillages (*.obj *.ply *.off *.stl)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>in the files</source>
        <translation>dans les fichiers</translation>
    </message>
    <message>
        <source>Choose the mesh that gives faces and texture coordinates</source>
        <translation>Choisir le maillage qui donne les faces et les coordonnées de texture</translation>
    </message>
    <message>
        <source> fps</source>
        <translation> i/s</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>Character</source>
        <translation>Personnage</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Maillage</translation>
    </message>
    <message>
        <source>Up, unit</source>
        <translation>Axe vertical, unité</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Cadence</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Textures</source>
        <translation>Textures</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Dernière image</translation>
    </message>
    <message>
        <source>as found</source>
        <translation>comme trouvé</translation>
    </message>
</context>
<context>
    <name>quadrille::ImportFlow</name>
    <message>
        <source>Mesh sequences (%1);;All files (*)</source>
        <translation>Séquences de maillages (%1);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>&amp;Import sequences…</source>
        <translation>&amp;Importer des séquences…</translation>
    </message>
    <message>
        <source>Look at mesh sequences and add them to the project</source>
        <translation>Examiner des séquences de maillages et les ajouter au projet</translation>
    </message>
    <message>
        <source>Import a &amp;folder…</source>
        <translation>Importer un &amp;dossier…</translation>
    </message>
    <message>
        <source>Look at all takes of a folder and add them to the project</source>
        <translation>Examiner toutes les prises d’un dossier et les ajouter au projet</translation>
    </message>
    <message>
        <source>Import sequences</source>
        <translation>Importer des séquences</translation>
    </message>
    <message>
        <source>Import a folder</source>
        <translation>Importer un dossier</translation>
    </message>
    <message>
        <source>Looking for sequences</source>
        <translation>Recherche de séquences</translation>
    </message>
    <message numerus="yes">
        <source>Opening %n file(s)</source>
        <translation>
            <numerusform>Ouverture de %n fichier</numerusform>
            <numerusform>Ouverture de %n fichiers</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::IssueLog</name>
    <message>
        <source>Message</source>
        <translation>Message</translation>
    </message>
    <message>
        <source>Concerns</source>
        <translation>Concerne</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Emplacement</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Fois</translation>
    </message>
</context>
<context>
    <name>quadrille::IssuesPanel</name>
    <message>
        <source>Issues</source>
        <translation>Problèmes</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Afficher</translation>
    </message>
    <message>
        <source>Go to what the issue is about</source>
        <translation>Aller à ce que concerne le problème</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Effacer</translation>
    </message>
    <message>
        <source>Forget all issues</source>
        <translation>Oublier tous les problèmes</translation>
    </message>
    <message>
        <source>No issues. What goes wrong, and what an import had to repair, is listed here.</source>
        <translation>Aucun problème. Ce qui échoue, et ce qu’un import a dû réparer, s’affiche ici.</translation>
    </message>
    <message numerus="yes">
        <source>%n error(s)</source>
        <translation>
            <numerusform>%n erreur</numerusform>
            <numerusform>%n erreurs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s)</source>
        <translation>
            <numerusform>%n avertissement</numerusform>
            <numerusform>%n avertissements</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <comment>numbers of errors and of warnings</comment>
        <translation>%1 · %2</translation>
    </message>
</context>
<context>
    <name>quadrille::JobListModel</name>
    <message>
        <source>less than a second left</source>
        <translation>moins d’une seconde restante</translation>
    </message>
    <message numerus="yes">
        <source>%n s left</source>
        <translation>
            <numerusform>%n s restante</numerusform>
            <numerusform>%n s restantes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n min left</source>
        <translation>
            <numerusform>%n min restante</numerusform>
            <numerusform>%n min restantes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n h left</source>
        <translation>
            <numerusform>%n h restante</numerusform>
            <numerusform>%n h restantes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::JobsPopup</name>
    <message>
        <source>Running jobs</source>
        <translation>Tâches en cours</translation>
    </message>
    <message>
        <source>stopping…</source>
        <translation>arrêt…</translation>
    </message>
    <message>
        <source>Cancel “%1”</source>
        <translation>Annuler « %1 »</translation>
    </message>
</context>
<context>
    <name>quadrille::LostMediaTable</name>
    <message>
        <source>%1, mesh</source>
        <translation>%1, maillage</translation>
    </message>
    <message>
        <source>%1, texture</source>
        <translation>%1, texture</translation>
    </message>
    <message>
        <source>%1, joint angles</source>
        <translation>%1, angles des articulations</translation>
    </message>
    <message>
        <source>%1, frames</source>
        <translation>%1, images</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Used by</source>
        <translation>Utilisé par</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Was in</source>
        <translation>Était dans</translation>
    </message>
    <message>
        <source>Is in</source>
        <translation>Est dans</translation>
    </message>
    <message>
        <source>Files that are missing</source>
        <translation>Fichiers manquants</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>manquant</translation>
    </message>
    <message>
        <source>chosen, but different content</source>
        <translation>choisi, mais de contenu différent</translation>
    </message>
    <message>
        <source>found, but different content</source>
        <translation>trouvé, mais de contenu différent</translation>
    </message>
    <message>
        <source>chosen by hand</source>
        <translation>choisi à la main</translation>
    </message>
    <message>
        <source>found by name</source>
        <translation>trouvé par son nom</translation>
    </message>
    <message>
        <source>found by content</source>
        <translation>trouvé par son contenu</translation>
    </message>
    <message>
        <source>found by name and content</source>
        <translation>trouvé par son nom et son contenu</translation>
    </message>
    <message>
        <source>Not found yet. Search a folder, or choose it by hand.</source>
        <translation>Pas encore trouvé. Cherchez dans un dossier, ou choisissez-le à la main.</translation>
    </message>
    <message>
        <source>The content is not the one that the project used. Tick it only if you want to use it all the same.</source>
        <translation>Le contenu n’est pas celui que le projet utilisait. Ne le cochez que si vous voulez l’utiliser quand même.</translation>
    </message>
    <message>
        <source>Several have this name; the one whose folders are most alike was taken. Choose another by hand if it is the wrong one.</source>
        <translation>Plusieurs portent ce nom ; celui dont les dossiers se ressemblent le plus a été pris. Choisissez-en un autre à la main si ce n’est pas le bon.</translation>
    </message>
    <message>
        <source>The content was never noted, so it cannot be compared.</source>
        <translation>Le contenu n’a jamais été noté, il ne peut donc pas être comparé.</translation>
    </message>
    <message>
        <source>The name is another, but the content is the one that the project used.</source>
        <translation>Le nom est différent, mais le contenu est celui que le projet utilisait.</translation>
    </message>
    <message>
        <source>Name and content are those that the project used.</source>
        <translation>Le nom et le contenu sont ceux que le projet utilisait.</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 et %n autre</numerusform>
            <numerusform>%1 et %n autres</numerusform>
        </translation>
    </message>
    <message>
        <source>; </source>
        <comment>between users of a file</comment>
        <translation> ; </translation>
    </message>
</context>
<context>
    <name>quadrille::MainWindow</name>
    <message>
        <source>Project</source>
        <translation>Projet</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
    <message>
        <source>Issues</source>
        <translation>Problèmes</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>Exporté vers %1</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nouveau</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <source>Open the &amp;sample</source>
        <translation>Ouvrir l’e&amp;xemple</translation>
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
        <source>Edit</source>
        <translation>Édition</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Manuel</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Affichage</translation>
    </message>
    <message>
        <source>Theme of the s&amp;ystem</source>
        <translation>Thème du s&amp;ystème</translation>
    </message>
    <message>
        <source>&amp;Light theme</source>
        <translation>Thème c&amp;lair</translation>
    </message>
    <message>
        <source>&amp;Dark theme</source>
        <translation>Thème som&amp;bre</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Propriétés</translation>
    </message>
    <message>
        <source>Cards</source>
        <translation>Cartes</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Projets &amp;récents</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Préférences…</translation>
    </message>
    <message>
        <source>Theme, language, copies, shortcuts</source>
        <translation>Thème, langue, copies, raccourcis</translation>
    </message>
    <message>
        <source>&amp;Find an action…</source>
        <translation>&amp;Trouver une action…</translation>
    </message>
    <message>
        <source>Find any action by its name and run it</source>
        <translation>Trouver une action par son nom et l’exécuter</translation>
    </message>
    <message>
        <source>&amp;About Quadrille</source>
        <translation>À &amp;propos de Quadrille</translation>
    </message>
    <message>
        <source>Saved to %1</source>
        <translation>Enregistré dans %1</translation>
    </message>
    <message>
        <source>&amp;Running jobs</source>
        <translation>Tâches en &amp;cours</translation>
    </message>
    <message>
        <source>Lists what is being worked on, each with a button that cancels it</source>
        <translation>Liste les travaux en cours, chacun avec un bouton qui l’annule</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Texture</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) were relinked</source>
        <translation>
            <numerusform>%n fichier a été relié</numerusform>
            <numerusform>%n fichiers ont été reliés</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::Menus</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>&amp;Playback</source>
        <translation>&amp;Lecture</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;ide</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>Lan&amp;gue</translation>
    </message>
</context>
<context>
    <name>quadrille::PictureFields</name>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Arrière-plan</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Rendu</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Tours</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Transparent</translation>
    </message>
    <message>
        <source>Textured</source>
        <translation>Texturé</translation>
    </message>
    <message>
        <source>Texture without light</source>
        <translation>Texture sans éclairage</translation>
    </message>
    <message>
        <source>Clay</source>
        <translation>Argile</translation>
    </message>
    <message>
        <source>Wireframe</source>
        <translation>Fil de fer</translation>
    </message>
    <message>
        <source>Turns around the figure</source>
        <translation>Tourne autour du personnage</translation>
    </message>
    <message>
        <source>Stands still</source>
        <translation>Reste fixe</translation>
    </message>
    <message>
        <source>Follows the figure</source>
        <translation>Suit le personnage</translation>
    </message>
    <message>
        <source>Full turns of the camera over the clip; negative ones go the other way round</source>
        <translation>Tours complets de la caméra au cours du clip&#x202f;; un nombre négatif inverse le sens</translation>
    </message>
</context>
<context>
    <name>quadrille::PictureFlow</name>
    <message>
        <source>View</source>
        <translation>Affichage</translation>
    </message>
    <message>
        <source>Copy the &amp;picture</source>
        <translation>Copier l’&amp;image</translation>
    </message>
    <message>
        <source>Puts the view as it is now onto the clipboard</source>
        <translation>Met la vue telle qu’elle est dans le presse-papiers</translation>
    </message>
    <message>
        <source>Save the pict&amp;ure…</source>
        <translation>Enregistrer l’i&amp;mage…</translation>
    </message>
    <message>
        <source>Writes the view as it is now into a picture file</source>
        <translation>Écrit la vue telle qu’elle est dans un fichier image</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Enregistrer l’image</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.tif *.tiff)</source>
        <translation>Images (*.png *.jpg *.jpeg *.tif *.tiff)</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>Enregistrement de %1</translation>
    </message>
</context>
<context>
    <name>quadrille::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Préférences</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Général</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Raccourcis</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Comme le système</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>never</source>
        <translation>jamais</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> Mo</translation>
    </message>
    <message>
        <source>Play over and over</source>
        <translation>Lire en boucle</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Thème</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>Copy unsaved edits every</source>
        <translation>Copier les modifications toutes les</translation>
    </message>
    <message>
        <source>Undo history</source>
        <translation>Historique d’annulation</translation>
    </message>
    <message>
        <source>Playback</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>A copy is offered again after a crash</source>
        <translation>Une copie est proposée après un plantage</translation>
    </message>
    <message>
        <source>Oldest edits beyond this can no longer be undone</source>
        <translation>Au-delà, les modifications les plus anciennes ne peuvent plus être annulées</translation>
    </message>
</context>
<context>
    <name>quadrille::ProjectDocument</name>
    <message>
        <source>Untitled</source>
        <translation>Sans titre</translation>
    </message>
</context>
<context>
    <name>quadrille::ProjectEdits</name>
    <message>
        <source>Remove “%1”</source>
        <translation>Supprimer «&#xa0;%1&#xa0;»</translation>
    </message>
    <message numerus="yes">
        <source>Remove %n characters</source>
        <translation>
            <numerusform>Supprimer %n personnage</numerusform>
            <numerusform>Supprimer %n personnages</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove %n exports</source>
        <translation>
            <numerusform>Supprimer %n export</numerusform>
            <numerusform>Supprimer %n exports</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove %n sequences</source>
        <translation>
            <numerusform>Supprimer %n séquence</numerusform>
            <numerusform>Supprimer %n séquences</numerusform>
        </translation>
    </message>
    <message>
        <source>Add “%1”</source>
        <translation>Ajouter «&#xa0;%1&#xa0;»</translation>
    </message>
    <message numerus="yes">
        <source>Add %n sequences</source>
        <translation>
            <numerusform>Ajouter %n séquence</numerusform>
            <numerusform>Ajouter %n séquences</numerusform>
        </translation>
    </message>
    <message>
        <source>Duplicate “%1”</source>
        <translation>Dupliquer «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>Renommer «&#xa0;%1&#xa0;» en «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>Trim “%1”</source>
        <translation>Rogner «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Change the frame rate of “%1”</source>
        <translation>Modifier la cadence de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Change axes or unit of “%1”</source>
        <translation>Modifier les axes ou l’unité de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Change the texture of “%1”</source>
        <translation>Modifier la texture de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Change the character of “%1”</source>
        <translation>Modifier le personnage de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Label “%1”</source>
        <translation>Étiqueter «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Mark foot contacts of “%1”</source>
        <translation>Marquer les contacts des pieds de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Change the reference joint angles of “%1”</source>
        <translation>Modifier les angles articulaires de référence de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Edit the notes of “%1”</source>
        <translation>Modifier les notes de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Change the mesh of “%1”</source>
        <translation>Modifier le maillage de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Change the project settings</source>
        <translation>Modifier les réglages du projet</translation>
    </message>
    <message>
        <source>Add export “%1”</source>
        <translation>Ajouter l’export «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Change export “%1”</source>
        <translation>Modifier l’export «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Relink media</source>
        <translation>Relier les médias</translation>
    </message>
</context>
<context>
    <name>quadrille::ProjectFiles</name>
    <message>
        <source>Unsaved edits</source>
        <translation>Modifications non enregistrées</translation>
    </message>
    <message>
        <source>Save the edits in “%1”?</source>
        <translation>Enregistrer les modifications de «&#xa0;%1&#xa0;»&#x202f;?</translation>
    </message>
    <message>
        <source>Making the sample character</source>
        <translation>Création du personnage d’exemple</translation>
    </message>
    <message>
        <source>Open project</source>
        <translation>Ouvrir un projet</translation>
    </message>
    <message>
        <source>Quadrille projects (*%1)</source>
        <translation>Projets Quadrille (*%1)</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Enregistrer le projet</translation>
    </message>
</context>
<context>
    <name>quadrille::ProjectPage</name>
    <message>
        <source>Rate</source>
        <translation>Cadence</translation>
    </message>
    <message>
        <source>Frames a second at which everything runs; sequences with another rate are resampled</source>
        <translation>Images par seconde auxquelles tout se joue&#x202f;; les séquences d’une autre cadence sont rééchantillonnées</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Axes</translation>
    </message>
    <message>
        <source>Up axis and unit that all sequences are converted to</source>
        <translation>Axe vertical et unité vers lesquels toutes les séquences sont converties</translation>
    </message>
    <message>
        <source>Cache</source>
        <translation>Cache</translation>
    </message>
    <message>
        <source>Memory for frames and textures of this project</source>
        <translation>Mémoire pour les images et les textures de ce projet</translation>
    </message>
    <message>
        <source>Holds</source>
        <translation>Contient</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message numerus="yes">
        <source>%n characters</source>
        <translation>
            <numerusform>%n personnage</numerusform>
            <numerusform>%n personnages</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sequences</source>
        <translation>
            <numerusform>%n séquence</numerusform>
            <numerusform>%n séquences</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n exports</source>
        <translation>
            <numerusform>%n export</numerusform>
            <numerusform>%n exports</numerusform>
        </translation>
    </message>
    <message>
        <source>not saved yet</source>
        <translation>pas encore enregistré</translation>
    </message>
    <message>
        <source> fps</source>
        <translation> i/s</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> Mo</translation>
    </message>
</context>
<context>
    <name>quadrille::ProjectPanel</name>
    <message>
        <source>Project</source>
        <translation>Projet</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Édition</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>Re&amp;nommer</translation>
    </message>
    <message>
        <source>Give the selected entry of the project another name</source>
        <translation>Donner un autre nom à l’élément sélectionné du projet</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Dupliquer</translation>
    </message>
    <message>
        <source>Add a copy of the selected sequence, to cut or mark otherwise</source>
        <translation>Ajouter une copie de la séquence sélectionnée, à couper ou à marquer autrement</translation>
    </message>
    <message>
        <source>&amp;Remove from the project</source>
        <translation>&amp;Retirer du projet</translation>
    </message>
    <message>
        <source>Take the selected entries out; their files stay</source>
        <translation>Retirer les éléments sélectionnés ; leurs fichiers restent</translation>
    </message>
    <message>
        <source>A name is needed.</source>
        <translation>Il faut un nom.</translation>
    </message>
    <message>
        <source>“%1” is taken.</source>
        <translation>« %1 » est déjà pris.</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Réessayer</translation>
    </message>
    <message>
        <source>Show in its folder</source>
        <translation>Montrer dans son dossier</translation>
    </message>
</context>
<context>
    <name>quadrille::ProjectTreeModel</name>
    <message>
        <source>Characters (%1)</source>
        <translation>Personnages (%1)</translation>
    </message>
    <message>
        <source>Sequences (%1)</source>
        <translation>Séquences (%1)</translation>
    </message>
    <message>
        <source>Exports (%1)</source>
        <translation>Exports (%1)</translation>
    </message>
</context>
<context>
    <name>quadrille::PropertiesPanel</name>
    <message numerus="yes">
        <source>%n sequences</source>
        <translation>
            <numerusform>%n séquence</numerusform>
            <numerusform>%n séquences</numerusform>
        </translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projet</translation>
    </message>
    <message numerus="yes">
        <source>%n frames, %1 s</source>
        <translation>
            <numerusform>%n image, %1 s</numerusform>
            <numerusform>%n images, %1 s</numerusform>
        </translation>
    </message>
    <message>
        <source>They are shown beside each other. Select one of them to edit it.</source>
        <translation>Elles sont montrées côte à côte. Sélectionnez-en une pour la modifier.</translation>
    </message>
</context>
<context>
    <name>quadrille::RecentMenu</name>
    <message>
        <source>Forget these</source>
        <translation>Oublier ces projets</translation>
    </message>
</context>
<context>
    <name>quadrille::RecoveryFlow</name>
    <message>
        <source>Unsaved edits were kept</source>
        <translation>Des modifications non enregistrées ont été gardées</translation>
    </message>
    <message>
        <source>Quadrille ended unexpectedly. Edits of “%1” from %2 were never saved.</source>
        <translation>Quadrille s’est arrêté de façon inattendue. Des modifications de « %1 » du %2 n’ont jamais été enregistrées.</translation>
    </message>
    <message>
        <source>Recover them, or discard them for good.</source>
        <translation>Récupérez-les, ou abandonnez-les définitivement.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Récupérer</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>Ask again later</source>
        <translation>Demander plus tard</translation>
    </message>
</context>
<context>
    <name>quadrille::RelinkDialog</name>
    <message>
        <source>Looking for what is missing</source>
        <translation>Recherche de ce qui manque</translation>
    </message>
    <message>
        <source>Folder to search</source>
        <translation>Dossier où chercher</translation>
    </message>
    <message>
        <source>Searching “%1”</source>
        <translation>Recherche dans « %1 »</translation>
    </message>
    <message>
        <source>Search another folder, or choose one file by hand.</source>
        <translation>Cherchez dans un autre dossier, ou choisissez un fichier à la main.</translation>
    </message>
    <message>
        <source>Where is “%1”?</source>
        <translation>Où est « %1 » ?</translation>
    </message>
    <message>
        <source>Files of this kind (*%1);;All files (*)</source>
        <translation>Fichiers de ce type (*%1);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Comparing “%1”</source>
        <translation>Comparaison de « %1 »</translation>
    </message>
    <message numerus="yes">
        <source>%n more were found from there.</source>
        <translation>
            <numerusform>%n autre a été trouvé à partir de là.</numerusform>
            <numerusform>%n autres ont été trouvés à partir de là.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Choose another folder.</source>
        <translation>Choisissez un autre dossier.</translation>
    </message>
    <message>
        <source>Nothing is missing: all files are where the project says.</source>
        <translation>Rien ne manque : tous les fichiers sont là où le projet le dit.</translation>
    </message>
    <message>
        <source>Looking for what is missing…</source>
        <translation>Recherche de ce qui manque…</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) are not where the project says. Search the folder where they are now.</source>
        <translation>
            <numerusform>%n fichier n’est pas là où le projet le dit. Cherchez dans le dossier où il se trouve maintenant.</numerusform>
            <numerusform>%n fichiers ne sont pas là où le projet le dit. Cherchez dans le dossier où ils se trouvent maintenant.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n missing file(s) were found. The project changes only when you apply this.</source>
        <translation>
            <numerusform>%1 sur %n fichier manquant a été trouvé. Le projet ne change que lorsque vous l’appliquez.</numerusform>
            <numerusform>%1 sur %n fichiers manquants ont été trouvés. Le projet ne change que lorsque vous l’appliquez.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Search</source>
        <translation>&amp;Chercher</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Arrêter</translation>
    </message>
    <message numerus="yes">
        <source>Relink %n file(s)</source>
        <translation>
            <numerusform>Relier %n fichier</numerusform>
            <numerusform>Relier %n fichiers</numerusform>
        </translation>
    </message>
    <message>
        <source>Relink</source>
        <translation>Relier</translation>
    </message>
    <message>
        <source>Find missing files</source>
        <translation>Trouver les fichiers manquants</translation>
    </message>
    <message>
        <source>Search &amp;in</source>
        <translation>Chercher &amp;dans</translation>
    </message>
    <message>
        <source>This folder is searched, and all folders in it</source>
        <translation>Ce dossier est parcouru, avec tous ceux qu’il contient</translation>
    </message>
    <message>
        <source>Choose the folder and search it</source>
        <translation>Choisir le dossier et y chercher</translation>
    </message>
    <message>
        <source>Look for the missing files by name and by content</source>
        <translation>Chercher les fichiers manquants par nom et par contenu</translation>
    </message>
    <message>
        <source>Progress of the search</source>
        <translation>Avancement de la recherche</translation>
    </message>
    <message>
        <source>Choose by &amp;hand…</source>
        <translation>Choisir à la &amp;main…</translation>
    </message>
    <message>
        <source>Say where the file of this row is; others are looked for from there</source>
        <translation>Dire où est le fichier de cette ligne ; les autres sont cherchés à partir de là</translation>
    </message>
    <message>
        <source>Use the files that are ticked; one step for undo</source>
        <translation>Utiliser les fichiers cochés ; une seule étape d’annulation</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>None of the missing files is in “%1”.</source>
        <translation>Aucun des fichiers manquants n’est dans « %1 ».</translation>
    </message>
</context>
<context>
    <name>quadrille::RelinkFlow</name>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Find &amp;missing files…</source>
        <translation>Trouver les fichiers &amp;manquants…</translation>
    </message>
    <message>
        <source>Look for files that moved, and relink them</source>
        <translation>Chercher les fichiers déplacés et les relier</translation>
    </message>
    <message>
        <source>Looking for what is missing</source>
        <translation>Recherche de ce qui manque</translation>
    </message>
    <message>
        <source>Find missing files…</source>
        <translation>Trouver les fichiers manquants…</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) of the project are missing. They may have been moved or renamed.</source>
        <translation>
            <numerusform>%n fichier du projet manque. Il a peut-être été déplacé ou renommé.</numerusform>
            <numerusform>%n fichiers du projet manquent. Ils ont peut-être été déplacés ou renommés.</numerusform>
        </translation>
    </message>
    <message>
        <source>Noting the contents of files</source>
        <translation>Relevé du contenu des fichiers</translation>
    </message>
</context>
<context>
    <name>quadrille::SequenceCards</name>
    <message>
        <source>Cannot be opened</source>
        <translation>Ne s’ouvre pas</translation>
    </message>
    <message>
        <source>Opening…</source>
        <translation>Ouverture…</translation>
    </message>
    <message numerus="yes">
        <source>%1 s · %2 fps
%n frames</source>
        <translation>
            <numerusform>%1 s · %2 i/s
%n image</numerusform>
            <numerusform>%1 s · %2 i/s
%n images</numerusform>
        </translation>
    </message>
    <message>
        <source>Pictures of “%1”</source>
        <translation>Images de «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>quadrille::SequenceMedia</name>
    <message>
        <source>Opening “%1”</source>
        <translation>Ouverture de «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>quadrille::SequencePage</name>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Unique in the project</source>
        <translation>Unique dans le projet</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>Character</source>
        <translation>Personnage</translation>
    </message>
    <message>
        <source>Whose mesh gives faces and texture coordinates</source>
        <translation>Celui dont le maillage donne les faces et les coordonnées de texture</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>First and last frame of the source that are used, from 0</source>
        <translation>Première et dernière images de la source utilisées, à partir de 0</translation>
    </message>
    <message>
        <source>Source rate</source>
        <translation>Cadence de la source</translation>
    </message>
    <message>
        <source>Frames a second of a source that names none; automatic is the project&apos;s rate</source>
        <translation>Images par seconde d’une source qui n’en indique pas&#x202f;; automatique&#xa0;: la cadence du projet</translation>
    </message>
    <message>
        <source>Source axes</source>
        <translation>Axes de la source</translation>
    </message>
    <message>
        <source>Whether the source has other axes or another unit than metres with y up</source>
        <translation>Indique si la source a d’autres axes ou une autre unité que le mètre avec y vers le haut</translation>
    </message>
    <message>
        <source>Up axis and unit of the source</source>
        <translation>Axe vertical et unité de la source</translation>
    </message>
    <message>
        <source>Textures</source>
        <translation>Textures</translation>
    </message>
    <message>
        <source>Its own textures; automatic are the character&apos;s, or those found beside the source</source>
        <translation>Ses propres textures&#x202f;; automatique&#xa0;: celles du personnage, ou celles trouvées à côté de la source</translation>
    </message>
    <message>
        <source>Joint angles</source>
        <translation>Angles articulaires</translation>
    </message>
    <message>
        <source>A BVH with the true joint angles, used to evaluate results</source>
        <translation>Un fichier BVH avec les vrais angles articulaires, pour évaluer les résultats</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>Repères</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Constats</translation>
    </message>
    <message>
        <source>%1, clip %2</source>
        <translation>%1, clip %2</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatique</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message numerus="yes">
        <source>%n labels</source>
        <translation>
            <numerusform>%n étiquette</numerusform>
            <numerusform>%n étiquettes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n contacts</source>
        <translation>
            <numerusform>%n contact</numerusform>
            <numerusform>%n contacts</numerusform>
        </translation>
    </message>
    <message>
        <source>opening…</source>
        <translation>ouverture…</translation>
    </message>
    <message numerus="yes">
        <source>%n frames, %1 s</source>
        <translation>
            <numerusform>%n image, %1 s</numerusform>
            <numerusform>%n images, %1 s</numerusform>
        </translation>
    </message>
    <message>
        <source>Reference joint angles</source>
        <translation>Angles articulaires de référence</translation>
    </message>
    <message>
        <source>BVH (*.bvh)</source>
        <translation>BVH (*.bvh)</translation>
    </message>
    <message>
        <source> fps</source>
        <translation> i/s</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Dernière image</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>Première image</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>none</source>
        <comment>findings</comment>
        <translation>aucun</translation>
    </message>
    <message>
        <source>metres, y up</source>
        <translation>m, y en haut</translation>
    </message>
    <message>
        <source>others</source>
        <comment>axes</comment>
        <translation>autres</translation>
    </message>
</context>
<context>
    <name>quadrille::SequenceStage</name>
    <message>
        <source>Reading the path of “%1”</source>
        <translation>Lecture du trajet de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Ghosts of “%1”</source>
        <translation>Fantômes de «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>quadrille::SequenceTimeline</name>
    <message>
        <source>Labels</source>
        <translation>Étiquettes</translation>
    </message>
    <message>
        <source>Left foot</source>
        <translation>Pied gauche</translation>
    </message>
    <message>
        <source>Right foot</source>
        <translation>Pied droit</translation>
    </message>
    <message>
        <source>label</source>
        <translation>étiquette</translation>
    </message>
    <message>
        <source>Name of the label</source>
        <translation>Nom de l’étiquette</translation>
    </message>
    <message>
        <source>Rename Label</source>
        <translation>Renommer l’étiquette</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Add Label Here</source>
        <translation>Ajouter une étiquette ici</translation>
    </message>
    <message>
        <source>Add Contact Here</source>
        <translation>Ajouter un contact ici</translation>
    </message>
    <message>
        <source>Trim Start to Frame %1</source>
        <translation>Faire commencer à l’image %1</translation>
    </message>
    <message>
        <source>Trim End to Frame %1</source>
        <translation>Faire finir à l’image %1</translation>
    </message>
    <message>
        <source>Use All Frames</source>
        <translation>Utiliser toutes les images</translation>
    </message>
</context>
<context>
    <name>quadrille::SequencesWorkspace</name>
    <message>
        <source>Edit</source>
        <translation>Édition</translation>
    </message>
    <message>
        <source>Trim &amp;start to here</source>
        <translation>Faire &amp;commencer ici</translation>
    </message>
    <message>
        <source>Trim &amp;end to here</source>
        <translation>Faire &amp;finir ici</translation>
    </message>
    <message>
        <source>Use &amp;all frames</source>
        <translation>Utiliser &amp;toutes les images</translation>
    </message>
    <message>
        <source>Add a &amp;label</source>
        <translation>Ajouter une éti&amp;quette</translation>
    </message>
    <message>
        <source>Playback</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>&amp;Lire ou mettre en pause</translation>
    </message>
    <message>
        <source>P&amp;revious frame</source>
        <translation>Image p&amp;récédente</translation>
    </message>
    <message>
        <source>&amp;Next frame</source>
        <translation>Image &amp;suivante</translation>
    </message>
    <message>
        <source>&amp;First frame</source>
        <translation>&amp;Première image</translation>
    </message>
    <message>
        <source>&amp;Last frame</source>
        <translation>&amp;Dernière image</translation>
    </message>
    <message>
        <source>Play &amp;backwards, faster</source>
        <translation>Lire en arr&amp;ière, plus vite</translation>
    </message>
    <message>
        <source>P&amp;ause</source>
        <translation>Pa&amp;use</translation>
    </message>
    <message>
        <source>Play f&amp;orwards, faster</source>
        <translation>Lire en a&amp;vant, plus vite</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Affichage</translation>
    </message>
    <message>
        <source>&amp;Textured</source>
        <translation>&amp;Texturé</translation>
    </message>
    <message>
        <source>&amp;Clay</source>
        <translation>&amp;Argile</translation>
    </message>
    <message>
        <source>&amp;Wireframe</source>
        <translation>&amp;Fil de fer</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Grille</translation>
    </message>
    <message>
        <source>&amp;Follow the character</source>
        <translation>S&amp;uivre le personnage</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Mesurer</translation>
    </message>
    <message>
        <source>Frame &amp;all</source>
        <translation>Tout &amp;cadrer</translation>
    </message>
    <message>
        <source>From the f&amp;ront</source>
        <translation>De fac&amp;e</translation>
    </message>
    <message>
        <source>From the &amp;side</source>
        <translation>De &amp;profil</translation>
    </message>
    <message>
        <source>From a&amp;bove</source>
        <translation>De &amp;dessus</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Frise chronologique</translation>
    </message>
    <message>
        <source>Trajector&amp;y</source>
        <translation>T&amp;rajectoire</translation>
    </message>
    <message>
        <source>&amp;Names</source>
        <translation>N&amp;oms</translation>
    </message>
    <message>
        <source>G&amp;hosts</source>
        <translation>Fantôme&amp;s</translation>
    </message>
    <message>
        <source>Fra&amp;me the selection</source>
        <translation>Cadrer la sélection</translation>
    </message>
    <message>
        <source>Side by s&amp;ide</source>
        <translation>Côte à côte</translation>
    </message>
    <message>
        <source>&amp;Overlaid</source>
        <translation>Superposées</translation>
    </message>
    <message>
        <source>Overlaid, each in a colour of its own</source>
        <translation>Superposées, chacune dans sa couleur</translation>
    </message>
    <message>
        <source>No foot contacts were found in “%1”.</source>
        <translation>Aucun contact des pieds n’a été trouvé dans «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>Mark them by hand: draw in the track of a foot in the timeline.</source>
        <translation>Marquez-les à la main&#xa0;: dessinez dans la piste d’un pied de la frise chronologique.</translation>
    </message>
    <message>
        <source>No sequences yet. Drop files here, or import them from the File menu.</source>
        <translation>Aucune séquence pour l’instant. Déposez des fichiers ici, ou importez-les par le menu Fichier.</translation>
    </message>
    <message>
        <source>Opening “%1”…</source>
        <translation>Ouverture de «&#xa0;%1&#xa0;»…</translation>
    </message>
    <message>
        <source>“%1” cannot be shown.</source>
        <translation>«&#xa0;%1&#xa0;» ne peut pas être montrée.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Try Again</source>
        <translation>Réessayer</translation>
    </message>
</context>
<context>
    <name>quadrille::ShortcutPage</name>
    <message>
        <source>%1 belongs to “%2” already.</source>
        <translation>%1 appartient déjà à « %2 ».</translation>
    </message>
    <message>
        <source>Choose other keys, or give “%1” others first.</source>
        <translation>Choisissez d’autres touches, ou donnez-en d’abord d’autres à « %1 ».</translation>
    </message>
    <message>
        <source>Find an action or its keys</source>
        <translation>Trouver une action ou ses touches</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Trouver</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Action</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Raccourcis</translation>
    </message>
    <message>
        <source>New keys</source>
        <translation>Nouvelles touches</translation>
    </message>
    <message>
        <source>Click here and press the keys</source>
        <translation>Cliquez ici et pressez les touches</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Tout rétablir</translation>
    </message>
</context>
<context>
    <name>quadrille::StatusJobs</name>
    <message>
        <source>Cancel all jobs</source>
        <translation>Annuler toutes les tâches</translation>
    </message>
    <message numerus="yes">
        <source>%1, and %n more</source>
        <translation>
            <numerusform>%1, et %n autre</numerusform>
            <numerusform>%1, et %n autres</numerusform>
        </translation>
    </message>
    <message>
        <source>Cache %1 of %2 MB</source>
        <translation>Cache&#xa0;: %1 sur %2 Mo</translation>
    </message>
    <message>
        <source>Memory that frames and textures take, and may take</source>
        <translation>Mémoire que les images et les textures occupent, et peuvent occuper</translation>
    </message>
    <message>
        <source>List the running jobs</source>
        <translation>Lister les tâches en cours</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>quadrille::TakePreview</name>
    <message>
        <source>Drawing the preview</source>
        <translation>Dessin de l’aperçu</translation>
    </message>
</context>
<context>
    <name>quadrille::TakeTable</name>
    <message>
        <source>one, chosen</source>
        <translation>une, choisie</translation>
    </message>
    <message>
        <source>one per frame, chosen</source>
        <translation>une par image, choisies</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>one</source>
        <translation>une</translation>
    </message>
    <message numerus="yes">
        <source>%n, one per frame</source>
        <translation>
            <numerusform>%n, une par image</numerusform>
            <numerusform>%n, une par image</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n, by material</source>
        <translation>
            <numerusform>%n, par matériau</numerusform>
            <numerusform>%n, par matériau</numerusform>
        </translation>
    </message>
    <message>
        <source>Take</source>
        <translation>Prise</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Cadence</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Maillage</translation>
    </message>
    <message>
        <source>Textures</source>
        <translation>Textures</translation>
    </message>
    <message>
        <source>Takes that were found</source>
        <translation>Prises trouvées</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>ne s’ouvre pas</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation>%1 i/s</translation>
    </message>
    <message>
        <source>not named</source>
        <translation>non indiquée</translation>
    </message>
    <message numerus="yes">
        <source>%n vertices</source>
        <translation>
            <numerusform>%n sommet</numerusform>
            <numerusform>%n sommets</numerusform>
        </translation>
    </message>
    <message>
        <source>Drawing “%1”</source>
        <translation>Dessin de «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>quadrille::TextureField</name>
    <message>
        <source>%1, one per frame</source>
        <translation>%1, une par image</translation>
    </message>
    <message numerus="yes">
        <source>%n, by material</source>
        <translation>
            <numerusform>%n, par matériau</numerusform>
            <numerusform>%n, par matériau</numerusform>
        </translation>
    </message>
    <message>
        <source>One picture…</source>
        <translation>Une seule texture…</translation>
    </message>
    <message>
        <source>A folder with one picture per frame…</source>
        <translation>Un dossier avec une texture par image…</translation>
    </message>
    <message>
        <source>None named</source>
        <translation>Aucune indiquée</translation>
    </message>
    <message>
        <source>Folder with one picture per frame</source>
        <translation>Dossier avec une texture par image</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Texture</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.tif *.tiff)</source>
        <translation>Images (*.png *.jpg *.jpeg *.tif *.tiff)</translation>
    </message>
</context>
<context>
    <name>quadrille::TexturePanel</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>u %1  v %2</source>
        <translation>u %1  v %2</translation>
    </message>
    <message>
        <source>%1 · pixel %2, %3</source>
        <translation>%1 · pixel %2, %3</translation>
    </message>
    <message>
        <source>UV edges</source>
        <translation>Arêtes UV</translation>
    </message>
    <message>
        <source>Draw the edges of the mesh over its texture</source>
        <translation>Dessiner les arêtes du maillage sur sa texture</translation>
    </message>
    <message>
        <source>1:1</source>
        <translation>1:1</translation>
    </message>
    <message>
        <source>One pixel of the texture for each pixel of the screen (0)</source>
        <translation>Un pixel de la texture par pixel de l’écran (0)</translation>
    </message>
    <message>
        <source>Actual size</source>
        <translation>Taille réelle</translation>
    </message>
    <message>
        <source>Fit into the view (F)</source>
        <translation>Ajuster à la vue (F)</translation>
    </message>
    <message>
        <source>Fit into the view</source>
        <translation>Ajuster à la vue</translation>
    </message>
    <message>
        <source>Material whose texture is shown</source>
        <translation>Matériau dont la texture est montrée</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>Choose textures</source>
        <translation>Choisir des textures</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Texture</translation>
    </message>
    <message>
        <source>Drawing the UV edges of “%1”</source>
        <translation>Dessin des arêtes UV de « %1 »</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>image %1</translation>
    </message>
    <message>
        <source>all frames</source>
        <translation>toutes les images</translation>
    </message>
    <message>
        <source>Inside the sequence’s file</source>
        <translation>Dans le fichier de la séquence</translation>
    </message>
    <message>
        <source>%1 × %2 pixels · %3</source>
        <translation>%1 × %2 pixels · %3</translation>
    </message>
    <message>
        <source>The texture of the selected sequence is shown here.</source>
        <translation>La texture de la séquence sélectionnée est montrée ici.</translation>
    </message>
    <message>
        <source>“%1” cannot be shown.</source>
        <translation>« %1 » ne peut pas être montrée.</translation>
    </message>
    <message>
        <source>Opening “%1”…</source>
        <translation>Ouverture de « %1 »…</translation>
    </message>
    <message>
        <source>The material “%1” has no texture.</source>
        <translation>Le matériau « %1 » n’a pas de texture.</translation>
    </message>
    <message>
        <source>“%1” has no texture. Choose a picture for all frames, or a folder with one for each.</source>
        <translation>« %1 » n’a pas de texture. Choisissez une image pour toutes les images de la séquence, ou un dossier avec une pour chacune.</translation>
    </message>
    <message>
        <source>“%1” has no texture, and its mesh has no texture coordinates (UVs) to put one on. Choose a character whose mesh has them in the properties.</source>
        <translation>« %1 » n’a pas de texture, et son maillage n’a pas de coordonnées de texture (UV) pour en recevoir une. Choisissez dans les propriétés un personnage dont le maillage en a.</translation>
    </message>
    <message>
        <source>The mesh has no texture coordinates (UVs), so it is shown in clay.</source>
        <translation>Le maillage n’a pas de coordonnées de texture (UV), il est donc montré en argile.</translation>
    </message>
    <message>
        <source>Choose a character whose mesh has them in the properties.</source>
        <translation>Choisissez dans les propriétés un personnage dont le maillage en a.</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
</context>
<context>
    <name>quadrille::ViewTools</name>
    <message>
        <source>View tools</source>
        <translation>Outils de la vue</translation>
    </message>
    <message>
        <source>every </source>
        <comment>every 10 frames: a ghost</comment>
        <translation>toutes les </translation>
    </message>
    <message>
        <source>Frames from one ghost to the next</source>
        <translation>Images d’un fantôme au suivant</translation>
    </message>
</context>
<context>
    <name>quadrille::WelcomePage</name>
    <message>
        <source>Bring in captured performances: drop files or folders anywhere in this window, or begin here.</source>
        <translation>Importez des performances captées&#xa0;: déposez des fichiers ou des dossiers n’importe où dans cette fenêtre, ou commencez ici.</translation>
    </message>
    <message>
        <source>Open the sample</source>
        <translation>Ouvrir l’exemple</translation>
    </message>
    <message>
        <source>Open a project…</source>
        <translation>Ouvrir un projet…</translation>
    </message>
    <message>
        <source>Import sequences…</source>
        <translation>Importer des séquences…</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>Projets récents</translation>
    </message>
    <message>
        <source>%1 is not there any more. Del forgets it.</source>
        <translation>%1 n’existe plus. Suppr l’oublie.</translation>
    </message>
</context>
<context>
    <name>quadrille::widgets::ActionPalette</name>
    <message>
        <source>What do you want to do?</source>
        <translation>Que voulez-vous faire ?</translation>
    </message>
    <message>
        <source>Find an action</source>
        <translation>Trouver une action</translation>
    </message>
    <message>
        <source>Actions</source>
        <translation>Actions</translation>
    </message>
    <message>
        <source>No action has this name.</source>
        <translation>Aucune action ne porte ce nom.</translation>
    </message>
</context>
<context>
    <name>quadrille::widgets::MessageStrip</name>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Avertissement</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Remarque</translation>
    </message>
</context>
<context>
    <name>quadrille::widgets::PlaybackBar</name>
    <message>
        <source>First frame (Home)</source>
        <translation>Première image (Début)</translation>
    </message>
    <message>
        <source>Previous frame (←)</source>
        <translation>Image précédente (←)</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Pause (Espace)</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>Lire (Espace)</translation>
    </message>
    <message>
        <source>Next frame (→)</source>
        <translation>Image suivante (→)</translation>
    </message>
    <message>
        <source>Last frame (End)</source>
        <translation>Dernière image (Fin)</translation>
    </message>
    <message>
        <source>Start over at the end</source>
        <translation>Recommencer à la fin</translation>
    </message>
    <message>
        <source>Current frame, counted from 0</source>
        <translation>Image actuelle, comptée à partir de 0</translation>
    </message>
    <message>
        <source>Current frame</source>
        <translation>Image actuelle</translation>
    </message>
    <message>
        <source>Frames a second that are reached, and that the sequence has</source>
        <translation>Images par seconde atteintes, et celles de la séquence</translation>
    </message>
    <message>
        <source>of %1 · %2 / %3 s</source>
        <translation>sur %1 · %2 / %3 s</translation>
    </message>
    <message>
        <source>%1 of %2 fps</source>
        <translation>%1 sur %2 i/s</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation>%1 i/s</translation>
    </message>
</context>
<context>
    <name>quadrille::widgets::Timeline</name>
    <message>
        <source>Frame %1 of %2, %3</source>
        <translation>Image %1 sur %2, %3</translation>
    </message>
    <message>
        <source>%1: frames %2 to %3 (%4 s)</source>
        <translation>%1&#xa0;: images %2 à %3 (%4 s)</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Frise chronologique</translation>
    </message>
    <message>
        <source>Scroll timeline</source>
        <translation>Faire défiler la frise</translation>
    </message>
    <message>
        <source>Nothing to play yet</source>
        <translation>Rien à lire pour l’instant</translation>
    </message>
</context>
<context>
    <name>quadrille::widgets::Viewport</name>
    <message>
        <source>Viewport</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Three-dimensional view</source>
        <translation>Vue en trois dimensions</translation>
    </message>
    <message>
        <source>There is no OpenGL 3.2 here, so nothing can be shown in three dimensions. Install the graphics driver, or Mesa&apos;s software renderer (libgl1-mesa-dri).</source>
        <translation>OpenGL 3.2 n’est pas disponible ici&#xa0;: rien ne peut être montré en trois dimensions. Installez le pilote graphique, ou le rendu logiciel de Mesa (libgl1-mesa-dri).</translation>
    </message>
</context>
</TS>
