function text = setting(name, value)
% SETTING  Returns 'NAME=VALUE' for the command; numbers with all digits, texts ('0.45', '600 rpm') unchanged.
name = text_of(name);
value = text_of(value);
if ~ischar(name) || isempty(name)
    error('whirl:badInput', 'settings are pairs of a name and a value, and a name is a text');
end
if isnumeric(value) && numel(value) == 1 && isreal(value)
    text = sprintf('%s=%.17g', name, double(value));
elseif ischar(value) && size(value, 1) == 1
    text = [name '=' value];
else
    error('whirl:badInput', 'the value of %s is neither a number nor a text', name);
end
end
