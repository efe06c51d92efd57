function edges = cell_edges(values)
% CELL_EDGES  Where the cells around values end: halfway to their neighbours, the outer ones as far on the other side.
values = values(:);
if numel(values) == 1
    half = 0.5 * abs(values) + 0.5 * (values == 0);
    edges = [values - half; values + half];
else
    middles = 0.5 * (values(1:end - 1) + values(2:end));
    edges = [2 * values(1) - middles(1); middles; 2 * values(end) - middles(end)];
end
end
