function name = first_with(result, field, every)
% FIRST_WITH  Returns the name of the first table with a field ('orbit/max_radius'), or ''; looks at 'detail' only if
% EVERY.
for i = 1:numel(result.attributes.tables)
    name = result.attributes.tables{i};
    if has_field(result.(name), field) && (every || ~strcmp(name, 'detail'))
        return
    end
end
name = '';
end
