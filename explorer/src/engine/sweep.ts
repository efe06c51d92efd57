// Division of a diagram into parts of points, and their order.

/// Values of a diagram that one task computes.
export interface Part {
  /// Slots of the diagram, in the order of the computation.
  readonly slots: Uint32Array;
  readonly carried: boolean;
}

/// Number of points of a part: as many as the core computes at the same time.
const PART_SIZE = 16;

const range = (count: number) => Array.from({ length: count }, (_, index) => index);

/// Divides the points into parts. Carried points, each of which starts from the one before, are one part; other points
/// are divided in their order.
export function partsOf(count: number, carry: 'none' | 'forward' | 'reverse' | 'both'): Part[] {
  const chain = (slots: number[]) => ({ slots: Uint32Array.from(slots), carried: true });
  if (carry === 'forward') return [chain(range(count))];
  if (carry === 'reverse') return [chain(range(count).reverse())];
  // Give the way back slots of its own after the others, in the order of the values.
  if (carry === 'both')
    return [
      chain(range(count)),
      chain(
        range(count)
          .reverse()
          .map((index) => count + index),
      ),
    ];
  const parts: Part[] = [];
  for (let first = 0; first < count; first += PART_SIZE)
    parts.push({
      slots: Uint32Array.from(range(Math.min(PART_SIZE, count - first)), (index) => first + index),
      carried: false,
    });
  return parts;
}
