import { topologicalOrder } from '../../graph/topology.ts';
import type { ResourceId } from '../../program/program.ts';
import type { ScheduledOperation, Step } from './scheduled.ts';

/**
 * Orders the operations for the runtime: those that run once per frame, then those per view.
 *
 * Once per frame: kind by kind as far as dependencies permit, values first (docs/ARCHITECTURE.md, “Drawing”), in graph order among equals.
 *
 * Per view: in an order that keeps few textures alive, because each has the size of the view. The optimal order is NP-complete for graphs
 * with shared results (Sethi 1975), so this uses the rule of Sethi and Ullman (1970) for trees, as Blender's compositor does: of the
 * textures that an operation reads, the one that needs the most buffers is drawn first. Operations in `onScreen` come last, without
 * interruption and in painter's order, because leaving and re-entering the session's framebuffer makes a tiled GPU store and load it.
 *
 * Operations that write `delayed` images come at the very end: until then these contain the previous frame.
 */
export function orderOperations(
  steps: readonly Step[],
  onScreen: readonly string[],
  delayed: ReadonlySet<ResourceId>,
): ScheduledOperation[] {
  const isCapture = ({ operation }: Step) => operation.writes.some((resource) => delayed.has(resource));
  const each = steps.filter(runs('each'));
  const frame = orderEach(
    each.filter((step) => !isCapture(step)),
    onScreen,
  );
  const ordered = [...orderOnce(steps.filter(runs('once'))), ...frame, ...orderCaptures(each.filter(isCapture))];
  return ordered.map(({ operation }) => operation);
}

function runs(view: 'once' | 'each') {
  return ({ operation }: Step) => operation.view === view;
}

const ONCE_KINDS: readonly ScheduledOperation['kind'][] = [
  'value',
  'source',
  'behavior',
  'geometry',
  'shadow-maps',
  'pass',
  'cpu',
  'readback',
];

function orderOnce(steps: readonly Step[]): Step[] {
  const rank = ({ operation }: Step) => ONCE_KINDS.indexOf(operation.kind);
  const sorted = [...steps].sort((a, b) => rank(a) - rank(b));
  return needsFirst(sorted, stepsById(steps), ({ after }) => after);
}

function orderEach(steps: readonly Step[], onScreen: readonly string[]): Step[] {
  const byId = stepsById(steps);
  const buffers = buffersNeeded(steps, byId);
  const mostFirst = ({ after }: Step) => [...after].sort((a, b) => (buffers.get(b) ?? 0) - (buffers.get(a) ?? 0));
  const screen = onScreen.flatMap((id) => byId.get(id) ?? []);
  const shown = screen.flatMap(mostFirst).flatMap((id) => byId.get(id) ?? []);
  const last = new Set(screen);
  const pictures = needsFirst([...shown, ...steps.filter((step) => !last.has(step))], byId, mostFirst);
  return [...pictures, ...screen];
}

/**
 * A capture that reads the target of another one comes first, so that it reads the previous frame. Captures that read each other cannot be
 * ordered.
 */
function orderCaptures(steps: readonly Step[]): Step[] {
  const readersOf = ({ operation }: Step) =>
    steps
      .filter((other) => other.operation.reads.some((resource) => operation.writes.includes(resource)))
      .map((other) => other.operation.id);
  return needsFirst(steps, stepsById(steps), readersOf);
}

/** Maximum number of textures alive while the texture of a step is drawn, with its inputs in the best order (Sethi–Ullman numbers). */
function buffersNeeded(steps: readonly Step[], byId: ReadonlyMap<string, Step>): ReadonlyMap<string, number> {
  const followers = new Map<string, string[]>(steps.map(({ operation }) => [operation.id, []]));
  for (const { operation, after } of steps) for (const id of after) followers.get(id)?.push(operation.id);
  const buffers = new Map<string, number>();
  for (const id of topologicalOrder(followers.keys(), (vertex) => followers.get(vertex) ?? []).order) {
    const needs = (byId.get(id)?.after ?? []).map((before) => buffers.get(before) ?? 0).sort((a, b) => b - a);
    buffers.set(id, Math.max(1, ...needs.map((need, kept) => need + kept)));
  }
  return buffers;
}

/** Depth-first order in which each root comes after its dependencies. Uses its own stack, because chains can be long. */
function needsFirst(roots: readonly Step[], byId: ReadonlyMap<string, Step>, needs: (step: Step) => readonly string[]): Step[] {
  const ordered: Step[] = [];
  const seen = new Set<Step>();
  for (const root of roots) {
    const open: { readonly step: Step; readonly rest: string[] }[] = [];
    const enter = (step: Step) => {
      if (seen.has(step)) return;
      seen.add(step);
      open.push({ step, rest: [...needs(step)].reverse() });
    };
    enter(root);
    for (let top = open.at(-1); top; top = open.at(-1)) {
      const id = top.rest.pop();
      const need = id === undefined ? undefined : byId.get(id);
      if (need) enter(need);
      else if (id === undefined) {
        ordered.push(top.step);
        open.pop();
      }
    }
  }
  return ordered;
}

function stepsById(steps: readonly Step[]): ReadonlyMap<string, Step> {
  return new Map(steps.map((step) => [step.operation.id, step]));
}
