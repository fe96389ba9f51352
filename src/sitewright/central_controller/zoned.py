"""Proposals that also keep out of the zones that people drew during the run."""

from __future__ import annotations

from dataclasses import dataclass, replace

from sitewright.central_controller.ports import (
    Alternative,
    FactsChanged,
    ProposalOutcome,
    SiteContext,
    StillClear,
)
from sitewright.central_controller.proposal import ProposedStep
from sitewright.central_controller.proposing import Proposals
from sitewright.central_controller.steering import with_zones
from sitewright.foundation.ids import ComponentId
from sitewright.planning_twin.refusal import StaleCertificate
from sitewright.robot_team.skill import SkillCall


@dataclass(frozen=True, slots=True)
class ZonedProposals:
    """Ports `ProposalSource` and `StartCheck` for a cell whose zones can change.

    Attributes:
        source: For the cell as its file has it.
    """

    source: Proposals

    def propose(
        self, context: SiteContext, *, exclude: frozenset[ComponentId] = frozenset()
    ) -> ProposalOutcome:
        """Plan the next target."""
        return self.at(context).propose(context, exclude=exclude)

    def alternatives(self, context: SiteContext) -> tuple[Alternative, ...]:
        """Return what could be done next instead."""
        return self.at(context).alternatives(context)

    def propose_single(self, context: SiteContext, call: SkillCall) -> ProposalOutcome:
        """Plan one chosen call."""
        return self.at(context).propose_single(context, call)

    def check(
        self, step: ProposedStep, context: SiteContext
    ) -> StillClear | StaleCertificate | FactsChanged:
        """Check a step once more, right before it starts."""
        return self.at(context).check(step, context)

    def strays(self, context: SiteContext) -> frozenset[ComponentId]:
        """Return the pieces that no plan counts on where they lie."""
        return self.source.strays(context)

    def at(self, context: SiteContext) -> Proposals:
        """Return the source for the zones of a site."""
        if not context.site.zones:
            return self.source
        return replace(self.source, design=with_zones(self.source.design, context.site))
