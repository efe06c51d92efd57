function name = command()
% COMMAND  The whirl command, quoted: that of the environment variable WHIRL, or 'whirl' on the PATH.
name = getenv('WHIRL');
if isempty(name)
    name = 'whirl';
end
name = quoted(name);
end
