"""Writes Sitewright's status.json into the open Rhino document. Run it inside Rhino.

Rhino 7: command EditPythonScript; Rhino 8: command ScriptEditor. Open this file, press run, choose
status.json. Each object that was built gets its user text (sitewright.status ...) and moves to the
layer As-Built; stock that was used moves to the layer Consumed, which is switched off. Layers of
type and group below it stay. Objects that nothing became of yet are left alone. One Undo takes
everything back.
"""

from __future__ import print_function

import io
import json

PREFIX = "sitewright."
USED_LAYER = "Consumed"
ROLES = {
    "target": "target",
    "targets": "target",
    "material": "material",
    "materials": "material",
    "asbuilt": "as_built",
    "asdesigned": "as_designed",
    "consumed": "as_designed",
    "virtualcollision": "virtual_collision",
    "virtualcollisions": "virtual_collision",
}  # add the names of your own layers that import.toml maps


def role_of(name):
    """Return the role of a layer by its name; None if it has none."""
    return ROLES.get("".join(c for c in name.lower() if c not in " \t-_"))


def new_path(path, label):
    """Return the layer path of an object whose role changed; type and group layers stay.

    label is the name of the layer of the new role.
    """
    segments = path.split("::") if path else []
    for index in reversed(range(len(segments))):
        found = role_of(segments[index].partition("[")[0])
        if found is not None:
            is_there = found == role_of(label) and label != USED_LAYER
            kept = segments[index] if is_there else label
            return "::".join(segments[:index] + [kept] + segments[index + 1 :])
    return "::".join([label] + segments)


def move(rs, identity, label):
    """Move an object to the layer of its new role; a new layer for used stock is switched off."""
    old = rs.ObjectLayer(identity)
    path = new_path(old, label)
    names = path.split("::")
    is_new = label in names and not rs.IsLayer("::".join(names[: names.index(label) + 1]))
    if not rs.IsLayer(path):
        rs.AddLayer(path, rs.LayerColor(old))
    rs.ObjectLayer(identity, path)
    if is_new and label == USED_LAYER:
        rs.LayerVisible("::".join(names[: names.index(label) + 1]), False)


def apply_status(rs, status):
    """Write every changed entry; return the ids written and those that the document lacks.

    rs is the module rhinoscriptsyntax.
    """
    written, missing = [], []
    for identity in sorted(status):
        state = status[identity]
        if not state["changed"]:
            continue
        if not rs.IsObject(identity):
            missing.append(identity)
            continue
        for key, value in sorted(state["keys"].items()):
            rs.SetUserText(identity, PREFIX + key, str(value))
        if state["moves_to"]:
            if rs.GetUserText(identity, PREFIX + "layer"):
                rs.SetUserText(identity, PREFIX + "layer", state["layer"])
            move(rs, identity, state["moves_to"])
        written.append(identity)
    return written, missing


def main():
    """Ask for status.json and apply it to the open document."""
    import rhinoscriptsyntax as rs

    name = rs.OpenFileName("status.json", "status.json|*.json||")
    if not name:
        return
    with io.open(name, encoding="utf-8") as file:
        status = json.load(file)
    rs.EnableRedraw(False)
    try:
        written, missing = apply_status(rs, status)
    finally:
        rs.EnableRedraw(True)
    print("{0} objects updated.".format(len(written)))
    for identity in missing:
        print("Not in this document: {0}".format(identity))


if __name__ == "__main__":
    main()
