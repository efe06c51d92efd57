function count = plane_count(table)
% PLANE_COUNT  How many planes a map has: 1 without a third parameter.
count = 1;
if isfield(table.attributes, 'plane')
    [ignored, places] = places_of(table); %#ok<ASGLU>
    count = places / double(table.attributes.plane);
end
end
