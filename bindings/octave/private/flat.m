function list = flat(table, values)
% FLAT  Returns numbers of every point as one list in the order of the points, also for a whole map.
%   A whole map has its points as [rows][columns] or [planes][rows][columns] and is numbered row by row.
points = 1;
if isfield(table, 'x') && isfield(table, 'y')
    points = 2 + isfield(table, 'z');
end
others = points + 1:max(ndims(values), points + 1);
turned = permute(values, [points:-1:1, others]);
sizes = size(turned);
list = reshape(turned, [numel(table.values), sizes(points + 1:end), 1]);
end
