import { describe, expect, test } from '@jest/globals';
import { type AnchorStorage, createAnchorMemory } from './anchor-memory.ts';
import { forgetAnchor, KEPT_LIMIT, keepAnchor } from './keep-anchor.ts';

function createStorage(): AnchorStorage & { text: string | null } {
  return {
    text: null,
    getItem() {
      return this.text;
    },
    setItem(_key, text) {
      this.text = text;
    },
  };
}

/** A device that keeps so many anchors. */
function createDevice(limit = KEPT_LIMIT) {
  const kept = new Set<string>();
  let made = 0;
  const session = {
    deletePersistentAnchor: async (handle: string) => {
      if (!kept.delete(handle)) throw new Error('There is none.');
    },
  } as unknown as XRSession;
  const anchor = (): XRAnchor =>
    ({
      requestPersistentHandle: async () => {
        if (kept.size >= limit) throw new Error('Anchor creation failed.');
        const handle = `handle-${++made}`;
        kept.add(handle);
        return handle;
      },
    }) as unknown as XRAnchor;
  return { kept, session, anchor };
}

const entry = (name: string) => ({ name, anchorFromPose: null });

describe('anchors over visits', () => {
  test('are found by their name in a later visit, on their page alone', async () => {
    const storage = createStorage();
    const { session, anchor } = createDevice();
    const anchorFromPose = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0.5, 0, 1];
    await keepAnchor(anchor(), session, createAnchorMemory(storage, '/a'), { name: 'table', anchorFromPose });
    expect(createAnchorMemory(storage, '/a').find('table')).toEqual({ page: '/a', name: 'table', handle: 'handle-1', anchorFromPose });
    expect(createAnchorMemory(storage, '/a').find('wall')).toBe(null);
    expect(createAnchorMemory(storage, '/b').find('table')).toBe(null);
  });

  test('replace the earlier one of their name, on the device too', async () => {
    const { kept, session, anchor } = createDevice();
    const memory = createAnchorMemory(createStorage(), '/');
    for (let i = 0; i < 3; i++) expect(await keepAnchor(anchor(), session, memory, entry('table'))).toEqual({ kept: true, evicted: 0 });
    expect([[...kept], memory.count, memory.find('table')?.handle]).toEqual([['handle-3'], 1, 'handle-3']);
  });

  test('a ninth replaces the oldest of the origin, and says so', async () => {
    const storage = createStorage();
    const { kept, session, anchor } = createDevice();
    const [first, second] = [createAnchorMemory(storage, '/first'), createAnchorMemory(storage, '/second')];
    await keepAnchor(anchor(), session, first, entry('oldest'));
    for (let i = 2; i <= 8; i++) await keepAnchor(anchor(), session, second, entry(`anchor ${i}`));
    expect([kept.size, second.count]).toEqual([8, 8]);
    expect(await keepAnchor(anchor(), session, second, entry('ninth'))).toEqual({ kept: true, evicted: 1 });
    expect([kept.size, first.find('oldest'), second.find('anchor 2') !== null, second.find('ninth')?.handle]).toEqual([
      8,
      null,
      true,
      'handle-9',
    ]);
  });

  test('nothing is deleted for one that the device refuses for another reason', async () => {
    const { kept, session, anchor } = createDevice();
    const memory = createAnchorMemory(createStorage(), '/');
    await keepAnchor(anchor(), session, memory, entry('table'));
    const refusing = { requestPersistentHandle: () => Promise.reject(new Error('No.')) } as unknown as XRAnchor;
    expect(await keepAnchor(refusing, session, memory, entry('wall'))).toEqual({ kept: false, evicted: 0 });
    expect(await keepAnchor({} as XRAnchor, session, memory, entry('door'))).toEqual({ kept: false, evicted: 0 });
    expect([[...kept], memory.count]).toEqual([['handle-1'], 1]);
  });

  test('one that refuses all the time does not wait for ever', async () => {
    const { session, anchor } = createDevice(0);
    const memory = createAnchorMemory(createStorage(), '/');
    for (let i = 0; i < KEPT_LIMIT; i++) memory.add({ ...entry(`anchor ${i}`), handle: `gone ${i}` });
    expect(await keepAnchor(anchor(), session, memory, entry('table'))).toEqual({ kept: false, evicted: 1 });
  });

  test('are forgotten, also if the device has done so already', async () => {
    const { kept, session, anchor } = createDevice();
    const memory = createAnchorMemory(createStorage(), '/');
    await keepAnchor(anchor(), session, memory, entry('table'));
    kept.clear();
    const found = memory.find('table');
    if (found) await forgetAnchor(session, memory, found);
    expect(memory.find('table')).toBe(null);
  });
});

describe('the list of kept anchors', () => {
  test.each([
    ['no storage', null],
    [
      'a storage that throws',
      {
        getItem: () => {
          throw new Error('SecurityError');
        },
        setItem: () => {
          throw new Error('SecurityError');
        },
      },
    ],
  ])('lasts as long as the page with %s', (_what, storage) => {
    const memory = createAnchorMemory(storage, '/');
    memory.add({ ...entry('table'), handle: 'a' });
    expect([memory.find('table')?.handle, memory.count]).toEqual(['a', 1]);
    memory.remove('a');
    expect(memory.oldest()).toBe(null);
  });

  test.each(['nonsense', '{}', 'null', '[1, null, {}]', '[{"page":"/","name":"table","handle":"a","anchorFromPose":[1]}]'])(
    'ignores %s in the storage, which other scripts may have written',
    (text) => {
      const memory = createAnchorMemory({ getItem: () => text, setItem: () => {} }, '/');
      expect([memory.count, memory.find('table'), memory.oldest()]).toEqual([0, null, null]);
    },
  );
});
