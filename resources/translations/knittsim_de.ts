<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>beds</name>
    <message>
        <source>front bed</source>
        <translation>vorderes Bett</translation>
    </message>
    <message>
        <source>rear bed</source>
        <translation>hinteres Bett</translation>
    </message>
</context>
<context>
    <name>knittsim::document</name>
    <message>
        <source>Left foot</source>
        <translation>Linker Fuß</translation>
    </message>
    <message>
        <source>Right foot</source>
        <translation>Rechter Fuß</translation>
    </message>
    <message>
        <source>Left head</source>
        <translation>Linker Kopf</translation>
    </message>
    <message>
        <source>Right head</source>
        <translation>Rechter Kopf</translation>
    </message>
    <message>
        <source>Crossing on the left leg</source>
        <translation>Kreuzung am linken Schenkel</translation>
    </message>
    <message>
        <source>Crossing on the right leg</source>
        <translation>Kreuzung am rechten Schenkel</translation>
    </message>
    <message>
        <source>Crossing on the float</source>
        <translation>Kreuzung an der Flottung</translation>
    </message>
    <message>
        <source>to the right</source>
        <translation>nach rechts</translation>
    </message>
    <message>
        <source>to the left</source>
        <translation>nach links</translation>
    </message>
    <message>
        <source>Knit on %1 with carrier %2, %3</source>
        <translation>Stricken auf %1 mit Fadenführer %2, %3</translation>
    </message>
    <message>
        <source>Tuck on %1 with carrier %2, %3</source>
        <translation>Fang auf %1 mit Fadenführer %2, %3</translation>
    </message>
    <message>
        <source>Miss %1 with carrier %2, %3</source>
        <translation>%1 auslassen, Fadenführer %2, %3</translation>
    </message>
    <message>
        <source>Carrier %2 starts at %1, %3</source>
        <translation>Fadenführer %2 beginnt bei %1, %3</translation>
    </message>
    <message>
        <source>Carrier %2 ends at %1, %3</source>
        <translation>Fadenführer %2 endet bei %1, %3</translation>
    </message>
    <message>
        <source>Split on %1 with carrier %2, %3</source>
        <translation>Splitten auf %1 mit Fadenführer %2, %3</translation>
    </message>
    <message>
        <source>Bring in carrier %1</source>
        <translation>Fadenführer %1 hereinholen</translation>
    </message>
    <message>
        <source>Bring in carrier %1 with the hook</source>
        <translation>Fadenführer %1 mit dem Haken hereinholen</translation>
    </message>
    <message>
        <source>Release carrier %1 from the hook</source>
        <translation>Fadenführer %1 vom Haken lösen</translation>
    </message>
    <message>
        <source>Take out carrier %1</source>
        <translation>Fadenführer %1 herausnehmen</translation>
    </message>
    <message>
        <source>Take out carrier %1 with the hook</source>
        <translation>Fadenführer %1 mit dem Haken herausnehmen</translation>
    </message>
    <message>
        <source>hung on an empty needle</source>
        <translation>auf eine leere Nadel gehängt</translation>
    </message>
    <message>
        <source>knit (purl on the face)</source>
        <translation>gestrickt (links auf der Vorderseite)</translation>
    </message>
    <message>
        <source>knit</source>
        <translation>gestrickt</translation>
    </message>
    <message>
        <source>tuck</source>
        <translation>Fang</translation>
    </message>
    <message>
        <source>split</source>
        <translation>gesplittet</translation>
    </message>
    <message>
        <source>through %1 loops</source>
        <translation>durch %1 Schleifen</translation>
    </message>
    <message>
        <source>moved %1 to the right</source>
        <translation>um %1 nach rechts gewandert</translation>
    </message>
    <message>
        <source>moved %1 to the left</source>
        <translation>um %1 nach links gewandert</translation>
    </message>
    <message>
        <source>moved to the front bed</source>
        <translation>aufs vordere Bett gehängt</translation>
    </message>
    <message>
        <source>moved to the rear bed</source>
        <translation>aufs hintere Bett gehängt</translation>
    </message>
    <message>
        <source>dropped</source>
        <translation>abgeworfen</translation>
    </message>
    <message>
        <source>front needle %1</source>
        <translation>Nadel %1 vorn</translation>
    </message>
    <message>
        <source>rear needle %1</source>
        <translation>Nadel %1 hinten</translation>
    </message>
    <message>
        <source>front slider %1</source>
        <translation>Schieber %1 vorn</translation>
    </message>
    <message>
        <source>rear slider %1</source>
        <translation>Schieber %1 hinten</translation>
    </message>
    <message>
        <source>Stitch size %1, tension %2</source>
        <translation>Maschengröße %1, Spannung %2</translation>
    </message>
    <message>
        <source>Stitch number %1</source>
        <translation>Maschennummer %1</translation>
    </message>
    <message>
        <source>Rack the rear bed to %1</source>
        <translation>Hinteres Bett auf %1 versetzen</translation>
    </message>
    <message>
        <source>Drop the loops of %1</source>
        <translation>Schleifen von %1 abwerfen</translation>
    </message>
    <message>
        <source>Activate %1 without yarn</source>
        <translation>%1 ohne Faden bewegen</translation>
    </message>
    <message>
        <source>Transfer from %1 to %2</source>
        <translation>Umhängen von %1 auf %2</translation>
    </message>
    <message>
        <source>Split on %1 to %2 with carrier %3, %4</source>
        <translation>Splitten von %1 auf %2 mit Fadenführer %3, %4</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Show carrier %1 in colour %2</source>
        <translation>Fadenführer %1 in Farbe %2 zeigen</translation>
    </message>
    <message>
        <source>Knit: %1 draws yarn of carrier %2 through its loop.</source>
        <translation>Stricken: %1 zieht Faden von Fadenführer %2 durch ihre Schleife.</translation>
    </message>
    <message>
        <source>Tuck: %1 takes yarn of carrier %2 and keeps what it holds.</source>
        <translation>Fang: %1 nimmt Faden von Fadenführer %2 und behält, was sie hält.</translation>
    </message>
    <message>
        <source>Miss: carrier %2 passes %1, which stays down.</source>
        <translation>Auslassen: Fadenführer %2 läuft an %1 vorbei, sie bleibt unten.</translation>
    </message>
    <message>
        <source>Split: the loop on %1 moves to %2, and %1 takes yarn of carrier %3.</source>
        <translation>Splitten: Die Schleife von %1 wandert auf %2, und %1 nimmt Faden von Fadenführer %3.</translation>
    </message>
    <message>
        <source>Transfer: the loop on %1 moves to %2.</source>
        <translation>Umhängen: Die Schleife von %1 wandert auf %2.</translation>
    </message>
    <message>
        <source>Drop: the loop falls off %1.</source>
        <translation>Abwerfen: Die Schleife fällt von %1.</translation>
    </message>
    <message>
        <source>%1 moves without yarn.</source>
        <translation>%1 bewegt sich ohne Faden.</translation>
    </message>
    <message>
        <source>Rack: the rear bed moves to %1.</source>
        <translation>Versatz: Das hintere Bett rückt auf %1.</translation>
    </message>
    <message>
        <source>Carrier %1 comes in.</source>
        <translation>Fadenführer %1 kommt herein.</translation>
    </message>
    <message>
        <source>Carrier %1 comes in, the hook holds its yarn.</source>
        <translation>Fadenführer %1 kommt herein, der Haken hält seinen Faden.</translation>
    </message>
    <message>
        <source>The hook lets go of the yarn of carrier %1.</source>
        <translation>Der Haken lässt den Faden von Fadenführer %1 los.</translation>
    </message>
    <message>
        <source>Carrier %1 goes out, its yarn is cut.</source>
        <translation>Fadenführer %1 geht hinaus, sein Faden wird geschnitten.</translation>
    </message>
    <message>
        <source>%1, course %2: %3 with carrier %4</source>
        <translation>%1, Reihe %2: %3 mit Fadenführer %4</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, Zeile %2</translation>
    </message>
    <message>
        <source>Knit: %1 is empty and takes yarn of carrier %2 as its first loop.</source>
        <translation>Stricken: %1 ist leer und nimmt Faden von Fadenführer %2 als erste Schleife.</translation>
    </message>
    <message>
        <source>Tuck: %1 is empty and takes yarn of carrier %2 as its first loop.</source>
        <translation>Fang: %1 ist leer und nimmt Faden von Fadenführer %2 als erste Schleife.</translation>
    </message>
</context>
<context>
    <name>knittsim::document::Document</name>
    <message>
        <source>ladder of one loop</source>
        <translation>Laufmasche aus einer Schleife</translation>
    </message>
    <message>
        <source>ladders of %1 loops</source>
        <translation>Laufmaschen aus %1 Schleifen</translation>
    </message>
    <message>
        <source>yarn %1 on carrier %2</source>
        <translation>Garn %1 auf Fadenführer %2</translation>
    </message>
    <message>
        <source>edit as chart</source>
        <translation>als Patrone bearbeiten</translation>
    </message>
</context>
<context>
    <name>knittsim::document::Words</name>
    <message>
        <source>Bound: %1, rack %2</source>
        <translation>Gebunden: %1, Versatz %2</translation>
    </message>
    <message>
        <source>Dropped by %1</source>
        <translation>Abgeworfen durch %1</translation>
    </message>
    <message>
        <source>Hangs on %1</source>
        <translation>Hängt auf %1</translation>
    </message>
    <message>
        <source>The yarn of this loop lies in front here</source>
        <translation>Der Faden dieser Schleife liegt hier vorn</translation>
    </message>
    <message>
        <source>In front here: %1</source>
        <translation>Hier vorn: %1</translation>
    </message>
    <message>
        <source>the loop of line %1 on %2</source>
        <translation>die Schleife von Zeile %1 auf %2</translation>
    </message>
    <message>
        <source>the loop on %1</source>
        <translation>die Schleife auf %1</translation>
    </message>
    <message>
        <source>, through one loop</source>
        <translation>, durch eine Schleife</translation>
    </message>
    <message>
        <source>, through %1 loops</source>
        <translation>, durch %1 Schleifen</translation>
    </message>
    <message>
        <source>, on the empty needle</source>
        <translation>, auf der leeren Nadel</translation>
    </message>
    <message>
        <source>Made: %1%2, rack %3</source>
        <translation>Gebildet: %1%2, Versatz %3</translation>
    </message>
    <message>
        <source>Moved by the split from %1 to %2%3, rack %4</source>
        <translation>Durch das Splitten gewandert von %1 auf %2%3, Versatz %4</translation>
    </message>
    <message>
        <source>Transferred from %1 to %2%3, rack %4</source>
        <translation>Umgehängt von %1 auf %2%3, Versatz %4</translation>
    </message>
    <message>
        <source>, onto one loop</source>
        <translation>, auf eine Schleife</translation>
    </message>
    <message>
        <source>, onto %1 loops</source>
        <translation>, auf %1 Schleifen</translation>
    </message>
    <message>
        <source>Crossed: %1; in front of %2 of %3</source>
        <translation>Gekreuzt: %1; vor %2 von %3</translation>
    </message>
    <message>
        <source>Crossed: %1; behind %2 of %3</source>
        <translation>Gekreuzt: %1; hinter %2 von %3</translation>
    </message>
    <message>
        <source>the left leg</source>
        <translation>dem linken Schenkel</translation>
    </message>
    <message>
        <source>the right leg</source>
        <translation>dem rechten Schenkel</translation>
    </message>
    <message>
        <source>the float before</source>
        <translation>der Flottung davor</translation>
    </message>
