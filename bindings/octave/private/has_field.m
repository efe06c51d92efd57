function yes = has_field(table, field)
% HAS_FIELD  Whether a table has the field 'ANALYSIS/QUANTITY'.
yes = any(strcmp(field, table.attributes.fields));
end
