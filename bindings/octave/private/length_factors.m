function factors = length_factors(result, table)
% LENGTH_FACTORS  What lengths of every point of a table are multiplied by to be in the unit of figures.
%   Where the parameter changes the length scale, lengths in a unit follow it; those over the scale do not.
about = result.case_.attributes;
factors = about.shown_length * ones(numel(table.values), 1);
if ~about.shown_length_over
    factors = factors .* flat(table, table.length_scale) / about.length_scale;
end
end
