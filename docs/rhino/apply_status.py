"""Writes Sitewright's status.json into the open Rhino document. Run it inside Rhino.

Rhino 7: command EditPythonScript; Rhino 8: command ScriptEditor. Open this file, press run, choose
status.json. Each object that was built gets its user text (sitewright.status ...) and moves to the
layer As-Built; layers of type and group below it stay. One Undo takes everything back.
"""

from __future__ import print_function

import io
import json

PREFIX = "sitewright."
ROLES = {
    "target": "target",
    "targets": "target",
    "material": "material",
    "materials": "material",
    "asbuilt": "as_built",
    "asdesigned": "as_designed",
    "virtualcollision": "virtual_collision",
    "virtualcollisions": "virtual_collision",
}  # add the names of your own layers that import.toml maps


def new_path(path, role):
    """Return the layer path of an object whose role changed; type and group layers stay."""
    label = "-".join(word.capitalize() for word in role.split("_"))
    segments = path.split("::") if path else []
    for index in reversed(range(len(segments))):
        name = segments[index].partition("[")[0]
        found = ROLES.get("".join(c for c in name.lower() if c not in " \t-_"))
        if found is not None:
            kept = segments[index] if found == role else label
            return "::".join(segments[:index] + [kept] + segments[index + 1 :])
    return "::".join([label] + segments)


def apply_status(rs, status):
    """Write every entry; return the ids written and the ids that the document does not have.

    rs is the module rhinoscriptsyntax.
    """
    written, missing = [], []
    for identity in sorted(status):
        if not rs.IsObject(identity):
            missing.append(identity)
            continue
        state = status[identity]
        for key, value in sorted(state["keys"].items()):
            rs.SetUserText(identity, PREFIX + key, str(value))
        if rs.GetUserText(identity, PREFIX + "layer"):
            rs.SetUserText(identity, PREFIX + "layer", state["layer"])
        old = rs.ObjectLayer(identity)
        path = new_path(old, state["layer"])
        if not rs.IsLayer(path):
            rs.AddLayer(path, rs.LayerColor(old))
        rs.ObjectLayer(identity, path)
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
