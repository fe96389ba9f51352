"""Why a step is as it is, in plain words."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator, Sequence

from sitewright.central_controller.causes import is_asked_for
from sitewright.central_controller.doers import Doer
from sitewright.central_controller.fingerprint import check_code
from sitewright.central_controller.ports import RefusalNote
from sitewright.foundation.sentence import Sentence
from sitewright.interaction_twin.labels import Labels
from sitewright.interaction_twin.measures import in_millimetres, in_seconds
from sitewright.interaction_twin.narration import fact_in_words, narrate
from sitewright.interaction_twin.phrases import ENGLISH, Phrasebook
from sitewright.interaction_twin.retelling import retold
from sitewright.interaction_twin.step_reasons import StepReasons
from sitewright.planning_twin.motion import PlannedMotion
from sitewright.robot_team.skill import Skill

_MOST = 6
_UPRIGHT_RAD = math.radians(0.1)


def explanation(
    reasons: StepReasons, labels: Labels, book: Phrasebook = ENGLISH
) -> tuple[str, ...]:
    """Return the explanation of a step as lines: titles, and indented what belongs to them."""
    return tuple(_Words(reasons, labels, book).lines())


class _Words:
    """Turns the reasons of one step into lines."""

    def __init__(self, reasons: StepReasons, labels: Labels, book: Phrasebook) -> None:
        self.reasons, self.labels, self.book = reasons, labels, book

    def lines(self) -> Iterator[str]:
        r = self.reasons
        yield self._say(
            "title",
            number=r.number,
            count=len(r.steps),
            target=self.labels.name(r.target),
            status=self.book.step.get(f"status-{r.status}", r.status),
        )
        yield f"  {narrate(r.step.call, self.labels, self.book)}."
        yield f"  {self._say('plan', code=check_code(r.fingerprint), run=r.run)}"
        yield from self._titled(self._say("why"), self._why())
        yield from self._titled(self._say("possible"), self._possible())
        robot = self.labels.name(r.step.call.robot)
        yield from self._titled(self._say("robot", robot=robot), self._robot())
        if r.piece is not None:
            piece = self.labels.name(r.piece)
            yield from self._titled(self._say("piece", piece=piece), self._piece())
        yield from self._titled(self._say("how"), self._how())
        yield from self._titled(self._say("refused"), map(self._refusal, r.own_refusals))
        yield from self._titled(self._say("refused-other"), map(self._refusal, r.other_refusals))
        if not r.refusals:
            yield f"  {self._say('nothing')}"

    def _titled(self, title: str, lines: Iterator[str]) -> Iterator[str]:
        found = list(lines)
        if found:
            yield title
        for line in found:
            yield f"  {line}"

    def _why(self) -> Iterator[str]:
        r = self.reasons
        consumers: dict[str, list[int]] = defaultdict(list)
        for link in r.needed_by:
            consumers[link.fact].append(link.consumer or 0)
        for fact, numbers in consumers.items():
            first, *more = numbers
            key = "serves-many" if more else "serves"
            yield self._say(
                key,
                fact=self._fact(fact),
                number=first,
                numbers=_listed(numbers),
                words=self._step(first),
            )
        for fact in r.lasting:
            yield self._say("asked" if is_asked_for(fact) else "lasts", fact=self._fact(fact))
        way = r.way_to_purpose
        if len(way) > 2:  # noqa: PLR2004 - more than itself and the next
            last = way[-1]
            yield self._say("leads", number=last, words=self._step(last), way=_listed(way[1:-1]))
        if not consumers and not r.lasting:
            yield self._say("no-use")

    def _possible(self) -> Iterator[str]:
        for link in self.reasons.made_possible_by:
            if link.producer:
                words = self._step(link.producer)
                yield self._say(
                    "made", fact=self._fact(link.fact), number=link.producer, words=words
                )
            else:
                yield self._say("given", fact=self._fact(link.fact))

    def _robot(self) -> Iterator[str]:
        r = self.reasons
        own = r.step.call.robot
        if r.act != r.step.call:
            yield self._say("for-act", words=narrate(r.act, self.labels, self.book))
        able = next((d.can_by for d in r.doers if d.robot == own), "")
        yield self._say("able", by=able) if able else self._say("only-moves")
        for doer in r.doers if able else ():
            if doer.robot != own:
                yield from self._other(doer)

    def _other(self, doer: Doer) -> Iterator[str]:
        name = self.labels.name(doer.robot)
        for obstacle in doer.obstacles:
            yield self._say("other", robot=name, obstacle=obstacle)
        if not doer.obstacles:
            yield self._say("either", robot=name)

    def _piece(self) -> Iterator[str]:
        r = self.reasons
        known = {p.piece: p for p in r.pieces}
        if r.piece is None or not known:
            yield self._say("held")
            return
        chosen = known.get(r.piece)
        if chosen is None:
            yield self._say("aside", target=self.labels.name(r.target))
            return
        free = [p for p in r.pieces if not p.under]
        key = "only" if free == [chosen] else "nearest" if free[:1] == [chosen] else "not-nearest"
        yield self._say(key, count=len(free), distance=f"{chosen.distance_m:.2f} m")
        farther = [
            f"{self.labels.name(p.piece)} ({p.distance_m:.2f} m)"
            for p in free
            if p.distance_m >= chosen.distance_m and p is not chosen
        ]
        buried = [self.labels.name(p.piece) for p in r.pieces if p.under]
        if farther:
            yield self._say("farther", pieces=self._some(farther))
        if buried:
            yield self._say("buried", pieces=self._some(buried))

    def _how(self) -> Iterator[str]:
        r = self.reasons
        yield self._say("takes", duration=in_seconds(r.step.duration_s))
        for motion in r.step.motions:
            yield from self._motion(motion)
        if not r.step.motions:
            is_move = r.step.call.skill in (Skill.REACH, Skill.RETRACT)
            yield self._say("joined" if is_move else "still")
        yield from self._stance()
        touching = [self._together(pair) for pair in r.step.contacts]
        if touching:
            yield self._say("touch", pairs=self._some(touching))

    def _motion(self, motion: PlannedMotion) -> Iterator[str]:
        proof = motion.certificate
        if proof.closest_pair is not None:
            yield self._say(
                "closest",
                distance=in_millimetres(proof.closest_distance_m),
                pair=self._together(proof.closest_pair),
                clearance=in_millimetres(proof.clearance_m),
            )
        yield self._say(
            "proof",
            pairs=proof.pairs,
            engine=proof.engine,
            second=motion.agreement.engine,
            samples=motion.agreement.samples,
        )

    def _stance(self) -> Iterator[str]:
        stance = self.reasons.stance
        if stance is None:
            return
        if stance.lean_rad is not None:
            is_upright = stance.lean_rad < _UPRIGHT_RAD
            yield (
                self._say("upright")
                if is_upright
                else self._say("lean", angle=_degrees(stance.lean_rad))
            )
        if stance.from_middle_m is not None and stance.from_above_rad is not None:
            yield self._say(
                "grip",
                distance=in_millimetres(abs(stance.from_middle_m)),
                angle=_degrees(stance.from_above_rad),
            )

    def _refusal(self, note: RefusalNote) -> str:
        return retold(note.reason, self.labels, self.book)

    def _together(self, names: Sequence[str]) -> str:
        return self.book.told.get(" and ", " and ").join(map(self.labels.name, names))

    def _some(self, names: Sequence[str]) -> str:
        listed = self.book.told.get(", ", ", ").join(names[:_MOST])
        if len(names) <= _MOST:
            return listed
        more = Sentence("{names} and {count} more", names=listed, count=len(names) - _MOST)
        return retold(more, self.labels, self.book)

    def _say(self, key: str, **words: object) -> str:
        return self.book.step[key].format(**words)

    def _fact(self, fact: str) -> str:
        return fact_in_words(fact, self.labels, self.book)

    def _step(self, number: int) -> str:
        call = self.reasons.steps[number - 1].call
        return narrate(call, self.labels, self.book)


def _listed(numbers: Sequence[int]) -> str:
    return ", ".join(map(str, numbers))


def _degrees(angle_rad: float) -> str:
    return f"{math.degrees(angle_rad):.1f} degrees"
