function yes = has_attractors(table, name)
% HAS_ATTRACTORS  Whether points are different starts of one machine: a basin, or several starts a place.
FIELD = field_names();
yes = strcmp(name, 'basin') || has_field(table, FIELD.starts_number);
end
