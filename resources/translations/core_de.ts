<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>integrators</name>
    <message>
        <source>Newton with conjugate gradients</source>
        <translation>Newton mit konjugierten Gradienten</translation>
    </message>
    <message>
        <source>Finds the rest shape in few large steps; the quickest way.</source>
        <translation>Findet die Ruheform in wenigen großen Schritten; der schnellste Weg.</translation>
    </message>
    <message>
        <source>Implicit steps</source>
        <translation>Implizite Schritte</translation>
    </message>
    <message>
        <source>Damped steps that grow as rest comes nearer; sure from any start.</source>
        <translation>Gedämpfte Schritte, die wachsen, je näher die Ruhe kommt; sicher von jedem Anfang.</translation>
    </message>
    <message>
        <source>FIRE</source>
        <translation>FIRE</translation>
    </message>
    <message>
        <source>Lets the fabric slide to rest like a damped body; smooth to watch.</source>
        <translation>Lässt das Gestrick wie einen gedämpften Körper zur Ruhe gleiten; schön anzusehen.</translation>
    </message>
    <message>
        <source>L-BFGS</source>
        <translation>L-BFGS</translation>
    </message>
    <message>
        <source>Descends with a memory of its last steps; needs forces only.</source>
        <translation>Steigt mit einem Gedächtnis der letzten Schritte ab; braucht nur Kräfte.</translation>
    </message>
    <message>
        <source>KINSOL Newton-PCG</source>
        <translation>KINSOL Newton-PCG</translation>
    </message>
    <message>
        <source>Newton by SUNDIALS, with its own line search on the force.</source>
        <translation>Newton von SUNDIALS, mit eigener Liniensuche auf der Kraft.</translation>
    </message>
    <message>
        <source>Cash-Karp 5(4)</source>
        <translation>Cash-Karp 5(4)</translation>
    </message>
    <message>
        <source>The paper&apos;s method: true motion in time, with damping. Slow.</source>
        <translation>Das Verfahren des Aufsatzes: wahre Bewegung in der Zeit, mit Dämpfung. Langsam.</translation>
    </message>
    <message>
        <source>Dormand-Prince 5(4)</source>
        <translation>Dormand-Prince 5(4)</translation>
    </message>
    <message>
        <source>True motion in time, with damping. Slow.</source>
        <translation>Wahre Bewegung in der Zeit, mit Dämpfung. Langsam.</translation>
    </message>
    <message>
        <source>CVODE Adams</source>
        <translation>CVODE Adams</translation>
    </message>
    <message>
        <source>True motion in time by a multistep method. Slow.</source>
        <translation>Wahre Bewegung in der Zeit mit einem Mehrschrittverfahren. Langsam.</translation>
    </message>
    <message>
        <source>CVODE BDF</source>
        <translation>CVODE BDF</translation>
    </message>
    <message>
        <source>True motion in time by an implicit method: long steps where all is calm.</source>
        <translation>Wahre Bewegung in der Zeit mit einem impliziten Verfahren: lange Schritte, wo alles ruhig ist.</translation>
    </message>
