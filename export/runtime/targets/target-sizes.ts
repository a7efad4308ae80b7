import type { Program, ResourceId, TargetSize } from '../../program/program.ts';
import type { PlayState } from '../play-state.ts';
import type { LiveResource, LiveResources } from '../resources/resources.ts';
import type { Slots } from '../values/slots.ts';
import { evaluateSize } from './evaluate-size.ts';
import type { Target } from './target.ts';

/** Resizes the targets of each domain before operations draw to them. */
export interface TargetSizes {
  /** Resizes the targets of the image domain. Called once per frame. */
  resizeImages(state: PlayState): void;
  /** Resizes the targets of the view domain. Called at the start of each view. */
  resizeViews(state: PlayState): void;
  trim(viewCount: number): void;
}

/** What a size is relative to: the view, an image or another target. */
type Base =
  | { readonly kind: 'view' }
  | { readonly kind: 'external'; readonly resource: Extract<LiveResource, { kind: 'external' }> }
  | Sized;

interface Sized {
  readonly kind: 'target';
  readonly domain: 'view' | 'image';
  readonly target: Target;
  readonly size: TargetSize;
  readonly base: Base;
  widthPx: number;
  heightPx: number;
}

export function createTargetSizes(program: Program, resources: LiveResources, slots: Slots, maxPx: number): TargetSizes {
  const ordered = basesFirst(program, resources);
  const resize = (state: PlayState, domain: 'view' | 'image', viewIndex: number): void => {
    for (let i = 0; i < ordered.length; i++) {
      const sized = ordered[i];
      if (sized?.domain !== domain) continue;
      const widthPx = baseWidth(sized.base, state);
      const heightPx = baseHeight(sized.base, state);
      sized.widthPx = evaluateSize(sized.size.width, widthPx, heightPx, slots, maxPx);
      sized.heightPx = evaluateSize(sized.size.height, widthPx, heightPx, slots, maxPx);
      sized.target.resize(viewIndex, sized.widthPx, sized.heightPx);
    }
  };
  return {
    resizeImages: (state) => resize(state, 'image', 0),
    resizeViews: (state) => resize(state, 'view', state.viewIndex),
    trim: (viewCount) => {
      for (const { target } of ordered) target.trim(viewCount);
    },
  };
}

/**
 * Width to which a size is relative, pixels. For an image of the view domain that is the width of the view, whatever the size of its
 * texture.
 */
function baseWidth(base: Base, state: PlayState): number {
  if (base.kind === 'target') return base.widthPx;
  if (base.kind === 'view' || base.resource.domain === 'view') return state.widthPx;
  return base.resource.layer.views[0]?.widthPx ?? 0;
}

function baseHeight(base: Base, state: PlayState): number {
  if (base.kind === 'target') return base.heightPx;
  if (base.kind === 'view' || base.resource.domain === 'view') return state.heightPx;
  return base.resource.layer.views[0]?.heightPx ?? 0;
}

function basesFirst(program: Program, resources: LiveResources): Sized[] {
  const ordered: Sized[] = [];
  const done = new Map<ResourceId, Base>([['view', { kind: 'view' }]]);
  const open = new Set<ResourceId>();
  const specs = new Map(program.resources.map((r) => [r.id, r]));
  const visit = (id: ResourceId): Base => {
    const known = done.get(id);
    if (known) return known;
    const live = resources.get(id);
    const spec = specs.get(id);
    if (open.has(id)) throw new Error(`The size of ${id} depends on itself.`);
    open.add(id);
    let base: Base;
    if (live?.kind === 'external') {
      base = { kind: 'external', resource: live };
    } else if (live?.kind === 'target' && spec?.kind === 'target') {
      base = {
        kind: 'target',
        domain: live.domain,
        target: live.target,
        size: spec.size,
        base: visit(spec.size.base),
        widthPx: 1,
        heightPx: 1,
      };
      ordered.push(base);
    } else {
      throw new Error(`A size is relative to ${id}, which has none.`);
    }
    done.set(id, base);
    return base;
  };
  for (const resource of program.resources) if (resource.kind === 'target') visit(resource.id);
  return ordered;
}
