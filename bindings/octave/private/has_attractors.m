function yes = has_attractors(table, name)
% HAS_ATTRACTORS  Whether points are different starts of one machine: a basin, or several starts a place.
yes = strcmp(name, 'basin') || has_field(table, 'starts/number');
end
