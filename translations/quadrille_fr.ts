<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr_FR" sourcelanguage="en">
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
        <source>Check the path, or find the file with Relink.</source>
        <translation>Vérifiez le chemin, ou retrouvez le fichier avec Relier.</translation>
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
        <translation>Échec de la lecture : {reason}.</translation>
    </message>
    <message>
        <source>Check the disk and try again.</source>
        <translation>Vérifiez le disque et réessayez.</translation>
    </message>
    <message>
        <source>Writing failed: {reason}.</source>
        <translation>Échec de l’écriture : {reason}.</translation>
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
        <translation>Le fichier se termine trop tôt : {expected} attendus, {found} trouvés.</translation>
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
        <translation>Le format ne permet pas cela à cet endroit : {reason}.</translation>
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
        <translation>Le fichier est endommagé ou d’un autre format ; exportez-le de nouveau.</translation>
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
        <translation>{format} ne peut pas être lu ici.</translation>
    </message>
    <message>
        <source>{remedy}</source>
        <translation>{remedy}</translation>
    </message>
    <message>
        <source>This file holds positions only; a mesh with its faces is needed.</source>
        <translation>Ce fichier ne contient que des positions ; il faut un maillage avec ses faces.</translation>
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
        <translation>Exportez aussi la géométrie du personnage : caméras, lumières et os seuls ne peuvent pas être montrés.</translation>
    </message>
    <message>
        <source>The {count} triangles share no vertices: this is a polygon soup.</source>
        <translation>Les {count} triangles ne partagent aucun sommet : c’est une soupe de polygones.</translation>
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
        <translation>La topologie diffère de celle de la première image : {what}.</translation>
    </message>
    <message>
        <source>A sequence needs one topology; leave this frame out or track the capture first.</source>
        <translation>Une séquence exige une seule topologie ; excluez cette image ou suivez d’abord la capture.</translation>
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
        <translation>Ce n’est pas du JSON valide : {reason}.</translation>
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
        <translation>Le projet est de version {found} ; ce programme connaît les versions jusqu’à {known}.</translation>
    </message>
    <message>
        <source>Open it with a newer Quadrille.</source>
        <translation>Ouvrez-le avec une version plus récente de Quadrille.</translation>
    </message>
    <message>
        <source>“{what}” uses a file that is not there: {path}.</source>
        <translation>« {what} » utilise un fichier absent : {path}.</translation>
    </message>
    <message>
        <source>Put it back, or relink it.</source>
        <translation>Remettez-le en place, ou reliez-le.</translation>
    </message>
    <message>
        <source>The project has no target “{what}”.</source>
        <translation>Le projet n’a pas de cible « {what} ».</translation>
    </message>
    <message>
        <source>It has: {known}.</source>
        <translation>Il contient : {known}.</translation>
    </message>
    <message>
        <source>The project has no data “{what}”.</source>
        <translation>Le projet n’a pas de données « {what} ».</translation>
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
        <translation>Un événement inattendu s’est produit : {reason}.</translation>
    </message>
    <message>
        <source>Save your work and try again; if it happens again, report it.</source>
        <translation>Enregistrez votre travail et réessayez ; si cela se reproduit, signalez-le.</translation>
    </message>
    <message>
        <source>The numbering has gaps: {missing}.</source>
        <translation>La numérotation a des trous : {missing}.</translation>
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
        <translation>La source n’indique aucune cadence ; {fps} i/s est supposé.</translation>
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
        <translation>Supprimer « %1 »</translation>
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
        <translation>Ajouter « %1 »</translation>
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
        <translation>Dupliquer « %1 »</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>Renommer « %1 » en « %2 »</translation>
    </message>
    <message>
        <source>Trim “%1”</source>
        <translation>Rogner « %1 »</translation>
    </message>
    <message>
        <source>Change the frame rate of “%1”</source>
        <translation>Modifier la cadence de « %1 »</translation>
    </message>
    <message>
        <source>Change axes or unit of “%1”</source>
        <translation>Modifier les axes ou l’unité de « %1 »</translation>
    </message>
    <message>
        <source>Change the texture of “%1”</source>
        <translation>Modifier la texture de « %1 »</translation>
    </message>
    <message>
        <source>Change the character of “%1”</source>
        <translation>Modifier le personnage de « %1 »</translation>
    </message>
    <message>
        <source>Label “%1”</source>
        <translation>Étiqueter « %1 »</translation>
    </message>
    <message>
        <source>Mark foot contacts of “%1”</source>
        <translation>Marquer les contacts des pieds de « %1 »</translation>
    </message>
    <message>
        <source>Change the reference joint angles of “%1”</source>
        <translation>Modifier les angles articulaires de référence de « %1 »</translation>
    </message>
    <message>
        <source>Edit the notes of “%1”</source>
        <translation>Modifier les notes de « %1 »</translation>
    </message>
    <message>
        <source>Change the mesh of “%1”</source>
        <translation>Modifier le maillage de « %1 »</translation>
    </message>
    <message>
        <source>Change the project settings</source>
        <translation>Modifier les réglages du projet</translation>
    </message>
    <message>
        <source>Add export “%1”</source>
        <translation>Ajouter l’export « %1 »</translation>
    </message>
    <message>
        <source>Change export “%1”</source>
        <translation>Modifier l’export « %1 »</translation>
    </message>
    <message>
        <source>Relink media</source>
        <translation>Relier les médias</translation>
    </message>
</context>
</TS>
