import type { Capability } from '../../nodes/kit/definition.ts';
import type { ProgramNeed } from '../program/needs.ts';

const WHAT: Readonly<Record<Capability, string>> = {
  'camera-image': 'The camera feed',
  depth: 'The depth of the room',
  'light-estimation': 'The light in the room',
  'hit-test': 'Surfaces you point at',
  anchors: 'Fixed places in the room',
  planes: 'Floors, walls and tables',
  meshes: 'The shape of the room',
  hands: 'Your hands',
  microphone: 'The microphone',
  motion: 'How you move the device',
  location: 'Where you are',
};

/** A feature that the page requests, as a line for the visitor. */
export interface Ask {
  readonly what: string;
  /** Why the feature is requested, and what happens without it. */
  readonly why: string;
  readonly required: boolean;
}

/** Texts for the features of a program, required ones first. Nodes that need the same feature share one line. */
export function asksOf(needs: readonly ProgramNeed[]): readonly Ask[] {
  const capabilities = [...new Set(needs.map((need) => need.capability))];
  const asks = capabilities.map((capability) => {
    const same = needs.filter((need) => need.capability === capability);
    const whys = [...new Set(same.map((need) => bare(need.why)))];
    const withouts = [...new Set(same.map((need) => bare(need.without)))];
    const required = same.some((need) => need.required);
    const reason = sentence(whys.join(', and '));
    return {
      what: WHAT[capability],
      why: required ? `${reason} Required.` : `${reason} Without it: ${sentence(withouts.join('; '), false)}`,
      required,
    };
  });
  return [...asks.filter((ask) => ask.required), ...asks.filter((ask) => !ask.required)];
}

/** Makes a sentence of a text: `to hide objects` → `To hide objects.` */
function sentence(text: string, capital = true): string {
  const first = capital ? text.charAt(0).toUpperCase() : text.charAt(0).toLowerCase();
  return `${first}${text.slice(1)}.`;
}

function bare(text: string): string {
  return text.trim().replace(/[.\s]+$/, '');
}
