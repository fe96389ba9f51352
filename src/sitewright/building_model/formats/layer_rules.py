"""What the layers of a drawing say: role on the site, type and group of a component."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field

from sitewright.building_model.component import Layer

_BIM = re.compile(r"^(?P<name>.*)\[(?P<type>[^\[\]]+)\]$")
_MEANINGLESS = frozenset({"default", "0"})
"""Names that a program gives a layer that nobody made."""
_ROLES: Mapping[str, Layer] = {
    "target": Layer.TARGET,
    "targets": Layer.TARGET,
    "material": Layer.MATERIAL,
    "materials": Layer.MATERIAL,
    "asbuilt": Layer.AS_BUILT,
    "asdesigned": Layer.AS_DESIGNED,
    "consumed": Layer.AS_DESIGNED,
    "virtualcollision": Layer.VIRTUAL_COLLISION,
    "virtualcollisions": Layer.VIRTUAL_COLLISION,
}


@dataclass(frozen=True, slots=True, kw_only=True)
class LayerReading:
    """What a layer path says; None or empty where it says nothing."""

    role: Layer | None = None
    type: str = ""
    group: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class LayerNames:
    """Names that a user's own file gives the five roles, besides the built-in ones."""

    role_by_name: Mapping[str, Layer] = field(default_factory=dict)

    def role_of(self, name: str) -> Layer | None:
        """Return the role that a layer of this name has; case and separators do not count."""
        word = folded(name)
        return self.role_by_name.get(word) or _ROLES.get(word)


def folded(name: str) -> str:
    """Return a name without case, spaces, hyphens and underscores."""
    return re.sub(r"[\s_-]+", "", name).casefold()


def reading_of(path: str, names: LayerNames) -> LayerReading:
    """Return what a path such as ``Target::Storey 1[IfcStorey]::IfcWall`` says.

    The deepest layer with a role decides the role. Of the others, the deepest is the type and
    the one above it is the group.
    """
    role: Layer | None = None
    words: list[tuple[str, str]] = []
    for segment in (s.strip() for s in path.split("::")):
        name, kind = _segment(segment)
        found = names.role_of(name)
        role = found or role
        if not found and segment and segment.casefold() not in _MEANINGLESS:
            words.append((name, kind))
    if not words:
        return LayerReading(role=role)
    name, kind = words[-1]
    group = words[-2][0] if len(words) > 1 else (name if kind else "")
    return LayerReading(role=role, type=kind or name, group=group)


def _segment(segment: str) -> tuple[str, str]:
    match = _BIM.match(segment)
    return (match["name"].strip(), match["type"].strip()) if match else (segment, "")
