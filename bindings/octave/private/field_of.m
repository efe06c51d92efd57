function [numbers, about] = field_of(table, field)
% FIELD_OF  The numbers of a field 'ANALYSIS/QUANTITY' as [points][stations or contacts][rows][columns], and what the
%   result says of them: unit, meaning, extent, ...
parts = regexp(field, '/', 'split');
group = table.(parts{1});
% A quantity whose name is a keyword has a suffix.
name = parts{2};
if ~isfield(group, name)
    name = [name '_'];
end
about = group.about.(name);
numbers = reshape(double(flat(table, group.(name))), numel(table.values), double(about.repeat), ...
    double(about.rows), double(about.columns));
end
