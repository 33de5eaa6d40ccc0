<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>quadrille::AnimationBar</name>
    <message numerus="yes">
        <source>%1 s, %n transitions</source>
        <translation>
            <numerusform>%1 s, %n transition</numerusform>
            <numerusform>%1 s, %n transitions</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::AnimationPage</name>
    <message numerus="yes">
        <source>%n path(s)</source>
        <translation>
            <numerusform>%n path</numerusform>
            <numerusform>%n paths</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n key(s)</source>
        <translation>
            <numerusform>%n key</numerusform>
            <numerusform>%n keys</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n action(s)</source>
        <translation>
            <numerusform>%n action</numerusform>
            <numerusform>%n actions</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>looped, played %n times</source>
        <translation>
            <numerusform>looped, played once</numerusform>
            <numerusform>looped, played %n times</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frames, %1 s</source>
        <translation>
            <numerusform>%n frame, %1 s</numerusform>
            <numerusform>%n frames, %1 s</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::AppearanceBar</name>
    <message numerus="yes">
        <source>%1 %n second(s) left</source>
        <translation>
            <numerusform>%1 %n second left</numerusform>
            <numerusform>%1 %n seconds left</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 %n minute(s) left</source>
        <translation>
            <numerusform>%1 %n minute left</numerusform>
            <numerusform>%1 %n minutes left</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Ready: %n texture(s) learned</source>
        <translation>
            <numerusform>Ready: %n texture learned</numerusform>
            <numerusform>Ready: %n textures learned</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1; they have no more than %n component(s)</source>
        <translation>
            <numerusform>%1; they have no more than %n component</numerusform>
            <numerusform>%1; they have no more than %n components</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::AppearancePage</name>
    <message numerus="yes">
        <source>%n texture(s)</source>
        <translation>
            <numerusform>%n texture</numerusform>
            <numerusform>%n textures</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::BrokenEdits</name>
    <message numerus="yes">
        <source>Remove %n unreadable parts</source>
        <translation>
            <numerusform>Remove %n unreadable part</numerusform>
            <numerusform>Remove %n unreadable parts</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::CharacterPage</name>
    <message numerus="yes">
        <source>%n sequences</source>
        <translation>
            <numerusform>%n sequence</numerusform>
            <numerusform>%n sequences</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n vertices</source>
        <translation>
            <numerusform>%n vertex</numerusform>
            <numerusform>%n vertices</numerusform>
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
            <numerusform>%n component</numerusform>
            <numerusform>%n components</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n boundary loops</source>
        <translation>
            <numerusform>%n boundary loop</numerusform>
            <numerusform>%n boundary loops</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n non-manifold edges</source>
        <translation>
            <numerusform>%n non-manifold edge</numerusform>
            <numerusform>%n non-manifold edges</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::DefaultSettings</name>
    <message numerus="yes">
        <source>The last %n start(s) of Quadrille failed. Start with default settings?</source>
        <translation>
            <numerusform>The last start of Quadrille failed. Start with default settings?</numerusform>
            <numerusform>The last %n starts of Quadrille failed. Start with default settings?</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::ExportDialog</name>
    <message numerus="yes">
        <source>%1, and %n more</source>
        <translation>
            <numerusform>%1, and %n more</numerusform>
            <numerusform>%1, and %n more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 · %n frame(s), %2 s</source>
        <comment>files · frames, seconds</comment>
        <translation>
            <numerusform>%1 · %n frame, %2 s</numerusform>
            <numerusform>%1 · %n frames, %2 s</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>“%1” and %n more are there already.</source>
        <translation>
            <numerusform>“%1” and %n more are there already.</numerusform>
            <numerusform>“%1” and %n more are there already.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) written, “%1” the first.</source>
        <translation>
            <numerusform>%n file written, “%1” the first.</numerusform>
            <numerusform>%n files written, “%1” the first.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::GapsPanel</name>
    <message numerus="yes">
        <source>Starts and ends of takes: %n</source>
        <translation>
            <numerusform>Starts and ends of take: %n</numerusform>
            <numerusform>Starts and ends of takes: %n</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::GraphBar</name>
    <message numerus="yes">
        <source>± %1; %n pair(s) of frames without a way</source>
        <translation>
            <numerusform>± %1; %n pair of frames without a way</numerusform>
            <numerusform>± %1; %n pairs of frames without a way</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::GraphWorkspace</name>
    <message numerus="yes">
        <source>%n table(s) were saved in %1.</source>
        <translation>
            <numerusform>%n table were saved in %1.</numerusform>
            <numerusform>%n tables were saved in %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::ImportDialog</name>
    <message numerus="yes">
        <source>Looking at %n source(s)</source>
        <translation>
            <numerusform>Looking at %n source</numerusform>
            <numerusform>Looking at %n sources</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Import %n take(s)</source>
        <translation>
            <numerusform>Import %n take</numerusform>
            <numerusform>Import %n takes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The rate of %n take(s) is not known.</source>
        <translation>
            <numerusform>The rate of %n take is not known.</numerusform>
            <numerusform>The rate of %n takes is not known.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Import %n take(s) at %1 fps</source>
        <translation>
            <numerusform>Import %n take at %1 fps</numerusform>
            <numerusform>Import %n takes at %1 fps</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::ImportFlow</name>
    <message numerus="yes">
        <source>Opening %n file(s)</source>
        <translation>
            <numerusform>Opening %n file</numerusform>
            <numerusform>Opening %n files</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::IssuesPanel</name>
    <message numerus="yes">
        <source>%n error(s)</source>
        <translation>
            <numerusform>%n error</numerusform>
            <numerusform>%n errors</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s)</source>
        <translation>
            <numerusform>%n warning</numerusform>
            <numerusform>%n warnings</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::JobListModel</name>
    <message numerus="yes">
        <source>%n s left</source>
        <translation>
            <numerusform>%n s left</numerusform>
            <numerusform>%n s left</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n min left</source>
        <translation>
            <numerusform>%n min left</numerusform>
            <numerusform>%n min left</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n h left</source>
        <translation>
            <numerusform>%n h left</numerusform>
            <numerusform>%n h left</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::JunctionPanel</name>
    <message numerus="yes">
        <source>%n frame(s)</source>
        <comment>length of a transition</comment>
        <translation>
            <numerusform>%n frame</numerusform>
            <numerusform>%n frames</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::KeysAndStoryboard</name>
    <message numerus="yes">
        <source>%n takes added to the storyboard of “%1”</source>
        <translation>
            <numerusform>%n take added to the storyboard of “%1”</numerusform>
            <numerusform>%n takes added to the storyboard of “%1”</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::LabelTakes</name>
    <message numerus="yes">
        <source>Label %n take(s)</source>
        <translation>
            <numerusform>Label %n take</numerusform>
            <numerusform>Label %n takes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::LearningPanel</name>
    <message numerus="yes">
        <source>%n iterations, %1</source>
        <translation>
            <numerusform>%n iteration, %1</numerusform>
            <numerusform>%n iterations, %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::LivePage</name>
    <message numerus="yes">
        <source>%1 s, steered %n time(s)</source>
        <translation>
            <numerusform>%1 s, steered %n time</numerusform>
            <numerusform>%1 s, steered %n times</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::LostMediaTable</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 and %n more</numerusform>
            <numerusform>%1 and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::MainWindow</name>
    <message numerus="yes">
        <source>%n file(s) were relinked</source>
        <translation>
            <numerusform>%n file was relinked</numerusform>
            <numerusform>%n files were relinked</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::MarkEdits</name>
    <message numerus="yes">
        <source>Label %n sequences</source>
        <translation>
            <numerusform>Label %n sequence</numerusform>
            <numerusform>Label %n sequences</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::MotionSpacePage</name>
    <message numerus="yes">
        <source>%n frame(s)</source>
        <translation>
            <numerusform>%n frame</numerusform>
            <numerusform>%n frames</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n reference(s)</source>
        <translation>
            <numerusform>%n reference</numerusform>
            <numerusform>%n references</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::MovementPanel</name>
    <message numerus="yes">
        <source>Learn from %n takes</source>
        <translation>
            <numerusform>Learn from %n take</numerusform>
            <numerusform>Learn from %n takes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::PairTool</name>
    <message numerus="yes">
        <source>%n pair(s) were added.</source>
        <translation>
            <numerusform>%n pair was added.</numerusform>
            <numerusform>%n pairs were added.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::PairsPanel</name>
    <message numerus="yes">
        <source>%n pair(s) were proposed. What you change makes them the project’s.</source>
        <translation>
            <numerusform>%n pair was proposed. What you change makes it the project’s.</numerusform>
            <numerusform>%n pairs were proposed. What you change makes them the project’s.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s): from about 15 on all parts turn as they should.</source>
        <translation>
            <numerusform>%n pair: from about 15 on all parts turn as they should.</numerusform>
            <numerusform>%n pairs: from about 15 on all parts turn as they should.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::PathPanel</name>
    <message numerus="yes">
        <source>%1 · polygon, %n corner(s)</source>
        <translation>
            <numerusform>%1 · polygon, %n corner</numerusform>
            <numerusform>%1 · polygon, %n corners</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::ProjectEdits</name>
    <message numerus="yes">
        <source>Remove %n characters</source>
        <translation>
            <numerusform>Remove %n character</numerusform>
            <numerusform>Remove %n characters</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove %n exports</source>
        <translation>
            <numerusform>Remove %n export</numerusform>
            <numerusform>Remove %n exports</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove %n sequences</source>
        <translation>
            <numerusform>Remove %n sequence</numerusform>
            <numerusform>Remove %n sequences</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Add %n sequences</source>
        <translation>
            <numerusform>Add %n sequence</numerusform>
            <numerusform>Add %n sequences</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove %n animations</source>
        <translation>
            <numerusform>Remove %n animation</numerusform>
            <numerusform>Remove %n animations</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove %n variations</source>
        <translation>
            <numerusform>Remove %n variation</numerusform>
            <numerusform>Remove %n variations</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove %n evaluations</source>
        <translation>
            <numerusform>Remove %n evaluation</numerusform>
            <numerusform>Remove %n evaluations</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove %n models of appearance</source>
        <translation>
            <numerusform>Remove %n model of appearance</numerusform>
            <numerusform>Remove %n models of appearance</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove %n transfers</source>
        <translation>
            <numerusform>Remove %n transfer</numerusform>
            <numerusform>Remove %n transfers</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove %n projections</source>
        <translation>
            <numerusform>Remove %n projection</numerusform>
            <numerusform>Remove %n projections</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove %n motion spaces</source>
        <translation>
            <numerusform>Remove %n motion space</numerusform>
            <numerusform>Remove %n motion spaces</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove %n live performances</source>
        <translation>
            <numerusform>Remove %n live performance</numerusform>
            <numerusform>Remove %n live performances</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::ProjectPage</name>
    <message numerus="yes">
        <source>%n characters</source>
        <translation>
            <numerusform>%n character</numerusform>
            <numerusform>%n characters</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sequences</source>
        <translation>
            <numerusform>%n sequence</numerusform>
            <numerusform>%n sequences</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n exports</source>
        <translation>
            <numerusform>%n export</numerusform>
            <numerusform>%n exports</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::ProjectStrips</name>
    <message numerus="yes">
        <source>%n part(s) of the project cannot be read. They stay in its file as they are.</source>
        <translation>
            <numerusform>%n part of the project cannot be read. It stays in its file as it is.</numerusform>
            <numerusform>%n parts of the project cannot be read. They stay in its file as they are.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) of the project changed on disk.</source>
        <translation>
            <numerusform>%n file of the project changed on disk.</numerusform>
            <numerusform>%n files of the project changed on disk.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::PropertiesPanel</name>
    <message numerus="yes">
        <source>%n sequences</source>
        <translation>
            <numerusform>%n sequence</numerusform>
            <numerusform>%n sequences</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frames, %1 s</source>
        <translation>
            <numerusform>%n frame, %1 s</numerusform>
            <numerusform>%n frames, %1 s</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::RecoveryNotice</name>
    <message numerus="yes">
        <source>Unsaved work: “%1”, %2, %n entries</source>
        <translation>
            <numerusform>Unsaved work: “%1”, %2, %n entry</numerusform>
            <numerusform>Unsaved work: “%1”, %2, %n entries</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::RelinkDialog</name>
    <message numerus="yes">
        <source>%n more were found from there.</source>
        <translation>
            <numerusform>%n more was found from there.</numerusform>
            <numerusform>%n more were found from there.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) are not where the project says. Search the folder where they are now.</source>
        <translation>
            <numerusform>%n file is not where the project says. Search the folder where it is now.</numerusform>
            <numerusform>%n files are not where the project says. Search the folder where they are now.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n missing file(s) were found. The project changes only when you apply this.</source>
        <translation>
            <numerusform>%1 of %n missing file was found. The project changes only when you apply this.</numerusform>
            <numerusform>%1 of %n missing files were found. The project changes only when you apply this.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Relink %n file(s)</source>
        <translation>
            <numerusform>Relink %n file</numerusform>
            <numerusform>Relink %n files</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::RelinkFlow</name>
    <message numerus="yes">
        <source>%n file(s) of the project are missing. They may have been moved or renamed.</source>
        <translation>
            <numerusform>%n file of the project is missing. It may have been moved or renamed.</numerusform>
            <numerusform>%n files of the project are missing. They may have been moved or renamed.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::ResultsFlow</name>
    <message numerus="yes">
        <source>%n result(s) cannot be stored anywhere and are in memory only.</source>
        <translation>
            <numerusform>%n result cannot be stored anywhere and is in memory only.</numerusform>
            <numerusform>%n results cannot be stored anywhere and are in memory only.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::SamplesPanel</name>
    <message numerus="yes">
        <source>%n drawn, %1 rejected, %2 thrown away</source>
        <translation>
            <numerusform>%n drawn, %1 rejected, %2 thrown away</numerusform>
            <numerusform>%n drawn, %1 rejected, %2 thrown away</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Throw %n variation(s) away</source>
        <translation>
            <numerusform>Throw %n variation away</numerusform>
            <numerusform>Throw %n variations away</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Keep %n variation(s)</source>
        <translation>
            <numerusform>Keep %n variation</numerusform>
            <numerusform>Keep %n variations</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Making %n clip(s)</source>
        <translation>
            <numerusform>Making %n clip</numerusform>
            <numerusform>Making %n clips</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Learning to the end, making %n clip(s)</source>
        <translation>
            <numerusform>Learning to the end, making %n clip</numerusform>
            <numerusform>Learning to the end, making %n clips</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::SequenceCards</name>
    <message numerus="yes">
        <source>%1 s · %2 fps