</context>
<context>
    <name>knittsim::ui</name>
    <message>
        <source>Cast-on</source>
        <translation>Anschlag</translation>
    </message>
    <message>
        <source>The first loops are hung on empty needles. Every second needle takes yarn on the way there, the others on the way back.</source>
        <translation>Die ersten Schleifen werden auf leere Nadeln gehängt. Jede zweite Nadel nimmt auf dem Hinweg Faden, die anderen auf dem Rückweg.</translation>
    </message>
    <message>
        <source>Knit</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>The needle rises, its old loop slides behind the latch, new yarn comes. The needle sinks and draws the new loop through the old one.</source>
        <translation>Die Nadel steigt, ihre alte Schleife rutscht hinter die Zunge, neuer Faden kommt. Die Nadel sinkt und zieht die neue Schleife durch die alte.</translation>
    </message>
    <message>
        <source>Purl</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>The same stitch made on the rear bed. Seen from the front, the new loop goes to the back.</source>
        <translation>Dieselbe Masche auf dem hinteren Bett. Von vorn gesehen geht die neue Schleife nach hinten.</translation>
    </message>
    <message>
        <source>Tuck</source>
        <translation>Fang</translation>
    </message>
    <message>
        <source>The needle rises only so far that the old loop stays on the latch. It takes yarn and holds both.</source>
        <translation>Die Nadel steigt nur so weit, dass die alte Schleife auf der Zunge bleibt. Sie nimmt Faden und hält beide.</translation>
    </message>
    <message>
        <source>Miss</source>
        <translation>Auslassen</translation>
    </message>
    <message>
        <source>The needle stays down while the carrier passes. The yarn floats past its loop.</source>
        <translation>Die Nadel bleibt unten, während der Fadenführer vorbeiläuft. Der Faden flottet an ihrer Schleife vorbei.</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Splitten</translation>
    </message>
    <message>
        <source>The loop goes to the other bed, and the needle takes new yarn in the same stroke. Both needles hold a loop then.</source>
        <translation>Die Schleife geht aufs andere Bett, und die Nadel nimmt im selben Hub neuen Faden. Danach halten beide Nadeln eine Schleife.</translation>
    </message>
    <message>
        <source>Transfer</source>
        <translation>Umhängen</translation>
    </message>
    <message>
        <source>The needle lifts its loop high, the needle opposite enters it and takes it over. The first needle is empty then.</source>
        <translation>Die Nadel hebt ihre Schleife hoch, die Nadel gegenüber greift hinein und übernimmt sie. Die erste Nadel ist dann leer.</translation>
    </message>
    <message>
        <source>Rack</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>The whole rear bed moves aside by needles. Its loops stand opposite other front needles then.</source>
        <translation>Das ganze hintere Bett rückt um Nadeln zur Seite. Seine Schleifen stehen dann anderen vorderen Nadeln gegenüber.</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Abwerfen</translation>
    </message>
    <message>
        <source>The needle works without getting yarn. Its loop falls off, and what hung from it may run.</source>
        <translation>Die Nadel arbeitet, ohne Faden zu bekommen. Ihre Schleife fällt ab, und was daran hing, kann laufen.</translation>
    </message>
    <message>
        <source>Bind-off</source>
        <translation>Abketten</translation>
    </message>
    <message>
        <source>One loop after the other is moved on to its neighbour and knitted together with it, until none is left that could run.</source>
        <translation>Eine Schleife nach der anderen wird zur Nachbarin gehängt und mit ihr zusammengestrickt, bis keine mehr laufen kann.</translation>
    </message>
    <message>
        <source>Knit: stitch on the front bed</source>
        <translation>Rechts: Masche auf dem vorderen Bett</translation>
    </message>
    <message>
        <source>Purl: stitch on the rear bed</source>
        <translation>Links: Masche auf dem hinteren Bett</translation>
    </message>
    <message>
        <source>Stitch on both beds</source>
        <translation>Masche auf beiden Betten</translation>
    </message>
    <message>
        <source>Tuck: the yarn is laid into the hook, the loop is held</source>
        <translation>Fang: Der Faden wird in den Haken gelegt, die Schleife bleibt</translation>
    </message>
    <message>
        <source>Miss: the yarn passes, the loop is held</source>
        <translation>Auslassen: Der Faden läuft vorbei, die Schleife bleibt</translation>
    </message>
    <message>
        <source>Rest: the yarn does not come here, the loop is held</source>
        <translation>Ruhe: Der Faden kommt nicht hierher, die Schleife bleibt</translation>
    </message>
    <message>
        <source>Empty: no fabric here</source>
        <translation>Leer: hier ist kein Gestrick</translation>
    </message>
    <message>
        <source>This display offers no OpenGL.</source>
        <translation>Diese Anzeige bietet kein OpenGL.</translation>
    </message>
    <message>
        <source>OpenGL cannot be used on this display.</source>
        <translation>OpenGL kann auf dieser Anzeige nicht benutzt werden.</translation>
    </message>
    <message>
        <source>This display has software OpenGL only.</source>
        <translation>Diese Anzeige hat nur OpenGL in Software.</translation>
    </message>
    <message>
        <source>OpenGL 3.3 is needed; this display has %1.%2.</source>
        <translation>OpenGL 3.3 ist nötig; diese Anzeige hat %1.%2.</translation>
    </message>
    <message>
        <source>The carriage comes</source>
        <translation>Der Schlitten kommt</translation>
    </message>
    <message>
        <source>The empty needle rises</source>
        <translation>Die leere Nadel steigt</translation>
    </message>
    <message>
        <source>The carrier lays the yarn into the hook</source>
        <translation>Der Fadenführer legt den Faden in den Haken</translation>
    </message>
    <message>
        <source>The needle sinks with its first loop</source>
        <translation>Die Nadel sinkt mit ihrer ersten Schleife</translation>
    </message>
    <message>
        <source>The needle rises: the old loop slides behind the latch</source>
        <translation>Die Nadel steigt: die alte Schleife rutscht hinter die Zunge</translation>
    </message>
    <message>
        <source>The needle sinks: the old loop shuts the latch</source>
        <translation>Die Nadel sinkt: die alte Schleife schließt die Zunge</translation>
    </message>
    <message>
        <source>Knock-over: the old loop hangs in the new one</source>
        <translation>Abschlag: die alte Schleife hängt in der neuen</translation>
    </message>
    <message>
        <source>The needle rises half: the old loop stays on the latch</source>
        <translation>Die Nadel steigt halb: die alte Schleife bleibt auf der Zunge</translation>
    </message>
    <message>
        <source>The needle sinks: both loops lie in the hook</source>
        <translation>Die Nadel sinkt: beide Schleifen liegen im Haken</translation>
    </message>
    <message>
        <source>Tuck: the old loop is kept</source>
        <translation>Fang: die alte Schleife bleibt</translation>
    </message>
    <message>
        <source>The needle lifts its loop high</source>
        <translation>Die Nadel hebt ihre Schleife hoch</translation>
    </message>
    <message>
        <source>The other needle enters the loop, the yarn is laid</source>
        <translation>Die andere Nadel greift in die Schleife, der Faden kommt</translation>
    </message>
    <message>
        <source>The other needle enters the loop</source>
        <translation>Die andere Nadel greift in die Schleife</translation>
    </message>
    <message>
        <source>The first needle sinks and leaves the loop to the other</source>
        <translation>Die erste Nadel sinkt und lässt die Schleife der anderen</translation>
    </message>
    <message>
        <source>The loop hangs on the other bed</source>
        <translation>Die Schleife hängt am anderen Bett</translation>
    </message>
    <message>
        <source>The needle rises and gets no yarn</source>
        <translation>Die Nadel steigt und bekommt keinen Faden</translation>
    </message>
    <message>
        <source>The needle sinks: the loop shuts the latch</source>
        <translation>Die Nadel sinkt: die Schleife schließt die Zunge</translation>
    </message>
    <message>
        <source>The loop falls off</source>
        <translation>Die Schleife fällt ab</translation>
    </message>
    <message>
        <source>The needle holds no loop</source>
        <translation>Die Nadel hält keine Schleife</translation>
    </message>
    <message>
        <source>The carrier passes, the needle stays down</source>
        <translation>Der Fadenführer läuft vorbei, die Nadel bleibt unten</translation>
    </message>
    <message>
        <source>The rear bed moves</source>
        <translation>Das hintere Bett rückt</translation>
    </message>
    <message>
        <source>forces are balanced</source>
        <translation>die Kräfte sind im Gleichgewicht</translation>
    </message>
    <message>
        <source>energy and shape no longer change</source>
        <translation>Energie und Form ändern sich nicht mehr</translation>
    </message>
    <message>
        <source>the limit of steps is reached</source>
        <translation>die Höchstzahl der Schritte ist erreicht</translation>
    </message>
    <message>
        <source>the numbers became useless; the last good shape is kept</source>
        <translation>die Zahlen wurden unbrauchbar; die letzte gute Form bleibt</translation>
    </message>
    <message>
        <source>the integrator gave up; try another one</source>
        <translation>der Integrator gab auf; versuche einen anderen</translation>
    </message>
    <message>
        <source>Nothing open</source>
        <translation>Nichts geöffnet</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Wird geöffnet</translation>
    </message>
    <message>
        <source>As the machine leaves it</source>
        <translation>Wie von der Maschine</translation>
    </message>
    <message>
        <source>Settling</source>
        <translation>Entspannt sich</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>At rest</source>
        <translation>In Ruhe</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 of %2 loops have run</source>
        <translation>%1 von %2 Schleifen sind gelaufen</translation>
    </message>
    <message>
        <source>%1 loops have run, %2 would run</source>
        <translation>%1 Schleifen sind gelaufen, %2 würden laufen</translation>
    </message>
    <message>
        <source>1 loop would run</source>
        <translation>1 Schleife würde laufen</translation>
    </message>
    <message>
        <source>%1 loops would run</source>
        <translation>%1 Schleifen würden laufen</translation>
    </message>
    <message>
        <source>1 loop has run</source>
        <translation>1 Schleife ist gelaufen</translation>
    </message>
    <message>
        <source>%1 loops have run</source>
        <translation>%1 Schleifen sind gelaufen</translation>
    </message>
    <message>
        <source>Nothing more runs: every loop that is left is held by a needle or by the loop drawn through it.</source>
        <translation>Mehr läuft nicht: Jede Schleife, die noch da ist, wird von einer Nadel gehalten oder von der Schleife, die durch sie gezogen ist.</translation>
    </message>
    <message>
        <source>Nothing runs: every loop is held by a needle or by the loop drawn through it.</source>
        <translation>Nichts läuft: Jede Schleife wird von einer Nadel gehalten oder von der Schleife, die durch sie gezogen ist.</translation>
    </message>
    <message>
        <source>%1 Without the stitch holder the loops left on the needles run as well.</source>
        <translation>%1 Ohne den Maschenhalter laufen auch die Schleifen, die noch auf Nadeln hängen.</translation>
    </message>
    <message>
        <source>Takes out the loops that nothing holds, course by course, and gives their yarn to the neighbours</source>
        <translation>Nimmt Reihe um Reihe die Schleifen heraus, die nichts hält, und gibt ihren Faden den Nachbarn</translation>
    </message>
    <message>
        <source>Loops left on the needles are held; without it the fabric ravels from the top</source>
        <translation>Schleifen, die noch auf Nadeln hängen, werden gehalten; ohne ihn läuft das Gestrick von oben auf</translation>
    </message>
    <message>
        <source>Laying the yarn</source>
        <translation>Der Faden wird gelegt</translation>
    </message>
    <message>
        <source>The yarn grows</source>
        <translation>Der Faden wird dick</translation>
    </message>
    <message>
        <source>Settling, step %1</source>
        <translation>Entspannt sich, Schritt %1</translation>
    </message>
    <message>
        <source>%1 × %2 mm a stitch</source>
        <translation>%1 × %2 mm je Masche</translation>
    </message>
    <message>
        <source>At rest: wale spacing %1 mm, course spacing %2 mm, %3 × %4 mm</source>
        <translation>In Ruhe: Stäbchenabstand %1 mm, Reihenabstand %2 mm, %3 × %4 mm</translation>
    </message>
    <message>
        <source>No yarn is inside another</source>
        <translation>Kein Faden steckt in einem anderen</translation>
    </message>
    <message>
        <source>%1 places where yarns overlap</source>
        <translation>%1 Stellen, an denen Fäden einander durchdringen</translation>
    </message>
    <message>
        <source>Stop the yarn</source>
        <translation>Garn anhalten</translation>
    </message>
    <message>
        <source>Go on as yarn</source>
        <translation>Als Garn weiter</translation>
    </message>
    <message>
        <source>Settle as yarn</source>
        <translation>Als Garn entspannen</translation>
    </message>
    <message>
        <source>Settle the whole fabric as real yarn, with thickness, bending and friction; up to a minute for a thousand stitches</source>
        <translation>Entspannt das ganze Gestrick als wirkliches Garn, mit Dicke, Biegung und Reibung; bis zu einer Minute für tausend Maschen</translation>
    </message>
    <message>
        <source>no twist</source>
        <translation>keine Drehung</translation>
    </message>
    <message>
        <source>%1/m %2</source>
        <translation>%1/m %2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Linear density</source>
        <translation>Feinheit</translation>
    </message>
    <message>
        <source>%1 tex</source>
        <translation>%1 tex</translation>
    </message>
    <message>
        <source>Outer diameter</source>
        <translation>Außendurchmesser</translation>
    </message>
    <message>
        <source>Core diameter</source>
        <translation>Kerndurchmesser</translation>
    </message>
    <message>
        <source>EA, stretching</source>
        <translation>EA, Dehnung</translation>
    </message>
    <message>
        <source>EI, bending</source>
        <translation>EI, Biegung</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Plies and twist</source>
        <translation>Zwirnung und Drehung</translation>
    </message>
    <message>
        <source>Two together, leaning right; the hole beside it is an eyelet</source>
        <translation>Zwei zusammen, nach rechts geneigt; daneben bleibt ein Loch</translation>
    </message>
    <message>
        <source>Two together, leaning left; the hole beside it is an eyelet</source>
        <translation>Zwei zusammen, nach links geneigt; daneben bleibt ein Loch</translation>
    </message>
    <message>
        <source>Cable: loops change places; the upper line lies in front</source>
        <translation>Zopf: Schleifen tauschen die Plätze; die obere Linie liegt vorn</translation>
    </message>
    <message>
        <source>Name of the module</source>
        <translation>Name des Moduls</translation>
    </message>
    <message>
        <source>Save as a module</source>
        <translation>Als Modul speichern</translation>
    </message>
    <message>
        <source>Rename the module</source>
        <translation>Modul umbenennen</translation>
    </message>
    <message>
        <source>Delete the module</source>
        <translation>Modul löschen</translation>
    </message>
    <message>
        <source>Delete the module %1 for good?</source>
        <translation>Modul %1 endgültig löschen?</translation>
    </message>
    <message>
        <source>Course %1</source>
        <translation>Reihe %1</translation>
    </message>
    <message>
        <source>carrier %1 to the left</source>
        <translation>Fadenführer %1 nach links</translation>
    </message>
    <message>
        <source>carrier %1 to the right</source>
        <translation>Fadenführer %1 nach rechts</translation>
    </message>
    <message>
        <source>carrier %1</source>
        <translation>Fadenführer %1</translation>
    </message>
    <message>
        <source>stitch size %1</source>
        <translation>Maschengröße %1</translation>
    </message>
    <message>
        <source>racking %1</source>
        <translation>Versatz %1</translation>
    </message>
    <message>
        <source>Loop that was dropped</source>
        <translation>Abgeworfene Schleife</translation>
    </message>
    <message>
        <source>Stitch through several loops</source>
        <translation>Masche durch mehrere Schleifen</translation>
    </message>
    <message>
        <source>Loop goes to the right</source>
        <translation>Schleife wandert nach rechts</translation>
    </message>
    <message>
        <source>Loop goes to the left</source>
        <translation>Schleife wandert nach links</translation>
    </message>
    <message>
        <source>Loop goes to the front bed</source>
        <translation>Schleife geht aufs vordere Bett</translation>
    </message>
    <message>
        <source>Loop goes to the rear bed</source>
        <translation>Schleife geht aufs hintere Bett</translation>
    </message>
    <message>
        <source>Loop on an empty needle, rear bed</source>
        <translation>Schleife auf leerer Nadel, hinteres Bett</translation>
    </message>
    <message>
        <source>Loop on an empty needle, front bed</source>
        <translation>Schleife auf leerer Nadel, vorderes Bett</translation>
    </message>
    <message>
        <source>Stitch on the rear bed (purl)</source>
        <translation>Masche auf dem hinteren Bett (links)</translation>
    </message>
    <message>
        <source>Stitch on the front bed (knit)</source>
        <translation>Masche auf dem vorderen Bett (rechts)</translation>
    </message>
    <message>
        <source>Tuck on the rear bed</source>
        <translation>Fang auf dem hinteren Bett</translation>
    </message>
    <message>
        <source>Tuck on the front bed</source>
        <translation>Fang auf dem vorderen Bett</translation>
    </message>
    <message>
        <source>Split: stitch and loop on the other bed</source>
        <translation>Splitten: Masche, und Schleife aufs andere Bett</translation>
    </message>
    <message>
        <source>a loose end</source>
        <translation>einem losen Ende</translation>
    </message>
    <message>
        <source>%1 in course %2</source>
        <translation>%1 in Reihe %2</translation>
    </message>
    <message>
        <source>No yarn went through another on the way</source>
        <translation>Kein Faden ging unterwegs durch einen anderen</translation>
    </message>
    <message>
        <source>%1 times yarn went through yarn, first at %2 and %3</source>
        <translation>%1-mal ging Faden durch Faden, zuerst bei %2 und %3</translation>
    </message>
    <message>
        <source>Knit on the front bed, tuck on the rear bed</source>
        <translation>Rechte Masche vorn, Fang auf dem hinteren Bett</translation>
    </message>
    <message>
        <source>Tuck on the front bed, knit on the rear bed</source>
        <translation>Fang auf dem vorderen Bett, Masche hinten</translation>
    </message>
    <message>
        <source>Tuck on both beds</source>
        <translation>Fang auf beiden Betten</translation>
    </message>
    <message>
        <source>Miss on the rear bed</source>
        <translation>Auslassen auf dem hinteren Bett</translation>
    </message>
    <message>
        <source>Drop: the loops of the needle fall off before the course</source>
        <translation>Abwerfen: die Maschen der Nadel fallen vor der Reihe ab</translation>
    </message>
    <message>
        <source>The old loop hangs on the other bed, the new one on its own</source>
        <translation>Die alte Schleife hängt am anderen Bett, die neue am eigenen</translation>
    </message>
    <message>
        <source>source not given</source>
        <translation>Quelle nicht angegeben</translation>
    </message>
    <message>
        <source>Hairiness, melange</source>
        <translation>Haarigkeit, Melange</translation>
    </message>
    <message>
        <source>Settling as yarn</source>
        <translation>Entspannt sich als Garn</translation>
    </message>
    <message>
        <source>Yarn at rest</source>
        <translation>Garn in Ruhe</translation>
    </message>
    <message>
        <source>Yarn stopped</source>
        <translation>Garn angehalten</translation>
    </message>
    <message>
        <source>Yarn hardly moves any more</source>
        <translation>Garn bewegt sich kaum noch</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::AboutDialog</name>
    <message>
        <source>KnittSim %1</source>
        <translation>KnittSim %1</translation>
    </message>
    <message>
        <source>Qt %1 (built with %2)</source>
        <translation>Qt %1 (gebaut mit %2)</translation>
    </message>
    <message>
        <source>OpenGL: %1</source>
        <translation>OpenGL: %1</translation>
    </message>
    <message>
        <source>not in use</source>
        <translation>nicht in Gebrauch</translation>
    </message>
    <message>
        <source>System: %1, %2</source>
        <translation>System: %1, %2</translation>
    </message>
    <message>
        <source>About KnittSim</source>
        <translation>Über KnittSim</translation>
    </message>
    <message>
        <source>Turns knitting-machine programs into the fabric they knit, after the method of Meißner and Eberhardt, “The Art of Knitted Fabrics” (1998).

MIT licence. Copyright the KnittSim authors.</source>
        <translation>Macht aus Strickprogrammen das Gestrick, das sie stricken, nach dem Verfahren von Meißner und Eberhardt, „The Art of Knitted Fabrics“ (1998).

