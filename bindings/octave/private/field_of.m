function [numbers, about] = field_of(table, field)
% FIELD_OF  Returns the numbers of a field 'ANALYSIS/QUANTITY' as [points][stations or contacts][rows][columns], and
% their description in the result: unit, meaning, extent, ...
parts = regexp(field, '/', 'split');
group = table.(parts{1});
% In the struct, a quantity whose name is a keyword of the language ends in '_'.
name = parts{2};
if ~isfield(group, name)
    name = [name '_'];
end
about = group.about.(name);
numbers = reshape(double(flat(table, group.(name))), numel(table.values), double(about.repeat), ...
    double(about.rows), double(about.columns));
end
