// Parameters whose values follow from others.
import type { ParameterInfo } from '../engine/protocol';

/// Returns true if any parameter depends on the parameter with a name.
export function anyFollows(parameters: readonly ParameterInfo[], name: string): boolean {
  const follows = ({ expression, written }: ParameterInfo): boolean =>
    expression &&
    (written.match(/[A-Za-z_]\w*/g) ?? []).some(
      (word) => word === name || parameters.some((each) => each.name === word && follows(each)),
    );
  return parameters.some(follows);
}