MIT-Lizenz. Copyright: die Autoren von KnittSim.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copies these lines for a report</source>
        <translation>Kopiert diese Zeilen für einen Bericht</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::Banner</name>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::CarrierModel</name>
    <message>
        <source>Carrier %1: %2</source>
        <translation>Fadenführer %1: %2</translation>
    </message>
    <message>
        <source>Carrier %1. Drop a yarn of the library here; the fabric goes on from its shape. Double click or Enter: another colour.</source>
        <translation>Fadenführer %1. Hier ein Garn der Sammlung ablegen; das Gestrick geht von seiner Form aus weiter. Doppelklick oder Eingabetaste: andere Farbe.</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::CataloguePopup</name>
    <message>
        <source>texture</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>cable</source>
        <translation>Zopf</translation>
    </message>
    <message>
        <source>lace</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>tuck and slip</source>
        <translation>Fang und Hebemasche</translation>
    </message>
    <message>
        <source>shaping</source>
        <translation>Formen</translation>
    </message>
    <message>
        <source>Stitch catalogue</source>
        <translation>Maschenkatalog</translation>
    </message>
    <message>
        <source>%1 (%2), %3 wales x %4 courses</source>
        <translation>%1 (%2), %3 Stäbchen x %4 Reihen</translation>
    </message>
    <message>
        <source>your own</source>
        <translation>eigene</translation>
    </message>
    <message>
        <source>&amp;Rename your module…</source>
        <translation>Eigenes Modul &amp;umbenennen…</translation>
    </message>
    <message>
        <source>&amp;Delete your module…</source>
        <translation>Eigenes Modul &amp;löschen…</translation>
    </message>
    <message>
        <source>Search: cable, lace, rib…</source>
        <translation>Suche: cable, rib, Zopf, Spitze…</translation>
    </message>
    <message>
        <source>Search the stitch catalogue</source>
        <translation>Den Musterkatalog durchsuchen</translation>
    </message>
    <message>
        <source>Words of the name, or the kind: texture, cable, lace, tuck and slip, shaping</source>
        <translation>Wörter des Namens oder die Art: Struktur, Zopf, Spitze, Fang und Hebemasche, Formgebung</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::ChartArea</name>
    <message>
        <source>Yarn</source>
        <translation>Garn</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Rack</source>
        <translation>Versatz</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::ChartCanvas</name>
    <message>
        <source>Chart</source>
        <translation>Patrone</translation>
    </message>
    <message>
        <source>Wales across, courses up. The left button draws, the right one picks stitch and yarn.</source>
        <translation>Stäbchen quer, Reihen nach oben. Die linke Taste zeichnet, die rechte übernimmt Masche und Garn.</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>ausschneiden</translation>
    </message>
    <message>
        <source>paste</source>
        <translation>einfügen</translation>
    </message>
    <message>
        <source>clear</source>
        <translation>leeren</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>spiegeln</translation>
    </message>
    <message>
        <source>rotate</source>
        <translation>drehen</translation>
    </message>
    <message>
        <source>repeat</source>
        <translation>wiederholen</translation>
    </message>
    <message>
        <source>insert courses</source>
        <translation>Reihen einfügen</translation>
    </message>
    <message>
        <source>remove courses</source>
        <translation>Reihen entfernen</translation>
    </message>
    <message>
        <source>insert wales</source>
        <translation>Stäbchen einfügen</translation>
    </message>
    <message>
        <source>remove wales</source>
        <translation>Stäbchen entfernen</translation>
    </message>
    <message>
        <source>move</source>
        <translation>verschieben</translation>
    </message>
    <message>
        <source>Needle %1, course %2: %3</source>
        <translation>Nadel %1, Reihe %2: %3</translation>
    </message>
    <message>
        <source>, carrier %1</source>
        <translation>, Fadenführer %1</translation>
    </message>
    <message>
        <source>; before it the loop goes to wale %1</source>
        <translation>; davor wandert die Schleife zu Stäbchen %1</translation>
    </message>
    <message>
        <source>Carrier %1</source>
        <translation>Fadenführer %1</translation>
    </message>
    <message>
        <source>yarn of the course</source>
        <translation>Garn der Reihe</translation>
    </message>
    <message>
        <source>Only a chart on both beds is racked; on a single bed loops are moved by cables.</source>
        <translation>Nur eine Patrone auf beiden Betten wird versetzt; auf einem Bett wandern Schleifen durch Zöpfe.</translation>
    </message>
    <message>
        <source>racking</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>stitch size</source>
        <translation>Maschengröße</translation>
    </message>
    <message>
        <source>Racking of the course</source>
        <translation>Versatz der Reihe</translation>
    </message>
    <message>
        <source>Stitch size from this course on</source>
        <translation>Maschengröße ab dieser Reihe</translation>
    </message>
    <message>
        <source>Colours of all courses</source>
        <translation>Farben aller Reihen</translation>
    </message>
    <message>
        <source>Colours of the selected courses</source>
        <translation>Farben der ausgewählten Reihen</translation>
    </message>
    <message>
        <source>A chart with cables or lace is knitted on one bed: its colours cannot have a back.</source>
        <translation>Ein Muster mit Zöpfen oder Lochmuster wird auf einem Bett gestrickt: seine Farben können keine Rückseite haben.</translation>
    </message>
    <message>
        <source>knitting of the colours</source>
        <translation>Strickart der Farben</translation>
    </message>
    <message>
        <source>both beds</source>
        <translation>beide Betten</translation>
    </message>
    <message>
        <source>one bed</source>
        <translation>ein Bett</translation>
    </message>
    <message>
        <source>Moved loops, as of cables and lace, need a chart on one bed.</source>
        <translation>Umgehängte Maschen, wie bei Zöpfen und Lochmustern, brauchen ein Muster auf einem Bett.</translation>
    </message>
    <message>
        <source>shift</source>
        <translation>verschieben</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::ChartEditor</name>
    <message>
        <source>The fabric follows…</source>
        <translation>Das Gestrick folgt…</translation>
    </message>
    <message>
        <source>The fabric is out of date: %1</source>
        <translation>Das Gestrick ist veraltet: %1</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Pencil</source>
        <translation>Stift</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Füllen</translation>
    </message>
    <message>
        <source>Stitch catalogue</source>
        <translation>Maschenkatalog</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Ausschneiden</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>C&amp;lear</source>
        <translation>&amp;Leeren</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>A&amp;lles auswählen</translation>
    </message>
    <message>
        <source>&amp;Mirror left and right</source>
        <translation>Links und rechts &amp;spiegeln</translation>
    </message>
    <message>
        <source>Mirror &amp;up and down</source>
        <translation>&amp;Oben und unten spiegeln</translation>
    </message>
    <message>
        <source>&amp;Rotate a square selection</source>
        <translation>Quadratische Auswahl &amp;drehen</translation>
    </message>
    <message>
        <source>R&amp;epeat the selection over the chart</source>
        <translation>Auswahl über die Patrone &amp;wiederholen</translation>
    </message>
    <message>
        <source>&amp;Insert courses</source>
        <translation>&amp;Reihen einfügen</translation>
    </message>
    <message>
        <source>Remo&amp;ve courses</source>
        <translation>Reihen ent&amp;fernen</translation>
    </message>
    <message>
        <source>Insert &amp;wales</source>
        <translation>S&amp;täbchen einfügen</translation>
    </message>
    <message>
        <source>Remove wale&amp;s</source>
        <translation>Stä&amp;bchen entfernen</translation>
    </message>
    <message>
        <source>Save the selection as a m&amp;odule…</source>
        <translation>Auswahl als M&amp;odul speichern…</translation>
    </message>
    <message>
        <source>Select the stitches of the module first.</source>
        <translation>Wähle zuerst die Maschen des Moduls aus.</translation>
    </message>
    <message>
        <source>The module stands at the end of the stitch catalogue.</source>
        <translation>Das Modul steht am Ende des Maschenkatalogs.</translation>
    </message>
    <message>
        <source>&amp;Yarn of the course…</source>
        <translation>&amp;Garn der Reihe…</translation>
    </message>
    <message>
        <source>Stitch si&amp;ze of the course…</source>
        <translation>Maschen&amp;größe der Reihe…</translation>
    </message>
    <message>
        <source>Rackin&amp;g of the course…</source>
        <translation>&amp;Versatz der Reihe…</translation>
    </message>
    <message>
        <source>&amp;Bind off above the chart</source>
        <translation>Über dem Muster a&amp;bketten</translation>
    </message>
    <message>
        <source>bind off</source>
        <translation>abketten</translation>
    </message>
    <message>
        <source>Only a chart on one bed, with two loops or more, can be bound off.</source>
        <translation>Nur ein Muster auf einem Bett mit mindestens zwei Maschen lässt sich abketten.</translation>
    </message>
    <message>
        <source>&amp;Knitting of the colours…</source>
        <translation>Stric&amp;kart der Farben …</translation>
    </message>
    <message>
        <source>How the colours are knitted: floats, intarsia, a birdseye or ladder back (%1)</source>
        <translation>Wie die Farben gestrickt werden: Flottungen, Intarsie, Pfauenaugen- oder Leiter-Rückseite (%1)</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Work on bot&amp;h beds</source>
        <translation>Auf &amp;beiden Betten arbeiten</translation>
    </message>
    <message>
        <source>Stitch and &amp;yarn to draw with</source>
        <translation>Masche und &amp;Garn zum Zeichnen</translation>
    </message>
    <message>
        <source>Shi&amp;ft, move and repeat</source>
        <translation>&amp;Umlaufen, verschieben, wiederholen</translation>
    </message>
    <message>
        <source>%1; the yarns stay</source>
        <translation>%1; die Garne bleiben</translation>
    </message>
    <message>
        <source>yarn of carrier %1; the stitches stay</source>
        <translation>Garn von Fadenführer %1; die Maschen bleiben</translation>
    </message>
    <message>
        <source>%1 with the yarn of carrier %2</source>
        <translation>%1 mit dem Garn von Fadenführer %2</translation>
    </message>
    <message>
        <source>Select: drag over cells. Drag the selection to move it, its edge to repeat it.</source>
        <translation>Auswählen: über Felder ziehen. Die Auswahl ziehen verschiebt, ihr Rand wiederholt sie.</translation>
    </message>
    <message>
        <source>Pencil: %1</source>
        <translation>Stift: %1</translation>
    </message>
    <message>
        <source>Line: %1</source>
        <translation>Linie: %1</translation>
    </message>
    <message>
        <source>Rectangle: %1</source>
        <translation>Rechteck: %1</translation>
    </message>
    <message>
        <source>Fill: %1</source>
        <translation>Füllen: %1</translation>
    </message>
    <message>
        <source>%1: a click lays it down, a drag repeats it.</source>
        <translation>%1: ein Klick setzt es, Ziehen wiederholt es.</translation>
    </message>
    <message>
        <source>Choose a stitch of the catalogue (Shift+B).</source>
        <translation>Ein Muster aus dem Katalog wählen (Umschalt+B).</translation>
    </message>
    <message>
        <source>&amp;Next stitch</source>
        <translation>&amp;Nächste Masche</translation>
    </message>
    <message>
        <source>&amp;Previous stitch</source>
        <translation>&amp;Vorige Masche</translation>
    </message>
    <message>
        <source>Next &amp;yarn</source>
        <translation>Nächstes &amp;Garn</translation>
    </message>
    <message>
        <source>Previous y&amp;arn</source>
        <translation>Voriges G&amp;arn</translation>
    </message>
    <message>
        <source>P&amp;ick both under the cursor</source>
        <translation>Beides unter der &amp;Marke aufnehmen</translation>
    </message>
    <message>
        <source>A&amp;dd a yarn</source>
        <translation>Garn &amp;hinzufügen</translation>
    </message>
    <message>
        <source>to the left</source>
        <translation>nach links</translation>
    </message>
    <message>
        <source>to the right</source>
        <translation>nach rechts</translation>
    </message>
    <message>
        <source>upwards</source>
        <translation>nach oben</translation>
    </message>
    <message>
        <source>downwards</source>
        <translation>nach unten</translation>
    </message>
    <message>
        <source>Shift %1</source>
        <translation>Umlaufend %1</translation>
    </message>
    <message>
        <source>Move the selection %1</source>
        <translation>Auswahl %1 verschieben</translation>
    </message>
    <message>
        <source>Repeat the selection %1</source>
        <translation>Auswahl %1 wiederholen</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::ChartLook</name>
    <message>
        <source>Stitch faces</source>
        <translation>Maschenbilder</translation>
    </message>
    <message>
        <source>Craft symbols</source>
        <translation>Handstrickzeichen</translation>
    </message>
    <message>
        <source>Loop notation</source>
        <translation>Maschenlaufbild</translation>
    </message>
    <message>
        <source>Course numbers</source>
        <translation>Reihennummern</translation>
    </message>
    <message>
        <source>Carriage direction</source>
        <translation>Schlittenrichtung</translation>
    </message>
    <message>
        <source>Carriers</source>
        <translation>Fadenführer</translation>
    </message>
    <message>
        <source>Stitch size</source>
        <translation>Maschengröße</translation>
    </message>
    <message>
        <source>Racking</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>Needle numbers</source>
        <translation>Nadelnummern</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::ChartStroke</name>
    <message>
        <source>pencil</source>
        <translation>Stift</translation>
    </message>
    <message>
        <source>line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>fill</source>
        <translation>Füllung</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::ColourMethodMenu</name>
    <message>
        <source>&amp;Float jacquard</source>
        <translation>&amp;Flottierender Jacquard</translation>
    </message>
    <message>
        <source>Yarns that do not show float behind the stitches</source>
        <translation>Fäden, die nicht zu sehen sind, flotten hinter den Maschen</translation>
    </message>
    <message>
        <source>&amp;Intarsia</source>
        <translation>&amp;Intarsie</translation>
    </message>
    <message>
        <source>Every yarn stays in its own zone and is linked to the next one by a tuck</source>
        <translation>Jeder Faden bleibt in seinem Feld und ist mit dem nächsten durch einen Fang verbunden</translation>
    </message>
    <message>
        <source>&amp;Birdseye back</source>
        <translation>&amp;Pfauenaugen-Rückseite</translation>
    </message>
    <message>
        <source>On both beds: every yarn knits every second needle of the rear bed; no floats, a dotted back</source>
        <translation>Auf beiden Betten: jeder Faden strickt jede zweite Nadel des hinteren Betts; keine Flottungen, getupfte Rückseite</translation>
    </message>
    <message>
        <source>&amp;Ladder back</source>
        <translation>&amp;Leiter-Rückseite</translation>
    </message>
    <message>
        <source>On both beds: every fourth needle of the rear bed knits a yarn that does not show there; a light back with short floats</source>
        <translation>Auf beiden Betten: jede vierte Nadel des hinteren Betts strickt einen Faden, der dort nicht zu sehen ist; leichte Rückseite mit kurzen Flottungen</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::ColourwayBar</name>
    <message>
        <source>Colourway %1</source>
        <translation>Farbstellung %1</translation>
    </message>
    <message>
        <source>Colourway</source>
        <translation>Farbstellung</translation>
    </message>
    <message>
        <source>Sets of yarns for the carriers, saved with the chart</source>
        <translation>Garnsätze für die Fadenführer, mit der Patrone gespeichert</translation>
    </message>
    <message>
        <source>Add, rename and delete colourways</source>
        <translation>Farbstellungen hinzufügen, umbenennen und löschen</translation>
    </message>
    <message>
        <source>&amp;Duplicate this one…</source>
        <translation>Diese &amp;verdoppeln…</translation>
    </message>
    <message>
        <source>New colourway</source>
        <translation>Neue Farbstellung</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>&amp;Umbenennen…</translation>
    </message>
    <message>
        <source>Rename the colourway</source>
        <translation>Farbstellung umbenennen</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Name:</translation>
    </message>
    <message>
        <source>colourway %1</source>
        <translation>Farbstellung %1</translation>
    </message>
    <message>
        <source>new colourway</source>
        <translation>neue Farbstellung</translation>
    </message>
    <message>
        <source>name of the colourway</source>
        <translation>Name der Farbstellung</translation>
    </message>
    <message>
        <source>delete a colourway</source>
        <translation>Farbstellung löschen</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::Comparison</name>
    <message>
        <source>%1%2 × %3%4 mm</source>
        <translation>%1%2 × %3%4 mm</translation>
    </message>
    <message>
        <source>
%1 wales, %2 courses in 10 cm</source>
        <translation>
