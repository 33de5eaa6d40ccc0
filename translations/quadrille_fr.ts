<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr_FR" sourcelanguage="en">
<context>
    <name>Evaluation</name>
    <message>
        <source>Change of edges</source>
        <translation>Changement des arêtes</translation>
    </message>
    <message>
        <source>λ</source>
        <translation>λ</translation>
    </message>
    <message>
        <source>Change of volume</source>
        <translation>Changement de volume</translation>
    </message>
    <message>
        <source>Costs, over the largest of a linear transition</source>
        <translation>Coûts, sur le plus grand d’une transition linéaire</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Mean path cost</source>
        <translation>Coût moyen des chemins</translation>
    </message>
    <message>
        <source>α</source>
        <translation>α</translation>
    </message>
    <message>
        <source>Mean path cost, as many edges in both</source>
        <translation>Coût moyen des chemins, autant d’arêtes dans les deux</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Densité</translation>
    </message>
    <message>
        <source>Correlation with joint angles</source>
        <translation>Corrélation avec les angles des articulations</translation>
    </message>
    <message>
        <source>Correlation, joint by joint</source>
        <translation>Corrélation, articulation par articulation</translation>
    </message>
    <message>
        <source>Later than wanted</source>
        <translation>Plus tard que voulu</translation>
    </message>
    <message>
        <source>Good transitions</source>
        <translation>Bonnes transitions</translation>
    </message>
    <message>
        <source>What is used up of the limit, median</source>
        <translation>Ce qui est usé de la limite, médiane</translation>
    </message>
    <message>
        <source>How well costs foretell, area under the curve</source>
        <translation>Ce que prédisent les coûts, aire sous la courbe</translation>
    </message>
    <message>
        <source>Pairs of frames with a transition</source>
        <translation>Paires d’images qui ont une transition</translation>
    </message>
    <message>
        <source>Deviation from the path</source>
        <translation>Écart au chemin</translation>
    </message>
    <message>
        <source>Foot slide</source>
        <translation>Glissement des pieds</translation>
    </message>
    <message>
        <source>Change of speed</source>
        <translation>Variation de vitesse</translation>
    </message>
    <message>
        <source>Transitions a second</source>
        <translation>Transitions par seconde</translation>
    </message>
    <message>
        <source>Blended share of the frames</source>
        <translation>Part fondue des images</translation>
    </message>
    <message>
        <source>Share of the frames that are no locomotion</source>
        <translation>Part des images qui ne sont pas de la locomotion</translation>
    </message>
    <message>
        <source>Acceleration, as multiples of the take’s</source>
        <translation>Accélération, en multiples de celle de la prise</translation>
    </message>
    <message>
        <source>Foot slide, as multiples of the take’s</source>
        <translation>Glissement des pieds, en multiples de celui de la prise</translation>
    </message>
    <message>
        <source>Below and above the take</source>
        <translation>Sous et sur la prise</translation>
    </message>
    <message>
        <source>Greatest turn from the take</source>
        <translation>Plus grand écart de cap</translation>
    </message>
    <message>
        <source>How many</source>
        <translation>Combien</translation>
    </message>
    <message>
        <source>Mean distance of a vertex</source>
        <translation>Distance moyenne d’un sommet</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>images</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>a word and its value: &quot;slope 2&quot;</extracomment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Way of the centre, seen from above</source>
        <translation>Chemin du centre, vu d’en haut</translation>
    </message>
    <message>
        <source>Interpolated poses</source>
        <translation>Poses interpolées</translation>
    </message>
    <message>
        <source>How interpolated poses keep the lengths of edges and the volume, beside blended vertices (SMCAS Fig. 4)</source>
        <translation>Comment les poses interpolées gardent la longueur des arêtes et le volume, face à des sommets mélangés (SMCAS fig. 4)</translation>
    </message>
    <message>
        <source>Kinds of transitions</source>
        <translation>Sortes de transitions</translation>
    </message>
    <message>
        <source>Linear and warped transitions, with windows of one length and of any: cost, acceleration and length (SMCAS Fig. 7)</source>
        <translation>Transitions linéaires et alignées, avec des fenêtres d’une longueur ou de toutes : coût, accélération et durée (SMCAS fig. 7)</translation>
    </message>
    <message>
        <source>Essential graph and motion graph</source>
        <translation>Graphe essentiel et graphe de mouvement</translation>
    </message>
    <message>
        <source>What ways through both graphs cost, and how dense the graphs are, for several α (SMCAS Fig. 9)</source>
        <translation>Ce que coûtent les chemins dans les deux graphes, et leur densité, pour plusieurs α (SMCAS fig. 9)</translation>
    </message>
    <message>
        <source>Centre of a blend, constant weights</source>
        <translation>Centre d’un fondu, poids constants</translation>
    </message>
    <message>
        <source>The way of the body’s centre while two takes are blended half and half: without alignment, aligned once, at every step (SMCAS Fig. 11)</source>
        <translation>Le chemin du centre du corps pendant que deux prises sont fondues moitié-moitié : sans alignement, aligné une fois, à chaque pas (SMCAS fig. 11)</translation>
    </message>
    <message>
        <source>Centre of a blend, moving weights</source>
        <translation>Centre d’un fondu, poids variables</translation>
    </message>
    <message>
        <source>The same while one take goes over into the other (SMCAS Fig. 12)</source>
        <translation>De même pendant qu’une prise passe à l’autre (SMCAS fig. 12)</translation>
    </message>
    <message>
        <source>Pose distances and joint angles</source>
        <translation>Distances de poses et angles des articulations</translation>
    </message>
    <message>
        <source>How well pose distances agree with the joint angles of a motion capture beside the takes (SMCAS Table 1)</source>
        <translation>À quel point les distances de poses s’accordent avec les angles d’une capture de mouvement à côté des prises (SMCAS tableau 1)</translation>
    </message>
    <message>
        <source>Poses at times</source>
        <translation>Poses à des instants</translation>
    </message>
    <message>
        <source>Random poses at random times: when each was wanted and when the walk shows it (SMCAS Table 2)</source>
        <translation>Des poses au hasard à des instants au hasard : quand chacune était voulue et quand le parcours la montre (SMCAS tableau 2)</translation>
    </message>
    <message>
        <source>What shows at transitions</source>
        <translation>Ce qui se voit aux transitions</translation>
    </message>
    <message>
        <source>Random transitions measured against their takes: accelerations, frozen frames, steps, sliding feet, volume</source>
        <translation>Des transitions au hasard mesurées face à leurs prises : accélérations, images figées, sauts, pieds qui glissent, volume</translation>
    </message>
    <message>
        <source>What makes graphs dense</source>
        <translation>Ce qui rend les graphes denses</translation>
    </message>
    <message>
        <source>How dense both graphs are when one thing at a time is another: divisor of costs, longest window, takes joined, as published</source>
        <translation>La densité des deux graphes quand une chose à la fois est autre : diviseur des coûts, fenêtre la plus longue, prises jointes, comme publié</translation>
    </message>
    <message>
        <source>Walks along five paths</source>
        <translation>Parcours le long de cinq chemins</translation>
    </message>
    <message>
        <source>How calm walks along a straight line, an S, a circle, a right angle and a figure of eight are, and how their feet stand</source>
        <translation>Le calme de parcours le long d’une droite, d’un S, d’un cercle, d’un angle droit et d’un huit, et l’appui des pieds</translation>
    </message>
    <message>
        <source>Poses that models reconstruct</source>
        <translation>Poses que les modèles reconstruisent</translation>
    </message>
    <message>
        <source>How far models of variations are from the poses that they learned, beside principal components (CVS Fig. 4)</source>
        <translation>L’écart des modèles de variations aux poses qu’ils ont apprises, face aux composantes principales (CVS fig. 4)</translation>
    </message>
    <message>
        <source>Blends in latent space</source>
        <translation>Mélanges dans l’espace latent</translation>
    </message>
    <message>
        <source>How far interpolated blends are from true ones, with and without learned ones between (CVS Fig. 7)</source>
        <translation>L’écart des mélanges interpolés aux vrais, avec et sans mélanges appris entre eux (CVS fig. 7)</translation>
    </message>
    <message>
        <source>What shows of variations</source>
        <translation>Ce qui se voit des variations</translation>
    </message>
    <message>
        <source>Variations beside the takes that they vary: accelerations, sliding feet, heights, headings, lengths, what was rejected</source>
        <translation>Les variations face aux prises qu’elles varient : accélérations, pieds qui glissent, hauteurs, caps, durées, ce qui fut rejeté</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <extracomment>an evaluation and the character that it is of</extracomment>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Compactness, SSIM</source>
        <translation>Compacité, SSIM</translation>
    </message>
    <message>
        <source>How well Eigen textures and Eigen warps restore textures by their number, beside naive principal components: structural similarity (SMCAS Fig. 17)</source>
        <translation>À quel point textures propres et déformations propres restituent les textures selon leur nombre, à côté de composantes principales naïves&#xa0;: similarité structurelle (SMCAS fig. 17)</translation>
    </message>
    <message>
        <source>Compactness, squared error</source>
        <translation>Compacité, erreur quadratique</translation>
    </message>
    <message>
        <source>The same as mean squared error (SMCAS Fig. 18)</source>
        <translation>La même chose en erreur quadratique moyenne (SMCAS fig. 18)</translation>
    </message>
    <message>
        <source>Generalisation, SSIM</source>
        <translation>Généralisation, SSIM</translation>
    </message>
    <message>
        <source>How well textures that were left out are restored by how many were learned from: structural similarity (SMCAS Fig. 19)</source>
        <translation>À quel point les textures laissées de côté sont restituées selon le nombre de celles apprises&#xa0;: similarité structurelle (SMCAS fig. 19)</translation>
    </message>
    <message>
        <source>Generalisation, squared error</source>
        <translation>Généralisation, erreur quadratique</translation>
    </message>
    <message>
        <source>The same as mean squared error (SMCAS Fig. 20)</source>
        <translation>La même chose en erreur quadratique moyenne (SMCAS fig. 20)</translation>
    </message>
    <message>
        <source>Eigen textures of interpolated textures</source>
        <translation>Textures propres de textures interpolées</translation>
    </message>
    <message>
        <source>How near textures midway between two frames come to those with all Eigen textures, by their number (SMCAS Fig. 22)</source>
        <translation>À quel point les textures à mi-chemin de deux images approchent celles qui ont toutes les textures propres, selon leur nombre (SMCAS fig. 22)</translation>
    </message>
    <message>
        <source>Interpolated textures</source>
        <translation>Textures interpolées</translation>
    </message>
    <message>
        <source>Textures midway between two frames, by the model and blended, against the captured one in the middle</source>
        <translation>Textures à mi-chemin de deux images, par le modèle et mélangées, face à celle qui fut captée au milieu</translation>
    </message>
    <message>
        <source>Bytes of textures</source>
        <translation>Octets des textures</translation>
    </message>
    <message>
        <source>What files of models, JPEG pictures and H.264 films of the textures take, and what they lose</source>
        <translation>Ce que prennent fichiers de modèles, images JPEG et films H.264 des textures, et ce qu’ils perdent</translation>
    </message>
    <message>
        <source>Structural similarity</source>
        <translation>Similarité structurelle</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Composantes</translation>
    </message>
    <message>
        <source>Mean squared error</source>
        <translation>Erreur quadratique moyenne</translation>
    </message>
    <message>
        <source>Share of the textures learned from</source>
        <translation>Part des textures apprises</translation>
    </message>
    <message>
        <source>Eigen textures</source>
        <translation>Textures propres</translation>
    </message>
    <message>
        <source>Difference from the captured texture</source>
        <translation>Différence avec la texture captée</translation>
    </message>
    <message>
        <source>Frames to each side</source>
        <translation>Images de chaque côté</translation>
    </message>
    <message>
        <source>Bytes a frame</source>
        <translation>Octets par image</translation>
    </message>
    <message>
        <source>Textures learned from poses</source>
        <translation>Textures apprises d’après les poses</translation>
    </message>
    <message>
        <source>Textures of the poses of a take that was left out: of the nearest frame of the others, their mean, and learned from poses</source>
        <translation>Textures des poses d’une prise laissée de côté : de l’image la plus proche des autres, leur moyenne, et apprises d’après les poses</translation>
    </message>
    <message>
        <source>Transfers and their truth</source>
        <translation>Transferts et leur vérité</translation>
    </message>
    <message>
        <source>How far transfers are from what they ought to be, where that is known: with quaternions and logarithms, with and without correction of the pose and stretch</source>
        <translation>De combien les transferts s’écartent de ce qu’ils devraient être, là où on le sait : avec quaternions et logarithmes, avec et sans correction de la pose et étirement</translation>
    </message>
    <message>
        <source>Mean distance of a vertex from the truth, share of the height</source>
        <translation>Distance moyenne d’un sommet à la vérité, part de la hauteur</translation>
    </message>
    <message>
        <source>Mean distance of a vertex from the truth</source>
        <translation>Distance moyenne d’un sommet à la vérité</translation>
    </message>
    <message>
        <source>Greatest distance of a vertex from the truth</source>
        <translation>Plus grande distance d’un sommet à la vérité</translation>
    </message>
    <message>
        <source>Mean distance of a vertex, frame by frame</source>
        <translation>Distance moyenne d’un sommet, image par image</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Volume, share of that at rest</source>
        <translation>Volume, part de celui au repos</translation>
    </message>
    <message>
        <source>Angle that paired triangles miss</source>
        <translation>Angle que manquent les triangles appariés</translation>
    </message>
    <message>
        <source>Hybrid blends</source>
        <translation>Mélanges hybrides</translation>
    </message>
    <message>
        <source>How far blends of motion spaces are from non-linear ones, and what they take, by the number of references (IA4D Table 1)</source>
        <translation>À quelle distance les mélanges des espaces de mouvement sont des mélanges non linéaires, et la place qu’ils prennent, selon le nombre de références (IA4D, table 1)</translation>
    </message>
    <message>
        <source>Hybrid blends from take to take</source>
        <translation>Mélanges hybrides de prise à prise</translation>
    </message>
    <message>
        <source>The same along the ways from take to take (IA4D Fig. 4)</source>
        <translation>La même chose le long des chemins de prise à prise (IA4D, fig. 4)</translation>
    </message>
    <message>
        <source>Transitions between motion spaces</source>
        <translation>Transitions entre espaces de mouvement</translation>
    </message>
    <message>
        <source>What transitions cost and how long they take: found while spaces play, and computed before (IA4D Table 2)</source>
        <translation>Ce que les transitions coûtent et le temps qu’elles prennent&#xa0;: trouvées pendant le jeu, et calculées d’avance (IA4D, table 2)</translation>
    </message>
    <message>
        <source>Interpolated distances of poses</source>
        <translation>Distances de poses interpolées</translation>
    </message>
    <message>
        <source>How far distances that are interpolated between takes are from true ones (IA4D Table 3)</source>
        <translation>À quel point les distances interpolées entre prises s’écartent des vraies (IA4D, table 3)</translation>
    </message>
    <message>
        <source>Mean distance from non-linear blends</source>
        <translation>Écart moyen aux mélanges non linéaires</translation>
    </message>
    <message>
        <source>References</source>
        <translation>Références</translation>
    </message>
    <message>
        <source>Memory of the references</source>
        <translation>Mémoire des références</translation>
    </message>
    <message>
        <source>Greatest distance from non-linear blends</source>
        <translation>Plus grand écart aux mélanges non linéaires</translation>
    </message>
    <message>
        <source>Weight of the second take</source>
        <translation>Poids de la seconde prise</translation>
    </message>
    <message>
        <source>Latency of transitions</source>
        <translation>Latence des transitions</translation>
    </message>
    <message>
        <source>Dissimilarity of poses, 0 to 1000</source>
        <translation>Dissemblance des poses, de 0 à 1000</translation>
    </message>
    <message>
        <source>Mean error of interpolated distances, share of their range</source>
        <translation>Erreur moyenne des distances interpolées, part de leur étendue</translation>
    </message>
    <message>
        <source>Halvings</source>
        <translation>Divisions en deux</translation>
    </message>
    <message>
        <source>Greatest error of interpolated distances, share of their range</source>
        <translation>Plus grande erreur des distances interpolées, part de leur étendue</translation>
    </message>
</context>
<context>
    <name>EvaluationWord</name>
    <message>
        <source>surface cost</source>
        <translation>coût de surface</translation>
    </message>
    <message>
        <source>deviation of surface cost</source>
        <translation>écart-type du coût de surface</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>accélération</translation>
    </message>
    <message>
        <source>deviation of acceleration</source>
        <translation>écart-type de l’accélération</translation>
    </message>
    <message>
        <source>surface cost a frame</source>
        <translation>coût de surface par image</translation>
    </message>
    <message>
        <source>deviation of surface cost a frame</source>
        <translation>écart-type du coût par image</translation>
    </message>
    <message>
        <source>length</source>
        <translation>longueur</translation>
    </message>
    <message>
        <source>deviation of length</source>
        <translation>écart-type de la longueur</translation>
    </message>
    <message>
        <source>transition</source>
        <translation>transition</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>pente</translation>
    </message>
    <message>
        <source>pairs</source>
        <translation>paires</translation>
    </message>
    <message>
        <source>largest linear cost</source>
        <translation>plus grand coût linéaire</translation>
    </message>
    <message>
        <source>largest linear acceleration</source>
        <translation>plus grande accélération linéaire</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linéaire</translation>
    </message>
    <message>
        <source>warped</source>
        <translation>alignée</translation>
    </message>
    <message>
        <source>warped, any windows</source>
        <translation>alignée, fenêtres libres</translation>
    </message>
    <message>
        <source>graph</source>
        <translation>graphe</translation>
    </message>
    <message>
        <source>α</source>
        <translation>α</translation>
    </message>
    <message>
        <source>nodes</source>
        <translation>nœuds</translation>
    </message>
    <message>
        <source>edges</source>
        <translation>arêtes</translation>
    </message>
    <message>
        <source>transitions</source>
        <translation>transitions</translation>
    </message>
    <message>
        <source>density</source>
        <translation>densité</translation>
    </message>
    <message>
        <source>mean path cost</source>
        <translation>coût moyen des chemins</translation>
    </message>
    <message>
        <source>deviation of path cost</source>
        <translation>écart-type du coût</translation>
    </message>
    <message>
        <source>pairs without a way</source>
        <translation>paires sans chemin</translation>
    </message>
    <message>
        <source>components</source>
        <translation>composantes</translation>
    </message>
    <message>
        <source>pairs with a way in both</source>
        <translation>paires avec chemin dans les deux</translation>
    </message>
    <message>
        <source>mean cost of these</source>
        <translation>coût moyen de celles-ci</translation>
    </message>
    <message>
        <source>component</source>
        <translation>composante</translation>
    </message>
    <message>
        <source>reachable</source>
        <translation>atteignable</translation>
    </message>
    <message>
        <source>returns</source>
        <translation>revient</translation>
    </message>
    <message>
        <source>Essential graph</source>
        <translation>graphe essentiel</translation>
    </message>
    <message>
        <source>motion graph</source>
        <translation>graphe de mouvement</translation>
    </message>
    <message>
        <source>variant</source>
        <translation>variante</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>image</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>images</translation>
    </message>
    <message>
        <source>take</source>
        <translation>prise</translation>
    </message>
    <message>
        <source>first</source>
        <translation>première</translation>
    </message>
    <message>
        <source>last</source>
        <translation>dernière</translation>
    </message>
    <message>
        <source>distance of the ends</source>
        <translation>distance des bouts</translation>
    </message>
    <message>
        <source>greatest turn</source>
        <translation>plus grand virage</translation>
    </message>
    <message>
        <source>reversals</source>
        <translation>demi-tours</translation>
    </message>
    <message>
        <source>without alignment</source>
        <translation>sans alignement</translation>
    </message>
    <message>
        <source>aligned once</source>
        <translation>aligné une fois</translation>
    </message>
    <message>
        <source>aligned at every step</source>
        <translation>aligné à chaque pas</translation>
    </message>
    <message>
        <source>source</source>
        <translation>source</translation>
    </message>
    <message>
        <source>destination</source>
        <translation>destination</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>référence</translation>
    </message>
    <message>
        <source>Pearson, vertices</source>
        <translation>Pearson, sommets</translation>
    </message>
    <message>
        <source>Pearson, surface</source>
        <translation>Pearson, surface</translation>
    </message>
    <message>
        <source>distance correlation, vertices</source>
        <translation>corrélation de distance, sommets</translation>
    </message>
    <message>
        <source>distance correlation, surface</source>
        <translation>corrélation de distance, surface</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>articulation</translation>
    </message>
    <message>
        <source>joints</source>
        <translation>articulations</translation>
    </message>
    <message>
        <source>mean difference</source>
        <translation>différence moyenne</translation>
    </message>
    <message>
        <source>share</source>
        <translation>part</translation>
    </message>
    <message>
        <source>method</source>
        <translation>méthode</translation>
    </message>
    <message>
        <source>λ</source>
        <translation>λ</translation>
    </message>
    <message>
        <source>change of edges</source>
        <translation>changement des arêtes</translation>
    </message>
    <message>
        <source>deviation of edges</source>
        <translation>écart-type des arêtes</translation>
    </message>
    <message>
        <source>greatest change of edges</source>
        <translation>plus grand changement d’arête</translation>
    </message>
    <message>
        <source>change of volume</source>
        <translation>changement de volume</translation>
    </message>
    <message>
        <source>greatest change of volume</source>
        <translation>plus grand changement de volume</translation>
    </message>
    <message>
        <source>pose distance</source>
        <translation>distance des poses</translation>
    </message>
    <message>
        <source>from</source>
        <translation>de</translation>
    </message>
    <message>
        <source>from frame</source>
        <translation>de l’image</translation>
    </message>
    <message>
        <source>to</source>
        <translation>à</translation>
    </message>
    <message>
        <source>to frame</source>
        <translation>à l’image</translation>
    </message>
    <message>
        <source>search</source>
        <translation>recherche</translation>
    </message>
    <message>
        <source>key</source>
        <translation>clé</translation>
    </message>
    <message>
        <source>wanted</source>
        <translation>voulu</translation>
    </message>
    <message>
        <source>obtained</source>
        <translation>obtenu</translation>
    </message>
    <message>
        <source>error</source>
        <translation>erreur</translation>
    </message>
    <message>
        <source>cost</source>
        <translation>coût</translation>
    </message>
    <message>
        <source>cost of edges</source>
        <translation>coût des arêtes</translation>
    </message>
    <message>
        <source>cost of timing</source>
        <translation>coût des instants</translation>
    </message>
    <message>
        <source>mean error</source>
        <translation>erreur moyenne</translation>
    </message>
    <message>
        <source>greatest error</source>
        <translation>plus grande erreur</translation>
    </message>
    <message>
        <source>expansions</source>
        <translation>expansions</translation>
    </message>
    <message>
        <source>proven best</source>
        <translation>prouvé le meilleur</translation>
    </message>
    <message>
        <source>bound</source>
        <translation>borne</translation>
    </message>
    <message>
        <source>blend</source>
        <translation>fondu</translation>
    </message>
    <message>
        <source>criterion</source>
        <translation>critère</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>mesurées</translation>
    </message>
    <message>
        <source>good</source>
        <translation>bonnes</translation>
    </message>
    <message>
        <source>median of ratios</source>
        <translation>médiane des rapports</translation>
    </message>
    <message>
        <source>90th percentile of ratios</source>
        <translation>90e centile des rapports</translation>
    </message>
    <message>
        <source>greatest ratio</source>
        <translation>plus grand rapport</translation>
    </message>
    <message>
        <source>predictor</source>
        <translation>prédicteur</translation>
    </message>
    <message>
        <source>rank correlation</source>
        <translation>corrélation de rang</translation>
    </message>
    <message>
        <source>area under the curve</source>
        <translation>aire sous la courbe</translation>
    </message>
    <message>
        <source>frozen frames</source>
        <translation>images figées</translation>
    </message>
    <message>
        <source>step of the centre</source>
        <translation>saut du centre</translation>
    </message>
    <message>
        <source>foot slide</source>
        <translation>glissement des pieds</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>volume</translation>
    </message>
    <message>
        <source>all</source>
        <translation>tous</translation>
    </message>
    <message>
        <source>source window</source>
        <translation>fenêtre source</translation>
    </message>
    <message>
        <source>destination window</source>
        <translation>fenêtre destination</translation>
    </message>
    <message>
        <source>weight</source>
        <translation>poids</translation>
    </message>
    <message>
        <source>sum</source>
        <translation>somme</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>moyenne</translation>
    </message>
    <message>
        <source>gentle</source>
        <translation>doux</translation>
    </message>
    <message>
        <source>published</source>
        <translation>publié</translation>
    </message>
    <message>
        <source>quantile</source>
        <translation>quantile</translation>
    </message>
    <message>
        <source>longest window</source>
        <translation>fenêtre la plus longue</translation>
    </message>
    <message>
        <source>takes</source>
        <translation>prises</translation>
    </message>
    <message>
        <source>divisor</source>
        <translation>diviseur</translation>
    </message>
    <message>
        <source>median deformation</source>
        <translation>déformation médiane</translation>
    </message>
    <message>
        <source>transitions, Essential graph</source>
        <translation>transitions, graphe essentiel</translation>
    </message>
    <message>
        <source>density, Essential graph</source>
        <translation>densité, graphe essentiel</translation>
    </message>
    <message>
        <source>transitions, motion graph</source>
        <translation>transitions, graphe de mouvement</translation>
    </message>
    <message>
        <source>density, motion graph</source>
        <translation>densité, graphe de mouvement</translation>
    </message>
    <message>
        <source>as set</source>
        <translation>tel que réglé</translation>
    </message>
    <message>
        <source>joined</source>
        <translation>jointes</translation>
    </message>
    <message>
        <source>as published</source>
        <translation>comme publié</translation>
    </message>
    <message>
        <source>joined, quantile</source>
        <translation>jointes, quantile</translation>
    </message>
    <message>
        <source>published, quantile</source>
        <translation>publié, quantile</translation>
    </message>
    <message>
        <source>published, joined</source>
        <translation>publié, jointes</translation>
    </message>
    <message>
        <source>published, joined, quantile</source>
        <translation>publié, jointes, quantile</translation>
    </message>
    <message>
        <source>interpolated</source>
        <translation>interpolées</translation>
    </message>
    <message>
        <source>rotations blended</source>
        <translation>rotations fondues</translation>
    </message>
    <message>
        <source>cost of acceleration</source>
        <translation>coût de l’accélération</translation>
    </message>
    <message>
        <source>cost for liveliness</source>
        <translation>coût selon la vivacité</translation>
    </message>
    <message>
        <source>path</source>
        <translation>chemin</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>secondes</translation>
    </message>
    <message>
        <source>transitions a second</source>
        <translation>transitions par seconde</translation>
    </message>
    <message>
        <source>shortest run</source>
        <translation>plus courte suite d’images</translation>
    </message>
    <message>
        <source>blended share</source>
        <translation>part fondue</translation>
    </message>
    <message>
        <source>share of other movements</source>
        <translation>part d’autres mouvements</translation>
    </message>
    <message>
        <source>mean deviation</source>
        <translation>écart moyen</translation>
    </message>
    <message>
        <source>greatest deviation</source>
        <translation>plus grand écart</translation>
    </message>
    <message>
        <source>foot slide of takes</source>
        <translation>glissement dans les prises</translation>
    </message>
    <message>
        <source>ratio of foot slide</source>
        <translation>rapport du glissement</translation>
    </message>
    <message>
        <source>change of speed</source>
        <translation>variation de vitesse</translation>
    </message>
    <message>
        <source>change of speed of takes</source>
        <translation>variation dans les prises</translation>
    </message>
    <message>
        <source>ratio of change of speed</source>
        <translation>rapport des variations</translation>
    </message>
    <message>
        <source>straight line</source>
        <translation>droite</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>cercle</translation>
    </message>
    <message>
        <source>right angle</source>
        <translation>angle droit</translation>
    </message>
    <message>
        <source>figure of eight</source>
        <translation>huit</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>variations</source>
        <translation>variations</translation>
    </message>
    <message>
        <source>of</source>
        <translation>de</translation>
    </message>
    <message>
        <source>asked</source>
        <translation>demandées</translation>
    </message>
    <message>
        <source>delivered</source>
        <translation>livrées</translation>
    </message>
    <message>
        <source>drawn</source>
        <translation>tirées</translation>
    </message>
    <message>
        <source>drawn from</source>
        <translation>tirée de</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>mauvaises</translation>
    </message>
    <message>
        <source>greatest acceleration</source>
        <translation>plus grande accélération</translation>
    </message>
    <message>
        <source>acceleration of the centre</source>
        <translation>accélération du centre</translation>
    </message>
    <message>
        <source>sink</source>
        <translation>enfoncement</translation>
    </message>
    <message>
        <source>hover</source>
        <translation>flottement</translation>
    </message>
    <message>
        <source>heading</source>
        <translation>cap</translation>
    </message>
    <message>
        <source>step of the take</source>
        <translation>pas de la prise</translation>
    </message>
    <message>
        <source>step</source>
        <translation>pas</translation>
    </message>
    <message>
        <source>spread of lengths</source>
        <translation>étendue des durées</translation>
    </message>
    <message>
        <source>closing</source>
        <translation>fermeture</translation>
    </message>
    <message>
        <source>part</source>
        <translation>partie</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>sommets</translation>
    </message>
    <message>
        <source>dimensions</source>
        <translation>dimensions</translation>
    </message>
    <message>
        <source>error of the model</source>
        <translation>erreur du modèle</translation>
    </message>
    <message>
        <source>error of principal components</source>
        <translation>erreur des composantes principales</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>rapport</translation>
    </message>
    <message>
        <source>weight across</source>
        <translation>poids en travers</translation>
    </message>
    <message>
        <source>from the takes</source>
        <translation>depuis les prises</translation>
    </message>
    <message>
        <source>from nearby</source>
        <translation>depuis les proches</translation>
    </message>
    <message>
        <source>gentle, feet corrected</source>
        <translation>doux, pieds corrigés</translation>
    </message>
    <message>
        <source>Euler angles</source>
        <translation>angles d’Euler</translation>
    </message>
    <message>
        <source>rotations</source>
        <translation>rotations</translation>
    </message>
    <message>
        <source>those furthest apart</source>
        <translation>les plus éloignées</translation>
    </message>
    <message>
        <source>rejected: far from all poses</source>
        <translation>rejetées : loin de toutes les poses</translation>
    </message>
    <message>
        <source>rejected: sliding feet</source>
        <translation>rejetées : pieds qui glissent</translation>
    </message>
    <message>
        <source>rejected: intersections</source>
        <translation>rejetées : intersections</translation>
    </message>
    <message>
        <source>rejected: volume</source>
        <translation>rejetées : volume</translation>
    </message>
    <message>
        <source>rejected: crumpled</source>
        <translation>rejetées : froissées</translation>
    </message>
    <message>
        <source>rejected: under the ground</source>
        <translation>rejetées : sous le sol</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>échelle</translation>
    </message>
    <message>
        <source>as many edges in both</source>
        <translation>autant d’arêtes dans les deux</translation>
    </message>
    <message>
        <source>by criterion</source>
        <translation>par critère</translation>
    </message>
    <message>
        <source>what foretells</source>
        <translation>ce qui prédit</translation>
    </message>
    <message>
        <source>summary</source>
        <translation>résumé</translation>
    </message>
    <message>
        <source>means</source>
        <translation>moyennes</translation>
    </message>
    <message>
        <source>ratio of acceleration</source>
        <translation>rapport des accélérations</translation>
    </message>
    <message>
        <source>ratio of frozen frames</source>
        <translation>rapport des images figées</translation>
    </message>
    <message>
        <source>ratio of the centre’s step</source>
        <translation>rapport du saut du centre</translation>
    </message>
    <message>
        <source>ratio of volume</source>
        <translation>rapport du volume</translation>
    </message>
    <message>
        <source>area, acceleration</source>
        <translation>aire, accélération</translation>
    </message>
    <message>
        <source>area, frozen frames</source>
        <translation>aire, images figées</translation>
    </message>
    <message>
        <source>area, centre’s step</source>
        <translation>aire, saut du centre</translation>
    </message>
    <message>
        <source>area, foot slide</source>
        <translation>aire, glissement</translation>
    </message>
    <message>
        <source>area, volume</source>
        <translation>aire, volume</translation>
    </message>
    <message>
        <source>kind</source>
        <translation>sorte</translation>
    </message>
    <message>
        <source>character</source>
        <translation>personnage</translation>
    </message>
    <message>
        <source>results</source>
        <translation>résultats</translation>
    </message>
    <message>
        <source>SSIM of textures</source>
        <translation>SSIM des textures</translation>
    </message>
    <message>
        <source>SSIM of textures, naive</source>
        <translation>SSIM des textures, naïf</translation>
    </message>
    <message>
        <source>deviation of SSIM of textures</source>
        <translation>écart-type, SSIM des textures</translation>
    </message>
    <message>
        <source>deviation of SSIM of textures, naive</source>
        <translation>écart-type, SSIM des textures, naïf</translation>
    </message>
    <message>
        <source>SSIM of pictures</source>
        <translation>SSIM des images</translation>
    </message>
    <message>
        <source>SSIM of pictures, naive</source>
        <translation>SSIM des images, naïf</translation>
    </message>
    <message>
        <source>deviation of SSIM of pictures</source>
        <translation>écart-type, SSIM des images</translation>
    </message>
    <message>
        <source>deviation of SSIM of pictures, naive</source>
        <translation>écart-type, SSIM des images, naïf</translation>
    </message>
    <message>
        <source>squared error of textures</source>
        <translation>erreur quadratique des textures</translation>
    </message>
    <message>
        <source>squared error of textures, naive</source>
        <translation>erreur quadratique des textures, naïf</translation>
    </message>
    <message>
        <source>deviation of squared error of textures</source>
        <translation>écart-type, erreur quadratique des textures</translation>
    </message>
    <message>
        <source>deviation of squared error of textures, naive</source>
        <translation>écart-type, erreur quadratique des textures, naïf</translation>
    </message>
    <message>
        <source>squared error of pictures</source>
        <translation>erreur quadratique des images</translation>
    </message>
    <message>
        <source>squared error of pictures, naive</source>
        <translation>erreur quadratique des images, naïf</translation>
    </message>
    <message>
        <source>deviation of squared error of pictures</source>
        <translation>écart-type, erreur quadratique des images</translation>
    </message>
    <message>
        <source>deviation of squared error of pictures, naive</source>
        <translation>écart-type, erreur quadratique des images, naïf</translation>
    </message>
    <message>
        <source>Eigen warps</source>
        <translation>déformations propres</translation>
    </message>
    <message>
        <source>Eigen textures</source>
        <translation>textures propres</translation>
    </message>
    <message>
        <source>compared</source>
        <translation>comparé</translation>
    </message>
    <message>
        <source>textures</source>
        <translation>textures</translation>
    </message>
    <message>
        <source>pictures</source>
        <translation>images</translation>
    </message>
    <message>
        <source>crossover</source>
        <translation>croisement</translation>
    </message>
    <message>
        <source>share learned from</source>
        <translation>part apprise</translation>
    </message>
    <message>
        <source>learned from</source>
        <translation>apprises</translation>
    </message>
    <message>
        <source>draws</source>
        <translation>tirages</translation>
    </message>
    <message>
        <source>SSIM</source>
        <translation>SSIM</translation>
    </message>
    <message>
        <source>squared error</source>
        <translation>erreur quadratique</translation>
    </message>
    <message>
        <source>frames to each side</source>
        <translation>images de chaque côté</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>différence</translation>
    </message>
    <message>
        <source>difference, linear</source>
        <translation>différence, linéaire</translation>
    </message>
    <message>
        <source>ratio of differences</source>
        <translation>rapport des différences</translation>
    </message>
    <message>
        <source>SSIM, linear</source>
        <translation>SSIM, linéaire</translation>
    </message>
    <message>
        <source>setting</source>
        <translation>réglage</translation>
    </message>
    <message>
        <source>bytes a frame</source>
        <translation>octets par image</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>octets</translation>
    </message>
    <message>
        <source>model</source>
        <translation>modèle</translation>
    </message>
    <message>
        <source>JPEG</source>
        <translation>JPEG</translation>
    </message>
    <message>
        <source>H.264</source>
        <translation>H.264</translation>
    </message>
    <message>
        <source>captured</source>
        <translation>capté</translation>
    </message>
    <message>
        <source>least</source>
        <translation>le moins</translation>
    </message>
    <message>
        <source>difference, nearest frame</source>
        <translation>différence, image la plus proche</translation>
    </message>
    <message>
        <source>difference, mean</source>
        <translation>différence, moyenne</translation>
    </message>
    <message>
        <source>difference, learned</source>
        <translation>différence, apprise</translation>
    </message>
    <message>
        <source>difference of warps, nearest frame</source>
        <translation>différence des déformations, image la plus proche</translation>
    </message>
    <message>
        <source>difference of warps, mean</source>
        <translation>différence des déformations, moyenne</translation>
    </message>
    <message>
        <source>difference of warps, learned</source>
        <translation>différence des déformations, apprise</translation>
    </message>
    <message>
        <source>SSIM, nearest frame</source>
        <translation>SSIM, image la plus proche</translation>
    </message>
    <message>
        <source>SSIM, mean</source>
        <translation>SSIM, moyenne</translation>
    </message>
    <message>
        <source>SSIM, learned</source>
        <translation>SSIM, apprise</translation>
    </message>
    <message>
        <source>squared error, nearest frame</source>
        <translation>erreur quadratique, image la plus proche</translation>
    </message>
    <message>
        <source>squared error, mean</source>
        <translation>erreur quadratique, moyenne</translation>
    </message>
    <message>
        <source>squared error, learned</source>
        <translation>erreur quadratique, apprise</translation>
    </message>
    <message>
        <source>transfer</source>
        <translation>transfert</translation>
    </message>
    <message>
        <source>quaternions</source>
        <translation>quaternions</translation>
    </message>
    <message>
        <source>logarithms</source>
        <translation>logarithmes</translation>
    </message>
    <message>
        <source>pose</source>
        <translation>pose</translation>
    </message>
    <message>
        <source>pose corrected</source>
        <translation>pose corrigée</translation>
    </message>
    <message>
        <source>pose as it is</source>
        <translation>pose telle quelle</translation>
    </message>
    <message>
        <source>mean error, share of the height</source>
        <translation>erreur moyenne, part de la hauteur</translation>
    </message>
    <message>
        <source>worst error, share of the height</source>
        <translation>pire erreur, part de la hauteur</translation>
    </message>
    <message>
        <source>mean error as placed, share of the height</source>
        <translation>erreur moyenne en place, part de la hauteur</translation>
    </message>
    <message>
        <source>worst error as placed, share of the height</source>
        <translation>pire erreur en place, part de la hauteur</translation>
    </message>
    <message>
        <source>worst error</source>
        <translation>pire erreur</translation>
    </message>
    <message>
        <source>mean error as placed</source>
        <translation>erreur moyenne en place</translation>
    </message>
    <message>
        <source>worst error as placed</source>
        <translation>pire erreur en place</translation>
    </message>
    <message>
        <source>volume of the truth</source>
        <translation>volume de la vérité</translation>
    </message>
    <message>
        <source>angle that pairs miss</source>
        <translation>angle que manquent les paires</translation>
    </message>
    <message>
        <source>foot slide of the truth</source>
        <translation>glissement des pieds de la vérité</translation>
    </message>
    <message>
        <source>stretched</source>
        <translation>avec étirement</translation>
    </message>
    <message>
        <source>turned only</source>
        <translation>rotations seules</translation>
    </message>
    <message>
        <source>what is about them</source>
        <translation>ce qui les entoure</translation>
    </message>
    <message>
        <source>pairs stand for</source>
        <translation>les paires valent pour</translation>
    </message>
    <message>
        <source>single triangles</source>
        <translation>des triangles seuls</translation>
    </message>
    <message>
        <source>motion space</source>
        <translation>espace de mouvement</translation>
    </message>
    <message>
        <source>references</source>
        <translation>références</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>arête</translation>
    </message>
    <message>
        <source>memory</source>
        <translation>mémoire</translation>
    </message>
    <message>
        <source>greatest error, share of the size</source>
        <translation>plus grande erreur, part de la taille</translation>
    </message>
    <message>
        <source>dissimilarity</source>
        <translation>dissemblance</translation>
    </message>
    <message>
        <source>mean latency</source>
        <translation>latence moyenne</translation>
    </message>
    <message>
        <source>median latency</source>
        <translation>latence médiane</translation>
    </message>
    <message>
        <source>latency, 95th percentile</source>
        <translation>latence, 95e centile</translation>
    </message>
    <message>
        <source>worst latency</source>
        <translation>pire latence</translation>
    </message>
    <message>
        <source>missed</source>
        <translation>manquées</translation>
    </message>
    <message>
        <source>target</source>
        <translation>cible</translation>
    </message>
    <message>
        <source>halvings</source>
        <translation>divisions en deux</translation>
    </message>
    <message>
        <source>found while playing</source>
        <translation>trouvée en jouant</translation>
    </message>
    <message>
        <source>responsive</source>
        <translation>réactive</translation>
    </message>
    <message>
        <source>1 computed before</source>
        <translation>1 calculée d’avance</translation>
    </message>
    <message>
        <source>5 computed before</source>
        <translation>5 calculées d’avance</translation>
    </message>
    <message>
        <source>10 computed before</source>
        <translation>10 calculées d’avance</translation>
    </message>
</context>
<context>
    <name>FrameKind</name>
    <message>
        <source>captured</source>
        <translation>captée</translation>
    </message>
    <message>
        <source>varied</source>
        <translation>variée</translation>
    </message>
    <message>
        <source>transition</source>
        <translation>transition</translation>
    </message>
</context>
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
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 ft</source>
        <translation>%1 ft</translation>
    </message>
    <message>
        <source>%1 in</source>
        <translation>%1 in</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
</context>
<context>
    <name>MeasureText</name>
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
    </message>
    <message>
        <source>%1 °/s</source>
        <translation>%1 °/s</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
</context>
<context>
    <name>QAbstractFileIconProvider</name>
    <message>
        <source>Folder</source>
        <comment>All other platforms</comment>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Disque</translation>
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
        <translation>Vérifiez le chemin, ou utilisez «&#xa0;Trouver les fichiers manquants&#xa0;» dans l’éditeur.</translation>
    </message>
    <message>
        <source>Put it back, or use “Find missing files” in the editor.</source>
        <translation>Remettez-le en place, ou utilisez «&#xa0;Trouver les fichiers manquants&#xa0;» dans l’éditeur.</translation>
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
        <translation>il ne commence pas par «&#xa0;ply&#xa0;»</translation>
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
        <translation>Animez un maillage avec lui et exportez celui-ci en GLB ou FBX&#xa0;; un BVH peut être nommé comme angles articulaires de référence d’une séquence.</translation>
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
        <translation>«&#xa0;{sequence} » a une autre topologie que «&#xa0;{first} »&#xa0;: {what}.</translation>
    </message>
    <message>
        <source>The sequences of a character share one topology; leave this one out.</source>
        <translation>Les séquences d’un personnage partagent une topologie&#xa0;; excluez celle-ci.</translation>
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
        <translation>Il n’y a pas de transition de l’image {source} à l’image {destination} : il faut {needed} images à partir de l’une et jusqu’à l’autre&#xa0;; leurs séquences en ont {after} et {before}.</translation>
    </message>
    <message>
        <source>Leave earlier, arrive later, or allow shorter windows.</source>
        <translation>Partez plus tôt, arrivez plus tard, ou permettez des fenêtres plus courtes.</translation>
    </message>
    <message>
        <source>The clip has {frames} frames; a loop needs at least {needed}.</source>
        <translation>Le clip a {frames} images&#xa0;; une boucle en demande au moins {needed}.</translation>
    </message>
    <message>
        <source>Take a longer clip, or allow shorter transitions.</source>
        <translation>Prenez un clip plus long, ou permettez des transitions plus courtes.</translation>
    </message>
    <message>
        <source>A loop needs to cut at least {needed} frames from each end of the clip, to blend them; {given} are allowed.</source>
        <translation>Une boucle doit couper au moins {needed} images à chaque bout du clip pour les fondre&#xa0;; {given} sont permises.</translation>
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
        <translation>Aucune symétrie gauche-droite du maillage n’a été trouvée&#xa0;: {share} % de ses sommets ont un vis-à-vis de l’autre côté.</translation>
    </message>
    <message>
        <source>Give a symmetry map, or an upright pose to find it in.</source>
        <translation>Donnez une carte de symétrie, ou une pose debout où la trouver.</translation>
    </message>
    <message>
        <source>The symmetry map does not fit the mesh: {reason}.</source>
        <translation>La carte de symétrie ne convient pas au maillage&#xa0;: {reason}.</translation>
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
        <translation>Les contacts se corrigent là où des jambes se détachent du corps&#xa0;; omettez cette étape.</translation>
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
        <translation>La clé {key} est hors d’atteinte&#xa0;: aucun parcours ne mène à l’image {frame}.</translation>
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
        <translation>Aucune image de ce personnage n’est «&#xa0;{name} ».</translation>
    </message>
    <message>
        <source>Label some, or ask for something else.</source>
        <translation>Étiquetez-en, ou demandez autre chose.</translation>
    </message>
    <message>
        <source>“{name}” cannot be performed: {share} % of a span are asked for, and no walk plays more than {most} %.</source>
        <translation>«&#xa0;{name} » ne peut être exécuté&#xa0;: {share} % d’un passage sont demandés, et aucun parcours n’en joue plus de {most} %.</translation>
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
        <translation>Le trajet commence dans «&#xa0;{name} », ou trop près.</translation>
    </message>
    <message>
        <source>Move one of them; the path is free from {free} m on.</source>
        <translation>Déplacez l’un des deux&#xa0;; le trajet est libre à partir de {free} m.</translation>
    </message>
    <message>
        <source>No walk was found that gets past “{name}” at {reached} m of the path.</source>
        <translation>Aucun parcours trouvé ne passe «&#xa0;{name} » à {reached} m du trajet.</translation>
    </message>
    <message>
        <source>Lead the path around it, leave more room, or search with a greater budget.</source>
        <translation>Contournez-le, laissez plus de place, ou cherchez avec un budget plus grand.</translation>
    </message>
    <message>
        <source>No walk was found that shows “{name}” from {from} m to {to} m of the path; the best one fails at {reached} m.</source>
        <translation>Aucun parcours trouvé ne montre «&#xa0;{name} » de {from} m à {to} m du trajet&#xa0;; le meilleur échoue à {reached} m.</translation>
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
        <translation>Dites combien de fois plus long est le résultat&#xa0;: 2 pour la moitié de la vitesse.</translation>
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
    <message>
        <source>the sound cannot be encoded</source>
        <translation>le son ne peut pas être encodé</translation>
    </message>
    <message>
        <source>The sound of this file</source>
        <translation>Le son de ce fichier</translation>
    </message>
    <message>
        <source>Save it as WAV.</source>
        <translation>Enregistrez-le en WAV.</translation>
    </message>
    <message>
        <source>Give it a path, keys or actions.</source>
        <translation>Donnez-lui un trajet, des clés ou des actions.</translation>
    </message>
    <message>
        <source>Break the circle.</source>
        <translation>Rompez le cercle.</translation>
    </message>
    <message>
        <source>Give some frames of a sequence this label.</source>
        <translation>Donnez cette étiquette à des images d’une séquence.</translation>
    </message>
    <message>
        <source>“{take}” has {count} frames; variations are learned from takes of {least} or more.</source>
        <translation>«&#xa0;{take} » a {count} images&#xa0;; les variations s’apprennent sur des prises d’au moins {least}.</translation>
    </message>
    <message>
        <source>Choose another take, or more of its frames.</source>
        <translation>Choisissez une autre prise, ou davantage de ses images.</translation>
    </message>
    <message>
        <source>The curve “{curve}” names vertex {vertex}, but the mesh has {vertices}.</source>
        <translation>La courbe «&#xa0;{curve} » nomme le sommet {vertex}, mais le maillage en a {vertices}.</translation>
    </message>
    <message>
        <source>It may come from another mesh; draw it again.</source>
        <translation>Elle vient peut-être d’un autre maillage&#xa0;; tracez-la à nouveau.</translation>
    </message>
    <message>
        <source>The curve “{curve}” has {found} vertices; a closed curve needs at least 3.</source>
        <translation>La courbe «&#xa0;{curve} » a {found} sommets&#xa0;; une courbe fermée en demande au moins 3.</translation>
    </message>
    <message>
        <source>Add points, or delete the curve.</source>
        <translation>Ajoutez des points ou supprimez la courbe.</translation>
    </message>
    <message>
        <source>The curve “{curve}” is open: no edge leads from vertex {from} to vertex {to}.</source>
        <translation>La courbe «&#xa0;{curve} » est ouverte&#xa0;: aucune arête ne mène du sommet {from} au sommet {to}.</translation>
    </message>
    <message>
        <source>Add points there. If it is open in many places, it may come from another mesh; draw it again.</source>
        <translation>Ajoutez-y des points. Si elle est ouverte en maints endroits, elle vient peut-être d’un autre maillage&#xa0;; tracez-la à nouveau.</translation>
    </message>
    <message>
        <source>The curve “{curve}” meets itself at vertex {vertex}.</source>
        <translation>La courbe «&#xa0;{curve} » se recoupe au sommet {vertex}.</translation>
    </message>
    <message>
        <source>Move the points near there apart.</source>
        <translation>Écartez les points voisins.</translation>
    </message>
    <message>
        <source>The curve “{curve}” meets the curve “{other}” at vertex {vertex}.</source>
        <translation>La courbe «&#xa0;{curve} » rencontre la courbe «&#xa0;{other} » au sommet {vertex}.</translation>
    </message>
    <message>
        <source>Move one of them away.</source>
        <translation>Éloignez l’une d’elles.</translation>
    </message>
    <message>
        <source>The curve “{curve}” does not cut the mesh in two.</source>
        <translation>La courbe «&#xa0;{curve} » ne coupe pas le maillage en deux.</translation>
    </message>
    <message>
        <source>Lead it once around a limb. Where a limb touches the body and has grown together with it, no curve can; take a mesh in another pose.</source>
        <translation>Menez-la une fois autour d’un membre. Là où un membre touche le corps et s’y est soudé, aucune courbe ne le peut&#xa0;; prenez un maillage dans une autre pose.</translation>
    </message>
    <message>
        <source>There are two curves “{curve}”.</source>
        <translation>Il y a deux courbes «&#xa0;{curve} ».</translation>
    </message>
    <message>
        <source>Rename one of them.</source>
        <translation>Renommez l’une d’elles.</translation>
    </message>
    <message>
        <source>The curve has a point at vertex {vertex} already.</source>
        <translation>La courbe a déjà un point au sommet {vertex}.</translation>
    </message>
    <message>
        <source>Choose another place, or drag that point.</source>
        <translation>Choisissez un autre endroit ou déplacez ce point.</translation>
    </message>
    <message>
        <source>Another curve passes through vertex {vertex}.</source>
        <translation>Une autre courbe passe par le sommet {vertex}.</translation>
    </message>
    <message>
        <source>Choose a place beside it.</source>
        <translation>Choisissez un endroit à côté.</translation>
    </message>
    <message>
        <source>Nothing leads from vertex {from} to vertex {to} but through other curves or this one.</source>
        <translation>Rien ne mène du sommet {from} au sommet {to} sans traverser d’autres courbes ou celle-ci.</translation>
    </message>
    <message>
        <source>Move the points, or the curves between them.</source>
        <translation>Déplacez les points ou les courbes qui les séparent.</translation>
    </message>
    <message>
        <source>There is no curve {distance} m beside this one: the surface ends before, or other curves are in the way.</source>
        <translation>Il n’y a pas de courbe à {distance} m de celle-ci&#xa0;: la surface finit avant, ou d’autres courbes barrent le chemin.</translation>
    </message>
    <message>
        <source>Choose a smaller distance.</source>
        <translation>Choisissez une distance plus petite.</translation>
    </message>
    <message>
        <source>This curve does not cut the mesh in two, so there is nothing to draw it tight around, and no side to lay another on.</source>
        <translation>Cette courbe ne coupe pas le maillage en deux&#xa0;: il n’y a rien autour de quoi la resserrer, ni de côté où en poser une autre.</translation>
    </message>
    <message>
        <source>Lead it once around a limb first.</source>
        <translation>Menez-la d’abord une fois autour d’un membre.</translation>
    </message>
    <message>
        <source>There are two parts “{part}”.</source>
        <translation>Il y a deux parties «&#xa0;{part} ».</translation>
    </message>
    <message>
        <source>Every part hangs on another one; the part that all others hang on is missing.</source>
        <translation>Chaque partie dépend d’une autre&#xa0;; il manque celle dont toutes dépendent.</translation>
    </message>
    <message>
        <source>Add it, with neither parent nor curves.</source>
        <translation>Ajoutez-la, sans parent ni courbes.</translation>
    </message>
    <message>
        <source>Both “{part}” and “{other}” have no parent.</source>
        <translation>Ni «&#xa0;{part} » ni «&#xa0;{other} » n’ont de parent.</translation>
    </message>
    <message>
        <source>Let one of them hang on another part.</source>
        <translation>Faites dépendre l’une d’elles d’une autre partie.</translation>
    </message>
    <message>
        <source>The part “{part}” hangs on “{parent}”, which does not exist.</source>
        <translation>La partie «&#xa0;{part} » dépend de «&#xa0;{parent} », qui n’existe pas.</translation>
    </message>
    <message>
        <source>Choose one of the parts that exist.</source>
        <translation>Choisissez une partie qui existe.</translation>
    </message>
    <message>
        <source>The part “{part}” hangs on itself, by way of others.</source>
        <translation>La partie «&#xa0;{part} » dépend d’elle-même par l’intermédiaire d’autres.</translation>
    </message>
    <message>
        <source>Choose another parent.</source>
        <translation>Choisissez un autre parent.</translation>
    </message>
    <message>
        <source>The part “{part}” has {found} curves; it needs {needed}.</source>
        <translation>La partie «&#xa0;{part} » a {found} courbes&#xa0;; il lui en faut {needed}.</translation>
    </message>
    <message>
        <source>A part that hangs on another has two, around what they share; the one that all hang on has none.</source>
        <translation>Une partie qui dépend d’une autre en a deux, autour de ce qu’elles partagent&#xa0;; celle dont toutes dépendent n’en a aucune.</translation>
    </message>
    <message>
        <source>The part “{part}” uses the curve “{curve}”, which does not exist.</source>
        <translation>La partie «&#xa0;{part} » emploie la courbe «&#xa0;{curve} », qui n’existe pas.</translation>
    </message>
    <message>
        <source>Draw it, or choose another.</source>
        <translation>Tracez-la ou choisissez-en une autre.</translation>
    </message>
    <message>
        <source>Both “{part}” and “{other}” use the curve “{curve}”.</source>
        <translation>«&#xa0;{part} » et «&#xa0;{other} » emploient toutes deux la courbe «&#xa0;{curve} ».</translation>
    </message>
    <message>
        <source>Give each part two curves of its own.</source>
        <translation>Donnez à chaque partie ses deux courbes.</translation>
    </message>
    <message>
        <source>The curves “{curve}” and “{other}” of the part “{part}” bound no ring together.</source>
        <translation>Les courbes «&#xa0;{curve} » et «&#xa0;{other} » de la partie «&#xa0;{part} » ne bordent pas un même anneau.</translation>
    </message>
    <message>
        <source>Draw both around the same limb, with no other curve between them.</source>
        <translation>Tracez-les autour du même membre, sans autre courbe entre elles.</translation>
    </message>
    <message>
        <source>The part “{part}” does not lie next to “{parent}”, on which it hangs.</source>
        <translation>La partie «&#xa0;{part} » n’est pas voisine de «&#xa0;{parent} », dont elle dépend.</translation>
    </message>
    <message>
        <source>Choose the part beyond its curves as parent.</source>
        <translation>Choisissez pour parent la partie au-delà de ses courbes.</translation>
    </message>
    <message>
        <source>The part “{part}” has no vertices beyond what it shares with others.</source>
        <translation>La partie «&#xa0;{part} » n’a pas de sommets en dehors de ceux qu’elle partage.</translation>
    </message>
    <message>
        <source>Move its curves away from the limb&apos;s end, or from other curves.</source>
        <translation>Éloignez ses courbes du bout du membre ou d’autres courbes.</translation>
    </message>
    <message>
        <source>No two arms and two legs were found: {found} limbs stick out.</source>
        <translation>Deux bras et deux jambes n’ont pas été trouvés&#xa0;: {found} membres dépassent.</translation>
    </message>
    <message>
        <source>Draw the curves by hand, or choose a pose in which arms and legs stick out.</source>
        <translation>Tracez les courbes à la main ou choisissez une pose où bras et jambes s’écartent.</translation>
    </message>
    <message>
        <source>No curve around “{limb}” cuts it off: it seems to touch another place of the body and to have grown together with it.</source>
        <translation>Aucune courbe autour de «&#xa0;{limb} » ne le détache&#xa0;: il semble toucher un autre endroit du corps et s’y être soudé.</translation>
    </message>
    <message>
        <source>Draw the other curves by hand, or take a mesh in a pose in which it touches nothing.</source>
        <translation>Tracez les autres courbes à la main ou prenez un maillage dans une pose où il ne touche rien.</translation>
    </message>
    <message>
        <source>No room for two curves around “{limb}” was found.</source>
        <translation>Aucune place n’a été trouvée pour deux courbes autour de «&#xa0;{limb} ».</translation>
    </message>
    <message>
        <source>Draw the curves by hand, or ask for narrower overlaps.</source>
        <translation>Tracez les courbes à la main ou demandez des recouvrements plus étroits.</translation>
    </message>
    <message>
        <source>There is no variation {number}: too few of those drawn were good enough.</source>
        <translation>Il n’y a pas de variation {number} : trop peu de celles tirées étaient assez bonnes.</translation>
    </message>
    <message>
        <source>Draw with another seed, or allow more in the limits.</source>
        <translation>Tirez avec une autre graine, ou élargissez les limites.</translation>
    </message>
    <message>
        <source>“{name}” is an input ({what}): inputs are never written over</source>
        <translation>«&#xa0;{name} » est une entrée ({what})&#xa0;: les entrées ne sont jamais écrasées</translation>
    </message>
    <message>
        <source>Write to another file.</source>
        <translation>Écrivez dans un autre fichier.</translation>
    </message>
    <message>
        <source>“{name}” would lie outside of the project&apos;s folder, {what}</source>
        <translation>«&#xa0;{name} » serait hors du dossier du projet, {what}</translation>
    </message>
    <message>
        <source>Choose a place inside, or allow this one (--allow-outside on the command line).</source>
        <translation>Choisissez un endroit à l’intérieur, ou permettez celui-ci (--allow-outside en ligne de commande).</translation>
    </message>
    <message>
        <source>“{name}” is written by {what}, too</source>
        <translation>«&#xa0;{name} » est aussi écrit par {what}</translation>
    </message>
    <message>
        <source>Give one of them another path.</source>
        <translation>Donnez un autre chemin à l’un des deux.</translation>
    </message>
    <message>
        <source>“{name}” is there already, and the program did not write it as it is</source>
        <translation>«&#xa0;{name} » existe déjà, et le programme ne l’a pas écrit tel qu’il est</translation>
    </message>
    <message>
        <source>Move it away, or allow to replace it (--overwrite on the command line).</source>
        <translation>Déplacez-le, ou permettez de le remplacer (--overwrite en ligne de commande).</translation>
    </message>
    <message>
        <source>Close it there first, or write all the same with --force.</source>
        <translation>Fermez-le d’abord là-bas, ou écrivez quand même avec --force.</translation>
    </message>
    <message>
        <source>“{name}” has a place for the number of a frame, but {format} is one file for all frames</source>
        <translation>«&#xa0;{name} » a une place pour le numéro d’une image, mais {format} est un seul fichier pour toutes les images</translation>
    </message>
    <message>
        <source>Leave the # out of the name.</source>
        <translation>Retirez les # du nom.</translation>
    </message>
    <message>
        <source>This is a device, not a file</source>
        <translation>C’est un périphérique, pas un fichier</translation>
    </message>
    <message>
        <source>This is a folder, not a file</source>
        <translation>C’est un dossier, pas un fichier</translation>
    </message>
    <message>
        <source>This is a pipe, not a file</source>
        <translation>C’est un tube, pas un fichier</translation>
    </message>
    <message>
        <source>This is a socket, not a file</source>
        <translation>C’est une socket, pas un fichier</translation>
    </message>
    <message>
        <source>Choose a file on a disk.</source>
        <translation>Choisissez un fichier sur un disque.</translation>
    </message>
    <message>
        <source>it is no HDF5 file, or a damaged one</source>
        <translation>ce n’est pas un fichier HDF5, ou il est endommagé</translation>
    </message>
    <message>
        <source>Something unexpected happened inside the program ({detail}).</source>
        <translation>Un imprévu s’est produit dans le programme ({detail}).</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>le disque est plein</translation>
    </message>
    <message>
        <source>the file would be larger than this disk allows</source>
        <translation>le fichier serait plus grand que ce disque ne le permet</translation>
    </message>
    <message>
        <source>the disk reports an error</source>
        <translation>le disque signale une erreur</translation>
    </message>
    <message>
        <source>the folder is not there any more</source>
        <translation>le dossier n’existe plus</translation>
    </message>
    <message>
        <source>a file stands where a folder should be</source>
        <translation>un fichier occupe la place d’un dossier</translation>
    </message>
    <message>
        <source>a folder stands where the file should be</source>
        <translation>un dossier occupe la place du fichier</translation>
    </message>
    <message>
        <source>the folder is not empty</source>
        <translation>le dossier n’est pas vide</translation>
    </message>
    <message>
        <source>too many files are open</source>
        <translation>trop de fichiers sont ouverts</translation>
    </message>
    <message>
        <source>its links lead round in a circle</source>
        <translation>ses liens tournent en rond</translation>
    </message>
    <message>
        <source>another program is using it</source>
        <translation>un autre programme l’utilise</translation>
    </message>
    <message>
        <source>the system is out of memory</source>
        <translation>le système n’a plus de mémoire</translation>
    </message>
    <message>
        <source>the network drive does not answer</source>
        <translation>le lecteur réseau ne répond pas</translation>
    </message>
    <message>
        <source>The name of this file, or of a folder on the way to it, is longer than the disk allows</source>
        <translation>Le nom de ce fichier, ou d’un dossier qui y mène, est plus long que le disque ne le permet</translation>
    </message>
    <message>
        <source>Choose a shorter name.</source>
        <translation>Choisissez un nom plus court.</translation>
    </message>
    <message>
        <source>This result cannot be stored anywhere and is kept in memory, until the program ends. Free some space, or choose another folder for results.</source>
        <translation>Ce résultat ne peut être enregistré nulle part et reste en mémoire jusqu’à la fin du programme. Libérez de la place, ou choisissez un autre dossier pour les résultats.</translation>
    </message>
    <message>
        <source>it could not be written to its end</source>
        <translation>il n’a pas pu être écrit jusqu’au bout</translation>
    </message>
    <message>
        <source>Free some space, or choose another folder for results.</source>
        <translation>Libérez de la place, ou choisissez un autre dossier pour les résultats.</translation>
    </message>
    <message>
        <source>Add the takes of its character under “sequences”.</source>
        <translation>Ajoutez les prises de son personnage sous «&#xa0;sequences ».</translation>
    </message>
    <message>
        <source>a part of the file is damaged</source>
        <translation>une partie du fichier est endommagée</translation>
    </message>
    <message>
        <source>Ask for a shorter one, or lower the rate of the project.</source>
        <translation>Demandez plus court, ou baissez la cadence du projet.</translation>
    </message>
    <message>
        <source>Leave some takes or parts of them out, or lower the rate of the project.</source>
        <translation>Laissez de côté des prises ou des parties de prises, ou baissez la cadence du projet.</translation>
    </message>
    <message>
        <source>The character has no feet that could be told apart: contacts are not corrected.</source>
        <translation>Le personnage n’a pas de pieds que l’on distingue&#xa0;: les appuis ne sont pas corrigés.</translation>
    </message>
    <message>
        <source>The result “{stage}” was replaced while it was being used.</source>
        <translation>Le résultat «&#xa0;{stage}&#xa0;» a été remplacé pendant qu’il servait.</translation>
    </message>
    <message>
        <source>Another rebuild of the project is under way; try again once it is done.</source>
        <translation>Une autre reconstruction du projet est en cours&#xa0;; réessayez quand elle sera finie.</translation>
    </message>
    <message>
        <source>No walk gets past “{name}” at {reached} m of the path; every way was tried.</source>
        <translation>Aucun parcours ne passe «&#xa0;{name}&#xa0;» à {reached} m du trajet&#xa0;; toutes les voies ont été essayées.</translation>
    </message>
    <message>
        <source>Lead the path around it, or leave more room.</source>
        <translation>Menez le trajet autour, ou laissez plus de place.</translation>
    </message>
    <message>
        <source>No walk shows “{name}” from {from} m to {to} m of the path; the best one fails at {reached} m, and every way was tried.</source>
        <translation>Aucun parcours ne montre «&#xa0;{name}&#xa0;» de {from} m à {to} m du trajet&#xa0;; le meilleur échoue à {reached} m, et toutes les voies ont été essayées.</translation>
    </message>
    <message>
        <source>End the span at {reached} m, or demand other frames.</source>
        <translation>Terminez le segment à {reached} m, ou demandez d’autres images.</translation>
    </message>
    <message>
        <source>No walk does all that is asked at once; every way was tried.</source>
        <translation>Aucun parcours ne fait à la fois tout ce qui est demandé&#xa0;; toutes les voies ont été essayées.</translation>
    </message>
    <message>
        <source>Take back a chosen, locked or banned transition, or ask for less.</source>
        <translation>Annulez une transition choisie, verrouillée ou interdite, ou demandez moins.</translation>
    </message>
    <message>
        <source>An AVI film cannot be larger than 4 GB</source>
        <translation>Un film AVI ne peut pas dépasser 4 Go</translation>
    </message>
    <message>
        <source>Write MP4, or fewer frames.</source>
        <translation>Écrivez du MP4, ou moins d’images.</translation>
    </message>
    <message>
        <source>the encoder of H.264 gives up</source>
        <translation>l’encodeur H.264 abandonne</translation>
    </message>
    <message>
        <source>An MP4 film has at least 16 × 16 pixels</source>
        <translation>Un film MP4 a au moins 16 × 16 pixels</translation>
    </message>
    <message>
        <source>Choose a larger size.</source>
        <translation>Choisissez une taille plus grande.</translation>
    </message>
    <message>
        <source>An MP4 film has at most as many pixels as 4096 × 2304</source>
        <translation>Un film MP4 a au plus autant de pixels que 4096 × 2304</translation>
    </message>
    <message>
        <source>Choose a smaller size, or write PNG pictures.</source>
        <translation>Choisissez une taille plus petite, ou écrivez des images PNG.</translation>
    </message>
    <message>
        <source>The sides of an MP4 film are even</source>
        <translation>Les côtés d’un film MP4 sont pairs</translation>
    </message>
    <message>
        <source>Choose even numbers of pixels.</source>
        <translation>Choisissez des nombres pairs de pixels.</translation>
    </message>
    <message>
        <source>it is no model of appearance</source>
        <translation>ce n’est pas un modèle d’apparence</translation>
    </message>
    <message>
        <source>Give all textures of the character one size.</source>
        <translation>Donnez la même taille à toutes les textures du personnage.</translation>
    </message>
    <message>
        <source>Give it one for each frame, or leave the sequence out.</source>
        <translation>Donnez-lui-en une par image, ou omettez la séquence.</translation>
    </message>
    <message>
        <source>Give sequences a folder of textures, one for each frame.</source>
        <translation>Donnez aux séquences un dossier de textures, une par image.</translation>
    </message>
    <message>
        <source>Name another one, or leave it out.</source>
        <translation>Nommez-en une autre, ou omettez-la.</translation>
    </message>
    <message>
        <source>Give it the size of the textures.</source>
        <translation>Donnez-lui la taille des textures.</translation>
    </message>
    <message>
        <source>GLB cannot change textures: it shows that of the first frame, and those of all frames are beside it, in {path}.</source>
        <translation>GLB ne peut pas changer de texture&#xa0;: il montre celle de la première image, et celles de toutes les images sont à côté, dans {path}.</translation>
    </message>
    <message>
        <source>Give it one, or take it out of the completions.</source>
        <translation>Donnez-lui-en une, ou retirez-la des compléments.</translation>
    </message>
    <message>
        <source>the decoder of H.264 gives up</source>
        <translation>le décodeur H.264 abandonne</translation>
    </message>
    <message>
        <source>Give it sequences with more frames.</source>
        <translation>Donnez-lui des séquences de plus d’images.</translation>
    </message>
    <message>
        <source>Give it a second sequence with a texture for each frame.</source>
        <translation>Donnez-lui une deuxième séquence avec une texture par image.</translation>
    </message>
    <message>
        <source>No triangles are paired.</source>
        <translation>Aucun triangle n’est apparié.</translation>
    </message>
    <message>
        <source>Pair triangles of the template with those of the target.</source>
        <translation>Appariez des triangles du gabarit avec ceux de la cible.</translation>
    </message>
    <message>
        <source>Pair {pair} names triangle {triangle} of the template, which has only {count}.</source>
        <translation>La paire {pair} désigne le triangle {triangle} du gabarit, qui n’en a que {count}.</translation>
    </message>
    <message>
        <source>Pair it again: the mesh has changed.</source>
        <translation>Refaites la paire : le maillage a changé.</translation>
    </message>
    <message>
        <source>Pair {pair} names triangle {triangle} of the target, which has only {count}.</source>
        <translation>La paire {pair} désigne le triangle {triangle} de la cible, qui n’en a que {count}.</translation>
    </message>
    <message>
        <source>Triangle {triangle} of the target is in two pairs.</source>
        <translation>Le triangle {triangle} de la cible figure dans deux paires.</translation>
    </message>
    <message>
        <source>Remove one of them.</source>
        <translation>Retirez l’une d’elles.</translation>
    </message>
    <message>
        <source>Triangle {triangle} of the target has no area.</source>
        <translation>Le triangle {triangle} de la cible n’a pas d’aire.</translation>
    </message>
    <message>
        <source>Pair one beside it.</source>
        <translation>Appariez-en un voisin.</translation>
    </message>
    <message>
        <source>No two arms and two legs were found on the template, by which pairs of triangles could be proposed.</source>
        <translation>Deux bras et deux jambes n’ont pas été trouvés sur le gabarit, d’après lesquels des paires de triangles pourraient être proposées.</translation>
    </message>
    <message>
        <source>Pair triangles by hand, or take a pose in which arms and legs stick out.</source>
        <translation>Appariez des triangles à la main, ou prenez une pose où bras et jambes se détachent du corps.</translation>
    </message>
    <message>
        <source>No two arms and two legs were found on the target, by which pairs of triangles could be proposed.</source>
        <translation>Deux bras et deux jambes n’ont pas été trouvés sur la cible, d’après lesquels des paires de triangles pourraient être proposées.</translation>
    </message>
    <message>
        <source>Name a clip of the target&apos;s own mesh as “truth”.</source>
        <translation>Nommez comme « truth » un clip du propre maillage de la cible.</translation>
    </message>
    <message>
        <source>Name a clip that shows the same frame by frame as “truth”.</source>
        <translation>Nommez comme « truth » un clip qui montre la même chose image par image.</translation>
    </message>
    <message>
        <source>Make one of some takes.</source>
        <translation>Faites-en un de quelques prises.</translation>
    </message>
    <message>
        <source>a clip, only the motion spaces of a performance (“live/NAME”)</source>
        <translation>un clip, seulement les espaces de mouvement d’une performance (« live/NOM »)</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 images</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 octets</translation>
    </message>
    <message>
        <source>at least %1 bytes</source>
        <translation>au moins %1 octets</translation>
    </message>
    <message>
        <source>a header of %1 bytes</source>
        <translation>un en-tête de %1 octets</translation>
    </message>
    <message>
        <source>the header says %1 frames</source>
        <translation>l’en-tête dit %1 images</translation>
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
        <translation>Un éditeur pour la capture de performances en 4D&#xa0;: il tire de nouvelles performances de celles qui ont été captées.</translation>
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
    <name>quadrille::AcrossFields</name>
    <message>
        <source>Vary a blend of four</source>
        <translation>Varier un mélange de quatre</translation>
    </message>
    <message>
        <source>Change the weights of a blend</source>
        <translation>Changer les poids d’un mélange</translation>
    </message>
    <message>
        <source>The take across from the first: four takes make a square with two weights</source>
        <translation>La prise en face de la première&#xa0;: quatre prises font un carré à deux poids</translation>
    </message>
    <message>
        <source>Across from the second take</source>
        <translation>En face de la seconde prise</translation>
    </message>
    <message>
        <source>The take across from the second</source>
        <translation>La prise en face de la seconde</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Poids</translation>
    </message>
    <message>
        <source>Drag to where variations lie between the four takes; arrows move by 1 %, with Shift by 10 %. Dots are blends that are learned.</source>
        <translation>Glissez le point là où les variations se tiennent entre les quatre prises&#xa0;; les flèches le déplacent de 1 %, avec Maj de 10 %. Les points sont des mélanges appris.</translation>
    </message>
    <message>
        <source>Upwards</source>
        <translation>Vers le haut</translation>
    </message>
    <message>
        <source>Weight of the second pair in percent</source>
        <translation>Poids de la seconde paire en pour cent</translation>
    </message>
    <message>
        <source> %</source>
        <comment>percent</comment>
        <translation> %</translation>
    </message>
    <message>
        <source>Learn this square</source>
        <translation>Apprendre ce carré</translation>
    </message>
    <message>
        <source>Learn from blends of the four takes, too: on the edges of the square and inside</source>
        <translation>Apprendre aussi de mélanges des quatre prises&#xa0;: sur les bords du carré et à l’intérieur</translation>
    </message>
    <message>
        <source>nothing: two takes alone</source>
        <translation>rien&#xa0;: deux prises seules</translation>
    </message>
    <message>
        <source>Learn a square of blends</source>
        <translation>Apprendre un carré de mélanges</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>En face</translation>
    </message>
</context>
<context>
    <name>quadrille::ActionForm</name>
    <message>
        <source>Change how often an action is performed</source>
        <translation>Changer combien de fois une action est jouée</translation>
    </message>
    <message>
        <source>Change the duration of an action</source>
        <translation>Changer la durée d’une action</translation>
    </message>
    <message>
        <source>Change how much of an action is played</source>
        <translation>Changer la part jouée d’une action</translation>
    </message>
    <message>
        <source>Change the frames of an action</source>
        <translation>Changer les images d’une action</translation>
    </message>
    <message>
        <source>No card selected</source>
        <translation>Aucune carte sélectionnée</translation>
    </message>
    <message>
        <source>Label “%1”</source>
        <translation>Étiquette «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Drag the ends to choose the frames; ← and → move the active end by a frame</source>
        <translation>Glissez les bouts pour choisir les images&#xa0;; ← et → déplacent le bout actif d’une image</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Fois</translation>
    </message>
    <message>
        <source> ×</source>
        <translation> ×</translation>
    </message>
    <message>
        <source>How often it is performed</source>
        <translation>Combien de fois elle est jouée</translation>
    </message>
    <message>
        <source>Goes on for</source>
        <translation>Dure</translation>
    </message>
    <message>
        <source>It goes on for a time, with any of its frames in any order</source>
        <translation>Elle dure un temps, avec n’importe lesquelles de ses images dans n’importe quel ordre</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>At least</source>
        <translation>Au moins</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>How much of the frames must be played; the rest may be left out at both ends to join it better</source>
        <translation>Combien de ses images doivent être jouées&#xa0;; le reste peut être omis aux deux bouts pour mieux joindre</translation>
    </message>
    <message>
        <source>First and last frame of the take that are played</source>
        <translation>Première et dernière image de la prise qui sont jouées</translation>
    </message>
</context>
<context>
    <name>quadrille::AlternativesList</name>
    <message>
        <source>Transition</source>
        <translation>Transition</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Poids</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Slide</source>
        <comment>of feet, a speed</comment>
        <translation>Gliss.</translation>
    </message>
    <message>
        <source>Jump</source>
        <comment>of the speed</comment>
        <translation>Saut</translation>
    </message>
    <message>
        <source>Deformation and duration together</source>
        <translation>Déformation et durée ensemble</translation>
    </message>
    <message>
        <source>How many frames it lasts</source>
        <translation>Combien d’images elle dure</translation>
    </message>
    <message>
        <source>How fast standing feet slide meanwhile, in metres a second</source>
        <translation>À quelle vitesse les pieds posés glissent pendant ce temps, en mètres par seconde</translation>
    </message>
    <message>
        <source>How much the body’s velocity over the ground changes from before to behind it, in metres a second</source>
        <translation>De combien la vitesse du corps au-dessus du sol change entre avant et après, en mètres par seconde</translation>
    </message>
</context>
<context>
    <name>quadrille::AnimateWorkspace</name>
    <message>
        <source>Path</source>
        <translation>Trajet</translation>
    </message>
    <message>
        <source>Transitions</source>
        <translation>Transitions</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Finition</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Import sequences first: animations are made from them.</source>
        <translation>Importez d’abord des séquences&#xa0;: les animations en sont faites.</translation>
    </message>
    <message>
        <source>No animation yet.</source>
        <translation>Pas encore d’animation.</translation>
    </message>
    <message>
        <source>Draw a path, drop poses onto the timeline, or line up takes in the storyboard.</source>
        <translation>Tracez un trajet, déposez des poses sur la ligne de temps, ou alignez des prises dans le scénario.</translation>
    </message>
    <message>
        <source>Computing the graph of transitions…</source>
        <translation>Calcul du graphe des transitions…</translation>
    </message>
    <message>
        <source>Seeking a walk…</source>
        <translation>Recherche d’un parcours…</translation>
    </message>
    <message>
        <source>This is what another transition would be like.</source>
        <translation>Voici ce que serait une autre transition.</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Réessayer</translation>
    </message>
    <message>
        <source>Return takes it; Escape goes back to the clip.</source>
        <translation>Entrée la prend&#xa0;; Échap revient au clip.</translation>
    </message>
</context>
<context>
    <name>quadrille::AnimationBar</name>
    <message>
        <source>Animation</source>
        <translation>Animation</translation>
    </message>
    <message>
        <source>The animation that is worked on</source>
        <translation>L’animation sur laquelle on travaille</translation>
    </message>
    <message>
        <source>No animation</source>
        <translation>Aucune animation</translation>
    </message>
    <message>
        <source>Animate</source>
        <translation>Animer</translation>
    </message>
    <message>
        <source>&amp;New animation</source>
        <translation>&amp;Nouvelle animation</translation>
    </message>
    <message>
        <source>Add an animation to the project</source>
        <translation>Ajouter une animation au projet</translation>
    </message>
    <message>
        <source>&amp;Duplicate the animation</source>
        <translation>&amp;Dupliquer l’animation</translation>
    </message>
    <message>
        <source>Add a copy of the animation, to try something else with it</source>
        <translation>Ajouter une copie de l’animation, pour essayer autre chose</translation>
    </message>
    <message>
        <source>Seek a&amp;gain</source>
        <translation>&amp;Chercher encore</translation>
    </message>
    <message>
        <source>Seek the walk again after it was stopped or failed</source>
        <translation>Chercher de nouveau le parcours après un arrêt ou un échec</translation>
    </message>
    <message>
        <source>&amp;Stop seeking</source>
        <translation>&amp;Arrêter la recherche</translation>
    </message>
    <message>
        <source>Keep the best walk that was found so far</source>
        <translation>Garder le meilleur parcours trouvé jusqu’ici</translation>
    </message>
    <message>
        <source>Add an animation, then draw a path, drop poses or line up takes.</source>
        <translation>Ajoutez une animation, puis un trajet, des poses ou des prises.</translation>
    </message>
    <message>
        <source>Waiting for the graph…</source>
        <translation>En attente du graphe…</translation>
    </message>
    <message>
        <source>Seeking a walk…</source>
        <translation>Recherche d’un parcours…</translation>
    </message>
    <message>
        <source>Seeking a better walk… %1</source>
        <translation>Recherche d’un meilleur parcours… %1</translation>
    </message>
    <message>
        <source>No walk was found.</source>
        <translation>Aucun parcours n’a été trouvé.</translation>
    </message>
    <message>
        <source>Stopped. %1</source>
        <translation>Arrêté. %1</translation>
    </message>
    <message numerus="yes">
        <source>%1 s, %n transitions</source>
        <translation>
            <numerusform>%1 s, %n transition</numerusform>
            <numerusform>%1 s, %n transitions</numerusform>
        </translation>
    </message>
    <message>
        <source>, cost %1</source>
        <translation>, coût %1</translation>
    </message>
    <message>
        <source>, proven best</source>
        <translation>, prouvé le meilleur</translation>
    </message>
    <message>
        <source>, cost %1 m²</source>
        <translation>, coût %1&#xa0;m²</translation>
    </message>
    <message>
        <source>, proven best from key to key</source>
        <translation>, prouvé le meilleur d’une clé à l’autre</translation>
    </message>
</context>
<context>
    <name>quadrille::AnimationCamera</name>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>No camera keys: double-click to keep what you see as one</source>
        <translation>Pas de clé de caméra&#xa0;: double-cliquez pour retenir ce que vous voyez</translation>
    </message>
    <message>
        <source>Animate</source>
        <translation>Animer</translation>
    </message>
    <message>
        <source>Add &amp;camera key</source>
        <translation>Ajouter une clé de &amp;caméra</translation>
    </message>
    <message>
        <source>Keep what the view shows now, at the playhead, for pictures and videos</source>
        <translation>Retenir ce que montre la vue, à la tête de lecture, pour les images et vidéos</translation>
    </message>
    <message>
        <source>Replace camera key</source>
        <translation>Remplacer la clé de caméra</translation>
    </message>
    <message>
        <source>Make the chosen camera key what the view shows now</source>
        <translation>Faire de la clé de caméra choisie ce que montre la vue</translation>
    </message>
    <message>
        <source>Remove camera key</source>
        <translation>Retirer la clé de caméra</translation>
    </message>
    <message>
        <source>Take the chosen camera key away</source>
        <translation>Enlever la clé de caméra choisie</translation>
    </message>
    <message>
        <source>&amp;Look through the camera</source>
        <translation>&amp;Regarder par la caméra</translation>
    </message>
    <message>
        <source>Let the view follow the camera keys while the clip plays</source>
        <translation>Faire suivre les clés de caméra à la vue pendant la lecture</translation>
    </message>
    <message>
        <source>Add camera key</source>
        <translation>Ajouter une clé de caméra</translation>
    </message>
    <message>
        <source>Move camera key</source>
        <translation>Déplacer la clé de caméra</translation>
    </message>
</context>
<context>
    <name>quadrille::AnimationEdits</name>
    <message>
        <source>Add animation “%1”</source>
        <translation>Ajouter l’animation «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Duplicate “%1”</source>
        <translation>Dupliquer «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>quadrille::AnimationPage</name>
    <message>
        <source>Whose sequences the animation is made of</source>
        <translation>Celui dont les séquences font l’animation</translation>
    </message>
    <message>
        <source>Asked for</source>
        <translation>Demandé</translation>
    </message>
    <message>
        <source>Afterwards</source>
        <translation>Ensuite</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Change the character of “%1”</source>
        <translation>Changer le personnage de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>nothing: its walk was accepted</source>
        <translation>rien&#xa0;: son parcours a été accepté</translation>
    </message>
    <message numerus="yes">
        <source>%n path(s)</source>
        <translation>
            <numerusform>%n trajet</numerusform>
            <numerusform>%n trajets</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n key(s)</source>
        <translation>
            <numerusform>%n clé</numerusform>
            <numerusform>%n clés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n action(s)</source>
        <translation>
            <numerusform>%n action</numerusform>
            <numerusform>%n actions</numerusform>
        </translation>
    </message>
    <message>
        <source>nothing yet</source>
        <translation>rien encore</translation>
    </message>
    <message numerus="yes">
        <source>looped, played %n times</source>
        <translation>
            <numerusform>bouclé, joué %n fois</numerusform>
            <numerusform>bouclé, joué %n fois</numerusform>
        </translation>
    </message>
    <message>
        <source>looped</source>
        <translation>bouclé</translation>
    </message>
    <message>
        <source>foot contacts corrected</source>
        <translation>contacts des pieds corrigés</translation>
    </message>
    <message>
        <source>mirrored</source>
        <translation>reflété</translation>
    </message>
    <message>
        <source>retimed</source>
        <translation>retemporisé</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>rien</translation>
    </message>
    <message>
        <source>made when its workspace is open</source>
        <translation>fait quand son espace est ouvert</translation>
    </message>
    <message numerus="yes">
        <source>%n frames, %1 s</source>
        <translation>
            <numerusform>%n image, %1 s</numerusform>
            <numerusform>%n images, %1 s</numerusform>
        </translation>
    </message>
    <message>
        <source>repeats varied</source>
        <translation>reprises variées</translation>
    </message>
</context>
<context>
    <name>quadrille::AnimationReport</name>
    <message>
        <source>s</source>
        <comment>seconds</comment>
        <translation>s</translation>
    </message>
    <message>
        <source>cm</source>
        <comment>centimetres</comment>
        <translation>cm</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Duration before finishing</source>
        <translation>Durée avant la finition</translation>
    </message>
    <message>
        <source>Transitions</source>
        <translation>Transitions</translation>
    </message>
    <message>
        <source>Cost of all edges</source>
        <translation>Coût de toutes les arêtes</translation>
    </message>
    <message>
        <source>Cost of timing</source>
        <translation>Coût des temps</translation>
    </message>
    <message>
        <source>Cost of deviation</source>
        <translation>Coût de l’écart</translation>
    </message>
    <message>
        <source>m²</source>
        <comment>square metres</comment>
        <translation>m²</translation>
    </message>
    <message>
        <source>Total cost</source>
        <translation>Coût total</translation>
    </message>
    <message>
        <source>States looked at</source>
        <translation>États examinés</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>not proven</source>
        <translation>non prouvé</translation>
    </message>
    <message>
        <source>still seeking</source>
        <translation>en cours</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Clé</translation>
    </message>
    <message>
        <source>Path length</source>
        <translation>Longueur du trajet</translation>
    </message>
    <message>
        <source>m</source>
        <comment>metres</comment>
        <translation>m</translation>
    </message>
    <message>
        <source>Mean deviation</source>
        <translation>Écart moyen</translation>
    </message>
    <message>
        <source>Greatest deviation</source>
        <translation>Écart maximal</translation>
    </message>
    <message>
        <source>Span from</source>
        <translation>Portion à partir de</translation>
    </message>
    <message>
        <source>Span lasts</source>
        <translation>Portion&#xa0;: durée</translation>
    </message>
    <message>
        <source>Action from</source>
        <translation>Action à partir de</translation>
    </message>
    <message>
        <source>Action lasts</source>
        <translation>Action&#xa0;: durée</translation>
    </message>
    <message>
        <source>Repeats drawn from variations</source>
        <translation>Reprises tirées de variations</translation>
    </message>
    <message>
        <source>Their weight μ</source>
        <translation>Leur poids μ</translation>
    </message>
    <message>
        <source>Weight β of a frame</source>
        <translation>Poids β d’une image</translation>
    </message>
    <message>
        <source>from key to key</source>
        <translation>d’une clé à l’autre</translation>
    </message>
    <message>
        <source>Proven best in the Essential graph</source>
        <translation>Meilleur prouvé dans le graphe essentiel</translation>
    </message>
    <message>
        <source>Lower bound of the cost</source>
        <translation>Borne inférieure du coût</translation>
    </message>
</context>
<context>
    <name>quadrille::AnimationResults</name>
    <message>
        <source>Animation “%1”</source>
        <translation>Animation «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>quadrille::AnimationSound</name>
    <message>
        <source>Animate</source>
        <translation>Animer</translation>
    </message>
    <message>
        <source>Choose soun&amp;d…</source>
        <translation>Choisir un &amp;son…</translation>
    </message>
    <message>
        <source>Let a sound be heard with the animation, and in its videos</source>
        <translation>Faire entendre un son avec l’animation, et dans ses vidéos</translation>
    </message>
    <message>
        <source>&amp;Mute</source>
        <translation>&amp;Muet</translation>
    </message>
    <message>
        <source>Play in silence here; videos keep their sound</source>
        <translation>Lire ici en silence&#xa0;; les vidéos gardent leur son</translation>
    </message>
    <message>
        <source>Remove the sound</source>
        <translation>Retirer le son</translation>
    </message>
    <message>
        <source>Take the sound away from the animation; its file stays</source>
        <translation>Enlever le son de l’animation&#xa0;; son fichier reste</translation>
    </message>
    <message>
        <source>Choose a sound</source>
        <translation>Choisir un son</translation>
    </message>
    <message>
        <source>Sounds (*.wav *.flac *.aif *.aiff *.ogg *.mp3);;All files (*)</source>
        <translation>Sons (*.wav *.flac *.aif *.aiff *.ogg *.mp3);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Choose the sound</source>
        <translation>Choisir le son</translation>
    </message>
    <message>
        <source>Move the sound</source>
        <translation>Déplacer le son</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lecture de %1</translation>
    </message>
    <message>
        <source>No sound: click to choose a WAV file</source>
        <translation>Pas de son&#xa0;: cliquez pour choisir un fichier WAV</translation>
    </message>
    <message>
        <source>Reading the sound…</source>
        <translation>Lecture du son…</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Son</translation>
    </message>
</context>
<context>
    <name>quadrille::AnimationTimeline</name>
    <message>
        <source>Add key</source>
        <translation>Ajouter une clé</translation>
    </message>
    <message>
        <source>Remove key</source>
        <translation>Retirer une clé</translation>
    </message>
    <message>
        <source>Move key</source>
        <translation>Déplacer une clé</translation>
    </message>
    <message>
        <source>Go to key</source>
        <translation>Aller à la pose</translation>
    </message>
    <message>
        <source>Edit key</source>
        <translation>Modifier la pose</translation>
    </message>
    <message>
        <source>Inspect transition</source>
        <translation>Examiner la transition</translation>
    </message>
    <message>
        <source>Edit note</source>
        <translation>Modifier la note</translation>
    </message>
    <message>
        <source>Remove note</source>
        <translation>Retirer la note</translation>
    </message>
    <message>
        <source>Add the shown pose as key here</source>
        <translation>Ajouter ici la pose affichée comme pose clé</translation>
    </message>
</context>
<context>
    <name>quadrille::AnimationTracks</name>
    <message>
        <source>Keys</source>
        <translation>Clés</translation>
    </message>
    <message>
        <source>Drag the picture of a card here to ask for its pose at a time</source>
        <translation>Glissez ici l’image d’une carte pour demander sa pose à un moment</translation>
    </message>
    <message>
        <source>Made afterwards</source>
        <translation>Fait après coup</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Clip</translation>
    </message>
    <message>
        <source>Actions</source>
        <translation>Actions</translation>
    </message>
    <message>
        <source>Path asks</source>
        <translation>Trajet</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1, drawn from %2</source>
        <comment>frames, a variation</comment>
        <translation>%1, tiré de %2</translation>
    </message>
    <message>
        <source>%1, cost %2</source>
        <comment>a transition</comment>
        <translation>%1, coût %2</translation>
    </message>
    <message>
        <source>What is found is shown here</source>
        <translation>Ce qui est trouvé s’affiche ici</translation>
    </message>
</context>
<context>
    <name>quadrille::AppearanceBar</name>
    <message>
        <source>Appearance</source>
        <translation>Apparence</translation>
    </message>
    <message>
        <source>&amp;New model of textures</source>
        <translation>&amp;Nouveau modèle de textures</translation>
    </message>
    <message>
        <source>Add a model of the character’s textures to the project</source>
        <translation>Ajouter au projet un modèle des textures du personnage</translation>
    </message>
    <message>
        <source>&amp;Duplicate the model of textures</source>
        <translation>&amp;Dupliquer le modèle de textures</translation>
    </message>
    <message>
        <source>Add a copy, to compute it with other settings</source>
        <translation>Ajouter une copie, à calculer avec d’autres réglages</translation>
    </message>
    <message>
        <source>&amp;Build</source>
        <translation>&amp;Construire</translation>
    </message>
    <message>
        <source>Computes Eigen textures and Eigen warps of all textures</source>
        <translation>Calcule les textures et les déformations propres de toutes les textures</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>Ends the computation; flows that are done need not be computed again</source>
        <translation>Arrête le calcul ; les flots déjà faits ne seront pas recalculés</translation>
    </message>
    <message>
        <source>Models of textures</source>
        <translation>Modèles de textures</translation>
    </message>
    <message>
        <source>The model of textures that is worked on</source>
        <translation>Le modèle de textures sur lequel on travaille</translation>
    </message>
    <message>
        <source>No model</source>
        <translation>Aucun modèle</translation>
    </message>
    <message>
        <source>Completing textures…</source>
        <translation>Les textures sont complétées…</translation>
    </message>
    <message>
        <source>Computing the model…</source>
        <translation>Le modèle est calculé…</translation>
    </message>
    <message numerus="yes">
        <source>%1 %n second(s) left</source>
        <translation>
            <numerusform>%1 Encore %n seconde</numerusform>
            <numerusform>%1 Encore %n secondes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 %n minute(s) left</source>
        <translation>
            <numerusform>%1 Encore %n minute</numerusform>
            <numerusform>%1 Encore %n minutes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Ready: %n texture(s) learned</source>
        <translation>
            <numerusform>Prêt : %n texture apprise</numerusform>
            <numerusform>Prêt : %n textures apprises</numerusform>
        </translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>Échec : %1</translation>
    </message>
    <message>
        <source>It did not work.</source>
        <translation>Cela n’a pas marché.</translation>
    </message>
    <message>
        <source>Not built yet</source>
        <translation>Pas encore construit</translation>
    </message>
    <message numerus="yes">
        <source>%1; they have no more than %n component(s)</source>
        <translation>
            <numerusform>%1&#xa0;; elles n’ont pas plus de %n composante</numerusform>
            <numerusform>%1&#xa0;; elles n’ont pas plus de %n composantes</numerusform>
        </translation>
    </message>
    <message>
        <source>Out of date: of other settings or textures. Build it again.</source>
        <translation>Périmé&#xa0;: d’autres réglages ou d’autres textures. Construisez-le à nouveau.</translation>
    </message>
</context>
<context>
    <name>quadrille::AppearanceEdits</name>
    <message>
        <source>Add appearance “%1”</source>
        <translation>Ajouter l’apparence «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Duplicate “%1”</source>
        <translation>Dupliquer «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>quadrille::AppearanceFields</name>
    <message>
        <source>Components</source>
        <translation>Composantes</translation>
    </message>
    <message>
        <source>Of Eigen textures and Eigen warps together, at most; 1 to 1000</source>
        <translation>Textures et déformations propres ensemble, au plus&#xa0;; de 1 à 1000</translation>
    </message>
    <message>
        <source>Warps</source>
        <translation>Déformations</translation>
    </message>
    <message>
        <source>How many of the components are Eigen warps, which align textures</source>
        <translation>Combien de composantes sont des déformations propres, qui alignent les textures</translation>
    </message>
    <message>
        <source> %</source>
        <comment>percent</comment>
        <translation> %</translation>
    </message>
    <message>
        <source>Alignment</source>
        <translation>Alignement</translation>
    </message>
    <message>
        <source>How the way of each texel is found from texture to texture</source>
        <translation>Comment le chemin de chaque texel est trouvé d’une texture à l’autre</translation>
    </message>
    <message>
        <source>TV-L1</source>
        <translation>TV-L1</translation>
    </message>
    <message>
        <source>Dense inverse search, quick</source>
        <translation>Recherche inverse dense, rapide</translation>
    </message>
    <message>
        <source>Variations</source>
        <translation>Variations</translation>
    </message>
    <message>
        <source>What frames of variations take their textures from: their poses, as the model learned to vary with them, or the captured frames that they vary</source>
        <translation>D’où les images des variations tirent leurs textures : de leurs poses, avec lesquelles le modèle a appris à varier, ou des images captées qu’elles varient</translation>
    </message>
    <message>
        <source>Learned from poses</source>
        <translation>Apprises d’après les poses</translation>
    </message>
    <message>
        <source>Of captured frames</source>
        <translation>D’images captées</translation>
    </message>
</context>
<context>
    <name>quadrille::AppearancePage</name>
    <message>
        <source>Whose textures are learned; its sequences are chosen anew with another one</source>
        <translation>Dont les textures sont apprises&#xa0;; ses séquences sont choisies à nouveau avec un autre</translation>
    </message>
    <message>
        <source>Learned from</source>
        <translation>Appris de</translation>
    </message>
    <message>
        <source>Completed</source>
        <translation>Complétées</translation>
    </message>
    <message>
        <source>Change the character of “%1”</source>
        <translation>Changer le personnage de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>all with a texture for each frame</source>
        <translation>toutes celles qui ont une texture par image</translation>
    </message>
    <message numerus="yes">
        <source>%n texture(s)</source>
        <translation>
            <numerusform>%n texture</numerusform>
            <numerusform>%n textures</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::AppearanceResults</name>
    <message>
        <source>Looking for the textures of “%1”</source>
        <translation>Recherche des textures de « %1 »</translation>
    </message>
    <message>
        <source>Completing textures by “%1”</source>
        <translation>Textures complétées par « %1 »</translation>
    </message>
    <message>
        <source>Textures of “%1”</source>
        <translation>Textures de « %1 »</translation>
    </message>
</context>
<context>
    <name>quadrille::AppearanceWorkspace</name>
    <message>
        <source>Coefficients</source>
        <translation>Coefficients</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Composantes</translation>
    </message>
    <message>
        <source>Masks</source>
        <translation>Masques</translation>
    </message>
    <message>
        <source>Between</source>
        <translation>Entre</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualité</translation>
    </message>
    <message>
        <source>Import sequences first: their textures are what is modelled.</source>
        <translation>Importez d’abord des séquences : ce sont leurs textures qui sont modélisées.</translation>
    </message>
    <message>
        <source>The texture of the frame that is shown stands here.</source>
        <translation>La texture de l’image montrée se place ici.</translation>
    </message>
    <message>
        <source>No take has a texture for each frame, so there is nothing to model.</source>
        <translation>Aucune prise n’a de texture par image : il n’y a rien à modéliser.</translation>
    </message>
    <message>
        <source>No take of “%1” has a texture for each frame, so there is nothing to model.</source>
        <translation>Aucune prise de « %1 » n’a de texture par image : il n’y a rien à modéliser.</translation>
    </message>
    <message>
        <source>Select a take and choose a folder of textures in its properties: one picture for each of its frames.</source>
        <translation>Sélectionnez une prise et choisissez un dossier de textures dans ses propriétés : une par image de la prise.</translation>
    </message>
    <message>
        <source>New model</source>
        <translation>Nouveau modèle</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Réessayer</translation>
    </message>
    <message>
        <source>“%1” is not built yet.</source>
        <translation>« %1 » n’est pas encore construit.</translation>
    </message>
    <message>
        <source>It takes some seconds for each texture; you can go on working meanwhile.</source>
        <translation>Il faut quelques secondes par texture ; on peut travailler en attendant.</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>Construire</translation>
    </message>
    <message>
        <source>“%1” cannot be shown.</source>
        <translation>«&#xa0;%1&#xa0;» ne peut pas être montré.</translation>
    </message>
    <message>
        <source>Eigen textures and warps make sharp textures between captured frames, and fill in what is missing.</source>
        <translation>Les textures et déformations propres donnent des textures nettes entre les images captées, et complètent ce qui manque.</translation>
    </message>
</context>
<context>
    <name>quadrille::AxesFields</name>
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
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
</context>
<context>
    <name>quadrille::BetweenPanel</name>
    <message>
        <source>The texture between two captured frames: a linear blend shows both, one through the other; the model moves the one to the other.</source>
        <translation>La texture entre deux images captées : un mélange linéaire montre les deux, l’une à travers l’autre ; le modèle amène l’une à l’autre.</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>This frame</source>
        <translation>Celle-ci</translation>
    </message>
    <message>
        <source>Take the frame that is shown</source>
        <translation>Prendre l’image montrée</translation>
    </message>
    <message>
        <source>%1: this frame</source>
        <translation>%1 : celle-ci</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Montrer</translation>
    </message>
    <message>
        <source>Go to that frame</source>
        <translation>Aller à cette image</translation>
    </message>
    <message>
        <source>%1: show</source>
        <translation>%1 : montrer</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Poids</translation>
    </message>
    <message>
        <source>How far from the first frame to the second</source>
        <translation>À quelle distance de la première image vers la seconde</translation>
    </message>
    <message>
        <source> %</source>
        <comment>percent</comment>
        <translation> %</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>pas encore</translation>
    </message>
</context>
<context>
    <name>quadrille::BlendList</name>
    <message>
        <source>%1 %</source>
        <comment>share in percent</comment>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Pair</source>
        <translation>Paire</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Poids</translation>
    </message>
    <message>
        <source>Blends</source>
        <translation>Mélanges</translation>
    </message>
    <message>
        <source>Return or a double click edits the weights of the second; Delete removes the pair</source>
        <translation>Entrée ou un double clic modifie les poids de la seconde&#xa0;; Suppr retire la paire</translation>
    </message>
    <message>
        <source>First take</source>
        <translation>Première prise</translation>
    </message>
    <message>
        <source>Second take</source>
        <translation>Seconde prise</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Mélanger</translation>
    </message>
    <message>
        <source>Learn from blends of the two takes, too, so that variations between them can be drawn</source>
        <translation>Apprendre aussi de mélanges des deux prises, pour tirer des variations entre elles</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>Choose two takes or more to blend between them.</source>
        <translation>Choisissez deux prises ou plus pour les mélanger.</translation>
    </message>
    <message>
        <source>Blend “%1” and “%2”</source>
        <translation>Mélanger «&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>Remove a blend</source>
        <translation>Retirer un mélange</translation>
    </message>
    <message>
        <source>Change the weights of a blend</source>
        <translation>Changer les poids d’un mélange</translation>
    </message>
</context>
<context>
    <name>quadrille::BodyPartsPanel</name>
    <message>
        <source>Body parts</source>
        <translation>Parties du corps</translation>
    </message>
    <message>
        <source>Cut the body into torso, arms and legs</source>
        <translation>Coupe le corps en tronc, bras et jambes</translation>
    </message>
    <message>
        <source>Click points around a limb (C)</source>
        <translation>Cliquer des points autour d’un membre (C)</translation>
    </message>
    <message>
        <source>Snap to creases within</source>
        <translation>Aimanter aux plis à moins de</translation>
    </message>
    <message>
        <source>A point that is put down jumps to the nearest crease; hold Alt to put it where the pointer is</source>
        <translation>Un point posé saute au pli le plus proche&#xa0;; tenir Alt pour le poser sous le pointeur</translation>
    </message>
    <message>
        <source>Radius of snapping</source>
        <translation>Rayon d’aimantation</translation>
    </message>
    <message>
        <source> cm</source>
        <translation> cm</translation>
    </message>
    <message>
        <source>Between two curves</source>
        <translation>Entre deux courbes</translation>
    </message>
    <message>
        <source>Distance between the two curves of a part</source>
        <translation>Distance entre les deux courbes d’une partie</translation>
    </message>
    <message>
        <source>How wide the strip is that a part shares with its parent, for curves that are made</source>
        <translation>Largeur de la bande qu’une partie partage avec son parent, pour les courbes qui sont faites</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Pose</translation>
    </message>
    <message>
        <source>Curves follow the surface as it is in this pose</source>
        <translation>Les courbes suivent la surface telle qu’elle est dans cette pose</translation>
    </message>
    <message>
        <source>Use the shown one</source>
        <translation>Prendre celle montrée</translation>
    </message>
    <message>
        <source>Draw curves in the pose that the view shows</source>
        <translation>Tracer les courbes dans la pose que la vue montre</translation>
    </message>
    <message>
        <source>Parts belong to a body: import a sequence first.</source>
        <translation>Les parties appartiennent à un corps&#xa0;: importez d’abord une séquence.</translation>
    </message>
    <message>
        <source>Reading the body …</source>
        <translation>Lecture du corps…</translation>
    </message>
    <message>
        <source>Variations are learned part by part. Curves around the limbs say where the parts meet: have torso, arms and legs proposed, or draw curves on the body.</source>
        <translation>Les variations s’apprennent partie par partie. Des courbes autour des membres disent où les parties se rejoignent&#xa0;: faites proposer tronc, bras et jambes, ou tracez des courbes sur le corps.</translation>
    </message>
    <message>
        <source>%1, frame %2</source>
        <translation>%1, image %2</translation>
    </message>
    <message>
        <source>The curve “%1” bounds no part yet.</source>
        <translation>La courbe «&#xa0;%1&#xa0;» ne borne encore aucune partie.</translation>
    </message>
    <message>
        <source>A part needs two: draw another, or let one be made beside it.</source>
        <translation>Il en faut deux à une partie&#xa0;: tracez-en une autre, ou faites-en faire une à côté.</translation>
    </message>
    <message>
        <source>The curves “%1” and “%2” bound no part yet.</source>
        <translation>Les courbes «&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;» ne bornent encore aucune partie.</translation>
    </message>
    <message>
        <source>Propose parts</source>
        <translation>Proposer des parties</translation>
    </message>
    <message>
        <source>Draw a curve</source>
        <translation>Tracer une courbe</translation>
    </message>
    <message>
        <source>Add a part</source>
        <translation>Ajouter une partie</translation>
    </message>
</context>
<context>
    <name>quadrille::BodyPartsTree</name>
    <message>
        <source>Parts and curves</source>
        <translation>Parties et courbes</translation>
    </message>
    <message>
        <source>Parts of the body, each with the two curves that bound what it shares with its parent</source>
        <translation>Parties du corps, chacune avec les deux courbes qui bornent ce qu’elle partage avec son parent</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Partie</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Sommets</translation>
    </message>
    <message>
        <source>Whether something is wrong</source>
        <translation>Si quelque chose ne va pas</translation>
    </message>
</context>
<context>
    <name>quadrille::BodySurface</name>
    <message>
        <source>Reading the pose that curves are drawn in</source>
        <translation>Lecture de la pose où l’on trace les courbes</translation>
    </message>
</context>
<context>
    <name>quadrille::BrokenEdits</name>
    <message>
        <source>Remove “%1”</source>
        <translation>Supprimer «&#xa0;%1&#xa0;»</translation>
    </message>
    <message numerus="yes">
        <source>Remove %n unreadable parts</source>
        <translation>
            <numerusform>Retirer %n partie illisible</numerusform>
            <numerusform>Retirer %n parties illisibles</numerusform>
        </translation>
    </message>
    <message>
        <source>Correct “%1”</source>
        <translation>Corriger «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>quadrille::BrokenPage</name>
    <message>
        <source>Problem</source>
        <translation>Problème</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Emplacement</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>sentence and remedy</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Text in the file</source>
        <translation>Texte dans le fichier</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>Relire</translation>
    </message>
    <message>
        <source>Takes the corrected text over; until then the entry stays as it is in the file</source>
        <translation>Reprend le texte corrigé&#xa0;; jusque-là, l’entrée reste telle quelle dans le fichier</translation>
    </message>
    <message>
        <source>Remove from the project</source>
        <translation>Retirer du projet</translation>
    </message>
</context>
<context>
    <name>quadrille::CardPictures</name>
    <message>
        <source>Pictures of “%1”</source>
        <translation>Images de «&#xa0;%1&#xa0;»</translation>
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
        <source>Order of the cards</source>
        <translation>Ordre des cartes</translation>
    </message>
    <message>
        <source>As in the project</source>
        <translation>Comme dans le projet</translation>
    </message>
    <message>
        <source>By name</source>
        <translation>Par nom</translation>
    </message>
    <message>
        <source>By length</source>
        <translation>Par durée</translation>
    </message>
    <message>
        <source>By label</source>
        <translation>Par étiquette</translation>
    </message>
    <message>
        <source>No sequences yet. Drop files or folders anywhere in this window.</source>
        <translation>Pas encore de séquences. Déposez des fichiers ou des dossiers n’importe où dans cette fenêtre.</translation>
    </message>
    <message>
        <source>No name or label has “%1” in it.</source>
        <translation>Aucun nom, aucune étiquette ne contient «&#xa0;%1 ».</translation>
    </message>
    <message>
        <source>Add a label</source>
        <translation>Ajouter une étiquette</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>Comparer avec</translation>
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
    <name>quadrille::ClipChoice</name>
    <message>
        <source>Takes</source>
        <translation>Prises</translation>
    </message>
    <message>
        <source>Animations</source>
        <translation>Animations</translation>
    </message>
    <message>
        <source>Variations</source>
        <translation>Variations</translation>
    </message>
    <message>
        <source>Transfers</source>
        <translation>Transferts</translation>
    </message>
    <message>
        <source>Projections</source>
        <translation>Projections</translation>
    </message>
    <message>
        <source>Live performances</source>
        <translation>Performances en direct</translation>
    </message>
</context>
<context>
    <name>quadrille::ClipScene</name>
    <message>
        <source>Reading the path of “%1”</source>
        <translation>Lecture du trajet de «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>quadrille::CoefficientsPanel</name>
    <message>
        <source>T%1</source>
        <comment>an Eigen texture</comment>
        <translation>T%1</translation>
    </message>
    <message>
        <source>W%1</source>
        <comment>an Eigen warp</comment>
        <translation>D%1</translation>
    </message>
    <message>
        <source>Frame’s own</source>
        <translation>Ceux de l’image</translation>
    </message>
    <message>
        <source>Take back what was changed by hand</source>
        <translation>Reprendre ce qui fut changé à la main</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>Put all coefficients to zero, which is the mean texture</source>
        <translation>Mettre tous les coefficients à zéro : la texture moyenne</translation>
    </message>
    <message>
        <source>The model has not learned this frame. Moving a slider begins at the mean.</source>
        <translation>Le modèle n’a pas appris cette image. Un curseur que l’on bouge part de la moyenne.</translation>
    </message>
    <message>
        <source>Coefficients of the frame that is shown stand here, once the model is built.</source>
        <translation>Les coefficients de l’image montrée se placent ici, une fois le modèle construit.</translation>
    </message>
    <message>
        <source>%1, changed by hand</source>
        <translation>%1, changé à la main</translation>
    </message>
    <message>
        <source>Show fewer</source>
        <translation>En montrer moins</translation>
    </message>
    <message>
        <source>Show all %1</source>
        <translation>Montrer les %1</translation>
    </message>
    <message>
        <source> σ</source>
        <comment>standard deviations</comment>
        <translation> σ</translation>
    </message>
    <message>
        <source>Eigen texture %1, in standard deviations from the mean</source>
        <translation>Texture propre %1, en écarts-types depuis la moyenne</translation>
    </message>
    <message>
        <source>Eigen warp %1, in standard deviations from the mean</source>
        <translation>Déformation propre %1, en écarts-types depuis la moyenne</translation>
    </message>
</context>
<context>
    <name>quadrille::ComponentsPanel</name>
    <message>
        <source>Eigen textures</source>
        <translation>Textures propres</translation>
    </message>
    <message>
        <source>Which colours change together: above grey more, below it less</source>
        <translation>Quelles couleurs changent ensemble : plus que le gris davantage, moins que lui moins</translation>
    </message>
    <message>
        <source>Eigen warps</source>
        <translation>Déformations propres</translation>
    </message>
    <message>
        <source>Where texels move together: arrows and colours say which way, their length and strength how far</source>
        <translation>Où des texels bougent ensemble : flèches et couleurs disent vers où, leur longueur et leur force de combien</translation>
    </message>
    <message>
        <source>Eigen textures and Eigen warps stand here once the model is built.</source>
        <translation>Textures et déformations propres se placent ici une fois le modèle construit.</translation>
    </message>
    <message>
        <source>Drawing components…</source>
        <translation>Les composantes sont dessinées…</translation>
    </message>
    <message>
        <source>Drawing components</source>
        <translation>Dessin des composantes</translation>
    </message>
    <message>
        <source>%1 · %2 %</source>
        <comment>number and share of the variance</comment>
        <translation>%1 · %2 %</translation>
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
    <name>quadrille::CurrentAnimation</name>
    <message>
        <source>animation</source>
        <translation>animation</translation>
    </message>
</context>
<context>
    <name>quadrille::CurrentAppearance</name>
    <message>
        <source>textures</source>
        <translation>textures</translation>
    </message>
</context>
<context>
    <name>quadrille::CurrentTransfer</name>
    <message>
        <source>Pair triangles</source>
        <translation>Apparier des triangles</translation>
    </message>
    <message>
        <source>Move pair %1</source>
        <translation>Déplacer la paire %1</translation>
    </message>
    <message>
        <source>Remove pair %1</source>
        <translation>Retirer la paire %1</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <translation>%1 par %2</translation>
    </message>
    <message>
        <source>trunk</source>
        <translation>tronc</translation>
    </message>
    <message>
        <source>head</source>
        <translation>tête</translation>
    </message>
    <message>
        <source>left upper arm</source>
        <translation>bras gauche</translation>
    </message>
    <message>
        <source>left lower arm</source>
        <translation>avant-bras gauche</translation>
    </message>
    <message>
        <source>right upper arm</source>
        <translation>bras droit</translation>
    </message>
    <message>
        <source>right lower arm</source>
        <translation>avant-bras droit</translation>
    </message>
    <message>
        <source>left thigh</source>
        <translation>cuisse gauche</translation>
    </message>
    <message>
        <source>left shin</source>
        <translation>jambe gauche</translation>
    </message>
    <message>
        <source>right thigh</source>
        <translation>cuisse droite</translation>
    </message>
    <message>
        <source>right shin</source>
        <translation>jambe droite</translation>
    </message>
    <message>
        <source>%1, filmed</source>
        <translation>%1, filmé</translation>
    </message>
</context>
<context>
    <name>quadrille::CurrentVariation</name>
    <message>
        <source>Add variations, then choose the takes to learn from.</source>
        <translation>Ajoutez des variations, puis choisissez les prises à apprendre.</translation>
    </message>
    <message>
        <source>Check the takes to learn from in the panel Movement.</source>
        <translation>Cochez les prises à apprendre dans le panneau Mouvement.</translation>
    </message>
    <message>
        <source>Aligning the takes was stopped.</source>
        <translation>L’alignement des prises a été arrêté.</translation>
    </message>
    <message>
        <source>Aligning the takes…</source>
        <translation>Alignement des prises…</translation>
    </message>
    <message>
        <source>The takes are aligned: learn to draw variations of them.</source>
        <translation>Les prises sont alignées&#xa0;: apprenez pour en tirer des variations.</translation>
    </message>
    <message>
        <source>Learning…</source>
        <translation>Apprentissage…</translation>
    </message>
    <message>
        <source>Drawing variations…</source>
        <translation>Tirage des variations…</translation>
    </message>
    <message>
        <source>It did not work.</source>
        <translation>Cela n’a pas marché.</translation>
    </message>
    <message>
        <source>variations</source>
        <translation>variations</translation>
    </message>
    <message>
        <source>Learning was stopped.</source>
        <translation>L’apprentissage a été arrêté.</translation>
    </message>
</context>
<context>
    <name>quadrille::DefaultSettings</name>
    <message>
        <source>Default settings (%1)</source>
        <translation>Réglages par défaut (%1)</translation>
    </message>
    <message>
        <source>Quadrille did not start</source>
        <translation>Quadrille n’a pas démarré</translation>
    </message>
    <message numerus="yes">
        <source>The last %n start(s) of Quadrille failed. Start with default settings?</source>
        <translation>
            <numerusform>Le dernier démarrage de Quadrille a échoué. Démarrer avec les réglages par défaut&#xa0;?</numerusform>
            <numerusform>Les %n derniers démarrages de Quadrille ont échoué. Démarrer avec les réglages par défaut&#xa0;?</numerusform>
        </translation>
    </message>
    <message>
        <source>Shortcuts, theme and the arrangement of windows are as they were at first then. Yours are put aside as %1.</source>
        <translation>Les raccourcis, le thème et la disposition des fenêtres sont alors ceux du début. Les vôtres sont mis de côté sous le nom %1.</translation>
    </message>
    <message>
        <source>Start as before</source>
        <translation>Démarrer comme avant</translation>
    </message>
</context>
<context>
    <name>quadrille::EntryPage</name>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Unique in the project</source>
        <translation>Unique dans le projet</translation>
    </message>
    <message>
        <source>Character</source>
        <translation>Personnage</translation>
    </message>
    <message>
        <source>Work on it</source>
        <translation>Y travailler</translation>
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
    <name>quadrille::EvaluationChooser</name>
    <message>
        <source>Evaluations measure the project’s own takes, as the papers do, and what shows of what is made of them. Choose one to add.</source>
        <translation>Les évaluations mesurent les prises du projet, comme le font les articles, et ce qui se voit de ce que l’on en fait. Choisissez-en une à ajouter.</translation>
    </message>
    <message>
        <source>Evaluations that can be added</source>
        <translation>Évaluations que l’on peut ajouter</translation>
    </message>
    <message>
        <source>The project has it already.</source>
        <translation>Le projet l’a déjà.</translation>
    </message>
    <message>
        <source>There are no takes yet.</source>
        <translation>Il n’y a pas encore de prises.</translation>
    </message>
    <message>
        <source>No take has reference joint angles (a BVH file, in its properties).</source>
        <translation>Aucune prise n’a d’angles de référence (un fichier BVH, dans ses propriétés).</translation>
    </message>
    <message>
        <source>The project has no variations.</source>
        <translation>Le projet n’a pas de variations.</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <extracomment>what an evaluation shows, then why it cannot be added</extracomment>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>The project has no model of appearance.</source>
        <translation>Le projet n’a pas de modèle d’apparence.</translation>
    </message>
    <message>
        <source>No transfer names a clip that shows what it ought to be.</source>
        <translation>Aucun transfert ne nomme un clip qui montre ce qu’il devrait être.</translation>
    </message>
    <message>
        <source>The project has no two motion spaces of several takes.</source>
        <translation>Le projet n’a pas deux espaces de mouvement de plusieurs prises.</translation>
    </message>
    <message>
        <source>The project has no motion space of several takes.</source>
        <translation>Le projet n’a pas d’espace de mouvement de plusieurs prises.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
</context>
<context>
    <name>quadrille::EvaluationPanel</name>
    <message>
        <source>What was measured</source>
        <translation>Ce qui fut mesuré</translation>
    </message>
    <message>
        <source>What the chart shows</source>
        <translation>Ce que montre le graphique</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>Tableaux</translation>
    </message>
    <message>
        <source>&amp;Compute</source>
        <translation>&amp;Calculer</translation>
    </message>
    <message>
        <source>Looking for results…</source>
        <translation>Recherche de résultats…</translation>
    </message>
    <message>
        <source>There was nothing to measure.</source>
        <translation>Il n’y avait rien à mesurer.</translation>
    </message>
    <message>
        <source>There is nothing in the project that this could be about: takes of a character that it names, or variations that are learned.</source>
        <translation>Il n’y a rien dans le projet dont ceci pourrait parler : des prises d’un personnage nommé, ou des variations apprises.</translation>
    </message>
    <message>
        <source>Not computed yet. It takes from seconds to minutes; you can go on working meanwhile.</source>
        <translation>Pas encore calculée. Cela prend de quelques secondes à quelques minutes ; vous pouvez continuer à travailler.</translation>
    </message>
    <message>
        <source>The project has changed since this was computed.</source>
        <translation>Le projet a changé depuis ce calcul.</translation>
    </message>
    <message>
        <source>Compute</source>
        <translation>Calculer</translation>
    </message>
    <message>
        <source>Computing, with all that it needs…</source>
        <translation>Calcul, avec tout ce qu’il faut…</translation>
    </message>
    <message>
        <source>Computed anew; these are the results before.</source>
        <translation>Recalculée ; voici les résultats d’avant.</translation>
    </message>
    <message>
        <source>Being computed.</source>
        <translation>En cours de calcul.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Réessayer</translation>
    </message>
    <message>
        <source>This could not be computed.</source>
        <translation>Ceci n’a pas pu être calculé.</translation>
    </message>
    <message>
        <source>Evaluations</source>
        <translation>Évaluations</translation>
    </message>
    <message>
        <source>&amp;Add an evaluation…</source>
        <translation>&amp;Ajouter une évaluation…</translation>
    </message>
    <message>
        <source>Lists what can be measured of the project’s takes, and of what is made of them</source>
        <translation>Liste ce que l’on peut mesurer des prises du projet, et de ce que l’on en fait</translation>
    </message>
    <message>
        <source>&amp;Show the evaluation</source>
        <translation>&amp;Montrer l’évaluation</translation>
    </message>
    <message>
        <source>Shows tables and charts of the selected evaluation</source>
        <translation>Montre tableaux et graphiques de l’évaluation choisie</translation>
    </message>
    <message>
        <source>&amp;Compute the evaluation</source>
        <translation>&amp;Calculer l’évaluation</translation>
    </message>
    <message>
        <source>Computes the selected evaluation and what it needs, as a rebuild does</source>
        <translation>Calcule l’évaluation choisie et ce qu’il lui faut, comme une reconstruction</translation>
    </message>
    <message>
        <source>S&amp;top computing</source>
        <translation>Arrê&amp;ter le calcul</translation>
    </message>
    <message>
        <source>Stops computing the selected evaluation</source>
        <translation>Arrête le calcul de l’évaluation choisie</translation>
    </message>
    <message>
        <source>C&amp;opy the table</source>
        <translation>C&amp;opier le tableau</translation>
    </message>
    <message>
        <source>Copies the table that is shown as comma-separated values</source>
        <translation>Copie le tableau montré en valeurs séparées par des virgules</translation>
    </message>
    <message>
        <source>Sa&amp;ve the table…</source>
        <translation>Enre&amp;gistrer le tableau…</translation>
    </message>
    <message>
        <source>Saves the table that is shown as a CSV file</source>
        <translation>Enregistre le tableau montré en fichier CSV</translation>
    </message>
    <message>
        <source>Save the table</source>
        <translation>Enregistrer le tableau</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>Valeurs séparées par des virgules (*.csv)</translation>
    </message>
</context>
<context>
    <name>quadrille::EvaluationResults</name>
    <message>
        <source>Looking for evaluations</source>
        <translation>Recherche d’évaluations</translation>
    </message>
    <message>
        <source>Evaluation “%1”</source>
        <translation>Évaluation « %1 »</translation>
    </message>
</context>
<context>
    <name>quadrille::EvaluationTableModel</name>
    <message>
        <source>%1 (%2)</source>
        <extracomment>a column of a table, then its unit</extracomment>
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
        <source>Write over</source>
        <translation>Remplacer</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>Export de %1</translation>
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
    <message>
        <source>Clip</source>
        <translation>Clip</translation>
    </message>
    <message>
        <source>%1 … · all variations that are kept, their latents, and a description</source>
        <translation>%1 … · toutes les variations gardées, leurs latentes et une description</translation>
    </message>
    <message>
        <source>How far the export is</source>
        <translation>Avancement de l’export</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>The export “%1” of this project writes there.</source>
        <translation>L’export «&#xa0;%1&#xa0;» de ce projet écrit là.</translation>
    </message>
    <message>
        <source>Choose another file.</source>
        <translation>Choisissez un autre fichier.</translation>
    </message>
    <message>
        <source>Replace an export?</source>
        <translation>Remplacer un export&#xa0;?</translation>
    </message>
    <message>
        <source>The export “%1” of this project writes there already.</source>
        <translation>L’export «&#xa0;%1&#xa0;» de ce projet écrit déjà là.</translation>
    </message>
    <message>
        <source>This one takes its place in the project.</source>
        <translation>Celui-ci prend sa place dans le projet.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Remplacer</translation>
    </message>
    <message>
        <source>An earlier export wrote it.</source>
        <translation>Un export précédent l’a écrit.</translation>
    </message>
    <message>
        <source>It was not written by this project, or was changed since. What is replaced is lost.</source>
        <translation>Il n’a pas été écrit par ce projet, ou a été modifié depuis. Ce qui est remplacé est perdu.</translation>
    </message>
    <message>
        <source>Write outside of the project?</source>
        <translation>Écrire hors du projet&#xa0;?</translation>
    </message>
    <message>
        <source>This export writes into %1.</source>
        <translation>Cet export écrit dans %1.</translation>
    </message>
    <message>
        <source>That is outside of the project&apos;s folder. If the project is not your own, make sure that you want it to write there. You are not asked again about this folder.</source>
        <translation>C’est hors du dossier du projet. Si le projet n’est pas de vous, assurez-vous de vouloir qu’il écrive là. La question n’est pas posée à nouveau pour ce dossier.</translation>
    </message>
    <message>
        <source>Write there</source>
        <translation>Écrire là</translation>
    </message>
    <message>
        <source>Preparing the export</source>
        <translation>Préparation de l’export</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) written, “%1” the first.</source>
        <translation>
            <numerusform>%n fichier écrit&#xa0;: «&#xa0;%1 ».</numerusform>
            <numerusform>%n fichiers écrits, le premier est «&#xa0;%1 ».</numerusform>
        </translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Montrer dans le dossier</translation>
    </message>
    <message>
        <source>glTF shows the texture of the first frame; those of all frames are written beside.</source>
        <translation>glTF montre la texture de la première image&#xa0;; celles de toutes les images sont écrites à côté.</translation>
    </message>
    <message>
        <source>USD, OBJ and PLY show each in its frame.</source>
        <translation>USD, OBJ et PLY montrent chacune dans son image.</translation>
    </message>
    <message>
        <source>%1 · motion spaces, transitions and the recording, to be steered in games</source>
        <translation>%1 · espaces de mouvement, transitions et enregistrement, à diriger dans des jeux</translation>
    </message>
    <message>
        <source>Put the pictures into the file</source>
        <translation>Mettre les images dans le fichier</translation>
    </message>
    <message>
        <source>“%1” is written.</source>
        <translation>«&#xa0;%1&#xa0;» est écrit.</translation>
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
        <source>Write the selected sequences, animation or variations in another format, or as pictures or video</source>
        <translation>Écrire les séquences, l’animation ou les variations sélectionnées dans un autre format, ou en images ou vidéo</translation>
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
    <name>quadrille::FieldForm</name>
    <message>
        <source>Set “%1”</source>
        <translation>Définir «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source> fps</source>
        <translation> i/s</translation>
    </message>
</context>
<context>
    <name>quadrille::FrameNotes</name>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>Double-click to write something about a frame</source>
        <translation>Double-cliquez pour écrire quelque chose au sujet d’une image</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>Note on this frame</source>
        <translation>Note sur cette image</translation>
    </message>
</context>
<context>
    <name>quadrille::FramePictures</name>
    <message>
        <source>Pictures of frames</source>
        <translation>Images miniatures</translation>
    </message>
</context>
<context>
    <name>quadrille::GapsPanel</name>
    <message>
        <source>Gaps of the graphs</source>
        <translation>Lacunes des graphes</translation>
    </message>
    <message>
        <source>Frames that walks do not reach, or do not come back from, and what would help. A click shows it.</source>
        <translation>Images que les parcours n’atteignent pas, ou d’où ils ne reviennent pas, et ce qui aiderait. Un clic le montre.</translation>
    </message>
    <message>
        <source>Compute the graph to see which frames walks cannot reach.</source>
        <translation>Calculez le graphe pour voir quelles images les parcours n’atteignent pas.</translation>
    </message>
    <message>
        <source>Essential graph</source>
        <translation>Graphe essentiel</translation>
    </message>
    <message>
        <source>Motion graph</source>
        <translation>Graphe de mouvement</translation>
    </message>
    <message>
        <source>every frame is reached from every other</source>
        <extracomment>frames in the largest component, of all frames</extracomment>
        <translation>chaque image est atteinte depuis toute autre</translation>
    </message>
    <message>
        <source>%1 of %2 frames are joined both ways</source>
        <translation>%1 images sur %2 sont reliées dans les deux sens</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>name of a graph; what it joins</extracomment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Usual: transitions need these frames</source>
        <translation>Normal&#xa0;: les transitions ont besoin de ces images</translation>
    </message>
    <message numerus="yes">
        <source>Starts and ends of takes: %n</source>
        <translation>
            <numerusform>Débuts et fins de prises&#xa0;: %n</numerusform>
            <numerusform>Débuts et fins de prises&#xa0;: %n</numerusform>
        </translation>
    </message>
    <message>
        <source>No walk leads from there to the largest part of the graph</source>
        <translation>Aucun parcours ne mène de là à la plus grande partie du graphe</translation>
    </message>
    <message>
        <source>No walk leads there from the largest part of the graph</source>
        <translation>Aucun parcours n’y mène depuis la plus grande partie du graphe</translation>
    </message>
    <message>
        <source>%1–%2</source>
        <translation>%1–%2</translation>
    </message>
    <message>
        <source>%1: dead end</source>
        <translation>%1&#xa0;: impasse</translation>
    </message>
    <message>
        <source>%1: not reached</source>
        <extracomment>frames that no walk reaches</extracomment>
        <translation>%1&#xa0;: hors d’atteinte</translation>
    </message>
    <message>
        <source>Take the transition %1 → %2 (weight %3)</source>
        <extracomment>two frames and a weight</extracomment>
        <translation>Prendre la transition %1 → %2 (poids %3)</translation>
    </message>
    <message>
        <source>Capture a take %1 → %2 (poses %3 %4 apart)</source>
        <extracomment>two frames, and the distance of their poses with its unit</extracomment>
        <translation>Capter une prise %1 → %2 (poses distantes de %3 %4)</translation>
    </message>
    <message>
        <source>Capture more takes</source>
        <translation>Capter d’autres prises</translation>
    </message>
</context>
<context>
    <name>quadrille::GiveResults</name>
    <message>
        <source>Copying the results to the new place…</source>
        <translation>Copie des résultats au nouvel endroit…</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Passer</translation>
    </message>
    <message>
        <source>Copying results</source>
        <translation>Copie des résultats</translation>
    </message>
</context>
<context>
    <name>quadrille::GraphBar</name>
    <message>
        <source>Set α to %1</source>
        <translation>Régler α sur %1</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message numerus="yes">
        <source>± %1; %n pair(s) of frames without a way</source>
        <translation>
            <numerusform>± %1&#xa0;; %n paire d’images sans chemin</numerusform>
            <numerusform>± %1&#xa0;; %n paires d’images sans chemin</numerusform>
        </translation>
    </message>
    <message>
        <source>Character</source>
        <translation>Personnage</translation>
    </message>
    <message>
        <source>Whose sequences the graph joins</source>
        <translation>De qui le graphe relie les séquences</translation>
    </message>
    <message>
        <source>&amp;α</source>
        <translation>&amp;α</translation>
    </message>
    <message>
        <source>α</source>
        <translation>α</translation>
    </message>
    <message>
        <source>α, as a number</source>
        <translation>α, en nombre</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Arêtes</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Densité</translation>
    </message>
    <message>
        <source>Edges of all that there could be between different frames</source>
        <translation>Part des arêtes possibles entre images différentes</translation>
    </message>
    <message>
        <source>Mean cost</source>
        <translation>Coût moyen</translation>
    </message>
    <message>
        <source>Of the cheapest way from any frame to any other</source>
        <translation>Du chemin le moins cher d’une image quelconque à une autre</translation>
    </message>
    <message>
        <source>Essential graph</source>
        <translation>Graphe essentiel</translation>
    </message>
    <message>
        <source>Motion graph</source>
        <translation>Graphe de mouvement</translation>
    </message>
    <message>
        <source>sparse: smooth ways</source>
        <extracomment>ends of the slider for α: few edges in the graph, many edges in it</extracomment>
        <translation>épars&#xa0;: trajets doux</translation>
    </message>
    <message>
        <source>dense: short ways</source>
        <translation>dense&#xa0;: trajets courts</translation>
    </message>
    <message>
        <source>Weight of a frame of duration against deformation: higher values prefer short ways. The curve is the density of the Essential graph.</source>
        <translation>Poids d’une image de durée face à la déformation&#xa0;: des valeurs plus hautes préfèrent les trajets courts. La courbe est la densité du graphe essentiel.</translation>
    </message>
    <message>
        <source>So many are certain; others are still looked at</source>
        <translation>Celles-ci sont certaines&#xa0;; d’autres sont encore examinées</translation>
    </message>
</context>
<context>
    <name>quadrille::GraphChartsPanel</name>
    <message>
        <source>α</source>
        <translation>α</translation>
    </message>
    <message>
        <source>Essential graph</source>
        <translation>Graphe essentiel</translation>
    </message>
    <message>
        <source>Motion graph</source>
        <translation>Graphe de mouvement</translation>
    </message>
    <message>
        <source>Compute the graph to compare it over α.</source>
        <translation>Calculez le graphe pour le comparer selon α.</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Densité</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Arêtes</translation>
    </message>
    <message>
        <source>Mean path cost</source>
        <translation>Coût moyen des chemins</translation>
    </message>
    <message>
        <source>Of so many frames this takes some minutes and much memory.</source>
        <translation>Pour autant d’images, cela prend quelques minutes et beaucoup de mémoire.</translation>
    </message>
    <message>
        <source>Compare over α</source>
        <translation>Comparer selon α</translation>
    </message>
    <message>
        <source>Computing the graphs for several α: %1 of %2</source>
        <translation>Calcul des graphes pour plusieurs α : %1 sur %2</translation>
    </message>
</context>
<context>
    <name>quadrille::GraphExplorer</name>
    <message>
        <source>Graphs</source>
        <translation>Graphes</translation>
    </message>
    <message>
        <source>Gaps of the graphs</source>
        <translation>Lacunes des graphes</translation>
    </message>
    <message>
        <source>Graphs against α</source>
        <translation>Graphes selon α</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>a sequence and one of its frames</extracomment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 › %2</source>
        <extracomment>two frames: a transition from the first to the second</extracomment>
        <translation>%1 › %2</translation>
    </message>
</context>
<context>
    <name>quadrille::GraphMap</name>
    <message>
        <source>rad</source>
        <translation>rad</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Essential graph</source>
        <translation>Graphe essentiel</translation>
    </message>
    <message>
        <source>Motion graph</source>
        <translation>Graphe de mouvement</translation>
    </message>
    <message>
        <source>Drawing the costs</source>
        <translation>Dessin des coûts</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>Coût</translation>
    </message>
    <message>
        <source>%1 % in colour</source>
        <translation>%1 % en couleur</translation>
    </message>
    <message>
        <source>Costs of transitions</source>
        <translation>Coûts des transitions</translation>
    </message>
    <message>
        <source>Transitions as arcs</source>
        <translation>Transitions en arcs</translation>
    </message>
    <message>
        <source>Rows are the frames that transitions leave, columns those where they arrive.</source>
        <translation>Les lignes sont les images que les transitions quittent, les colonnes celles où elles arrivent.</translation>
    </message>
    <message>
        <source>Sequences as bars, with the transitions between their frames as arcs.</source>
        <translation>Les séquences en barres, les transitions entre leurs images en arcs.</translation>
    </message>
    <message>
        <source>&amp;Cost up to</source>
        <translation>&amp;Coût jusqu’à</translation>
    </message>
    <message>
        <source>any</source>
        <translation>libre</translation>
    </message>
    <message>
        <source>Transitions that cost more are greyed; 0 shows all</source>
        <translation>Les transitions plus chères sont grisées&#xa0;; 0 montre tout</translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation>&amp;Durée</translation>
    </message>
    <message>
        <source>Transitions that last shorter or longer, in frames (%1 a second), are greyed</source>
        <translation>Les transitions plus brèves ou plus longues, en images (%1 par seconde), sont grisées</translation>
    </message>
    <message>
        <source>Greatest cost shown</source>
        <translation>Plus grand coût montré</translation>
    </message>
    <message>
        <source>Least length shown</source>
        <translation>Plus petite durée montrée</translation>
    </message>
    <message>
        <source>Greatest length shown</source>
        <translation>Plus grande durée montrée</translation>
    </message>
    <message>
        <source>Takes and the transitions between them</source>
        <translation>Les prises et les transitions entre elles</translation>
    </message>
    <message>
        <source>Takes with their pictures, and how many transitions lead from one to another.</source>
        <translation>Les prises avec leurs images, et combien de transitions mènent de l’une à l’autre.</translation>
    </message>
    <message>
        <source>Only %1</source>
        <translation>Seulement %1</translation>
    </message>
    <message>
        <source>%1. Click to look at all takes</source>
        <translation>%1. Cliquez pour voir toutes les prises</translation>
    </message>
    <message>
        <source>Motion graph: transitions between takes</source>
        <translation>Graphe de mouvement : transitions entre prises</translation>
    </message>
    <message>
        <source>Essential graph: transitions between takes</source>
        <translation>Graphe essentiel : transitions entre prises</translation>
    </message>
</context>
<context>
    <name>quadrille::GraphResults</name>
    <message>
        <source>Graph</source>
        <translation>Graphe</translation>
    </message>
    <message>
        <source>Graph of “%1”</source>
        <translation>Graphe de «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>quadrille::GraphSettingsPanel</name>
    <message>
        <source>Poses</source>
        <translation>Poses</translation>
    </message>
    <message>
        <source>How two poses are compared, wherever the body stands</source>
        <translation>Comment deux poses sont comparées, où que se tienne le corps</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Étirement</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>Coût</translation>
    </message>
    <message>
        <source>Whether a transition&apos;s pose distances are summed, as published, or averaged</source>
        <translation>Si les distances de poses d’une transition sont sommées, comme publié, ou moyennées</translation>
    </message>
    <message>
        <source>Weigh by</source>
        <translation>Peser par</translation>
    </message>
    <message>
        <source>Whether transitions between calm takes must be better than those of lively ones</source>
        <translation>Si les transitions entre prises calmes doivent être meilleures qu’entre prises vives</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Pente</translation>
    </message>
    <message>
        <source>How many frames in a row one take may wait for the other, 2 to 5</source>
        <translation>Combien d’images de suite une prise peut attendre l’autre, 2 à 5</translation>
    </message>
    <message>
        <source>Shortest window</source>
        <translation>Fenêtre la plus courte</translation>
    </message>
    <message>
        <source>Frames of each take that a transition blends at the least, in seconds</source>
        <translation>Images de chaque prise qu’une transition fond au moins, en secondes</translation>
    </message>
    <message>
        <source>Longest window</source>
        <translation>Fenêtre la plus longue</translation>
    </message>
    <message>
        <source>Frames of each take that a transition blends at the most, in seconds</source>
        <translation>Images de chaque prise qu’une transition fond au plus, en secondes</translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation>Plus grande distance</translation>
    </message>
    <message>
        <source>What costs are divided by; automatic is the largest distance of two poses</source>
        <translation>Ce par quoi les coûts sont divisés&#xa0;; automatique&#xa0;: la plus grande distance de deux poses</translation>
    </message>
    <message>
        <source>By their surfaces</source>
        <translation>Par leurs surfaces</translation>
    </message>
    <message>
        <source>By their vertices</source>
        <translation>Par leurs sommets</translation>
    </message>
    <message>
        <source>Nothing else</source>
        <translation>Rien d’autre</translation>
    </message>
    <message>
        <source> frames</source>
        <extracomment>after a number: steps of a warp path in a row</extracomment>
        <translation> images</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatique</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Pieds</translation>
    </message>
    <message>
        <source>What it costs to blend frames of which every foot stands in one only, and as much to drag a foot over an eighth of the body’s height; 0 as published</source>
        <translation>Ce que coûte de fondre des images dont chaque pied n’est à l’appui que dans une seule, et autant de traîner un pied sur un huitième de la hauteur du corps&#xa0;; 0 comme publié</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>What it costs when body and feet move otherwise, for a body height a second; 0 as published</source>
        <translation>Ce que coûte un mouvement différent du corps et des pieds, pour une hauteur du corps par seconde&#xa0;; 0 comme publié</translation>
    </message>
    <message>
        <source>Costs and windows as the paper has them, for comparison: transitions show more</source>
        <translation>Coûts et fenêtres de l’article, pour comparer&#xa0;: les transitions se voient davantage</translation>
    </message>
    <message>
        <source>Seek transitions as published</source>
        <translation>Chercher les transitions comme publié</translation>
    </message>
    <message>
        <source>As published</source>
        <translation>Comme publié</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Lissage</translation>
    </message>
    <message>
        <source>Over how many frames costs are averaged before the minima of the motion graph are sought; as published over none</source>
        <translation>Sur combien d’images les coûts sont moyennés avant de chercher les minima du graphe de mouvement&#xa0;; comme publié, sur aucune</translation>
    </message>
    <message>
        <source>none</source>
        <comment>smoothing</comment>
        <translation>aucun</translation>
    </message>
    <message>
        <source>How long a transition lasts: while it follows its warp path, as published, its takes slow down; as the mean of its windows they keep their pace</source>
        <translation>Combien de temps dure une transition : suivant son chemin d’alignement, comme publié, ses prises ralentissent ; selon la moyenne de ses fenêtres, elles gardent leur allure</translation>
    </message>
    <message>
        <source>Distances of poses</source>
        <translation>Distances des poses</translation>
    </message>
    <message>
        <source>Weight of the surface&apos;s stretch against its rotation</source>
        <translation>Poids de l’étirement de la surface face à sa rotation</translation>
    </message>
    <message>
        <source>Costs of transitions</source>
        <translation>Coûts des transitions</translation>
    </message>
    <message>
        <source>Windows of transitions</source>
        <translation>Fenêtres des transitions</translation>
    </message>
    <message>
        <source>Sum</source>
        <comment>of distances</comment>
        <translation>Somme</translation>
    </message>
    <message>
        <source>Mean</source>
        <comment>of distances</comment>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>Liveliness</source>
        <translation>La vivacité</translation>
    </message>
    <message>
        <source>As long as</source>
        <translation>Aussi longue que</translation>
    </message>
    <message>
        <source>Its warp path</source>
        <translation>Son chemin</translation>
    </message>
    <message>
        <source>Its windows</source>
        <translation>Ses fenêtres</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triangles</translation>
    </message>
    <message>
        <source>How many triangles, or vertices, poses are compared by, spread evenly over the surface; fewer take less time and are less exact. Automatic: all, or 1,000 where there are more than 5,000 frames</source>
        <translation>Par combien de triangles, ou de sommets, les poses sont comparées, répartis également sur la surface ; moins prend moins de temps et est moins exact. Automatique : tous, ou 1 000 s’il y a plus de 5 000 images</translation>
    </message>
</context>
<context>
    <name>quadrille::GraphStatePage</name>
    <message>
        <source>%1 frames need about %2 of memory, more than this computer has. Trim sequences or remove some.</source>
        <translation>%1 images demandent environ %2 de mémoire, plus que cet ordinateur n’en a. Rognez des séquences ou retirez-en.</translation>
    </message>
    <message>
        <source>%1 frames, about %2 of memory</source>
        <translation>%1 images, environ %2 de mémoire</translation>
    </message>
    <message>
        <source>No graph yet</source>
        <translation>Pas encore de graphe</translation>
    </message>
    <message>
        <source>The graph holds every transition from one frame to another. It is computed from all sequences of the character.</source>
        <translation>Le graphe contient chaque transition d’une image à une autre. Il est calculé à partir de toutes les séquences du personnage.</translation>
    </message>
    <message>
        <source>No sequences yet</source>
        <translation>Pas encore de séquences</translation>
    </message>
    <message>
        <source>Transitions lead from one sequence to another: import some first.</source>
        <translation>Les transitions mènent d’une séquence à une autre&#xa0;: importez-en d’abord.</translation>
    </message>
    <message>
        <source>Computing the graph</source>
        <translation>Calcul du graphe</translation>
    </message>
    <message>
        <source>Pose distances, transitions and both graphs. You can go on working meanwhile.</source>
        <translation>Distances de poses, transitions et les deux graphes. Vous pouvez continuer à travailler.</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Arrêter</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>&amp;Compute the graph</source>
        <translation>&amp;Calculer le graphe</translation>
    </message>
    <message>
        <source>&amp;Import sequences…</source>
        <translation>&amp;Importer des séquences…</translation>
    </message>
    <message>
        <source>&amp;Try again</source>
        <translation>&amp;Réessayer</translation>
    </message>
</context>
<context>
    <name>quadrille::GraphWorkspace</name>
    <message>
        <source>Graph</source>
        <translation>Graphe</translation>
    </message>
    <message>
        <source>&amp;Compute the graph</source>
        <translation>&amp;Calculer le graphe</translation>
    </message>
    <message>
        <source>Finds every transition between the frames of a character</source>
        <translation>Trouve chaque transition entre les images d’un personnage</translation>
    </message>
    <message>
        <source>S&amp;top computing</source>
        <translation>Arrê&amp;ter le calcul</translation>
    </message>
    <message>
        <source>Leaves the graph as it was</source>
        <translation>Laisse le graphe comme il était</translation>
    </message>
    <message>
        <source>&amp;Play the transition</source>
        <translation>&amp;Lire la transition</translation>
    </message>
    <message>
        <source>Blends the chosen transition and plays it with some frames around it</source>
        <translation>Fond la transition choisie et la joue avec quelques images autour</translation>
    </message>
    <message>
        <source>Show &amp;both frames</source>
        <translation>Montrer les &amp;deux images</translation>
    </message>
    <message>
        <source>Shows where the chosen transition leaves and where it arrives</source>
        <translation>Montre d’où part la transition choisie et où elle arrive</translation>
    </message>
    <message>
        <source>Blend &amp;gently</source>
        <translation>Fondre en &amp;douceur</translation>
    </message>
    <message>
        <source>Keeps speeds smooth and standing feet in place, as animations can</source>
        <translation>Garde des vitesses régulières et les pieds posés en place, comme le peuvent les animations</translation>
    </message>
    <message>
        <source>&amp;Lower α</source>
        <translation>&amp;Baisser α</translation>
    </message>
    <message>
        <source>Lets the graphs prefer little deformation</source>
        <translation>Fait préférer aux graphes peu de déformation</translation>
    </message>
    <message>
        <source>&amp;Raise α</source>
        <translation>&amp;Augmenter α</translation>
    </message>
    <message>
        <source>Lets the graphs prefer short ways</source>
        <translation>Fait préférer aux graphes les chemins courts</translation>
    </message>
    <message>
        <source>&amp;Save tables…</source>
        <translation>Enregi&amp;strer les tableaux…</translation>
    </message>
    <message>
        <source>Edges, statistics and components of both graphs as CSV files</source>
        <translation>Arêtes, statistiques et composantes des deux graphes en fichiers CSV</translation>
    </message>
    <message>
        <source>Show costs as a &amp;matrix</source>
        <translation>Montrer les coûts en &amp;matrice</translation>
    </message>
    <message>
        <source>Each cell is a transition from the frame of its row to that of its column</source>
        <translation>Chaque case est une transition de l’image de sa ligne à celle de sa colonne</translation>
    </message>
    <message>
        <source>Show edges as &amp;arcs</source>
        <translation>Montrer les arêtes en &amp;arcs</translation>
    </message>
    <message>
        <source>The Essential graph above the sequences, the motion graph below</source>
        <translation>Le graphe essentiel au-dessus des séquences, le graphe de mouvement au-dessous</translation>
    </message>
    <message>
        <source>&amp;Essential graph on the matrix</source>
        <translation>Graphe &amp;essentiel sur la matrice</translation>
    </message>
    <message>
        <source>Marks transitions that no cheaper way can replace with rings</source>
        <translation>Marque d’anneaux les transitions qu’aucun chemin moins cher ne remplace</translation>
    </message>
    <message>
        <source>M&amp;otion graph on the matrix</source>
        <translation>Graphe de &amp;mouvement sur la matrice</translation>
    </message>
    <message>
        <source>Marks transitions of locally least cost with diamonds</source>
        <translation>Marque de losanges les transitions de coût localement minimal</translation>
    </message>
    <message>
        <source>Show the &amp;whole matrix</source>
        <translation>Montrer &amp;toute la matrice</translation>
    </message>
    <message>
        <source>Zooms out until all frames show</source>
        <translation>Dézoome jusqu’à montrer toutes les images</translation>
    </message>
    <message>
        <source>W&amp;hy this transition</source>
        <translation>&amp;Pourquoi cette transition</translation>
    </message>
    <message>
        <source>Its cost in parts, and what could be taken instead</source>
        <translation>Son coût en parts, et ce qu’on pourrait prendre à la place</translation>
    </message>
    <message>
        <source>Charts over α</source>
        <translation>Courbes selon α</translation>
    </message>
    <message>
        <source>Density, edges and mean cost of both graphs</source>
        <translation>Densité, arêtes et coût moyen des deux graphes</translation>
    </message>
    <message>
        <source>Gaps of the &amp;graphs</source>
        <translation>Lacunes des &amp;graphes</translation>
    </message>
    <message>
        <source>Frames that walks do not reach, and what would help</source>
        <translation>Images que les parcours n’atteignent pas, et ce qui aiderait</translation>
    </message>
    <message>
        <source>Graph sett&amp;ings</source>
        <translation>&amp;Réglages du graphe</translation>
    </message>
    <message>
        <source>How poses are compared and which transitions are sought</source>
        <translation>Comment les poses sont comparées et quelles transitions sont cherchées</translation>
    </message>
    <message>
        <source>Saving tables</source>
        <translation>Enregistrement des tableaux</translation>
    </message>
    <message numerus="yes">
        <source>%n table(s) were saved in %1.</source>
        <translation>
            <numerusform>%n tableau a été enregistré dans %1.</numerusform>
            <numerusform>%n tableaux ont été enregistrés dans %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>blended</source>
        <translation>fondu</translation>
    </message>
    <message>
        <source>Transition</source>
        <translation>Transition</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Courbes</translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>Lacunes</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>Transitions</source>
        <translation>Transitions</translation>
    </message>
    <message>
        <source>Point at the map to see two frames; click to play the transition.</source>
        <translation>Pointez la carte pour voir deux images&#xa0;; cliquez pour jouer la transition.</translation>
    </message>
    <message>
        <source>The graph is computed anew; this is the one before.</source>
        <translation>Le graphe est recalculé&#xa0;; voici le précédent.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>The settings have changed since this graph was computed.</source>
        <translation>Les réglages ont changé depuis le calcul de ce graphe.</translation>
    </message>
    <message>
        <source>Compute</source>
        <translation>Calculer</translation>
    </message>
    <message>
        <source>%1 · %2 frames (%3 s) · windows %4 and %5</source>
        <extracomment>a cell of the map, then how long its transition is in frames and seconds, and its windows in frames</extracomment>
        <translation>%1 · %2 images (%3 s) · fenêtres %4 et %5</translation>
    </message>
    <message>
        <source>%1 · Essential graph</source>
        <translation>%1 · graphe essentiel</translation>
    </message>
    <message>
        <source>%1 · motion graph</source>
        <translation>%1 · graphe de mouvement</translation>
    </message>
    <message>
        <source>Point at the map to read costs</source>
        <translation>Pointez la carte pour lire les coûts</translation>
    </message>
    <message>
        <source>Folder for the tables</source>
        <translation>Dossier des tableaux</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Réessayer</translation>
    </message>
    <message>
        <source>Show ta&amp;kes and their transitions</source>
        <translation>Montrer les prises et leurs &amp;transitions</translation>
    </message>
    <message>
        <source>Each take is a node; arrows count the transitions from one to another</source>
        <translation>Chaque prise est un nœud&#xa0;; les flèches comptent les transitions de l’une à l’autre</translation>
    </message>
    <message>
        <source>Cop&amp;y the frames</source>
        <translation>Co&amp;pier les images</translation>
    </message>
    <message>
        <source>Puts the names of both frames onto the clipboard</source>
        <translation>Met les noms des deux images dans le presse-papiers</translation>
    </message>
    <message>
        <source>&amp;Only these takes</source>
        <translation>&amp;Seulement ces prises</translation>
    </message>
    <message>
        <source>&amp;All takes</source>
        <translation>&amp;Toutes les prises</translation>
    </message>
    <message>
        <source>&amp;Ban it in “%1”</source>
        <extracomment>an animation</extracomment>
        <translation>L’&amp;interdire dans «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Allow a transition</source>
        <translation>Permettre une transition</translation>
    </message>
    <message>
        <source>Ban a transition</source>
        <translation>Bannir une transition</translation>
    </message>
    <message>
        <source>Of what the transition is made</source>
        <translation>De quoi la transition est faite</translation>
    </message>
    <message>
        <source>&amp;List the best transitions from “%1” to “%2”</source>
        <extracomment>two takes</extracomment>
        <translation>Lister les &amp;meilleures transitions de «&#xa0;%1&#xa0;» à «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>&amp;Only this take</source>
        <translation>&amp;Seulement cette prise</translation>
    </message>
    <message>
        <source>The graph is being opened…</source>
        <translation>Le graphe s’ouvre…</translation>
    </message>
</context>
<context>
    <name>quadrille::HelpFlow</name>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Manuel</translation>
    </message>
    <message>
        <source>&amp;Help on this</source>
        <translation>&amp;Aide sur ceci</translation>
    </message>
    <message>
        <source>Opens the manual at what the mouse points at or has the focus</source>
        <translation>Ouvre le manuel à l’endroit qui traite de ce que montre la souris ou de ce qui a le focus</translation>
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
    <message>
        <source>The help does not have these words together.</source>
        <translation>Aucune page de l’aide ne réunit ces mots.</translation>
    </message>
    <message>
        <source>Places found</source>
        <translation>Passages trouvés</translation>
    </message>
    <message>
        <source>Find in the help</source>
        <translation>Chercher dans l’aide</translation>
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
        <source>as found</source>
        <translation>comme trouvé</translation>
    </message>
    <message>
        <source>Frames a second of this take and of those with the same rate</source>
        <translation>Images par seconde de cette prise et de celles qui ont la même cadence</translation>
    </message>
    <message numerus="yes">
        <source>The rate of %n take(s) is not known.</source>
        <translation>
            <numerusform>La cadence de %n prise n’est pas connue.</numerusform>
            <numerusform>La cadence de %n prises n’est pas connue.</numerusform>
        </translation>
    </message>
    <message>
        <source>Set the rate at which they were captured.</source>
        <translation>Indiquez la cadence de leur capture.</translation>
    </message>
    <message>
        <source>%1 fps is right</source>
        <translation>%1 i/s est juste</translation>
    </message>
    <message>
        <source>The file says so.</source>
        <translation>Le fichier l’indique.</translation>
    </message>
    <message>
        <source>As you set it.</source>
        <translation>Comme vous l’avez indiquée.</translation>
    </message>
    <message>
        <source>As in %1 beside it.</source>
        <translation>Comme dans %1, à côté.</translation>
    </message>
    <message>
        <source>As the other takes of the character.</source>
        <translation>Comme les autres prises du personnage.</translation>
    </message>
    <message>
        <source>A guess: nothing beside the take names its rate.</source>
        <translation>Une supposition&#xa0;: rien à côté de la prise n’indique sa cadence.</translation>
    </message>
    <message>
        <source>%1 fps are taken for it. %2</source>
        <comment>a rate, and a sentence with the reason</comment>
        <translation>%1 i/s sont retenues pour elle. %2</translation>
    </message>
    <message numerus="yes">
        <source>Import %n take(s) at %1 fps</source>
        <translation>
            <numerusform>Importer %n prise à %1 i/s</numerusform>
            <numerusform>Importer %n prises à %1 i/s</numerusform>
        </translation>
    </message>
    <message>
        <source>A guess: its keys are uneven, or too few to tell a rate.</source>
        <translation>Une supposition&#xa0;: ses clés sont irrégulières, ou trop peu nombreuses pour dire une cadence.</translation>
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
    <message>
        <source>Show what it is about</source>
        <translation>Montrer ce dont il s’agit</translation>
    </message>
    <message>
        <source>Copy the text</source>
        <translation>Copier le texte</translation>
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
        <translation>Annuler «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>quadrille::JunctionInspector</name>
    <message>
        <source>Measuring a transition</source>
        <translation>Mesure d’une transition</translation>
    </message>
</context>
<context>
    <name>quadrille::JunctionPanel</name>
    <message>
        <source>Animate</source>
        <translation>Animer</translation>
    </message>
    <message>
        <source>Previous &amp;transition</source>
        <translation>&amp;Transition précédente</translation>
    </message>
    <message>
        <source>Ne&amp;xt transition</source>
        <translation>Transition &amp;suivante</translation>
    </message>
    <message>
        <source>&amp;Play around the transition</source>
        <translation>&amp;Lire autour de la transition</translation>
    </message>
    <message>
        <source>Plays the selected transition with half a second before and behind</source>
        <translation>Lit la transition sélectionnée avec une demi-seconde avant et après</translation>
    </message>
    <message>
        <source>&amp;Ban the transition</source>
        <translation>&amp;Bannir la transition</translation>
    </message>
    <message>
        <source>Never uses the selected transition, and seeks another way</source>
        <translation>N’utilise jamais la transition sélectionnée, et cherche un autre chemin</translation>
    </message>
    <message>
        <source>Ban it and its nei&amp;ghbours</source>
        <translation>La bannir avec ses v&amp;oisines</translation>
    </message>
    <message>
        <source>Never uses the selected transition, nor those within two frames of it</source>
        <translation>N’utilise jamais la transition sélectionnée, ni celles à deux images près</translation>
    </message>
    <message>
        <source>Choose an&amp;other</source>
        <translation>En choisir une a&amp;utre</translation>
    </message>
    <message>
        <source>Lists the next best transitions nearby, to be seen and taken</source>
        <translation>Liste les meilleures transitions suivantes alentour, à voir et à prendre</translation>
    </message>
    <message>
        <source>&amp;Lock the transition</source>
        <translation>&amp;Verrouiller la transition</translation>
    </message>
    <message>
        <source>Keeps the selected transition whatever else is asked for</source>
        <translation>Garde la transition sélectionnée quoi qu’on demande d’autre</translation>
    </message>
    <message>
        <source>Lock the se&amp;gment</source>
        <translation>Verrouiller le se&amp;gment</translation>
    </message>
    <message>
        <source>Keeps the transitions at both ends of the captured frames that are shown</source>
        <translation>Garde les transitions aux deux bouts des images captées qui sont montrées</translation>
    </message>
    <message>
        <source>&amp;Take the decision back</source>
        <translation>&amp;Reprendre la décision</translation>
    </message>
    <message>
        <source>Forgets what was decided about the transition in the list of decisions</source>
        <translation>Oublie ce qui a été décidé de la transition dans la liste des décisions</translation>
    </message>
    <message>
        <source>&amp;Accept the walk</source>
        <translation>&amp;Accepter le parcours</translation>
    </message>
    <message>
        <source>Keeps the walk that is shown: nothing is sought any more</source>
        <translation>Garde le parcours montré&#xa0;: rien n’est plus cherché</translation>
    </message>
    <message>
        <source>Choose another transition</source>
        <translation>Choisir une autre transition</translation>
    </message>
    <message>
        <source>Ban a transition</source>
        <translation>Bannir une transition</translation>
    </message>
    <message>
        <source>Ban a transition and its neighbours</source>
        <translation>Bannir une transition et ses voisines</translation>
    </message>
    <message>
        <source>Unlock a transition</source>
        <translation>Déverrouiller une transition</translation>
    </message>
    <message>
        <source>Lock a transition</source>
        <translation>Verrouiller une transition</translation>
    </message>
    <message>
        <source>Lock a segment</source>
        <translation>Verrouiller un segment</translation>
    </message>
    <message>
        <source>Take a decision back</source>
        <translation>Reprendre une décision</translation>
    </message>
    <message>
        <source>Accept the walk</source>
        <translation>Accepter le parcours</translation>
    </message>
    <message>
        <source>Seek again</source>
        <translation>Chercher à nouveau</translation>
    </message>
    <message>
        <source>cut</source>
        <comment>a transition that is not in the clip any more</comment>
        <translation>coupée</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Verrouillée</translation>
    </message>
    <message>
        <source>Chosen</source>
        <translation>Choisie</translation>
    </message>
    <message>
        <source>Banned</source>
        <translation>Bannie</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s)</source>
        <comment>length of a transition</comment>
        <translation>
            <numerusform>%n image</numerusform>
            <numerusform>%n images</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2 s. Cost %3: deformation %4, duration %5.</source>
        <translation>%1, %2 s. Coût %3&#xa0;: déformation %4, durée %5.</translation>
    </message>
    <message>
        <source>jerk</source>
        <translation>à-coups</translation>
    </message>
    <message>
        <source>stand-still</source>
        <translation>pose figée</translation>
    </message>
    <message>
        <source>leap</source>
        <translation>saut</translation>
    </message>
    <message>
        <source>foot slip</source>
        <translation>glissement</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>volume</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>Should not show:</source>
        <translation>Ne devrait pas se voir&#xa0;:</translation>
    </message>
    <message>
        <source>May show:</source>
        <translation>Peut se voir&#xa0;:</translation>
    </message>
    <message>
        <source>This walk was accepted: it stays as it is, and nothing is sought.</source>
        <translation>Ce parcours a été accepté&#xa0;: il reste tel quel, et rien n’est cherché.</translation>
    </message>
    <message>
        <source>At</source>
        <translation>À</translation>
    </message>
    <message>
        <source>Transition</source>
        <translation>Transition</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>Coût</translation>
    </message>
    <message>
        <source>Transitions of the clip</source>
        <translation>Transitions du clip</translation>
    </message>
    <message>
        <source>Instead of it</source>
        <translation>À sa place</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Transitions nearby</source>
        <translation>Transitions alentour</translation>
    </message>
    <message>
        <source>Point at one to see it; double-click or Return takes it</source>
        <translation>Pointez-en une pour la voir&#xa0;; double-clic ou Entrée la prend</translation>
    </message>
    <message>
        <source>Decided</source>
        <translation>Décisions</translation>
    </message>
    <message>
        <source>Decision</source>
        <translation>Décision</translation>
    </message>
    <message>
        <source>Decisions about transitions</source>
        <translation>Décisions sur les transitions</translation>
    </message>
    <message>
        <source>The transitions of the clip come here: to be played, banned, locked or exchanged. There is none yet.</source>
        <translation>Les transitions du clip viennent ici&#xa0;: pour être lues, bannies, verrouillées ou échangées. Il n’y en a pas encore.</translation>
    </message>
    <message>
        <source>A click goes there and plays around it</source>
        <translation>Un clic y va et lit autour</translation>
    </message>
    <message>
        <source>How much of what is still good is used up, measured on the frames of the transition: what is above 100 % is likely to be seen</source>
        <translation>Part utilisée de ce qui est encore bon, mesurée sur les images de la transition&#xa0;: ce qui dépasse 100 % se verra sans doute</translation>
    </message>
    <message>
        <source>Seek the whole &amp;walk again</source>
        <translation>Chercher à nouveau tout le &amp;parcours</translation>
    </message>
    <message>
        <source>Forgets the walk that was accepted, or that decisions keep to, and seeks what is asked for</source>
        <translation>Oublie le parcours accepté, ou celui auquel les décisions se tiennent, et cherche ce qui est demandé</translation>
    </message>
    <message>
        <source>Only what you decide changes, and what is next to it; the rest of the walk stays.</source>
        <translation>Seul change ce que vous décidez, et ce qui est à côté&#xa0;; le reste du parcours demeure.</translation>
    </message>
    <message>
        <source>No other transition is nearby.</source>
        <translation>Aucune autre transition n’est proche.</translation>
    </message>
</context>
<context>
    <name>quadrille::KeysAndStoryboard</name>
    <message>
        <source>Storyboard</source>
        <translation>Scénario</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Clés</translation>
    </message>
    <message>
        <source>Animate</source>
        <translation>Animer</translation>
    </message>
    <message>
        <source>Add as &amp;key</source>
        <translation>Ajouter comme &amp;clé</translation>
    </message>
    <message>
        <source>Ask for the pose that is shown now, at the animation&apos;s playhead</source>
        <translation>Demander la pose montrée maintenant, à la tête de lecture de l’animation</translation>
    </message>
    <message>
        <source>There is no pose to add: select a take, or show a clip.</source>
        <translation>Pas de pose à ajouter&#xa0;: sélectionnez une prise, ou montrez un clip.</translation>
    </message>
    <message>
        <source>Key “%1” added to “%2”</source>
        <translation>Clé «&#xa0;%1&#xa0;» ajoutée à «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>R&amp;emove the key</source>
        <translation>&amp;Retirer la clé</translation>
    </message>
    <message>
        <source>Remove the key that is selected on the timeline</source>
        <translation>Retirer la clé sélectionnée sur la ligne de temps</translation>
    </message>
    <message>
        <source>Pre&amp;vious key</source>
        <translation>Clé &amp;précédente</translation>
    </message>
    <message>
        <source>Go to the key before the playhead</source>
        <translation>Aller à la clé avant la tête de lecture</translation>
    </message>
    <message>
        <source>Ne&amp;xt key</source>
        <translation>Clé &amp;suivante</translation>
    </message>
    <message>
        <source>Go to the key behind the playhead</source>
        <translation>Aller à la clé derrière la tête de lecture</translation>
    </message>
    <message>
        <source>Add to the s&amp;toryboard</source>
        <translation>Ajouter au &amp;scénario</translation>
    </message>
    <message>
        <source>Let the selected takes be performed in the animation, one after the other</source>
        <translation>Faire jouer les prises sélectionnées dans l’animation, l’une après l’autre</translation>
    </message>
    <message numerus="yes">
        <source>%n takes added to the storyboard of “%1”</source>
        <translation>
            <numerusform>%n prise ajoutée au scénario de «&#xa0;%1&#xa0;»</numerusform>
            <numerusform>%n prises ajoutées au scénario de «&#xa0;%1&#xa0;»</numerusform>
        </translation>
    </message>
    <message>
        <source>Change the notes of “%1”</source>
        <translation>Changer les notes de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
</context>
<context>
    <name>quadrille::KeysModel</name>
    <message>
        <source>any</source>
        <translation>libre</translation>
    </message>
    <message>
        <source>F2 or another click edits it, a double click goes there</source>
        <translation>F2 ou un autre clic le modifie, un double clic y va</translation>
    </message>
    <message>
        <source>Further off than its tolerance allows</source>
        <translation>Plus d’écart que permis</translation>
    </message>
    <message>
        <source>A double click goes there</source>
        <translation>Un double clic y va</translation>
    </message>
    <message>
        <source>The sequence and the frame of it that is to be shown</source>
        <translation>La séquence, et son image qui doit être montrée</translation>
    </message>
    <message>
        <source>When it is to be shown</source>
        <translation>Quand elle doit être montrée</translation>
    </message>
    <message>
        <source>When it is shown</source>
        <translation>Quand elle est montrée</translation>
    </message>
    <message>
        <source>How much later than wanted; below 0 for earlier</source>
        <translation>De combien plus tard que voulu&#xa0;; moins de 0 pour plus tôt</translation>
    </message>
    <message>
        <source>By how much the time may be missed at most</source>
        <translation>De combien le moment peut être manqué au plus</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Pose</translation>
    </message>
    <message>
        <source>Wanted (s)</source>
        <translation>Voulu (s)</translation>
    </message>
    <message>
        <source>Obtained (s)</source>
        <translation>Obtenu (s)</translation>
    </message>
    <message>
        <source>Off (s)</source>
        <translation>Écart (s)</translation>
    </message>
    <message>
        <source>May be off (s)</source>
        <translation>Écart permis (s)</translation>
    </message>
    <message>
        <source>Move key</source>
        <translation>Déplacer une clé</translation>
    </message>
    <message>
        <source>Change the tolerance of a key</source>
        <translation>Changer l’écart permis d’une clé</translation>
    </message>
</context>
<context>
    <name>quadrille::KeysPanel</name>
    <message>
        <source>any</source>
        <translation>libre</translation>
    </message>
    <message>
        <source>Change how keys are sought</source>
        <translation>Changer la recherche des clés</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Clés</translation>
    </message>
    <message>
        <source>Poses at times: drag the picture of a card onto the timeline, or put the pose that is shown at the playhead.</source>
        <translation>Des poses à des moments&#xa0;: glissez l’image d’une carte sur la ligne de temps, ou mettez la pose montrée à la tête de lecture.</translation>
    </message>
    <message>
        <source>Remove the key</source>
        <translation>Retirer la clé</translation>
    </message>
    <message>
        <source>Seek all keys at once</source>
        <translation>Chercher toutes les clés à la fois</translation>
    </message>
    <message>
        <source>Slower, and never worse: the errors of all keys are weighed against each other instead of one key after the other</source>
        <translation>Plus lent, et jamais moins bon&#xa0;: les écarts de toutes les clés sont pesés les uns contre les autres au lieu d’une clé après l’autre</translation>
    </message>
    <message>
        <source>At most %1 s off</source>
        <translation>Au plus %1 s d’écart</translation>
    </message>
    <message>
        <source>Add the shown pose</source>
        <translation>Ajouter la pose affichée</translation>
    </message>
    <message>
        <source>Go to key</source>
        <translation>Aller à la pose</translation>
    </message>
    <message>
        <source>Edit the time</source>
        <translation>Modifier le temps</translation>
    </message>
    <message>
        <source>Edit the tolerance</source>
        <translation>Modifier la tolérance</translation>
    </message>
    <message>
        <source>Remove key</source>
        <translation>Retirer une clé</translation>
    </message>
</context>
<context>
    <name>quadrille::LabelList</name>
    <message>
        <source>Labels</source>
        <translation>Étiquettes</translation>
    </message>
    <message>
        <source>Drag a label between the cards, or press Return: any take that has it may be played</source>
        <translation>Glissez une étiquette entre les cartes, ou appuyez sur Entrée&#xa0;: toute prise qui la porte peut être jouée</translation>
    </message>
</context>
<context>
    <name>quadrille::LabelTakes</name>
    <message numerus="yes">
        <source>Label %n take(s)</source>
        <translation>
            <numerusform>Étiqueter %n prise</numerusform>
            <numerusform>Étiqueter %n prises</numerusform>
        </translation>
    </message>
    <message>
        <source>as below</source>
        <translation>comme ci-dessous</translation>
    </message>
    <message>
        <source>One label for all of these takes</source>
        <translation>Une étiquette pour toutes ces prises</translation>
    </message>
    <message>
        <source>Labels of the takes</source>
        <translation>Étiquettes des prises</translation>
    </message>
    <message>
        <source>&amp;Label for all:</source>
        <translation>É&amp;tiquette pour toutes&#xa0;:</translation>
    </message>
    <message>
        <source>Each label covers its whole take. A take without one is left as it is.</source>
        <translation>Chaque étiquette couvre toute sa prise. Une prise sans étiquette reste telle quelle.</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Étiquette</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>Prise</translation>
    </message>
    <message>
        <source>This take is not open.</source>
        <translation>Cette prise n’est pas ouverte.</translation>
    </message>
</context>
<context>
    <name>quadrille::LatentPanel</name>
    <message>
        <source>Variations</source>
        <translation>Variations</translation>
    </message>
    <message>
        <source>&amp;Confidence in the latent space</source>
        <translation>&amp;Confiance dans l’espace latent</translation>
    </message>
    <message>
        <source>Colours tell how sure the model is, instead of which take a line is</source>
        <translation>Les couleurs disent combien le modèle est sûr, au lieu de distinguer les prises</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Partie</translation>
    </message>
    <message>
        <source>The part of the body whose latent space is shown</source>
        <translation>La partie du corps dont l’espace latent est montré</translation>
    </message>
    <message>
        <source>Latent space</source>
        <translation>Espace latent</translation>
    </message>
    <message>
        <source>Each take becomes a line in the latent space of a part, once the movement is learned.</source>
        <translation>Chaque prise devient une ligne dans l’espace latent d’une partie, une fois le mouvement appris.</translation>
    </message>
    <message>
        <source>Variation %1</source>
        <translation>Variation %1</translation>
    </message>
    <message>
        <source>Confidence of “%1”</source>
        <translation>Confiance de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>log₁₀ variance</source>
        <translation>log₁₀ variance</translation>
    </message>
    <message>
        <source>Show the whole laten&amp;t space</source>
        <translation>Montrer tout l’espace laten&amp;t</translation>
    </message>
    <message>
        <source>Brings all lines into the view; in the view itself, F does so</source>
        <translation>Ramène toutes les lignes dans la vue&#xa0;; dans la vue même, F le fait</translation>
    </message>
</context>
<context>
    <name>quadrille::LayoutMenu</name>
    <message>
        <source>View</source>
        <translation>Affichage</translation>
    </message>
    <message>
        <source>&amp;Save the layout…</source>
        <translation>&amp;Enregistrer la disposition…</translation>
    </message>
    <message>
        <source>Give the arrangement of the panels a name, to come back to it</source>
        <translation>Donner un nom à la disposition des panneaux, pour y revenir</translation>
    </message>
    <message>
        <source>&amp;Reset the layout</source>
        <translation>&amp;Rétablir la disposition</translation>
    </message>
    <message>
        <source>Put the panels of this workspace where they were at first</source>
        <translation>Remettre les panneaux de cet espace à leur place d’origine</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Save the layout</source>
        <translation>Enregistrer la disposition</translation>
    </message>
    <message>
        <source>Name of the layout; one that is there already is replaced:</source>
        <translation>Nom de la disposition&#xa0;; une disposition du même nom est remplacée&#xa0;:</translation>
    </message>
</context>
<context>
    <name>quadrille::LearningPanel</name>
    <message>
        <source>being learned</source>
        <translation>en cours</translation>
    </message>
    <message>
        <source>converged</source>
        <translation>convergé</translation>
    </message>
    <message>
        <source>as low as it goes</source>
        <translation>aussi bas que possible</translation>
    </message>
    <message>
        <source>stopped at the limit of iterations</source>
        <translation>arrêté à la limite d’itérations</translation>
    </message>
    <message>
        <source>stopped by you: the best so far</source>
        <translation>arrêté par vous&#xa0;: le meilleur trouvé</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Partie</translation>
    </message>
    <message>
        <source>Objective</source>
        <translation>Objectif</translation>
    </message>
    <message>
        <source>Error, mm</source>
        <translation>Erreur, mm</translation>
    </message>
    <message>
        <source>PCA, mm</source>
        <translation>ACP, mm</translation>
    </message>
    <message>
        <source>Mean distance of the reconstructed training poses, millimetres</source>
        <translation>Distance moyenne des poses apprises reconstruites, en millimètres</translation>
    </message>
    <message>
        <source>The same with as many principal components</source>
        <translation>La même avec autant de composantes principales</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Parties</translation>
    </message>
    <message>
        <source>Iteration</source>
        <translation>Itération</translation>
    </message>
    <message>
        <source>What is minimised shows here while it is learned.</source>
        <translation>Ce qui est minimisé se voit ici pendant l’apprentissage.</translation>
    </message>
    <message numerus="yes">
        <source>%n iterations, %1</source>
        <translation>
            <numerusform>%n itération, %1</numerusform>
            <numerusform>%n itérations, %1</numerusform>
        </translation>
    </message>
    <message>
        <source>At the bound of what it may be</source>
        <translation>À la borne de ce qu’il peut être</translation>
    </message>
</context>
<context>
    <name>quadrille::LearningSettings</name>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>Learning</source>
        <translation>Apprentissage</translation>
    </message>
    <message>
        <source>Dimensions</source>
        <translation>Dimensions</translation>
    </message>
    <message>
        <source>Of the latent space: more follow the takes closer and vary less; 1 to 10</source>
        <translation>De l’espace latent&#xa0;: plus il y en a, plus il suit les prises et moins il varie&#xa0;; de 1 à 10</translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation>Déplacement</translation>
    </message>
    <message>
        <source>How much the way over the ground counts against the pose: its variance in mean variances of a coordinate</source>
        <translation>Poids du chemin au sol face à la pose&#xa0;: sa variance en variances moyennes d’une coordonnée</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Tirage</translation>
    </message>
    <message>
        <source>Advanced: learning</source>
        <translation>Avancé&#xa0;: apprentissage</translation>
    </message>
    <message>
        <source>Restarts</source>
        <translation>Redémarrages</translation>
    </message>
    <message>
        <source>Starts beyond the first, from disturbed principal components; the best counts</source>
        <translation>Départs après le premier, à partir de composantes principales perturbées&#xa0;; le meilleur compte</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>Of the restarts: the same seed learns the same</source>
        <translation>Des nouveaux départs&#xa0;: la même graine apprend la même chose</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>Learning stops where the objective fell by less than this share of itself, in parts per million, over the window</source>
        <translation>L’apprentissage s’arrête quand l’objectif a baissé de moins que cette part de lui-même, en millionièmes, sur la fenêtre</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenêtre</translation>
    </message>
    <message>
        <source>Over how many iterations the fall of the objective is looked at</source>
        <translation>Sur combien d’itérations on regarde la baisse de l’objectif</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Au plus</translation>
    </message>
    <message>
        <source>Iterations of one start; the panel says where these were not enough</source>
        <translation>Itérations d’un départ&#xa0;; le panneau dit où elles n’ont pas suffi</translation>
    </message>
    <message>
        <source>Advanced: drawing</source>
        <translation>Avancé&#xa0;: tirage</translation>
    </message>
    <message>
        <source>Leapfrog steps</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>At most, of each proposal of Hybrid Monte Carlo: more wander further</source>
        <translation>Au plus, de chaque proposition du Monte-Carlo hybride&#xa0;: plus il y en a, plus elle va loin</translation>
    </message>
    <message>
        <source>Burn-in</source>
        <translation>Rodage</translation>
    </message>
    <message>
        <source>Proposals before the first variation, while the step size is tuned</source>
        <translation>Propositions avant la première variation, pendant que le pas est réglé</translation>
    </message>
    <message>
        <source>Thinning</source>
        <translation>Espacement</translation>
    </message>
    <message>
        <source>Proposals from one variation to the next: more are less alike</source>
        <translation>Propositions d’une variation à la suivante&#xa0;: plus il y en a, moins elles se ressemblent</translation>
    </message>
    <message>
        <source>Accepted, at least</source>
        <translation>Acceptées, au moins</translation>
    </message>
    <message>
        <source>The step size is made smaller where fewer proposals are accepted</source>
        <translation>Le pas est réduit quand moins de propositions sont acceptées</translation>
    </message>
    <message>
        <source>Accepted, at most</source>
        <translation>Acceptées, au plus</translation>
    </message>
    <message>
        <source>The step size is made greater where more proposals are accepted</source>
        <translation>Le pas est agrandi quand plus de propositions sont acceptées</translation>
    </message>
    <message>
        <source>Advanced: what is rejected</source>
        <translation>Avancé&#xa0;: ce qui est rejeté</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>How far the worst pose may be from the nearest one that was learned from: as far as takes of the same movement are from each other, or in sizes of the figure</source>
        <translation>À quelle distance de la plus proche pose apprise la pire pose peut être : aussi loin que les prises du même mouvement le sont l’une de l’autre, ou en tailles de la figure</translation>
    </message>
    <message>
        <source>As the takes</source>
        <comment>the limit of the distance</comment>
        <translation>Comme les prises</translation>
    </message>
    <message>
        <source>Skate</source>
        <translation>Glissement</translation>
    </message>
    <message>
        <source>How much faster standing feet may slide than in the take, in sizes of the figure a second</source>
        <translation>De combien les pieds posés peuvent glisser plus vite que dans la prise, en tailles de la figure par seconde</translation>
    </message>
    <message>
        <source>Crossings</source>
        <translation>Croisements</translation>
    </message>
    <message>
        <source>How many more triangles may go through each other than in the take, as a share of all</source>
        <translation>Combien de triangles de plus que dans la prise peuvent se traverser, en part de tous</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>How far the body’s volume may leave that of the takes</source>
        <translation>De combien le volume du corps peut s’écarter de celui des prises</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>Poses</translation>
    </message>
    <message>
        <source>The most probable pose of each place in the latent space, or one draw for all frames</source>
        <translation>La pose la plus probable de chaque lieu de l’espace latent, ou un seul tirage pour toutes les images</translation>
    </message>
    <message>
        <source>Most probable</source>
        <translation>La plus probable</translation>
    </message>
    <message>
        <source>One draw</source>
        <translation>Un tirage</translation>
    </message>
    <message>
        <source>Takes slip from feet that touch the ground in the take, before variations are judged</source>
        <translation>Retire le glissement des pieds qui touchent le sol dans la prise, avant que les variations soient jugées</translation>
    </message>
    <message>
        <source>Collapse</source>
        <translation>Effondrement</translation>
    </message>
    <message>
        <source>How much of a foot, a hand or another region of the body may shrink or fold up</source>
        <translation>Quelle part d’un pied, d’une main ou d’une autre région du corps peut rétrécir ou se replier</translation>
    </message>
    <message>
        <source>Sink</source>
        <translation>Enfoncement</translation>
    </message>
    <message>
        <source>How much deeper than the take the body may reach, as a share of its size</source>
        <translation>De combien le corps peut descendre plus bas que dans la prise, en part de sa taille</translation>
    </message>
    <message>
        <source>Trajectories</source>
        <translation>Trajectoires</translation>
    </message>
    <message>
        <source>Smooth deviations from the take, as far apart as the spread says, or the model’s own trajectories as they are drawn, which jitter</source>
        <translation>Des écarts lisses par rapport à la prise, aussi grands que le dit l’écart, ou les trajectoires du modèle telles qu’elles sont tirées, qui tremblent</translation>
    </message>
    <message>
        <source>Smooth deviations</source>
        <translation>Écarts lisses</translation>
    </message>
    <message>
        <source>Of the model</source>
        <translation>Du modèle</translation>
    </message>
    <message>
        <source> variances</source>
        <translation> variances</translation>
    </message>
    <message>
        <source> iterations</source>
        <translation> itérations</translation>
    </message>
    <message>
        <source> ppm</source>
        <translation> ppm</translation>
    </message>
    <message>
        <source> proposals</source>
        <translation> propositions</translation>
    </message>
    <message>
        <source> %</source>
        <comment>percent</comment>
        <translation> %</translation>
    </message>
    <message>
        <source> % of triangles</source>
        <comment>percent</comment>
        <translation> % des triangles</translation>
    </message>
    <message>
        <source> % of size</source>
        <comment>percent</comment>
        <translation> % de la taille</translation>
    </message>
    <message>
        <source> % of size/s</source>
        <comment>percent</comment>
        <translation> % de la taille/s</translation>
    </message>
    <message>
        <source>Keep standing feet still</source>
        <translation>Tenir immobiles les pieds posés</translation>
    </message>
</context>
<context>
    <name>quadrille::LiveBar</name>
    <message>
        <source>Recorded performances</source>
        <translation>Performances enregistrées</translation>
    </message>
    <message>
        <source>Recorded performances; choosing one plays it again</source>
        <translation>Performances enregistrées ; en choisir une la rejoue</translation>
    </message>
    <message>
        <source>No recording</source>
        <translation>Aucun enregistrement</translation>
    </message>
    <message>
        <source>Preparing motion spaces…</source>
        <translation>Préparation des espaces de mouvement…</translation>
    </message>
    <message>
        <source>Recording: %1 s</source>
        <translation>Enregistrement : %1 s</translation>
    </message>
    <message>
        <source>Replay: %1 of %2 s</source>
        <translation>Rejoue : %1 sur %2 s</translation>
    </message>
    <message>
        <source>Live: %1 s</source>
        <translation>En direct : %1 s</translation>
    </message>
    <message>
        <source>Paused at %1 s</source>
        <translation>En pause à %1 s</translation>
    </message>
    <message>
        <source>Path to follow</source>
        <translation>Chemin à suivre</translation>
    </message>
    <message>
        <source>The path of an animation, which is followed around its obstacles from its beginning; whoever steers takes over</source>
        <translation>Le chemin d’une animation, suivi depuis son début en contournant ses obstacles ; qui dirige reprend la main</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>À la main</translation>
    </message>
    <message>
        <source>Along “%1”</source>
        <translation>Le long de « %1 »</translation>
    </message>
</context>
<context>
    <name>quadrille::LiveEdits</name>
    <message>
        <source>Record “%1”</source>
        <translation>Enregistrer « %1 »</translation>
    </message>
</context>
<context>
    <name>quadrille::LiveGraphResults</name>
    <message>
        <source>Motion spaces</source>
        <translation>Espaces de mouvement</translation>
    </message>
</context>
<context>
    <name>quadrille::LivePage</name>
    <message>
        <source>Whose motion spaces are played</source>
        <translation>À qui sont les espaces de mouvement joués</translation>
    </message>
    <message>
        <source>Motion spaces</source>
        <translation>Espaces de mouvement</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Begins at %1</source>
        <translation>Commence en %1</translation>
    </message>
    <message>
        <source>Where on the ground the performance begins</source>
        <translation>Où, sur le sol, la performance commence</translation>
    </message>
    <message>
        <source>Looks to</source>
        <translation>Regarde vers</translation>
    </message>
    <message>
        <source>Where the performance looks first: to the left of straight on</source>
        <translation>Vers où la performance regarde d’abord : à gauche de tout droit</translation>
    </message>
    <message>
        <source> °</source>
        <translation> °</translation>
    </message>
    <message>
        <source>Transitions ahead</source>
        <translation>Transitions en avant</translation>
    </message>
    <message>
        <source>How far ahead a transition is looked for, in either motion space</source>
        <translation>Jusqu’où une transition est cherchée en avant, dans l’un et l’autre espace de mouvement</translation>
    </message>
    <message>
        <source> frames</source>
        <translation> images</translation>
    </message>
    <message>
        <source>Waiting costs</source>
        <translation>L’attente coûte</translation>
    </message>
    <message>
        <source>A frame of waiting for a transition, against dissimilarities from 0 to 1000</source>
        <translation>Une image d’attente d’une transition, face à des dissemblances de 0 à 1000</translation>
    </message>
    <message>
        <source>Waiting costs, responsive</source>
        <translation>L’attente coûte, réactif</translation>
    </message>
    <message>
        <source>The same while it is steered responsively</source>
        <translation>De même tant que l’on dirige de façon réactive</translation>
    </message>
    <message>
        <source>Fade</source>
        <translation>Fondu</translation>
    </message>
    <message>
        <source>In which one motion space takes over from another</source>
        <translation>Pendant lequel un espace de mouvement prend la suite d’un autre</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Across a range</source>
        <translation>D’un bout à l’autre</translation>
    </message>
    <message>
        <source>In which a parameter goes over all of its range at least</source>
        <translation>Le temps qu’un paramètre met au moins à parcourir toute son étendue</translation>
    </message>
    <message>
        <source>Correct contacts</source>
        <translation>Corriger les contacts</translation>
    </message>
    <message>
        <source>Feet that stand in the takes stand still in the clip as well</source>
        <translation>Les pieds posés dans les prises restent immobiles dans le clip aussi</translation>
    </message>
    <message numerus="yes">
        <source>%1 s, steered %n time(s)</source>
        <translation>
            <numerusform>%1 s, dirigée %n fois</numerusform>
            <numerusform>%1 s, dirigée %n fois</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::LiveWorkspace</name>
    <message>
        <source>Performer</source>
        <translation>Interprète</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>En direct</translation>
    </message>
    <message>
        <source>&amp;Play live, or pause</source>
        <translation>&amp;Jouer en direct, ou mettre en pause</translation>
    </message>
    <message>
        <source>Plays the motion spaces as they are steered, or pauses</source>
        <translation>Joue les espaces de mouvement comme on les dirige, ou met en pause</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Records what is steered, until it is pressed again: a performance of the project</source>
        <translation>Enregistre ce qui est dirigé, jusqu’à ce qu’on appuie de nouveau : une performance du projet</translation>
    </message>
    <message>
        <source>&amp;Begin anew</source>
        <translation>&amp;Recommencer</translation>
    </message>
    <message>
        <source>Forgets what was played, and begins where it began</source>
        <translation>Oublie ce qui fut joué, et commence là où cela avait commencé</translation>
    </message>
    <message>
        <source>&amp;Add as a take</source>
        <translation>&amp;Ajouter comme prise</translation>
    </message>
    <message>
        <source>Adds the recorded clip to the takes: for graphs, animations, variations</source>
        <translation>Ajoute le clip enregistré aux prises : pour graphes, animations, variations</translation>
    </message>
    <message>
        <source>E&amp;xport the clip…</source>
        <translation>E&amp;xporter le clip…</translation>
    </message>
    <message>
        <source>Writes the recorded clip into files</source>
        <translation>Écrit le clip enregistré dans des fichiers</translation>
    </message>
    <message>
        <source>Steering</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>Rewind</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>The gamepad was pulled out.</source>
        <translation>La manette a été débranchée.</translation>
    </message>
    <message>
        <source>Plug it in again, or steer by keys; Space goes on.</source>
        <translation>Rebranchez-la, ou dirigez au clavier ; Espace continue.</translation>
    </message>
    <message>
        <source>performance</source>
        <translation>performance</translation>
    </message>
    <message>
        <source>Spaces</source>
        <translation>Espaces</translation>
    </message>
    <message>
        <source>Import takes of somebody first: walks, turns, jumps.</source>
        <translation>Importez d’abord des prises de quelqu’un : marches, virages, sauts.</translation>
    </message>
    <message>
        <source>Here takes of one kind become a movement that you steer: walks by their speed.</source>
        <translation>Ici, des prises d’une même sorte deviennent un mouvement que vous dirigez : des marches par leur vitesse.</translation>
    </message>
    <message>
        <source>Select some takes and make a motion space of them.</source>
        <translation>Sélectionnez quelques prises et faites-en un espace de mouvement.</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Réessayer</translation>
    </message>
    <message>
        <source>New motion space</source>
        <translation>Nouvel espace de mouvement</translation>
    </message>
    <message>
        <source>Edit the motion space</source>
        <translation>Modifier l’espace de mouvement</translation>
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
        <translation>Plusieurs portent ce nom&#xa0;; celui dont les dossiers se ressemblent le plus a été pris. Choisissez-en un autre à la main si ce n’est pas le bon.</translation>
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
    <message>
        <source>&amp;Sequences</source>
        <translation>&amp;Séquences</translation>
    </message>
    <message>
        <source>&amp;Graph</source>
        <translation>&amp;Graphe</translation>
    </message>
    <message>
        <source>&amp;Animate</source>
        <translation>&amp;Animer</translation>
    </message>
    <message>
        <source>&amp;Variations</source>
        <translation>&amp;Variations</translation>
    </message>
    <message>
        <source>Settings that could not be used were put aside as %1: here are the usual ones.</source>
        <translation>Des réglages inutilisables ont été mis de côté sous le nom %1&#xa0;: voici les réglages habituels.</translation>
    </message>
    <message>
        <source>&amp;Close the project</source>
        <translation>&amp;Fermer le projet</translation>
    </message>
    <message>
        <source>Close the project and go back to the beginning</source>
        <translation>Fermer le projet et revenir à l’accueil</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>Plein é&amp;cran</translation>
    </message>
    <message>
        <source>Fill the screen with the window, and back</source>
        <translation>Étendre la fenêtre à tout l’écran, et revenir</translation>
    </message>
    <message>
        <source>Come &amp;closer</source>
        <translation>&amp;Se rapprocher</translation>
    </message>
    <message>
        <source>Move the camera towards what it looks at</source>
        <translation>Approcher la caméra de ce qu’elle regarde</translation>
    </message>
    <message>
        <source>Go f&amp;arther</source>
        <translation>S’é&amp;loigner</translation>
    </message>
    <message>
        <source>Move the camera away from what it looks at</source>
        <translation>Éloigner la caméra de ce qu’elle regarde</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Panneau</translation>
    </message>
    <message>
        <source>Pa&amp;nels</source>
        <translation>Pa&amp;nneaux</translation>
    </message>
    <message>
        <source>La&amp;yout</source>
        <translation>Disposi&amp;tion</translation>
    </message>
    <message>
        <source>Help on “%1”</source>
        <translation>Aide sur «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>%1 (read only)</source>
        <translation>%1 (lecture seule)</translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation>Évaluation</translation>
    </message>
    <message>
        <source>A&amp;ppearance</source>
        <translation>Appa&amp;rence</translation>
    </message>
    <message>
        <source>T&amp;ransfer</source>
        <translation>T&amp;ransfert</translation>
    </message>
    <message>
        <source>&amp;Live</source>
        <translation>En &amp;direct</translation>
    </message>
    <message>
        <source>Pr&amp;operties</source>
        <translation>Pr&amp;opriétés</translation>
    </message>
    <message>
        <source>Shows the properties of what is selected in the project</source>
        <translation>Montre les propriétés de ce qui est sélectionné dans le projet</translation>
    </message>
</context>
<context>
    <name>quadrille::MarkEdits</name>
    <message numerus="yes">
        <source>Label %n sequences</source>
        <translation>
            <numerusform>Étiqueter %n séquence</numerusform>
            <numerusform>Étiqueter %n séquences</numerusform>
        </translation>
    </message>
    <message>
        <source>Change the notes of “%1”</source>
        <translation>Changer les notes de «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>quadrille::MaskCanvas</name>
    <message>
        <source>Reading a mask</source>
        <translation>Lecture d’un masque</translation>
    </message>
    <message>
        <source>Erase a stroke of a mask</source>
        <translation>Gommer un trait d’un masque</translation>
    </message>
    <message>
        <source>Paint a stroke of a mask</source>
        <translation>Peindre un trait d’un masque</translation>
    </message>
    <message>
        <source>Filling a chart</source>
        <translation>Remplissage d’un îlot</translation>
    </message>
    <message>
        <source>Mask a chart</source>
        <translation>Masquer un îlot</translation>
    </message>
    <message>
        <source>Complete frame %1</source>
        <translation>Compléter l’image %1</translation>
    </message>
    <message>
        <source>Do not complete frame %1</source>
        <translation>Ne pas compléter l’image %1</translation>
    </message>
    <message>
        <source>Clear a mask</source>
        <translation>Vider un masque</translation>
    </message>
</context>
<context>
    <name>quadrille::MasksPanel</name>
    <message>
        <source>Appearance</source>
        <translation>Apparence</translation>
    </message>
    <message>
        <source>&amp;Paint a mask</source>
        <translation>&amp;Peindre un masque</translation>
    </message>
    <message>
        <source>Marks what is missing of the texture, in the texture view</source>
        <translation>Marque ce qui manque à la texture, dans la vue de texture</translation>
    </message>
    <message>
        <source>Complete this f&amp;rame</source>
        <translation>&amp;Compléter cette image</translation>
    </message>
    <message>
        <source>Adds the texture of the frame to those that are completed</source>
        <translation>Ajoute la texture de l’image à celles qui sont complétées</translation>
    </message>
    <message>
        <source>Do &amp;not complete this frame</source>
        <translation>&amp;Ne pas compléter cette image</translation>
    </message>
    <message>
        <source>Takes the texture of the frame out of those that are completed, with its mask</source>
        <translation>Retire la texture de l’image de celles qui sont complétées, avec son masque</translation>
    </message>
    <message>
        <source>Clear the &amp;mask</source>
        <translation>Vider le &amp;masque</translation>
    </message>
    <message>
        <source>Takes all strokes of the mask away</source>
        <translation>Enlève tous les traits du masque</translation>
    </message>
    <message>
        <source>C&amp;omplete textures</source>
        <translation>C&amp;ompléter les textures</translation>
    </message>
    <message>
        <source>Fills in what is masked with what the model finds likeliest</source>
        <translation>Remplit ce qui est masqué avec ce que le modèle trouve le plus vraisemblable</translation>
    </message>
    <message>
        <source>Mark what a texture lacks; the model fills it in. Textures to be completed are not learned from.</source>
        <translation>Marquez ce qui manque à une texture ; le modèle le remplit. Les textures à compléter ne sont pas apprises.</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Outil</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinceau</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>Gomme</translation>
    </message>
    <message>
        <source>Fill a chart</source>
        <translation>Remplir un îlot</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>What a press on the texture does while a mask is painted</source>
        <translation>Ce que fait une pression sur la texture pendant qu’un masque est peint</translation>
    </message>
    <message>
        <source>Radius of the brush</source>
        <translation>Rayon du pinceau</translation>
    </message>
    <message>
        <source>Textures to be completed</source>
        <translation>Textures à compléter</translation>
    </message>
    <message>
        <source>Textures to be completed: choose one to go there</source>
        <translation>Textures à compléter : en choisir une y mène</translation>
    </message>
    <message>
        <source>%1, no mask yet</source>
        <translation>%1, pas encore de masque</translation>
    </message>
    <message>
        <source>Add a model of textures first.</source>
        <translation>Ajoutez d’abord un modèle de textures.</translation>
    </message>
    <message>
        <source>Go to a frame, choose “Paint a mask” and mark on its texture what is missing.</source>
        <translation>Allez à une image, choisissez « Peindre un masque » et marquez sur sa texture ce qui manque.</translation>
    </message>
    <message>
        <source>Completing textures…</source>
        <translation>Les textures sont complétées…</translation>
    </message>
    <message>
        <source>All are completed as they are masked.</source>
        <translation>Toutes sont complétées selon leurs masques.</translation>
    </message>
    <message>
        <source>Completed anew when you ask for it.</source>
        <translation>Complétées de nouveau quand vous le demandez.</translation>
    </message>
    <message>
        <source>Completing them builds the model first.</source>
        <translation>Les compléter construit d’abord le modèle.</translation>
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
    <message>
        <source>&amp;Graph</source>
        <translation>&amp;Graphe</translation>
    </message>
    <message>
        <source>&amp;Animate</source>
        <translation>&amp;Animer</translation>
    </message>
    <message>
        <source>Va&amp;riations</source>
        <translation>Va&amp;riations</translation>
    </message>
    <message>
        <source>&amp;Take</source>
        <translation>&amp;Prise</translation>
    </message>
    <message>
        <source>&amp;Shading</source>
        <translation>&amp;Rendu</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>A&amp;fficher</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>&amp;Caméra</translation>
    </message>
    <message>
        <source>Com&amp;pare</source>
        <translation>Com&amp;parer</translation>
    </message>
    <message>
        <source>P&amp;icture</source>
        <translation>I&amp;mage</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Thème</translation>
    </message>
    <message>
        <source>&amp;Path</source>
        <translation>&amp;Trajet</translation>
    </message>
    <message>
        <source>&amp;Keys and storyboard</source>
        <translation>&amp;Poses et scénarimage</translation>
    </message>
    <message>
        <source>&amp;Sound</source>
        <translation>&amp;Son</translation>
    </message>
    <message>
        <source>&amp;Transitions</source>
        <translation>T&amp;ransitions</translation>
    </message>
    <message>
        <source>&amp;Report</source>
        <translation>&amp;Bilan</translation>
    </message>
    <message>
        <source>&amp;Parts of the body</source>
        <translation>&amp;Parties du corps</translation>
    </message>
    <message>
        <source>&amp;Samples</source>
        <translation>&amp;Échantillons</translation>
    </message>
    <message>
        <source>&amp;Latent space</source>
        <translation>Espace &amp;latent</translation>
    </message>
    <message>
        <source>E&amp;valuations</source>
        <translation>É&amp;valuations</translation>
    </message>
    <message>
        <source>&amp;Completions</source>
        <translation>Co&amp;mpléments</translation>
    </message>
    <message>
        <source>Te&amp;xture</source>
        <translation>Te&amp;xture</translation>
    </message>
    <message>
        <source>Appeara&amp;nce</source>
        <translation>Appare&amp;nce</translation>
    </message>
    <message>
        <source>&amp;Transfer</source>
        <translation>&amp;Transfert</translation>
    </message>
    <message>
        <source>&amp;Pairs</source>
        <translation>&amp;Paires</translation>
    </message>
    <message>
        <source>Wor&amp;kspace</source>
        <translation>Espace de &amp;travail</translation>
    </message>
    <message>
        <source>&amp;Live</source>
        <translation>En &amp;direct</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>an action and what it is about, as “Undo: Rename “walk””</extracomment>
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>quadrille::MotionSpaceEdits</name>
    <message>
        <source>speed</source>
        <translation>vitesse</translation>
    </message>
    <message>
        <source>Add motion space “%1”</source>
        <translation>Ajouter l’espace de mouvement «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Duplicate “%1”</source>
        <translation>Dupliquer «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>turning</source>
        <translation>rotation</translation>
    </message>
    <message>
        <source>jump height</source>
        <translation>hauteur du saut</translation>
    </message>
    <message>
        <source>jump length</source>
        <translation>longueur du saut</translation>
    </message>
    <message>
        <source>height</source>
        <translation>hauteur</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>avant</translation>
    </message>
    <message>
        <source>side</source>
        <translation>côté</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>paramètre</translation>
    </message>
    <message>
        <source>Add the take “%1”</source>
        <translation>Ajouter la prise «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Add takes</source>
        <translation>Ajouter des prises</translation>
    </message>
</context>
<context>
    <name>quadrille::MotionSpacePage</name>
    <message>
        <source>Whose movement it is; takes are chosen anew with another one</source>
        <translation>De qui est le mouvement&#xa0;; avec un autre, les prises sont à choisir de nouveau</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Takes</source>
        <translation>Prises</translation>
    </message>
    <message>
        <source>What the space is made of, and where each take lies on its axes</source>
        <translation>De quoi l’espace est fait, et où chaque prise se trouve sur ses axes</translation>
    </message>
    <message>
        <source>Set the frames of a take</source>
        <translation>Régler les images d’une prise</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Exactly these; all of them, or the cycle that is found in them</source>
        <translation>Exactement celles-ci&#xa0;; toutes, ou le cycle qui y est trouvé</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>En miroir</translation>
    </message>
    <message>
        <source>Left and right are exchanged</source>
        <translation>La gauche et la droite sont échangées</translation>
    </message>
    <message>
        <source>Reversed</source>
        <translation>À l’envers</translation>
    </message>
    <message>
        <source>It is played from its last frame to its first</source>
        <translation>Elle est jouée de sa dernière image à sa première</translation>
    </message>
    <message>
        <source>Played at</source>
        <translation>Jouée à</translation>
    </message>
    <message>
        <source>1 is as it was captured</source>
        <translation>1&#xa0;: comme elle a été captée</translation>
    </message>
    <message>
        <source>Set the place of a take</source>
        <translation>Régler la place d’une prise</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Place</translation>
    </message>
    <message>
        <source>A value of each parameter, with ; between them; measured where it is empty</source>
        <translation>Une valeur par paramètre, séparées par&#xa0;; – mesurée si elle est vide</translation>
    </message>
    <message>
        <source>Steered by</source>
        <translation>Conduit par</translation>
    </message>
    <message>
        <source>What its takes differ in: one to three parameters</source>
        <translation>Ce qui distingue ses prises&#xa0;: un à trois paramètres</translation>
    </message>
    <message>
        <source>Add a parameter</source>
        <translation>Ajouter un paramètre</translation>
    </message>
    <message>
        <source>Name a parameter</source>
        <translation>Nommer un paramètre</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Unique in the space</source>
        <translation>Unique dans l’espace</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Mesure</translation>
    </message>
    <message>
        <source>What is measured of each take, and of the blends between them</source>
        <translation>Ce qui est mesuré de chaque prise, et des mélanges entre elles</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Turning to the left</source>
        <translation>Rotation vers la gauche</translation>
    </message>
    <message>
        <source>Height of a jump</source>
        <translation>Hauteur d’un saut</translation>
    </message>
    <message>
        <source>Length of a jump</source>
        <translation>Longueur d’un saut</translation>
    </message>
    <message>
        <source>Height of a vertex</source>
        <translation>Hauteur d’un sommet</translation>
    </message>
    <message>
        <source>Forward way of a vertex</source>
        <translation>Avance d’un sommet</translation>
    </message>
    <message>
        <source>Way of a vertex to the left</source>
        <translation>Écart d’un sommet à gauche</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>À la main</translation>
    </message>
    <message>
        <source>Vertex</source>
        <translation>Sommet</translation>
    </message>
    <message>
        <source>Of the mesh, from 0</source>
        <translation>Du maillage, à partir de 0</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Référence</translation>
    </message>
    <message>
        <source>The take whose frames are those of the space</source>
        <translation>La prise dont les images sont celles de l’espace</translation>
    </message>
    <message>
        <source>the first</source>
        <translation>la première</translation>
    </message>
    <message>
        <source>Find cycles</source>
        <translation>Chercher les cycles</translation>
    </message>
    <message>
        <source>Takes of walking and running are cut to one cycle, which repeats</source>
        <translation>Les prises de marche et de course sont réduites à un cycle, qui se répète</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>By how much blends may miss the non-linear ones at most</source>
        <translation>De combien les mélanges peuvent manquer les non linéaires au plus</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>References at most</source>
        <translation>Références au plus</translation>
    </message>
    <message>
        <source>Non-linear blends that are stored to keep the tolerance; 0 for linear blends</source>
        <translation>Mélanges non linéaires gardés pour tenir la tolérance&#xa0;; 0 pour des mélanges linéaires</translation>
    </message>
    <message>
        <source>Change the character of “%1”</source>
        <translation>Changer le personnage de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Remove the take “%1”</source>
        <translation>Retirer la prise «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Remove a parameter</source>
        <translation>Retirer un paramètre</translation>
    </message>
    <message>
        <source>Add a take</source>
        <translation>Ajouter une prise</translation>
    </message>
    <message>
        <source>Remove the take</source>
        <translation>Retirer la prise</translation>
    </message>
    <message>
        <source>Remove the parameter</source>
        <translation>Retirer le paramètre</translation>
    </message>
    <message>
        <source>mirrored</source>
        <translation>en miroir</translation>
    </message>
    <message>
        <source>reversed</source>
        <translation>à l’envers</translation>
    </message>
    <message>
        <source>%1 · %2 to %3, missed by %4 at most</source>
        <translation>%1 · de %2 à %3, manqué de %4 au plus</translation>
    </message>
    <message>
        <source>It has no takes</source>
        <translation>Il n’a pas de prises</translation>
    </message>
    <message>
        <source>Being computed …</source>
        <translation>En calcul …</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s)</source>
        <translation>
            <numerusform>%n image</numerusform>
            <numerusform>%n images</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2; %3, %4; blends miss non-linear ones by %5 mm at most</source>
        <translation>%1, %2&#xa0;; %3, %4&#xa0;; les mélanges manquent les non linéaires de %5&#xa0;mm au plus</translation>
    </message>
    <message>
        <source>repeats</source>
        <translation>se répète</translation>
    </message>
    <message>
        <source>plays once</source>
        <translation>joué une fois</translation>
    </message>
    <message numerus="yes">
        <source>%n reference(s)</source>
        <translation>
            <numerusform>%n référence</numerusform>
            <numerusform>%n références</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::MotionSpaceResults</name>
    <message>
        <source>Motion space “%1”</source>
        <translation>Espace de mouvement «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>quadrille::MovementPanel</name>
    <message>
        <source>Take</source>
        <translation>Prise</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Used</source>
        <translation>Utilisées</translation>
    </message>
    <message>
        <source>The frames that are learned from: one cycle, or all</source>
        <translation>Les images apprises&#xa0;: un cycle, ou toutes</translation>
    </message>
    <message>
        <source>Takes to learn from</source>
        <translation>Prises à apprendre</translation>
    </message>
    <message>
        <source>Blends</source>
        <translation>Mélanges</translation>
    </message>
    <message>
        <source>Alignment</source>
        <translation>Alignement</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Référence</translation>
    </message>
    <message>
        <source>The take whose timing the others are warped to</source>
        <translation>La prise dont les autres prennent le rythme</translation>
    </message>
    <message>
        <source>Change the reference</source>
        <translation>Changer la référence</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Gabarit</translation>
    </message>
    <message>
        <source>The pose that all frames are laid onto; a click takes the one that is shown</source>
        <translation>La pose sur laquelle toutes les images sont posées&#xa0;; un clic prend celle qui est montrée</translation>
    </message>
    <message>
        <source>Change the template</source>
        <translation>Changer le gabarit</translation>
    </message>
    <message>
        <source>So that all takes begin in the same phase</source>
        <translation>Pour que toutes les prises commencent dans la même phase</translation>
    </message>
    <message>
        <source>Cut to cycles</source>
        <translation>Couper aux cycles</translation>
    </message>
    <message>
        <source>the first take</source>
        <translation>la première prise</translation>
    </message>
    <message>
        <source>%1, frame %2</source>
        <translation>%1, image %2</translation>
    </message>
    <message>
        <source>the reference’s first frame</source>
        <translation>début de la référence</translation>
    </message>
    <message>
        <source>Cut walks and runs to one cycle</source>
        <translation>Couper marches et courses à un cycle</translation>
    </message>
    <message>
        <source>Learn from “%1”</source>
        <translation>Apprendre de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Do not learn from “%1”</source>
        <translation>Ne pas apprendre de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Check the takes of one kind of movement, or drag their cards here: they are learned from.</source>
        <translation>Cochez les prises d’un même genre de mouvement, ou glissez leurs cartes ici&#xa0;: on apprend d’elles.</translation>
    </message>
    <message>
        <source>“%1” is of another character.</source>
        <translation>«&#xa0;%1&#xa0;» est d’un autre personnage.</translation>
    </message>
    <message numerus="yes">
        <source>Learn from %n takes</source>
        <translation>
            <numerusform>Apprendre de %n prise</numerusform>
            <numerusform>Apprendre de %n prises</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::NotesPanel</name>
    <message>
        <source>Frame</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>At</source>
        <translation>À</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>Edit the note</source>
        <translation>Modifier la note</translation>
    </message>
    <message>
        <source>Remove the note</source>
        <translation>Retirer la note</translation>
    </message>
    <message>
        <source>No notes. Shift+N writes one on the frame that is shown.</source>
        <translation>Pas de notes. Maj+N en écrit une sur l’image affichée.</translation>
    </message>
</context>
<context>
    <name>quadrille::ObstacleForm</name>
    <message>
        <source>Middle %1</source>
        <translation>Milieu %1</translation>
    </message>
    <message>
        <source>Where the middle of the obstacle is on the ground</source>
        <translation>Où se trouve le milieu de l’obstacle sur le sol</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Of the disc</source>
        <translation>Du disque</translation>
    </message>
    <message>
        <source>Change the radius of an obstacle</source>
        <translation>Changer le rayon d’un obstacle</translation>
    </message>
    <message>
        <source>Move an obstacle</source>
        <translation>Déplacer un obstacle</translation>
    </message>
</context>
<context>
    <name>quadrille::PairPreview</name>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>Transition</source>
        <translation>Transition</translation>
    </message>
    <message>
        <source>Reading two frames</source>
        <translation>Lecture de deux images</translation>
    </message>
    <message>
        <source>Blending a transition</source>
        <translation>Fondu d’une transition</translation>
    </message>
</context>
<context>
    <name>quadrille::PairTool</name>
    <message>
        <source>This triangle of the body has a pair already.</source>
        <translation>Ce triangle du corps a déjà une paire.</translation>
    </message>
    <message>
        <source>Transfer</source>
        <translation>Transfert</translation>
    </message>
    <message>
        <source>&amp;Propose pairs</source>
        <translation>&amp;Proposer des paires</translation>
    </message>
    <message>
        <source>Exchanges all pairs for ones that are found by laying the template onto the body</source>
        <translation>Remplace toutes les paires par d’autres, trouvées en posant le gabarit sur le corps</translation>
    </message>
    <message>
        <source>&amp;Mirror the pair</source>
        <translation>&amp;Refléter la paire</translation>
    </message>
    <message>
        <source>Adds the same pair on the other side of both bodies</source>
        <translation>Ajoute la même paire de l’autre côté des deux corps</translation>
    </message>
    <message>
        <source>The other side has this pair already, or nothing tells where it is.</source>
        <translation>L’autre côté a déjà cette paire, ou rien ne dit où elle est.</translation>
    </message>
    <message>
        <source>Mirror &amp;all pairs</source>
        <translation>Refléter &amp;toutes les paires</translation>
    </message>
    <message>
        <source>Adds each pair on the other side as well, where that has none</source>
        <translation>Ajoute aussi chaque paire de l’autre côté, là où il n’y en a pas</translation>
    </message>
    <message>
        <source>&amp;Remove the pair</source>
        <translation>Reti&amp;rer la paire</translation>
    </message>
    <message>
        <source>Removes the selected pair</source>
        <translation>Retire la paire sélectionnée</translation>
    </message>
    <message>
        <source>Propose pairs</source>
        <translation>Proposer des paires</translation>
    </message>
    <message>
        <source>Mirror all pairs</source>
        <translation>Refléter toutes les paires</translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s) were added.</source>
        <translation>
            <numerusform>%n paire ajoutée.</numerusform>
            <numerusform>%n paires ajoutées.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing tells which triangle of the other body belongs to it: click on it.</source>
        <translation>Rien ne dit quel triangle de l’autre corps lui correspond : cliquez dessus.</translation>
    </message>
    <message>
        <source>Now click on the same place of the body; Return proposes one, Escape gives up.</source>
        <translation>Cliquez maintenant sur le même endroit du corps ; Entrée en propose un, Échap renonce.</translation>
    </message>
    <message>
        <source>Now click on the same place of the template; Return proposes one, Escape gives up.</source>
        <translation>Cliquez maintenant sur le même endroit du gabarit ; Entrée en propose un, Échap renonce.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>Mirroring pairs</source>
        <translation>Reflet des paires</translation>
    </message>
</context>
<context>
    <name>quadrille::PairsPanel</name>
    <message>
        <source>Pair</source>
        <translation>Paire</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Partie</translation>
    </message>
    <message>
        <source>Likeness</source>
        <translation>Ressemblance</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Gabarit</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Corps</translation>
    </message>
    <message>
        <source>How alike the two places are once the template is laid onto the body: by how far they are from hands, feet and head, where they lie and how they face; below 30 % a look is worth while</source>
        <translation>À quel point les deux endroits se ressemblent une fois le gabarit posé sur le corps : d’après leur distance aux mains, aux pieds et à la tête, l’endroit où ils sont et leur orientation ; au-dessous de 30 %, un regard vaut la peine</translation>
    </message>
    <message>
        <source>Number of the triangle, from 0</source>
        <translation>Numéro du triangle, à partir de 0</translation>
    </message>
    <message>
        <source>Pairs of triangles</source>
        <translation>Paires de triangles</translation>
    </message>
    <message>
        <source>%1 %</source>
        <extracomment>a share</extracomment>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Pairs of triangles say which places of two bodies move alike.</source>
        <translation>Les paires de triangles disent quels endroits de deux corps bougent de la même façon.</translation>
    </message>
    <message>
        <source>Click on a place of the template, then on the same place of the body. Some pairs on each part that turns will do: from about 15 on.</source>
        <translation>Cliquez sur un endroit du gabarit, puis sur le même endroit du corps. Quelques paires sur chaque partie qui tourne suffisent : à partir d’environ 15.</translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s) were proposed. What you change makes them the project’s.</source>
        <translation>
            <numerusform>%n paire a été proposée. Ce que vous y changez en fait une paire du projet.</numerusform>
            <numerusform>%n paires ont été proposées. Ce que vous y changez en fait celles du projet.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s): from about 15 on all parts turn as they should.</source>
        <translation>
            <numerusform>%n paire : à partir d’environ 15, toutes les parties tournent comme il faut.</numerusform>
            <numerusform>%n paires : à partir d’environ 15, toutes les parties tournent comme il faut.</numerusform>
        </translation>
    </message>
    <message>
        <source>Without a pair: %1. How they turn is guessed from what is beside them.</source>
        <translation>Sans paire : %1. La façon dont ces parties tournent est devinée d’après leurs voisines.</translation>
    </message>
    <message>
        <source>The body is %1 times as tall as the template: its file may be in another unit, which the properties of its take can name.</source>
        <translation>Le corps est %1 fois aussi grand que le gabarit : son fichier est peut-être dans une autre unité, que les propriétés de sa prise peuvent nommer.</translation>
    </message>
    <message>
        <source>Pairs are sought…</source>
        <translation>Recherche de paires…</translation>
    </message>
</context>
<context>
    <name>quadrille::PanelActions</name>
    <message>
        <source>Put back into the window</source>
        <translation>Remettre dans la fenêtre</translation>
    </message>
    <message>
        <source>Take out of the window</source>
        <translation>Détacher de la fenêtre</translation>
    </message>
    <message>
        <source>Hide “%1”</source>
        <translation>Masquer «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>quadrille::PartCurveTool</name>
    <message>
        <source>Variations</source>
        <translation>Variations</translation>
    </message>
    <message>
        <source>&amp;Propose parts</source>
        <translation>&amp;Proposer des parties</translation>
    </message>
    <message>
        <source>Cut the body into torso, arms and legs; takes the place of all curves and parts</source>
        <translation>Coupe le corps en tronc, bras et jambes&#xa0;; remplace toutes les courbes et parties</translation>
    </message>
    <message>
        <source>Draw a &amp;curve</source>
        <translation>Tracer une &amp;courbe</translation>
    </message>
    <message>
        <source>Click points around a limb; the curve closes itself, Return or a click on the first point ends</source>
        <translation>Cliquer des points autour d’un membre&#xa0;; la courbe se ferme d’elle-même, Entrée ou un clic sur le premier point termine</translation>
    </message>
    <message>
        <source>Add a s&amp;econd curve</source>
        <translation>Ajouter une s&amp;econde courbe</translation>
    </message>
    <message>
        <source>Beside the selected one, towards the end of the limb: a part needs two</source>
        <translation>À côté de celle choisie, vers le bout du membre&#xa0;: il en faut deux à une partie</translation>
    </message>
    <message>
        <source>&amp;Add a part</source>
        <translation>&amp;Ajouter une partie</translation>
    </message>
    <message>
        <source>From the selected curve and the one next to it, or one that is made</source>
        <translation>De la courbe choisie et de celle d’à côté, ou d’une qui est faite</translation>
    </message>
    <message>
        <source>&amp;Mirror to the other side</source>
        <translation>&amp;Reporter de l’autre côté</translation>
    </message>
    <message>
        <source>Make the selected curve or part on the other side of the body, too</source>
        <translation>Fait la courbe ou la partie choisie aussi de l’autre côté du corps</translation>
    </message>
    <message>
        <source>&amp;Shorten the curve</source>
        <translation>Raccourcir la cour&amp;be</translation>
    </message>
    <message>
        <source>Lead it where the limb is thinnest nearby</source>
        <translation>La mène là où le membre est le plus mince à proximité</translation>
    </message>
    <message>
        <source>&amp;Delete the curve or part</source>
        <translation>&amp;Supprimer la courbe ou la partie</translation>
    </message>
    <message>
        <source>Take away what is selected; curves of a part stay</source>
        <translation>Retire ce qui est choisi&#xa0;; les courbes d’une partie restent</translation>
    </message>
    <message>
        <source>S&amp;nap to creases</source>
        <translation>Aima&amp;nter aux plis</translation>
    </message>
    <message>
        <source>Points jump to creases near them, and curves follow them</source>
        <translation>Les points sautent aux plis proches, et les courbes les suivent</translation>
    </message>
    <message>
        <source>Sho&amp;w the parts</source>
        <translation>&amp;Montrer les parties</translation>
    </message>
    <message>
        <source>Colour the parts of the body and show their curves in the view</source>
        <translation>Colore les parties du corps et montre leurs courbes dans la vue</translation>
    </message>
    <message>
        <source>&amp;Delete the point</source>
        <translation>&amp;Supprimer le point</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>courbe</translation>
    </message>
    <message>
        <source>Draw a curve</source>
        <translation>Tracer une courbe</translation>
    </message>
    <message>
        <source>Add a point to a curve</source>
        <translation>Ajouter un point à une courbe</translation>
    </message>
    <message>
        <source>Move a point of a curve</source>
        <translation>Déplacer un point d’une courbe</translation>
    </message>
    <message>
        <source>Insert a point into a curve</source>
        <translation>Insérer un point dans une courbe</translation>
    </message>
    <message>
        <source>Delete a curve</source>
        <translation>Supprimer une courbe</translation>
    </message>
    <message>
        <source>Delete a point of a curve</source>
        <translation>Supprimer un point d’une courbe</translation>
    </message>
    <message>
        <source>Proposing parts of the body</source>
        <translation>Proposition des parties du corps</translation>
    </message>
    <message>
        <source>Propose parts</source>
        <translation>Proposer des parties</translation>
    </message>
    <message>
        <source>part</source>
        <translation>partie</translation>
    </message>
    <message>
        <source>body</source>
        <translation>corps</translation>
    </message>
    <message>
        <source>Add a part</source>
        <translation>Ajouter une partie</translation>
    </message>
    <message>
        <source>Adding a part</source>
        <translation>Ajout d’une partie</translation>
    </message>
    <message>
        <source>Adding a second curve</source>
        <translation>Ajout d’une seconde courbe</translation>
    </message>
    <message>
        <source>Add a second curve</source>
        <translation>Ajouter une seconde courbe</translation>
    </message>
    <message>
        <source>%1, mirrored</source>
        <translation>%1, reportée</translation>
    </message>
    <message>
        <source>Mirroring</source>
        <translation>Report de l’autre côté</translation>
    </message>
    <message>
        <source>Mirror a part</source>
        <translation>Reporter une partie de l’autre côté</translation>
    </message>
    <message>
        <source>Mirror a curve</source>
        <translation>Reporter une courbe de l’autre côté</translation>
    </message>
    <message>
        <source>Shortening a curve</source>
        <translation>Raccourcissement d’une courbe</translation>
    </message>
    <message>
        <source>Shorten a curve</source>
        <translation>Raccourcir une courbe</translation>
    </message>
    <message>
        <source>Delete a part</source>
        <translation>Supprimer une partie</translation>
    </message>
    <message>
        <source>The curve “%1” bounded the part “%2”, which lacks a curve now.</source>
        <translation>La courbe «&#xa0;%1&#xa0;» bornait la partie «&#xa0;%2 », à qui il manque maintenant une courbe.</translation>
    </message>
    <message>
        <source>Undo, draw another one, or choose one for the part.</source>
        <translation>Annulez, tracez-en une autre, ou choisissez-en une pour la partie.</translation>
    </message>
    <message>
        <source>There is a curve “%1” already.</source>
        <translation>Il y a déjà une courbe «&#xa0;%1 ».</translation>
    </message>
    <message>
        <source>There is a part “%1” already.</source>
        <translation>Il y a déjà une partie «&#xa0;%1 ».</translation>
    </message>
    <message>
        <source>Choose another name.</source>
        <translation>Choisissez un autre nom.</translation>
    </message>
    <message>
        <source>Rename a curve</source>
        <translation>Renommer une courbe</translation>
    </message>
    <message>
        <source>Rename a part</source>
        <translation>Renommer une partie</translation>
    </message>
    <message>
        <source>Choose the pose that curves are drawn in</source>
        <translation>Choisir la pose où l’on trace les courbes</translation>
    </message>
    <message>
        <source>Body parts</source>
        <translation>Parties du corps</translation>
    </message>
    <message>
        <source>shared by two, lighter</source>
        <translation>commun à deux, plus clair</translation>
    </message>
    <message>
        <source>Point %1 of the curve “%2”</source>
        <translation>Point %1 de la courbe «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>Curve “%1”</source>
        <translation>Courbe «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>quadrille::PartForm</name>
    <message>
        <source>Hangs on</source>
        <translation>Tient à</translation>
    </message>
    <message>
        <source>The part of the body that it is joined to</source>
        <translation>La partie du corps à laquelle elle est jointe</translation>
    </message>
    <message>
        <source>First curve</source>
        <translation>Première courbe</translation>
    </message>
    <message>
        <source>One of the curves that bound what it shares with its parent</source>
        <translation>L’une des courbes qui bornent ce qu’elle partage avec son parent</translation>
    </message>
    <message>
        <source>Second curve</source>
        <translation>Seconde courbe</translation>
    </message>
    <message>
        <source>The other curve that bounds what it shares with its parent</source>
        <translation>L’autre courbe qui borne ce qu’elle partage avec son parent</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>That lead the curve; the vertices between them follow the surface</source>
        <translation>Ceux qui guident la courbe&#xa0;; les sommets entre eux suivent la surface</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Around the limb, over the edges of the mesh</source>
        <translation>Autour du membre, le long des arêtes du maillage</translation>
    </message>
    <message>
        <source>%1: all other parts hang on it</source>
        <translation>%1&#xa0;: toutes les autres parties y tiennent</translation>
    </message>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>Hang a part on another</source>
        <translation>Attacher une partie à une autre</translation>
    </message>
    <message>
        <source>Choose a curve of a part</source>
        <translation>Choisir une courbe d’une partie</translation>
    </message>
</context>
<context>
    <name>quadrille::PathForm</name>
    <message>
        <source>Curve</source>
        <translation>Courbe</translation>
    </message>
    <message>
        <source>How the path goes from point to point</source>
        <translation>Comment le trajet va d’un point à l’autre</translation>
    </message>
    <message>
        <source>Leads</source>
        <translation>Mène</translation>
    </message>
    <message>
        <source>Whether the heights of its points count, or it is seen from above</source>
        <translation>Si les hauteurs de ses points comptent, ou s’il est vu d’en haut</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Marge</translation>
    </message>
    <message>
        <source>The distance that the body’s centre keeps from obstacles</source>
        <translation>La distance que le centre du corps garde des obstacles</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>How far the body’s centre is from where it was to be</source>
        <translation>À quelle distance le centre du corps est d’où il devait être</translation>
    </message>
    <message>
        <source>Change the clearance</source>
        <translation>Changer la marge</translation>
    </message>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>mean %1
greatest %2</source>
        <translation>moyen %1
maximal %2</translation>
    </message>
    <message>
        <source>Smooth through points</source>
        <translation>Lisse par les points</translation>
    </message>
    <message>
        <source>Straight lines</source>
        <translation>Lignes droites</translation>
    </message>
    <message>
        <source>Bézier with handles</source>
        <translation>Bézier avec poignées</translation>
    </message>
    <message>
        <source>Over the ground</source>
        <translation>Sur le sol</translation>
    </message>
    <message>
        <source>Through space</source>
        <translation>Dans l’espace</translation>
    </message>
</context>
<context>
    <name>quadrille::PathPanel</name>
    <message>
        <source>A path says where the body goes. Click points on the ground, or drag a line over it; the curve can be moved, labelled and timed afterwards.</source>
        <translation>Un trajet dit où va le corps. Cliquez des points sur le sol, ou tracez-y une ligne&#xa0;; la courbe peut ensuite être déplacée, étiquetée et minutée.</translation>
    </message>
    <message>
        <source>Click points on the ground, or drag a line over it (P)</source>
        <translation>Cliquer des points sur le sol, ou y tracer une ligne (P)</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Spans</source>
        <translation>Portions</translation>
    </message>
    <message>
        <source>Obstacles</source>
        <translation>Obstacles</translation>
    </message>
    <message>
        <source>Points of the path</source>
        <translation>Points du trajet</translation>
    </message>
    <message>
        <source>Coordinates of the points; a double click edits one</source>
        <translation>Coordonnées des points&#xa0;; un double clic en modifie une</translation>
    </message>
    <message>
        <source>Spans of the path</source>
        <translation>Portions du trajet</translation>
    </message>
    <message>
        <source>Parts of the path on which frames or a speed are asked for</source>
        <translation>Parties du trajet où des images ou une vitesse sont demandées</translation>
    </message>
    <message>
        <source>Parts of the ground that the body’s centre stays out of</source>
        <translation>Parties du sol où le centre du corps n’entre pas</translation>
    </message>
    <message>
        <source>%1 – %2 %3 · %4</source>
        <translation>%1 – %2 %3 · %4</translation>
    </message>
    <message>
        <source>%1 · disc, radius %2 %3</source>
        <translation>%1 · disque, rayon %2 %3</translation>
    </message>
    <message numerus="yes">
        <source>%1 · polygon, %n corner(s)</source>
        <translation>
            <numerusform>%1 · polygone, %n coin</numerusform>
            <numerusform>%1 · polygone, %n coins</numerusform>
        </translation>
    </message>
    <message>
        <source>Draw a path</source>
        <translation>Dessiner un trajet</translation>
    </message>
</context>
<context>
    <name>quadrille::PathPoints</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>handle</source>
        <translation>poignée</translation>
    </message>
    <message>
        <source>Move a point of the path</source>
        <translation>Déplacer un point du trajet</translation>
    </message>
    <message>
        <source>Edit the coordinate</source>
        <translation>Modifier la coordonnée</translation>
    </message>
    <message>
        <source>Delete the point</source>
        <translation>Supprimer le point</translation>
    </message>
</context>
<context>
    <name>quadrille::PathResult</name>
    <message>
        <source>Animate</source>
        <translation>Animer</translation>
    </message>
    <message>
        <source>Show the &amp;deviation</source>
        <translation>Montrer l’é&amp;cart</translation>
    </message>
    <message>
        <source>Draw a line from the body’s centre to where the path wants it</source>
        <translation>Tracer une ligne du centre du corps à l’endroit où le trajet le veut</translation>
    </message>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>%1 cm away</source>
        <translation>à %1 cm</translation>
    </message>
</context>
<context>
    <name>quadrille::PathTool</name>
    <message>
        <source>Animate</source>
        <translation>Animer</translation>
    </message>
    <message>
        <source>Draw a &amp;path</source>
        <translation>Dessiner un &amp;trajet</translation>
    </message>
    <message>
        <source>Click for points, or drag a stroke; Return or a double click ends, Backspace takes the last point back</source>
        <translation>Cliquer pour des points, ou tracer un trait&#xa0;; Entrée ou un double clic termine, Retour arrière reprend le dernier point</translation>
    </message>
    <message>
        <source>Add a &amp;round obstacle</source>
        <translation>Ajouter un obstacle &amp;rond</translation>
    </message>
    <message>
        <source>Drag from the middle of a disc that the body stays out of</source>
        <translation>Faire glisser depuis le milieu d’un disque où le corps n’entre pas</translation>
    </message>
    <message>
        <source>Add an obstacle with &amp;corners</source>
        <translation>Ajouter un obstacle à c&amp;oins</translation>
    </message>
    <message>
        <source>Click corners; Return or a click on the first one ends</source>
        <translation>Cliquer des coins&#xa0;; Entrée ou un clic sur le premier termine</translation>
    </message>
    <message>
        <source>Sho&amp;w the path</source>
        <translation>&amp;Montrer le trajet</translation>
    </message>
    <message>
        <source>Show the path with its points, spans and obstacles in the view</source>
        <translation>Montrer le trajet avec ses points, portions et obstacles dans la vue</translation>
    </message>
    <message>
        <source>Ask for frames or speed on a &amp;span</source>
        <translation>Demander des images ou une vitesse sur une &amp;portion</translation>
    </message>
    <message>
        <source>Only frames with a label, or a speed, on a part of the path</source>
        <translation>Seulement des images avec une étiquette, ou une vitesse, sur une partie du trajet</translation>
    </message>
    <message>
        <source>Re&amp;verse the path</source>
        <translation>In&amp;verser le trajet</translation>
    </message>
    <message>
        <source>Begin at its end</source>
        <translation>Commencer à sa fin</translation>
    </message>
    <message>
        <source>Reverse the path</source>
        <translation>Inverser le trajet</translation>
    </message>
    <message>
        <source>&amp;Close the path</source>
        <translation>&amp;Fermer le trajet</translation>
    </message>
    <message>
        <source>Lead the path back to where it began</source>
        <translation>Ramener le trajet à son début</translation>
    </message>
    <message>
        <source>Close the path</source>
        <translation>Fermer le trajet</translation>
    </message>
    <message>
        <source>De&amp;lete the path</source>
        <translation>Supprimer &amp;le trajet</translation>
    </message>
    <message>
        <source>Take away the path with its spans and obstacles</source>
        <translation>Retirer le trajet avec ses portions et ses obstacles</translation>
    </message>
    <message>
        <source>Delete the path</source>
        <translation>Supprimer le trajet</translation>
    </message>
    <message>
        <source>&amp;Insert a point here</source>
        <translation>&amp;Insérer un point ici</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>&amp;Join the handles</source>
        <translation>&amp;Joindre les poignées</translation>
    </message>
    <message>
        <source>Move the end of a span</source>
        <translation>Déplacer l’extrémité d’une portion</translation>
    </message>
    <message>
        <source>Delete a span of the path</source>
        <translation>Supprimer une portion du trajet</translation>
    </message>
    <message>
        <source>Add an obstacle</source>
        <translation>Ajouter un obstacle</translation>
    </message>
    <message>
        <source>Change an obstacle</source>
        <translation>Modifier un obstacle</translation>
    </message>
    <message>
        <source>Delete an obstacle</source>
        <translation>Supprimer un obstacle</translation>
    </message>
    <message>
        <source>Add a point to the path</source>
        <translation>Ajouter un point au trajet</translation>
    </message>
    <message>
        <source>Insert a point into the path</source>
        <translation>Insérer un point dans le trajet</translation>
    </message>
    <message>
        <source>Delete a point of the path</source>
        <translation>Supprimer un point du trajet</translation>
    </message>
    <message>
        <source>Draw a path</source>
        <translation>Dessiner un trajet</translation>
    </message>
    <message>
        <source>Move a point of the path</source>
        <translation>Déplacer un point du trajet</translation>
    </message>
    <message>
        <source>An end of the path is too close</source>
        <translation>Une extrémité du trajet est trop proche</translation>
    </message>
    <message>
        <source>Handle of point %1 of the path</source>
        <translation>Poignée du point %1 du trajet</translation>
    </message>
    <message>
        <source>Point %1 of the path</source>
        <translation>Point %1 du trajet</translation>
    </message>
    <message>
        <source>Beginning of span %1</source>
        <translation>Début de la portion %1</translation>
    </message>
    <message>
        <source>End of span %1</source>
        <translation>Fin de la portion %1</translation>
    </message>
    <message>
        <source>Corner %1 of obstacle %2</source>
        <translation>Coin %1 de l’obstacle %2</translation>
    </message>
    <message>
        <source>Obstacle %1</source>
        <translation>Obstacle %1</translation>
    </message>
    <message>
        <source>Add a span to the path</source>
        <translation>Ajouter une portion au trajet</translation>
    </message>
    <message>
        <source>Change the kind of curve</source>
        <translation>Changer le type de courbe</translation>
    </message>
    <message>
        <source>Lead the path through space</source>
        <translation>Mener le trajet dans l’espace</translation>
    </message>
    <message>
        <source>Lead the path over the ground</source>
        <translation>Mener le trajet sur le sol</translation>
    </message>
    <message>
        <source>%1, frames %2 – %3</source>
        <translation>%1, images %2 – %3</translation>
    </message>
    <message>
        <source>any frames</source>
        <translation>toutes images</translation>
    </message>
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
    </message>
</context>
<context>
    <name>quadrille::PictureFields</name>
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
    <message>
        <source>Goes along its keys</source>
        <translation>Suit ses clés</translation>
    </message>
    <message>
        <source>From where the view looks</source>
        <translation>D’où regarde la vue</translation>
    </message>
    <message>
        <source>The frame that the view shows looks the same in the film; otherwise the camera steps back until the figure fills the picture</source>
        <translation>L’image que montre la vue est la même dans le film&#xa0;; sinon, la caméra recule jusqu’à ce que la figure remplisse l’image</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
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
    <name>quadrille::PoseComparison</name>
    <message>
        <source>The pose distance is shown between two sequences.</source>
        <translation>La distance de pose se montre entre deux séquences.</translation>
    </message>
    <message>
        <source>“%1” and “%2” have different meshes.</source>
        <translation>«&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;» ont des maillages différents.</translation>
    </message>
    <message>
        <source>Select two of them.</source>
        <translation>Sélectionnez-en deux.</translation>
    </message>
    <message>
        <source>Poses can be compared where both belong to one character.</source>
        <translation>Les poses se comparent quand les deux appartiennent à un même personnage.</translation>
    </message>
</context>
<context>
    <name>quadrille::PoseHeatMap</name>
    <message>
        <source>Pose distance of “%1” and “%2”</source>
        <translation>Distance de pose de «&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>Pose distance, mean %1</source>
        <extracomment>title of a legend; %1 is a number of radians</extracomment>
        <translation>Distance de pose, moyenne %1</translation>
    </message>
    <message>
        <source>rad</source>
        <translation>rad</translation>
    </message>
</context>
<context>
    <name>quadrille::PostPanel</name>
    <message>
        <source>Only a loop can be repeated: ask for one above.</source>
        <translation>Seule une boucle peut être répétée&#xa0;: demandez-en une ci-dessus.</translation>
    </message>
    <message>
        <source>Here an animation is looped, retimed, mirrored and blended.</source>
        <translation>Ici une animation est bouclée, retardée ou accélérée, mise en miroir et fondue.</translation>
    </message>
    <message>
        <source>Time in the result (s)</source>
        <translation>Temps dans le résultat (s)</translation>
    </message>
    <message>
        <source>Moment of the clip (s)</source>
        <translation>Moment du clip (s)</translation>
    </message>
    <message>
        <source>Curve of times</source>
        <translation>Courbe des temps</translation>
    </message>
    <message>
        <source> s</source>
        <comment>unit of a number</comment>
        <translation> s</translation>
    </message>
    <message>
        <source>a third</source>
        <translation>un tiers</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Boucle</translation>
    </message>
    <message>
        <source>Cuts both ends where they fit best and blends one into the other</source>
        <translation>Coupe les deux bouts là où ils s’accordent le mieux et fond l’un dans l’autre</translation>
    </message>
    <message>
        <source>Cut at the start</source>
        <translation>Coupe au début</translation>
    </message>
    <message>
        <source>How far from the first frame the loop may begin</source>
        <translation>À quelle distance de la première image la boucle peut commencer</translation>
    </message>
    <message>
        <source>Cut at the end</source>
        <translation>Coupe à la fin</translation>
    </message>
    <message>
        <source>How far from the last frame the loop may end</source>
        <translation>À quelle distance de la dernière image la boucle peut finir</translation>
    </message>
    <message>
        <source>Takes the way over the ground out, so that each round begins where it began</source>
        <translation>Retire le chemin au sol&#xa0;: chaque tour commence là où il a commencé</translation>
    </message>
    <message>
        <source>Repeats</source>
        <translation>Répétitions</translation>
    </message>
    <message>
        <source>How often the loop plays</source>
        <translation>Combien de fois la boucle est jouée</translation>
    </message>
    <message>
        <source> ×</source>
        <comment>how many times</comment>
        <translation> ×</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Retime</source>
        <translation>Changer le temps</translation>
    </message>
    <message>
        <source>Plays the clip faster or slower, as a whole or from moment to moment</source>
        <translation>Joue le clip plus vite ou plus lentement, en entier ou de moment en moment</translation>
    </message>
    <message>
        <source>Not at all</source>
        <translation>Pas du tout</translation>
    </message>
    <message>
        <source>By a factor</source>
        <translation>Par un facteur</translation>
    </message>
    <message>
        <source>To a duration</source>
        <translation>À une durée</translation>
    </message>
    <message>
        <source>By a curve</source>
        <translation>Par une courbe</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Facteur</translation>
    </message>
    <message>
        <source>Times as long as the clip: 2 is half as fast</source>
        <translation>Fois la longueur du clip&#xa0;: 2 est deux fois moins vite</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>How long the result lasts</source>
        <translation>Combien dure le résultat</translation>
    </message>
    <message>
        <source>The figure goes as fast as in the clip, and its feet slide; otherwise its way slows with its poses</source>
        <translation>La figure va aussi vite que dans le clip, et ses pieds glissent&#xa0;; sinon son chemin ralentit avec ses poses</translation>
    </message>
    <message>
        <source>Drag points; double-click adds one, Del removes it; Page Up and Down choose one</source>
        <translation>Tirez les points&#xa0;; un double-clic en ajoute un, Suppr le retire&#xa0;; Page préc. et suiv. en choisissent un</translation>
    </message>
    <message>
        <source> %</source>
        <comment>unit of a number</comment>
        <translation> %</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Pieds</translation>
    </message>
    <message>
        <source>Takes slip from feet while they touch the ground</source>
        <translation>Retire le glissement des pieds tant qu’ils touchent le sol</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Force</translation>
    </message>
    <message>
        <source>Share of the slip that is taken out</source>
        <translation>Part du glissement qui est retirée</translation>
    </message>
    <message>
        <source>Ease</source>
        <translation>Transition douce</translation>
    </message>
    <message>
        <source>How long before a contact it sets in, and how long after it dies away</source>
        <translation>Combien de temps avant un contact cela commence, et combien de temps après cela s’éteint</translation>
    </message>
    <message>
        <source>Greatest shift</source>
        <translation>Déplacement maximal</translation>
    </message>
    <message>
        <source>How far a foot is moved at most, of the height of the figure; the rest of the slip stays</source>
        <translation>De combien un pied est déplacé au plus, en part de la hauteur de la figure&#xa0;; le reste du glissement demeure</translation>
    </message>
    <message>
        <source>Greatest turn</source>
        <translation>Rotation maximale</translation>
    </message>
    <message>
        <source>How far a foot is turned about the vertical at most</source>
        <translation>De combien un pied est tourné au plus autour de la verticale</translation>
    </message>
    <message>
        <source>°</source>
        <comment>unit of a number</comment>
        <translation>°</translation>
    </message>
    <message>
        <source>Greatest lift</source>
        <translation>Élévation maximale</translation>
    </message>
    <message>
        <source>How far a foot is lifted or lowered at most, of the height of the figure</source>
        <translation>De combien un pied est levé ou baissé au plus, en part de la hauteur de la figure</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Miroir</translation>
    </message>
    <message>
        <source>Needs the symmetry of the mesh: found, or read from a file</source>
        <translation>Demande la symétrie du maillage&#xa0;: trouvée, ou lue dans un fichier</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symétrie</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>Choisir un fichier…</translation>
    </message>
    <message>
        <source>Find it in the mesh</source>
        <translation>La trouver dans le maillage</translation>
    </message>
    <message>
        <source>Found in the mesh</source>
        <translation>Trouvée dans le maillage</translation>
    </message>
    <message>
        <source>A file that names, for each vertex, the one opposite to it</source>
        <translation>Un fichier qui nomme, pour chaque sommet, celui qui lui est opposé</translation>
    </message>
    <message>
        <source>Choose a symmetry</source>
        <translation>Choisir une symétrie</translation>
    </message>
    <message>
        <source>Symmetries (*.npy *.txt *.csv);;All files (*)</source>
        <translation>Symétries (*.npy *.txt *.csv);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Blending</source>
        <translation>Fondu</translation>
    </message>
    <message>
        <source>Transitions</source>
        <translation>Transitions</translation>
    </message>
    <message>
        <source>Gentle keeps the speed of both takes smooth and standing feet in place</source>
        <translation>Doux garde lisse la vitesse des deux prises et en place les pieds posés</translation>
    </message>
    <message>
        <source>As published</source>
        <translation>Comme publié</translation>
    </message>
    <message>
        <source>Gentle</source>
        <translation>Doux</translation>
    </message>
    <message>
        <source>Between poses</source>
        <translation>Entre les poses</translation>
    </message>
    <message>
        <source>How a pose between two poses comes about: turning and stretching every triangle (Poisson), turning it and stretching linearly (Slerp), or on straight lines (Linear)</source>
        <translation>Comment naît une pose entre deux poses&#xa0;: en tournant et étirant chaque triangle (Poisson), en le tournant et l’étirant linéairement (Slerp), ou en ligne droite (Linéaire)</translation>
    </message>
    <message>
        <source>Poisson</source>
        <translation>Poisson</translation>
    </message>
    <message>
        <source>Slerp</source>
        <translation>Slerp</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linéaire</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Recherche</translation>
    </message>
    <message>
        <source>Budget</source>
        <translation>Budget</translation>
    </message>
    <message>
        <source>States that are looked at: more finds better walks and takes longer; the same budget finds the same walk on every machine</source>
        <translation>États examinés&#xa0;: davantage trouve de meilleurs parcours et prend plus de temps&#xa0;; le même budget trouve le même parcours sur toute machine</translation>
    </message>
    <message>
        <source>usual (%L1)</source>
        <comment>a number of states</comment>
        <translation>habituel (%L1)</translation>
    </message>
    <message>
        <source>Timing, β</source>
        <translation>Temps, β</translation>
    </message>
    <message>
        <source>What a frame of timing error costs: more meets times better, with worse transitions</source>
        <translation>Ce que coûte une image d’erreur de temps&#xa0;: davantage tient mieux les temps, avec de moins bonnes transitions</translation>
    </message>
    <message>
        <source>10 α</source>
        <translation>10 α</translation>
    </message>
    <message>
        <source>Transitions, μ</source>
        <translation>Transitions, μ</translation>
    </message>
    <message>
        <source>What transitions count against squared metres of deviation from a path</source>
        <translation>Ce que comptent les transitions face aux mètres carrés d’écart au trajet</translation>
    </message>
    <message>
        <source>usual (%L1)</source>
        <comment>a weight</comment>
        <translation>habituel (%L1)</translation>
    </message>
    <message>
        <source>Seeks the best walk over all keys; otherwise from key to key, as published</source>
        <translation>Cherche le meilleur parcours sur toutes les clés&#xa0;; sinon de clé en clé, comme publié</translation>
    </message>
    <message>
        <source>Variations</source>
        <translation>Variations</translation>
    </message>
    <message>
        <source>Frames shown again</source>
        <translation>Images remontrées</translation>
    </message>
    <message>
        <source>The first time captured frames are shown as they are; each further time they can be drawn from another variation of their take, so that repeats are never the same</source>
        <translation>La première fois, les images captées sont montrées telles quelles&#xa0;; chaque fois suivante, elles peuvent être tirées d’une autre variation de leur prise, pour qu’aucune reprise ne soit la même</translation>
    </message>
    <message>
        <source>How long poses take from captured frames to varied ones, and back</source>
        <translation>Temps que mettent les poses pour passer des images captées aux variées, et revenir</translation>
    </message>
    <message>
        <source>As captured</source>
        <translation>Telles quelles</translation>
    </message>
    <message>
        <source>From all</source>
        <translation>De toutes</translation>
    </message>
    <message>
        <source>From “%1”</source>
        <comment>variations</comment>
        <translation>De «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>There are no variations to draw from: learn some in the workspace Variations.</source>
        <translation>Il n’y a pas de variations d’où tirer&#xa0;: apprenez-en dans l’espace Variations.</translation>
    </message>
    <message>
        <source>This animation shows no frames again.</source>
        <translation>Cette animation ne remontre aucune image.</translation>
    </message>
    <message>
        <source>Some frames are shown again as captured: no variation varies them.</source>
        <translation>Certaines images sont remontrées telles que captées&#xa0;: aucune variation ne les varie.</translation>
    </message>
    <message>
        <source>Walks</source>
        <translation>Parcours</translation>
    </message>
    <message>
        <source>Calm walks stay in a take for a while, need not keep to a path by the centimetre, and prefer takes of locomotion along it</source>
        <translation>Les parcours calmes restent un moment dans une prise, ne suivent pas un trajet au centimètre près et y préfèrent les prises de locomotion</translation>
    </message>
    <message>
        <source>Calm</source>
        <translation>Calmes</translation>
    </message>
    <message>
        <source>Stay in a take</source>
        <translation>Rester dans une prise</translation>
    </message>
    <message>
        <source>Least time between two transitions of a calm walk</source>
        <translation>Temps minimal entre deux transitions d’un parcours calme</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>usual (%L1 s)</source>
        <comment>seconds</comment>
        <translation>usuel (%L1 s)</translation>
    </message>
    <message>
        <source>Off the path</source>
        <translation>Écart au trajet</translation>
    </message>
    <message>
        <source>How far from a path a calm walk may be without any cost</source>
        <translation>De combien un parcours calme peut s’écarter d’un trajet sans que cela coûte</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>usual (%L1 m)</source>
        <comment>metres</comment>
        <translation>usuel (%L1 m)</translation>
    </message>
    <message>
        <source>Steering</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>How far a calm walk turns towards its path at most, beyond what was captured; 0: not at all</source>
        <translation>De combien un parcours calme tourne au plus vers son trajet, au-delà de ce qui a été capté ; 0 : pas du tout</translation>
    </message>
    <message>
        <source>°/m</source>
        <translation>°/m</translation>
    </message>
    <message>
        <source>usual (%L1°/m)</source>
        <comment>degrees a metre</comment>
        <translation>usuel (%L1°/m)</translation>
    </message>
    <message>
        <source>Close to a seamless loop</source>
        <translation>Fermer en boucle sans couture</translation>
    </message>
    <message>
        <source>Stay in place</source>
        <translation>Rester sur place</translation>
    </message>
    <message>
        <source>Keep the speed over the ground</source>
        <translation>Garder la vitesse au sol</translation>
    </message>
    <message>
        <source>Keep standing feet still</source>
        <translation>Tenir immobiles les pieds posés</translation>
    </message>
    <message>
        <source>Exchange left and right</source>
        <translation>Échanger gauche et droite</translation>
    </message>
    <message>
        <source>All keys at once</source>
        <translation>Toutes les clés à la fois</translation>
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
    <message>
        <source>Copy unsaved edits within</source>
        <translation>Copier les modifications non enregistrées sous</translation>
    </message>
    <message>
        <source>Mouse in the view</source>
        <translation>Souris dans la vue</translation>
    </message>
    <message>
        <source>Which buttons and keys turn, move and near the view</source>
        <translation>Boutons et touches qui tournent, déplacent et rapprochent la vue</translation>
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
    <message numerus="yes">
        <source>Remove %n animations</source>
        <translation>
            <numerusform>Retirer %n animation</numerusform>
            <numerusform>Retirer %n animations</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove %n variations</source>
        <translation>
            <numerusform>Retirer %n variation</numerusform>
            <numerusform>Retirer %n variations</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1” is taken</source>
        <translation>«&#xa0;%1&#xa0;» est déjà pris</translation>
    </message>
    <message>
        <source>Choose another name.</source>
        <translation>Choisissez un autre nom.</translation>
    </message>
    <message numerus="yes">
        <source>Remove %n evaluations</source>
        <translation>
            <numerusform>Retirer %n évaluation</numerusform>
            <numerusform>Retirer %n évaluations</numerusform>
        </translation>
    </message>
    <message>
        <source>Add evaluation “%1”</source>
        <translation>Ajouter l’évaluation « %1 »</translation>
    </message>
    <message numerus="yes">
        <source>Remove %n models of appearance</source>
        <translation>
            <numerusform>Supprimer %n modèle d’apparence</numerusform>
            <numerusform>Supprimer %n modèles d’apparence</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove %n transfers</source>
        <translation>
            <numerusform>Supprimer %n transfert</numerusform>
            <numerusform>Supprimer %n transferts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove %n projections</source>
        <translation>
            <numerusform>Supprimer %n projection</numerusform>
            <numerusform>Supprimer %n projections</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove %n motion spaces</source>
        <translation>
            <numerusform>Retirer %n espace de mouvement</numerusform>
            <numerusform>Retirer %n espaces de mouvement</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove %n live performances</source>
        <translation>
            <numerusform>Supprimer %n performance en direct</numerusform>
            <numerusform>Supprimer %n performances en direct</numerusform>
        </translation>
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
    <message>
        <source>“%1” is open read only.</source>
        <translation>«&#xa0;%1&#xa0;» est ouvert en lecture seule.</translation>
    </message>
    <message>
        <source>The folder of “%1” cannot be written to.</source>
        <translation>Le dossier de «&#xa0;%1&#xa0;» n’est pas accessible en écriture.</translation>
    </message>
    <message>
        <source>“%1” was taken over: %2.</source>
        <translation>«&#xa0;%1&#xa0;» a été repris&#xa0;: %2.</translation>
    </message>
    <message>
        <source>“%1” is open elsewhere: %2. Choose another name.</source>
        <translation>«&#xa0;%1&#xa0;» est ouvert ailleurs&#xa0;: %2. Choisissez un autre nom.</translation>
    </message>
</context>
<context>
    <name>quadrille::ProjectGuard</name>
    <message>
        <source>somebody, since %1</source>
        <translation>quelqu’un, depuis %1</translation>
    </message>
    <message>
        <source>%1 on %2, not heard of since %3</source>
        <translation>%1 sur %2, sans nouvelles depuis %3</translation>
    </message>
    <message>
        <source>%1 on %2, since %3</source>
        <translation>%1 sur %2, depuis %3</translation>
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
        <source>&amp;Remove from the project</source>
        <translation>&amp;Retirer du projet</translation>
    </message>
    <message>
        <source>Take the selected entries out; their files stay</source>
        <translation>Retirer les éléments sélectionnés&#xa0;; leurs fichiers restent</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Réessayer</translation>
    </message>
    <message>
        <source>Show in its folder</source>
        <translation>Montrer dans son dossier</translation>
    </message>
    <message>
        <source>Add a copy of the selected sequence, animation or variations, to change it</source>
        <translation>Ajouter une copie de la séquence, de l’animation ou des variations sélectionnées, pour la modifier</translation>
    </message>
    <message>
        <source>Unfold all</source>
        <translation>Tout déplier</translation>
    </message>
    <message>
        <source>Fold all</source>
        <translation>Tout replier</translation>
    </message>
    <message>
        <source>Variations</source>
        <translation>Variations</translation>
    </message>
    <message>
        <source>New &amp;motion space</source>
        <translation>Nouvel espace de &amp;mouvement</translation>
    </message>
    <message>
        <source>Make the selected takes one movement that is steered, such as by its speed</source>
        <translation>Faire des prises choisies un seul mouvement que l’on conduit, par exemple par sa vitesse</translation>
    </message>
    <message>
        <source>motion space</source>
        <translation>espace de mouvement</translation>
    </message>
</context>
<context>
    <name>quadrille::ProjectQuestions</name>
    <message>
        <source>“%1” is open elsewhere: %2.</source>
        <translation>«&#xa0;%1&#xa0;» est ouvert ailleurs&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Two who save the same project write over each other&apos;s work. Taken over, it cannot be saved there any more without being asked.</source>
        <translation>Deux personnes qui enregistrent le même projet écrasent le travail l’une de l’autre. Une fois repris, il ne peut plus être enregistré là-bas sans question.</translation>
    </message>
    <message>
        <source>Open a copy</source>
        <translation>Ouvrir une copie</translation>
    </message>
    <message>
        <source>Read only</source>
        <translation>Lecture seule</translation>
    </message>
    <message>
        <source>Take over</source>
        <translation>Reprendre</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Enregistrer sous…</translation>
    </message>
    <message>
        <source>Take over and save</source>
        <translation>Reprendre et enregistrer</translation>
    </message>
    <message>
        <source>Save it under another name to keep your edits.</source>
        <translation>Enregistrez-le sous un autre nom pour garder vos modifications.</translation>
    </message>
    <message>
        <source>The file of “%1” was changed by somebody else since it was opened.</source>
        <translation>Le fichier de «&#xa0;%1&#xa0;» a été modifié par quelqu’un d’autre depuis son ouverture.</translation>
    </message>
    <message>
        <source>Overwriting it loses their edits; reloading it loses yours.</source>
        <translation>L’écraser perd leurs modifications&#xa0;; le recharger perd les vôtres.</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Écraser</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Recharger</translation>
    </message>
    <message>
        <source>Reload “%1”?</source>
        <translation>Recharger «&#xa0;%1&#xa0;»&#xa0;?</translation>
    </message>
    <message>
        <source>Your unsaved edits are lost then.</source>
        <translation>Vos modifications non enregistrées seront alors perdues.</translation>
    </message>
    <message>
        <source>“%1” cannot be opened. %2</source>
        <comment>project and problem</comment>
        <translation>«&#xa0;%1&#xa0;» ne peut pas être ouvert. %2</translation>
    </message>
    <message>
        <source>The backup beside it, of %1, can. It takes the project&apos;s place when you save.</source>
        <translation>La copie de sauvegarde à côté, du %1, peut l’être. Elle prend la place du projet quand vous enregistrez.</translation>
    </message>
    <message>
        <source>Open the backup</source>
        <translation>Ouvrir la sauvegarde</translation>
    </message>
</context>
<context>
    <name>quadrille::ProjectStrips</name>
    <message>
        <source>Edits can be saved under another name.</source>
        <translation>Les modifications peuvent être enregistrées sous un autre nom.</translation>
    </message>
    <message>
        <source>“%1” is open read only; it is open elsewhere: %2. %3</source>
        <translation>«&#xa0;%1&#xa0;» est ouvert en lecture seule&#xa0;; il est ouvert ailleurs&#xa0;: %2. %3</translation>
    </message>
    <message>
        <source>“%1” is open read only: its folder cannot be written to. %2</source>
        <translation>«&#xa0;%1&#xa0;» est ouvert en lecture seule&#xa0;: son dossier n’est pas accessible en écriture. %2</translation>
    </message>
    <message>
        <source>“%1” was taken over: %2. %3</source>
        <translation>«&#xa0;%1&#xa0;» a été repris&#xa0;: %2. %3</translation>
    </message>
    <message>
        <source>The file of “%1” was changed by another program.</source>
        <translation>Le fichier de «&#xa0;%1&#xa0;» a été modifié par un autre programme.</translation>
    </message>
    <message numerus="yes">
        <source>%n part(s) of the project cannot be read. They stay in its file as they are.</source>
        <translation>
            <numerusform>%n partie du projet est illisible. Elle reste telle quelle dans le fichier.</numerusform>
            <numerusform>%n parties du projet sont illisibles. Elles restent telles quelles dans le fichier.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) of the project changed on disk.</source>
        <translation>
            <numerusform>%n fichier du projet a changé sur le disque.</numerusform>
            <numerusform>%n fichiers du projet ont changé sur le disque.</numerusform>
        </translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Enregistrer sous…</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Recharger</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Montrer</translation>
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
    <message>
        <source>Animations (%1)</source>
        <translation>Animations (%1)</translation>
    </message>
    <message>
        <source>Variations (%1)</source>
        <translation>Variations (%1)</translation>
    </message>
    <message>
        <source>Body parts (%1)</source>
        <translation>Parties du corps (%1)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>an entry of the project, and its state or what is wrong with it</extracomment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>not made yet, or out of date</source>
        <translation>pas encore fait, ou périmé</translation>
    </message>
    <message>
        <source>being made</source>
        <translation>en cours</translation>
    </message>
    <message>
        <source>Cannot be read (%1)</source>
        <translation>Illisible (%1)</translation>
    </message>
    <message>
        <source>Evaluations (%1)</source>
        <translation>Évaluations (%1)</translation>
    </message>
    <message>
        <source>Appearance (%1)</source>
        <translation>Apparence (%1)</translation>
    </message>
    <message>
        <source>Transfers (%1)</source>
        <translation>Transferts (%1)</translation>
    </message>
    <message>
        <source>Projections (%1)</source>
        <translation>Projections (%1)</translation>
    </message>
    <message>
        <source>Motion spaces (%1)</source>
        <translation>Espaces de mouvement (%1)</translation>
    </message>
    <message>
        <source>Live performances (%1)</source>
        <translation>Performances en direct (%1)</translation>
    </message>
</context>
<context>
    <name>quadrille::ProjectionEdits</name>
    <message>
        <source>Add 3D video “%1”</source>
        <translation>Ajouter la vidéo 3D « %1 »</translation>
    </message>
    <message>
        <source>Duplicate “%1”</source>
        <translation>Dupliquer «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>quadrille::ProjectionPage</name>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Unique in the project</source>
        <translation>Unique dans le projet</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Caméras</translation>
    </message>
    <message>
        <source>The table of calibrated cameras and their pictures, JSON; a click chooses another</source>
        <translation>La table des caméras calibrées et de leurs images, JSON ; un clic en choisit une autre</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Clip</translation>
    </message>
    <message>
        <source>What the cameras saw, frame by frame: a take or a transferred clip</source>
        <translation>Ce que les caméras ont vu, image par image : une prise ou un clip transféré</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Side of the textures, texels; where texels are smaller than the pictures’ pixels, textures get soft</source>
        <translation>Côté des textures, en texels ; là où les texels sont plus petits que les pixels des images, les textures deviennent douces</translation>
    </message>
    <message>
        <source>Sharpness</source>
        <translation>Netteté</translation>
    </message>
    <message>
        <source>How much more cameras count that see a surface from the front; 0 takes all alike</source>
        <translation>À quel point comptent davantage les caméras qui voient une surface de face ; 0 les prend toutes également</translation>
    </message>
    <message>
        <source>Fill what no camera sees</source>
        <translation>Remplir ce qu’aucune caméra ne voit</translation>
    </message>
    <message>
        <source>From other frames, and else from what is beside it; otherwise it is black</source>
        <translation>D’après d’autres images, sinon d’après ce qui est à côté ; autrement c’est noir</translation>
    </message>
    <message>
        <source>Choose a table of cameras</source>
        <translation>Choisir une table de caméras</translation>
    </message>
    <message>
        <source>Cameras (*.json)</source>
        <translation>Caméras (*.json)</translation>
    </message>
    <message>
        <source>Choose cameras</source>
        <translation>Choisir des caméras</translation>
    </message>
    <message>
        <source>3D video “%1”</source>
        <translation>Vidéo 3D « %1 »</translation>
    </message>
    <message>
        <source>Compute the textures</source>
        <translation>Calculer les textures</translation>
    </message>
    <message>
        <source>Add as a take</source>
        <translation>Ajouter comme prise</translation>
    </message>
    <message>
        <source>Computes the textures and adds the clip that wears them to the takes</source>
        <translation>Calcule les textures et ajoute aux prises le clip qui les porte</translation>
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
    <name>quadrille::QualityPanel</name>
    <message>
        <source>Explained variance</source>
        <translation>Variance expliquée</translation>
    </message>
    <message>
        <source>What is drawn over the number of components</source>
        <translation>Ce qui est tracé selon le nombre de composantes</translation>
    </message>
    <message>
        <source>Compute</source>
        <translation>Calculer</translation>
    </message>
    <message>
        <source>Adds the evaluation to the project where it is missing, and computes it</source>
        <translation>Ajoute l’évaluation au projet si elle y manque, et la calcule</translation>
    </message>
    <message>
        <source>What more components give shows here, once the model is built.</source>
        <translation>Ce qu’apportent plus de composantes se montre ici, une fois le modèle construit.</translation>
    </message>
    <message>
        <source>used</source>
        <comment>components</comment>
        <translation>utilisées</translation>
    </message>
    <message>
        <source>Components of the space</source>
        <translation>Composantes de l’espace</translation>
    </message>
    <message>
        <source>Eigen textures</source>
        <translation>Textures propres</translation>
    </message>
    <message>
        <source>Eigen warps</source>
        <translation>Déformations propres</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>Calcul…</translation>
    </message>
    <message>
        <source>Needs takes of a character.</source>
        <translation>Demande des prises d’un personnage.</translation>
    </message>
</context>
<context>
    <name>quadrille::RangeField</name>
    <message>
        <source>First frame</source>
        <translation>Première image</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Dernière image</translation>
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
    <name>quadrille::RecentProjects</name>
    <message>
        <source>Not there any more</source>
        <translation>N’existe plus</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>Projets récents</translation>
    </message>
    <message>
        <source>%1 is not there any more. Del forgets it.</source>
        <translation>%1 n’existe plus. Suppr l’oublie.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Show in its folder</source>
        <translation>Montrer dans son dossier</translation>
    </message>
    <message>
        <source>Remove from this list</source>
        <translation>Retirer de cette liste</translation>
    </message>
</context>
<context>
    <name>quadrille::Recovery</name>
    <message>
        <source>Untitled</source>
        <translation>Sans titre</translation>
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
        <translation>Quadrille s’est arrêté de façon inattendue. Des modifications de «&#xa0;%1&#xa0;» du %2 n’ont jamais été enregistrées.</translation>
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
    <message>
        <source>A copy of unsaved edits cannot be read. It was kept, and lies at %1 now.</source>
        <translation>Une copie de modifications non enregistrées est illisible. Elle a été gardée et se trouve maintenant ici&#xa0;: %1.</translation>
    </message>
</context>
<context>
    <name>quadrille::RecoveryNotice</name>
    <message numerus="yes">
        <source>Unsaved work: “%1”, %2, %n entries</source>
        <translation>
            <numerusform>Travail non enregistré&#xa0;: «&#xa0;%1 », %2, %n entrée</numerusform>
            <numerusform>Travail non enregistré&#xa0;: «&#xa0;%1 », %2, %n entrées</numerusform>
        </translation>
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
        <source>Deletes this copy for good</source>
        <translation>Supprime cette copie définitivement</translation>
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
        <translation>Recherche dans «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Search another folder, or choose one file by hand.</source>
        <translation>Cherchez dans un autre dossier, ou choisissez un fichier à la main.</translation>
    </message>
    <message>
        <source>Where is “%1”?</source>
        <translation>Où est «&#xa0;%1&#xa0;»&#xa0;?</translation>
    </message>
    <message>
        <source>Files of this kind (*%1);;All files (*)</source>
        <translation>Fichiers de ce type (*%1);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Comparing “%1”</source>
        <translation>Comparaison de «&#xa0;%1&#xa0;»</translation>
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
        <translation>Rien ne manque&#xa0;: tous les fichiers sont là où le projet le dit.</translation>
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
        <translation>Dire où est le fichier de cette ligne&#xa0;; les autres sont cherchés à partir de là</translation>
    </message>
    <message>
        <source>Use the files that are ticked; one step for undo</source>
        <translation>Utiliser les fichiers cochés&#xa0;; une seule étape d’annulation</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>None of the missing files is in “%1”.</source>
        <translation>Aucun des fichiers manquants n’est dans «&#xa0;%1 ».</translation>
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
    <name>quadrille::ReportPanel</name>
    <message>
        <source>%1 %2</source>
        <comment>number and unit</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Animate</source>
        <translation>Animer</translation>
    </message>
    <message>
        <source>&amp;Copy the report</source>
        <translation>&amp;Copier le rapport</translation>
    </message>
    <message>
        <source>Copies what was wanted and obtained as comma-separated values</source>
        <translation>Copie ce qui était voulu et obtenu en valeurs séparées par des virgules</translation>
    </message>
    <message>
        <source>Sa&amp;ve the report…</source>
        <translation>&amp;Enregistrer le rapport…</translation>
    </message>
    <message>
        <source>Saves what was wanted and obtained as a CSV file</source>
        <translation>Enregistre ce qui était voulu et obtenu dans un fichier CSV</translation>
    </message>
    <message>
        <source>Save the &amp;frames&apos; origins…</source>
        <translation>Enregistrer l’origine des &amp;images…</translation>
    </message>
    <message>
        <source>Saves the time of every frame and where it comes from as a CSV file</source>
        <translation>Enregistre le temps de chaque image et d’où elle vient dans un fichier CSV</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>what, and of which</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Missed by %1 s</source>
        <translation>Manqué de %1 s</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>now</source>
        <comment>time of the frame that is shown</comment>
        <translation>maintenant</translation>
    </message>
    <message>
        <source>Save the frames&apos; origins</source>
        <translation>Enregistrer l’origine des images</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Enregistrer le rapport</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>Valeurs séparées par des virgules (*.csv)</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Quoi</translation>
    </message>
    <message>
        <source>Wanted</source>
        <translation>Voulu</translation>
    </message>
    <message>
        <source>Obtained</source>
        <translation>Obtenu</translation>
    </message>
    <message>
        <source>What was wanted and obtained</source>
        <translation>Ce qui était voulu et obtenu</translation>
    </message>
    <message>
        <source>What was asked of the animation and what it does comes here, as soon as there is a clip.</source>
        <translation>Ce qui a été demandé à l’animation et ce qu’elle fait vient ici, dès qu’il y a un clip.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>s</source>
        <comment>seconds</comment>
        <translation>s</translation>
    </message>
    <message>
        <source>cm</source>
        <comment>centimetres</comment>
        <translation>cm</translation>
    </message>
    <message>
        <source>Deviation from the path over time</source>
        <translation>Écart au trajet au cours du temps</translation>
    </message>
</context>
<context>
    <name>quadrille::ResultsFlow</name>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Fo&amp;lder of results…</source>
        <translation>Dossier des résu&amp;ltats…</translation>
    </message>
    <message>
        <source>Choose where the results of this project are stored</source>
        <translation>Choisir où les résultats de ce projet sont enregistrés</translation>
    </message>
    <message>
        <source>Choose a folder…</source>
        <translation>Choisir un dossier…</translation>
    </message>
    <message numerus="yes">
        <source>%n result(s) cannot be stored anywhere and are in memory only.</source>
        <translation>
            <numerusform>%n résultat ne peut être enregistré nulle part et n’est qu’en mémoire.</numerusform>
            <numerusform>%n résultats ne peuvent être enregistrés nulle part et ne sont qu’en mémoire.</numerusform>
        </translation>
    </message>
    <message>
        <source>Free some space, or choose another folder.</source>
        <translation>Libérez de la place, ou choisissez un autre dossier.</translation>
    </message>
    <message>
        <source>The results of this project cannot be stored in their folder. They go to %1 until they can.</source>
        <translation>Les résultats de ce projet ne peuvent être enregistrés dans leur dossier. En attendant, ils vont dans %1.</translation>
    </message>
    <message>
        <source>Folder of results</source>
        <translation>Dossier des résultats</translation>
    </message>
</context>
<context>
    <name>quadrille::RewindPanel</name>
    <message>
        <source>Transitions that were made</source>
        <translation>Transitions faites</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Quand</translation>
    </message>
    <message>
        <source>Transition</source>
        <translation>Transition</translation>
    </message>
    <message>
        <source>Latency</source>
        <translation>Latence</translation>
    </message>
    <message>
        <source>Unlikeness</source>
        <translation>Dissemblance</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Attente</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>Coût</translation>
    </message>
    <message>
        <source>Dissimilarity of the poses that meet, 0 to 1000</source>
        <translation>Dissemblance des poses qui se rencontrent, de 0 à 1000</translation>
    </message>
    <message>
        <source>What the latency costs</source>
        <translation>Ce que coûte la latence</translation>
    </message>
    <message>
        <source>Transitions show here as they are made. Choose one to go back to it: Space plays on as it was, and steering takes over from there.</source>
        <translation>Les transitions apparaissent ici à mesure qu’elles se font. Choisissez-en une pour y revenir : Espace rejoue comme c’était, et diriger reprend la main de là.</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>leave frame %1, enter %2</source>
        <translation>quitter l’image %1, entrer par %2</translation>
    </message>
    <message>
        <source>%1 (chosen)</source>
        <translation>%1 (choisie)</translation>
    </message>
    <message>
        <source>%1 (going on)</source>
        <translation>%1 (continuer)</translation>
    </message>
    <message>
        <source>From the wish until the target is where it is wanted; of a single way from when it was looked for</source>
        <translation>Du souhait jusqu’à ce que la cible soit où on la veut ; d’une voie seule, depuis qu’elle fut cherchée</translation>
    </message>
</context>
<context>
    <name>quadrille::RightMenu</name>
    <message>
        <source>Copy as &amp;text</source>
        <translation>Copier comme &amp;texte</translation>
    </message>
</context>
<context>
    <name>quadrille::SampleFlow</name>
    <message>
        <source>Making the sample character</source>
        <translation>Création du personnage d’exemple</translation>
    </message>
</context>
<context>
    <name>quadrille::SamplesPanel</name>
    <message>
        <source>Variations</source>
        <translation>Variations</translation>
    </message>
    <message>
        <source>Vary &amp;another take</source>
        <translation>Varier une &amp;autre prise</translation>
    </message>
    <message>
        <source>Draw variations of another take or blend, too</source>
        <translation>Tirer aussi des variations d’une autre prise ou d’un mélange</translation>
    </message>
    <message>
        <source>Do not &amp;vary this take</source>
        <translation>Ne pas &amp;varier cette prise</translation>
    </message>
    <message>
        <source>Take these variations out of the project</source>
        <translation>Retirer ces variations du projet</translation>
    </message>
    <message>
        <source>Draw &amp;others</source>
        <translation>En tirer d’au&amp;tres</translation>
    </message>
    <message>
        <source>Draws as many other variations, with the next seed</source>
        <translation>Tire autant d’autres variations, avec la graine suivante</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Garder</translation>
    </message>
    <message>
        <source>Keeps the selected variations after all</source>
        <translation>Garde tout de même les variations sélectionnées</translation>
    </message>
    <message>
        <source>Dis&amp;card</source>
        <translation>&amp;Jeter</translation>
    </message>
    <message>
        <source>Throws the selected variations away: they are not exported</source>
        <translation>Jette les variations sélectionnées&#xa0;: elles ne sont pas exportées</translation>
    </message>
    <message>
        <source>Add as &amp;sequences</source>
        <translation>Ajouter comme &amp;séquences</translation>
    </message>
    <message>
        <source>Adds the selected variations to the project, to work on as on takes</source>
        <translation>Ajoute les variations sélectionnées au projet, pour y travailler comme sur des prises</translation>
    </message>
    <message>
        <source>E&amp;xport the data set…</source>
        <translation>E&amp;xporter le jeu de données…</translation>
    </message>
    <message>
        <source>Writes the variations that are kept, with where they come from</source>
        <translation>Écrit les variations gardées, avec leur provenance</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a take or blend, and how often</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>nothing: the take alone</source>
        <translation>rien&#xa0;: la prise seule</translation>
    </message>
    <message numerus="yes">
        <source>%n drawn, %1 rejected, %2 thrown away</source>
        <translation>
            <numerusform>%n tirée, %1 rejetées, %2 jetées</numerusform>
            <numerusform>%n tirées, %1 rejetées, %2 jetées</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 cm</source>
        <comment>a distance</comment>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>At most %1 cm from the nearest pose that was learned from</source>
        <translation>Au plus à %1 cm de la pose apprise la plus proche</translation>
    </message>
    <message>
        <source>%1 cm/s</source>
        <comment>a speed</comment>
        <translation>%1 cm/s</translation>
    </message>
    <message>
        <source>The take: %1 cm/s</source>
        <translation>La prise&#xa0;: %1 cm/s</translation>
    </message>
    <message>
        <source>%1 %</source>
        <comment>share in percent</comment>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Thrown away: it is not exported</source>
        <translation>Jetée&#xa0;: elle n’est pas exportée</translation>
    </message>
    <message>
        <source>Vary another take</source>
        <translation>Varier une autre prise</translation>
    </message>
    <message>
        <source>Do not vary a take</source>
        <translation>Ne pas varier une prise</translation>
    </message>
    <message numerus="yes">
        <source>Throw %n variation(s) away</source>
        <translation>
            <numerusform>Jeter %n variation</numerusform>
            <numerusform>Jeter %n variations</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Keep %n variation(s)</source>
        <translation>
            <numerusform>Garder %n variation</numerusform>
            <numerusform>Garder %n variations</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, variation %2</source>
        <extracomment>a take or blend, and the number of a variation</extracomment>
        <translation>%1, variation %2</translation>
    </message>
    <message numerus="yes">
        <source>Making %n clip(s)</source>
        <translation>
            <numerusform>Fabrication de %n clip</numerusform>
            <numerusform>Fabrication de %n clips</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 → %2, %3 %</source>
        <extracomment>two takes, and the share of the second</extracomment>
        <translation>%1 → %2, %3 %</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>De</translation>
    </message>
    <message>
        <source>Towards</source>
        <translation>Vers</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Poids</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>Vary a blend</source>
        <translation>Varier un mélange</translation>
    </message>
    <message>
        <source>Change the number of variations</source>
        <translation>Changer le nombre de variations</translation>
    </message>
    <message>
        <source>Change the seed</source>
        <translation>Changer la graine</translation>
    </message>
    <message>
        <source>Change the weight of a blend</source>
        <translation>Changer le poids d’un mélange</translation>
    </message>
    <message>
        <source>What variations are drawn of</source>
        <translation>Ce dont les variations sont tirées</translation>
    </message>
    <message>
        <source>The take that is varied</source>
        <translation>La prise qui est variée</translation>
    </message>
    <message>
        <source>The second take of a blend; blend the two in the movement to learn the way between</source>
        <translation>La seconde prise d’un mélange&#xa0;; mélangez les deux dans le mouvement pour apprendre l’entre-deux</translation>
    </message>
    <message>
        <source>The share of the second take</source>
        <translation>La part de la seconde prise</translation>
    </message>
    <message>
        <source> %</source>
        <comment>percent</comment>
        <translation> %</translation>
    </message>
    <message>
        <source>How many variations are drawn</source>
        <translation>Combien de variations sont tirées</translation>
    </message>
    <message>
        <source>The same seed draws the same variations</source>
        <translation>La même graine tire les mêmes variations</translation>
    </message>
    <message>
        <source>Check the takes to learn from in the panel Movement; what is drawn of them comes here.</source>
        <translation>Cochez les prises à apprendre dans le panneau Mouvement&#xa0;; ce qui en est tiré vient ici.</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N°</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>Skate</source>
        <translation>Glissement</translation>
    </message>
    <message>
        <source>Crossings</source>
        <translation>Croisements</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Mean distance from the nearest pose that was learned from</source>
        <translation>Distance moyenne à la pose apprise la plus proche</translation>
    </message>
    <message>
        <source>How fast standing feet slide</source>
        <translation>Vitesse à laquelle glissent les pieds posés</translation>
    </message>
    <message>
        <source>Pairs of triangles that go through each other, most of a frame</source>
        <translation>Paires de triangles qui se traversent, le plus dans une image</translation>
    </message>
    <message>
        <source>How far the body’s volume leaves that of the takes</source>
        <translation>De combien le volume du corps s’écarte de celui des prises</translation>
    </message>
    <message>
        <source>Rejected, too far from what was learned: %1</source>
        <translation>Rejetées, trop loin de ce qui a été appris&#xa0;: %1</translation>
    </message>
    <message>
        <source>Rejected, feet slide: %1</source>
        <translation>Rejetées, les pieds glissent&#xa0;: %1</translation>
    </message>
    <message>
        <source>Rejected, the surface goes through itself: %1</source>
        <translation>Rejetées, la surface se traverse&#xa0;: %1</translation>
    </message>
    <message>
        <source>Rejected, the body swells or shrinks: %1</source>
        <translation>Rejetées, le corps enfle ou rétrécit&#xa0;: %1</translation>
    </message>
    <message>
        <source>Too few were good enough: %1 were asked for. Take another seed, or more takes; the panel Learning says what is rejected.</source>
        <translation>Trop peu étaient assez bonnes&#xa0;: %1 étaient demandées. Prenez une autre graine, ou plus de prises&#xa0;; le panneau Apprentissage dit ce qui est rejeté.</translation>
    </message>
    <message numerus="yes">
        <source>Learning to the end, making %n clip(s)</source>
        <translation>
            <numerusform>Apprentissage jusqu’au bout, %n clip en cours</numerusform>
            <numerusform>Apprentissage jusqu’au bout, %n clips en cours</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <extracomment>two pairs of takes at the corners of a square</extracomment>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>The takes: %1</source>
        <translation>Les prises&#xa0;: %1</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>Change how far variations are apart</source>
        <translation>Changer l’écart entre les variations</translation>
    </message>
    <message>
        <source>How far variations are apart, as a share of how far the takes are; of all sets alike. Usually %1</source>
        <translation>L’écart entre les variations, en part de l’écart entre les prises&#xa0;; le même pour tous les ensembles. D’ordinaire %1</translation>
    </message>
    <message>
        <source>Rejected, a region of the body crumples: %1</source>
        <translation>Rejetées, une région du corps se chiffonne&#xa0;: %1</translation>
    </message>
    <message>
        <source>Rejected, it sinks into the ground: %1</source>
        <translation>Rejetées, elle s’enfonce dans le sol&#xa0;: %1</translation>
    </message>
    <message>
        <source>They are apart by %1, not by %2: further away the model is not sure of the poses, or the movement becomes restless.</source>
        <translation>Elles diffèrent de %1 et non de %2&#xa0;: plus loin, le modèle n’est pas sûr des poses, ou le mouvement devient agité.</translation>
    </message>
    <message>
        <source>No other take shows this movement: how far its takes are apart is a guess.</source>
        <translation>Aucune autre prise ne montre ce mouvement&#xa0;: de combien ses prises diffèrent n’est qu’une estimation.</translation>
    </message>
</context>
<context>
    <name>quadrille::SceneGhosts</name>
    <message>
        <source>Ghosts of “%1”</source>
        <translation>Fantômes de «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>quadrille::SceneView</name>
    <message>
        <source>Timeline</source>
        <translation>Frise chronologique</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Affichage</translation>
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
        <source>Name of the label</source>
        <translation>Nom de l’étiquette</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Rename label</source>
        <translation>Renommer l’étiquette</translation>
    </message>
    <message>
        <source>Edit note</source>
        <translation>Modifier la note</translation>
    </message>
    <message>
        <source>Add label here</source>
        <translation>Ajouter une étiquette ici</translation>
    </message>
    <message>
        <source>Add contact here</source>
        <translation>Ajouter un contact ici</translation>
    </message>
    <message>
        <source>Trim start to frame %1</source>
        <translation>Commencer à l’image %1</translation>
    </message>
    <message>
        <source>Trim end to frame %1</source>
        <translation>Finir à l’image %1</translation>
    </message>
    <message>
        <source>Use all frames</source>
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
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>Label the ta&amp;kes…</source>
        <translation>Éti&amp;queter les prises…</translation>
    </message>
    <message>
        <source>Give each of the selected takes a label over all of its frames</source>
        <translation>Donner à chaque prise sélectionnée une étiquette sur toutes ses images</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Réessayer</translation>
    </message>
</context>
<context>
    <name>quadrille::SettingForm</name>
    <message>
        <source>Back to the usual value</source>
        <translation>Revenir à la valeur habituelle</translation>
    </message>
</context>
<context>
    <name>quadrille::ShortcutPage</name>
    <message>
        <source>%1 belongs to “%2” already.</source>
        <translation>%1 appartient déjà à «&#xa0;%2 ».</translation>
    </message>
    <message>
        <source>Choose other keys, or give “%1” others first.</source>
        <translation>Choisissez d’autres touches, ou donnez-en d’abord d’autres à «&#xa0;%1 ».</translation>
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
    <name>quadrille::ShownTexture</name>
    <message>
        <source>Build the model to see what it makes of this texture.</source>
        <translation>Construisez le modèle pour voir ce qu’il fait de cette texture.</translation>
    </message>
    <message>
        <source>The model has not learned the texture of frame %1.</source>
        <translation>Le modèle n’a pas appris la texture de l’image %1.</translation>
    </message>
    <message>
        <source>Nothing of this texture is completed yet.</source>
        <translation>Rien de cette texture n’est encore complété.</translation>
    </message>
    <message>
        <source>Choose the two frames in the panel Between.</source>
        <translation>Choisissez les deux images dans le panneau Entre.</translation>
    </message>
    <message>
        <source>The model has not learned both frames.</source>
        <translation>Le modèle n’a pas appris les deux images.</translation>
    </message>
</context>
<context>
    <name>quadrille::SpaceGraph</name>
    <message>
        <source>Motion spaces show here. Drop the cards of some takes here to make one of them.</source>
        <translation>Les espaces de mouvement se montrent ici. Déposez-y les cartes de quelques prises pour en faire un.</translation>
    </message>
    <message>
        <source>Motion spaces</source>
        <translation>Espaces de mouvement</translation>
    </message>
    <message>
        <source>Transitions that were made</source>
        <translation>Transitions faites</translation>
    </message>
    <message>
        <source>motion space</source>
        <translation>espace de mouvement</translation>
    </message>
    <message>
        <source>Go to the last of them</source>
        <translation>Aller à la dernière d’entre elles</translation>
    </message>
</context>
<context>
    <name>quadrille::SpaceMap</name>
    <message>
        <source>%1 %2 %</source>
        <extracomment>a take and its share in a blend</extracomment>
        <translation>%1 %2 %</translation>
    </message>
</context>
<context>
    <name>quadrille::SpanForm</name>
    <message>
        <source>Show</source>
        <translation>Montrer</translation>
    </message>
    <message>
        <source>The only frames that may be played there: those with a label, or of a sequence</source>
        <translation>Les seules images qui peuvent y être jouées&#xa0;: celles d’une étiquette ou d’une séquence</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>First and last frame of the sequence that may be played</source>
        <translation>Première et dernière image de la séquence qui peuvent être jouées</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>Where the span begins, along the path</source>
        <translation>Où commence la portion, le long du trajet</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>Where the span ends, along the path</source>
        <translation>Où finit la portion, le long du trajet</translation>
    </message>
    <message>
        <source>Lasts</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>How long the span is to take; 0: as long as it takes</source>
        <translation>Combien de temps la portion doit prendre&#xa0;; 0&#xa0;: ce qu’il faut</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>How fast the body is to go there; 0: as fast as it goes</source>
        <translation>À quelle vitesse le corps doit y aller&#xa0;; 0&#xa0;: comme il va</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Move the end of a span</source>
        <translation>Déplacer l’extrémité d’une portion</translation>
    </message>
    <message>
        <source>Change how long a span takes</source>
        <translation>Changer la durée d’une portion</translation>
    </message>
    <message>
        <source>Change the speed of a span</source>
        <translation>Changer la vitesse d’une portion</translation>
    </message>
    <message>
        <source>Any frames</source>
        <translation>Toutes les images</translation>
    </message>
    <message>
        <source>Choose the frames of a span</source>
        <translation>Choisir les images d’une portion</translation>
    </message>
    <message>
        <source>%1 s, %2 m/s</source>
        <translation>%1 s, %2 m/s</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source> m/s</source>
        <translation> m/s</translation>
    </message>
    <message>
        <source>any</source>
        <translation>libre</translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation>%1 (manque)</translation>
    </message>
</context>
<context>
    <name>quadrille::StatusJobs</name>
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
        <source>Cancel “%1”</source>
        <translation>Annuler «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>quadrille::SteeringPanel</name>
    <message>
        <source>Transitions come at once, where they may be seen more; R. Else they wait for poses that are alike.</source>
        <translation>Les transitions viennent aussitôt, où elles peuvent se voir davantage ; R. Sinon elles attendent des poses semblables.</translation>
    </message>
    <message>
        <source>Gamepad: %1</source>
        <translation>Manette : %1</translation>
    </message>
    <message>
        <source>%1, soon %2</source>
        <translation>%1, bientôt %2</translation>
    </message>
    <message>
        <source>Measured: %1, %2</source>
        <translation>Mesuré : %1, %2</translation>
    </message>
    <message>
        <source>Last transition: %1 s, dissimilarity %2 of 1000</source>
        <translation>Dernière transition : %1 s, dissemblance %2 sur 1000</translation>
    </message>
    <message>
        <source>Tick %1 ms, picture %2 ms</source>
        <translation>Pas %1 ms, image %2 ms</translation>
    </message>
    <message>
        <source>1 to 9: spaces · J: jump · Space: pause</source>
        <comment>keys</comment>
        <translation>1 à 9&#xa0;: espaces · J&#xa0;: saut · Espace&#xa0;: pause</translation>
    </message>
    <message>
        <source>A D or ← →</source>
        <comment>keys</comment>
        <translation>A D ou ← →</translation>
    </message>
    <message>
        <source>W S or ↑ ↓</source>
        <comment>keys</comment>
        <translation>W S ou ↑ ↓</translation>
    </message>
    <message>
        <source>Page ↑ ↓</source>
        <comment>keys</comment>
        <translation>Page ↑ ↓</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>keys, and the parameter that they steer</extracomment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Nothing steers this motion space: it is always the same.</source>
        <translation>Rien ne dirige cet espace de mouvement&#xa0;: il est toujours le même.</translation>
    </message>
    <message>
        <source>Responsive</source>
        <translation>Réactif</translation>
    </message>
</context>
<context>
    <name>quadrille::StoryboardPanel</name>
    <message>
        <source>What happens one after the other: drag takes or labels here. The joins are found for them.</source>
        <translation>Ce qui se passe l’un après l’autre&#xa0;: glissez ici des prises ou des étiquettes. Ce qui les joint est trouvé.</translation>
    </message>
    <message>
        <source>label</source>
        <translation>étiquette</translation>
    </message>
    <message>
        <source>no such label</source>
        <translation>étiquette inconnue</translation>
    </message>
    <message>
        <source>no such take</source>
        <translation>prise inconnue</translation>
    </message>
    <message>
        <source>frames %1–%2</source>
        <translation>images %1–%2</translation>
    </message>
    <message>
        <source>all frames</source>
        <translation>toutes les images</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>× %1</source>
        <translation>× %1</translation>
    </message>
    <message>
        <source>Performed from %1 s to %2 s</source>
        <translation>Jouée de %1 s à %2 s</translation>
    </message>
    <message>
        <source>Add to the storyboard</source>
        <translation>Ajouter au scénario</translation>
    </message>
    <message>
        <source>Move in the storyboard</source>
        <translation>Déplacer dans le scénario</translation>
    </message>
    <message>
        <source>Duplicate in the storyboard</source>
        <translation>Dupliquer dans le scénario</translation>
    </message>
    <message>
        <source>Remove from the storyboard</source>
        <translation>Retirer du scénario</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Modifier</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliquer</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Go to where it is performed</source>
        <translation>Aller là où cela est joué</translation>
    </message>
    <message>
        <source>Add a label</source>
        <translation>Ajouter une étiquette</translation>
    </message>
    <message>
        <source>Add takes</source>
        <translation>Ajouter les prises</translation>
    </message>
    <message>
        <source>Those that are selected, as one action each</source>
        <translation>Celles qui sont sélectionnées, une action pour chacune</translation>
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
    <message>
        <source>unknown</source>
        <translation>inconnue</translation>
    </message>
</context>
<context>
    <name>quadrille::TakeUse</name>
    <message>
        <source>The frames that you chose</source>
        <translation>Les images que vous avez choisies</translation>
    </message>
    <message>
        <source>One cycle of the movement</source>
        <translation>Un cycle du mouvement</translation>
    </message>
    <message>
        <source>All frames</source>
        <translation>Toutes les images</translation>
    </message>
    <message>
        <source>All frames: the take is shorter than a cycle</source>
        <translation>Toutes les images&#xa0;: la prise est plus courte qu’un cycle</translation>
    </message>
    <message>
        <source>All frames: the take has no cycle like the reference’s</source>
        <translation>Toutes les images&#xa0;: la prise n’a pas de cycle comme celui de la référence</translation>
    </message>
</context>
<context>
    <name>quadrille::TextureComparison</name>
    <message>
        <source>Appearance</source>
        <translation>Apparence</translation>
    </message>
    <message>
        <source>&amp;Original</source>
        <translation>&amp;Original</translation>
    </message>
    <message>
        <source>&amp;Made by the model</source>
        <translation>&amp;Fait par le modèle</translation>
    </message>
    <message>
        <source>&amp;Difference</source>
        <translation>&amp;Différence</translation>
    </message>
    <message>
        <source>Difference, &amp;absolute</source>
        <translation>Différence &amp;absolue</translation>
    </message>
    <message>
        <source>&amp;Side by side</source>
        <translation>&amp;Côte à côte</translation>
    </message>
    <message>
        <source>S&amp;wipe</source>
        <translation>&amp;Volet</translation>
    </message>
    <message>
        <source>&amp;UV edges</source>
        <translation>Arêtes &amp;UV</translation>
    </message>
    <message>
        <source>Draw the edges of the mesh over its texture</source>
        <translation>Dessiner les arêtes du maillage sur sa texture</translation>
    </message>
    <message>
        <source>&amp;Fit the texture</source>
        <translation>A&amp;juster la texture</translation>
    </message>
    <message>
        <source>Fit the texture into its view</source>
        <translation>Ajuster la texture à sa vue</translation>
    </message>
    <message>
        <source>What is compared</source>
        <translation>Ce qui est comparé</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Between two frames</source>
        <translation>Entre deux images</translation>
    </message>
    <message>
        <source>Completed</source>
        <translation>Complétées</translation>
    </message>
    <message>
        <source>Component</source>
        <translation>Composante</translation>
    </message>
    <message>
        <source>How it is compared</source>
        <translation>Comment c’est comparé</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Texture</translation>
    </message>
    <message>
        <source>Second texture</source>
        <translation>Seconde texture</translation>
    </message>
    <message>
        <source>Components used</source>
        <translation>Composantes utilisées</translation>
    </message>
    <message>
        <source>How many of the model’s components textures are made of, from the first on</source>
        <translation>De combien de composantes du modèle les textures sont faites, à partir de la première</translation>
    </message>
    <message>
        <source>Linear blend</source>
        <translation>Mélange linéaire</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Après</translation>
    </message>
    <message>
        <source>Mean − %1 σ</source>
        <translation>Moyenne − %1 σ</translation>
    </message>
    <message>
        <source>Mean + %1 σ</source>
        <translation>Moyenne + %1 σ</translation>
    </message>
    <message>
        <source>Original</source>
        <translation>Original</translation>
    </message>
    <message>
        <source>Made by hand</source>
        <translation>Fait à la main</translation>
    </message>
    <message>
        <source>Reconstruction</source>
        <translation>Reconstruction</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Différence</translation>
    </message>
    <message>
        <source>Difference, absolute</source>
        <translation>Différence absolue</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Côte à côte</translation>
    </message>
    <message>
        <source>Swipe</source>
        <translation>Volet</translation>
    </message>
    <message>
        <source> of %1</source>
        <comment>components</comment>
        <translation> sur %1</translation>
    </message>
    <message>
        <source>Drawing UV edges</source>
        <translation>Dessin des arêtes UV</translation>
    </message>
    <message>
        <source>SSIM %1 · MSE %2 grey levels²</source>
        <translation>SSIM %1 · MSE %2 niveaux de gris²</translation>
    </message>
    <message>
        <source>Difference in grey levels, second texture less the first</source>
        <translation>Différence en niveaux de gris, seconde texture moins première</translation>
    </message>
    <message>
        <source>Levels</source>
        <comment>grey levels</comment>
        <translation>Niveaux</translation>
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
        <translation>Dessin des arêtes UV de «&#xa0;%1&#xa0;»</translation>
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
        <translation>«&#xa0;%1&#xa0;» ne peut pas être montrée.</translation>
    </message>
    <message>
        <source>Opening “%1”…</source>
        <translation>Ouverture de «&#xa0;%1 »…</translation>
    </message>
    <message>
        <source>The material “%1” has no texture.</source>
        <translation>Le matériau «&#xa0;%1&#xa0;» n’a pas de texture.</translation>
    </message>
    <message>
        <source>“%1” has no texture. Choose a picture for all frames, or a folder with one for each.</source>
        <translation>«&#xa0;%1&#xa0;» n’a pas de texture. Choisissez une image pour toutes les images de la séquence, ou un dossier avec une pour chacune.</translation>
    </message>
    <message>
        <source>“%1” has no texture, and its mesh has no texture coordinates (UVs) to put one on. Choose a character whose mesh has them in the properties.</source>
        <translation>«&#xa0;%1&#xa0;» n’a pas de texture, et son maillage n’a pas de coordonnées de texture (UV) pour en recevoir une. Choisissez dans les propriétés un personnage dont le maillage en a.</translation>
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
    <name>quadrille::TimelineActions</name>
    <message>
        <source>Play from here and &amp;return</source>
        <translation>Lire d’ici et re&amp;venir</translation>
    </message>
    <message>
        <source>Plays from the playhead, which goes back there when it stops</source>
        <translation>Lit depuis la tête de lecture, qui y revient à l’arrêt</translation>
    </message>
    <message>
        <source>Loop from &amp;here</source>
        <translation>Boucle à partir d’&amp;ici</translation>
    </message>
    <message>
        <source>Lets the part that plays again and again begin at the playhead</source>
        <translation>Fait commencer à la tête de lecture la partie lue en boucle</translation>
    </message>
    <message>
        <source>Loop &amp;up to here</source>
        <translation>Boucle &amp;jusqu’ici</translation>
    </message>
    <message>
        <source>Lets the part that plays again and again end at the playhead</source>
        <translation>Fait finir à la tête de lecture la partie lue en boucle</translation>
    </message>
    <message>
        <source>Play &amp;everything again</source>
        <translation>&amp;Tout relire</translation>
    </message>
    <message>
        <source>Takes the loop off the ruler</source>
        <translation>Retire la boucle de la règle</translation>
    </message>
    <message>
        <source>&amp;Write a note</source>
        <translation>Écrire une &amp;note</translation>
    </message>
    <message>
        <source>Writes something about the frame that is shown</source>
        <translation>Écrit quelque chose au sujet de l’image affichée</translation>
    </message>
    <message>
        <source>Previous n&amp;ote</source>
        <translation>Note &amp;précédente</translation>
    </message>
    <message>
        <source>Goes to the note before the playhead</source>
        <translation>Va à la note avant la tête de lecture</translation>
    </message>
    <message>
        <source>Next no&amp;te</source>
        <translation>Note &amp;suivante</translation>
    </message>
    <message>
        <source>Goes to the note behind the playhead</source>
        <translation>Va à la note après la tête de lecture</translation>
    </message>
    <message>
        <source>Playback</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>Back an&amp;d forth</source>
        <translation>&amp;Aller et retour</translation>
    </message>
    <message>
        <source>What loops turns round at its ends instead of starting over</source>
        <translation>La boucle rebrousse chemin à ses bouts au lieu de recommencer</translation>
    </message>
    <message>
        <source>&amp;Seconds on the ruler</source>
        <translation>Se&amp;condes sur la règle</translation>
    </message>
    <message>
        <source>Counts seconds on the ruler instead of frames</source>
        <translation>Compte des secondes sur la règle au lieu d’images</translation>
    </message>
    <message>
        <source>Loop from here</source>
        <translation>Boucle à partir d’ici</translation>
    </message>
    <message>
        <source>Loop up to here</source>
        <translation>Boucle jusqu’ici</translation>
    </message>
    <message>
        <source>Write a note here</source>
        <translation>Écrire une note ici</translation>
    </message>
    <message>
        <source>Show all frames</source>
        <translation>Montrer toutes les images</translation>
    </message>
    <message>
        <source>Unfold the row</source>
        <translation>Déplier la ligne</translation>
    </message>
    <message>
        <source>Fold the row</source>
        <translation>Replier la ligne</translation>
    </message>
</context>
<context>
    <name>quadrille::TransferBar</name>
    <message>
        <source>Transfer</source>
        <translation>Transfert</translation>
    </message>
    <message>
        <source>&amp;Duplicate the transfer</source>
        <translation>&amp;Dupliquer le transfert</translation>
    </message>
    <message>
        <source>Adds a copy, for another body or another clip</source>
        <translation>Ajoute une copie, pour un autre corps ou un autre clip</translation>
    </message>
    <message>
        <source>Transfers</source>
        <translation>Transferts</translation>
    </message>
    <message>
        <source>The transfer that is worked on</source>
        <translation>Le transfert sur lequel on travaille</translation>
    </message>
    <message>
        <source>No transfer</source>
        <translation>Aucun transfert</translation>
    </message>
    <message>
        <source>Preview; the clip is computed…</source>
        <translation>Aperçu ; le clip est en cours de calcul…</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>Calcul…</translation>
    </message>
    <message numerus="yes">
        <source>Ready: %n frame(s)</source>
        <translation>
            <numerusform>Prêt : %n image</numerusform>
            <numerusform>Prêt : %n images</numerusform>
        </translation>
    </message>
    <message>
        <source>It did not work.</source>
        <translation>Cela n’a pas marché.</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>Not computed</source>
        <translation>Pas calculé</translation>
    </message>
</context>
<context>
    <name>quadrille::TransferChart</name>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Error of paired triangles</source>
        <translation>Erreur des triangles appariés</translation>
    </message>
    <message>
        <source>Feet that slide</source>
        <translation>Pieds qui glissent</translation>
    </message>
    <message>
        <source>Of the body, against its volume at rest</source>
        <translation>Du corps, rapporté à son volume au repos</translation>
    </message>
    <message>
        <source>The mean angle by which paired triangles miss the template’s rotation</source>
        <translation>L’angle moyen dont les triangles appariés manquent la rotation du gabarit</translation>
    </message>
    <message>
        <source>How fast feet that stand until the next frame move</source>
        <translation>La vitesse des pieds posés jusqu’à l’image suivante</translation>
    </message>
    <message>
        <source>What is drawn over the frames</source>
        <translation>Ce qui est tracé au fil des images</translation>
    </message>
    <message>
        <source>How each frame came out shows here, once the clip is computed.</source>
        <translation>Ce que chaque image a donné se montre ici, une fois le clip calculé.</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>cm/s</source>
        <translation>cm/s</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>image</translation>
    </message>
    <message>
        <source>Directions of limbs</source>
        <translation>Directions des membres</translation>
    </message>
    <message>
        <source>Directions of feet</source>
        <translation>Directions des pieds</translation>
    </message>
    <message>
        <source>The mean angle by which lower arms and legs point elsewhere than the template’s</source>
        <translation>L’angle moyen dont avant-bras et jambes sont dirigés autrement que ceux du gabarit</translation>
    </message>
    <message>
        <source>The mean angle by which feet point elsewhere than the template’s</source>
        <translation>L’angle moyen dont les pieds sont dirigés autrement que ceux du gabarit</translation>
    </message>
</context>
<context>
    <name>quadrille::TransferEdits</name>
    <message>
        <source>Add transfer “%1”</source>
        <translation>Ajouter le transfert « %1 »</translation>
    </message>
    <message>
        <source>Duplicate “%1”</source>
        <translation>Dupliquer «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>quadrille::TransferFields</name>
    <message>
        <source>The most alike</source>
        <translation>La plus semblable</translation>
    </message>
    <message>
        <source>Not known</source>
        <translation>Inconnue</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Clip</translation>
    </message>
    <message>
        <source>What is performed: a take, an animation or another transfer</source>
        <translation>Ce qui est exécuté : une prise, une animation ou un autre transfert</translation>
    </message>
    <message>
        <source>Performed by</source>
        <translation>Exécuté par</translation>
    </message>
    <message>
        <source>The body that performs it: a scan or a take of another character, in its first frame</source>
        <translation>Le corps qui l’exécute : un scan ou une prise d’un autre personnage, dans sa première image</translation>
    </message>
    <message>
        <source>Reference pose</source>
        <translation>Pose de référence</translation>
    </message>
    <message>
        <source>The pose of the template that the body&apos;s is like; the nearer it is, the better the result</source>
        <translation>La pose du gabarit à laquelle ressemble celle du corps ; plus elle est proche, meilleur est le résultat</translation>
    </message>
    <message>
        <source>Rotations</source>
        <translation>Rotations</translation>
    </message>
    <message>
        <source>What of the rotations of paired triangles is spread over the body: logarithms turn evenly where a part turns far</source>
        <translation>Ce qui est réparti sur le corps des rotations des triangles appariés : les logarithmes tournent régulièrement là où une partie tourne beaucoup</translation>
    </message>
    <message>
        <source>Quaternions</source>
        <translation>Quaternions</translation>
    </message>
    <message>
        <source>Logarithms</source>
        <translation>Logarithmes</translation>
    </message>
    <message>
        <source>Scale of the way</source>
        <translation>Échelle du chemin</translation>
    </message>
    <message>
        <source>Of the way over the ground and of heights above it; by itself what the steps of the body ask for</source>
        <translation>Du chemin au sol et des hauteurs au-dessus ; d’elle-même, ce que demandent les pas du corps</translation>
    </message>
    <message>
        <source>by itself</source>
        <translation>d’elle-même</translation>
    </message>
    <message>
        <source>Correct the pose</source>
        <translation>Corriger la pose</translation>
    </message>
    <message>
        <source>Limbs that the body holds otherwise than the template does in the reference pose are brought there first: the arms of a scan in A- or T-pose</source>
        <translation>Les membres que le corps tient autrement que le gabarit dans la pose de référence y sont d’abord amenés : les bras d’un scan en pose A ou T</translation>
    </message>
    <message>
        <source>Carry stretch</source>
        <translation>Transmettre l’étirement</translation>
    </message>
    <message>
        <source>How the skin of the template stretches and is pressed together about each pair is carried as well, so that bends keep their volume; else rotations only</source>
        <translation>La façon dont la peau du gabarit s’étire et se comprime autour de chaque paire est transmise aussi, pour que les plis gardent leur volume ; sinon les rotations seules</translation>
    </message>
    <message>
        <source>Correct contacts</source>
        <translation>Corriger les contacts</translation>
    </message>
    <message>
        <source>Feet that stand in the clip stand still in the result as well</source>
        <translation>Les pieds posés dans le clip restent immobiles dans le résultat aussi</translation>
    </message>
    <message>
        <source>Truth</source>
        <translation>Vérité</translation>
    </message>
    <message>
        <source>A take of the body that shows what the result ought to be, for the evaluation of transfers; the result does not depend on it</source>
        <translation>Une prise du corps qui montre ce que le résultat devrait être, pour l’évaluation des transferts ; le résultat n’en dépend pas</translation>
    </message>
    <message>
        <source>Hold surroundings</source>
        <translation>Tenir les alentours</translation>
    </message>
    <message>
        <source>Each pair stands for what lies about it, some 8 cm on a grown-up, so that bends stay where they are however fine the body is; else for single triangles</source>
        <translation>Chaque paire vaut pour ce qui l’entoure, sur quelque 8 cm chez un adulte, si bien que les plis restent où ils sont, si fin que soit le corps ; sinon pour des triangles seuls</translation>
    </message>
</context>
<context>
    <name>quadrille::TransferPage</name>
    <message>
        <source>Whose body performs the clip; pairs are made anew with another one</source>
        <translation>Celui dont le corps exécute le clip ; avec un autre, les paires sont refaites</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Paires</translation>
    </message>
    <message>
        <source>Let another body perform “%1”</source>
        <translation>Faire exécuter « %1 » par un autre corps</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>proposées</translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s)</source>
        <translation>
            <numerusform>%n paire</numerusform>
            <numerusform>%n paires</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::TransferResults</name>
    <message>
        <source>Transfer “%1”</source>
        <translation>Transfert « %1 »</translation>
    </message>
</context>
<context>
    <name>quadrille::TransferSettingsPanel</name>
    <message>
        <source>Transfer</source>
        <translation>Transfert</translation>
    </message>
    <message>
        <source>Take the shown &amp;frame as reference pose</source>
        <translation>Prendre l’&amp;image montrée comme pose de référence</translation>
    </message>
    <message>
        <source>The pose in which the take is shown is the one that the body’s is like</source>
        <translation>La pose dans laquelle la prise est montrée est celle à laquelle ressemble celle du corps</translation>
    </message>
    <message>
        <source>Take the reference pose</source>
        <translation>Prendre la pose de référence</translation>
    </message>
    <message>
        <source>Take the shown frame</source>
        <translation>Prendre l’image montrée</translation>
    </message>
</context>
<context>
    <name>quadrille::TransferWorkspace</name>
    <message>
        <source>Template</source>
        <translation>Gabarit</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Corps</translation>
    </message>
    <message>
        <source>Transfer</source>
        <translation>Transfert</translation>
    </message>
    <message>
        <source>&amp;New transfer</source>
        <translation>&amp;Nouveau transfert</translation>
    </message>
    <message>
        <source>Lets another body perform the take that is selected</source>
        <translation>Fait exécuter par un autre corps la prise sélectionnée</translation>
    </message>
    <message>
        <source>&amp;Add as a take</source>
        <translation>&amp;Ajouter comme prise</translation>
    </message>
    <message>
        <source>Adds the transferred clip to the takes: for graphs, animations, variations</source>
        <translation>Ajoute le clip transféré aux prises : pour des graphes, animations, variations</translation>
    </message>
    <message>
        <source>E&amp;xport the clip…</source>
        <translation>E&amp;xporter le clip…</translation>
    </message>
    <message>
        <source>Writes the transferred clip into files</source>
        <translation>Écrit le clip transféré dans des fichiers</translation>
    </message>
    <message>
        <source>Show &amp;reference poses</source>
        <translation>Montrer les poses de &amp;référence</translation>
    </message>
    <message>
        <source>Shows both bodies as they stand, instead of what they perform</source>
        <translation>Montre les deux corps tels qu’ils se tiennent, au lieu de ce qu’ils exécutent</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Paires</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Import takes first, and a scan of somebody else: the scan can perform the takes.</source>
        <translation>Importez d’abord des prises et un scan de quelqu’un d’autre : le scan peut exécuter les prises.</translation>
    </message>
    <message>
        <source>Here another body performs a take: a scan of anybody, or any creature with knees and elbows.</source>
        <translation>Ici, un autre corps exécute une prise : le scan de n’importe qui, ou une créature qui a des genoux et des coudes.</translation>
    </message>
    <message>
        <source>Import a scan, then pair triangles of both bodies, or have pairs proposed.</source>
        <translation>Importez un scan, puis appariez des triangles des deux corps, ou faites proposer des paires.</translation>
    </message>
    <message>
        <source>New transfer</source>
        <translation>Nouveau transfert</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Réessayer</translation>
    </message>
    <message>
        <source>New 3D &amp;video…</source>
        <translation>Nouvelle &amp;vidéo 3D…</translation>
    </message>
    <message>
        <source>Projects pictures of calibrated cameras onto the clip: its textures then are what they saw</source>
        <translation>Projette les images de caméras calibrées sur le clip : ses textures sont alors ce qu’elles ont vu</translation>
    </message>
    <message>
        <source>Choose a table of cameras</source>
        <translation>Choisir une table de caméras</translation>
    </message>
    <message>
        <source>Cameras (*.json)</source>
        <translation>Caméras (*.json)</translation>
    </message>
</context>
<context>
    <name>quadrille::TransitionPanel</name>
    <message>
        <source>a frame is no transition to itself</source>
        <translation>une image n’est pas une transition vers elle-même</translation>
    </message>
    <message>
        <source>none: no windows fit between these frames</source>
        <translation>aucun&#xa0;: pas de fenêtres possibles entre ces images</translation>
    </message>
    <message>
        <source>%1 = %2 / %3 %4</source>
        <translation>%1 = %2 / %3 %4</translation>
    </message>
    <message>
        <source>%1 = %2 × %3</source>
        <extracomment>a weight, then α times a number of frames</extracomment>
        <translation>%1 = %2 × %3</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s), %1 s</source>
        <translation>
            <numerusform>%n image, %1 s</numerusform>
            <numerusform>%n images, %1 s</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 and %2 frames</source>
        <extracomment>frames of the source window and of the destination window</extracomment>
        <translation>%1 et %2 images</translation>
    </message>
    <message>
        <source>No way leads there.</source>
        <translation>Aucun chemin n’y mène.</translation>
    </message>
    <message>
        <source>%1–%2</source>
        <extracomment>frames of a sequence in a row: the first with the sequence, the last alone</extracomment>
        <translation>%1–%2</translation>
    </message>
    <message>
        <source>A way that costs %1: %2</source>
        <extracomment>the cost of a way and the frames that it goes through</extracomment>
        <translation>Un chemin qui coûte %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Yes: one plays on to the other as captured</source>
        <translation>Oui&#xa0;: l’une mène à l’autre comme captée</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Oui</translation>
    </message>
    <message>
        <source>No. %1</source>
        <translation>Non. %1</translation>
    </message>
    <message>
        <source>No: not a local minimum of the cost</source>
        <translation>Non&#xa0;: pas un minimum local du coût</translation>
    </message>
    <message>
        <source>Click a cell of the map to see what the transition costs and why.</source>
        <translation>Cliquez une case de la carte pour voir ce que coûte la transition et pourquoi.</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Poids</translation>
    </message>
    <message>
        <source>Deformation and duration together</source>
        <translation>Déformation et durée ensemble</translation>
    </message>
    <message>
        <source>Deformation</source>
        <translation>Déformation</translation>
    </message>
    <message>
        <source>Cost of the warp path over the largest pose distance</source>
        <translation>Coût du chemin d’alignement sur la plus grande distance de poses</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>α for each frame that the transition lasts</source>
        <translation>α pour chaque image que dure la transition</translation>
    </message>
    <message>
        <source>Lasts</source>
        <translation>Dure</translation>
    </message>
    <message>
        <source>From the last captured pose to the next</source>
        <translation>De la dernière pose captée à la suivante</translation>
    </message>
    <message>
        <source>Windows</source>
        <translation>Fenêtres</translation>
    </message>
    <message>
        <source>How many frames of both takes are blended</source>
        <translation>Combien d’images des deux prises sont fondues</translation>
    </message>
    <message>
        <source>Essential graph</source>
        <translation>Graphe essentiel</translation>
    </message>
    <message>
        <source>It holds what no cheaper way can replace</source>
        <translation>Il contient ce qu’aucun chemin moins cher ne remplace</translation>
    </message>
    <message>
        <source>Motion graph</source>
        <translation>Graphe de mouvement</translation>
    </message>
    <message>
        <source>It holds the local minima of the cost</source>
        <translation>Il contient les minima locaux du coût</translation>
    </message>
    <message>
        <source>Next best from about there</source>
        <translation>Les meilleures suivantes, de là à peu près</translation>
    </message>
    <message>
        <source>Foot slide</source>
        <translation>Glissement des pieds</translation>
    </message>
    <message>
        <source>How fast the feet that stand in both takes slide, on average</source>
        <translation>À quelle vitesse glissent, en moyenne, les pieds posés dans les deux prises</translation>
    </message>
    <message>
        <source>Speed jump</source>
        <translation>Saut de vitesse</translation>
    </message>
    <message>
        <source>How much the body’s velocity over the ground changes, from the frames before the transition to those behind it</source>
        <translation>De combien la vitesse du corps au-dessus du sol change, des images avant la transition à celles d’après</translation>
    </message>
    <message>
        <source>Best from “%1” to “%2”</source>
        <extracomment>two takes</extracomment>
        <translation>Les meilleures de «&#xa0;%1&#xa0;» à «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>%1 %2, %3 %</source>
        <extracomment>a cost, its unit, and its share</extracomment>
        <translation>%1 %2, %3&#xa0;%</translation>
    </message>
    <message>
        <source>of which poses</source>
        <translation>dont poses</translation>
    </message>
    <message>
        <source>How far the poses are from each other that are blended</source>
        <translation>De combien les poses fondues sont éloignées les unes des autres</translation>
    </message>
    <message>
        <source>of which feet</source>
        <translation>dont pieds</translation>
    </message>
    <message>
        <source>What blended frames cost in which other feet stand (Feet, under Settings)</source>
        <translation>Ce que coûtent des images fondues où d’autres pieds sont posés (Pieds, dans Réglages)</translation>
    </message>
    <message>
        <source>of which speeds</source>
        <translation>dont vitesses</translation>
    </message>
    <message>
        <source>What blended frames cost in which body and feet move otherwise (Speed, under Settings)</source>
        <translation>Ce que coûtent des images fondues où le corps et les pieds bougent autrement (Vitesse, dans Réglages)</translation>
    </message>
    <message>
        <source>%1 m/s</source>
        <extracomment>a speed</extracomment>
        <translation>%1 m/s</translation>
    </message>
</context>
<context>
    <name>quadrille::TransitionPreview</name>
    <message>
        <source>Preview of a transition</source>
        <translation>Aperçu d’une transition</translation>
    </message>
</context>
<context>
    <name>quadrille::TransitionSpeeds</name>
    <message>
        <source>Measuring a transition</source>
        <translation>Mesure d’une transition</translation>
    </message>
</context>
<context>
    <name>quadrille::VariationBar</name>
    <message>
        <source>Variations</source>
        <translation>Variations</translation>
    </message>
    <message>
        <source>The variations that are worked on</source>
        <translation>Les variations auxquelles on travaille</translation>
    </message>
    <message>
        <source>No variations</source>
        <translation>Pas de variations</translation>
    </message>
    <message>
        <source>&amp;New variations</source>
        <translation>&amp;Nouvelles variations</translation>
    </message>
    <message>
        <source>Add variations of a movement to the project</source>
        <translation>Ajouter au projet des variations d’un mouvement</translation>
    </message>
    <message>
        <source>&amp;Learn</source>
        <translation>&amp;Apprendre</translation>
    </message>
    <message>
        <source>Learns a model of each part of the body from the checked takes</source>
        <translation>Apprend des prises cochées un modèle de chaque partie du corps</translation>
    </message>
    <message>
        <source>Stop lear&amp;ning</source>
        <translation>A&amp;rrêter l’apprentissage</translation>
    </message>
    <message>
        <source>Ends learning and keeps the best so far</source>
        <translation>Arrête d’apprendre et garde le meilleur trouvé</translation>
    </message>
    <message>
        <source>&amp;Duplicate the variations</source>
        <translation>&amp;Dupliquer les variations</translation>
    </message>
    <message>
        <source>Add a copy, to learn from other takes or in another way</source>
        <translation>Ajouter une copie, pour apprendre d’autres prises ou autrement</translation>
    </message>
</context>
<context>
    <name>quadrille::VariationEdits</name>
    <message>
        <source>Add variations “%1”</source>
        <translation>Ajouter les variations «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Duplicate “%1”</source>
        <translation>Dupliquer «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>quadrille::VariationPage</name>
    <message>
        <source>Whose movement is learned; its takes are chosen anew with another one</source>
        <translation>Celui dont le mouvement est appris&#xa0;; avec un autre, ses prises sont à choisir à nouveau</translation>
    </message>
    <message>
        <source>Learned from</source>
        <translation>Appris de</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>Tirées</translation>
    </message>
    <message>
        <source>Change the character of “%1”</source>
        <translation>Changer le personnage de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>nothing yet</source>
        <translation>rien encore</translation>
    </message>
    <message numerus="yes">
        <source>%n variation(s)</source>
        <translation>
            <numerusform>%n variation</numerusform>
            <numerusform>%n variations</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::VariationResults</name>
    <message>
        <source>Aligning “%1”</source>
        <translation>Alignement de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Learning “%1”</source>
        <translation>Apprentissage de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Drawing “%1”</source>
        <translation>Tirage de «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>quadrille::VariationsWorkspace</name>
    <message>
        <source>Variation %1</source>
        <translation>Variation %1</translation>
    </message>
    <message>
        <source>Variations</source>
        <translation>Variations</translation>
    </message>
    <message>
        <source>Show the &amp;take, too</source>
        <translation>Montrer aussi la &amp;prise</translation>
    </message>
    <message>
        <source>Movement</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Body parts</source>
        <translation>Parties</translation>
    </message>
    <message>
        <source>Learning</source>
        <translation>Apprentissage</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Tirages</translation>
    </message>
    <message>
        <source>Latent space</source>
        <translation>Espace latent</translation>
    </message>
    <message>
        <source>Warps</source>
        <translation>Alignement</translation>
    </message>
    <message>
        <source>Import sequences first: variations are learned from them.</source>
        <translation>Importez d’abord des séquences&#xa0;: les variations en sont apprises.</translation>
    </message>
    <message>
        <source>Learning was stopped: these variations are drawn from the best so far.</source>
        <translation>L’apprentissage a été arrêté&#xa0;: ces variations sont tirées du meilleur trouvé.</translation>
    </message>
    <message>
        <source>What is exported or added as sequences is learned to the end first, so that the project always makes the same of it.</source>
        <translation>Ce qui est exporté ou ajouté comme séquences est d’abord appris jusqu’au bout, pour que le projet en fasse toujours la même chose.</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Réessayer</translation>
    </message>
    <message>
        <source>Learn to the end</source>
        <translation>Apprendre jusqu’au bout</translation>
    </message>
    <message>
        <source>Shows what was captured, the takes that are varied, among the variations</source>
        <translation>Montre ce qui a été capté, les prises variées, parmi les variations</translation>
    </message>
</context>
<context>
    <name>quadrille::ViewActions</name>
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
        <source>View</source>
        <translation>Affichage</translation>
    </message>
    <message>
        <source>&amp;Pose distance</source>
        <translation>Distance de &amp;pose</translation>
    </message>
    <message>
        <source>Colours two takes by how much each part of their poses differs</source>
        <translation>Colore deux prises selon ce dont chaque partie de leurs poses diffère</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Grille</translation>
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
        <source>&amp;Measure</source>
        <translation>&amp;Mesurer</translation>
    </message>
    <message>
        <source>&amp;Follow the character</source>
        <translation>S&amp;uivre le personnage</translation>
    </message>
    <message>
        <source>Fra&amp;me the selection</source>
        <translation>Cadrer la sélection</translation>
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
        <source>Sha&amp;dow</source>
        <translation>&amp;Ombre</translation>
    </message>
    <message>
        <source>&amp;Pin this frame as a ghost</source>
        <translation>É&amp;pingler cette image comme fantôme</translation>
    </message>
    <message>
        <source>Keep the pose that is shown in the view, with its frame number</source>
        <translation>Garder dans la vue la pose affichée, avec son numéro d’image</translation>
    </message>
    <message>
        <source>&amp;Remove all pinned ghosts</source>
        <translation>&amp;Retirer tous les fantômes épinglés</translation>
    </message>
</context>
<context>
    <name>quadrille::ViewMenu</name>
    <message>
        <source>Look &amp;from</source>
        <translation>Regarder &amp;depuis</translation>
    </message>
    <message>
        <source>&amp;Shading</source>
        <translation>&amp;Rendu</translation>
    </message>
    <message>
        <source>&amp;Help on the view</source>
        <translation>&amp;Aide sur la vue</translation>
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
    <name>quadrille::WarpPanel</name>
    <message>
        <source>Reference frame</source>
        <translation>Image de la référence</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>Prise</translation>
    </message>
    <message>
        <source>How the takes are warped onto the reference shows here, once some are checked in the panel Movement.</source>
        <translation>Ici se voit comment les prises suivent la référence, une fois cochées dans le panneau Mouvement.</translation>
    </message>
    <message>
        <source>Used</source>
        <translation>Utilisées</translation>
    </message>
    <message>
        <source>Mean cost</source>
        <translation>Coût moyen</translation>
    </message>
    <message>
        <source>How far apart poses are that are matched, degrees per triangle</source>
        <translation>Écart entre les poses mises en correspondance, en degrés par triangle</translation>
    </message>
    <message>
        <source>Warped takes</source>
        <translation>Prises alignées</translation>
    </message>
    <message>
        <source>%1°</source>
        <comment>an angle</comment>
        <translation>%1°</translation>
    </message>
    <message>
        <source>now</source>
        <comment>time of the frame that is shown</comment>
        <translation>maintenant</translation>
    </message>
</context>
<context>
    <name>quadrille::WelcomePage</name>
    <message>
        <source>Open a project…</source>
        <translation>Ouvrir un projet…</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>Projets récents</translation>
    </message>
    <message>
        <source>Making the character: %1 %. Click again to cancel.</source>
        <translation>Création du personnage&#xa0;: %1 %. Cliquez encore pour annuler.</translation>
    </message>
    <message>
        <source>%1 is not there any more.</source>
        <translation>%1 n’existe plus.</translation>
    </message>
    <message>
        <source>Open it from where it is now, or take it out of this list.</source>
        <translation>Ouvrez-le de là où il est maintenant, ou retirez-le de cette liste.</translation>
    </message>
    <message>
        <source>Remove from this list</source>
        <translation>Retirer de cette liste</translation>
    </message>
    <message>
        <source>New performances from captured ones. Drop files or folders anywhere in this window, or begin here.</source>
        <translation>De nouvelles performances à partir de performances captées. Déposez des fichiers ou des dossiers n’importe où dans cette fenêtre, ou commencez ici.</translation>
    </message>
    <message>
        <source>Your own</source>
        <translation>Vos prises</translation>
    </message>
    <message>
        <source>Try it with the sample character</source>
        <translation>Essayer avec le personnage d’exemple</translation>
    </message>
    <message>
        <source>Open your takes…</source>
        <translation>Ouvrir vos prises…</translation>
    </message>
    <message>
        <source>Mesh sequences as files: OBJ, PLY, PC2, MDD, GLB, FBX and more.</source>
        <translation>Séquences de maillages en fichiers&#xa0;: OBJ, PLY, PC2, MDD, GLB, FBX et d’autres.</translation>
    </message>
    <message>
        <source>Open a folder of takes…</source>
        <translation>Ouvrir un dossier de prises…</translation>
    </message>
    <message>
        <source>Everything in it, with the mesh that it shares.</source>
        <translation>Tout ce qu’il contient, avec le maillage commun.</translation>
    </message>
    <message>
        <source>What you saved before, as you left it.</source>
        <translation>Ce que vous avez enregistré, comme vous l’avez laissé.</translation>
    </message>
    <message>
        <source>Play a take</source>
        <translation>Jouer une prise</translation>
    </message>
    <message>
        <source>Look at a captured walk from all sides.</source>
        <translation>Regarder de tous côtés une marche captée.</translation>
    </message>
    <message>
        <source>See transitions</source>
        <translation>Voir les transitions</translation>
    </message>
    <message>
        <source>Where every frame goes over into every other.</source>
        <translation>Où chaque image passe à chaque autre.</translation>
    </message>
    <message>
        <source>Draw a path</source>
        <translation>Dessiner un trajet</translation>
    </message>
    <message>
        <source>A new performance that follows a line; change the line.</source>
        <translation>Une nouvelle performance qui suit une ligne&#xa0;; changez la ligne.</translation>
    </message>
</context>
<context>
    <name>quadrille::WorkspaceTabs</name>
    <message>
        <source>Workspace</source>
        <translation>Espace</translation>
    </message>
    <message>
        <source>Workspaces</source>
        <translation>Espaces de travail</translation>
    </message>
</context>
<context>
    <name>quadrille::widgets::ActionPalette</name>
    <message>
        <source>What do you want to do?</source>
        <translation>Que voulez-vous faire&#xa0;?</translation>
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
    <name>quadrille::widgets::ArcView</name>
    <message>
        <source>%1 %2</source>
        <extracomment>a sequence and one of its frames</extracomment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 → %2: %3</source>
        <extracomment>two frames and the weight of the edge between them</extracomment>
        <translation>%1 → %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>%1: %2 transitions</source>
        <extracomment>name of a graph; how many edges</extracomment>
        <translation>%1&#xa0;: %2 transitions</translation>
    </message>
    <message>
        <source>%1: %2 of %3 transitions, the cheapest</source>
        <extracomment>name of a graph; how many edges show; how many there are</extracomment>
        <translation>%1&#xa0;: %2 transitions sur %3, les moins chères</translation>
    </message>
</context>
<context>
    <name>quadrille::widgets::AxesGizmo</name>
    <message>
        <source>Axes</source>
        <translation>Axes</translation>
    </message>
    <message>
        <source>Click an axis to look from its end (keys 1, 3, 7)</source>
        <translation>Cliquez sur un axe pour regarder depuis son bout (touches 1, 3, 7)</translation>
    </message>
</context>
<context>
    <name>quadrille::widgets::BarChart</name>
    <message>
        <source>%1 (%2)</source>
        <extracomment>what a chart shows, then its unit</extracomment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>non mesuré</translation>
    </message>
    <message>
        <source>%1: %2 %3</source>
        <extracomment>a series of a chart and its value, with unit</extracomment>
        <translation>%1 : %2 %3</translation>
    </message>
    <message>
        <source>&amp;Copy values as CSV</source>
        <translation>&amp;Copier les valeurs en CSV</translation>
    </message>
</context>
<context>
    <name>quadrille::widgets::ClipLegend</name>
    <message>
        <source>Frames of the clip: %1</source>
        <translation>Images du clip&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>quadrille::widgets::CurveEditor</name>
    <message>
        <source>%1 s shows %2 s</source>
        <comment>time in the result, moment of the clip</comment>
        <translation>%1 s montre %2 s</translation>
    </message>
</context>
<context>
    <name>quadrille::widgets::LatentView</name>
    <message>
        <source>The latent view needs OpenGL 3.2.</source>
        <translation>La vue latente a besoin d’OpenGL 3.2.</translation>
    </message>
    <message>
        <source>%1, frame %2</source>
        <extracomment>a movement and one of its frames</extracomment>
        <translation>%1, image %2</translation>
    </message>
    <message>
        <source>%1; %2: %3</source>
        <extracomment>a movement with its frame; a quantity and its value</extracomment>
        <translation>%1&#xa0;; %2&#xa0;: %3</translation>
    </message>
    <message numerus="yes">
        <source>The first three of %n dimensions</source>
        <translation>
            <numerusform>La première de %n dimension</numerusform>
            <numerusform>Les trois premières de %n dimensions</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::widgets::LineChart</name>
    <message>
        <source>%1 = %2</source>
        <extracomment>an axis and a value on it</extracomment>
        <translation>%1 = %2</translation>
    </message>
    <message>
        <source>%1: %2 %3</source>
        <extracomment>a series of a chart and its value, with unit</extracomment>
        <translation>%1&#xa0;: %2 %3</translation>
    </message>
    <message>
        <source>&amp;Copy values as CSV</source>
        <translation>&amp;Copier les valeurs en CSV</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <extracomment>title of an axis, then its unit</extracomment>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>quadrille::widgets::MatrixView</name>
    <message>
        <source>%1 → %2: nothing</source>
        <extracomment>two frames, the first the source, the second the destination</extracomment>
        <translation>%1 → %2&#xa0;: rien</translation>
    </message>
    <message>
        <source>%1 → %2: %3 %4</source>
        <extracomment>two frames, a number and its unit</extracomment>
        <translation>%1 → %2&#xa0;: %3 %4</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>a sequence and one of its frames</extracomment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>No cell is chosen</source>
        <translation>Aucune case n’est choisie</translation>
    </message>
    <message>
        <source>from ↓ to →</source>
        <extracomment>rows of the matrix: where a transition comes from; columns: where it goes to</extracomment>
        <translation>de ↓ vers →</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <extracomment>title of a legend, then its unit</extracomment>
        <translation>%1 (%2)</translation>
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
    <name>quadrille::widgets::PathEditor</name>
    <message>
        <source>Click for a point, pull for its handles · Return ends · Backspace takes one back</source>
        <translation>Cliquer pour un point, tirer pour ses poignées · Entrée termine · Retour arrière en reprend un</translation>
    </message>
    <message>
        <source>Click for points, or drag a stroke · Return ends · Backspace takes one back</source>
        <translation>Cliquer pour des points, ou tracer un trait · Entrée termine · Retour arrière en reprend un</translation>
    </message>
    <message>
        <source>Drag from the middle of the obstacle · Esc gives up</source>
        <translation>Faire glisser depuis le milieu de l’obstacle · Échap abandonne</translation>
    </message>
    <message>
        <source>Click the corners of the obstacle · Return ends · Esc gives up</source>
        <translation>Cliquer les coins de l’obstacle · Entrée termine · Échap abandonne</translation>
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
    <message>
        <source>%1 / %2 s</source>
        <translation>%1 / %2 s</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
</context>
<context>
    <name>quadrille::widgets::RangeStrip</name>
    <message>
        <source>Frames used</source>
        <translation>Images utilisées</translation>
    </message>
</context>
<context>
    <name>quadrille::widgets::SoundLane</name>
    <message>
        <source>%1 (muted)</source>
        <translation>%1 (muet)</translation>
    </message>
</context>
<context>
    <name>quadrille::widgets::Storyboard</name>
    <message>
        <source>%1 of %2: %3, %4</source>
        <translation>%1 sur %2&#xa0;: %3, %4</translation>
    </message>
    <message>
        <source>Storyboard</source>
        <translation>Scénario</translation>
    </message>
</context>
<context>
    <name>quadrille::widgets::SurfaceCurveEditor</name>
    <message>
        <source>Click on the body for the first point · drag to turn · Esc leaves</source>
        <translation>Cliquer sur le corps pour le premier point · glisser pour tourner · Échap quitte</translation>
    </message>
    <message>
        <source>Click to close the curve</source>
        <translation>Cliquer pour fermer la courbe</translation>
    </message>
    <message>
        <source>Click for points around the body · Return or a click on the first point closes · Backspace takes one back</source>
        <translation>Cliquer des points autour du corps · Entrée ou un clic sur le premier ferme · Retour arrière en reprend un</translation>
    </message>
</context>
<context>
    <name>quadrille::widgets::TakeGraphView</name>
    <message numerus="yes">
        <source>%1 → %2: %n transition(s)</source>
        <extracomment>two takes; how many transitions lead from the first to the second</extracomment>
        <translation>
            <numerusform>%1 → %2&#xa0;: %n transition</numerusform>
            <numerusform>%1 → %2&#xa0;: %n transitions</numerusform>
        </translation>
    </message>
    <message>
        <source>↻ %1</source>
        <extracomment>how many transitions lead from frames of a take to others of the same take</extracomment>
        <translation>↻ %1</translation>
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
        <source>Nothing to play yet</source>
        <translation>Rien à lire pour l’instant</translation>
    </message>
    <message>
        <source>%1 at %2 s</source>
        <translation>%1 à %2 s</translation>
    </message>
    <message>
        <source>Obtained at %1 s, %2 s off</source>
        <translation>Obtenue à %1 s, écart de %2 s</translation>
    </message>
    <message>
        <source>May be off by %1 s</source>
        <translation>Écart permis&#xa0;: %1 s</translation>
    </message>
    <message>
        <source>%1
Frame %2, %3 s</source>
        <translation>%1
Image %2, %3 s</translation>
    </message>
    <message>
        <source>Drag to size the row; a double click makes it as usual</source>
        <translation>Glissez pour changer la hauteur de la ligne&#xa0;; un double clic lui rend la hauteur habituelle</translation>
    </message>
    <message>
        <source>%1: a click folds the row, another unfolds it</source>
        <translation>%1&#xa0;: un clic replie la ligne, un autre la déplie</translation>
    </message>
    <message>
        <source>Part of the frames that shows</source>
        <translation>Partie des images affichée</translation>
    </message>
    <message>
        <source>Drag the part to scroll and its ends to zoom; a double click shows all</source>
        <translation>Glissez la partie pour défiler, ses bouts pour zoomer&#xa0;; un double clic montre tout</translation>
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
<context>
    <name>quadrille::widgets::WeightsPad</name>
    <message>
        <source>%1 % to the right, %2 % upwards</source>
        <extracomment>shares of two weights, to the right and upwards, in percent</extracomment>
        <translation>%1 % vers la droite, %2 % vers le haut</translation>
    </message>
</context>
</TS>
