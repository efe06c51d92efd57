// Marks that differ by form as well as by colour.
import type { Pen } from './pen';

export type Mark = 'up' | 'down' | 'square' | 'ring' | 'cross' | 'dot';

/// Draws a mark about two `radius` wide, in the pen's fill and stroke.
export function drawMark(pen: Pen, mark: Mark, x: number, y: number, radius: number): void {
  pen.beginPath();
  switch (mark) {
    case 'up':
    case 'down': {
      const tip = mark === 'up' ? -radius : radius;
      pen.moveTo(x, y + 1.15 * tip);
      pen.lineTo(x + radius, y - 0.75 * tip);
      pen.lineTo(x - radius, y - 0.75 * tip);
      pen.closePath();
      pen.fill();
      return;
    }
    case 'square':
      pen.rect(x - 0.8 * radius, y - 0.8 * radius, 1.6 * radius, 1.6 * radius);
      pen.fill();
      return;
    case 'cross':
      pen.moveTo(x - radius, y - radius);
      pen.lineTo(x + radius, y + radius);
      pen.moveTo(x - radius, y + radius);
      pen.lineTo(x + radius, y - radius);
      pen.stroke();
      return;
    default:
      pen.moveTo(x + radius, y);
      pen.arc(x, y, radius, 0, 2 * Math.PI);
      if (mark === 'dot') pen.fill();
      else pen.stroke();
  }
}