%1 Stäbchen, %2 Reihen auf 10 cm</translation>
    </message>
    <message>
        <source>Settles this side as yarn, or stops it</source>
        <translation>Entspannt diese Seite als Garn, oder hält sie an</translation>
    </message>
    <message>
        <source>Links the cameras (J)</source>
        <translation>Verbindet die Kameras (J)</translation>
    </message>
    <message>
        <source>Closes the comparison (Escape)</source>
        <translation>Schließt den Vergleich (Esc)</translation>
    </message>
    <message>
        <source>The fabric that is compared</source>
        <translation>Das Gestrick, mit dem verglichen wird</translation>
    </message>
    <message>
        <source>Kept: %1, %2</source>
        <translation>Behalten: %1, %2</translation>
    </message>
    <message>
        <source>%1 could not be opened.</source>
        <translation>%1 konnte nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::DiagnosticsList</name>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>Double click or Enter shows the place (F8 next, Shift+F8 previous)</source>
        <translation>Doppelklick oder Eingabe zeigt die Stelle (F8 nächste, Umschalt+F8 vorige)</translation>
    </message>
    <message>
        <source>turned off: %1</source>
        <translation>abgeschaltet: %1</translation>
    </message>
    <message>
        <source>Show the &amp;place</source>
        <translation>&amp;Stelle zeigen</translation>
    </message>
    <message>
        <source>&amp;Copy as text</source>
        <translation>Als Text &amp;kopieren</translation>
    </message>
    <message>
        <source>Turn rule %1 &amp;on again</source>
        <translation>Regel %1 wieder &amp;einschalten</translation>
    </message>
    <message>
        <source>Turn &amp;off this rule…</source>
        <translation>Diese Regel &amp;abschalten…</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::DiagnosticsModel</name>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Turned off: %1.</source>
        <translation>Abgeschaltet: %1.</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problem</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Stelle</translation>
    </message>
    <message>
        <source>What is wrong and what helps</source>
        <translation>Was falsch ist und was hilft</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::DiagnosticsPanel</name>
    <message>
        <source>1 error</source>
        <translation>1 Fehler</translation>
    </message>
    <message>
        <source>%1 errors</source>
        <translation>%1 Fehler</translation>
    </message>
    <message>
        <source>1 warning</source>
        <translation>1 Warnung</translation>
    </message>
    <message>
        <source>%1 warnings</source>
        <translation>%1 Warnungen</translation>
    </message>
    <message>
        <source>1 note</source>
        <translation>1 Hinweis</translation>
    </message>
    <message>
        <source>%1 notes</source>
        <translation>%1 Hinweise</translation>
    </message>
    <message>
        <source>Shows or hides these problems</source>
        <translation>Zeigt oder verbirgt diese Probleme</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Regel</translation>
    </message>
    <message>
        <source>Shows the problems of one rule only</source>
        <translation>Zeigt nur die Probleme einer Regel</translation>
    </message>
    <message>
        <source>Shows the problems of rules that are turned off, with the reason</source>
        <translation>Zeigt die Probleme abgeschalteter Regeln, mit dem Grund</translation>
    </message>
    <message>
        <source>Export report…</source>
        <translation>Bericht ausgeben…</translation>
    </message>
    <message>
        <source>Writes machine, sizes, yarn, time and all problems to a file (Ctrl+Shift+E)</source>
        <translation>Schreibt Maschine, Maße, Garn, Zeit und alle Probleme in eine Datei (Strg+Umschalt+E)</translation>
    </message>
    <message>
        <source>%1 turned off</source>
        <translation>%1 abgeschaltet</translation>
    </message>
    <message>
        <source>Turn off a rule</source>
        <translation>Regel abschalten</translation>
    </message>
    <message>
        <source>%1 will not count in any file. Why not? The reason stays with the problems.</source>
        <translation>%1 zählt dann in keiner Datei. Warum nicht? Der Grund bleibt bei den Problemen stehen.</translation>
    </message>
    <message>
        <source>Turn off</source>
        <translation>Abschalten</translation>
    </message>
    <message>
        <source>All rules</source>
        <translation>Alle Regeln</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::EnergyPlot</name>
    <message>
        <source>Energies and residual</source>
        <translation>Energien und Residuum</translation>
    </message>
    <message>
        <source>Kinetic energy Ekin, spring energy V, Lagrangian L = Ekin − V, and the residual: the norm of the forces relative to the start</source>
        <translation>Bewegungsenergie Ekin, Federenergie V, Lagrangefunktion L = Ekin − V und das Residuum: die Norm der Kräfte, bezogen auf den Anfang</translation>
    </message>
    <message>
        <source>Ekin</source>
        <translation>Ekin</translation>
    </message>
    <message>
        <source>V</source>
        <translation>V</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Residuum</translation>
    </message>
    <message>
        <source>Energies appear when the fabric settles.</source>
        <translation>Energien erscheinen, wenn sich das Gestrick entspannt.</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::ExportDialog</name>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Durchsuchen…</translation>
    </message>
    <message>
        <source>Width of the picture</source>
        <translation>Breite des Bildes</translation>
    </message>
    <message>
        <source>Height of the picture</source>
        <translation>Höhe des Bildes</translation>
    </message>
    <message>
        <source>&amp;Transparent background</source>
        <translation>&amp;Durchsichtiger Hintergrund</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Ausgeben</translation>
    </message>
    <message>
        <source>What is written</source>
        <translation>Was geschrieben wird</translation>
    </message>
    <message>
        <source>File to write; one that is there is replaced when you export twice</source>
        <translation>Datei, die geschrieben wird; eine vorhandene wird ersetzt, wenn zweimal ausgegeben wird</translation>
    </message>
    <message>
        <source>Choose a folder and a name</source>
        <translation>Ordner und Namen wählen</translation>
    </message>
    <message>
        <source>From where the fabric is shown</source>
        <translation>Von wo das Gestrick gezeigt wird</translation>
    </message>
    <message>
        <source>Leaves out the background, for laying the picture over others</source>
        <translation>Lässt den Hintergrund weg, um das Bild über andere zu legen</translation>
    </message>
    <message>
        <source>As seen now</source>
        <translation>Wie jetzt zu sehen</translation>
    </message>
    <message>
        <source>Technical face</source>
        <translation>Rechte Warenseite</translation>
    </message>
    <message>
        <source>Technical back</source>
        <translation>Linke Warenseite</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Format:</translation>
    </message>
    <message>
        <source>&amp;Side:</source>
        <translation>&amp;Seite:</translation>
    </message>
    <message>
        <source>Si&amp;ze:</source>
        <translation>&amp;Größe:</translation>
    </message>
    <message>
        <source>Fi&amp;le:</source>
        <translation>Da&amp;tei:</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Ausgeben</translation>
    </message>
    <message>
        <source>Writes the file (Enter)</source>
        <translation>Schreibt die Datei (Eingabe)</translation>
    </message>
    <message>
        <source>Stops writing; nothing is left of the file (Esc)</source>
        <translation>Bricht das Schreiben ab; von der Datei bleibt nichts (Esc)</translation>
    </message>
    <message>
        <source>Export as</source>
        <translation>Ausgeben als</translation>
    </message>
    <message>
        <source>This file exists. Export once more to replace it, or choose another name.</source>
        <translation>Diese Datei gibt es schon. Gib noch einmal aus, um sie zu ersetzen, oder wähle einen anderen Namen.</translation>
    </message>
    <message>
        <source>Picture (PNG)</source>
        <translation>Bild (PNG)</translation>
    </message>
    <message>
        <source>What you see, at any size.</source>
        <translation>Was zu sehen ist, in jeder Größe.</translation>
    </message>
    <message>
        <source>Drawing in three strokes (SVG)</source>
        <translation>Zeichnung in drei Strichen (SVG)</translation>
    </message>
    <message>
        <source>Lines in millimetres; at every crossing the front yarn lies on top.</source>
        <translation>Linien in Millimetern; an jeder Kreuzung liegt der vordere Faden oben.</translation>
    </message>
    <message>
        <source>Geometry, glTF binary (GLB)</source>
        <translation>Geometrie, glTF binär (GLB)</translation>
    </message>
    <message>
        <source>A closed tube for each yarn, in metres, with its colour. One file.</source>
        <translation>Ein geschlossener Schlauch für jeden Faden, in Metern, mit seiner Farbe. Eine Datei.</translation>
    </message>
    <message>
        <source>Geometry, glTF text (GLTF)</source>
        <translation>Geometrie, glTF als Text (GLTF)</translation>
    </message>
    <message>
        <source>As the binary form, a third larger.</source>
        <translation>Wie die binäre Form, um ein Drittel größer.</translation>
    </message>
    <message>
        <source>Geometry, Wavefront (OBJ)</source>
        <translation>Geometrie, Wavefront (OBJ)</translation>
    </message>
    <message>
        <source>A closed tube for each yarn, in millimetres; colours in an MTL file beside it.</source>
        <translation>Ein geschlossener Schlauch für jeden Faden, in Millimetern; Farben in einer MTL-Datei daneben.</translation>
    </message>
    <message>
        <source>Yarn curves (BCC)</source>
        <translation>Fadenkurven (BCC)</translation>
    </message>
    <message>
        <source>The middle of each yarn as a curve, in millimetres.</source>
        <translation>Die Mitte jedes Fadens als Kurve, in Millimetern.</translation>
    </message>
    <message>
        <source>Bonding points (CSV)</source>
        <translation>Bindungspunkte (CSV)</translation>
    </message>
    <message>
        <source>A line for each bonding point: yarn, role, needle, place in millimetres.</source>
        <translation>Eine Zeile für jeden Bindungspunkt: Faden, Rolle, Nadel, Ort in Millimetern.</translation>
    </message>
    <message>
        <source>Pictures of the settling (folder of PNG)</source>
        <translation>Bilder des Entspannens (Ordner mit PNG)</translation>
    </message>
    <message>
        <source>From the machine to rest, seen from one place: 0001.png, 0002.png, ...</source>
        <translation>Von der Maschine bis zur Ruhe, von einem Ort gesehen: 0001.png, 0002.png, ...</translation>
    </message>
    <message>
        <source>As shown: %1.</source>
        <translation>Wie gezeigt: %1.</translation>
    </message>
    <message>
        <source>What the section cuts away is written too.</source>
        <translation>Was der Schnitt wegnimmt, wird mitgeschrieben.</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::FabricView</name>
    <message>
        <source>Fabric</source>
        <translation>Gestrick</translation>
    </message>
    <message>
        <source>The knitted fabric in three dimensions. Drag to turn it, drag with Shift to move it, turn the wheel to come nearer, click a stitch to select it.</source>
        <translation>Das Gestrick in drei Dimensionen. Ziehen dreht es, Ziehen mit Umschalt verschiebt es, das Mausrad holt es näher, ein Klick wählt eine Masche.</translation>
    </message>
    <message>
        <source>No fabric yet</source>
        <translation>Noch kein Gestrick</translation>
    </message>
    <message>
        <source>only yarn %1</source>
        <translation>nur Faden %1</translation>
    </message>
    <message>
        <source>only course %1</source>
        <translation>nur Reihe %1</translation>
    </message>
    <message>
        <source>OpenGL is switched off.</source>
        <translation>OpenGL ist ausgeschaltet.</translation>
    </message>
    <message>
        <source>%1 The fabric is drawn flat.</source>
        <translation>%1 Das Gestrick wird flach gezeichnet.</translation>
    </message>
    <message>
        <source>All of the fabric has run</source>
        <translation>Das ganze Gestrick ist aufgelaufen</translation>
    </message>
    <message>
        <source>Stitch on needle %1, course %2</source>
        <translation>Masche auf Nadel %1, Reihe %2</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 mm (%2 in)</source>
        <translation>%1 mm (%2 in)</translation>
    </message>
    <message>
        <source>%1 wales in 10 cm</source>
        <translation>%1 Stäbchen auf 10 cm</translation>
    </message>
    <message>
        <source>%1 courses in 10 cm</source>
        <translation>%1 Reihen auf 10 cm</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::Gallery</name>
    <message>
        <source>KnittSim</source>
        <translation>KnittSim</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Muster</translation>
    </message>
    <message>
        <source>Used last</source>
        <translation>Zuletzt benutzt</translation>
    </message>
    <message>
        <source>Draw a new chart, open a chart or a machine program, or begin with a sample.</source>
        <translation>Zeichne eine neue Patrone, öffne eine Patrone oder ein Strickprogramm oder beginne mit einem Muster.</translation>
    </message>
    <message>
        <source>New chart…</source>
        <translation>Neue Patrone…</translation>
    </message>
    <message>
        <source>Draw a chart of your own (Ctrl+N)</source>
        <translation>Eine eigene Patrone zeichnen (Strg+N)</translation>
    </message>
    <message>
        <source>Open a chart or a machine program (Ctrl+O)</source>
        <translation>Eine Patrone oder ein Strickprogramm öffnen (Strg+O)</translation>
    </message>
    <message>
        <source>From a picture…</source>
        <translation>Aus einem Bild…</translation>
    </message>
    <message>
        <source>Turn a photograph or drawing into a chart (Ctrl+Alt+I)</source>
        <translation>Ein Foto oder eine Zeichnung wird zur Patrone (Strg+Alt+I)</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::GlCanvas</name>
    <message>
        <source>The fabric is too large for this graphics driver.</source>
        <translation>Das Gestrick ist zu groß für diesen Grafiktreiber.</translation>
    </message>
    <message>
        <source>The graphics driver was reset.</source>
        <translation>Der Grafiktreiber wurde neu gestartet.</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::GlossaryDialog</name>
    <message>
        <source>Words of machine knitting</source>
        <translation>Wörter des Maschinenstrickens</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>Wörter</translation>
    </message>
    <message>
        <source>Choose a word (up and down)</source>
        <translation>Ein Wort wählen (auf und ab)</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::HandoutSink</name>
    <message>
        <source>The hand-out cannot be written to %1.</source>
        <translation>Der Handzettel kann nicht nach %1 geschrieben werden.</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::HistoryCard</name>
    <message>
        <source>History of the bonding point</source>
        <translation>Geschichte des Bindungspunkts</translation>
    </message>
    <message>
        <source>Close; H shows histories again</source>
        <translation>Schließen; H zeigt wieder Geschichten</translation>
    </message>
    <message>
        <source>Close the history</source>
        <translation>Geschichte schließen</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::KeyDialog</name>
    <message>
        <source>Mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>Turn the fabric</source>
        <translation>Gestrick drehen</translation>
    </message>
    <message>
        <source>left drag</source>
        <translation>mit links ziehen</translation>
    </message>
    <message>
        <source>Move the fabric</source>
        <translation>Gestrick verschieben</translation>
    </message>
    <message>
        <source>middle drag, or Shift and left drag</source>
        <translation>mit der Mitte ziehen, oder mit Umschalt und links</translation>
    </message>
    <message>
        <source>Zoom at the cursor</source>
        <translation>Am Mauszeiger vergrößern</translation>
    </message>
    <message>
        <source>wheel; in the pattern grid Ctrl and wheel</source>
        <translation>Mausrad; in der Patrone Strg und Mausrad</translation>
    </message>
    <message>
        <source>Move the section</source>
        <translation>Schnitt verschieben</translation>
    </message>
    <message>
        <source>Alt and wheel</source>
        <translation>Alt und Mausrad</translation>
    </message>
    <message>
        <source>Select a stitch</source>
        <translation>Masche wählen</translation>
    </message>
    <message>
        <source>click in fabric, grid or source</source>
        <translation>Klick in Gestrick, Patrone oder Quelltext</translation>
    </message>
    <message>
        <source>Pull the yarn</source>
        <translation>Am Faden ziehen</translation>
    </message>
    <message>
        <source>Ctrl and left drag on yarn</source>
        <translation>mit Strg und links am Faden ziehen</translation>
    </message>
    <message>
        <source>Put a yarn on a carrier</source>
        <translation>Garn auf einen Fadenführer legen</translation>
    </message>
    <message>
        <source>drag, or double click in the library</source>
        <translation>ziehen, oder Doppelklick in der Bibliothek</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Taste</translation>
    </message>
    <message>
        <source>Wherever the focus is</source>
        <translation>Wo immer der Fokus ist</translation>
    </message>
    <message>
        <source>Step the machine</source>
        <translation>Maschine weiterschalten</translation>
    </message>
    <message>
        <source>Space, arrows, Home, End</source>
        <translation>Leertaste, Pfeile, Pos1, Ende</translation>
    </message>
    <message>
        <source>Walk a list, move a slider, choose</source>
        <translation>In Listen gehen, Regler bewegen, auswählen</translation>
    </message>
    <message>
        <source>Ctrl and these keys</source>
        <translation>Strg und diese Tasten</translation>
    </message>
    <message>
        <source>Press a button</source>
        <translation>Eine Schaltfläche drücken</translation>
    </message>
    <message>
        <source>Enter, or Ctrl and Space</source>
        <translation>Eingabe, oder Strg und Leertaste</translation>
    </message>
    <message>
        <source>Kept in the layouts Designer and Quality</source>
        <translation>Bleibt in den Anordnungen Entwurf und Prüfung</translation>
    </message>
    <message>
        <source>all of them where text is written, arrows in charts</source>
        <translation>alle, wo Text geschrieben wird; Pfeile in Patronen</translation>
    </message>
    <message>
        <source>Pick stitch and yarn</source>
        <translation>Masche und Garn aufnehmen</translation>
    </message>
    <message>
        <source>right click in the chart</source>
        <translation>Rechtsklick in der Patrone</translation>
    </message>
    <message>
        <source>Move or repeat a selection</source>
        <translation>Auswahl verschieben oder wiederholen</translation>
    </message>
    <message>
        <source>drag it, or its edge</source>
        <translation>sie ziehen, oder ihren Rand</translation>
    </message>
    <message>
        <source>Draw stitch and yarn at once</source>
        <translation>Masche und Garn zugleich zeichnen</translation>
    </message>
    <message>
        <source>Shift and click the second of them</source>
        <translation>Umschalt und Klick auf das zweite</translation>
    </message>
    <message>
        <source>Search what is done, or a key</source>
        <translation>Suchen, was geschieht, oder eine Taste</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::LegendPanel</name>
    <message>
        <source>Legend</source>
        <translation>Legende</translation>
    </message>
    <message>
        <source>What the symbols and colours of the chart stand for.</source>
        <translation>Was die Zeichen und Farben der Patrone bedeuten.</translation>
    </message>
    <message>
        <source>Carrier %1: %2</source>
        <translation>Fadenführer %1: %2</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::LessonPanel</name>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>Begins a lesson</source>
        <translation>Beginnt eine Lektion</translation>
    </message>
    <message>
        <source>Opens a lesson of your own (JSON)</source>
        <translation>Öffnet eine eigene Lektion (JSON)</translation>
    </message>
    <message>
        <source>Open a lesson</source>
        <translation>Eine Lektion öffnen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>To the stop before (Page Up)</source>
        <translation>Zum vorigen Halt (Bild auf)</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>To the next stop (Page Down)</source>
        <translation>Zum nächsten Halt (Bild ab)</translation>
    </message>
    <message>
        <source>Stop of the lesson</source>
        <translation>Halt der Lektion</translation>
    </message>
    <message>
        <source>Choose a lesson</source>
        <translation>Lektion wählen</translation>
    </message>
    <message>
        <source>A lesson opens its own program and stops where there is something to see.</source>
        <translation>Eine Lektion öffnet ihr eigenes Programm und hält, wo es etwas zu sehen gibt.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::MachineChoice</name>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Add machine…</source>
        <translation>Maschine hinzufügen…</translation>
    </message>
    <message>
        <source>As the file says: %1</source>
        <translation>Wie in der Datei: %1</translation>
    </message>
    <message>
        <source>As the file says</source>
        <translation>Wie in der Datei</translation>
    </message>
    <message>
        <source>Machine: %1. Another one checks the program again and feeds its own loop lengths.</source>
        <translation>Maschine: %1. Eine andere prüft das Programm neu und liefert ihre eigenen Fadenlängen.</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::MainWindow</name>
    <message>
        <source>KnittSim</source>
        <translation>KnittSim</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Gestrick</translation>
    </message>
    <message>
        <source>%1 columns, %2 courses, %3, %4 problems</source>
        <translation>%1 Spalten, %2 Reihen, %3, %4 Probleme</translation>
    </message>
    <message>
        <source>Qt, flat</source>
        <translation>Qt, flach</translation>
    </message>
    <message>
        <source>Tape: %1</source>
        <translation>Maßband: %1</translation>
    </message>
    <message>
        <source>%1 could not be opened.</source>
        <translation>%1 konnte nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>%1 stays open.</source>
        <translation>%1 bleibt geöffnet.</translation>
    </message>
    <message>
        <source>Show the place</source>
        <translation>Stelle zeigen</translation>
    </message>
    <message>
        <source>Problems (%1)</source>
        <translation>Probleme (%1)</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>Charts and machine programs (*.knitt *.k *.knitout *.dat *.kc *.sin);;WKT of 1998 is not publicly documented: knitout or Sintral text fills its place (*.k *.sin);;All files (*)</source>
        <translation>Patronen und Strickprogramme (*.knitt *.k *.knitout *.dat *.kc *.sin);;WKT von 1998 ist nicht öffentlich dokumentiert: Knitout oder Sintral-Text tritt an seine Stelle (*.k *.sin);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open a chart or a machine program</source>
        <translation>Patrone oder Strickprogramm öffnen</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;New chart…</source>
        <translation>&amp;Neue Patrone…</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Öffnen…</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Samples</source>
        <translation>&amp;Muster</translation>
    </message>
    <message>
        <source>Sample &amp;gallery</source>
        <translation>Muster&amp;galerie</translation>
    </message>
    <message>
        <source>Ctrl+Shift+O</source>
        <translation>Ctrl+Shift+O</translation>
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
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>Export &amp;machine data…</source>
        <translation>&amp;Maschinendaten ausgeben…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+D</source>
        <translation>Ctrl+Shift+D</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Ausgeben…</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>Export &amp;report…</source>
        <translation>&amp;Bericht ausgeben…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Ctrl+Q</source>
        <translation>Ctrl+Q</translation>
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
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z</source>
        <translation>Ctrl+Shift+Z</translation>
    </message>
    <message>
        <source>&amp;Find a yarn</source>
        <translation>Garn &amp;finden</translation>
    </message>
    <message>
        <source>Select &amp;nothing</source>
        <translation>&amp;Nichts auswählen</translation>
    </message>
    <message>
        <source>Next &amp;problem</source>
        <translation>Nächstes &amp;Problem</translation>
    </message>
    <message>
        <source>Pre&amp;vious problem</source>
        <translation>&amp;Voriges Problem</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Vorn</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Hinten</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Rechts</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Links</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>&amp;Unten</translation>
    </message>
    <message>
        <source>Ort&amp;hographic</source>
        <translation>&amp;Parallelperspektive</translation>
    </message>
    <message>
        <source>Fit the fa&amp;bric</source>
        <translation>&amp;Gestrick einpassen</translation>
    </message>
    <message>
        <source>&amp;Centre on the selection</source>
        <translation>Auswahl in die &amp;Mitte</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Ver&amp;größern</translation>
    </message>
    <message>
        <source>Zoom o&amp;ut</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>Fit the &amp;pattern grid</source>
        <translation>Pa&amp;trone einpassen</translation>
    </message>
    <message>
        <source>Lit &amp;yarn</source>
        <translation>Beleuchtetes &amp;Garn</translation>
    </message>
    <message>
        <source>Three &amp;strokes</source>
        <translation>Drei &amp;Striche</translation>
    </message>
    <message>
        <source>Bonding points and &amp;mesh</source>
        <translation>Bindungspunkte und &amp;Netz</translation>
    </message>
    <message>
        <source>Yarn &amp;tension as colour</source>
        <translation>Faden&amp;spannung als Farbe</translation>
    </message>
    <message>
        <source>Contact force as colour</source>
        <translation>Kontaktkraft als Farbe</translation>
    </message>
    <message>
        <source>How hard other yarn presses, when settled as yarn (Shift+T)</source>
        <translation>Wie stark anderes Garn drückt, wenn als Garn entspannt (Umschalt+T)</translation>
    </message>
    <message>
        <source>H&amp;istory of the selected bonding point</source>
        <translation>&amp;Geschichte des gewählten Bindungspunkts</translation>
    </message>
    <message>
        <source>Shows the needle beds while they work (N)</source>
        <translation>Zeigt die Nadelbetten bei der Arbeit (N)</translation>
    </message>
    <message>
        <source>Follo&amp;w the working needle</source>
        <translation>Der arbeitenden Nadel &amp;folgen</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>&amp;Erscheinungsbild</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Wie das &amp;System</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>&amp;Machine</source>
        <translation>&amp;Maschine</translation>
    </message>
    <message>
        <source>&amp;Play the operations</source>
        <translation>&amp;Abspielen</translation>
    </message>
    <message>
        <source>&amp;Slower</source>
        <translation>&amp;Langsamer</translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation>&amp;Schneller</translation>
    </message>
    <message>
        <source>Operation &amp;forward</source>
        <translation>Schritt &amp;vor</translation>
    </message>
    <message>
        <source>Operation &amp;back</source>
        <translation>Schritt &amp;zurück</translation>
    </message>
    <message>
        <source>Pa&amp;ss forward</source>
        <translation>&amp;Fahrt vor</translation>
    </message>
    <message>
        <source>Pass bac&amp;k</source>
        <translation>Fahrt zu&amp;rück</translation>
    </message>
    <message>
        <source>&amp;Course forward</source>
        <translation>Reihe v&amp;or</translation>
    </message>
    <message>
        <source>C&amp;ourse back</source>
        <translation>Reihe z&amp;urück</translation>
    </message>
    <message>
        <source>To the &amp;empty machine</source>
        <translation>Zur &amp;leeren Maschine</translation>
    </message>
    <message>
        <source>To the e&amp;nd of the program</source>
        <translation>Zum &amp;Ende des Programms</translation>
    </message>
    <message>
        <source>&amp;Go to line…</source>
        <translation>&amp;Gehe zu Zeile…</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>&amp;Add machine…</source>
        <translation>Maschine &amp;hinzufügen…</translation>
    </message>
    <message>
        <source>&amp;Simulate</source>
        <translation>&amp;Simulieren</translation>
    </message>
    <message>
        <source>&amp;Start or pause</source>
        <translation>&amp;Start oder Pause</translation>
    </message>
    <message>
        <source>One s&amp;tep</source>
        <translation>Ein &amp;Schritt</translation>
    </message>
    <message>
        <source>&amp;Restart from the machine</source>
        <translation>&amp;Neu von der Maschine</translation>
    </message>
    <message>
        <source>St&amp;op</source>
        <translation>&amp;Halt</translation>
    </message>
    <message>
        <source>Settle as &amp;yarn</source>
        <translation>Als &amp;Garn entspannen</translation>
    </message>
    <message>
        <source>Pull &amp;test…</source>
        <translation>&amp;Zugversuch…</translation>
    </message>
    <message>
        <source>Force against strain of a repeat of the fabric (Ctrl+P)</source>
        <translation>Kraft über Dehnung eines Rapports (Strg+P)</translation>
    </message>
    <message>
        <source>S&amp;urroundings of the yarn</source>
        <translation>&amp;Umgebung des Garns</translation>
    </message>
    <message>
        <source>&amp;Integrator</source>
        <translation>&amp;Integrator</translation>
    </message>
    <message>
        <source>Remove &amp;ladders</source>
        <translation>&amp;Laufmaschen entfernen</translation>
    </message>
    <message>
        <source>Stitch &amp;holder</source>
        <translation>Maschen&amp;halter</translation>
    </message>
    <message>
        <source>&amp;Pull the yarn with the mouse</source>
        <translation>Mit der &amp;Maus am Faden ziehen</translation>
    </message>
    <message>
        <source>P&amp;in the selected bonding point, or free it</source>
        <translation>&amp;Gewählten Punkt feststecken oder lösen</translation>
    </message>
    <message>
        <source>Re&amp;move all pins</source>
        <translation>Alle Stecknadeln &amp;entfernen</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Fenster</translation>
    </message>
    <message>
        <source>&amp;Designer</source>
        <translation>&amp;Entwurf</translation>
    </message>
    <message>
        <source>&amp;Teacher</source>
        <translation>&amp;Unterricht</translation>
    </message>
    <message>
        <source>&amp;Quality assurance</source>
        <translation>&amp;Prüfung</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Tasten</translation>
    </message>
    <message>
        <source>&amp;About KnittSim</source>
        <translation>&amp;Über KnittSim</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Muster</translation>
    </message>
    <message>
        <source>Shows the list of problems</source>
        <translation>Zeigt die Liste der Probleme</translation>
    </message>
    <message>
        <source>&amp;Forget these files</source>
        <translation>Diese Dateien &amp;vergessen</translation>
    </message>
    <message>
        <source>Pau&amp;se</source>
        <translation>Pau&amp;se</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Start</translation>
    </message>
    <message>
        <source>Pause the simulation (F5)</source>
        <translation>Simulation anhalten (F5)</translation>
    </message>
    <message>
        <source>Start the simulation (F5)</source>
        <translation>Simulation starten (F5)</translation>
    </message>
    <message>
        <source>Skip to the end of the &amp;ladder</source>
        <translation>Zum Ende der &amp;Laufmasche</translation>
    </message>
    <message>
        <source>No problems</source>
        <translation>Keine Probleme</translation>
    </message>
    <message>
        <source>1 problem</source>
        <translation>1 Problem</translation>
    </message>
    <message>
        <source>%1 problems</source>
        <translation>%1 Probleme</translation>
    </message>
    <message>
        <source>1 note</source>
        <translation>1 Hinweis</translation>
    </message>
    <message>
        <source>%1 notes</source>
        <translation>%1 Hinweise</translation>
    </message>
    <message>
        <source>%1 exists. Replace it?</source>
        <translation>%1 gibt es schon. Ersetzen?</translation>
    </message>
    <message>
        <source>&amp;Pattern</source>
        <translation>&amp;Patrone</translation>
    </message>
    <message>
        <source>%1[*] – KnittSim</source>
        <translation>%1[*] – KnittSim</translation>
    </message>
    <message>
        <source>New chart</source>
        <translation>Neue Patrone</translation>
    </message>
    <message>
        <source>Save the chart</source>
        <translation>Patrone speichern</translation>
    </message>
    <message>
        <source>Charts (*.knitt)</source>
        <translation>Patronen (*.knitt)</translation>
    </message>
    <message>
        <source>%1 could not be saved. %2</source>
        <translation>%1 konnte nicht gespeichert werden. %2</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>The program of the chart is not ready yet.</source>
        <translation>Das Programm der Patrone ist noch nicht fertig.</translation>
    </message>
    <message>
        <source>The chart cannot be knitted as it is: there is no machine data.</source>
        <translation>Die Patrone kann so nicht gestrickt werden: es gibt keine Maschinendaten.</translation>
    </message>
    <message>
        <source>Export machine data</source>
        <translation>Maschinendaten ausgeben</translation>
    </message>
    <message>
        <source>Knitout (*.k *.knitout)</source>
        <translation>Knitout (*.k *.knitout)</translation>
    </message>
    <message>
        <source>Shima DAT (*.dat)</source>
        <translation>Shima DAT (*.dat)</translation>
    </message>
    <message>
        <source>Kniterate k-code (*.kc)</source>
        <translation>Kniterate k-code (*.kc)</translation>
    </message>
    <message>
        <source>The machine data cannot be written. %1</source>
        <translation>Die Maschinendaten können nicht geschrieben werden. %1</translation>
    </message>
    <message>
        <source>Unsaved work on %1 of %2 was found.</source>
        <translation>Nicht gespeicherte Arbeit an %1 vom %2 wurde gefunden.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>%1 has changes that are not saved.</source>
        <translation>%1 hat Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Patrone</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelltext</translation>
    </message>
    <message>
        <source>Yarns</source>
        <translation>Garne</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Needle beds</source>
        <translation>Nadelbetten</translation>
    </message>
    <message>
        <source>&amp;Overlays</source>
        <translation>&amp;Einblendungen</translation>
    </message>
    <message>
        <source>Legend of the &amp;mesh</source>
        <translation>Legende des &amp;Netzes</translation>
    </message>
    <message>
        <source>&amp;Dimensions and gauge</source>
        <translation>&amp;Maße und Maschendichte</translation>
    </message>
    <message>
        <source>Signs at &amp;problems</source>
        <translation>Zeichen an &amp;Problemen</translation>
    </message>
    <message>
        <source>&amp;Lines along courses and wales</source>
        <translation>&amp;Linien entlang Reihen und Stäbchen</translation>
    </message>
    <message>
        <source>&amp;Section parallel to the picture</source>
        <translation>&amp;Schnitt parallel zum Bild</translation>
    </message>
    <message>
        <source>Measuring &amp;tape</source>
        <translation>Maß&amp;band</translation>
    </message>
    <message>
        <source>Select a stitch first, or point at one</source>
        <translation>Wähle zuerst eine Masche oder zeige auf eine</translation>
    </message>
    <message>
        <source>%1: hides all but that of the selected stitch</source>
        <translation>%1: verbirgt alles außer dem der gewählten Masche</translation>
    </message>
    <message>
        <source>Only this &amp;yarn</source>
        <translation>Nur dieser &amp;Faden</translation>
    </message>
    <message>
        <source>Only this &amp;course</source>
        <translation>Nur diese &amp;Reihe</translation>
    </message>
    <message>
        <source>%1, %2 mm of yarn in the loop</source>
        <translation>%1, %2 mm Faden in der Schleife</translation>
    </message>
    <message>
        <source>Written to %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>The report cannot be written to %1.</source>
        <translation>Der Bericht kann nicht nach %1 geschrieben werden.</translation>
    </message>
    <message>
        <source>Report written to %1</source>
        <translation>Bericht geschrieben: %1</translation>
    </message>
    <message>
        <source>Export the report</source>
        <translation>Bericht ausgeben</translation>
    </message>
    <message>
        <source>Reports (*.html *.json)</source>
        <translation>Berichte (*.html *.json)</translation>
    </message>
    <message>
        <source>Add a machine</source>
        <translation>Maschine hinzufügen</translation>
    </message>
    <message>
        <source>Machine profiles (*.json);;All files (*)</source>
        <translation>Maschinenprofile (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>%1 is no machine profile that can be used.</source>
        <translation>%1 ist kein brauchbares Maschinenprofil.</translation>
    </message>
    <message>
        <source>And %1 more.</source>
        <translation>Und %1 weitere.</translation>
    </message>
    <message>
        <source>Machine %1 added</source>
        <translation>Maschine %1 hinzugefügt</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>&amp;Lesson</source>
        <translation>&amp;Lektion</translation>
    </message>
    <message>
        <source>&amp;Begin a lesson</source>
        <translation>Lektion &amp;beginnen</translation>
    </message>
    <message>
        <source>&amp;Open a lesson…</source>
        <translation>Lektion &amp;öffnen…</translation>
    </message>
    <message>
        <source>&amp;Next stop</source>
        <translation>&amp;Nächster Halt</translation>
    </message>
    <message>
        <source>Stop be&amp;fore</source>
        <translation>&amp;Voriger Halt</translation>
    </message>
    <message>
        <source>&amp;Words of machine knitting</source>
        <translation>&amp;Wörter des Maschinenstrickens</translation>
    </message>
    <message>
        <source>Open a lesson</source>
        <translation>Eine Lektion öffnen</translation>
    </message>
    <message>
        <source>Lessons (*.json);;All files (*)</source>
        <translation>Lektionen (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>%1 is no lesson that can be used.</source>
        <translation>%1 ist keine brauchbare Lektion.</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>Record an &amp;animation…</source>
        <translation>&amp;Animation aufzeichnen…</translation>
    </message>
    <message>
        <source>Record an animation</source>
        <translation>Animation aufzeichnen</translation>
    </message>
    <message>
        <source>Animated WebP (*.webp)</source>
        <translation>Animiertes WebP (*.webp)</translation>
    </message>
    <message>
        <source>Record &amp;pictures…</source>
        <translation>&amp;Bilder aufzeichnen…</translation>
    </message>
    <message>
        <source>Record pictures: name of a new folder</source>
        <translation>Bilder aufzeichnen: Name eines neuen Ordners</translation>
    </message>
    <message>
        <source>Folder of PNG files (*)</source>
        <translation>Ordner mit PNG-Dateien (*)</translation>
    </message>
    <message>
        <source>Print a &amp;hand-out…</source>
        <translation>&amp;Handzettel drucken…</translation>
    </message>
    <message>
        <source>Print a hand-out</source>
        <translation>Handzettel drucken</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>The range to play, else the bookmarks or the stops of the lesson</source>
        <translation>Der zu spielende Teil, sonst die Lesezeichen oder die Halte der Lektion</translation>
    </message>
    <message>
        <source>The empty machine.</source>
        <translation>Die leere Maschine.</translation>
    </message>
    <message>
        <source>Nothing is chosen yet: set bookmarks (Ctrl+B), mark a range (Shift+Home, Shift+End) or begin a lesson.</source>
        <translation>Noch ist nichts gewählt: setze Lesezeichen (Strg+B), markiere einen Teil (Umschalt+Pos1, Umschalt+Ende) oder beginne eine Lektion.</translation>
    </message>
    <message>
        <source>Recording %1 steps</source>
        <translation>%1 Schritte werden aufgezeichnet</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>E&amp;dit as chart</source>
        <translation>Als Patrone &amp;bearbeiten</translation>
    </message>
    <message>
        <source>Machine data becomes a chart that can be changed; what a chart cannot say is kept</source>
        <translation>Maschinendaten werden zu einer Patrone, die sich ändern lässt; was eine Patrone nicht sagen kann, bleibt</translation>
    </message>
    <message>
        <source>Symb&amp;ols</source>
        <translation>&amp;Zeichen</translation>
    </message>
    <message>
        <source>&amp;Next symbols</source>
        <translation>&amp;Nächste Zeichen</translation>
    </message>
    <message>
        <source>Colum&amp;ns beside the chart</source>
        <translation>&amp;Spalten neben der Patrone</translation>
    </message>
    <message>
        <source>Those that &amp;say something</source>
        <translation>Die etwas &amp;sagen</translation>
    </message>
    <message>
        <source>This is a chart now. Undo brings the machine data back.</source>
        <translation>Das ist jetzt eine Patrone. Rückgängig bringt die Maschinendaten zurück.</translation>
    </message>
    <message>
        <source>Import a picture</source>
        <translation>Bild einlesen</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg);;All files (*)</source>
        <translation>Bilder (*.png *.jpg *.jpeg);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Another program has changed %1 since it was opened. Replace it with what is here?</source>
        <translation>Ein anderes Programm hat %1 geändert, seit es geöffnet wurde. Durch das ersetzen, was hier ist?</translation>
    </message>
    <message>
        <source>Export the chart</source>
        <translation>Patrone ausgeben</translation>
    </message>
    <message>
        <source>PDF pages (*.pdf)</source>
        <translation>PDF-Seiten (*.pdf)</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG-Bild (*.png)</translation>
    </message>
    <message>
        <source>Drawing the chart…</source>
        <translation>Die Patrone wird gezeichnet…</translation>
    </message>
    <message>
        <source>The chart was not exported. %1</source>
        <translation>Die Patrone wurde nicht ausgegeben. %1</translation>
    </message>
    <message>
        <source>Chart written to %1</source>
        <translation>Patrone geschrieben: %1</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Another program has changed %1. Your own changes are not saved yet.</source>
        <translation>Ein anderes Programm hat %1 geändert. Die eigenen Änderungen sind noch nicht gespeichert.</translation>
    </message>
    <message>
        <source>Another program has changed %1.</source>
        <translation>Ein anderes Programm hat %1 geändert.</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Neu laden</translation>
    </message>
    <message>
        <source>Keep what is here</source>
        <translation>Behalten, was hier ist</translation>
    </message>
    <message>
        <source>Reload the file</source>
        <translation>Datei neu laden</translation>
    </message>
    <message>
        <source>Reloading %1 drops the changes made here.</source>
        <translation>Wer %1 neu lädt, verliert die Änderungen von hier.</translation>
    </message>
    <message>
        <source>Save them elsewhere…</source>
        <translation>Anderswo speichern…</translation>
    </message>
    <message>
        <source>Drop them</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Compare side b&amp;y side</source>
        <translation>&amp;Nebeneinander vergleichen</translation>
    </message>
    <message>
        <source>&amp;Keep this state beside</source>
        <translation>Diesen Stand daneben &amp;behalten</translation>
    </message>
    <message>
        <source>Keeps the fabric as it is now beside the one that goes on (Ctrl+K)</source>
        <translation>Behält das Gestrick, wie es jetzt ist, neben dem, das weitergeht (Strg+K)</translation>
    </message>
    <message>
        <source>With another &amp;file…</source>
        <translation>Mit einer anderen &amp;Datei…</translation>
    </message>
    <message>
        <source>With another &amp;yarn…</source>
        <translation>Mit einem anderen &amp;Garn…</translation>
    </message>
    <message>
        <source>&amp;Link the cameras</source>
        <translation>&amp;Kameras verbinden</translation>
    </message>
    <message>
        <source>&amp;Close the comparison</source>
        <translation>Vergleich &amp;schließen</translation>
    </message>
    <message>
        <source>Compare with a chart or a machine program</source>
        <translation>Mit einer Patrone oder einem Strickprogramm vergleichen</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Legende</translation>
    </message>
    <message>
        <source>Steps of the work</source>
        <translation>Arbeitsschritte</translation>
    </message>
    <message>
        <source>What was done, the last step at the end. A click goes there and back again.</source>
        <translation>Was getan wurde, der letzte Schritt am Ende. Ein Klick geht dorthin und wieder zurück.</translation>
    </message>
    <message>
        <source>Click a step to go there; the disk marks what is saved</source>
        <translation>Klick einen Schritt an, um dorthin zu gehen; die Diskette zeigt, was gespeichert ist</translation>
    </message>
    <message>
        <source>As it was opened</source>
        <translation>Wie geöffnet</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>%1 cannot become a chart.</source>
        <translation>%1 kann keine Patrone werden.</translation>
    </message>
    <message>
        <source>&amp;Import a picture…</source>
        <translation>Bild &amp;einlesen…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+I</source>
        <translation>Ctrl+Alt+I</translation>
    </message>
    <message>
        <source>Export &amp;chart…</source>
        <translation>P&amp;atrone ausgeben…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+P</source>
        <translation>Ctrl+Shift+P</translation>
    </message>
    <message>
        <source>The chart with legend and yarn amounts as PDF or PNG (Ctrl+Shift+P)</source>
        <translation>Die Patrone mit Legende und Garnmengen als PDF oder PNG (Strg+Umschalt+P)</translation>
    </message>
    <message>
        <source>Photo&amp;graph</source>
        <translation>&amp;Foto</translation>
    </message>
    <message>
        <source>&amp;Open a photograph…</source>
        <translation>Foto &amp;öffnen…</translation>
    </message>
    <message>
        <source>&amp;Show the photograph</source>
        <translation>Foto &amp;zeigen</translation>
    </message>
    <message>
        <source>&amp;Align by two points</source>
        <translation>An zwei Punkten &amp;ausrichten</translation>
    </message>
    <message>
        <source>Open a photograph</source>
        <translation>Foto öffnen</translation>
    </message>
    <message>
        <source>Photographs (*.png *.jpg *.jpeg);;All files (*)</source>
        <translation>Fotos (*.png *.jpg *.jpeg);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>The photograph %1 cannot be opened: %2.</source>
        <translation>Das Foto %1 kann nicht geöffnet werden: %2.</translation>
    </message>
    <message>
        <source>&amp;Speak the operations</source>
        <translation>Schritte &amp;sprechen</translation>
    </message>
    <message>
        <source>Speaks each operation that is shown, in the language of the window (Shift+S)</source>
        <translation>Spricht jeden gezeigten Schritt, in der Sprache des Fensters (Umschalt+S)</translation>
    </message>
    <message>
        <source>Fu&amp;zz of hairy yarn</source>
        <translation>&amp;Flaum von haarigem Garn</translation>
    </message>
    <message>
        <source>Loose fibres around hairy yarn, seen near by (Z)</source>
        <translation>Lose Fasern um haariges Garn, aus der Nähe zu sehen (Z)</translation>
    </message>
    <message>
        <source>Speed of settling as colour</source>
        <translation>Tempo des Entspannens als Farbe</translation>
    </message>
    <message>
        <source>How far the yarn has moved since the last picture (Ctrl+Shift+Y)</source>
        <translation>Wie weit sich das Garn seit dem letzten Bild bewegt hat (Strg+Umschalt+Y)</translation>
    </message>
    <message>
        <source>Na&amp;med views</source>
        <translation>&amp;Benannte Ansichten</translation>
    </message>
    <message>
        <source>&amp;Save this view…</source>
        <translation>Diese Ansicht &amp;speichern…</translation>
    </message>
    <message>
        <source>&amp;Rename or delete…</source>
        <translation>&amp;Umbenennen oder löschen…</translation>
    </message>
    <message>
        <source>Save this view</source>
        <translation>Diese Ansicht speichern</translation>
    </message>
    <message>
        <source>Name of the view; one of the same name is replaced:</source>
        <translation>Name der Ansicht; eine mit demselben Namen wird ersetzt:</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Ansicht %1</translation>
    </message>
    <message>
        <source>View “%1” saved</source>
        <translation>Ansicht „%1“ gespeichert</translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <translation>&amp;Automatisch</translation>
    </message>
    <message>
        <source>As fine as the width of the yarn on the screen can show</source>
        <translation>So fein, wie die Breite des Garns auf dem Bildschirm es zeigen kann</translation>
    </message>
    <message>
        <source>Full &amp;yarn</source>
        <translation>Volles &amp;Garn</translation>
    </message>
    <message>
        <source>Plies and fibres at any distance; the slowest</source>
        <translation>Zwirn und Fasern in jeder Entfernung; am langsamsten</translation>
    </message>
    <message>
        <source>Plain &amp;tubes</source>
        <translation>Glatte &amp;Röhren</translation>
    </message>
    <message>
        <source>Round yarn without plies at any distance</source>
        <translation>Rundes Garn ohne Zwirn in jeder Entfernung</translation>
    </message>
    <message>
        <source>&amp;Strokes</source>
        <translation>&amp;Striche</translation>
    </message>
    <message>
        <source>Flat bands at any distance; the fastest</source>
        <translation>Flache Bänder in jeder Entfernung; am schnellsten</translation>
    </message>
    <message>
        <source>&amp;Detail of the yarn</source>
        <translation>&amp;Feinheit des Garns</translation>
    </message>
    <message>
        <source>full yarn</source>
        <translation>volles Garn</translation>
    </message>
    <message>
        <source>plain tubes</source>
        <translation>glatte Röhren</translation>
    </message>
    <message>
        <source>strokes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>An animation has %1 steps at most, and %2 are chosen: mark a shorter range, or record numbered pictures.</source>
        <translation>Eine Animation hat höchstens %1 Schritte, gewählt sind %2: markiere einen kürzeren Teil oder zeichne nummerierte Bilder auf.</translation>
    </message>
    <message>
        <source>Ne&amp;xt colourway</source>
        <translation>Nä&amp;chste Farbstellung</translation>
    </message>
    <message>
        <source>out of date: the chart has changed</source>
        <translation>veraltet: die Patrone ist geändert</translation>
    </message>
    <message>
        <source>preview: the yarn has not settled yet</source>
        <translation>Vorschau: das Garn ist noch nicht in Ruhe</translation>
    </message>
    <message>
        <source>Saved %1, without a shape: the fabric is not at rest</source>
        <translation>%1 gespeichert, ohne Form: das Gestrick ist nicht in Ruhe</translation>
    </message>
    <message>
        <source>Keep the settled s&amp;hape in the file</source>
        <translation>&amp;Form in Ruhe mit in die Datei</translation>
    </message>
    <message>
        <source>The fabric lies there at once when the file is opened again</source>
        <translation>Das Gestrick liegt beim nächsten Öffnen sofort so da</translation>
    </message>
    <message>
        <source>Machine data for %1 written to %2</source>
        <translation>Maschinendaten für %1 nach %2 geschrieben</translation>
    </message>
    <message>
        <source>%1 is written, but %2 will not knit it without problems (%3 errors). %4</source>
        <translation>%1 ist geschrieben, aber %2 strickt es nicht ohne Probleme (%3 Fehler). %4</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::NeedleBeds</name>
    <message>
        <source>Needle beds</source>
        <translation>Nadelbetten</translation>
    </message>
    <message>
        <source>Empty machine</source>
        <translation>Leere Maschine</translation>
    </message>
    <message>
        <source>rear</source>
        <translation>hinten</translation>
    </message>
    <message>
        <source>front</source>
        <translation>vorn</translation>
    </message>
    <message>
        <source>rack</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>%1: no loop</source>
        <translation>%1: keine Schleife</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n loop(s)</source>
        <translation>
            <numerusform>%1: %n Schleife</numerusform>
            <numerusform>%1: %n Schleifen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::NewChartDialog</name>
    <message>
        <source>New chart</source>
        <translation>Neue Patrone</translation>
    </message>
    <message>
        <source>Needles across</source>
        <translation>Nadeln quer</translation>
    </message>
    <message>
        <source>Courses up</source>
        <translation>Reihen nach oben</translation>
    </message>
    <message>
        <source>The stitches that it begins with</source>
        <translation>Die Maschen, mit denen sie beginnt</translation>
    </message>
    <message>
        <source>&amp;Wales</source>
        <translation>&amp;Stäbchen</translation>
    </message>
    <message>
        <source>&amp;Courses</source>
        <translation>&amp;Reihen</translation>
    </message>
    <message>
        <source>&amp;Ground</source>
        <translation>&amp;Grund</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>Anlegen</translation>
    </message>
    <message>
        <source>Single: knit, purl, colours, cables, lace</source>
        <translation>Einfach: rechts, links, Farben, Zöpfe, Lochmuster</translation>
    </message>
    <message>
        <source>Double: full ribs, tubes, jacquard with a back</source>
        <translation>Doppelt: volle Rippen, Schläuche, Jacquard mit Rückseite</translation>
    </message>
    <message>
        <source>Double: front and rear needle of each wale knit side by side; Pattern &gt; Work on both beds changes it</source>
        <translation>Doppelt: vordere und hintere Nadel jedes Stäbchens stricken nebeneinander; Patrone &gt; Auf beiden Betten arbeiten ändert es</translation>
    </message>
    <message>
        <source>&amp;Fabric</source>
        <translation>Gestric&amp;k</translation>
    </message>
    <message>
        <source> stitches across</source>
        <translation> Maschen breit</translation>
    </message>
    <message>
        <source> rows up</source>
        <translation> Reihen hoch</translation>
    </message>
    <message>
        <source>Colours to draw with; more can be added at any time</source>
        <translation>Farben zum Zeichnen; weitere jederzeit</translation>
    </message>
    <message>
        <source>&amp;Yarns</source>
        <translation>G&amp;arne</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::OpeningCard</name>
    <message>
        <source>Reading the file</source>
        <translation>Die Datei wird gelesen</translation>
    </message>
    <message>
        <source>Running the machine</source>
        <translation>Die Maschine läuft</translation>
    </message>
    <message>
        <source>Building the fabric</source>
        <translation>Das Gestrick wird aufgebaut</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stops opening this file; what was open stays</source>
        <translation>Bricht das Öffnen dieser Datei ab; was geöffnet war, bleibt</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::Overlay</name>
    <message>
        <source>technical face</source>
        <translation>rechte Warenseite</translation>
    </message>
    <message>
        <source>technical back</source>
        <translation>linke Warenseite</translation>
    </message>
    <message>
        <source>seen from its edge</source>
        <translation>von der Kante gesehen</translation>
    </message>
    <message>
        <source>courses, numbered</source>
        <translation>Reihen, nummeriert</translation>
    </message>
    <message>
        <source>wales, numbered</source>
        <translation>Stäbchen, nummeriert</translation>
    </message>
    <message>
        <source>× error, ! warning</source>
        <translation>× Fehler, ! Warnung</translation>
    </message>
    <message>
        <source>section: Alt and wheel move it</source>
        <translation>Schnitt: Alt und Mausrad verschieben ihn</translation>
    </message>
    <message>
        <source>tape: click the second point</source>
        <translation>Maßband: klick den zweiten Punkt</translation>
    </message>
    <message>
        <source>tape: click the first point</source>
        <translation>Maßband: klick den ersten Punkt</translation>
    </message>
    <message>
        <source>foot in a head: a loop drawn through</source>
        <translation>Fuß im Kopf: eine durchgezogene Schleife</translation>
    </message>
    <message>
        <source>head, nothing through it</source>
        <translation>Kopf, durch den nichts geht</translation>
    </message>
    <message>
        <source>crossing: the unbroken yarn lies in front</source>
        <translation>Kreuzung: der ungebrochene Faden liegt vorn</translation>
    </message>
    <message>
        <source>Yarn tension (mN)</source>
        <translation>Fadenspannung (mN)</translation>
    </message>
    <message>
        <source>Contact force (mN/mm)</source>
        <translation>Kontaktkraft (mN/mm)</translation>
    </message>
    <message>
        <source>Not known for this shape yet</source>
        <translation>Für diese Form noch nicht bekannt</translation>
    </message>
    <message>
        <source>course</source>
        <translation>Reihe</translation>
    </message>
    <message>
        <source>wale</source>
        <translation>Stäbchen</translation>
    </message>
    <message>
        <source>click a point of the photograph</source>
        <translation>klick einen Punkt des Fotos</translation>
    </message>
    <message>
        <source>click the same point of the fabric</source>
        <translation>klick denselben Punkt des Gestricks</translation>
    </message>
    <message>
        <source>click a second point of the photograph</source>
        <translation>klick einen zweiten Punkt des Fotos</translation>
    </message>
    <message>
        <source>click the second point of the fabric</source>
        <translation>klick den zweiten Punkt des Gestricks</translation>
    </message>
    <message>
        <source>photograph beside</source>
        <translation>Foto daneben</translation>
    </message>
    <message>
        <source>photograph over it</source>
        <translation>Foto darüber</translation>
    </message>
    <message>
        <source>Moved since the last picture (mm)</source>
        <translation>Seit dem letzten Bild bewegt (mm)</translation>
    </message>
    <message>
        <source>Nothing has moved</source>
        <translation>Nichts hat sich bewegt</translation>
    </message>
    <message>
        <source>%1 mm (%2 in)</source>
        <translation>%1 mm (%2 in)</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::PatternGrid</name>
    <message>
        <source>Pattern grid</source>
        <translation>Patrone</translation>
    </message>
    <message>
        <source>Needles across, courses up, one cell a stitch. Click selects a stitch; Ctrl and the wheel zoom.</source>
        <translation>Nadeln quer, Reihen nach oben, ein Feld je Masche. Ein Klick wählt eine Masche; Strg und Mausrad vergrößern.</translation>
    </message>
    <message>
        <source>Needle %1, course %2: miss, carrier %3 floats past</source>
        <translation>Nadel %1, Reihe %2: ausgelassen, Fadenführer %3 flottet vorbei</translation>
    </message>
    <message>
        <source>This program makes no stitches.</source>
        <translation>Dieses Programm bildet keine Maschen.</translation>
    </message>
    <message>
        <source>Nothing is open.</source>
        <translation>Nichts ist geöffnet.</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::PhotographCard</name>
    <message>
        <source>How strongly the photograph covers the fabric</source>
        <translation>Wie stark das Foto das Gestrick verdeckt</translation>
    </message>
    <message>
        <source>Wipes the photograph away from the left</source>
        <translation>Wischt das Foto von links weg</translation>
    </message>
    <message>
        <source>&amp;Beside the fabric</source>
        <translation>&amp;Neben dem Gestrick</translation>
    </message>
    <message>
        <source>Photograph</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source>On the right of the fabric in the same scale, instead of over it</source>
        <translation>Rechts neben dem Gestrick im selben Maßstab, statt darüber</translation>
    </message>
    <message>
        <source>&amp;Align…</source>
        <translation>&amp;Ausrichten…</translation>
    </message>
    <message>
        <source>Two points of the photograph on two of the fabric (Shift+W)</source>
        <translation>Zwei Punkte des Fotos auf zwei des Gestricks (Umschalt+W)</translation>
    </message>
    <message>
        <source>&amp;Other…</source>
        <translation>An&amp;deres…</translation>
    </message>
    <message>
        <source>Opens another photograph (Ctrl+Alt+P)</source>
        <translation>Öffnet ein anderes Foto (Strg+Alt+P)</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Forgets the photograph</source>
        <translation>Vergisst das Foto</translation>
    </message>
    <message>
        <source>Hides the photograph; W shows it again</source>
        <translation>Verbirgt das Foto; W zeigt es wieder</translation>
    </message>
    <message>
        <source>Hide the photograph</source>
        <translation>Foto verbergen</translation>
    </message>
    <message>
        <source>O&amp;pacity</source>
        <translation>De&amp;ckkraft</translation>
    </message>
    <message>
        <source>&amp;Wipe</source>
        <translation>&amp;Wischen</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::PictureDialog</name>
    <message>
        <source>Import %1</source>
        <translation>%1 einlesen</translation>
    </message>
    <message>
        <source>Preview of the chart</source>
        <translation>Vorschau der Patrone</translation>
    </message>
    <message>
        <source>Stitches across</source>
        <translation>Maschen quer</translation>
    </message>
    <message>
        <source>Stitches up</source>
        <translation>Maschen nach oben</translation>
    </message>
    <message>
        <source>&amp;Keep the proportions</source>
        <translation>Ver&amp;hältnis behalten</translation>
    </message>
    <message>
        <source>Circles stay round: the courses follow from the wales and the gauge</source>
        <translation>Kreise bleiben rund: die Reihen folgen aus den Stäbchen und der Maschendichte</translation>
    </message>
    <message>
        <source>Gauge of the knitted fabric: how high a stitch is for its width</source>
        <translation>Maschendichte des Gestricks: wie hoch eine Masche für ihre Breite ist</translation>
    </message>
    <message>
        <source>Where the colours come from</source>
        <translation>Woher die Farben kommen</translation>
    </message>
    <message>
        <source>Found in the picture</source>
        <translation>Im Bild gefunden</translation>
    </message>
    <message>
        <source>Yarns of the open chart</source>
        <translation>Garne der offenen Patrone</translation>
    </message>
    <message>
        <source>Each colour needs a carrier</source>
        <translation>Jede Farbe braucht einen Fadenführer</translation>
    </message>
    <message>
        <source>&amp;Mix colours by dots</source>
        <translation>Farben durch Punkte &amp;mischen</translation>
    </message>
    <message>
        <source>Dithering: shades between the yarns from afar, single stitches from near</source>
        <translation>Rastern: von fern Töne zwischen den Garnen, von nah einzelne Maschen</translation>
    </message>
    <message>
        <source>How the colours are knitted</source>
        <translation>Wie die Farben gestrickt werden</translation>
    </message>
    <message>
        <source>Float jacquard</source>
        <translation>Jacquard mit Flottungen</translation>
    </message>
    <message>
        <source>Intarsia</source>
        <translation>Intarsie</translation>
    </message>
    <message>
        <source>&amp;Wales</source>
        <translation>&amp;Stäbchen</translation>
    </message>
    <message>
        <source>&amp;Courses</source>
        <translation>&amp;Reihen</translation>
    </message>
    <message>
        <source>Wales in 10 cm</source>
        <translation>Stäbchen auf 10 cm</translation>
    </message>
    <message>
        <source>Courses in 10 cm</source>
        <translation>Reihen auf 10 cm</translation>
    </message>
    <message>
        <source>C&amp;olours</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>&amp;Number of colours</source>
        <translation>&amp;Anzahl der Farben</translation>
    </message>
    <message>
        <source>Knitted &amp;as</source>
        <translation>Gestrickt &amp;als</translation>
    </message>
    <message>
        <source>Make the chart</source>
        <translation>Patrone anlegen</translation>
    </message>
    <message>
        <source>Reading the picture</source>
        <translation>Das Bild wird gelesen</translation>
    </message>
    <message>
        <source>The picture cannot be read: %1.</source>
        <translation>Das Bild kann nicht gelesen werden: %1.</translation>
    </message>
    <message>
        <source>%1 x %2 stitches, about %3 x %4 cm.</source>
        <translation>%1 x %2 Maschen, etwa %3 x %4 cm.</translation>
    </message>
    <message>
        <source>The picture has no more colours than %1.</source>
        <translation>Das Bild hat nicht mehr Farben als %1.</translation>
    </message>
    <message>
        <source>Yarns that do not show float behind the stitches</source>
        <translation>Fäden, die nicht zu sehen sind, flotten hinter den Maschen</translation>
    </message>
    <message>
        <source>Every yarn stays in its own zone</source>
        <translation>Jeder Faden bleibt in seinem Feld</translation>
    </message>
    <message>
        <source>Birdseye back</source>
        <translation>Jacquard mit Pfauenaugen-Rückseite</translation>
    </message>
    <message>
        <source>Both beds: yarns that do not show knit every second needle behind</source>
        <translation>Beide Betten: hinten strickt jeder Faden jede zweite Nadel</translation>
    </message>
    <message>
        <source>Ladder back</source>
        <translation>Jacquard mit Leiter-Rückseite</translation>
    </message>
    <message>
        <source>Both beds: yarns that do not show knit every fourth needle behind</source>
        <translation>Beide Betten: hinten strickt jede vierte Nadel einen Faden, der vorn nicht zu sehen ist</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::PngSink</name>
    <message>
        <source>%1 exists already; choose another name.</source>
        <translation>%1 gibt es schon; wähle einen anderen Namen.</translation>
    </message>
    <message>
        <source>A picture cannot be written to %1.</source>
        <translation>Ein Bild kann nicht nach %1 geschrieben werden.</translation>
    </message>
    <message>
        <source>The pictures cannot be written to %1.</source>
        <translation>Die Bilder können nicht nach %1 geschrieben werden.</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::PullDialog</name>
    <message>
        <source>Pull test</source>
        <translation>Zugversuch</translation>
    </message>
    <message>
        <source>Draws one repeat of the fabric longer in the yarn model and lets it back, as a strip far from its grips.</source>
        <translation>Zieht einen Rapport des Gestricks im Garnmodell länger und lässt ihn zurück, als Streifen fern von seinen Klemmen.</translation>
    </message>
    <message>
        <source>Left and right, along the courses</source>
        <translation>Links und rechts, entlang der Reihen</translation>
    </message>
    <message>
        <source>Top and bottom, along the wales</source>
        <translation>Oben und unten, entlang der Stäbchen</translation>
    </message>
    <message>
        <source>The two opposite sides that are pulled; the others are free</source>
        <translation>Die zwei gegenüberliegenden Seiten, an denen gezogen wird; die anderen sind frei</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Largest strain, of the size at rest</source>
        <translation>Größte Dehnung, bezogen auf die Größe in Ruhe</translation>
    </message>
    <message>
        <source>Points up to the largest strain, and as many back</source>
        <translation>Punkte bis zur größten Dehnung und ebenso viele zurück</translation>
    </message>
    <message>
        <source>Pulled &amp;sides</source>
        <translation>Gezogene &amp;Seiten</translation>
    </message>
    <message>
        <source>S&amp;train</source>
        <translation>&amp;Dehnung</translation>
    </message>
    <message>
        <source>Ste&amp;ps</source>
        <translation>S&amp;chritte</translation>
    </message>
    <message>
        <source>Progress of the pull test</source>
        <translation>Fortschritt des Zugversuchs</translation>
    </message>
    <message>
        <source>&amp;Pull</source>
        <translation>&amp;Ziehen</translation>
    </message>
    <message>
        <source>&amp;Write CSV…</source>
        <translation>&amp;CSV schreiben…</translation>
    </message>
    <message>
        <source>Writes strain, force and size of every point as comma-separated values</source>
        <translation>Schreibt Dehnung, Kraft und Größe jedes Punkts als kommagetrennte Werte</translation>
    </message>
    <message>
        <source>Ends the test (Esc)</source>
        <translation>Beendet den Versuch (Esc)</translation>
    </message>
    <message>
        <source>Sto&amp;p</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>Ends the test and keeps its points</source>
        <translation>Beendet den Versuch und behält seine Punkte</translation>
    </message>
    <message>
        <source>Starts the test</source>
        <translation>Beginnt den Versuch</translation>
    </message>
    <message>
        <source>A repeat of %1 × %2 stitches</source>
        <translation>Ein Rapport aus %1 × %2 Maschen</translation>
    </message>
    <message>
        <source>Some seconds for a small repeat.</source>
        <translation>Einige Sekunden für einen kleinen Rapport.</translation>
    </message>
    <message>
        <source>The repeat comes to rest…</source>
        <translation>Der Rapport kommt zur Ruhe…</translation>
    </message>
    <message>
        <source>%1, point %2 of at most %3</source>
        <translation>%1, Punkt %2 von höchstens %3</translation>
    </message>
    <message>
        <source>%1: %2 N/mm at %3 %</source>
        <translation>%1: %2 N/mm bei %3 %</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Most of the fabric would have to be knit and purl stitches of one yarn that repeat themselves.</source>
        <translation>Das Gestrick müsste zum größten Teil aus rechten und linken Maschen eines Garns bestehen, die sich wiederholen.</translation>
    </message>
    <message>
        <source>The repeat does not come to rest; the points up to there are kept.</source>
        <translation>Der Rapport kommt nicht zur Ruhe; die Punkte bis dahin bleiben.</translation>
    </message>
    <message>
        <source>Write the pull test</source>
        <translation>Zugversuch schreiben</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>Kommagetrennte Werte (*.csv)</translation>
    </message>
    <message>
        <source>Written to %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>%1 kann nicht geschrieben werden.</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::PullPlot</name>
    <message>
        <source>Force against strain</source>
        <translation>Kraft über Dehnung</translation>
    </message>
    <message>
        <source>Force by width of the fabric against strain: drawn longer (full line) and back (dashed)</source>
        <translation>Kraft je Breite des Gestricks über der Dehnung: länger gezogen (durchgezogen) und zurück (gestrichelt)</translation>
    </message>
    <message>
        <source>Force (N/mm)</source>
        <translation>Kraft (N/mm)</translation>
    </message>
    <message>
        <source>Strain (%)</source>
        <translation>Dehnung (%)</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::Recorder</name>
    <message>
        <source>There is no step to record.</source>
        <translation>Es gibt keinen Schritt aufzuzeichnen.</translation>
    </message>
    <message>
        <source>The program changed while it was recorded.</source>
        <translation>Das Programm hat sich während der Aufzeichnung geändert.</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::SheetPainter</name>
    <message>
        <source>Carrier %1: %2</source>
        <translation>Fadenführer %1: %2</translation>
    </message>
    <message>
        <source>%1, %2 m, %3 g</source>
        <translation>%1, %2 m, %3 g</translation>
    </message>
    <message>
        <source>Needles %1 to %2, courses %3 to %4 – page %5 of %6</source>
        <translation>Nadeln %1 bis %2, Reihen %3 bis %4 – Seite %5 von %6</translation>
    </message>
    <message>
        <source>%1 wales x %2 courses</source>
        <translation>%1 Stäbchen x %2 Reihen</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::SideEditor</name>
    <message>
        <source>A whole number from %1 to %2</source>
        <translation>Eine ganze Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>A number from %1 to %2</source>
        <translation>Eine Zahl von %1 bis %2</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::SimulationPanel</name>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>F5</source>
        <translation>F5</translation>
    </message>
    <message>
        <source>One step of the integrator</source>
        <translation>Ein Schritt des Integrators</translation>
    </message>
    <message>
        <source>F6</source>
        <translation>F6</translation>
    </message>
    <message>
        <source>Restart from the machine</source>
        <translation>Neu von der Maschine</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>Stop and forget the velocity</source>
        <translation>Anhalten und die Geschwindigkeit vergessen</translation>
    </message>
    <message>
        <source>Shift+F5</source>
        <translation>Umschalt+F5</translation>
    </message>
    <message>
        <source>Integrator</source>
        <translation>Integrator</translation>
    </message>
    <message>
        <source>Remove ladders</source>
        <translation>Laufmaschen entfernen</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Strg+L</translation>
    </message>
    <message>
        <source>Settle as yarn</source>
        <translation>Als Garn entspannen</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Surroundings of the yarn</source>
        <translation>Umgebung des Garns</translation>
    </message>
    <message>
        <source>Stitch holder</source>
        <translation>Maschenhalter</translation>
    </message>
    <message>
        <source>%1 (Ctrl+Shift+L)</source>
        <translation>%1 (Strg+Umschalt+L)</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Step %1 · %2 ms each</source>
        <translation>Schritt %1 · je %2 ms</translation>
    </message>
    <message>
        <source> · dt %1 s</source>
        <translation> · dt %1 s</translation>
    </message>
    <message>
        <source>Integrator. %1</source>
        <translation>Integrator. %1</translation>
    </message>
    <message>
        <source>Skip to the end</source>
        <translation>Zum Ende springen</translation>
    </message>
    <message>
        <source>Shows the end of the run at once (Ctrl+L); Escape puts the loops back</source>
        <translation>Zeigt gleich das Ende der Laufmasche (Strg+L); Esc nimmt sie zurück</translation>
    </message>
    <message>
        <source>%1 (Ctrl+L)</source>
        <translation>%1 (Strg+L)</translation>
    </message>
    <message>
        <source>Keeps the shape that the yarn has reached (Y)</source>
        <translation>Behält die Form, die das Garn erreicht hat (Y)</translation>
    </message>
    <message>
        <source>%1 (Y)</source>
        <translation>%1 (Y)</translation>
    </message>
    <message>
        <source>What the yarn lies on or hangs from. %1</source>
        <translation>Worauf das Garn liegt oder woran es hängt. %1</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::SourceView</name>
    <message>
        <source>Source text</source>
        <translation>Quelltext</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>This file is not text.</source>
        <translation>Diese Datei ist kein Text.</translation>
    </message>
    <message>
        <source>No text to show.</source>
        <translation>Kein Text zu zeigen.</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::Speaker</name>
    <message>
        <source>This program was built without speech. Install qt6-speech-dev and qt6-declarative-dev and build it anew.</source>
        <translation>Dieses Programm wurde ohne Sprache gebaut. Installiere qt6-speech-dev und qt6-declarative-dev und baue es neu.</translation>
    </message>
    <message>
        <source>Qt finds no speech engine. Install qt6-speech-speechd-plugin and speech-dispatcher.</source>
        <translation>Qt findet kein Sprachprogramm. Installiere qt6-speech-speechd-plugin und speech-dispatcher.</translation>
    </message>
    <message>
        <source>The speech service does not answer. Install speech-dispatcher with a voice such as speech-dispatcher-espeak-ng.</source>
        <translation>Der Sprachdienst antwortet nicht. Installiere speech-dispatcher mit einer Stimme wie speech-dispatcher-espeak-ng.</translation>
    </message>
    <message>
        <source>The speech service has no voice in this language.</source>
        <translation>Der Sprachdienst hat keine Stimme in dieser Sprache.</translation>
    </message>
    <message>
        <source>The empty machine.</source>
        <translation>Die leere Maschine.</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::StatusLine</name>
    <message>
        <source>Needle: f front bed, b rear bed</source>
        <translation>Nadel: f vorderes Bett, b hinteres Bett</translation>
    </message>
    <message>
        <source>needle %1</source>
        <translation>Nadel %1</translation>
    </message>
    <message>
        <source>Fabric course, counted from the first one knitted</source>
        <translation>Reihe des Gestricks, ab der ersten gezählt</translation>
    </message>
    <message>
        <source>course %1</source>
        <translation>Reihe %1</translation>
    </message>
    <message>
        <source>Racking of the rear bed in needle pitches</source>
        <translation>Versatz des hinteren Betts in Nadelteilungen</translation>
    </message>
    <message>
        <source>rack %1</source>
        <translation>Versatz %1</translation>
    </message>
    <message>
        <source>Yarn carrier and its direction</source>
        <translation>Fadenführer und seine Richtung</translation>
    </message>
    <message>
        <source>carrier %1 %2</source>
        <translation>Fadenführer %1 %2</translation>
    </message>
    <message>
        <source>What the simulation does</source>
        <translation>Was die Simulation tut</translation>
    </message>
    <message>
        <source>Loops made up to the operation shown</source>
        <translation>Schleifen bis zum gezeigten Schritt</translation>
    </message>
    <message>
        <source>Loops that nothing holds: Remove ladders (Ctrl+L) lets them run</source>
        <translation>Schleifen ohne Halt: Laufmaschen entfernen (Strg+L) lässt sie laufen</translation>
    </message>
    <message>
        <source>Spring energy V of the fabric</source>
        <translation>Federenergie V des Gestricks</translation>
    </message>
    <message>
        <source>V %1</source>
        <translation>V %1</translation>
    </message>
    <message>
        <source>Computing time of one integrator step</source>
        <translation>Rechenzeit eines Integratorschritts</translation>
    </message>
    <message>
        <source>%1 ms/step</source>
        <translation>%1 ms/Schritt</translation>
    </message>
    <message>
        <source>What draws the fabric (OpenGL)</source>
        <translation>Was das Gestrick zeichnet (OpenGL)</translation>
    </message>
    <message>
        <source>Drawn by %1</source>
        <translation>Gezeichnet von %1</translation>
    </message>
    <message>
        <source>%1 stitches</source>
        <translation>%1 Maschen</translation>
    </message>
    <message>
        <source>Level of detail that you chose (View &gt; Detail of the yarn)</source>
        <translation>Feinheit, die Sie gewählt haben (Ansicht &gt; Feinheit des Garns)</translation>
    </message>
    <message>
        <source>Level of detail drawn, chosen by the width of the yarn on the screen</source>
        <translation>Gezeichnete Feinheit, nach der Breite des Garns auf dem Bildschirm gewählt</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::StepPlayer</name>
    <message>
        <source>Step player</source>
        <translation>Schrittspieler</translation>
    </message>
    <message>
        <source>To the empty machine</source>
        <translation>Zur leeren Maschine</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Pos1</translation>
    </message>
    <message>
        <source>One course back</source>
        <translation>Eine Reihe zurück</translation>
    </message>
    <message>
        <source>One operation back</source>
        <translation>Einen Schritt zurück</translation>
    </message>
    <message>
        <source>Play the operations</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>One operation forward</source>
        <translation>Einen Schritt vor</translation>
    </message>
    <message>
        <source>One course forward</source>
        <translation>Eine Reihe vor</translation>
    </message>
    <message>
        <source>To the end of the program</source>
        <translation>Zum Ende des Programms</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>Reihe</translation>
    </message>
    <message>
        <source>Course that is shown (↑ and ↓)</source>
        <translation>Gezeigte Reihe (↑ und ↓)</translation>
    </message>
    <message>
        <source>Operation in the course</source>
        <translation>Schritt in der Reihe</translation>
    </message>
    <message>
        <source>Operation that is shown, inside the course (← and →, Shift for a carriage pass)</source>
        <translation>Gezeigter Schritt in der Reihe (← und →, mit Umschalt eine Fahrt)</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>1× is five operations a second ([ slower, ] faster)</source>
        <translation>1× sind fünf Schritte in der Sekunde ([ langsamer, ] schneller)</translation>
    </message>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>Operations carried out, and operations of the program</source>
        <translation>Ausgeführte Schritte und Schritte des Programms</translation>
    </message>
    <message>
        <source>Play a part again and again</source>
        <translation>Einen Teil immer wieder spielen</translation>
    </message>
    <message>
        <source>Bookmarks</source>
        <translation>Lesezeichen</translation>
    </message>
    <message>
        <source>Where playing stops</source>
        <translation>Wo das Abspielen hält</translation>
    </message>
    <message>
        <source>Empty machine</source>
        <translation>Leere Maschine</translation>
    </message>
    <message>
        <source>%1 · line %2</source>
        <translation>%1 · Zeile %2</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Play a part again a&amp;nd again</source>
        <translation>Einen Teil immer &amp;wieder spielen</translation>
    </message>
    <message>
        <source>&amp;From here</source>
        <translation>&amp;Von hier</translation>
    </message>
    <message>
        <source>Up &amp;to here</source>
        <translation>&amp;Bis hier</translation>
    </message>
    <message>
        <source>Play &amp;all again</source>
        <translation>Wieder &amp;alles spielen</translation>
    </message>
    <message>
        <source>Book&amp;marks</source>
        <translation>&amp;Lesezeichen</translation>
    </message>
    <message>
        <source>&amp;Bookmark here, or remove it</source>
        <translation>Lesezeichen &amp;hier setzen oder entfernen</translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
    <message>
        <source>&amp;Next bookmark</source>
        <translation>&amp;Nächstes Lesezeichen</translation>
    </message>
    <message>
        <source>&amp;Previous bookmark</source>
        <translation>&amp;Voriges Lesezeichen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Stop &amp;playing at</source>
        <translation>A&amp;nhalten bei</translation>
    </message>
    <message>
        <source>&amp;Knit</source>
        <translation>&amp;Stricken</translation>
    </message>
    <message>
        <source>&amp;Tuck</source>
        <translation>&amp;Fang</translation>
    </message>
    <message>
        <source>&amp;Miss</source>
        <translation>&amp;Auslassen</translation>
    </message>
    <message>
        <source>&amp;Split</source>
        <translation>S&amp;plitten</translation>
    </message>
    <message>
        <source>Trans&amp;fer</source>
        <translation>&amp;Umhängen</translation>
    </message>
    <message>
        <source>&amp;Drop</source>
        <translation>A&amp;bwerfen</translation>
    </message>
    <message>
        <source>&amp;Rack</source>
        <translation>&amp;Versatz</translation>
    </message>
    <message>
        <source>Carrier comes &amp;in</source>
        <translation>Fadenführer kommt &amp;herein</translation>
    </message>
    <message>
        <source>Carrier goes &amp;out</source>
        <translation>Fadenführer geht hina&amp;us</translation>
    </message>
    <message>
        <source>A racking that is &amp;not 0</source>
        <translation>Versatz &amp;ungleich 0</translation>
    </message>
    <message>
        <source>A &amp;problem</source>
        <translation>Ein &amp;Problem</translation>
    </message>
    <message>
        <source>A n&amp;eedle…</source>
        <translation>Eine &amp;Nadel…</translation>
    </message>
    <message>
        <source>A &amp;carrier that comes to work</source>
        <translation>Ein &amp;Fadenführer, der an die Arbeit kommt</translation>
    </message>
    <message>
        <source>No&amp;where</source>
        <translation>Nir&amp;gends</translation>
    </message>
    <message>
        <source>Carrier %1</source>
        <translation>Fadenführer %1</translation>
    </message>
    <message>
        <source>A n&amp;eedle (%1)…</source>
        <translation>Eine &amp;Nadel (%1)…</translation>
    </message>
    <message>
        <source>Stop at a needle</source>
        <translation>Bei einer Nadel anhalten</translation>
    </message>
    <message>
        <source>Bed and number, for example f5 or b12; empty for none:</source>
        <translation>Bett und Nummer, zum Beispiel f5 oder b12; leer für keine:</translation>
    </message>
    <message>
        <source>“%1” is no needle. Write the bed (f, b, fs or bs) and a number, for example f5.</source>
        <translation>„%1“ ist keine Nadel. Schreibe Bett (f, b, fs oder bs) und Nummer, zum Beispiel f5.</translation>
    </message>
    <message>
        <source>Go to line</source>
        <translation>Gehe zu Zeile</translation>
    </message>
    <message>
        <source>Line of the source:</source>
        <translation>Zeile des Quelltexts:</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::StitchPalette</name>
    <message>
        <source>%1 (E and Shift+E go through the stitches; with Shift the yarn stays chosen)</source>
        <translation>%1 (E und Umschalt+E gehen die Maschen durch; mit Umschalt bleibt das Garn gewählt)</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::TeachingBoard</name>
    <message>
        <source>Course and operation</source>
        <translation>Reihe und Schritt</translation>
    </message>
    <message>
        <source>Course that is knitted, and courses of the program</source>
        <translation>Reihe, die gestrickt wird, und Reihen des Programms</translation>
    </message>
    <message>
        <source>The operation that is shown</source>
        <translation>Der gezeigte Schritt</translation>
    </message>
    <message>
        <source>Row %1 of %2</source>
        <translation>Reihe %1 von %2</translation>
    </message>
    <message>
        <source>The empty machine.</source>
        <translation>Die leere Maschine.</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::ThreadedCanvas</name>
    <message>
        <source>The fabric is too large for this graphics driver.</source>
        <translation>Das Gestrick ist zu groß für diesen Grafiktreiber.</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::ViewsDialog</name>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Named views</source>
        <translation>Benannte Ansichten</translation>
    </message>
    <message>
        <source>Double click shows a view, F2 renames it</source>
        <translation>Doppelklick zeigt eine Ansicht, F2 benennt sie um</translation>
    </message>
    <message>
        <source>Puts the camera there (Enter)</source>
        <translation>Stellt die Kamera dorthin (Eingabe)</translation>
    </message>
    <message>
        <source>Gives the view another name (F2)</source>
        <translation>Gibt der Ansicht einen anderen Namen (F2)</translation>
    </message>
    <message>
        <source>Forgets the view</source>
        <translation>Vergisst die Ansicht</translation>
    </message>
    <message>
        <source>Double click shows a view, F2 renames it.</source>
        <translation>Doppelklick zeigt eine Ansicht, F2 benennt sie um.</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::WebpSink</name>
    <message>
        <source>The animation cannot be written to %1.</source>
        <translation>Die Animation kann nicht nach %1 geschrieben werden.</translation>
    </message>
    <message>
        <source>The animation could not be made: its pictures are too large or there are none.</source>
        <translation>Die Animation konnte nicht gemacht werden: ihre Bilder sind zu groß oder es gibt keine.</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::YarnChoiceDialog</name>
    <message>
        <source>Compare with another yarn</source>
        <translation>Mit einem anderen Garn vergleichen</translation>
    </message>
    <message>
        <source>Whose yarn is exchanged</source>
        <translation>Wessen Garn getauscht wird</translation>
    </message>
    <message>
        <source>The yarn of the fabric beside</source>
        <translation>Das Garn des Gestricks daneben</translation>
    </message>
    <message>
        <source>All carriers, each in its colour</source>
        <translation>Alle Fadenführer, jeder in seiner Farbe</translation>
    </message>
    <message>
        <source>Carrier %1: %2</source>
        <translation>Fadenführer %1: %2</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Vergleichen</translation>
    </message>
    <message>
        <source>Settles the same program in this yarn beside (Enter)</source>
        <translation>Entspannt daneben dasselbe Programm in diesem Garn (Eingabe)</translation>
    </message>
    <message>
        <source>&amp;Exchange:</source>
        <translation>&amp;Tauschen:</translation>
    </message>
    <message>
        <source>&amp;Yarn:</source>
        <translation>&amp;Garn:</translation>
    </message>
    <message>
        <source>%1, %2, %3 mm thick</source>
        <translation>%1, %2, %3 mm dick</translation>
    </message>
    <message>
        <source>instead of %1, %2 mm thick</source>
        <translation>statt %1, %2 mm dick</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::YarnDialog</name>
    <message>
        <source>wool</source>
        <translation>Wolle</translation>
    </message>
    <message>
        <source>cashmere</source>
        <translation>Kaschmir</translation>
    </message>
    <message>
        <source>alpaca</source>
        <translation>Alpaka</translation>
    </message>
    <message>
        <source>cotton</source>
        <translation>Baumwolle</translation>
    </message>
    <message>
        <source>linen</source>
        <translation>Leinen</translation>
    </message>
    <message>
        <source>silk</source>
        <translation>Seide</translation>
    </message>
    <message>
        <source>viscose</source>
        <translation>Viskose</translation>
    </message>
    <message>
        <source>acrylic</source>
        <translation>Polyacryl</translation>
    </message>
    <message>
        <source>polyester</source>
        <translation>Polyester</translation>
    </message>
    <message>
        <source>polyamide</source>
        <translation>Polyamid</translation>
    </message>
    <message>
        <source>New yarn</source>
        <translation>Neues Garn</translation>
    </message>
    <message>
        <source>Yarn %1</source>
        <translation>Garn %1</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>As it stands in the library</source>
        <translation>Wie es in der Bibliothek steht</translation>
    </message>
    <message>
        <source>What it is made of; the density for the diameters follows from it</source>
        <translation>Woraus es besteht; die Dichte für die Durchmesser folgt daraus</translation>
    </message>
    <message>
        <source>Fibre</source>
        <translation>Faser</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Outer diameter, mm</source>
        <translation>Außendurchmesser, mm</translation>
    </message>
    <message>
        <source>Core diameter, mm</source>
        <translation>Kerndurchmesser, mm</translation>
    </message>
    <message>
        <source>Of the fibres pressed together</source>
        <translation>Der zusammengedrückten Fasern</translation>
    </message>
    <message>
        <source>EA, stretching, N</source>
        <translation>EA, Dehnung, N</translation>
    </message>
    <message>
        <source>Force that would double the length</source>
        <translation>Kraft, die die Länge verdoppeln würde</translation>
    </message>
    <message>
        <source>EI, bending, mN·mm²</source>
        <translation>EI, Biegung, mN·mm²</translation>
    </message>
    <message>
        <source>How the yarn resists a bend</source>
        <translation>Wie das Garn einer Biegung widersteht</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Yarn on yarn, 0 to 2</source>
        <translation>Garn auf Garn, 0 bis 2</translation>
    </message>
    <message>
        <source>How the surface looks</source>
        <translation>Wie die Oberfläche aussieht</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Hairiness</source>
        <translation>Haarigkeit</translation>
    </message>
    <message>
        <source>0 none, 1 brushed mohair</source>
        <translation>0 keine, 1 gebürstetes Mohair</translation>
    </message>
    <message>
        <source>Plies</source>
        <translation>Einzelgarne</translation>
    </message>
    <message>
        <source>Yarns twisted into one</source>
        <translation>Garne, die zu einem verzwirnt sind</translation>
    </message>
    <message>
        <source>Twist per metre</source>
        <translation>Drehungen je Meter</translation>
    </message>
    <message>
        <source>Turns of the plies; S is positive, Z negative</source>
        <translation>Drehungen des Zwirns; S ist positiv, Z negativ</translation>
    </message>
    <message>
        <source>The colour that it has in the library</source>
        <translation>Die Farbe, die es in der Bibliothek hat</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>How fine it is, in the unit beside</source>
        <translation>Wie fein es ist, in der Einheit daneben</translation>
    </message>
    <message>
        <source>Another unit converts the number</source>
        <translation>Eine andere Einheit rechnet die Zahl um</translation>
    </message>
    <message>
        <source>Of the hull of the fibres</source>
        <translation>Der Hülle der Fasern</translation>
    </message>
    <message>
        <source>Part of the section that is fibre: ring spun 0.6, worsted 0.45 to 0.5, woollen and bulked 0.25 to 0.3, textured 0.35, brushed 0.06</source>
        <translation>Anteil des Querschnitts, der Faser ist: ringgesponnen 0.6, Kammgarn 0.45 bis 0.5, Streichgarn und Bauschgarn 0.25 bis 0.3, texturiert 0.35, gebürstet 0.06</translation>
    </message>
    <message>
        <source>From the count</source>
        <translation>Aus der Nummer</translation>
    </message>
    <message>
        <source>d = 0.03568 √(tex / (ρ φ)) mm, ρ of the fibre in g/cm³, φ as beside; 0.9 for the core</source>
        <translation>d = 0.03568 √(tex / (ρ φ)) mm, ρ der Faser in g/cm³, φ wie daneben; 0.9 für den Kern</translation>
    </message>
    <message>
        <source>Colour of the yarn</source>
        <translation>Farbe des Garns</translation>
    </message>
    <message>
        <source>Expected: %1</source>
        <translation>Erwartet: %1</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>glatt</translation>
    </message>
    <message>
        <source>hairy</source>
        <translation>haarig</translation>
    </message>
    <message>
        <source>bulky</source>
        <translation>bauschig</translation>
    </message>
    <message>
        <source>matte</source>
        <translation>matt</translation>
    </message>
    <message>
        <source>glossy</source>
        <translation>glänzend</translation>
    </message>
    <message>
        <source>lustrous</source>
        <translation>schimmernd</translation>
    </message>
    <message>
        <source>crimped</source>
        <translation>gekräuselt</translation>
    </message>
    <message>
        <source>slubby</source>
        <translation>mit Noppen</translation>
    </message>
    <message>
        <source>halo</source>
        <translation>mit Flaum</translation>
    </message>
    <message>
        <source>soft</source>
        <translation>weich</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::YarnModel</name>
    <message>
        <source>%1: drag it onto a carrier, or double click to put it on the selected carrier</source>
        <translation>%1: auf einen Fadenführer ziehen, oder Doppelklick für den gewählten Fadenführer</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::YarnPalette</name>
    <message>
        <source>Yarn of carrier %1: %2</source>
        <translation>Garn von Fadenführer %1: %2</translation>
    </message>
    <message>
        <source>Add a yarn on the next carrier</source>
        <translation>Ein Garn auf dem nächsten Fadenführer hinzufügen</translation>
    </message>
    <message>
        <source>another yarn</source>
        <translation>noch ein Garn</translation>
    </message>
    <message>
        <source>%1 (O and Shift+O go through the yarns; with Shift the stitch stays chosen)</source>
        <translation>%1 (O und Umschalt+O gehen die Garne durch; mit Umschalt bleibt die Masche gewählt)</translation>
    </message>
    <message>
        <source>+ Yarn</source>
        <translation>+ Garn</translation>
    </message>
</context>
<context>
    <name>knittsim::ui::YarnPanel</name>
    <message>
        <source>Carriers</source>
        <translation>Fadenführer</translation>
    </message>
    <message>
        <source>Search yarns</source>
        <translation>Garne suchen</translation>
    </message>
    <message>
        <source>Name, fibre or count (Ctrl+F)</source>
        <translation>Name, Faser oder Nummer (Strg+F)</translation>
    </message>
    <message>
        <source>Yarn library</source>
        <translation>Garnbibliothek</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothek</translation>
    </message>
    <message>
        <source>Details of the yarn</source>
        <translation>Einzelheiten des Garns</translation>
    </message>
    <message>
        <source>Replaces the carrier&apos;s yarn; the fabric goes on from its shape (double click or Enter)</source>
        <translation>Ersetzt das Garn des Fadenführers; das Gestrick macht mit seiner Form weiter (Doppelklick oder Eingabe)</translation>
    </message>
    <message>
        <source>Put on carrier %1</source>
        <translation>Auf Fadenführer %1 legen</translation>
    </message>
    <message>
        <source>Put on the carrier</source>
        <translation>Auf den Fadenführer legen</translation>
    </message>
    <message>
        <source>Colour of the carrier&apos;s yarn</source>
        <translation>Farbe des Garns auf dem Fadenführer</translation>
    </message>
    <message>
        <source>Which yarns</source>
        <translation>Welche Garne</translation>
    </message>
    <message>
        <source>Shows all yarns, your own, or those of one fibre</source>
        <translation>Zeigt alle Garne, die eigenen oder die einer Faser</translation>
    </message>
    <message>
        <source>Own</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>Add, change, import and export yarns of your own</source>
        <translation>Eigene Garne hinzufügen, ändern, einlesen und ausgeben</translation>
    </message>
    <message>
        <source>&amp;New yarn like this one…</source>
        <translation>&amp;Neues Garn wie dieses…</translation>
    </message>
    <message>
        <source>My %1</source>
        <translation>Mein %1</translation>
    </message>
    <message>
        <source>A copy that is yours</source>
        <translation>Eine eigene Kopie</translation>
    </message>
    <message>
        <source>&amp;Change…</source>
        <translation>Ä&amp;ndern…</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Einlesen…</translation>
    </message>
    <message>
        <source>The yarn could not be saved</source>
        <translation>Das Garn konnte nicht gespeichert werden</translation>
    </message>
    <message>
        <source>Import yarns</source>
        <translation>Garne einlesen</translation>
    </message>
    <message>
        <source>Yarns (*.json);;All files (*)</source>
        <translation>Garne (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Export the yarn</source>
        <translation>Garn ausgeben</translation>
    </message>
    <message>
        <source>Yarns (*.json)</source>
        <translation>Garne (*.json)</translation>
    </message>
    <message>
        <source>Delete the yarn</source>
        <translation>Garn löschen</translation>
    </message>
    <message>
        <source>Delete %1 from your yarns? Fabrics that use it keep it.</source>
        <translation>%1 aus den eigenen Garnen löschen? Gestricke, die es benutzen, behalten es.</translation>
    </message>
    <message>
        <source>All yarns</source>
        <translation>Alle Garne</translation>
    </message>
    <message>
        <source>Your own</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>&amp;Export this yarn…</source>
        <translation>Dieses Garn &amp;exportieren…</translation>
    </message>
    <message>
        <source>Export all &amp;own yarns…</source>
        <translation>Alle ei&amp;genen Garne exportieren…</translation>
    </message>
    <message>
        <source>One file, for other people or a version control</source>
        <translation>Eine Datei, für andere oder eine Versionsverwaltung</translation>
    </message>
    <message>
        <source>%1 holds no yarns that can be read</source>
        <translation>%1 enthält keine lesbaren Garne</translation>
    </message>
    <message>
        <source>Export all own yarns</source>
        <translation>Alle eigenen Garne exportieren</translation>
    </message>
    <message>
        <source>The yarns could not be written</source>
        <translation>Die Garne konnten nicht geschrieben werden</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Turns knitting-machine programs into fabrics that settle while you watch.</source>
        <translation>Macht aus Strickprogrammen Gestricke, die sich vor deinen Augen entspannen.</translation>
    </message>
</context>
<context>
    <name>messages</name>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>course %1</source>
        <translation>Reihe %1</translation>
    </message>
</context>
</TS>
