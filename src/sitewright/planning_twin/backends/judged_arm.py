"""Judges an arm at load: closed form, closed form on rails, or iterations, and why."""

from __future__ import annotations

import numpy as np

from sitewright.planning_twin.backends.kinematic_chain import Array, KinematicChain, chain_of
from sitewright.planning_twin.backends.numeric_kinematics import NumericSolver
from sitewright.planning_twin.backends.opw_geometry import NotOpw, opw_geometry
from sitewright.planning_twin.backends.opw_solver import OpwSolver
from sitewright.planning_twin.backends.rail_solver import RailSolver, arm_behind, rails_before
from sitewright.planning_twin.backends.solver import Solver
from sitewright.planning_twin.motion import ArmVerdict, InverseKind
from sitewright.robot_team.description import Description

_CHECKED_POSTURES = 500
_CHECK_TOLERANCE = 1e-9
"""Largest difference of any entry of the pose, between closed form and the URDF's own frames."""


def judged(description: Description) -> tuple[Solver, ArmVerdict]:
    """Return how an arm's inverse kinematics are solved, and why so.

    The closed form is taken only if its forward kinematics equal those of the URDF on 500 seeded
    postures inside the limits. An arm that branches between its joints is a TeamError.
    """
    chain = chain_of(description)
    rails = rails_before(chain)
    arm = arm_behind(chain, rails)
    geometry = opw_geometry(arm)
    if isinstance(geometry, NotOpw):
        return _by_iterations(chain, rails, geometry.reason)
    solver = OpwSolver(arm, geometry)
    error = solver.error(_checked(arm))
    if not error <= _CHECK_TOLERANCE:
        reason = f"the closed form differs from the URDF's own kinematics by {error:.1e}"
        return _by_iterations(chain, rails, reason, error)
    if rails == 0:
        verdict = ArmVerdict(
            kind=InverseKind.CLOSED_FORM, joints=chain.joints, rails=0, fk_error=error
        )
        return solver, verdict
    on_rails = RailSolver(chain, solver, rails)
    verdict = ArmVerdict(
        kind=InverseKind.CLOSED_FORM_ON_RAILS, joints=chain.joints, rails=rails, fk_error=error
    )
    return on_rails, verdict


def _by_iterations(
    chain: KinematicChain, rails: int, reason: str, error: float = 0.0
) -> tuple[Solver, ArmVerdict]:
    verdict = ArmVerdict(
        kind=InverseKind.ITERATIONS,
        joints=chain.joints,
        rails=rails,
        fk_error=error,
        reason=reason,
    )
    return NumericSolver(chain), verdict


def _checked(chain: KinematicChain) -> Array:
    random = np.random.default_rng(0)
    return random.uniform(chain.lower, chain.upper, (_CHECKED_POSTURES, chain.joints))
