function handle = draw_cells(axes_handle, x, y, cover, colours)
% DRAW_CELLS  The cells of a plane around values x (columns) and y (rows), each in the colour of the point that COVER
%   has there: COLOURS is [points][3], or [points] numbers, which go by the colours of the axes. Cells without a point,
%   and those of NaN, stay empty.
%   They are faces of one patch, in the order of the columns: pictures have cells of one size, and gnuplot draws
%   surfaces as if they were seen in space.
x_edges = cell_edges(x);
y_edges = cell_edges(y);
[x_corners, y_corners] = meshgrid(x_edges, y_edges);
[column, row] = meshgrid(1:numel(x), 1:numel(y));
there = find(cover(:) > 0);
there = there(~any(isnan(colours(cover(there), :)), 2));
height = numel(y_edges);
corner = row(there) + (column(there) - 1) * height;
handle = patch('Parent', axes_handle, 'Vertices', [x_corners(:), y_corners(:)], ...
    'Faces', [corner, corner + 1, corner + height + 1, corner + height], ...
    'FaceVertexCData', colours(cover(there), :), 'FaceColor', 'flat', 'EdgeColor', 'none');
axis(axes_handle, [min(x_edges), max(x_edges), min(y_edges), max(y_edges)]);
end
