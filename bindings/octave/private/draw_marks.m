function handle = draw_marks(axes_handle, x, y, marker, points, rgb, filled)
% DRAW_MARKS  Marks of a size in points without a line, of one colour, filled unless FILLED is false.
inside = rgb;
if nargin > 6 && ~filled
    inside = 'none';
end
if isempty(x)
    % There is an object also where nothing is to be seen.
    x = NaN;
    y = NaN;
end
handle = plot(axes_handle, x(:), y(:), 'LineStyle', 'none', 'Marker', marker, 'MarkerSize', points, 'Color', rgb, ...
    'MarkerEdgeColor', rgb, 'MarkerFaceColor', inside);
end
