function [table, name] = table_with(result, group, names)
% TABLE_WITH  The first of the tables NAMES that has a member GROUP, and its name.
if ischar(result)
    result = whirl_read(result);
end
if ~isstruct(result)
    error('whirl:badInput', 'expected a result: the name of a file, or what whirl_read gives');
end
for i = 1:numel(names)
    name = names{i};
    if isfield(result, name) && isfield(result.(name), group)
        table = result.(name);
        return
    end
end
error('whirl:badInput', 'the result has no table with ''%s'' (expected one of: %s)', group, ...
    strtrim(sprintf('%s ', names{:})));
end
