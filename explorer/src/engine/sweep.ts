// A diagram in parts: which points go together, and in which order.

/// Values of a diagram that one task computes.
export interface Part {
  /// Slots of the diagram, in the order of the computation.
  readonly slots: Uint32Array;
  readonly carried: boolean;
}

/// Points that fill the lanes of the core once.
const PART_SIZE = 16;

/// All numbers below `count`, coarse to fine: the ends first, then what halves the gaps.
export function coarseToFine(count: number): number[] {
  const order: number[] = [];
  const taken = new Uint8Array(count);
  const take = (index: number) => {
    if (taken[index]) return;
    taken[index] = 1;
    order.push(index);
  };
  if (count > 0) take(0);
  if (count > 1) take(count - 1);
  let stride = 1;
  while (stride < count) stride *= 2;
  for (; stride >= 1; stride /= 2) for (let index = 0; index < count; index += stride) take(index);
  return order;
}

const range = (count: number) => Array.from({ length: count }, (_, index) => index);

/// Points that follow one another are one part; of the others, some that lie far from each other.
export function partsOf(count: number, carry: 'none' | 'forward' | 'reverse' | 'both'): Part[] {
  const chain = (slots: number[]) => ({ slots: Uint32Array.from(slots), carried: true });
  if (carry === 'forward') return [chain(range(count))];
  if (carry === 'reverse') return [chain(range(count).reverse())];
  // The way back has slots of its own behind the others, in the order of the values.
  if (carry === 'both')
    return [
      chain(range(count)),
      chain(
        range(count)
          .reverse()
          .map((index) => count + index),
      ),
    ];
  const order = coarseToFine(count);
  const parts: Part[] = [];
  for (let first = 0; first < count; first += PART_SIZE)
    parts.push({ slots: Uint32Array.from(order.slice(first, first + PART_SIZE)), carried: false });
  return parts;
}
