import type { Capability } from '../../nodes/kit/definition.ts';

/** What a program needs of a session: one entry per capability. */
export interface ProgramNeed {
  readonly capability: Capability;
  readonly required: boolean;
  /** Nodes that need it. */
  readonly nodes: readonly string[];
  readonly why: string;
  readonly without: string;
  /** For the capability `depth`: all nodes that read it prefer measured depth to smoothed depth. Absent: smooth is preferred. */
  readonly depthType?: 'raw';
  /** Node → effect of the missing capability there, for nodes where it differs from `without`; absent if there are none. */
  readonly withoutByNode?: Readonly<Record<string, string>>;
}

/** A kind of session that can play the program, with what it lacks. A program lists its tiers best first. */
export interface Tier {
  readonly id: 'ar-camera' | 'ar' | 'camera' | 'authored-vr' | 'orbit';
  /** Needs that this tier cannot meet, with the effect on the output. */
  readonly without: readonly { readonly capability: Capability; readonly effect: string }[];
}
