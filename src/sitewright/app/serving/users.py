"""The users file: names, roles and the hashes of their tokens.

[[user]]
name = "anna"
role = "supervisor"
token_sha256 = "..."
pin_scrypt = "..." # if the person has a PIN
"""

from __future__ import annotations

import hashlib
import re
import secrets
import tomllib
from pathlib import Path
from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from sitewright.app.project import ProjectError
from sitewright.interaction_twin.roles import Role
from sitewright.interaction_twin.web.pins import new_pin_hash
from sitewright.interaction_twin.web.requests import PIN
from sitewright.interaction_twin.web.sessions import User


class _UserEntry(BaseModel):
    model_config = ConfigDict(extra="forbid")
    name: Annotated[str, Field(pattern=r"^[A-Za-z0-9][A-Za-z0-9 ._-]{0,39}$")]
    role: Role
    token_sha256: Annotated[str, Field(pattern=r"^[0-9a-f]{64}$")]
    pin_scrypt: Annotated[str, Field(pattern=r"^([0-9a-f]{32}\$[0-9a-f]{64})?$")] = ""


class _UsersFile(BaseModel):
    model_config = ConfigDict(extra="forbid")
    user: list[_UserEntry]


def read_users(file: Path) -> dict[str, User]:
    """Return the users of a file by name.

    Raises:
        ProjectError: It cannot be read, or says the same name twice.
    """
    try:
        found = _UsersFile.model_validate(tomllib.loads(file.read_text(encoding="utf-8")))
    except (OSError, tomllib.TOMLDecodeError, UnicodeDecodeError, ValidationError) as error:
        raise ProjectError(
            f"The users file {file} cannot be read: {error}. "
            "`sitewright user NAME --role ROLE` writes an entry."
        ) from error
    users = {
        u.name: User(name=u.name, role=u.role, token_sha256=u.token_sha256, pin_scrypt=u.pin_scrypt)
        for u in found.user
    }
    if len(users) != len(found.user) or "local" in users:
        raise ProjectError(f"The users file {file} has a name twice, or uses the name local.")
    return users


def new_user(file: Path, name: str, role: Role, *, pin: str = "") -> str:
    """Add a user to a file and return the token, which is kept nowhere else.

    Args:
        file: The users file.
        name: Of the person.
        role: What the person may do.
        pin: 4 to 12 digits for shared tablets; empty if the person has none.

    Raises:
        ProjectError: The file cannot be read, or has the name already; the PIN is none.
    """
    if not re.fullmatch(PIN, pin):
        raise ProjectError("A PIN has 4 to 12 digits.")
    known = read_users(file) if file.exists() else {}
    if name in known or name == "local":
        raise ProjectError(f"{file} has a user {name!r} already; remove that entry first.")
    token = secrets.token_urlsafe(32)
    digest = hashlib.sha256(token.encode()).hexdigest()
    kept = new_pin_hash(pin) if pin else ""
    entry = _UserEntry(name=name, role=role, token_sha256=digest, pin_scrypt=kept)
    text = "".join(
        f'[[user]]\n{key} = "{value}"\n' if key == "name" else f'{key} = "{value}"\n'
        for key, value in entry.model_dump(mode="json", exclude_defaults=True).items()
    )
    before = file.read_text(encoding="utf-8") if file.exists() else ""
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(f"{before}{text}\n", encoding="utf-8")
    file.chmod(0o600)
    return token
