import { createContext, useContext } from 'react';
import type { Feed } from '../state/feed.ts';

const FeedContext = createContext<Feed | null>(null);

export const FeedProvider = FeedContext.Provider;

export function useFeed(): Feed {
  const feed = useContext(FeedContext);
  if (!feed) throw new Error('useFeed is only there below FeedProvider.');
  return feed;
}
