function points = points_once(table, name)
% POINTS_ONCE  The points to be drawn: all, but of several starts of a place the first that leads to each attractor.
points = (1:numel(table.values))';
if ~has_attractors(table, name) || strcmp(name, 'basin')
    return
end
attractor = double(flat(table, table.attractor));
% A motion without a verdict is like no other.
alone = attractor == 0;
attractor(alone) = -points(alone);
[ignored, first] = unique([places_of(table), attractor], 'rows', 'first'); %#ok<ASGLU>
points = sort(first);
end
