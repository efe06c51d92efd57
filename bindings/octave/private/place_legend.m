function place_legend(axes_handle, marks, names, x, y)
% PLACE_LEGEND  Places a legend in a corner of the axes without points (at X, Y); outside if there is no such corner.
%   The location 'best' is unknown to gnuplot in Octave. Without X and Y the legend is outside.
longest = max(cellfun(@numel, names));
look = {'Interpreter', 'tex', 'Box', 'off', 'FontSize', 9};
corner = '';
if nargin > 4
    position = get(axes_handle, 'Position');
    corner = free_corner(axes_handle, x(:), y(:), (0.13 + 0.0135 * longest) / position(3), ...
        (0.02 + 0.053 * numel(names)) / position(4));
end
if ~isempty(corner)
    legend(axes_handle, marks, names, 'Location', corner, look{:});
    return
end
% Place it next to the axes, or above them with gnuplot, which would give it half of the figure.
place = {'eastoutside', 'Orientation', 'vertical'};
if drawn_by_gnuplot(axes_handle)
    place = {'northoutside', 'Orientation', 'horizontal'};
end
legend(axes_handle, marks, names, 'Location', place{:}, look{:});
end

function yes = drawn_by_gnuplot(axes_handle)
% Returns true in Octave if gnuplot draws the figure; figures of MATLAB have no toolkit.
figure_handle = ancestor(axes_handle, 'figure');
yes = isprop(figure_handle, '__graphics_toolkit__') && strcmp(get(figure_handle, '__graphics_toolkit__'), 'gnuplot');
end

function corner = free_corner(axes_handle, x, y, width, height)
limits = axis(axes_handle);
x = (x - limits(1)) / (limits(2) - limits(1));
y = (y - limits(3)) / (limits(4) - limits(3));
corners = {'northeast', 'northwest', 'southeast', 'southwest'};
right = x > 1 - width;
left = x < width;
above = y > 1 - height;
below = y < height;
hidden = {right & above, left & above, right & below, left & below};
free = find(~cellfun(@any, hidden), 1);
corner = [corners{free}];
end
