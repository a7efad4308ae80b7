import './no-host.css';
import { Logo } from './logo.tsx';

/** Shown instead of the editor if the server refuses the address. */
export function NoHost({ why }: { readonly why: string }) {
  return (
    <main className="no-host">
      <Logo />
      <h1>Invalid address</h1>
      <p>{why}</p>
    </main>
  );
}
