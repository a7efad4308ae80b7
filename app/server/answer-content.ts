import type { IncomingMessage, ServerResponse } from 'node:http';
import { pipeline } from 'node:stream/promises';
import type { Content } from '../services/content.ts';
import type { Origins } from '../services/content-policy.ts';

export async function answerContent(
  content: Content,
  origin: keyof Origins,
  request: IncomingMessage,
  response: ServerResponse,
): Promise<void> {
  const { status, headers, body } = await content.answer(origin, request.method ?? 'GET', request.url ?? '/');
  response.writeHead(status, headers);
  // A visitor who goes away in the middle is no error.
  await pipeline(body, response).catch(() => {});
}