%n frames</source>
        <translation>
            <numerusform>%1 s · %2 fps
%n frame</numerusform>
            <numerusform>%1 s · %2 fps
%n frames</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::SequencePage</name>
    <message numerus="yes">
        <source>%n labels</source>
        <translation>
            <numerusform>%n label</numerusform>
            <numerusform>%n labels</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n contacts</source>
        <translation>
            <numerusform>%n contact</numerusform>
            <numerusform>%n contacts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frames, %1 s</source>
        <translation>
            <numerusform>%n frame, %1 s</numerusform>
            <numerusform>%n frames, %1 s</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::StatusJobs</name>
    <message numerus="yes">
        <source>%1, and %n more</source>
        <translation>
            <numerusform>%1, and %n more</numerusform>
            <numerusform>%1, and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::TakeTable</name>
    <message numerus="yes">
        <source>%n, one per frame</source>
        <translation>
            <numerusform>%n, one per frame</numerusform>
            <numerusform>%n, one per frame</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n, by material</source>
        <translation>
            <numerusform>%n, by material</numerusform>
            <numerusform>%n, by material</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n vertices</source>
        <translation>
            <numerusform>%n vertex</numerusform>
            <numerusform>%n vertices</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::TextureField</name>
    <message numerus="yes">
        <source>%n, by material</source>
        <translation>
            <numerusform>%n, by material</numerusform>
            <numerusform>%n, by material</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::TransferBar</name>
    <message numerus="yes">
        <source>Ready: %n frame(s)</source>
        <translation>
            <numerusform>Ready: %n frame</numerusform>
            <numerusform>Ready: %n frames</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::TransferPage</name>
    <message numerus="yes">
        <source>%n pair(s)</source>
        <translation>
            <numerusform>%n pair</numerusform>
            <numerusform>%n pairs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::TransitionPanel</name>
    <message numerus="yes">
        <source>%n frame(s), %1 s</source>
        <translation>
            <numerusform>%n frame, %1 s</numerusform>
            <numerusform>%n frames, %1 s</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::VariationPage</name>
    <message numerus="yes">
        <source>%n variation(s)</source>
        <translation>
            <numerusform>%n variation</numerusform>
            <numerusform>%n variations</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::widgets::LatentView</name>
    <message numerus="yes">
        <source>The first three of %n dimensions</source>
        <translation>
            <numerusform>The first three of %n dimensions</numerusform>
            <numerusform>The first three of %n dimensions</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>quadrille::widgets::TakeGraphView</name>
    <message numerus="yes">
        <source>%1 → %2: %n transition(s)</source>
        <extracomment>two takes; how many transitions lead from the first to the second</extracomment>
        <translation>
            <numerusform>%1 → %2: %n transition</numerusform>
            <numerusform>%1 → %2: %n transitions</numerusform>
        </translation>
    </message>
</context>
</TS>
