"""What still stands while a frame is taken apart, and what would fall with a component."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from sitewright.building_model.inference.statics import Statics
from sitewright.foundation.ids import ComponentId


class Standing:
    """The components of a frame that are still there; each hangs on another one or the ground.

    Attributes:
        present: All that are still there.
        lost: Those of them that do not lead down to the ground any more.
    """

    def __init__(self, statics: Statics, components: Iterable[ComponentId]) -> None:
        self.present = set(components)
        self.lost: set[ComponentId] = set()
        self._stays_on = {i: statics.stays_on(i) & self.present for i in self.present}
        self._holds = _reversed(self._stays_on)
        self._carries = _reversed({i: statics.carriers_of(i) for i in self.present})
        self._hung: dict[ComponentId, set[ComponentId]] = {i: set() for i in self.present}
        self._on: dict[ComponentId, ComponentId] = {}
        ground = self.present & statics.ground
        self._hang(self._found(ground, self.present - ground))

    def kept_by(self, component: ComponentId) -> ComponentId | None:
        """Return what would rest on nothing without a component; None if it may leave.

        As long as the one that is returned is there, the component stays kept.
        """
        carried = self._carries.get(component, [])
        resting = next((c for c in carried if c in self.present), None)
        return resting or next(iter(self._fallen(component)[1]), None)

    def take(self, component: ComponentId) -> None:
        """Take a component away; what hung on it finds another hold, or is lost."""
        found, fallen = self._fallen(component)
        self._hang(found)
        for lost in fallen:
            self._let_go(lost)
        self.lost |= fallen
        self._let_go(component)
        self.lost.discard(component)
        self.present.discard(component)

    def _fallen(
        self, component: ComponentId
    ) -> tuple[dict[ComponentId, ComponentId], set[ComponentId]]:
        """Return the new holds of all that hangs on a component, and who finds none."""
        below: set[ComponentId] = set()
        waiting = list(self._hung[component])
        while waiting:
            hanging = waiting.pop()
            below.add(hanging)
            waiting += self._hung[hanging]
        if not below:
            return {}, below
        out = below | self.lost | {component}
        found = {i: on for i in sorted(below) if (on := self._other_hold(i, out)) is not None}
        found |= self._found(found, below - found.keys())
        return found, below - found.keys()

    def _other_hold(self, component: ComponentId, out: set[ComponentId]) -> ComponentId | None:
        holds = (self._stays_on[component] & self.present) - out
        return min(holds, default=None)

    def _found(
        self, anchored: Iterable[ComponentId], loose: set[ComponentId]
    ) -> dict[ComponentId, ComponentId]:
        """Return the holds of those among the loose that lead to the anchored ones."""
        found: dict[ComponentId, ComponentId] = {}
        waiting = sorted(anchored)
        while waiting:
            on = waiting.pop()
            for held in self._holds.get(on, ()):
                if held in loose and held not in found:
                    found[held] = on
                    waiting.append(held)
        return found

    def _hang(self, on: Mapping[ComponentId, ComponentId]) -> None:
        for component, other in on.items():
            self._let_go(component)
            self._on[component] = other
            self._hung[other].add(component)

    def _let_go(self, component: ComponentId) -> None:
        if component in self._on:
            self._hung[self._on.pop(component)].discard(component)


def _reversed(
    related: Mapping[ComponentId, Iterable[ComponentId]],
) -> dict[ComponentId, list[ComponentId]]:
    found: dict[ComponentId, list[ComponentId]] = {}
    for one in sorted(related):
        for other in related[one]:
            found.setdefault(other, []).append(one)
    return found
