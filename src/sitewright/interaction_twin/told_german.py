"""Reasons, holds and what would help in German, by the English sentence that they say."""

from __future__ import annotations

from collections.abc import Mapping

TOLD_GERMAN: Mapping[str, str] = {
    # joints between several things
    " and ": " und ",
    ", ": ", ",
    "; ": "; ",
    "; or ": "; oder ",
    # fixed words: skills, processes, what a driver reports
    "reach": "Fahren",
    "retract": "Zurückziehen",
    "grasp": "Greifen",
    "position": "Absetzen am Ziel",
    "set-down": "Ablegen",
    "release": "Loslassen",
    "fasten": "Befestigen",
    "apply-finish": "Streichen",
    "change-end-effector": "Werkzeugwechsel",
    "nail": "Nageln",
    "screw": "Schrauben",
    "paint": "Streichen",
    "drill": "Bohren",
    "grasp-failed": "der Greifer bekam es nicht zu fassen",
    "missed": "daneben gesetzt",
    "dropped": "fallen gelassen",
    "position-failed": "nicht an seinen Platz gekommen",
    "coverage-short": "nicht ganz gestrichen",
    "dock-failed": "das Werkzeug kam nicht in seine Ablage",
    "tracking": "der Arm wich von seiner Bahn ab",
    "held": "angehalten",
    # how sure a "no" is
    "proven impossible": "bewiesen unmöglich",
    "blocked by {things:and}": "versperrt durch {things:and}",
    "not found within budget": "in der Suchzeit nicht gefunden",
    "a person's wish": "Wunsch eines Menschen",
    "a person must put it right": "ein Mensch muss es richten",
    # how a run stands
    "The run stands. Resume to go on.": "Der Lauf steht. Mit Weiter geht er weiter.",
    "Planning the next target.": "Das nächste Bauteil wird geplant.",
    "Waiting for you.": "Wartet auf eine Entscheidung.",
    "Waiting for you: {steps} steps for {target}": "Wartet auf eine Entscheidung: {steps} Schritte "
    "für {target}",
    "Waiting for you: 1 step for {target}": "Wartet auf eine Entscheidung: 1 Schritt für {target}",
    "Under way.": "Unterwegs.",
    "A hold was asked for; the robots are coming to rest.": "Anhalten ist verlangt; die Roboter "
    "kommen zur Ruhe.",
    "Held.": "Angehalten.",
    "Only a person can say what happened.": "Nur ein Mensch kann sagen, was geschehen ist.",
    "Some targets cannot be built now; a person is needed.": "Einige Bauteile lassen sich jetzt "
    "nicht bauen; ein Mensch wird gebraucht.",
    "Every component is installed.": "Alle Bauteile sind eingebaut.",
    "The run broke off.": "Der Lauf ist abgebrochen.",
    "The process of the run is not there.": "Der Prozess des Laufs ist nicht da.",
    "Step {step} ({what}) was started and its end is not recorded. Look at the piece: is it done, "
    "not done, or done in part?": "Schritt {step} ({what}) wurde begonnen, sein Ende ist nicht "
    "verzeichnet. Bitte am Stück nachsehen: Ist er erledigt, nicht erledigt oder nur zum Teil?",
    # what a person can do
    "Plan it again, after the cell was looked at": "Neu planen, nachdem die Zelle angesehen wurde",
    "Say which of its work was done by hand": "Angeben, was davon von Hand gemacht wurde",
    "Take {zone} away": "{zone} entfernen",
    "keep-out zone {number}": "Sperrzone {number}",
    "{target} stands by itself": "{target} steht von selbst",
    "{operation} is done": "{operation} ist erledigt",
    # runs and approvals
    "The design changed after this plan was made.": "Der Entwurf wurde nach diesem Plan geändert.",
    "The design changed.": "Der Entwurf wurde geändert.",
    "{skill} was interrupted.": "{skill} wurde unterbrochen.",
    "held before the cell was told": "angehalten, bevor die Zelle den Auftrag bekam",
    "the sensors do not show its effect": "die Sensoren zeigen seine Wirkung nicht",
    "planned anew from where the robot is sensed": "neu geplant von dort, wo der Roboter ist",
    "it never started and may not start now": "es begann nie und darf jetzt nicht beginnen",
    "the cell's ledger does not know it": "das Register der Zelle kennt es nicht",
    "accepted by the cell, its end is not recorded": "von der Zelle angenommen, das Ende ist nicht "
    "verzeichnet",
    "The answer is about plan {shown}; the open one is {open}.": "Die Antwort betrifft Plan "
    "{shown}; offen ist {open}.",
    "The answer does not cover step {step}.": "Die Antwort schließt Schritt {step} nicht ein.",
    "{who} holds the run: {why}": "{who} hält den Lauf an: {why}",
    "{who} holds the run.": "{who} hält den Lauf an.",
    "{who} put it off: {why}": "{who} hat es zurückgestellt: {why}",
    "{who} put it off": "{who} hat es zurückgestellt",
    "The planner has no other plan than the one that was rejected.": "Es gibt keinen anderen Plan "
    "als den abgelehnten.",
    "This action is not feasible now.": "Das ist jetzt nicht möglich.",
    "After {skill} by {robot}: {subject} {what}.": "Nach {skill} durch {robot}: {subject}: {what}.",
    "The disk has too little space left to record what would happen.": "Auf der Festplatte ist zu "
    "wenig Platz, um festzuhalten, was geschieht.",
    "reported as done, but {what}": "als erledigt gemeldet, aber: {what}",
    "{robot} could not {skill}: {why}.": "{robot}: {skill} ist nicht gelungen: {why}.",
    "Step {step} is not clear any more: {pair:and} come too near.": "Schritt {step} ist nicht mehr "
    "frei: {pair:and} kommen sich zu nahe.",
    "Step {step} relies on what is not so: {fact}.": "Schritt {step} setzt voraus, was nicht so "
    "ist: {fact}.",
    "{subject} {what}. Look at the cell, then run again.": "{subject}: {what}. Bitte die Zelle "
    "ansehen, dann weiter.",
    "{subject} {what}. Look at the cell, then resume.": "{subject}: {what}. Bitte die Zelle "
    "ansehen, dann weiter.",
    "The site changed while nothing was to move.": "Die Baustelle hat sich geändert, obwohl sich "
    "nichts bewegen sollte.",
    "{target}: planned anew {count} times in vain.": "{target}: {count}-mal vergeblich neu geplant.",
    "The cell was lost again and again: {why}": "Die Verbindung zur Zelle riss immer wieder ab: "
    "{why}",
    "Planned anew {count} times within 10 min.": "{count}-mal in 10 min neu geplant.",
    "The approval was not given on this installation, or was changed.": "Die Freigabe stammt nicht "
    "von dieser Installation oder wurde verändert.",
    "The approval is about another plan.": "Die Freigabe betrifft einen anderen Plan.",
    "Step {step} is outside of what was approved.": "Schritt {step} ist nicht freigegeben.",
    "Step {step} was already started under this approval.": "Schritt {step} wurde mit dieser "
    "Freigabe schon begonnen.",
    "This approval was not started within 10 min. Approve again.": "Diese Freigabe wurde nicht "
    "innerhalb von 10 min begonnen. Bitte neu freigeben.",
    "Robot {robot} is not sensed.": "{robot} wird nicht erfasst.",
    "Step {step} is not approved.": "Schritt {step} ist nicht freigegeben.",
    "It leads nowhere.": "Es führt nicht weiter.",
    "no motion: {why}": "keine Bewegung: {why}",
    "no plan found from there in time": "von dort wurde in der Zeit kein Plan gefunden",
    "There is no open proposal.": "Es gibt keinen offenen Plan.",
    "Step {step} is not part of the proposal.": "Schritt {step} gehört nicht zum Plan.",
    "The site changed after this plan was made.": "Die Baustelle hat sich nach diesem Plan "
    "geändert.",
    "Another step has not ended yet.": "Ein anderer Schritt ist noch nicht zu Ende.",
    "Step {step} is not next; step {next} is.": "Nicht Schritt {step} ist der nächste, sondern "
    "Schritt {next}.",
    "Robot {robot} is not where step {step} starts: joint {joint} is at {is_rad:.3f}, the "
    "trajectory starts at {start_rad:.3f} (rad, m on a rail; allowed {most_rad:.3f}). A new motion "
    "is needed.": "{robot} ist nicht dort, wo Schritt {step} beginnt: Gelenk {joint} steht bei "
    "{is_rad:.3f}, die Bahn beginnt bei {start_rad:.3f} (rad, auf Schienen m; erlaubt "
    "{most_rad:.3f}). Eine neue Bewegung ist nötig.",
    # deviations
    "{piece} is {off_mm:.1f} mm and {off_deg:.2f} deg off": "{piece} liegt {off_mm:.1f} mm und "
    "{off_deg:.2f} Grad daneben",
    "only {share:.0%} of {operation} is covered": "nur {share:.0%} von {operation} sind gestrichen",
    "robot {robot} is not sensed": "{robot} wird nicht erfasst",
    "{piece} is not seen": "{piece} ist nicht zu sehen",
    "moved by {by_mm:.1f} mm and {by_deg:.2f} deg": "um {by_mm:.1f} mm und {by_deg:.2f} Grad "
    "verschoben",
    "{what} after it was installed": "{what}, nachdem es eingebaut war",
    "{piece} is not sensed in the gripper": "{piece} ist nicht im Greifer",
    "{piece} is still sensed in the gripper": "{piece} ist noch im Greifer",
    "the fastener {operation} is not sensed": "{operation} ist nicht zu finden",
    "{tool} is mounted, not {other}": "{tool} ist angebaut, nicht {other}",
    "the robot is not sensed any more": "der Roboter wird nicht mehr erfasst",
    "is not in the gripper of {robot} any more": "nicht mehr im Greifer von {robot}",
    "is not seen any more": "nicht mehr zu sehen",
    "carries {tool}, not {other}": "trägt {tool}, nicht {other}",
    "a joint moved by {by_rad:.3f} (rad, m on a rail) though it was at rest": "ein Gelenk hat sich "
    "um {by_rad:.3f} bewegt (rad, auf Schienen m), obwohl es ruhte",
    "does not match the site, says {who}": "stimmt laut {who} nicht mit der Baustelle überein",
    "{what}: {detail}": "{what}: {detail}",
    # steering
    "{who} did work on {target} by hand.": "{who} hat an {target} von Hand gearbeitet.",
    "{component} does not match the site.": "{component} stimmt nicht mit der Baustelle überein.",
    "{who} drew a keep-out zone.": "{who} hat eine Sperrzone gezeichnet.",
    "{who} removed {zone}.": "{who} hat {zone} entfernt.",
    # why a target has no plan, and what might help
    "{target}: {why}": "{target}: {why}",
    "{target}: {evidence:semi}. This might help: {remedies:semi}.": "{target}: {evidence:semi}. "
    "Das könnte helfen: {remedies:semi}.",
    "{target}: {evidence:semi}. Any one of these might help: {remedies:semi}.": "{target}: "
    "{evidence:semi}. Eines davon könnte helfen: {remedies:semi}.",
    "{target}: {evidence:semi}. All of these may be needed: {remedies:semi}.": "{target}: "
    "{evidence:semi}. Vielleicht ist all das nötig: {remedies:semi}.",
    "move {robot}'s base, let another robot do {place}, or do it by hand": "den Sockel von {robot} "
    "versetzen, {place} einem anderen Roboter geben oder es von Hand machen",
    "another robot, gripper or stock place for {piece}": "ein anderer Roboter, Greifer oder "
    "Lagerplatz für {piece}",
    "another robot or another way to hold {piece}": "ein anderer Roboter oder ein anderer Griff "
    "für {piece}",
    "another posture for whoever stands at {place}": "eine andere Haltung für den, der bei {place} "
    "steht",
    "make {fact} true": "dafür sorgen: {fact}",
    "take {things:and} out of the way": "{things:and} aus dem Weg räumen",
    "let {operation} be driven after {target} is let go of": "{operation} erst setzen, wenn "
    "{target} losgelassen ist",
    "let go of {target} with {count} of its fasteners driven": "{target} loslassen, sobald {count} "
    "der Befestigungen sitzen",
    "let go of {target} with fewer fasteners driven, or another robot or gripper": "{target} schon "
    "mit weniger Befestigungen loslassen, oder ein anderer Roboter oder Greifer",
    "the stack at {place}": "den Stapel auf {place}",
    "the base of {robot}": "den Sockel von {robot}",
    "place {other} before {target}": "{other} vor {target} einbauen",
    "take {pieces:and} away": "{pieces:and} wegnehmen",
    "move {thing} by {by_m:g} m towards {towards}": "{thing} um {by_m:g} m in Richtung {towards} "
    "versetzen",
    "{words} ({steps} steps)": "{words} ({steps} Schritte)",
    "{reason} Tried on a copy, and it works: {tried:or}.": "{reason} Auf einer Kopie versucht, und "
    "es geht: {tried:or}.",
    "{count} plans were refused by geometry; the last one: {last}": "{count} Pläne scheiterten an "
    "der Geometrie; der letzte: {last}",
    "{count} searches ended without a path; the last: {last}": "{count} Suchen endeten ohne Weg; "
    "die letzte: {last}",
    "{last}; no other order or robot avoids it": "{last}; keine andere Reihenfolge und kein anderer "
    "Roboter vermeidet das",
    # what was done instead
    "{target}: {reason} ({kind}, {verdict})": "{target}: {reason} ({verdict})",
    "{target}: {reason} ({kind}, {verdict}); instead: {then}": "{target}: {reason} ({verdict}); stattdessen: {then}",
    "{robot} takes {piece}": "{robot} nimmt {piece}",
    "{robot} does it": "{robot} macht es",
    "it is held {how}": "es wird so gehalten: {how}",
    "it leans ({how})": "es neigt sich ({how})",
    "it is held differently": "es wird anders gehalten",
    "the steps are ordered or shared out differently": "die Schritte werden anders geordnet oder "
    "verteilt",
    "{piece} may be taken": "{piece} darf genommen werden",
    "{other} is built first, of {piece}, which is in the way": "{other} wird zuerst gebaut, aus "
    "{piece}, das im Weg ist",
    "{pieces:and} is moved out of the way first": "{pieces:and} wird zuerst aus dem Weg geräumt",
    "{pieces:and} are moved out of the way first": "{pieces:and} werden zuerst aus dem Weg geräumt",
    # who cannot do what
    "{robot} cannot take {piece} at {place}: {why}": "{robot} kann {piece} bei {place} nicht "
    "nehmen: {why}",
    "{robot} cannot place {piece} at {place}: {why}": "{robot} kann {piece} nicht an {place} "
    "setzen: {why}",
    "{robot} cannot set {piece} down at {place}: {why}": "{robot} kann {piece} nicht auf {place} "
    "ablegen: {why}",
    "{robot} cannot leave {place}: {why}": "{robot} kann {place} nicht verlassen: {why}",
    "{robot} cannot let go of {held}: {why}": "{robot} kann {held} nicht loslassen: {why}",
    "{robot} cannot reach {place}: {why}": "{robot} kann {place} nicht erreichen: {why}",
    "{robot} cannot take {piece} and place it at {target}: {why}": "{robot} kann {piece} nicht "
    "nehmen und an {target} setzen: {why}",
    "{robot} cannot hold {piece} straight at its middle: cheaper grasps fail at {ends:comma}": ""
    "{robot} kann {piece} nicht gerade in der Mitte halten: einfachere Griffe scheitern bei: "
    "{ends:comma}",
    "{robot} cannot stand upright on {spot}: {why}": "{robot} kann nicht senkrecht auf {spot} "
    "stehen: {why}",
    "{robot} holds {piece} while other fasteners are driven": "{robot} hält {piece}, während andere "
    "Verbinder gesetzt werden",
    # why
    "{reason}: {pairs:comma}": "{reason}: {pairs:comma}",
    "{what}: {why}": "{what}: {why}",
    "{text}": "{text}",
    "{all:semi}.": "{all:semi}.",
    "{a} and {b}": "{a} und {b}",
    "every posture collides": "jede Haltung stößt an",
    "{a} and {b} come to {gap_mm:.1f} mm, allowed {least_mm:.1f} mm": "{a} und {b} kommen sich bis "
    "auf {gap_mm:.1f} mm nahe, erlaubt sind {least_mm:.1f} mm",
    "the cross-check sees {a} and {b} at {gap_mm:.1f} mm": "die Gegenprüfung sieht {a} und {b} bei "
    "{gap_mm:.1f} mm",
    "the planning process of {task} died with {status}": "der Planungsprozess von {task} endete mit "
    "{status}",
    "no path was found within {nodes} nodes": "in {nodes} Suchknoten wurde kein Weg gefunden",
    "no path within the nodes": "kein Weg in den Suchknoten",
    "nothing was tried": "nichts wurde versucht",
    "out of reach by {by_mm:.0f} mm (proven)": "{by_mm:.0f} mm außer Reichweite (bewiesen)",
    "no posture reaches it (proven)": "keine Haltung erreicht es (bewiesen)",
    "no posture reaches it (not proven)": "keine Haltung erreicht es (nicht bewiesen)",
    "{mass_kg:.0f} kg with the end effector, the arm carries {limit_kg:.0f} kg": "{mass_kg:.0f} kg "
    "mit dem Werkzeug, der Arm trägt {limit_kg:.0f} kg",
    "no posture serves what follows": "keine Haltung passt zu dem, was folgt",
    "no branch of the inverse kinematics holds": "keine Stellung des Arms bleibt auf der Linie",
    "the tip pose is not a number": "die Lage der Spitze ist keine Zahl",
    "none of {starts} starts led to the tip pose": "keiner von {starts} Anfängen führte zur Lage "
    "der Spitze",
    "the tip pose is out of reach": "die Lage der Spitze ist außer Reichweite",
    "the tip pose is out of reach from everywhere on the rails": "die Lage der Spitze ist von "
    "überall auf den Schienen außer Reichweite",
    "{what} at {tried} positions of the rails": "{what} an {tried} Stellen der Schienen",
    "no posture with the rails at rest": "keine Haltung bei ruhenden Schienen",
    "the start is blocked": "der Anfang ist versperrt",
    "the goal is blocked": "das Ziel ist versperrt",
    "every posture for the tip pose is outside the joint limits": "jede Haltung dafür liegt "
    "außerhalb der Gelenkgrenzen",
    "the line cannot be followed closely enough": "der Linie kann nicht genau genug gefolgt werden",
    "the arm would have to change its branch on the line ({jump_rad:.2f} rad)": "der Arm müsste auf "
    "der Linie umschlagen ({jump_rad:.2f} rad)",
    "no straight way into the dock": "kein gerader Weg in die Ablage",
    "there is no posture to go to": "es gibt keine Haltung, in die er könnte",
    "there was no pose to try": "es gab keine Lage zu versuchen",
    "nothing to do at {place}": "bei {place} ist nichts zu tun",
    "nothing can be set down at {place}": "auf {place} kann nichts abgelegt werden",
    "no tool change follows at this station": "an dieser Station folgt kein Werkzeugwechsel",
    "{place} is no buffer": "{place} ist keine Ablage",
    "the fingers have no room": "die Finger haben keinen Platz",
    # grasps
    "no gripper is mounted": "kein Greifer ist angebaut",
    "no grasp of {piece}": "kein Griff für {piece}",
    "no side of the piece fits between the gripper's fingers": "keine Seite des Stücks passt "
    "zwischen die Finger des Greifers",
    "no grasp serves {ends:comma}": "kein Griff taugt; sie scheitern beim {ends:comma}",
    "{end} ({count})": "{end} ({count})",
    "fasten while held": "Befestigen, während es gehalten wird",
    "pick and lift": "Aufnehmen und Anheben",
    "place": "Absetzen",
    "let go": "Loslassen",
    "reach the piece": "Erreichen des Stücks",
    "reach the target": "Erreichen des Ziels",
    "the motions of all {count} grasps that serve were refused": "die Bewegungen aller {count} "
    "tauglichen Griffe wurden verworfen",
    "the target is out of reach with every grasp (proven)": "das Ziel ist mit jedem Griff außer "
    "Reichweite (bewiesen)",
    "the piece is out of reach with every grasp (proven)": "das Stück ist mit jedem Griff außer "
    "Reichweite (bewiesen)",
    "the target is out of reach by {by_mm:.0f} mm with every grasp (proven)": "das Ziel ist mit "
    "jedem Griff {by_mm:.0f} mm außer Reichweite (bewiesen)",
    "the piece is out of reach by {by_mm:.0f} mm with every grasp (proven)": "das Stück ist mit "
    "jedem Griff {by_mm:.0f} mm außer Reichweite (bewiesen)",
    "{things:and} is in its place": "{things:and} ist an seinem Platz",
    "{things:and} are in its place": "{things:and} sind an seinem Platz",
    "at most {most} of the {needed} fasteners that must be driven before letting go can be driven "
    "while it is held (in {ways} ways to hold it)": "höchstens {most} der {needed} Verbinder, die "
    "vor dem Loslassen gesetzt sein müssen, lassen sich setzen, während es gehalten wird "
    "({ways} Arten zu halten)",
    "{missing:and} must be driven while the piece is held, and no tool gets there in any of the "
    "{ways} ways to hold it": "{missing:and} muss gesetzt werden, während das Stück gehalten wird, "
    "und kein Werkzeug kommt dorthin, wie auch immer es gehalten wird ({ways} Arten)",
    "at the middle": "in der Mitte",
    "{offset_mm:.0f} mm off the middle": "{offset_mm:.0f} mm neben der Mitte",
    "{where}, leaning {lean_deg:.0f} degrees": "{where}, um {lean_deg:.0f} Grad geneigt",
    # the planner of symbols
    "No skill of this team makes {facts:comma} true.": "Kein Können dieses Teams bewirkt: "
    "{facts:comma}.",
    "No order of skills reaches the goal.": "Keine Reihenfolge von Schritten führt zum Ziel.",
    "No plan was found: {why}.": "Kein Plan wurde gefunden: {why}.",
    "No search was run.": "Es wurde nicht gesucht.",
    "The time limit was reached.": "Die Zeit war um.",
    "the search ended without a plan": "die Suche endete ohne Plan",
    "the translator ran out of memory": "dem Übersetzer ging der Speicher aus",
    "the translator ran out of time": "dem Übersetzer ging die Zeit aus",
    "the search ran out of memory": "der Suche ging der Speicher aus",
    "the search ran out of time": "der Suche ging die Zeit aus",
    "the search ran out of memory and time": "der Suche gingen Speicher und Zeit aus",
    "no piece that fits {target} can be taken": "kein Stück, das zu {target} passt, kann genommen "
    "werden",
    "{none}; at no stock place any more: {lost:comma}": "{none}; an keinem Lagerplatz mehr: "
    "{lost:comma}",
    "goal needs {fact}, which no skill changes": "das Ziel verlangt, was kein Können ändert: {fact}",
    "operation {operation} of {target} is {process}, which no skill does": "{operation} ist "
    "{process}, das kein Können tut",
    "operation {operation} of {target} comes after {other}, which is not done and is no fastener "
    "of this target": "{operation} kommt nach {other}, das nicht erledigt und kein Verbinder dieses "
    "Bauteils ist",
    "nobody": "niemand",
    "{fastener} ({pair:and})": "{fastener} ({pair:and})",
    "{few}; proven over all {grasps} grasps in every posture ({ways} ways to hold it), and up to {poses} tool poses of {robots:and} for each fastener in every posture": "{few}; bewiesen über alle {grasps} Griffe in jeder Haltung ({ways} Arten zu halten) und je Verbinder bis zu {poses} Werkzeuglagen von {robots:and} in jeder Haltung",
    "{few}, since {robot}, which holds it, is in the way of {fasteners:and}": "{few}, weil {robot}, der es hält, bei {fasteners:and} im Weg ist",
    "{robot} lays it down at {place}": "{robot} legt es auf {place} ab",
    "{robot} takes it from there to {place}": "{robot} bringt es von dort nach {place}",
    "{legs:comma} and takes it differently": "{legs:comma} und nimmt es anders",
    "{legs:comma}, where {robot} takes it": "{legs:comma}, dort nimmt es {robot}",
    "{spot} has no fastener or no receiver": "{spot} hat keinen Verbinder oder kein Gegenstück",
    "{spot} has no patch or no piece": "{spot} hat keine Fläche oder kein Stück",
    "What would run ({found}) is not what was proposed ({wanted}).": "Was laufen würde ({found}), ist nicht, was vorgelegt wurde ({wanted}).",
    "Ask for the same plan again, after a look at the cell": "Denselben Plan noch einmal vorlegen, nach einem Blick auf die Zelle",
    "Draw a keep-out zone, so that the robots go another way": "Eine Sperrzone zeichnen, damit die Roboter anders fahren",
    "rejected, and nothing else was found": "abgelehnt, und nichts anderes wurde gefunden",
    "{target}: its plan was rejected, and no other one was found.": "{target}: Der Plan wurde abgelehnt, und ein anderer wurde nicht gefunden.",
    "no other way was found than the one that was called unsafe": "kein anderer Weg wurde gefunden als der, der unsicher genannt wurde",
    "{who} rejected the plan: {why}": "{who} hat den Plan abgelehnt: {why}",
    "{who} rejected step {step} ({call}): {why}": "{who} hat Schritt {step} abgelehnt ({call}): {why}",
    "wrong component": "falsches Bauteil",
    "wrong robot": "falscher Roboter",
    "the path looks unsafe": "der Weg sieht unsicher aus",
    "the site is different": "die Baustelle ist anders",
    "later": "später",
    "something else": "etwas anderes",
    # what happens, line by line
    "Run {run} continues {previous}.": "Lauf {run} setzt {previous} fort.",
    "Run {run} begins.": "Lauf {run} beginnt.",
    "The run goes on where it stopped.": "Der Lauf geht weiter, wo er stand.",
    "! {reason}": "! {reason}",
    "Everything is installed.": "Alles ist eingebaut.",
    "Nothing more can be built.": "Mehr lässt sich nicht bauen.",
    "The design changed ({old} -> {new}); plans are made anew.": "Der Entwurf wurde geändert ({old} -> {new}); es wird neu geplant.",
    "{changed} New work on what stands: {components:comma}.": "{changed} Neue Arbeit an dem, was steht: {components:comma}.",
    "  {text}": "  {text}",
    "  ! not done: {why}": "  ! nicht erledigt: {why}",
    "{component} is installed, {off_mm:.1f} mm off.": "{component} ist eingebaut, {off_mm:.1f} mm daneben.",
    "{who} drew {zone}.": "{who} hat {zone} gezeichnet.",
    "{who} took {zone} away.": "{who} hat {zone} entfernt.",
    "{target}: 1 step, {duration} (planned in {planned}, code {code})": "{target}: 1 Schritt, {duration} (geplant in {planned}, Code {code})",
    "{target}: {count} steps, {duration} (planned in {planned}, code {code})": "{target}: {count} Schritte, {duration} (geplant in {planned}, Code {code})",
    "  {target}: {reason} ({kind}); {then}": "  {target}: {reason}; {then}",
    "no way round it": "kein Weg darum herum",
    "! {target} cannot be built now: {why}": "! {target} lässt sich jetzt nicht bauen: {why}",
    "  {target} waits until {other} is built": "  {target} wartet, bis {other} gebaut ist",
    "  ! {subject}: {what}": "  ! {subject}: {what}",
    "  the cell's ledger says {verdict}: {evidence}": "  das Register der Zelle sagt {verdict}: {evidence}",
    "! The other action is not possible: {why}": "! Die andere Aktion ist nicht möglich: {why}",
    "! A new plan is needed: {why}": "! Ein neuer Plan ist nötig: {why}",
    "! The approval does not hold any more: {why}": "! Die Freigabe gilt nicht mehr: {why}",
    "! The cell was lost: {why}": "! Die Verbindung zur Zelle ging verloren: {why}",
    "never": "nie begonnen",
    "not-done": "nicht erledigt",
    "unknown": "unbekannt",
    # answers to decisions
    "The site or the plan changed after this plan was shown. Look at the new plan first.": "Baustelle oder Plan haben sich geändert, seit dieser Plan gezeigt wurde. Bitte erst den neuen Plan ansehen.",
    "This key was used for another decision; nothing was done.": "Dieser Schlüssel gehörte zu einer anderen Entscheidung; nichts wurde getan.",
    "Not recorded, nothing decided: the journal cannot be written ({why}).": "Nicht festgehalten, nichts entschieden: das Journal lässt sich nicht schreiben ({why}).",
    "{who} approved this plan already; nothing was done.": "{who} hat diesen Plan schon freigegeben; nichts wurde getan.",
    "{who} rejected this plan already; nothing was done.": "{who} hat diesen Plan schon abgelehnt; nichts wurde getan.",
    "{who} chose another action instead of this plan already; nothing was done.": "{who} hat statt dieses Plans schon eine andere Aktion gewählt; nichts wurde getan.",
    "{who} asked for a new motion in this plan already; nothing was done.": "{who} hat für diesen Plan schon eine neue Bewegung verlangt; nichts wurde getan.",
    "{who} held this plan already; nothing was done.": "{who} hat diesen Plan schon angehalten; nichts wurde getan.",
    "{who} reported a mismatch in this plan already; nothing was done.": "{who} hat zu diesem Plan schon eine Abweichung gemeldet; nichts wurde getan.",
    "{who} changed the keep-out zones of this plan already; nothing was done.": "{who} hat die Sperrzonen dieses Plans schon geändert; nichts wurde getan.",
    "{who} completed by hand a part of this plan already; nothing was done.": "{who} hat einen Teil dieses Plans schon von Hand erledigt; nichts wurde getan.",
    "{who} decided about this plan already; nothing was done.": "{who} hat über diesen Plan schon entschieden; nichts wurde getan.",
    "No plan waits for a decision now.": "Jetzt wartet kein Plan auf eine Entscheidung.",
    "No plan waits for a decision any more.": "Es wartet kein Plan mehr auf eine Entscheidung.",
    "The run stands already.": "Der Lauf steht schon.",
    "The run is under way already.": "Der Lauf ist schon unterwegs.",
    "This question is not open any more.": "Diese Frage ist nicht mehr offen.",
    "The run plans or moves now; hold it, or wait until it asks.": "Der Lauf plant oder bewegt sich jetzt; bitte anhalten oder warten, bis er fragt.",
    "This action is not possible now; look again.": "Das ist jetzt nicht möglich; bitte noch einmal ansehen.",
    "The run broke off: {why}": "Der Lauf ist abgebrochen: {why}",
    "The other ways could not be worked out: {why}": "Andere Wege ließen sich nicht ausrechnen: {why}",
    "Noted. A second person must decide the same.": "Notiert. Eine zweite Person muss dasselbe entscheiden.",
    "The plan has steps 1 to {last}; there is no step {step}.": "Der Plan hat die Schritte 1 bis {last}; Schritt {step} gibt es nicht.",
    "That part of the plan is not open; step {step} is next, the ones before are done.": "Dieser Teil des Plans ist nicht offen; Schritt {step} ist der nächste, die davor sind erledigt.",
    "Only a supervisor may approve step {step}: clearance {gap_mm:.0f} mm is under the policy's {least_mm:.0f} mm.": "Nur eine Aufsicht darf Schritt {step} freigeben: der Abstand {gap_mm:.0f} mm liegt unter den vorgeschriebenen {least_mm:.0f} mm.",
    "{fact} cannot be vouched for: the piece of {target} must be sensed in place, and the work must be open.": "Dafür kann niemand bürgen ({fact}): das Stück von {target} muss an seinem Platz erfasst und die Arbeit offen sein.",
    "Nobody drew {zone}; it cannot be taken away.": "{zone} hat niemand gezeichnet; sie lässt sich nicht entfernen.",
    "The process of the run is not there. Start `sitewright serve` again.": "Der Prozess des Laufs ist nicht da. Bitte `sitewright serve` neu starten.",
    "The process of the run does not answer; nothing is known.": "Der Prozess des Laufs antwortet nicht; es ist nichts bekannt.",
    "The process of the run ended; nothing is known.": "Der Prozess des Laufs ist zu Ende; es ist nichts bekannt.",
    "{who} asked for what this plan does; another person must approve it.": "{who} hat verlangt, was dieser Plan tut; jemand anders muss ihn freigeben.",
    "The first {wanted} of type {kind} are approved step by step ({built} are built); approve step {step} by itself.": "Die ersten {wanted} der Art {kind} werden Schritt für Schritt freigegeben ({built} sind gebaut); bitte Schritt {step} für sich freigeben.",
    "{spot} was left half done; rework it by hand.": "{spot} ist nur halb getan; bitte von Hand nacharbeiten.",
    "{who} wants another component than the plan before.": "{who} will ein anderes Bauteil als im Plan davor.",
    "{who} wants another robot than the plan before.": "{who} will einen anderen Roboter als im Plan davor.",
    "{who} called the plan before unsafe; it has other motions now.": "{who} nannte den Plan davor unsicher; er hat jetzt andere Bewegungen.",
    "{who} says that the site is not as the plan before had it.": "{who} sagt, die Baustelle sei nicht so wie im Plan davor.",
    "{who} put {target} off.": "{who} hat {target} aufgeschoben.",
    "{who} rejected the plan before.": "{who} hat den Plan davor abgelehnt.",
    "{said} “{detail}”": "{said} „{detail}“",
    "{who} asked for another motion.": "{who} hat um eine andere Bewegung gebeten.",
    "{names} and {count} more": "{names} und {count} weitere",
}