</context>
<context>
    <name>samples</name>
    <message>
        <source>Plain</source>
        <translation>Rechts/links</translation>
    </message>
    <message>
        <source>All stitches on the front bed: the edges curl.</source>
        <translation>Alle Maschen auf dem vorderen Bett: die Kanten rollen sich.</translation>
    </message>
    <message>
        <source>Reverse plain</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>All stitches on the rear bed: the technical back of plain.</source>
        <translation>Alle Maschen auf dem hinteren Bett: die linke Warenseite von Rechts/links.</translation>
    </message>
    <message>
        <source>Rib 1x1</source>
        <translation>Rippe 1x1</translation>
    </message>
    <message>
        <source>Front and rear wales alternate: narrow, thick and very stretchy.</source>
        <translation>Vordere und hintere Stäbchen im Wechsel: schmal, dick und sehr dehnbar.</translation>
    </message>
    <message>
        <source>Rib 2x2</source>
        <translation>Rippe 2x2</translation>
    </message>
    <message>
        <source>Two front wales, two rear wales.</source>
        <translation>Zwei Stäbchen vorn, zwei hinten.</translation>
    </message>
    <message>
        <source>Garter</source>
        <translation>Links/links</translation>
    </message>
    <message>
        <source>Courses alternate between the beds; all loops change beds before each course.</source>
        <translation>Reihen wechseln zwischen den Betten; vor jeder Reihe werden alle Schleifen umgehängt.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Perlmuster</translation>
    </message>
    <message>
        <source>Knit and purl like a chess board of single stitches.</source>
        <translation>Rechte und linke Maschen wie ein Schachbrett aus einzelnen Maschen.</translation>
    </message>
    <message>
        <source>Moss</source>
        <translation>Großes Perlmuster</translation>
    </message>
    <message>
        <source>Knit and purl like a chess board, two courses high.</source>
        <translation>Rechte und linke Maschen wie ein Schachbrett, zwei Reihen hoch.</translation>
    </message>
    <message>
        <source>Cable 2x2, left</source>
        <translation>Zopf 2x2, links</translation>
    </message>
    <message>
        <source>Two loops pass in front of two others to the left.</source>
        <translation>Zwei Schleifen gehen vor zwei anderen nach links.</translation>
    </message>
    <message>
        <source>Cable 2x2, right</source>
        <translation>Zopf 2x2, rechts</translation>
    </message>
    <message>
        <source>Two loops pass in front of two others to the right.</source>
        <translation>Zwei Schleifen gehen vor zwei anderen nach rechts.</translation>
    </message>
    <message>
        <source>Braid</source>
        <translation>Flechtzopf</translation>
    </message>
    <message>
        <source>Three strands of two wales, crossed right and left in turn.</source>
        <translation>Drei Stränge aus zwei Stäbchen, abwechselnd rechts und links gekreuzt.</translation>
    </message>
    <message>
        <source>Lace</source>
        <translation>Lochmuster</translation>
    </message>
    <message>
        <source>Loops stacked on their neighbours leave eyelets in lines that meet.</source>
        <translation>Auf Nachbarn gehängte Schleifen lassen Löcher, deren Linien sich treffen.</translation>
    </message>
    <message>
        <source>Ladders</source>
        <translation>Leitern</translation>
    </message>
    <message>
        <source>Needles out of work leave rungs of bare yarn between the stitches.</source>
        <translation>Nadeln außer Arbeit lassen Sprossen aus bloßem Faden zwischen den Maschen.</translation>
    </message>
    <message>
        <source>Tuck</source>
        <translation>Fang</translation>
    </message>
    <message>
        <source>Held loops take two tucks each and push the courses apart.</source>
        <translation>Gehaltene Schleifen nehmen je zwei Henkel auf und schieben die Reihen auseinander.</translation>
    </message>
    <message>
        <source>Slip stitch</source>
        <translation>Hebemaschen</translation>
    </message>
    <message>
        <source>The yarn misses held loops, which draw two colours over each other.</source>
        <translation>Der Faden lässt gehaltene Schleifen aus; sie ziehen zwei Farben übereinander.</translation>
    </message>
    <message>
        <source>Float jacquard</source>
        <translation>Jacquard mit Flottungen</translation>
    </message>
    <message>
        <source>Two colours in every course, each floating behind the other.</source>
        <translation>Zwei Farben in jeder Reihe, jede flottet hinter der anderen.</translation>
    </message>
    <message>
        <source>Intarsia</source>
        <translation>Intarsie</translation>
    </message>
    <message>
        <source>Three yarns, each in its own zone, joined by tucks.</source>
        <translation>Drei Garne, jedes in seinem Feld, durch Fang verbunden.</translation>
    </message>
    <message>
        <source>Tube</source>
        <translation>Schlauch</translation>
    </message>
    <message>
        <source>The front bed one way, the rear bed back: a seamless tube.</source>
        <translation>Das vordere Bett hin, das hintere zurück: ein Schlauch ohne Naht.</translation>
    </message>
    <message>
        <source>Short rows</source>
        <translation>Spickel</translation>
    </message>
    <message>
        <source>The carrier turns earlier each time: wedges that bend the fabric.</source>
        <translation>Der Fadenführer kehrt jedes Mal früher um: Keile, die das Gestrick biegen.</translation>
    </message>
    <message>
        <source>Racked rib</source>
        <translation>Versatzrippe</translation>
    </message>
    <message>
        <source>All needles of both beds, the rear bed shifted from course to course.</source>
        <translation>Alle Nadeln beider Betten, das hintere von Reihe zu Reihe versetzt.</translation>
    </message>
    <message>
        <source>Transfers</source>
        <translation>Umhängen</translation>
    </message>
    <message>
        <source>Two strands wander over a purl ground, then both edges are narrowed.</source>
        <translation>Zwei Stränge wandern über einen linken Grund, dann werden beide Kanten gemindert.</translation>
    </message>
</context>
<context>
    <name>surroundings</name>
    <message>
        <source>Pressed flat</source>
        <translation>Flach gepresst</translation>
    </message>
    <message>
        <source>Between two soft plates, as swatches are measured; edges cannot curl</source>
        <translation>Zwischen zwei weichen Platten, wie Muster gemessen werden; Kanten können sich nicht rollen</translation>
    </message>
    <message>
        <source>On a table</source>
        <translation>Auf einem Tisch</translation>
    </message>
    <message>
        <source>Its weight on a plane; edges may curl</source>
        <translation>Sein Gewicht auf einer Ebene; Kanten dürfen sich rollen</translation>
    </message>
    <message>
        <source>Hanging</source>
        <translation>Hängend</translation>
    </message>
    <message>
        <source>Its weight pulls at the last course, which is held</source>
        <translation>Sein Gewicht zieht an der letzten Reihe, die gehalten wird</translation>
    </message>
    <message>
        <source>Pinned at the edges</source>
        <translation>An den Rändern gesteckt</translation>
    </message>
    <message>
        <source>The loops at its edges stay where they are</source>
        <translation>Die Schleifen an seinen Rändern bleiben, wo sie sind</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Nothing holds it and it is shaken: no friction, edges curl</source>
        <translation>Nichts hält es und es wird geschüttelt: keine Reibung, Kanten rollen sich</translation>
    </message>
</context>
</TS>
