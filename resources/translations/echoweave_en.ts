<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US" sourcelanguage="en">
<context>
    <name>ew::stitching::AlignmentEdits</name>
    <message numerus="yes">
        <source>Three places that do not lie on one line are needed; mark %n more in both volumes.</source>
        <translation>
            <numerusform>Three places that do not lie on one line are needed; mark %n more in both volumes.</numerusform>
            <numerusform>Three places that do not lie on one line are needed; mark %n more in both volumes.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::stitching::Mosaic</name>
    <message numerus="yes">
        <source>%n targets</source>
        <translation>
            <numerusform>%n target</numerusform>
            <numerusform>%n targets</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n measurements</source>
        <translation>
            <numerusform>%n measurement</numerusform>
            <numerusform>%n measurements</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::stitching::PairInspector</name>
    <message numerus="yes">
        <source>Times are as %n pairs took here.</source>
        <translation>
            <numerusform>Times are as %n pair took here.</numerusform>
            <numerusform>Times are as %n pairs took here.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::stitching::ProjectDocument</name>
    <message numerus="yes">
        <source>%n files lie in other folders and are named by their whole path: to take the project to another machine, put them beside it first.</source>
        <translation>
            <numerusform>%n file lies in another folder and is named by its whole path: to take the project to another machine, put it beside it first.</numerusform>
            <numerusform>%n files lie in other folders and are named by their whole path: to take the project to another machine, put them beside it first.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::stitching::ProjectInputs</name>
    <message numerus="yes">
        <source>Reading %n volumes</source>
        <translation>
            <numerusform>Reading %n volume</numerusform>
            <numerusform>Reading %n volumes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>add %n volumes</source>
        <translation>
            <numerusform>add %n volume</numerusform>
            <numerusform>add %n volumes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more could not be read either.</source>
        <translation>
            <numerusform>%n more could not be read either.</numerusform>
            <numerusform>%n more could not be read either.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::stitching::StitchPanel</name>
    <message numerus="yes">
        <source>A project of %n volumes was not saved when the program ended.</source>
        <translation>
            <numerusform>A project of %n volume was not saved when the program ended.</numerusform>
            <numerusform>A project of %n volumes was not saved when the program ended.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more is offered after it.</source>
        <translation>
            <numerusform>%n more is offered after it.</numerusform>
            <numerusform>%n more are offered after it.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::ui::CaseInfo</name>
    <message numerus="yes">
        <source>%n more with the findings</source>
        <translation>
            <numerusform>%n more with the findings</numerusform>
            <numerusform>%n more with the findings</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::ui::CasePreparation</name>
    <message numerus="yes">
        <source>about %n minutes</source>
        <translation>
            <numerusform>about %n minute</numerusform>
            <numerusform>about %n minutes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::ui::CostPanel</name>
    <message numerus="yes">
        <source>%n planes</source>
        <translation>
            <numerusform>%n plane</numerusform>
            <numerusform>%n planes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Error of whole frames against those with 9 planes, %n poses around the present one.</source>
        <translation>
            <numerusform>Error of whole frames against those with 9 planes, %n pose around the present one.</numerusform>
            <numerusform>Error of whole frames against those with 9 planes, %n poses around the present one.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::ui::FileImportDialog</name>
    <message numerus="yes">
        <source>%1 was imported; %n notes say what was decided and left out.</source>
        <translation>
            <numerusform>%1 was imported; %n note says what was decided and left out.</numerusform>
            <numerusform>%1 was imported; %n notes say what was decided and left out.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::ui::JobsLine</name>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>%n more</numerusform>
            <numerusform>%n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::ui::Recording</name>
    <message numerus="yes">
        <source>%1 is open; %n notes say how it was read.</source>
        <translation>
            <numerusform>%1 is open; %n note says how it was read.</numerusform>
            <numerusform>%1 is open; %n notes say how it was read.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::ui::MessageBar</name>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>%n more</numerusform>
            <numerusform>%n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::ui::Opener</name>
    <message numerus="yes">
        <source>The mannequin was read; %n notes say how.</source>
        <translation>
            <numerusform>The mannequin was read; %n note says how.</numerusform>
            <numerusform>The mannequin was read; %n notes say how.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 is open; %n notes say how it was read.</source>
        <translation>
            <numerusform>%1 is open; %n note says how it was read.</numerusform>
            <numerusform>%1 is open; %n notes say how it was read.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::ui::SourceDialog</name>
    <message numerus="yes">
        <source>%1, %n after the source</source>
        <translation>
            <numerusform>%1, %n after the source</numerusform>
            <numerusform>%1, %n after the source</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1, %n before the source</source>
        <translation>
            <numerusform>%1, %n before the source</numerusform>
            <numerusform>%1, %n before the source</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::ui::StatusLine</name>
    <message numerus="yes">
        <source>plan: %n steps, %1 ms</source>
        <translation>
            <numerusform>plan: %n step, %1 ms</numerusform>
            <numerusform>plan: %n steps, %1 ms</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::ui::TrackerFigures</name>
    <message numerus="yes">
        <source>Not used: %n of what it sent. The last one: %1</source>
        <translation>
            <numerusform>Not used: %n of what it sent. The last one: %1</numerusform>
            <numerusform>Not used: %n of what it sent. The last one: %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ew::ui::TrackerLensStep</name>
    <message numerus="yes">
        <source>Measuring the lens from %n images…</source>
        <translation>
            <numerusform>Measuring the lens from %n image…</numerusform>
            <numerusform>Measuring the lens from %n images…</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The lens is measured: its images agree within %1 pixels, found from %n images.</source>
        <translation>
            <numerusform>The lens is measured: its images agree within %1 pixels, found from %n image.</numerusform>
            <numerusform>The lens is measured: its images agree within %1 pixels, found from %n images.</numerusform>
        </translation>
    </message>
</context>
</TS>
