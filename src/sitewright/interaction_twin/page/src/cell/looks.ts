// Colours and materials of the cell; what a colour means is written in the legend beside it.
import { Color, DoubleSide, LineBasicMaterial, MeshLambertMaterial, type Material } from "three";
import type { ComponentRecord } from "../wire";

/** Lanes: colour and number together, so that nobody has to tell colours apart. */
export const ROBOT_COLOURS = ["#2f6f9f", "#b5651d", "#4d7f3d", "#7a569b", "#9c4657", "#3a7d7d"] as const;

export function robotColour(index: number): string {
  return ROBOT_COLOURS[index % ROBOT_COLOURS.length] ?? ROBOT_COLOURS[0];
}

/** Colours of the bodies: those of the lanes, washed out so that the work stands out. */
const BODY_COLOURS = ["#7ba1c0", "#d09a5f", "#8db37e", "#ad94c2", "#c68a95", "#7fb0b0"] as const;

export function bodyColour(index: number): string {
  return BODY_COLOURS[index % BODY_COLOURS.length] ?? BODY_COLOURS[0];
}

export const COLOUR = {
  target: "#4f8cc6",
  active: "#0f7d8c",
  material: "#c6a06c",
  accessible: "#e6bf7f",
  built: "#b5874b",
  underWay: "#e8a93e",
  designed: "#98a3ab",
  keepOut: "#c9543f",
  wrong: "#b3261e",
  selected: "#0b93a5",
  blocker: "#d3321f",
  stale: "#a3abb0",
  fixture: "#cfd2d0",
  floor: "#dfe0dc",
  tool: "#54606a",
  path: "#0b93a5",
} as const;

export type PieceLook = "solid" | "ghost" | "keepOut";

/** Returns how a component is drawn: as a body, as what shall be, or as what to keep out of. */
export function lookOf(component: ComponentRecord): PieceLook {
  if (component.layer === "virtual_collision") return "keepOut";
  return component.layer === "material" || component.layer === "as_built" ? "solid" : "ghost";
}

const WRONG = new Set(["refused", "needs-rework", "stray"]);

export function colourOf(component: ComponentRecord): string {
  if (WRONG.has(component.status)) return COLOUR.wrong;
  switch (component.layer) {
    case "target":
      return component.status === "active" ? COLOUR.active : COLOUR.target;
    case "material":
      if (component.status === "held" || component.status === "used") return COLOUR.underWay;
      return component.accessible ? COLOUR.accessible : COLOUR.material;
    case "as_built":
      return COLOUR.built;
    case "as_designed":
      return COLOUR.designed;
    case "virtual_collision":
      return COLOUR.keepOut;
  }
}

export function pieceMaterial(look: PieceLook): Material {
  if (look === "solid") return new MeshLambertMaterial({ color: 0xffffff });
  const opacity = look === "ghost" ? 0.2 : 0.06;
  return new MeshLambertMaterial({ color: 0xffffff, transparent: true, opacity, depthWrite: false, side: DoubleSide });
}

export function edgeMaterial(look: PieceLook): LineBasicMaterial {
  const colour = { solid: "#5a4220", ghost: COLOUR.target, keepOut: COLOUR.keepOut }[look];
  return new LineBasicMaterial({ color: colour, transparent: true, opacity: look === "solid" ? 0.5 : 0.85 });
}

export const bodyMaterial = (colour: string): MeshLambertMaterial => new MeshLambertMaterial({ color: new Color(colour) });

export const veil = (colour: string, opacity: number): MeshLambertMaterial =>
  new MeshLambertMaterial({ color: new Color(colour), transparent: true, opacity, depthWrite: false });
