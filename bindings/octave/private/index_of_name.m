function index = index_of_name(names, wanted, what)
% INDEX_OF_NAME  Returns the number of a station or contact (WHAT) from its name, its number, or [] for the first.
index = text_of(wanted);
if isempty(index)
    index = 1;
elseif ischar(index)
    index = find(strcmp(names, index));
end
count = numel(names);
if ~isnumeric(index) || numel(index) ~= 1 || index < 1 || index > count || index ~= floor(index)
    error('whirl:badInput', 'there is no such %s, expected a number up to %d or one of: %s', what, count, ...
        strtrim(sprintf('%s ', names{:})));
end
end
