"""How the links of a URDF hang together: one root, one parent each, one tip."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Sequence

from sitewright.errors import did_you_mean
from sitewright.robot_team.description import Joint
from sitewright.robot_team.formats.urdf_xml import Findings

_USUAL_TIPS = ("tool0", "tcp")


def check_tree(links: Collection[str], joints: Sequence[Joint], findings: Findings) -> None:
    """Note joints to unknown links, links with two parents, and loops."""
    parents = defaultdict(list)
    for joint in joints:
        parents[joint.child].append(joint.name)
        for end, name in (("parent", joint.parent), ("child", joint.child)):
            if name and name not in links:
                fix = f"Define it.{did_you_mean(name, links)}"
                findings.add("R3", f"joint {joint.name}", f"Its {end} {name!r} is no link.", fix)
    for link, names in parents.items():
        if link and len(names) > 1:
            message = f"It is the child of {len(names)} joints: {', '.join(names)}."
            findings.add("R3", f"link {link}", message, "Leave it one parent.")
    parent_of = {joint.child: joint.parent for joint in joints}
    for link in sorted(set(parent_of) & set(links)):
        if _is_in_loop(link, parent_of):
            findings.add("R3", f"link {link}", "It is part of a loop.", "Open the loop.")


def find_root(
    links: Collection[str], joints: Sequence[Joint], wanted: str | None, findings: Findings
) -> str:
    """Return the wanted root, or the only link that is nobody's child."""
    if wanted is not None:
        if wanted not in links:
            fix = f"Name one of its links.{did_you_mean(wanted, links)}"
            findings.add("R3", "root", f"There is no link {wanted!r}.", fix)
        return wanted
    children = {joint.child for joint in joints}
    roots = [link for link in links if link not in children]
    if len(roots) > 1:
        message = f"{len(roots)} links are nobody's child: {', '.join(roots)}."
        findings.add("R3", "root", message, "Join them to one tree.")
    return roots[0] if roots else ""


def find_tip(
    links: Collection[str], joints: Sequence[Joint], wanted: str | None, findings: Findings
) -> str:
    """Return the wanted tip, or a link with a usual name, or the only link without children."""
    if wanted is not None:
        if wanted not in links:
            fix = f"Name one of its links.{did_you_mean(wanted, links)}"
            findings.add("R3", "tip", f"There is no link {wanted!r} below the root.", fix)
        return wanted
    for usual in _USUAL_TIPS:
        if usual in links:
            return usual
    parents = {joint.parent for joint in joints}
    leaves = sorted(link for link in links if link not in parents)
    if len(leaves) != 1:
        message = f"The tip may be any of {', '.join(leaves)}."
        findings.add("R3", "tip", message, "Name the frame at the flange 'tool0'.")
    return leaves[0]


def joints_outwards(root: str, joints: Sequence[Joint]) -> tuple[Joint, ...]:
    """Return the joints below the root, parents first, branches in the order of the file."""
    below = defaultdict(list)
    for joint in joints:
        below[joint.parent].append(joint)
    ordered: list[Joint] = []
    waiting = below[root][::-1]
    while waiting:
        joint = waiting.pop()
        ordered.append(joint)
        waiting += below[joint.child][::-1]
    return tuple(ordered)


def _is_in_loop(link: str, parent_of: dict[str, str]) -> bool:
    at, steps = parent_of[link], 0
    while at != link and at in parent_of and steps <= len(parent_of):
        at, steps = parent_of[at], steps + 1
    return at == link
