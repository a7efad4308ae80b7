import type { Capability } from '../../nodes/kit/definition.ts';
import type { DeviceRow } from '../program/devices/device-table.ts';
import type { ProgramNeed, Tier } from '../program/needs.ts';
import type { NodeOperation } from '../program/program.ts';

/** Names of capabilities in the texts of `scrim plan`, for designers. */
const CAPABILITIES: Readonly<Record<Capability, string>> = {
  'camera-image': 'the camera image',
  depth: 'room depth',
  'light-estimation': 'light estimation',
  'hit-test': 'where the visitor points in the room',
  anchors: 'fixed places in the room',
  planes: 'floors, walls and tables',
  meshes: 'the shape of the room',
  hands: 'the visitor’s hands',
  microphone: 'what the microphone hears',
  motion: 'how the device is moved and where north is',
  location: 'where on Earth the device is',
};

const TIERS: Readonly<Record<Tier['id'], string>> = {
  'ar-camera': 'AR with the camera image, where the browser gives it to pages',
  ar: 'AR',
  camera: 'Camera without AR: its image, with the orientation of the phone',
  'authored-vr': 'VR headset: a virtual room',
  orbit: 'Any other browser: orbit with mouse or finger',
};

/** Describes a need: `room depth, to hide objects behind furniture (room-a); without it nothing is hidden by the room`. */
export function needInWords({ capability, required, nodes, why, without }: ProgramNeed): string {
  const otherwise = required ? 'without it the page does not start' : `without it ${asClause(without)}`;
  return `${CAPABILITIES[capability]}, ${why} (${nodes.join(', ')}); ${otherwise}`;
}

/** Describes a tier: one line for the kind of session, and one for each effect of a missing feature. */
export function tierInWords({ id, without }: Tier): string[] {
  const lost = [...new Set(without.map(({ effect }) => effect))];
  return [TIERS[id], ...(lost.length === 0 ? ['everything works'] : lost.map(asClause))];
}

/** Describes a device: a line for its kind of session, and one for each effect of a missing feature, with its nodes. */
export function deviceInWords({ title, tier, lost, unseen, worthless, display }: DeviceRow): string[] {
  const head = `${title}: ${TIERS[tier]}${display === 'additive' ? ', where black is transparent' : ''}`;
  const dark = unseen.length === 0 ? [] : [`shadows are invisible: use Negative shadow instead (${unseen.join(', ')})`];
  if (lost.length === 0) return [head, ...(dark.length === 0 ? ['everything works'] : dark)];
  const nodesOf = new Map<string, string[]>();
  for (const { effect, fact, node } of lost) {
    const line = fact.has === 'no' ? asClause(effect) : `perhaps ${asClause(effect)}`;
    nodesOf.set(line, [...(nodesOf.get(line) ?? []), node]);
  }
  const lines = [...dark, ...[...nodesOf].map(([line, nodes]) => `${line} (${nodes.join(', ')})`)];
  return worthless ? [head, 'a required feature is missing: the page is of no use here', ...lines] : [head, ...lines];
}

/** Describes the expression or track of a param; null for other operations. */
export function bindingInWords({ id, type, node, config }: NodeOperation): string | null {
  const param = id.slice(node.length + 1, id.lastIndexOf('.'));
  if (type === 'binding/expression') return `${param} of ${node} follows an expression`;
  if (type !== 'binding/track') return null;
  const count = Array.isArray(config.times) ? config.times.length : 0;
  const again = { once: '', loop: ', looping', mirror: ', ping-pong' }[String(config.repeat)] ?? '';
  return `${param} of ${node} follows ${count === 1 ? 'one keyframe' : `${count} keyframes`}${again}`;
}

/** Turns a sentence into a clause: `Nothing is hidden.` becomes `nothing is hidden`. */
function asClause(sentence: string): string {
  const bare = sentence.trim().replace(/[.\s]+$/, '');
  return bare.charAt(0).toLowerCase() + bare.slice(1);
}
