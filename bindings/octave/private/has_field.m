function yes = has_field(table, field)
% HAS_FIELD  Returns true if a table has the field 'ANALYSIS/QUANTITY'.
yes = any(strcmp(field, table.attributes.fields));
end
