import type { Scene } from 'three';
import type { ObjectItem, ObjectList } from '../../../../nodes/kit/scene-lists.ts';
import { createVersionWatch } from '../../../../nodes/kit/version-watch.ts';
import { type Drawable, isDrawable } from './drawable.ts';
import { createProxy, type FlatProxy, type ProxyPlan } from './proxy.ts';

export type PlanProxies = (master: Drawable, item: ObjectItem) => readonly ProxyPlan[];

/** The proxies of several lists in one scene: rebuilt if a list's version changed, otherwise only moved. */
export interface ProxySet {
  readonly proxies: readonly FlatProxy[];
  /** Updates the proxies from the lists. Returns whether they were rebuilt; `force` rebuilds them in any case. */
  update(lists: readonly ObjectList[], force: boolean): boolean;
  dispose(): void;
}

export function createProxySet(scene: Scene, plan: PlanProxies): ProxySet {
  const proxies: FlatProxy[] = [];
  const watch = createVersionWatch();

  function clear(): void {
    for (const proxy of proxies) proxy.dispose();
    proxies.length = 0;
  }

  function build(lists: readonly ObjectList[]): void {
    clear();
    for (const list of lists) {
      for (const item of list.items) {
        item.root.traverse((object) => {
          if (!isDrawable(object)) return;
          for (const part of plan(object, item)) proxies.push(createProxy(object, item, part));
        });
      }
    }
    for (const { object } of proxies) scene.add(object);
  }

  return {
    proxies,
    update: (lists, force) => {
      const changed = watch.changed(lists) || force;
      if (changed) build(lists);
      for (const proxy of proxies) proxy.update();
      return changed;
    },
    dispose: clear,
  };
}
