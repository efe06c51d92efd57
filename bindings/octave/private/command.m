function name = command()
% COMMAND  Returns the whirl command, quoted: the environment variable WHIRL, or 'whirl' on the PATH.
name = getenv('WHIRL');
if isempty(name)
    name = 'whirl';
end
name = quoted(name);
end
