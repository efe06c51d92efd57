function handle = draw_marks(axes_handle, x, y, marker, points, rgb, filled)
% DRAW_MARKS  Draws marks without a line, of a size in points and one colour, filled unless FILLED is false.
inside = rgb;
if nargin > 6 && ~filled
    inside = 'none';
end
if isempty(x)
    % Make an invisible object if there are no points, so that there is always a handle.
    x = NaN;
    y = NaN;
end
handle = plot(axes_handle, x(:), y(:), 'LineStyle', 'none', 'Marker', marker, 'MarkerSize', points, 'Color', rgb, ...
    'MarkerEdgeColor', rgb, 'MarkerFaceColor', inside);
end
