import type { Locator } from 'playwright-core';

/** Chooses the option with a value in a list of the editor (`SelectField`). */
export async function chooseOption(list: Locator, value: string | number): Promise<void> {
  await list.click();
  await list.page().locator(`[role="option"][data-value="${value}"]`).click();
}

/** The value of a list of the editor. */
export async function chosenValue(list: Locator): Promise<string | null> {
  return list.getAttribute('data-value');
}
