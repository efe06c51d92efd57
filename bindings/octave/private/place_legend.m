function place_legend(axes_handle, marks, names, x, y)
% PLACE_LEGEND  A legend in the corner of the axes where no points are (these lie at X, Y), outside where there is none.
%   Octave's gnuplot knows no best place, so it is found here. Without X and Y the legend is outside.
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
% Beside the axes gnuplot would leave half of the figure to it.
place = {'eastoutside', 'Orientation', 'vertical'};
if drawn_by_gnuplot(axes_handle)
    place = {'northoutside', 'Orientation', 'horizontal'};
end
legend(axes_handle, marks, names, 'Location', place{:}, look{:});
end

function yes = drawn_by_gnuplot(axes_handle)
% Never true in MATLAB, whose figures tell no toolkit.
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
