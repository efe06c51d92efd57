function [table, name] = table_with(result, field, analysis, wanted, every)
% TABLE_WITH  Returns the table WANTED or, if it is empty, the first with a field ('orbit/max_radius'), and its name.
%   Messages name ANALYSIS, which computes the field. The table 'detail' is found only by its name, or with EVERY. With
%   WANTED, FIELD may be ''.
if ~isempty(wanted)
    name = text_of(wanted);
    if ~is_text(name) || ~any(strcmp(name, result.attributes.tables))
        error('whirl:badInput', 'the result has no such table, expected one of: %s', ...
            strtrim(sprintf('%s ', result.attributes.tables{:})));
    end
    table = result.(name);
    if ~isempty(field) && ~has_field(table, field)
        error('whirl:badInput', 'the table ''%s'' has no ''%s'': add %s to what the case analyses', name, field, ...
            analysis);
    end
    return
end
name = first_with(result, field, nargin > 4 && every);
if isempty(name)
    error('whirl:badInput', 'no table of the result has ''%s'': add %s to what the case analyses', field, analysis);
end
table = result.(name);
end
